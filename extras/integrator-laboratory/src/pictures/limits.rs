//! Large steps: resonances with the motion, and the limit of stability.

use super::style::of_method;
use crate::{
    limits::{LEFT, PERIODS},
    numbers::plain,
    study::Study,
};
use integrator_plot::{Axis, Chart, Mark, colour::GREY};
use std::f64::consts::TAU;

/// The largest change of the energy against the step.
pub(super) fn limits(study: &Study) -> Chart {
    let omega = TAU / study.period;
    let claim = format!(
        "The largest energy change in {PERIODS} periods. On an oscillator Verlet is stable up to hω = 2, the grey line for the frequency of this \
         motion. A nonlinear motion becomes unstable earlier, with peaks where the step resonates with it. Implicit methods have no limit \
         on an oscillator."
    );
    let chart = Chart::new(format!("Energy error against step: {}", study.system))
        .claim(claim)
        .measured(format!("2/ω = {}", plain(2.0 / omega)))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("largest |E − E₀| / K").between(1e-7, 10.0))
        .sized(1150, 700)
        .line("", [(2.0 / omega, 1e-7), (2.0 / omega, LEFT)])
        .coloured(GREY)
        .wide(1.5);
    let measured = study.methods.iter().filter(|measured| !measured.limits.is_empty());
    measured.fold(chart, |chart, measured| of_method(chart, Mark::Line, measured, measured.limits.iter().copied()))
}
