//! Kepler's equation in universal variables, and the increments that follow from its root (Stumpff 1962; Battin 1999).
//!
//! With `ds = dt/r`, the velocity `v = p/m`, `μ = k/m`, `η = q·v`, `β = 2μ/r₀ - v²` and `ζ = μ - β r₀`,
//!
//! ```text
//! t = r₀ s + η G₂(s) + ζ G₃(s)        r = r₀ + η G₁(s) + ζ G₂(s)
//! ```
//!
//! where `t` grows with `s` on every conic: there is one root. The first guess is the series for a short arc, cut after
//! its fourth order. One correction, of fourth order as well and with one division, takes it to the root wherever that
//! is near. Where this correction is too long, a second one follows it, and after that a search in a bracket, by Laguerre's
//! method (Conway 1986). The correction is always last and in the scalar itself, so that the tangent of a dual is exact,
//! wherever the search came from. That is for duals over duals: a dual solves for its value alone ([`super::slope`]).

use super::{
    fall::{End, Fall, come_from_far, falls},
    stumpff::{functions, shifted, small},
};
use crate::scalar::real::{Kernel, Mask, Real};
use core::f64::consts::{PI, TAU};

/// The largest correction in units of the conic's own scale, of which the terms that it neglects are the fourth power.
const SHORT: f64 = 1.0 / 4096.0;

/// The largest correction in units of the universal variable.
const SMALL: f64 = 1.0 / 64.0;

/// The largest `|β s²|` of a guess that is no search's: more than π², that of half an ellipse.
const LONGEST: f64 = 16.0;

/// The largest `|f - 1|` of an arc on which roundings are kept from drifting.
const FAR: f64 = 32.0;

/// The number of steps of a search. Each eighth halves the bracket, should Laguerre's method not come nearer.
const SEARCH: usize = 128;

/// A body, or a row of them.
#[derive(Clone, Copy)]
pub(crate) struct Body<W, const D: usize> {
    pub(crate) q: [W; D],
    pub(crate) p: [W; D],
    pub(crate) inverse_mass: W,
    pub(crate) strength: W,
}

/// The increments of the coordinates of a body.
pub(crate) struct Increments<W: Real, const D: usize> {
    pub(crate) q: [W; D],
    pub(crate) p: [W; D],
    /// The lanes in which Kepler's equation could not be solved: their increments are NaN.
    pub(crate) failed: W::Mask,
}

/// An arc from where a body is to where it will be.
pub(super) struct Solution<W: Real> {
    pub(super) orbit: Orbit<W>,
    /// One over the distance at the start, and at the end.
    pub(super) inverse: [W; 2],
    /// The universal variable at the end, and `G₁` to `G₃` there.
    pub(super) s: W,
    pub(super) functions: [W; 3],
    /// The bodies that no force acts on, those that fall from far away, whose ends are found otherwise, and those of which positions
    /// follow without the time.
    pub(super) free: W::Mask,
    pub(super) falling: W::Mask,
    pub(super) bound: W::Mask,
}

/// An orbit from where the body is, and the time that it takes.
#[derive(Clone, Copy)]
pub(super) struct Orbit<W> {
    /// `μ`
    pub(super) mu: W,
    /// `r₀`
    pub(super) distance: W,
    /// `η`
    pub(super) eta: W,
    /// `β`
    pub(super) beta: W,
    /// `ζ`
    pub(super) zeta: W,
    /// The time, within half a period.
    pub(super) time: W,
}

/// A point of an orbit.
#[derive(Clone, Copy)]
pub(super) struct Place<W> {
    /// `G₀` to `G₃`
    pub(super) functions: [W; 4],
    /// The time of the point minus the time at which the body should be.
    late: W,
    /// The distance, and its first two derivatives by `s`.
    distance: [W; 3],
    /// One over the distance.
    inverse: W,
}

/// The root of Kepler's equation: a place nearby, the correction of `s` from there, and the lanes in which there is none.
pub(super) struct Root<W: Real> {
    pub(super) place: Place<W>,
    pub(super) s: W,
    pub(super) d: W,
    pub(super) failed: W::Mask,
}

