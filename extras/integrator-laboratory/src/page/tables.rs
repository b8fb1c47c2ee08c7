//! The tables of the page: claims, methods and one extrapolated step.

use super::{Content, escaped};
use crate::{
    claims::Verdict,
    extrapolation::{DIVISIONS, Extrapolation},
    formula::math,
    measured::Measured,
    methods::Adaptive,
    numbers::{plain, signed},
    rows::Row,
    study::Study,
};
use integrator_plot::Colour;

/// The identifier of the table of one step, which claims name as their picture.
const EXTRAPOLATION: &str = "extrapolation";

/// All claims, folded: those that fail are in the summary as well.
pub(super) fn claims(content: &Content<'_>) -> String {
    let rows: String =
        content.verdicts.iter().enumerate().map(|(index, verdict)| row(content, index, verdict)).collect();
    format!(
        "<details class=\"chapter\" id=\"claims\">\n<summary><h2>All claims</h2></summary>\n<table>\n\
         <tr><th></th><th>claim</th><th>expected</th><th>measured</th><th>verdict</th></tr>\n{rows}</table>\n</details>\n"
    )
}

/// A claim with its number, and the picture that shows it.
fn row(content: &Content<'_>, index: usize, verdict: &Verdict) -> String {
    let is_table = verdict.picture == EXTRAPOLATION && content.study.is_some_and(|study| study.extrapolation.is_some());
    let shown = is_table || content.figures.iter().any(|figure| figure.name == verdict.picture);
    let picture = if shown { format!(" <a href=\"#{}\">picture</a>", verdict.picture) } else { String::new() };
    let why = if verdict.holds() { String::new() } else { format!("<br>{}", escaped(verdict.advice())) };
    format!(
        "<tr id=\"{name}\"><td>{number}</td><td class=\"says\">{says}{why}{picture}</td><td class=\"number\">{expected}</td>\
         <td class=\"number\">{measured}</td><td class=\"{word}\">{word}</td></tr>\n",
        name = verdict.name,
        number = index + 1,
        says = escaped(&verdict.says),
        expected = verdict.expected(),
        measured = verdict.found(),
        word = verdict.word(),
    )
}

/// A claim that fails, with what that may mean and what to try.
pub(super) fn failure(index: usize, verdict: &Verdict) -> String {
    format!(
        "<li><a class=\"FAILED\" href=\"#{name}\">{number}</a>. {says}: {found} instead of {expected}. {advice}</li>\n",
        name = verdict.name,
        number = index + 1,
        says = escaped(&verdict.says),
        found = verdict.found(),
        expected = verdict.expected(),
        advice = escaped(verdict.advice()),
    )
}

/// The table of one extrapolated step, if there is one.
pub(super) fn extrapolations(content: &Content<'_>, study: &Study) -> String {
    let table = study.extrapolation.as_ref().map(|table| extrapolation(table) + &content.links(EXTRAPOLATION));
    table.unwrap_or_default()
}

/// The table of one extrapolated step.
fn extrapolation(extrapolation: &Extrapolation) -> String {
    let rows: String = extrapolation
        .errors
        .iter()
        .zip(DIVISIONS)
        .map(|(errors, division)| {
            let entries: String =
                errors.iter().map(|error| format!("<td class=\"number\">{}</td>", plain(*error))).collect();
            format!("<tr><td>{division}</td>{entries}</tr>\n")
        })
        .collect();
    let orders: String = (1..=DIVISIONS.len()).map(|column| format!("<th>order {}</th>", 2 * column)).collect();
    format!(
        "<h3>The table of Aitken and Neville</h3>\n<p>One step of {step} by {n} midpoint steps, extrapolated to step size zero: \
         {formula}. Each entry is the error of the final state. Each column raises the order by two, and each row has finer steps. \
         The last entry is the step of the Gragg–Bulirsch–Stoer method.</p>\n\
         <table id=\"extrapolation\">\n<tr><th>midpoint steps</th>{orders}</tr>\n{rows}</table>\n",
        step = plain(extrapolation.step),
        n = math("n_j"),
        formula = math("T_{jk} = T_{j,k−1} + {T_{j,k−1} − T_{j−1,k−1}}/{{(n_j/n_{j−k})}^2 − 1}"),
    )
}

