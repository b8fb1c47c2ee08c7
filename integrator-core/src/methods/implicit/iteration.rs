//! The equation of an implicit step, by fixed-point iteration down to the rounding.
//!
//! Steps of a motion that oscillates are accurate where they turn by much less than a radian, and there each iteration
//! gains digits for the price of the field alone. Where it does not, Newton's iteration takes over.

use super::{
    field::{Constants, Pair, field},
    motion::Implicit,
    tableau::{Stages, Tableau},
};
use crate::{
    error::Unsolved,
    scalar::real::{Kernel, Real},
    state::{
        clock::Clock,
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{Shaped, System, motion::Prepared},
};
use alloc::vec::Vec;

/// The largest number of iterations. A usable iteration at least halves the distance each time, so that more lead
/// nowhere.
const ITERATIONS: u32 = 64;

/// An update that no longer shrinks is rounding if it is as small as this, in ε of the largest coordinate of its kind.
const STALLED: f64 = 64.0;

/// The motion of an implicit step.
type Moved<H, R, K> = Implicit<R, Shaped<H, K>, <H as System>::Parameters<R>>;

/// Takes steps with each motion.
pub(super) fn advance<H: System, R: Real, K: Precision, M: Stages<S>, const S: usize>(
    motions: &mut [Moved<H, R, K>],
    clock: Clock,
    steps: u64,
    _threads: Option<usize>,
) {
    for motion in motions {
        R::enter(Steps::<H, R, K, S> { motion, clock, steps, tableau: &M::TABLEAU });
    }
}

/// Steps of one motion.
struct Steps<'m, H: System, R: Real, K: Precision, const S: usize> {
    motion: &'m mut Moved<H, R, K>,
    clock: Clock,
    steps: u64,
    tableau: &'m Tableau<S>,
}

impl<H: System, R: Real, K: Precision, const S: usize> Kernel for Steps<'_, H, R, K, S> {
    type Out = ();

    /// An end that was not found is remembered, and no step is taken from there.
    #[inline(always)]
    fn call(self) {
        let Self { motion, clock, steps, tableau } = self;
        for step in clock.steps..clock.steps + steps {
            if !motion.unsolved.is_empty() {
                return;
            }
            let (time, h) = (clock.at(step), clock.h);
            motion.state.parameters.begin_step(time + h / 2.0);
            let count = Shaped::<H, K>::slots(&motion.state.q).len();
            let mut y = Pair::<H, R>::zero(count);
            let [q, p] = [&motion.state.q, &motion.state.p].map(Shaped::<H, K>::slots);
            for (numbers, slots) in y.halves_mut().into_iter().zip([q, p]) {
                for (number, slot) in numbers.iter_mut().zip(slots) {
                    *number = slot.value();
                }
            }
            let constants = Constants {
                gathered: &motion.state.parameters,
                of_lanes: &motion.constants,
                shape: &motion.shape,
                middle: time + h / 2.0,
            };
            let equation = Equation { constants, y: &y, time, h, epsilon: K::EPSILON, tableau };
            let Solution { slopes, evaluations, unsolved } = equation.solution();
            motion.evaluations += evaluations;
            motion.unsolved = unsolved;
            let [q, p] = [&mut motion.state.q, &mut motion.state.p].map(Shaped::<H, K>::slots_mut);
            for (half, slots) in [q, p].into_iter().enumerate() {
                for (k, slot) in slots.iter_mut().enumerate() {
                    let mut sum = R::of(tableau.b[0] * h) * slopes[0].halves()[half][k];
                    for (slopes, b) in slopes.iter().zip(&tableau.b).skip(1) {
                        sum = R::of(b * h).fma(slopes.halves()[half][k], sum);
                    }
                    slot.add(sum);
                }
            }
        }
    }
}

/// The equation of a step from a point.
pub(super) struct Equation<'m, H: System, R: Real, const S: usize> {
    pub(super) constants: Constants<'m, H, R>,
    pub(super) y: &'m Pair<H, R>,
    pub(super) time: f64,
    pub(super) h: f64,
    /// The spacing of numbers just above one in this precision.
    pub(super) epsilon: f64,
    pub(super) tableau: &'m Tableau<S>,
}

/// The field at the stages.
struct Solution<H: System, R: Real, const S: usize> {
    slopes: [Pair<H, R>; S],
    evaluations: u64,
    /// The faults of lanes without a solution; empty if all have one.
    unsolved: Vec<Option<Unsolved>>,
}