/// The orbit of a body, one over its distance, and the lanes in which no force acts on it.
#[inline(always)]
pub(super) fn orbit<W: Real, const D: usize>(body: &Body<W, D>, duration: W) -> (Orbit<W>, W, W::Mask) {
    let Body { q, p, inverse_mass, strength } = *body;
    let zero = W::of(0.0);
    let (mut square, mut radial, mut momentum) = (zero, zero, zero);
    for d in 0..D {
        square = q[d].fma(q[d], square);
        radial = q[d].fma(p[d], radial);
        momentum = p[d].fma(p[d], momentum);
    }
    // What no force acts on goes straight on: its root is zero, and where it is does not matter. Its unit of length is another one, in
    // which powers of the radial motion could leave the range of the scalar.
    let free = strength.equal(zero);
    let (square, radial) = (W::select(free, W::of(1.0), square), W::select(free, zero, radial));
    let distance = square.sqrt();
    // A root and a division that wait for each other take longer than the two side by side and what rounds them again.
    let quotient = distance * (W::of(1.0) / square);
    let inverse = quotient.fma((-distance).fma(quotient, W::of(1.0)), quotient);
    let mu = strength * inverse_mass;
    let velocity = velocity_squared(body, momentum);
    let beta = (mu + mu).fma(inverse, -velocity);
    let (eta, zeta) = (inverse_mass * radial, velocity.fma(distance, -mu));
    let time = within_a_period(mu, beta, duration);
    (Orbit { mu, distance, eta, beta, zeta, time }, inverse, free)
}

/// The way of a body in a time `duration`, and the arc that it follows from.
#[inline(always)]
pub(super) fn increments<W: Real, const D: usize>(body: &Body<W, D>, duration: W) -> (Increments<W, D>, Solution<W>) {
    let Body { q, p, inverse_mass, strength } = *body;
    let zero = W::of(0.0);
    let (orbit, inverse, free) = orbit(body, duration);
    let Orbit { mu, distance, eta, beta, time, .. } = orbit;
    let falling = falls(&orbit).and(free.not());
    let Root { place, s, d, failed } = root(&Orbit { time: W::select(free.or(falling), zero, time), ..orbit }, inverse);
    let [first, second, third] = shifted(place.functions, beta, d);
    let [r, slope, curvature] = place.distance;
    let farther = small(beta, d, [slope, curvature]);
    let r = r + farther;
    let arrival = place.arrival(r, farther);
    // f - 1, g / m, -m r df/dt and r (1 - dg/dt): none is a difference of numbers that are nearly equal.
    let f = W::select(failed, W::of(f64::NAN), -(mu * inverse * second));
    // Two forms of g: the first is on the orbit wherever s is, so that the error of the root is one of time alone, and
    // the second is exact where the body goes far away.
    let bound = zero.less(beta).and(f.abs().less(W::of(FAR)));
    let (near, far) = ((inverse_mass * distance).fma(first, inverse_mass * eta * second), (-mu).fma(third, time));
    let g = W::select(bound, near, inverse_mass * far);
    let by_position = strength * inverse * first;
    let by_momentum = mu * second;
    // Angular momentum is kept as long as f dg/dt - g df/dt = 1. What the roundings of these four take from that is the
    // same at each stage of a circular orbit: the momenta give it back, lest the energy drifts.
    let [by_g, by_r, by_f] = [g * by_position, f * r, f * by_momentum];
    let roundings = g.fma(by_position, -by_g) + (f.fma(r, -by_r) - f.fma(by_momentum, -by_f));
    let ([gained, over], [lost, under]) = (two_sum(by_g, -by_f), two_sum(by_momentum, -by_r));
    let excess = (gained - lost) + ((over - under) + roundings);
    // More than some dozen units is what the angular momentum of a fall has lost by cancellation, and not the momenta.
    let few = W::of(32.0) * unit() * (W::of(1.0) + f.abs()) * r;
    let excess = W::select(bound.and(excess.abs().less(few)), excess * arrival, zero);
    let rest = (-arrival).fma(r, W::of(1.0)) * arrival;
    let (mut by_q, mut by_p) = (q, p);
    for d in 0..D {
        by_q[d] = g.fma(p[d], f * q[d]);
        // Less than half a unit in the last place of a rounded number would be lost each time: it goes into the sum
        // with a product that is not rounded yet.
        let pull = by_position.fma(q[d], by_momentum * p[d]);
        let correction = (-excess).fma(arrival.fma(pull, -p[d]), rest * pull);
        by_p[d] = W::select(failed, W::of(f64::NAN), -arrival.fma(pull, correction));
    }
    let increments = Increments { q: by_q, p: by_p, failed };
    let increments = if falling.any() { increments.of_falls(body, orbit, falling) } else { increments };
    let functions = [first, second, third];
    (increments, Solution { orbit, inverse: [inverse, arrival + rest], s: s + d, functions, free, falling, bound })
}

