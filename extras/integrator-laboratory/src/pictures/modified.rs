//! The quantities that symplectic steps conserve.

use crate::{
    modified::{Levels, Modified},
    numbers::plain,
    problem::steps_per_period,
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, WHITE},
};

/// Shades of a method for its modifications, the last one the darkest: how much of white is mixed in.
const PALE: [f64; 5] = [0.0, 0.25, 0.45, 0.6, 0.7];

/// One column for each composition: its levels, where these are curves, and its changes.
pub(super) fn modified(study: &Study) -> Option<Panels> {
    let first = study.modified.first()?;
    let levels = "Points of an orbit in long steps lie on a level of the modified Hamiltonian, in colour, and leave the level of H, in grey. ";
    let claim = format!(
        "{}Below: the change of the modified Hamiltonian against the step. With each further term of its series, drawn darker, the change \
         falls with a higher power of the step.",
        if first.levels.is_some() { levels } else { "" }
    );
    let panels = Panels::new(format!("Modified Hamiltonians: {}", study.system), claim)
        .columns(study.modified.len())
        .panel(420, 320);
    let of_levels =
        study.modified.iter().filter_map(|modified| Some(portrait(study, modified, modified.levels.as_ref()?)));
    let charts = of_levels.chain(study.modified.iter().map(changes));
    Some(charts.fold(panels, Panels::chart))
}

fn portrait(study: &Study, modified: &Modified, levels: &Levels) -> Chart {
    let [of_h, of_modified] = levels.of.clone();
    Chart::new(modified.row.name)
        .claim(format!("{} steps per period", plain(f64::from(study.cycles) * steps_per_period(levels.count))))
        .along(Axis::linear(&study.view[0]))
        .up(Axis::linear(&study.view[1]))
        .with_equal_units()
        .line("", of_h)
        .coloured(GREY)
        .line("", of_modified)
        .coloured(modified.row.colour.towards(WHITE, PALE[2]))
        .series(Mark::Dots, "", levels.orbit.iter().copied())
        .coloured(modified.row.colour)
        .wide(1.2)
}

fn changes(modified: &Modified) -> Chart {
    let powers: Vec<String> = modified.powers.iter().map(|power| format!("h{}", raised(*power))).collect();
    let measured = match modified.excess {
        Some(excess) if excess < 0.0 && excess.is_finite() => {
            format!("measured exponents are smaller by at most {}", plain(-excess))
        }
        Some(_) => "measured exponents are at least these".to_owned(),
        None => "exponents could not be measured".to_owned(),
    };
    let chart = Chart::new(modified.row.name)
        .claim(format!("H changes by {}; with further terms {}", powers[0], powers[1..].join(", ")))
        .measured(measured)
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("largest |ΔE| / K in two periods"));
    (0..modified.powers.len()).fold(chart, |chart, index| {
        let points = modified.changes.iter().map(|(step, changes)| (*step, changes[index]));
        let shade = PALE[modified.powers.len() - 1 - index];
        chart.series(Mark::Dotted, "", points).coloured(modified.row.colour.towards(WHITE, shade))
    })
}

fn raised(power: i32) -> &'static str {
    ["⁰", "", "²", "³", "⁴", "⁵", "⁶"].get(power as usize).copied().unwrap_or("^n")
}
