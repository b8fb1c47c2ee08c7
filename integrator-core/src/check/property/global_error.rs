//! The distance of a run from the exact orbit.
//!
//! In: a system, a method, a start, a step, a number of steps. Out: a distance, and the accuracy of the reference
//! solution. Always true: the run is the user's own, in the precision of the user's state. The reference shares only
//! flows with a composition, and with a Taylor run only what flows have confirmed.

use crate::{
    check::{
        CheckError,
        oracle::{exact::Motions, reference::reference},
        start::IntoStart,
        statistics::{
            path::{PARTS, Path},
            points::{begin, flat_start, run},
        },
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::within,
    state::{flat::flat, precision::Precision},
    system::Shaped,
    trajectory::method::Method,
};

/// The uncertainty of the exact motion from which on nothing is compared with it. An arbitrary limit: beyond it, an
/// error has not one known digit.
const KNOWN: f64 = 0.1;

/// The distance of a run from the exact orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct GlobalError {
    /// The distance in phase space; positions and momenta are each in units of how far the exact orbit goes.
    pub distance: f64,
    /// The distance between two reference solutions, plus the rounding of a state. A distance below a few of these is
    /// not significant.
    pub uncertainty: f64,
    /// The time from the start over which the error was measured. Negative for a negative step.
    pub span: f64,
}

/// Measures the distance of `method` from the exact orbit over `steps` steps of `h` from `start`.
///
/// The result is the root mean square distance in phase space at four equally spaced times, since the error at a single
/// time may vanish by chance. `steps` is rounded up to a multiple of four.
///
/// If `#[hamiltonian(taylor)]` generated recurrences and the flows of the system confirm them, the exact orbit is a
/// Taylor series. It has a compensated state and a tolerance far below the rounding, and is accurate to the rounding
/// for many periods. Otherwise the exact orbit is a composition of flows of order 8, which is accurate for about ten
/// periods.
///
/// ```
/// use integrator_core::{check::global_error, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian(taylor)]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         -q[0].cos()
///     }
/// }
///
/// let start = Phase::new([2.0], [0.0]);
/// let coarse = global_error(&Pendulum, Yoshida4, start, 0.1, 10_000)?;
/// let fine = global_error(&Pendulum, Yoshida4, start, 0.05, 20_000)?;
/// let order = (coarse.distance / fine.distance).log2();
/// assert!((order - 4.0).abs() < 0.1 && fine.uncertainty < 1e-11);
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// - `steps` is zero.
/// - The start or the step is invalid for a run.
/// - The run diverges.
/// - The exact orbit is not known to a tenth of the distance that it covers.
pub fn global_error<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<GlobalError, CheckError> {
    if steps == 0 {
        return Err(CheckError::TooFewSteps { steps, needed: 1 });
    }
    let start = start.into_start();
    let begin = begin::<H, X, K>(system, method, &start, h)?;
    let part = steps.div_ceil(PARTS);
    let span = PARTS as f64 * part as f64 * h;
    let mut run = run::<H, X, K>(system, method, &start, h)?;
    let start = flat_start(&begin);
    let path = Path::of_run(start.phase.clone(), PARTS, &mut || run.advance(part).map(|_| flat(&run.state())))?;
    // Where a step follows the motion, flows in coarse steps follow it over some steps; where it does not, the exact
    // motion must not take longer than the run.
    let exact = reference(&Motions { system, shape: &begin.phase }, &start, span, part, steps.ilog2() as i32);
    let uncertainty = exact.uncertainty() + exact.rounding();
    if !within(uncertainty, KNOWN) {
        return Err(CheckError::NoReference { span, uncertainty });
    }
    Ok(GlobalError { distance: path.distance(&exact.path, exact.scale), uncertainty, span })
}