impl<W: Real, const D: usize> Increments<W, D> {
    /// Replaces the increments in the lanes whose bodies fall from far away.
    #[inline(always)]
    fn of_falls(mut self, body: &Body<W, D>, orbit: Orbit<W>, falling: W::Mask) -> Self {
        let End { q, p, failed } = W::enter(Fall { body: *body, orbit });
        self.failed = self.failed.or(falling.and(failed));
        let undefined = W::of(f64::NAN);
        for d in 0..D {
            let by = |end: W, start: W| W::select(failed, undefined, end - start);
            self.q[d] = W::select(falling, by(q[d], body.q[d]), self.q[d]);
            self.p[d] = W::select(falling, by(p[d], body.p[d]), self.p[d]);
        }
        self
    }
}

/// The square of the velocity, from that of the momentum. Where that or the square of the inverse mass leaves the range of the
/// scalar or loses digits at its lower end, as that of a light particle in single precision does, no square is formed but that of
/// the velocity.
#[inline(always)]
fn velocity_squared<W: Real, const D: usize>(body: &Body<W, D>, momentum: W) -> W {
    let Body { p, inverse_mass, .. } = *body;
    let square = inverse_mass * inverse_mass;
    let [least, largest] = if is_single::<W>() { [1e-30, 1e37] } else { [1e-290, 1e307] };
    let [least, largest] = [W::of(least), W::of(largest)];
    let inside = least.less(square).and(square.less(largest)).and(least.less(momentum)).and(momentum.less(largest));
    let outside = inside.not();
    let velocity = square * momentum;
    if !outside.any() {
        return velocity;
    }
    let mut by_parts = W::of(0.0);
    for number in p {
        let part = inverse_mass * number;
        by_parts = part.fma(part, by_parts);
    }
    W::select(outside, by_parts, velocity)
}

