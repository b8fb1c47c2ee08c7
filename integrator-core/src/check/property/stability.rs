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
use nalgebra::Complex;
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
    /// The `h·ω` from which the composition is unstable: [`Scheme::STABILITY_LIMIT`](crate::Scheme::STABILITY_LIMIT). If a part of
    /// `H` takes inner steps, π: a step of half a period of the fastest motion is in resonance with it.
    pub limit: f64,
    /// The same of an inner step, if a part of `H` takes inner steps: the innermost one.
    pub inner_step: Option<InnerStep>,
}

/// The fastest oscillation of a run in units of its inner step, and the stability limit of the inner composition.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct InnerStep {
    /// The largest `h·ω` of an inner step, in radians.
    pub turn: f64,
    /// The `h·ω` from which the inner composition is unstable.
    pub limit: f64,
}

impl Stability {
    /// Returns the phase advance as a fraction of the limit, of the inner step if that is more.
    pub fn share(&self) -> f64 {
        let inner = self.inner_step.map(|InnerStep { turn, limit }| turn / limit);
        largest([self.turn / self.limit].into_iter().chain(inner))
    }

    /// Whether the phase advance is half of the limit or more. The oscillation is then poorly resolved; use a smaller
    /// step.
    pub fn is_near(&self) -> bool {
        !self.share().is_nan() && !within(self.share(), NEAR.next_down())
    }
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Self { turn, time, limit, inner_step } = self;
        if turn.is_nan() {
            return write!(f, "h·ω is unknown: no sample has finite second derivatives");
        }
        let share = |turn: f64, limit: f64| Number(100.0 * turn / limit);
        write!(f, "h·ω is at most {turn:.2e} (t = {time:.3e}), {:.1} % of ", share(turn, limit))?;
        match inner_step {
            None => write!(f, "the limit {limit:.2}")?,
            Some(InnerStep { turn, limit }) => write!(
                f,
                "π, where the step resonates with the fastest motion; of an inner step {turn:.2e}, {:.1} % of the limit \
                 {limit:.2}",
                share(turn, limit)
            )?,
        }
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
/// - The parts of the Hamiltonian are not `T(p)` and `V(q)`, and none takes inner steps: the limit is that of an oscillator with
///   this splitting.
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
    let limit = composition.claims().stability_limit.unwrap_or(X::STABILITY_LIMIT);
    nearness::<H, X, K>(system, composition, limit, &start.into_start(), h)
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
    if !H::SEPARABLE && H::NESTED.is_empty() {
        return Err(CheckError::NotSeparable { what: "the limit of stability of a composition" });
    }
    let mut run = run::<H, X, f64>(system, method, &start, h)?;
    let energies = Energies::new(system, &start.phase);
    let begin = (flat(&run.state()), run.time());
    let mut fastest = fastest((&energies, h, limit), begin, &mut || {
        run.advance(INTERVAL).ok()?;
        Some((flat(&run.state()), run.time()))
    });
    fastest.inner_step =
        method.claims().innermost.map(|(steps, limit)| InnerStep { turn: fastest.turn / steps, limit });
    Ok(fastest)
}

/// The fastest oscillation of a run in units of its step, sampled at its start and after each call of `advance`.
fn fastest(
    (system, h, limit): (&dyn Differentiable, f64, f64),
    mut sample: (Flat, f64),
    advance: &mut dyn FnMut() -> Option<(Flat, f64)>,
) -> Stability {
    let mut fastest = Stability { turn: f64::NAN, time: sample.1, limit, inner_step: None };
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
    if let Some(frequency) = frequency_of_field(energies, point, time) {
        return frequency;
    }
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
    squared.map_or(f64::NAN, |values| largest_frequency(&values))
}

/// The largest frequency of the linear motion `δz' = J δz` about `point`, from the eigenvalues of `-J²`, if the last part of H takes
/// inner steps.
fn frequency_of_field(energies: &dyn Differentiable, point: &Flat, time: f64) -> Option<f64> {
    let length = point.q.len();
    let bent = |direction: &[f64]| {
        let tangent = Flat { q: direction[..length].to_vec(), p: direction[length..].to_vec() };
        let mut field = energies.bent_field(Part::Kinetic, point, &tangent, time)?;
        let gradient = energies.bent_field(Part::Potential, point, &tangent, time)?;
        field.extend(gradient.iter().map(|slope| -slope));
        Some(field)
    };
    bent(&vec![0.0; 2 * length])?;
    let squared = eigenvalues(2 * length, &|direction| {
        let twice = bent(direction).and_then(|field| bent(&field)).unwrap_or_default();
        twice.iter().map(|number| -number).collect()
    });
    Some(squared.map_or(f64::NAN, |values| largest_frequency(&values)))
}

/// The largest real part of a root of an eigenvalue.
fn largest_frequency(squared: &[Complex<f64>]) -> f64 {
    largest(squared.iter().map(|value| value.re.hypot(value.im).sqrt() * (value.im.atan2(value.re) / 2.0).cos()))
}