/// The table of methods, with the colour that each has in all pictures.
pub(super) fn methods(study: &Study) -> String {
    let rows: String = study.methods.iter().map(|measured| method(study, measured)).collect();
    let adaptive: String = study.adaptive.iter().map(adaptive).collect();
    let periods = study.methods.iter().filter_map(|measured| measured.energies.last()).map(|(periods, _)| *periods);
    let periods = plain(periods.fold(0.0, f64::max).round());
    format!(
        "<details class=\"chapter\" id=\"methods\">\n<summary><h2>All methods with their formulas</h2></summary>\n<p>{z}, \
         and <i>f</i> is its time derivative. Each method has the same colour in all pictures. Solid lines are symplectic methods, \
         dashed lines are others. Energy changes are those of {periods} periods in steps of {step}, in units of the largest kinetic \
         energy <i>K</i>; methods that choose their steps have a tolerance of {loose}. {drive}</p>\n\
         <table>\n<tr><th>method</th><th>a step</th><th>order (measured)</th><th>preserves areas</th><th>reversible</th><th>energy</th></tr>\n{rows}{adaptive}</table>\n</details>\n",
        z = math("z = (q, p)"),
        step = plain(study.step),
        loose = plain(crate::methods::LOOSE),
        drive = study.half_drive.filter(|half| study.step > *half).map(too_long).unwrap_or_default(),
    )
}

/// Warns of steps that do not resolve a drive.
fn too_long(half: f64) -> String {
    format!(
        "<strong>This step is longer than half the period of the drive, {}: no method follows the motion.</strong> ",
        plain(half)
    )
}

fn method(study: &Study, measured: &Measured) -> String {
    let row = measured.row;
    let order = match measured.slope {
        Some(slope) => format!("{} ({})", measured.order, plain(slope)),
        None => measured.order.to_string(),
    };
    let areas = match (measured.keeps_areas(), measured.blob.area() - 1.0) {
        (true, _) => "yes".to_owned(),
        (false, off) if off.is_finite() => format!("no: {}", signed(off)),
        _ => "no".to_owned(),
    };
    let back = match measured.reversal.apart {
        _ if measured.symmetric => "yes".to_owned(),
        Some(apart) => format!("no: {} of the orbit away", plain(apart)),
        None => "no".to_owned(),
    };
    let cells = [order, areas, back, energy(study, measured)];
    entry(&row, !measured.symplectic, cells)
}

/// A method that chooses its steps; nothing is measured of one map.
fn adaptive(adaptive: &Adaptive) -> String {
    let change = adaptive.energies.last().map_or(f64::NAN, |(_, change)| *change);
    entry(
        &adaptive.row,
        true,
        ["by tolerance".to_owned(), "no".to_owned(), "no".to_owned(), format!("{} K", signed(change))],
    )
}

fn entry(row: &Row, dashed: bool, [order, areas, back, energy]: [String; 4]) -> String {
    format!(
        "<tr><td class=\"method\">{chip}{name}</td><td class=\"says\">{formula}<br>{says}</td><td class=\"number\">{order}</td><td>{areas}</td><td>{back}</td><td class=\"number\">{energy}</td></tr>\n",
        chip = chip(row.colour, dashed),
        name = escaped(row.name),
        formula = math(row.formula),
        says = escaped(row.says),
    )
}

/// Describes the change of the energy, in a word and a number.
fn energy(study: &Study, measured: &Measured) -> String {
    if !study.autonomous {
        return "not conserved by H".to_owned();
    }
    if !study.resolved {
        return "lost in rounding".to_owned();
    }
    let (change, largest) = (measured.energy_change(), measured.largest_energy_change());
    match change {
        _ if largest <= measured.rounding => "kept to rounding".to_owned(),
        _ if measured.symplectic => format!("within {} K", plain(largest)),
        change if change.abs() <= measured.rounding => "kept to rounding".to_owned(),
        change if change > 0.0 => format!("gains {} K", plain(change)),
        change => format!("loses {} K", plain(change.abs())),
    }
}

/// A piece of a line in a colour.
fn chip(Colour(red, green, blue): Colour, dashed: bool) -> String {
    let fill = if dashed {
        format!("repeating-linear-gradient(90deg,rgb({red} {green} {blue}) 0 .45em,#fff .45em .65em)")
    } else {
        format!("rgb({red} {green} {blue})")
    };
    format!("<span class=\"chip\" style=\"background:{fill}\"></span>")
}