/// A sum, and what its rounding took from it.
#[inline(always)]
fn two_sum<W: Real>(a: W, b: W) -> [W; 2] {
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

/// The spacing of numbers next to one.
#[inline(always)]
fn unit<W: Real>() -> W {
    W::of(if is_single::<W>() { f64::from(f32::EPSILON) } else { f64::EPSILON })
}

/// Whether the scalar is one of single precision, which rounds 1 + 2⁻³⁰ to 1.
#[inline(always)]
fn is_single<W: Real>() -> bool {
    (W::of(1.0) + W::of(4_194_304.0 * f64::EPSILON)).equal(W::of(1.0)).any()
}

/// The time without whole revolutions: within half a period, where the motion has one.
#[inline(always)]
fn within_a_period<W: Real>(mu: W, beta: W, time: W) -> W {
    // The period is 2π μ / β^(3/2): its half, squared, without a root or a division.
    let way = (beta * time) * (beta * time) * beta;
    let long = (mu * mu * W::of(PI * PI)).less(way);
    if !long.any() {
        return time;
    }
    let period = W::of(TAU) * mu / (beta * beta.sqrt());
    let whole = (time / period).round();
    W::select(long, (-whole).fma(period, time), time)
}

/// Finds the point of the orbit where the body is after the duration.
#[inline(always)]
pub(super) fn root<W: Real>(orbit: &Orbit<W>, inverse: W) -> Root<W> {
    let s = orbit.short_arc(inverse);
    let place = orbit.at(s);
    let (d, near) = place.correction(orbit.beta, s);
    let failed = near.and(orbit.is_within_half_a_period(s)).not();
    if failed.any() { W::enter(Search { orbit: *orbit, s, d, open: failed }) } else { Root { place, s, d, failed } }
}

/// The search for the root in the lanes of `open`, where the arc is not short; nothing changes in the others. A function of its
/// own: it is seldom needed, and much code.
pub(super) struct Search<W: Real> {
    pub(super) orbit: Orbit<W>,
    pub(super) s: W,
    pub(super) d: W,
    pub(super) open: W::Mask,
}

impl<W: Real> Kernel for Search<W> {
    type Out = Root<W>;
    const APART: bool = true;

    #[inline(always)]
    fn call(self) -> Root<W> {
        let Self { orbit, s, d, mut open } = self;
        // Mostly the correction is too long to be the last one and short enough to lead near the root.
        let mut s = W::select(open.and(d.abs().less(s.abs())), s + d, s);
        let mut bracket = [s; 2];
        let mut reached = W::Mask::of(false);
        let mut steps = 0;
        loop {
            // The tangent of a guess is none of the root's.
            s = W::select(open, number(s), s);
            let mut place = orbit.at(s);
            // Where no number is nearer, what is left is what the tangent of a dual needs.
            place.late = W::select(reached, place.late - number(place.late), place.late);
            let (d, mut near) = place.correction(orbit.beta, s);
            if steps == 0 {
                near = near.and(orbit.is_within_half_a_period(s));
            }
            open = open.and(near.or(reached).not());
            if !open.any() || steps == SEARCH {
                return Root { place, s, d, failed: open };
            }
            if steps == 0 {
                bracket = orbit.bracket();
                s = W::select(open, orbit.guess(bracket), s);
            } else {
                reached = reached.or(open.and(orbit.is_rounding(&place, s)));
                s = W::select(open.and(reached.not()), orbit.laguerre(&place, s, &mut bracket, steps), s);
            }
            steps += 1;
        }
    }
}

/// The number without a tangent, and without the digits that a double has not.
#[inline(always)]
fn number<W: Real>(x: W) -> W {
    W::parameter(&|lane| x.lane(lane))
}

/// The root of `d + a d² + b d³ + c d⁴ = y`, up to terms of the fifth order. Sums of powers, because all of these are
/// computed in lanes.
#[inline(always)]
fn reverted<W: Real>(y: W, [a, b, c]: [W; 3]) -> W {
    let square = y * y;
    let cubic = (a + a).fma(a, -b);
    let quartic = (W::of(5.0) * a).fma((-a).fma(a, b), -c);
    (square * square).fma(quartic, (square * y).fma(cubic, square.fma(-a, y)))
}

impl<W: Real> Orbit<W> {
    /// The universal variable of a short arc.
    #[inline(always)]
    fn short_arc(&self, inverse: W) -> W {
        let Self { eta, beta, zeta, time, .. } = *self;
        let a = eta * (W::of(0.5) * inverse);
        let b = zeta * (W::of(1.0 / 6.0) * inverse);
        reverted(time * inverse, [a, b, W::of(-1.0 / 12.0) * beta * a])
    }

    /// Whether a guess that is no search's is no longer than any arc within half a period. If the series has diverged, the later numbers
    /// are meaningless.
    #[inline(always)]
    fn is_within_half_a_period(&self, s: W) -> W::Mask {
        (self.beta * s * s).abs().less(W::of(LONGEST))
    }

    #[inline(always)]
    fn at(&self, s: W) -> Place<W> {
        let Self { mu, distance, eta, beta, zeta, time } = *self;
        let functions = functions(beta, s);
        let [zeroth, first, second, third] = functions;
        let late = zeta.fma(third, eta.fma(second, distance.fma(s, -time)));
        let r = eta.fma(first, zeta.fma(second, distance));
        let slope = zeta.fma(first, eta * zeroth);
        Place { functions, late, distance: [r, slope, (-beta).fma(r, mu)], inverse: W::of(1.0) / r }
    }

    /// Two values of the universal variable with the root in between: on every conic, `t >= |μ| s³ / 120`.
    #[inline(always)]
    fn bracket(&self) -> [W; 2] {
        let zero = W::of(0.0);
        let far = (W::of(121.0) * self.time / self.mu.abs()).cbrt();
        // Those that fall from far away for a long time are not solved here, and others stay beyond a sixteenth of the distance.
        // Farther along the orbit, the terms of the equation are so large that their sum has no right sign.
        let beyond = W::of(16.0) * self.time / self.distance;
        let is_beyond = come_from_far(self).and(beyond.abs().less(far.abs()));
        let far = W::select(is_beyond, beyond, far);
        let backwards = self.time.less(zero);
        [W::select(backwards, far, zero), W::select(backwards, zero, far)]
    }

    /// Returns the start of the search: the arc of a fall, which is as good on an ellipse, or that of a fast hyperbola.
    #[inline(always)]
    fn guess(&self, [low, high]: [W; 2]) -> W {
        let Self { mu, eta, beta, zeta, time, .. } = *self;
        let zero = W::of(0.0);
        let backwards = time.less(zero);
        let fall = (W::of(6.0) * time / mu.abs()).cbrt();
        let rate = (-beta).sqrt();
        let growth = rate.fma(W::select(backwards, -eta, eta), zeta);
        let far = ((rate + rate) * rate * rate * time.abs() / growth + W::of(1.0)).ln() / rate;
        let far = W::select(backwards, -far, far);
        let fast = W::of(3.0).less(rate * fall.abs());
        let guess = W::select(fast, far, fall);
        let inside = low.less(guess).and(guess.less(high));
        W::select(inside, guess, W::of(0.5) * (low + high))
    }

    /// Whether a point is as early or late as rounding can make it.
    #[inline(always)]
    fn is_rounding(&self, place: &Place<W>, s: W) -> W::Mask {
        let Self { distance, eta, zeta, time, .. } = *self;
        let [_, _, second, third] = place.functions;
        let terms = (distance * s).abs() + (eta * second).abs() + (zeta * third).abs() + time.abs();
        place.late.abs().less_or_equal(W::of(4.0) * unit() * terms)
    }

    /// The next point of a search, in a bracket that shrinks.
    #[inline(always)]
    fn laguerre(&self, place: &Place<W>, s: W, [low, high]: &mut [W; 2], steps: usize) -> W {
        let zero = W::of(0.0);
        let [r, slope, _] = place.distance;
        let late = place.late;
        // What has overflowed is too far from the beginning.
        let overflown = late.equal(late).not();
        let backwards = self.time.less(zero);
        let below = late.less(zero).or(overflown.and(backwards));
        *low = W::select(below, s, *low);
        *high = W::select(below, *high, s);
        let inner = (W::of(16.0) * r * r - W::of(20.0) * late * slope).abs().sqrt();
        let next = s - W::of(5.0) * late / (r + inner);
        let inside = low.less(next).and(next.less(*high)).and(W::Mask::of(!steps.is_multiple_of(8)));
        W::select(inside, next, W::of(0.5) * (*low + *high))
    }
}

impl<W: Real> Place<W> {
    /// The correction of `s` at this point, and whether it leads to the root.
    #[inline(always)]
    fn correction(&self, beta: W, s: W) -> (W, W::Mask) {
        let Self { distance: [r, slope, curvature], inverse, .. } = *self;
        let a = (W::of(0.5) * slope) * inverse;
        let b = (W::of(1.0 / 6.0) * curvature) * inverse;
        let c = (W::of(-1.0 / 12.0) * beta) * a;
        // The first order shows whether the series converges: far from the root its sum may be small by chance.
        let linear = -self.late * inverse;
        let square = linear * linear;
        let near = (a * linear).abs().less_or_equal(W::of(SHORT / 2.0));
        let near = near.and((b * square).abs().less_or_equal(W::of(SHORT * SHORT / 6.0)));
        let near = near.and((beta * square).abs().less_or_equal(W::of(SHORT * SHORT)));
        let near = near.and(linear.abs().less_or_equal(W::of(SMALL) * s.abs()));
        (reverted(linear, [a, b, c]), near.and(W::of(0.0).less(r)))
    }

    /// One over the distance `r` next to this place, so much farther: by the series of 1/(1 + x), whose error here is that of
    /// a division at most once it is corrected by its first order.
    #[inline(always)]
    fn arrival(&self, r: W, farther: W) -> W {
        let x = farther * self.inverse;
        let arrival = self.inverse.fma(x.fma(x, -x), self.inverse);
        let far = W::of(2.0 * SHORT).less(x.abs());
        if far.any() { W::select(far, W::of(1.0) / r, arrival) } else { arrival }
    }
}
