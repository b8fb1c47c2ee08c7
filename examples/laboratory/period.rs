//! The period of the pendulum against the elliptic integral.

use crate::systems::Pendulum;
use integrator_core::{Method, prelude::*};
use integrator_laboratory::{Verdict, colour, plain};
use integrator_plot::{Axis, Chart, Mark};
use integrator_reference::RungeKutta4;
use std::f64::consts::TAU;

/// Initial angle of the pendulum, at rest.
pub(crate) const AMPLITUDE: f64 = 2.0;
/// Number of measured periods.
const SWINGS: u32 = 4;

/// Returns `4 K(sin(a/2))` by the arithmetic-geometric mean: the period of `H = p²/2 − cos q` with amplitude `a` is `2π /
/// agm(1, cos(a/2))`.
pub(crate) fn exact(amplitude: f64) -> f64 {
    let (mut arithmetic, mut geometric) = (1.0_f64, (0.5 * amplitude).cos());
    while (arithmetic - geometric).abs() > 2.0 * f64::EPSILON * arithmetic {
        (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
    }
    TAU / arithmetic
}

/// Relative errors of the period for successively halved steps.
pub(crate) struct Periods {
    pub(crate) name: &'static str,
    pub(crate) symplectic: bool,
    pub(crate) errors: Vec<(f64, f64)>,
}

/// Returns the mean time between two crossings of the lowest point in the same direction.
fn period<M: Method<Pendulum>>(method: M, h: f64) -> Option<f64> {
    let run = Pendulum.run_with(method, Phase::new([AMPLITUDE], [0.0]), h).ok()?;
    let steps = (1.2 * f64::from(SWINGS + 1) * exact(AMPLITUDE) / h) as u64;
    let mut passages = run.crossings(steps, Direction::Rising, |state, _| state.q[0]).map_while(Result::ok);
    let first = passages.next()?;
    let last = passages.nth(SWINGS as usize - 1)?;
    Some((last.time - first.time) / f64::from(SWINGS))
}

fn row<M: Method<Pendulum>>(name: &'static str, method: M, rungs: u32) -> Periods {
    let exact = exact(AMPLITUDE);
    let steps = (0..rungs).map(|rung| 0.4 / f64::from(1_u32 << rung));
    let error = |h: f64| period(method, h).map(|period| (h, ((period - exact) / exact).abs()));
    Periods { name, symplectic: method.facts().symplectic, errors: steps.filter_map(error).collect() }
}

/// Returns a row for each method.
pub(crate) fn all(rungs: u32) -> Vec<Periods> {
    vec![
        row("symplectic Euler", Euler, rungs),
        row("Verlet", Verlet, rungs),
        row("Runge–Kutta 4", RungeKutta4, rungs),
        row("Yoshida 4", Yoshida4, rungs),
        row("Blanes–Moan 6", BlanesMoan6, rungs),
        row("Kahan–Li 8", KahanLi8, rungs),
    ]
}

/// Returns the claim about the period of the pendulum.
pub(crate) fn claim(periods: &[Periods]) -> Verdict {
    let says = "The period of the pendulum is an elliptic integral: the least relative distance of Kahan–Li 8";
    // Some hundreds of rounding errors over four periods.
    Verdict::new(
        "pendulum_period",
        says,
        [0.0, 1e-13],
        periods.iter().find(|row| row.name == "Kahan–Li 8").and_then(Periods::least),
    )
    .shown_in("period")
}

/// Draws the errors of the period against the step.
pub(crate) fn picture(periods: &[Periods]) -> Chart {
    let best = periods.iter().filter_map(Periods::least).fold(f64::INFINITY, f64::min);
    let chart = Chart::new(format!("Period of the pendulum, amplitude {AMPLITUDE}"))
        .claim("The exact period is the elliptic integral 4 K(sin(a/2)). Measured periods converge with the order of the method. Symplectic Euler is as accurate as Verlet here, because it is conjugate to Verlet.")
        .measured(format!("exact {:.15}; nearest, relative: {}", exact(AMPLITUDE), plain(best)))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("relative error of the period"));
    periods.iter().fold(chart, |chart, row| {
        let chart = chart.series(Mark::Dotted, row.name, row.errors.iter().map(|(h, error)| (*h, error.max(1e-16))));
        let chart = colour(row.name).into_iter().fold(chart, Chart::coloured);
        if row.symplectic { chart } else { chart.dashed() }
    })
}

impl Periods {
    fn least(&self) -> Option<f64> {
        self.errors.iter().map(|(_, error)| *error).reduce(f64::min)
    }
}
