//! A set of starts under each method.

use crate::{measured::Measured, numbers::plain, study::Study};
use integrator_plot::{Axis, Chart, Mark, Panels};

/// One panel per method: the outline at some times, and the area at the last.
pub(super) fn areas(study: &Study) -> Panels {
    let claim = match study.freedom {
        1 => "The flow moves and shears a set of initial states. Symplectic methods preserve its area; others do not.",
        _ => {
            "The flow moves a loop of initial states in the plane of q₁ and p₁. Symplectic methods preserve Σ ∮ pᵢ dqᵢ; the area in \
             the picture is one term of this sum."
        }
    };
    let changes = study.methods.iter().filter(|measured| measured.symplectic);
    let largest = changes.map(|measured| (measured.blob.area() - 1.0).abs()).fold(0.0, f64::max);
    let panels = Panels::new(format!("Areas: {}", study.system), claim)
        .measured(format!("largest relative change under a symplectic method: {}", plain(largest)))
        .columns(4)
        .panel(320, 350);
    study.methods.iter().fold(panels, |panels, measured| panels.chart(panel(study, measured)))
}

fn panel(study: &Study, measured: &Measured) -> Chart {
    let what = if study.freedom == 1 { "area" } else { "Σ ∮ p dq" };
    let chart = Chart::new(measured.name())
        .claim(format!("{what} at the end: {}", factor(measured.blob.area())))
        .along(Axis::linear(&study.symbols[0]))
        .up(Axis::linear(&study.symbols[study.freedom]));
    measured.blob.outlines.iter().fold(chart, |chart, outline| {
        chart.series(Mark::Filled, "", outline.iter().copied()).coloured(measured.row.colour)
    })
}

/// A factor beside one: how far it is from it, where it is close.
fn factor(area: f64) -> String {
    let off = area - 1.0;
    if off.abs() < 0.01 {
        format!("1 {} {}", if off < 0.0 { '−' } else { '+' }, plain(off.abs()))
    } else {
        plain(area)
    }
}
