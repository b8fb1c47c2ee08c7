//! A self-contained HTML file with all pictures.

use crate::{
    claims::Verdict,
    extrapolation::{DIVISIONS, Extrapolation},
    formula::math,
    measured::Measured,
    numbers::{plain, signed},
    study::Study,
};
use integrator_plot::Colour;

/// A picture as SVG, with its name.
pub(crate) struct Figure {
    pub(crate) name: String,
    pub(crate) svg: String,
}

const STYLE: &str = "body{font:16px/1.5 sans-serif;color:#282828;max-width:1320px;margin:2em auto;padding:0 1em}\
svg{max-width:100%;height:auto}figure{margin:2em 0;border-top:1px solid #e2e2e2}table{border-collapse:collapse;\
display:block;overflow-x:auto}td,th{padding:.3em .5em;text-align:left;vertical-align:top;border-bottom:1px solid #e2e2e2}\
td.number{white-space:nowrap}td.method{min-width:8.5em}math{font-size:112%}td math{font-size:100%;margin-right:1em}.FAILED{color:#d55e00;font-weight:bold}\
.chip{display:inline-block;width:1.6em;height:.28em;vertical-align:middle;margin-right:.5em}";

/// The page of a system: its claims, its methods if they were measured, its pictures.
pub(crate) fn page(
    name: &str,
    formula: &str,
    study: Option<&Study>,
    verdicts: &[Verdict],
    figures: &[Figure],
) -> String {
    let (name, formula) = (escaped(name), escaped(formula));
    let rows: String = verdicts.iter().map(row).collect();
    let failed = verdicts.iter().filter(|verdict| !verdict.holds()).count();
    let summary = match failed {
        0 => format!("All {} claims hold.", verdicts.len()),
        failed => format!("{failed} of {} claims fail for this system.", verdicts.len()),
    };
    let pictures: String = figures.iter().map(figure).collect();
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Laboratory: {name}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<h1>Laboratory: {name}</h1>\n<p>{formula}</p>\n{methods}\
         <h2>Pictures</h2>\n{pictures}{extrapolation}<h2>Claims</h2>\n<p>{summary}</p>\n<table>\n\
         <tr><th>claim</th><th>expected</th><th>measured</th><th>verdict</th></tr>\n{rows}</table>\n</body>\n</html>\n",
        methods = study.map(methods).unwrap_or_default(),
        extrapolation = study.and_then(|study| study.extrapolation.as_ref()).map(extrapolation).unwrap_or_default(),
    )
}

/// A claim with its number.
fn row(verdict: &Verdict) -> String {
    format!(
        "<tr id=\"{}\"><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"{word}\">{word}</td></tr>\n",
        verdict.name,
        escaped(&verdict.says),
        verdict.expected(),
        plain(verdict.measured),
        word = verdict.word(),
    )
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
        "<h2>Extrapolation</h2>\n<p>One step of {step} by {n} midpoint steps, extrapolated to step size zero: \
         {formula}. Each entry is the error of the final state. Each column raises the order by two, and each row has finer steps. \
         The last entry is the step of the Gragg–Bulirsch–Stoer method.</p>\n\
         <table id=\"extrapolation\">\n<tr><th>midpoint steps</th>{orders}</tr>\n{rows}</table>\n",
        step = plain(extrapolation.step),
        n = math("n_j"),
        formula = math("T_{jk} = T_{j,k−1} + {T_{j,k−1} − T_{j−1,k−1}}/{{(n_j/n_{j−k})}^2 − 1}"),
    )
}

/// The table of methods, with the colour that each has in all pictures.
fn methods(study: &Study) -> String {
    let rows: String = study.methods.iter().map(|measured| method(study, measured)).collect();
    let periods = study.methods.iter().filter_map(|measured| measured.energies.last()).map(|(periods, _)| *periods);
    let periods = plain(periods.fold(0.0, f64::max).round());
    let adaptive = study.adaptive.iter().map(|adaptive| {
        format!("{}{} ({})", chip(adaptive.row.colour, true), escaped(adaptive.row.name), escaped(adaptive.row.says))
    });
    format!(
        "<h2>Methods</h2>\n<p>{z}, \
         and <i>f</i> is its time derivative. Each method has the same colour in all pictures. Solid lines are symplectic methods, \
         dashed lines are others. Energy changes are those of {periods} periods in steps of {step}, in units of the largest kinetic energy. {drive}The pictures also have the \
         adaptive methods: {adaptive}.</p>\n\
         <table>\n<tr><th>method</th><th>a step</th><th>order (measured)</th><th>preserves areas</th><th>reversible</th><th>energy</th></tr>\n{rows}</table>\n",
        z = math("z = (q, p)"),
        step = plain(study.step),
        drive = study.half_drive.filter(|half| study.step > *half).map(too_long).unwrap_or_default(),
        adaptive = adaptive.collect::<Vec<_>>().join(", "),
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
        Some(apart) => format!("no: {} away", plain(apart)),
        None => "no".to_owned(),
    };
    format!(
        "<tr><td class=\"method\">{chip}{name}</td><td>{formula}<br>{says}</td><td class=\"number\">{order}</td><td>{areas}</td><td>{back}</td><td class=\"number\">{energy}</td></tr>\n",
        chip = chip(row.colour, !measured.symplectic),
        name = escaped(row.name),
        formula = math(row.formula),
        says = escaped(row.says),
        energy = energy(study, measured),
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
        _ if measured.symplectic => format!("within {}", plain(largest)),
        change if change.abs() <= measured.rounding => "kept to rounding".to_owned(),
        change if change > 0.0 => format!("gains {}", plain(change)),
        change => format!("loses {}", plain(change.abs())),
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

/// A picture inside of the page.
fn figure(Figure { name, svg }: &Figure) -> String {
    let drawing = svg.replacen("<svg", &format!("<svg role=\"img\" aria-label=\"{name}\""), 1);
    format!("<figure id=\"{name}\">\n{drawing}</figure>\n")
}

/// Text in which no character means anything to HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
