//! Falls from far away: arcs of a hyperbola that begin far out and lead to the pericentre or beyond.
//!
//! From such a start Kepler's equation `t = r₀ s + η G₂ + ζ G₃`, the distance `r₀ + η G₁ + ζ G₂` and the sum `f q + g v` have
//! terms that are larger than their sums by many powers of ten. From the pericentre, where `η` is zero, no terms cancel. So the
//! time to the pericentre is taken from the given one, and the equation is solved for the rest. The end is its distance and the
//! angle from the start, and the angular momentum is a difference of products with one rounding each. With the hyperbolic anomaly
//! `H`, the true anomaly `f`, `m = |μ|`, `σ` the sign of `μ`, `n² = -β` and the angular momentum `h` of a unit of mass:
//!
//! ```text
//! e sinh H = η n / m        e cosh H = ζ / m = σ + r n² / m        e² = 1 + (n h / m)²
//! t = (e sinh H - σ H) m / n³        r cos f = (e - σ cosh H) m / n²        r sin f = (n h / m) sinh H m / n²
//! ```
//!
//! All of it is for motion towards the pericentre; for the opposite direction of time the velocities change their signs.

use super::{
    stumpff::shifted,
    universal::{Body, Orbit, Root, orbit, root},
};
use crate::scalar::{
    dual::Dual,
    elementary::Elementary,
    real::{Kernel, Mask, Real},
};
use core::array;

/// The hyperbolic tangent of the anomaly from which on a start is far: terms are three times as large as their sum, or more.
const FAR: f64 = 0.95;

/// The part of the distance to the centre that a free body with the energy of the orbit passes in a long fall. In a shorter one
/// no term is twice as large as their sum.
const LONG: f64 = 0.5;

/// The end of an arc, and where it was not found.
pub(super) struct End<W: Real, const D: usize> {
    pub(super) q: [W; D],
    pub(super) p: [W; D],
    pub(super) failed: W::Mask,
}

/// The lanes whose bodies fall from far away, for so long that they come near the pericentre.
#[inline(always)]
pub(super) fn falls<W: Real>(orbit: &Orbit<W>) -> W::Mask {
    let hyperbolic = orbit.beta.less(W::of(0.0));
    if !hyperbolic.any() {
        return hyperbolic;
    }
    let rate = W::select(hyperbolic, -orbit.beta, W::of(1.0)).sqrt();
    let is_long = (W::of(LONG) * orbit.distance).less(rate * orbit.time.abs());
    come_from_far(orbit).and(is_long)
}

/// The lanes whose bodies are far away on a hyperbola, on the way to the pericentre.
#[inline(always)]
pub(super) fn come_from_far<W: Real>(orbit: &Orbit<W>) -> W::Mask {
    let Orbit { eta, beta, zeta, time, .. } = *orbit;
    let zero = W::of(0.0);
    let hyperbolic = beta.less(zero);
    let rate = W::select(hyperbolic, -beta, W::of(1.0)).sqrt();
    hyperbolic.and((eta * time).less(zero)).and((W::of(FAR) * zeta).less(rate * eta.abs()))
}

/// A fall, as a function of its own: it is seldom needed, and much code.
pub(super) struct Fall<W, const D: usize> {
    pub(super) body: Body<W, D>,
    pub(super) orbit: Orbit<W>,
}

impl<W: Real, const D: usize> Kernel for Fall<W, D> {
    type Out = End<W, D>;
    const APART: bool = true;

    #[inline(always)]
    fn call(self) -> End<W, D> {
        let Self { body, orbit: Orbit { mu, distance, eta, beta, zeta, time } } = self;
        let (zero, one) = (W::of(0.0), W::of(1.0));
        let (m, square) = (mu.abs(), -beta);
        let (n, per_m) = (square.sqrt(), one / m);
        let is_attraction = zero.less(mu);
        let (direction, sigma) = (W::select(zero.less(time), one, -one), W::select(is_attraction, one, -one));
        let [scale, period] = [m / square, m / (square * n)];

        let (momentum_squared, across) = angular_momentum(&body, body.inverse_mass * n * per_m);
        let momentum = momentum_squared.sqrt();
        let e = (one + momentum_squared).sqrt();
        let (sine, cosine) = (-((eta * n).abs() * per_m), zeta * per_m);
        let till = (-sine - sigma * ((cosine - sine) / e).ln()) * period;
        let rest = time * direction - till;
        let before = true_anomaly(sigma, e, momentum, [sine, cosine]);

        let below = W::select(is_attraction, momentum_squared / (e + one), e + one);
        let from_pericentre = Orbit { mu, distance: scale * below, eta: zero, beta, zeta: m * e, time: rest };
        let Root { place, d, failed, .. } = root(&from_pericentre, one / from_pericentre.distance);
        let [first, second, _] = shifted(place.functions, beta, d);
        // Near the pericentre the end follows from the functions there; farther away from the time, to all digits.
        let anomaly = (n * first).asinh();
        let is_far = one.less(anomaly.abs());
        let sine = W::select(is_far, sigma.fma(anomaly, rest / period), e * (n * first));
        let near = (m * e).fma(second, from_pericentre.distance);
        let cosine = W::select(is_far, e.fma(e, sine * sine).sqrt(), near.fma(one / scale, sigma));
        let r = W::select(is_far, (cosine - sigma) * scale, near);
        let after = true_anomaly(sigma, e, momentum, [sine, cosine]);

        let turn = [after[0].fma(before[0], after[1] * before[1]), after[1].fma(before[0], -(after[0] * before[1]))];
        let (inverse, speed) = (one / distance, m / (n * r * body.inverse_mass));
        // A body that falls straight to the centre has no direction across, and no angle.
        let is_straight = momentum.equal(zero);
        let per_momentum = inverse / W::select(is_straight, one, momentum);
        let (mut q, mut p) = (body.q, body.p);
        for i in 0..D {
            let (along, across) = (body.q[i] * inverse, across[i] * per_momentum * direction);
            let outwards = turn[0].fma(along, turn[1] * across);
            let onwards = turn[0].fma(across, -(turn[1] * along));
            q[i] = r * outwards;
            p[i] = direction * speed * sine.fma(outwards, momentum * onwards);
        }
        End { q, p, failed }
    }
}

