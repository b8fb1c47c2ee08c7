//! Linear stability: the fastest oscillation compared with the stability limit of the composition.
//!
//! In: a system, a composition, a start, a step. Out: the largest `h·ω` along the orbit, and the limit of the
//! composition. Always true: frequencies are those of the flows linearised by dual numbers, for any `T`; a direction of
//! exponential growth has none. The result is a hint only: the orbit is sampled, and the limit is that of harmonic
//! oscillators.

use crate::{
    check::{
        CheckError,
        property::{
            energies::{Differentiable, Energies, Part},
            gradient::Gradient,
        },
        start::{IntoStart, Start},
        statistics::{
            points::{begin, coordinate, origin, run},
            spectrum::eigenvalues,
        },
    },
    composition::Composition,
    error::Number,
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, within},
    state::{
        flat::{Flat, flat},
        precision::Precision,
    },
    system::Shaped,
    trajectory::method::Method,
};
use std::fmt;

/// The number of samples of the motion and of steps between two of them: as far as the energy is followed in a
/// certificate.
const SAMPLES: u64 = 256;
const INTERVAL: u64 = 32;

/// The fraction of the limit from which a step is called near to it. At half of the limit Verlet's frequencies are off
/// by a tenth, resonances between them begin to be felt, and a spring that hardens to the fourfold on the way leads
/// beyond it.
const NEAR: f64 = 0.5;

/// The fastest oscillation of a run in units of its step, and the stability limit of the composition.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stability {
    /// The phase advance: the largest `h·ω` of all samples, in radians. Zero if nothing oscillates; NaN if no sample
    /// has finite second derivatives.
    pub turn: f64,
    /// The time of that sample.
    pub time: f64,
    /// The `h·ω` from which the composition is unstable: [`Scheme::STABILITY_LIMIT`](crate::Scheme::STABILITY_LIMIT).
    pub limit: f64,
}

impl Stability {
    /// Returns the phase advance as a fraction of the limit.
    pub fn share(&self) -> f64 {
        self.turn / self.limit
    }

    /// Whether the phase advance is half of the limit or more. The oscillation is then poorly resolved; use a smaller
    /// step.
    pub fn is_near(&self) -> bool {
        !self.share().is_nan() && !within(self.share(), NEAR.next_down())
    }
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { turn, time, limit } = self;
        if turn.is_nan() {
            return write!(f, "h·ω is unknown: no sample has finite second derivatives");
        }
        let share = Number(100.0 * self.share());
        write!(f, "h·ω is at most {turn:.2e} (t = {time:.3e}), {share:.1} % of the limit {limit:.2}")?;
        if self.is_near() {
            write!(f, "; WARNING: above half of the limit, use a smaller step")?;
        }
        Ok(())
    }
}

/// Estimates the linear stability of a run from `start` with step `h`: the largest `h·ω` at 256 points of its first
/// 8192 steps.
///
/// If the run diverges before, the points are taken from the steps with finite states.
///
/// The frequencies at a point are those of the linearised motion: the square roots of the eigenvalues of `T″ V″`.
/// Directions of exponential growth have no frequency. Up to 24 coordinates all frequencies are computed; beyond that
/// only the largest, to about one per cent. The cost is at most 24 force evaluations in dual numbers per point.
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The parts of the Hamiltonian are not `T(p)` and `V(q)`: the limit is that of an oscillator with this splitting.
///
/// ```
/// use integrator_core::{check::stability, prelude::*};
///
/// struct Spring;
///
/// #[hamiltonian]
/// impl Spring {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         50.0 * q[0] * q[0]
///     }
/// }
///
/// // The frequency is 10, and Verlet is unstable from h·ω = 2 on.
/// assert!(!stability(&Spring, Verlet, &Phase::new([1.0_f64], [0.0]), 0.05)?.is_near());
/// assert!(stability(&Spring, Verlet, &Phase::new([1.0_f64], [0.0]), 0.15)?.is_near());
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
pub fn stability<H: Hamiltonian, X: Composition<H>, K: Precision>(
    system: &H,
    composition: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
) -> Result<Stability, CheckError> {
    nearness::<H, X, K>(system, composition, X::STABILITY_LIMIT, &start.into_start(), h)
}

/// Estimates stability like [`stability`], for a method with this limit.
pub(crate) fn nearness<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    limit: f64,
    start: &Start<Shaped<H, K>>,
    h: f64,
) -> Result<Stability, CheckError> {
    let start = begin::<H, X, K>(system, method, start, h)?;
    if !H::SEPARABLE {
        return Err(CheckError::NotSeparable { what: "the limit of stability of a composition" });
    }
    let mut run = run::<H, X, f64>(system, method, &start, h)?;
    let energies = Energies::new(system, &start.phase);
    let begin = (flat(&run.state()), run.time());
    Ok(fastest((&energies, h, limit), begin, &mut || {
        run.advance(INTERVAL).ok()?;
        Some((flat(&run.state()), run.time()))
    }))
}

/// The fastest oscillation of a run in units of its step, sampled at its start and after each call of `advance`.
fn fastest(
    (system, h, limit): (&dyn Differentiable, f64, f64),
    mut sample: (Flat, f64),
    advance: &mut dyn FnMut() -> Option<(Flat, f64)>,
) -> Stability {
    let mut fastest = Stability { turn: f64::NAN, time: sample.1, limit };
    for _ in 0..SAMPLES {
        let (state, time) = &sample;
        let turn = (h * frequency(system, state, *time)).abs();
        // A sample without finite second derivatives says nothing of the others.
        if !turn.is_nan() && !within(turn, fastest.turn) {
            fastest = Stability { turn, time: *time, ..fastest };
        }
        // The samples before a divergence show what led to it.
        match advance() {
            Some(next) => sample = next,
            None => break,
        }
    }
    fastest
}

/// The largest frequency of the linear motion about `point`: with `δq' = T″ δp` and `δp' = -V″ δq`, the largest real
/// part of a root of an eigenvalue of `T″ V″`.
fn frequency(energies: &dyn Differentiable, point: &Flat, time: f64) -> f64 {
    let length = point.q.len();
    let still = origin(point);
    let at_rest = Flat { q: point.q.clone(), p: still.p.clone() };
    let at_origin = Flat { q: still.q.clone(), p: point.p.clone() };
    let force = Gradient::new(energies, Part::Potential, time);
    let velocity = Gradient::new(energies, Part::Kinetic, time);
    let tangent = |numbers: &[f64], first: usize| {
        let mut tangent = still.clone();
        for (index, number) in numbers.iter().enumerate() {
            *coordinate(&mut tangent, first + index) = *number;
        }
        tangent
    };
    let squared = eigenvalues(length, &|direction| {
        let pull = force.flow(&at_rest, Some(&tangent(direction, 0)));
        velocity.flow(&at_origin, Some(&tangent(&pull, length)))
    });
    squared.map_or(f64::NAN, |values| {
        largest(values.iter().map(|value| value.re.hypot(value.im).sqrt() * (value.im.atan2(value.re) / 2.0).cos()))
    })
}
