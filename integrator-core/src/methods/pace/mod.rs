//! Time transformations: steps that shorten where the motion is fast, and stay symplectic.
//!
//! In: a system with flows for durations of each lane, and a composition. Out: runs whose steps are equal in a fictitious
//! time `s`, and whose time `t` is part of the state, compensated. Always true: a transformation knows the energies and
//! the flows of the system, and nothing of its coordinates.

mod flows;
#[cfg(feature = "std")]
mod in_lanes;
mod method;
mod motion;

pub(super) use method::transformed;
pub use method::{Logarithmic, Paced, Power};

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System, motion::Plain},
};

/// The plain motion of a system, whatever layout its steps in `t` have.
pub type PlainMotion<H, R, K> = Plain<R, Shaped<H, K>, <H as System>::Parameters<R>>;

/// The nodes of Gauss's rule of five points between 0 and 1, with their weights. Its error is of the eleventh power of
/// the range, so that steps keep every order that is proved for a composition, which is ten at most.
const NODES: [[f64; 2]; 5] = [
    [0.046_910_077_030_668_004, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];

/// A Hamiltonian `T(p) + V(q)` with flows whose durations are numbers of each lane. Written by `#[hamiltonian]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not support time transformation",
    label = "cannot be integrated in a fictitious time",
    note = "`Logarithmic`, `Power` and `Paced` require `kinetic` and `potential` without explicit time, and without \
            Jacobi coordinates"
)]
pub trait TimeTransformed: System {
    /// Whether `V` has the same sign everywhere.
    const KEEPS_SIGN: bool = false;
    /// `T` and a number.
    fn kinetic_plus<R: Real, K: Precision>(motion: &PlainMotion<Self, R, K>, more: R) -> R;
    /// `V`.
    fn potential_of<R: Real, K: Precision>(motion: &PlainMotion<Self, R, K>) -> R;
    /// The exact flow of `T`.
    fn drift_for<R: Real, K: Precision>(motion: &mut PlainMotion<Self, R, K>, duration: R);
    /// The exact flow of `V`.
    fn kick_for<R: Real, K: Precision>(motion: &mut PlainMotion<Self, R, K>, duration: R);
    /// The exact flow of `-ln(-V)`; returns `V`, or a number with its sign if `V` keeps it.
    fn logarithmic_kick<R: Real, K: Precision>(motion: &mut PlainMotion<Self, R, K>, duration: R) -> R;
}

/// A Hamiltonian `T(p) + V(q)` with a pace of the user's own. Written by `#[hamiltonian]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `rate` for `Paced`",
    label = "`fn rate` is missing",
    note = "add `fn rate(&self, q: ...) -> f64` next to `kinetic` and `potential`; a larger value shortens the steps",
    note = "`Logarithmic` and `Power` do not require `rate`"
)]
pub trait Rated: TimeTransformed {
    /// Whether the velocity is linear in the momenta.
    const LINEAR_VELOCITY: bool = false;
    /// The pace.
    fn rate_of<R: Real, K: Precision>(motion: &PlainMotion<Self, R, K>) -> R;
    /// The pace by the user's own function, as it is written.
    fn stated_rate(&self, q: &Self::Coords) -> f64;
    /// The flow of the pace as a potential.
    fn kick_by_rate<R: Real, K: Precision>(motion: &mut PlainMotion<Self, R, K>, duration: R);
}

/// Applies the exact flow of `V` for `duration` over the pace.
///
/// Returns the pace, and how much it grows along the velocity meanwhile: `duration` times the mean over the kick of the
/// velocity times the gradient of the pace. That is the mean of both ends if the velocity is linear in the momenta, and
/// otherwise comes from Gauss's rule.
#[inline(always)]
fn rated_kick<H: Rated, R: Real, K: Precision>(motion: &mut PlainMotion<H, R, K>, duration: R) -> [R; 2] {
    let rate = H::rate_of::<R, K>(motion);
    let duration = duration / rate;
    let mut slope = motion.at_rest();
    H::kick_by_rate::<R, f64>(&mut slope, R::of(-1.0));
    if const { H::LINEAR_VELOCITY } {
        let half = R::of(0.5);
        let mut before = motion.at_origin();
        H::drift_for::<R, f64>(&mut before, half);
        H::kick_for::<R, K>(motion, duration);
        let mut after = motion.at_origin();
        H::drift_for::<R, f64>(&mut after, half);
        return [rate, duration * (before.positions_times(&slope) + after.positions_times(&slope))];
    }
    let mut force = motion.at_rest();
    H::kick_for::<R, f64>(&mut force, R::of(1.0));
    let mut mean = R::of(0.0);
    for [node, weight] in NODES {
        let mut there = motion.at_origin();
        there.push(duration * R::of(node), &force);
        H::drift_for::<R, f64>(&mut there, R::of(weight));
        mean += there.positions_times(&slope);
    }
    motion.push(duration, &force);
    [rate, duration * mean]
}