impl<H: System, R: Real, const S: usize> Equation<'_, H, R, S> {
    /// Converged lanes keep their result, so no lane iterates because of another one.
    #[inline(always)]
    fn solution(&self) -> Solution<H, R, S> {
        let first = field::<H, R>(&self.constants, self.y, self.time);
        let mut slopes: [Pair<H, R>; S] = core::array::from_fn(|_| first.clone());
        let mut evaluations = 1;
        let (mut update, mut settled) = (R::of(f64::INFINITY), R::of(0.0));
        for _ in 0..ITERATIONS {
            let mut found = slopes.clone();
            for (i, found) in found.iter_mut().enumerate() {
                let stage = self.stage(&slopes, i);
                *found = field::<H, R>(&self.constants, &stage, self.time + self.tableau.c[i] * self.h);
            }
            evaluations += S as u64;
            let now = R::state(&|lane| self.moved(&slopes, &found, lane));
            keep_settled(&settled, &slopes, &mut found);
            slopes = found;
            settled = R::state(&|lane| {
                let (now, before) = (now.lane(lane), update.lane(lane));
                let ends = now == 0.0 || now >= before && now <= STALLED * self.epsilon;
                f64::from(u8::from(ends)).max(settled.lane(lane))
            });
            update = now;
            if (0..R::LANES).all(|lane| settled.lane(lane) > 0.0) {
                return Solution { slopes, evaluations, unsolved: Vec::new() };
            }
        }
        let unsolved = self.without_contraction(&mut slopes, settled, update, &mut evaluations);
        Solution { slopes, evaluations, unsolved }
    }

    /// The place of a stage.
    #[inline(always)]
    fn stage(&self, slopes: &[Pair<H, R>; S], i: usize) -> Pair<H, R> {
        let mut stage = self.y.clone();
        for (half, numbers) in stage.halves_mut().into_iter().enumerate() {
            for (k, number) in numbers.iter_mut().enumerate() {
                for (slopes, a) in slopes.iter().zip(&self.tableau.a[i]) {
                    *number = R::of(a * self.h).fma(slopes.halves()[half][k], *number);
                }
            }
        }
        stage
    }

    /// Returns the largest change of a lane in an iteration, relative to the largest coordinate of the kind that
    /// changed.
    #[inline(always)]
    fn moved(&self, slopes: &[Pair<H, R>; S], found: &[Pair<H, R>; S], lane: usize) -> f64 {
        let mut most = 0.0_f64;
        for half in 0..2 {
            let y = self.y.halves()[half];
            for (before, after) in slopes.iter().zip(found) {
                let (before, after) = (before.halves()[half], after.halves()[half]);
                let (mut moved, mut size) = (0.0_f64, 0.0_f64);
                for k in 0..y.len() {
                    let after = self.h * after[k].lane(lane);
                    let step = (after - self.h * before[k].lane(lane)).abs();
                    moved = larger(moved, step);
                    size = size.max(y[k].lane(lane).abs()).max(after.abs());
                }
                // Nothing in units of nothing is nothing.
                let relative = if moved == 0.0 { 0.0 } else { moved / size };
                most = larger(most, relative);
            }
        }
        most
    }

    /// Solves the lanes that are not settled by Newton's method.
    #[cfg(feature = "check")]
    fn without_contraction(
        &self,
        slopes: &mut [Pair<H, R>; S],
        settled: R,
        _: R,
        evaluations: &mut u64,
    ) -> Vec<Option<Unsolved>> {
        super::newton::solve(self, slopes, settled, evaluations)
    }

    /// Returns an error for the lanes that are not settled, since there are no matrices without the feature `check`.
    #[cfg(not(feature = "check"))]
    fn without_contraction(
        &self,
        _: &mut [Pair<H, R>; S],
        settled: R,
        update: R,
        _: &mut u64,
    ) -> Vec<Option<Unsolved>> {
        let reason = |lane| {
            let unsolved = Unsolved::Contraction { iterations: ITERATIONS, update: update.lane(lane) };
            (settled.lane(lane) == 0.0).then_some(unsolved)
        };
        (0..R::LANES).map(reason).collect()
    }
}

/// The larger of two numbers, or what is no number: then nothing has settled, whatever the other coordinates do.
#[inline(always)]
fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other <= one { one } else { other }
}

/// Restores the previous slopes in the lanes that are settled.
#[inline(always)]
pub(super) fn keep_settled<H: System, R: Real, const S: usize>(
    settled: &R,
    slopes: &[Pair<H, R>; S],
    found: &mut [Pair<H, R>; S],
) {
    if (0..R::LANES).all(|lane| settled.lane(lane) == 0.0) {
        return;
    }
    for (slopes, found) in slopes.iter().zip(found) {
        for (before, after) in slopes.halves().into_iter().zip(found.halves_mut()) {
            for (before, after) in before.iter().zip(after) {
                let now = *after;
                *after = R::state(&|lane| if settled.lane(lane) > 0.0 { before.lane(lane) } else { now.lane(lane) });
            }
        }
    }
}
