//! The exact flow of Kepler parts, `H = Σ p²/2m - k/|q|`.
//!
//! Comes in: positions and momenta of bodies in any number of dimensions, the inverse mass and the strength `k` of each
//! body, and a duration of either sign. Goes out: both moved by increments, through their slots. Always true: what
//! happens to a body depends on that body alone, bitwise, however many are computed in lanes; one whose orbit
//! could not be solved for becomes NaN, with a note of it.

pub(crate) mod fall;
pub(crate) mod faults;
pub(crate) mod pericentre;
pub(crate) mod shared;
mod slope;
mod stumpff;
#[cfg(test)]
mod tests;
pub(crate) mod universal;

use crate::{
    error::Unsolved,
    scalar::{
        implicit::Image,
        real::{Kernel, Mask, Real},
        simd::row::Row,
    },
    state::precision::Slot,
    system::motion::Solver,
};
use faults::Faults;
use slope::Way;
use universal::{Body, Increments};

/// The largest number of bodies that are computed in lanes.
const ROW: usize = 8;

/// A prepared constant of every body: one number for all, or a table.
pub trait OfBody<R: Real> {
    /// The constant of one body.
    fn of_body(&self, body: usize) -> R;
}

impl<R: Real> OfBody<R> for R {
    #[inline(always)]
    fn of_body(&self, _body: usize) -> R {
        *self
    }
}

impl<R: Real> OfBody<R> for [R] {
    #[inline(always)]
    fn of_body(&self, body: usize) -> R {
        self[body]
    }
}

/// The solver of the flow of a Kepler part, with a note of each lane in which it failed.
#[derive(Clone, Default)]
pub struct Kepler {
    unsolved: Faults,
}

impl<P> Solver<P> for Kepler {
    fn of(_constants: &[&P], _length: usize) -> Self {
        Self::default()
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.unsolved.copy(&from.unsolved);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.unsolved.of_lane(lane)
    }
}

impl Kepler {
    /// Moves every body along its orbit for a time `duration`.
    #[inline(always)]
    pub fn flow<R: Real, L: Slot<R>, const D: usize>(
        &mut self,
        [q, p]: [&mut [[L; D]]; 2],
        inverse_mass: &(impl OfBody<R> + ?Sized),
        strength: &(impl OfBody<R> + ?Sized),
        duration: f64,
    ) {
        let duration = R::of(duration);
        // With derivatives, a solver for rows beside the one for a body would double the code.
        if const { R::LANES != R::MEMBERS } || q.len() == 1 {
            self.in_rows::<R, R, L, D>([q, p], inverse_mass, strength, duration);
        } else {
            self.in_rows::<R, R::Wide, L, D>([q, p], inverse_mass, strength, duration);
        }
    }

    /// Moves the bodies in rows of as many as `W` has lanes for.
    #[inline(always)]
    fn in_rows<R: Real, W: Row<R>, L: Slot<R>, const D: usize>(
        &mut self,
        [q, p]: [&mut [[L; D]]; 2],
        inverse_mass: &(impl OfBody<R> + ?Sized),
        strength: &(impl OfBody<R> + ?Sized),
        duration: R,
    ) {
        let width = W::LANES / R::LANES;
        let mut first = 0;
        while first < q.len() {
            let count = width.min(q.len() - first);
            let [mut masses, mut strengths] = [[duration; ROW]; 2];
            for lane in 0..width {
                // Lanes after the last body repeat the first ones.
                masses[lane] = inverse_mass.of_body(first + lane % count);
                strengths[lane] = strength.of_body(first + lane % count);
            }
            let body = Body {
                q: read::<R, W, L, D>(&q[first..first + count]),
                p: read::<R, W, L, D>(&p[first..first + count]),
                inverse_mass: W::read(&masses),
                strength: W::read(&strengths),
            };
            let moved = moved::<R, W, D>(body, W::splat(duration));
            if moved.failed.any() {
                let mut failed = [duration; ROW];
                W::select(moved.failed, W::of(1.0), W::of(0.0)).write(&mut failed);
                self.note(first, &failed[..count], &q[first..], duration);
            }
            add(&mut q[first..first + count], moved.q);
            add(&mut p[first..first + count], moved.p);
            first += width;
        }
    }

    /// Notes which bodies could not be moved, before they are NaN.
    #[cold]
    #[inline(never)]
    fn note<R: Real, L: Slot<R>, const D: usize>(&mut self, first: usize, failed: &[R], q: &[[L; D]], duration: R) {
        for (body, (failed, q)) in failed.iter().zip(q).enumerate() {
            let mut square = R::of(0.0);
            for slot in q {
                square = slot.value().fma(slot.value(), square);
            }
            let distance = square.sqrt();
            let fault = |lane| {
                let [distance, duration] = [distance.lane(lane), duration.lane(lane)];
                (failed.lane(lane) == 1.0).then_some(Unsolved::Kepler { body: first + body, distance, duration })
            };
            self.unsolved.note(R::LANES, &fault);
        }
    }
}

/// The way of a row of bodies that are computed in `R`.
#[inline(always)]
pub(crate) fn moved<R: Real, W: Real, const D: usize>(body: Body<W, D>, duration: W) -> Increments<W, D> {
    if const { R::LANES == R::MEMBERS && (R::BEYOND_BASELINE || !cfg!(all(target_arch = "x86_64", feature = "std"))) } {
        return way(body, duration);
    }
    // With derivatives it is so much code that one copy has to do for all stages; the baseline of x86 has few users, and the copy of
    // the library serves all systems.
    R::enter(OneCopy { body, duration })
}

/// The call of [`way`] as a function that is not inlined.
struct OneCopy<W, const D: usize> {
    body: Body<W, D>,
    duration: W,
}

impl<W: Real, const D: usize> Kernel for OneCopy<W, D> {
    type Out = Increments<W, D>;

    #[inline(always)]
    fn call(self) -> Increments<W, D> {
        way(self.body, self.duration)
    }
}

/// The way of a row of bodies, of which a dual finds the value first.
#[inline(always)]
fn way<W: Real, const D: usize>(body: Body<W, D>, duration: W) -> Increments<W, D> {
    let Body { q, p, inverse_mass, strength } = body;
    let Image { point: [q, p], failed } = W::solved::<Way, D, 3>([q, p], [inverse_mass, strength, duration]);
    Increments { q, p, failed }
}

/// The coordinates of a row of bodies.
#[inline(always)]
fn read<R: Real, W: Row<R>, L: Slot<R>, const D: usize>(bodies: &[[L; D]]) -> [W; D] {
    let mut rows = [W::of(0.0); D];
    let mut numbers = [R::of(0.0); ROW];
    for d in 0..D {
        for lane in 0..W::LANES / R::LANES {
            numbers[lane] = bodies[lane % bodies.len()][d].value();
        }
        rows[d] = W::read(&numbers);
    }
    rows
}

/// Adds increments to the coordinates of a row of bodies.
#[inline(always)]
fn add<R: Real, W: Row<R>, L: Slot<R>, const D: usize>(bodies: &mut [[L; D]], increments: [W; D]) {
    let mut numbers = [R::of(0.0); ROW];
    for d in 0..D {
        increments[d].write(&mut numbers);
        for (body, number) in bodies.iter_mut().zip(numbers) {
            body[d].add(number);
        }
    }
}
