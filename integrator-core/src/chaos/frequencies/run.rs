//! The terms of an observable of a run.

use super::line::{Line, frequencies};
use crate::{
    check::CheckError,
    state::{coords::Coords, phase::Phase},
    trajectory::run::Run,
};

/// Finds the terms of an observable of a run, from samples after every `every` steps.
///
/// `observable` returns a complex number `[real, imaginary]` for each state. The run takes `every · (samples - 1)` steps.
/// Amplitudes are those at the first sample, the state of the run before these steps.
///
/// ```
/// use integrator_core::{chaos, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian(compose = BlanesMoanSrkn11)]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// }
///
/// let mut run = Pendulum.run(Phase::new([1.0], [0.0]), 0.1)?;
/// let lines = chaos::frequencies_of_run(&mut run, 1, 4_096, 4, |state| [state.q[0], state.p[0]])?;
/// // The complete elliptic integral gives `agm(1, cos 1/2)`, clockwise.
/// assert!((lines[0].frequency + 0.937792).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// - [`CheckError::Run`]: the run fails, or `every` is 0.
/// - [`CheckError::UnequalSteps`]: steps have unequal lengths in time, as those of [`Logarithmic`](crate::Logarithmic). Use
///   [`Run::samples_at`] and [`frequencies()`].
/// - Those of [`frequencies()`]; the interval is `every` steps.
pub fn frequencies_of_run<C: Coords>(
    run: &mut Run<C>,
    every: u64,
    samples: usize,
    count: usize,
    observable: impl FnMut(&Phase<C>) -> [f64; 2],
) -> Result<Vec<Line>, CheckError> {
    let (interval, mut begin, mut observable) = (run.step() * every as f64, None, observable);
    let mut values = Vec::with_capacity(samples);
    for (number, sample) in run.by_ref().samples(every).take(samples).enumerate() {
        let sample = sample?;
        let begin = *begin.get_or_insert(sample.time);
        let expected = begin + number as f64 * interval;
        // Times of equal steps are `t0 + n·h`: they differ from this by the rounding of two products and two sums.
        if (sample.time - expected).abs() > 4.0 * f64::EPSILON * (begin.abs() + expected.abs() + sample.time.abs()) {
            return Err(CheckError::UnequalSteps { time: sample.time, expected });
        }
        values.push(observable(&sample.state));
    }
    frequencies(&values, interval, count)
}
