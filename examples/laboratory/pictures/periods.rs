//! The error of the pendulum's period.

use super::Drawing;
use crate::{
    notes::Notes,
    period::{AMPLITUDE, exact},
};
use integrator_plot::{Axis, Chart, Mark};

/// Errors of the period against the step.
pub(super) fn periods(notes: &Notes) -> Drawing {
    let best = notes.periods.iter().flat_map(|row| &row.errors).map(|(_, error)| *error).fold(f64::INFINITY, f64::min);
    let chart = Chart::new(format!("Period of the pendulum, amplitude {AMPLITUDE}"))
        .claim("The period is 4 K(sin(a/2)), an elliptic integral, here by the arithmetic-geometric mean. Measured periods reach it with the order of the method; symplectic Euler is as good as Verlet here, of which it is a view in other coordinates.")
        .measured(format!("exact {:.15}; nearest, relative: {best:.1e}", exact(AMPLITUDE)))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("relative error of the period"));
    Drawing::Chart(notes.periods.iter().fold(chart, |chart, row| {
        let chart = chart.series(Mark::Dotted, row.name, row.errors.iter().map(|(h, error)| (*h, error.max(1e-16))));
        if row.symplectic { chart } else { chart.dashed() }
    }))
}