/// The derivatives of ways along a direction, where some bodies fall from far away: those of falls are recomputed, one
/// after the other and in double precision, since falls are rare. Derivatives of these derivatives are not numbers.
pub(super) struct AlongFalls<F: Real, const D: usize> {
    pub(super) body: Body<F, D>,
    pub(super) duration: F,
    pub(super) falling: F::Mask,
    /// The derivatives of the other ways.
    pub(super) others: [[F; D]; 2],
    /// The direction, of positions and momenta and of the inverse mass, the strength and the duration.
    pub(super) point: [[F; D]; 2],
    pub(super) constants: [F; 3],
}

impl<F: Real, const D: usize> Kernel for AlongFalls<F, D> {
    type Out = [[F; D]; 2];

    #[inline(always)]
    fn call(self) -> [[F; D]; 2] {
        let Self { body: Body { q, p, inverse_mass, strength }, duration, falling, others, point, constants } = self;
        let (is_fall, parts) = (F::select(falling, F::of(1.0), F::of(0.0)), F::LANES / F::MEMBERS.max(1));
        let mut slopes = [[F::of(0.0); D]; 2];
        for lane in (0..F::LANES).step_by(parts).filter(|lane| is_fall.lane(*lane) == 1.0) {
            let numbers = [q, p, point[0], point[1]].map(|half| half.map(|number| number.lane(lane)));
            let constants =
                [[inverse_mass, strength, duration], constants].map(|all| all.map(|number| number.lane(lane)));
            let found = slope(numbers, constants);
            for (slopes, found) in slopes.as_flattened_mut().iter_mut().zip(found.as_flattened()) {
                *slopes += F::state(&|other| match other {
                    other if other == lane => *found,
                    other if other / parts == lane / parts => f64::NAN,
                    _ => 0.0,
                });
            }
        }
        for (slope, other) in slopes.as_flattened_mut().iter_mut().zip(others.as_flattened()) {
            *slope = F::select(falling, *slope, *other);
        }
        slopes
    }
}

/// The derivatives of the way of a body that falls, from its position and momentum, and its direction.
fn slope<const D: usize>(numbers: [[f64; D]; 4], constants: [[f64; 3]; 2]) -> [[f64; D]; 2] {
    if const { D > 3 } {
        return slope_of(numbers, constants);
    }
    let found = slope_in_space(numbers.map(|half| array::from_fn(|d| half.get(d).copied().unwrap_or(0.0))), constants);
    found.map(|half| array::from_fn(|d| half[d]))
}

/// The derivatives in three dimensions, which include the plane: compiled with the library, and not for each system.
#[inline(never)]
fn slope_in_space(numbers: [[f64; 3]; 4], constants: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
    slope_of(numbers, constants)
}

fn slope_of<const D: usize>([q, p, dq, dp]: [[f64; D]; 4], [constants, direction]: [[f64; 3]; 2]) -> [[f64; D]; 2] {
    let [q, p]: [[_; D]; 2] =
        [(q, dq), (p, dp)].map(|(half, along)| array::from_fn(|d| Dual::along(half[d], along[d])));
    let [inverse_mass, strength, duration] = array::from_fn(|i| Dual::along(constants[i], direction[i]));
    let body = Body { q, p, inverse_mass, strength };
    let End { q, p, .. } = Fall { body, orbit: orbit(&body, duration).0 }.call();
    [array::from_fn(|d| (q[d] - body.q[d]).slope()), array::from_fn(|d| (p[d] - body.p[d]).slope())]
}

/// The cosine and the sine of the true anomaly, from `e sinh H` and `e cosh H`.
#[inline(always)]
fn true_anomaly<W: Real>(sigma: W, e: W, momentum: W, [sine, cosine]: [W; 2]) -> [W; 2] {
    let per_distance = W::of(1.0) / (e * (cosine - sigma));
    [e.fma(e, -(sigma * cosine)) * per_distance, momentum * sine * per_distance]
}

/// The square of the angular momentum times a factor, and the product of this with the position, which is at right angles to
/// that and of the size of both. The parts are differences of products that are nearly equal, each with one rounding: every digit
/// that the distance of the pericentre loses is one of the end.
#[inline(always)]
fn angular_momentum<W: Real, const D: usize>(body: &Body<W, D>, factor: W) -> (W, [W; D]) {
    let Body { q, p, .. } = body;
    let mut square = W::of(0.0);
    let mut across = [square; D];
    for i in 0..D {
        for j in 0..i {
            let part = factor * difference_of_products([q[i], p[j], q[j], p[i]]);
            square = part.fma(part, square);
            across[j] = q[i].fma(part, across[j]);
            across[i] = (-q[j]).fma(part, across[i]);
        }
    }
    (square, across)
}

/// `a b - c d` (Kahan).
#[inline(always)]
pub(crate) fn difference_of_products<W: Real>(factors: [W; 4]) -> W {
    let value = |_, [a, b, c, d]: [f64; 4]| {
        let product = c * d;
        let lost = Elementary::mul_add(-c, d, product);
        Elementary::mul_add(a, b, -product) + lost
    };
    W::lane_by_lane(factors, value, |_, [a, b, c, d]| [b, a, -d, -c])
}
