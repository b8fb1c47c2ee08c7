//! The distance of the map of some steps from a symplectic map.

use super::style::of_method;
use crate::{
    measured::{Measured, STEPS},
    numbers::{plain, signed},
    study::Study,
};
use integrator_plot::{Axis, Chart, Mark, colour::GREY};

/// The smallest deviation that is shown.
const LEAST: f64 = 1e-5;

/// Draws the deviation of the exact tangent map from a symplectic one, step by step.
pub(super) fn maps(study: &Study) -> Chart {
    let number = |name: &str| Some(format!("{name} {}", signed(study.method(name)?.bracket() - 1.0)));
    let numbers: Vec<_> = ["forward Euler", "symplectic Euler", "Verlet"].into_iter().filter_map(number).collect();
    let claim = format!(
        "A map with derivative M is symplectic if MᵀJM = J. M is the exact derivative of {STEPS} steps, after which multistep methods have \
         left their starter. Symplectic methods deviate by rounding only, below the grey line, whatever the step; others by a power of the step."
    );
    let off = |measured: &Measured| -> Vec<(f64, f64)> {
        // A map that is exactly symplectic is shown at the lower edge.
        measured.defects.iter().map(|(step, defect)| (*step, defect.max(LEAST))).collect()
    };
    let ends = || study.methods.iter().flat_map(|measured| &measured.defects).map(|(step, _)| *step);
    let (least, most) = (ends().fold(f64::INFINITY, f64::min), ends().fold(0.0, f64::max));
    let chart = Chart::new(format!("Symplectic or not: {}", study.system))
        .claim(claim)
        .measured(format!("{} − 1 after one step of {}: {}", study.bracket(), plain(study.step), numbers.join(", ")))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("|MᵀJM − J| / rounding").between(LEAST, 1e13))
        .sized(1150, 760)
        .line("", [(least, 1.0), (most, 1.0)])
        .coloured(GREY)
        .wide(1.0);
    study.methods.iter().fold(chart, |chart, measured| of_method(chart, Mark::Dotted, measured, off(measured)))
}
