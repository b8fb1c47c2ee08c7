//! The Poisson bracket `{q₁, p₁}` after one step.

use super::{Drawing, style::styled};
use crate::{measured::Measured, study::Study};
use integrator_plot::{Axis, Chart, Mark};

/// By how much the bracket is off, step by step.
pub(super) fn brackets(study: &Study) -> Drawing {
    let number = |name: &str| study.method(name).map(|measured| format!("{name} {:+.1e}", measured.bracket - 1.0));
    let numbers: Vec<_> = ["forward Euler", "symplectic Euler", "Verlet"].into_iter().filter_map(number).collect();
    let claim = "A map is symplectic if {q₁, p₁} = 1. For symplectic methods nothing but rounding is left, whatever the step; \
                 for the others the bracket is off by a power of the step. All are from the exact tangent map of the code.";
    let chart = Chart::new(format!("Poisson bracket after one step: {}", study.system))
        .claim(claim)
        .measured(format!("{{q₁, p₁}} − 1 for the step {}: {}", study.step, numbers.join(", ")))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("|{q₁, p₁} − 1|").between(3e-17, 30.0))
        .sized(1100, 720);
    let off = |measured: &Measured| -> Vec<(f64, f64)> {
        // A bracket that is exactly one is shown as half a rounding.
        let off = |bracket: f64| (bracket - 1.0).abs().max(f64::EPSILON / 2.0);
        measured.brackets.iter().map(|(step, bracket)| (*step, off(*bracket))).collect()
    };
    Drawing::Chart(
        styled(study).fold(chart, |chart, (measured, style)| {
            style.apply(chart.series(Mark::Dotted, measured.name, off(measured)))
        }),
    )
}
