//! Deviations along the orbit, under each method.

use super::style::of_method;
use crate::{numbers::plain, study::Study, tangents::Deviation};
use integrator_plot::{Axis, Chart, Mark, Panels};

/// Changes below this are rounding.
const SMALLEST: f64 = 1e-15;

/// Draws the lengths of deviations, the bracket and the volumes.
pub(super) fn tangents(study: &Study) -> Panels {
    let claim = "Deviations evolved by the exact derivative of the steps. Their length does not distinguish the methods. The bracket \
         stays one under symplectic methods, solid lines. Under others it departs from one, later for higher orders.";
    let symplectic = study.methods.iter().filter(|measured| measured.symplectic);
    let brackets =
        symplectic.flat_map(|measured| &measured.deviations).map(|deviation| (deviation.bracket - 1.0).abs());
    let panels = Panels::new(format!("Deviations: {}", study.system), claim)
        .measured(format!(
            "steps of {}; of symplectic methods |{} − 1| ≤ {}",
            plain(study.step),
            study.bracket(),
            plain(brackets.fold(0.0, f64::max))
        ))
        .columns(1)
        .panel(1150, 620);
    let length = Axis::logarithmic(format!("|∂z/∂{}|", study.symbols[0]));
    let panels = panels.chart(chart(study, "Length of a deviation", length, |deviation| deviation.length));
    let bracket = Axis::signed_logarithmic(format!("{} − 1", study.bracket()), SMALLEST);
    let panels = panels.chart(chart(study, "Poisson bracket", bracket, |deviation| deviation.bracket - 1.0));
    if study.freedom == 1 {
        // Where it is the bracket.
        return panels;
    }
    let determinant = Axis::signed_logarithmic("det M − 1", SMALLEST);
    panels.chart(chart(study, "Determinant: phase-space volume", determinant, |deviation| deviation.determinant - 1.0))
}

fn chart(study: &Study, title: &str, up: Axis, value: fn(&Deviation) -> f64) -> Chart {
    let chart = Chart::new(title).along(Axis::linear("periods")).up(up).with_names_at_ends();
    study.methods.iter().fold(chart, |chart, measured| {
        let points = measured.deviations.iter().map(|deviation| (deviation.periods, value(deviation)));
        of_method(chart, Mark::Line, measured, points)
    })
}
