//! The equation of an implicit step, by fixed-point iteration down to the rounding.
//!
//! Steps of a motion that oscillates are accurate where they turn by much less than a radian, and there each iteration
//! gains digits for the price of the field alone. Where it does not, Newton's iteration takes over.
//!
//! The stages are the lanes of a row, so that the field is evaluated once for all of them where such rows are vectors. The
//! iteration ends where no number comes nearer to its limit any more (Antoñana, Makazaga and Murua 2017), so that no tolerance
//! biases the rounding errors.

use super::{
    field::{Constants, Pair, add_field, field_of_step},
    motion::Implicit,
    rows::{Rows, keep_settled, scale, spread, stages_of},
    tableau::{Stages, Tableau},
};
use crate::{
    error::Unsolved,
    scalar::{
        real::{Kernel, Real},
        simd::{lanes::Lanes, row::Row},
    },
    state::{
        clock::Clock,
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{Shaped, System, motion::Prepared},
};
use alloc::vec::Vec;
use core::mem::swap;

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

/// Whether the field may be evaluated for all stages at once: they have the time in common, and eight lanes take less time than
/// these stages one after the other.
pub(super) const fn may_be_together<H: System>(stages: usize) -> bool {
    stages > 2 && H::AUTONOMOUS && H::HAS_FIELD
}

/// Whether it is: the lanes of rows are those of one number, not of a dual, whose derivatives settle later than its value.
const fn are_together<H: System, R: Real, const S: usize>() -> bool {
    may_be_together::<H>(S) && R::LANES == 1 && <R::Row<S> as Row<R>>::PARTS == 0
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

    #[inline(always)]
    fn call(self) {
        if const { are_together::<H, R, S>() } {
            let of_lanes: Vec<_> = (0..<R::Row<S>>::LANES).map(|_| &self.motion.constants[0]).collect();
            let gathered = H::Parameters::<R::Row<S>>::gather(&of_lanes);
            return self.take::<R::Row<S>>(Some(gathered));
        }
        self.take::<Lanes<R, S>>(None);
    }
}

impl<H: System, R: Real, K: Precision, const S: usize> Steps<'_, H, R, K, S> {
    /// Takes the steps, with the stages in rows `W`, and the constants in such rows if the stages are computed together.
    ///
    /// An end that was not found is remembered, and no step is taken from there.
    #[inline(always)]
    fn take<W: Row<R>>(self, mut gathered: Option<H::Parameters<W>>) {
        let Self { motion, clock, steps, tableau } = self;
        let count = Shaped::<H, K>::slots(&motion.state.q).len();
        let (mut y, mut rows) = (Pair::zero(count), Rows::<H, R, W>::new(count));
        for step in clock.steps..clock.steps + steps {
            if !motion.unsolved.is_empty() {
                return;
            }
            let (time, h) = (clock.at(step), clock.h);
            let middle = time + h / 2.0;
            motion.state.parameters.begin_step(middle);
            if let Some(gathered) = &mut gathered {
                gathered.begin_step(middle);
            }
            let [q, p] = [&motion.state.q, &motion.state.p].map(Shaped::<H, K>::slots);
            for (numbers, slots) in y.halves_mut().into_iter().zip([q, p]) {
                for k in 0..slots.len() {
                    numbers[k] = slots[k].value();
                }
            }
            let constants = Constants {
                gathered: &motion.state.parameters,
                of_lanes: &motion.constants,
                shape: &motion.shape,
                middle,
            };
            let equation = Equation { constants, y: &y, time, h, epsilon: K::EPSILON, tableau };
            let (evaluations, unsolved) = equation.solve(gathered.as_ref(), &mut rows);
            motion.evaluations += evaluations;
            motion.unsolved = unsolved;
            let [q, p] = [&mut motion.state.q, &mut motion.state.p].map(Shaped::<H, K>::slots_mut);
            for (increments, slots) in rows.increments.halves().into_iter().zip([q, p]) {
                for k in 0..slots.len() {
                    let stages = stages_of::<R, W>(increments[k]);
                    let mut sum = stages[0];
                    for increment in &stages[1..S] {
                        sum += *increment;
                    }
                    slots[k].add(sum);
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

impl<H: System, R: Real, const S: usize> Equation<'_, H, R, S> {
    /// Finds the increments, and returns the number of evaluations and the faults of lanes without a solution, an empty list if
    /// all have one. Lanes that have settled keep their result, so no lane iterates because of another one.
    #[inline(always)]
    fn solve<W: Row<R>>(
        &self,
        gathered: Option<&H::Parameters<W>>,
        rows: &mut Rows<H, R, W>,
    ) -> (u64, Vec<Option<Unsolved>>) {
        let Self { tableau: Tableau { mu, b, .. }, y, h, .. } = self;
        // After the last stage, it is repeated.
        let of_stage = |of: &dyn Fn(usize) -> f64| W::parameter(&|lane| of((lane / R::LANES).min(S - 1)));
        let mut columns = [W::of(0.0); S];
        for (j, column) in columns.iter_mut().enumerate() {
            *column = of_stage(&|stage| mu[stage][j]);
        }
        let weights = of_stage(&|stage| b[stage] * h);
        for numbers in rows.least.halves_mut() {
            numbers.fill(W::state(&|_| f64::INFINITY));
        }
        self.begin(gathered, rows);
        scale(&mut rows.found, weights);
        swap(&mut rows.increments, &mut rows.found);
        let mut evaluations = 1;
        let mut settled = R::of(0.0);
        for _ in 0..ITERATIONS {
            for half in 0..2 {
                let (y, increments) = (y.halves()[half], rows.increments.halves()[half]);
                let places = &mut *rows.places.halves_mut()[half];
                for k in 0..y.len() {
                    let stages = stages_of::<R, W>(increments[k]);
                    let mut sum = W::splat(stages[0]).scale(columns[0]);
                    for j in 1..S {
                        sum = W::splat(stages[j]).scale_add(columns[j], sum);
                    }
                    places[k] = W::splat(y[k]) + sum;
                }
            }
            self.fields(gathered, rows);
            evaluations += S as u64;
            scale(&mut rows.found, weights);
            let shrinks = if const { W::PARTS == 0 } { rows.shrink_together() } else { rows.shrink::<S>() };
            keep_settled::<H, R, W>(&settled, &rows.increments, &mut rows.found);
            settled = R::state(&|lane| {
                // Only a lane that does not come nearer may have arrived.
                let has_arrived = || rows.update::<S>(y, lane) <= STALLED * self.epsilon;
                let ends = settled.lane(lane) > 0.0 || shrinks.lane(lane) == 0.0 && has_arrived();
                f64::from(u8::from(ends))
            });
            swap(&mut rows.increments, &mut rows.found);
            if (0..R::LANES).all(|lane| settled.lane(lane) > 0.0) {
                return (evaluations, Vec::new());
            }
        }
        let update = R::state(&|lane| rows.update::<S>(y, lane));
        let unsolved = self.without_contraction(&mut rows.increments, settled, update, &mut evaluations);
        (evaluations, unsolved)
    }

    /// The field at the beginning of the step, for all stages.
    #[inline(always)]
    fn begin<W: Row<R>>(&self, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) {
        if const { W::PARTS == 0 } {
            for (places, y) in rows.places.halves_mut().into_iter().zip(self.y.halves()) {
                spread(y, places);
            }
            return self.fields(gathered, rows);
        }
        let first = field_of_step::<H, R>(&self.constants, self.y, self.time);
        for (found, first) in rows.found.halves_mut().into_iter().zip(first.halves()) {
            spread(first, found);
        }
    }

    /// The field at all stages.
    #[inline(always)]
    fn fields<W: Row<R>>(&self, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) {
        let Rows { found, places, .. } = rows;
        if const { are_together::<H, R, S>() } {
            let Some(gathered) = gathered else { return };
            for numbers in found.halves_mut() {
                numbers.fill(W::of(0.0));
            }
            return add_field::<H, W>(gathered, places, found, self.time);
        }
        let mut place = self.y.clone();
        for stage in 0..S {
            for (place, places) in place.halves_mut().into_iter().zip(places.halves()) {
                for k in 0..place.len() {
                    place[k] = places[k].part(stage);
                }
            }
            let field = field_of_step::<H, R>(&self.constants, &place, self.time + self.tableau.c[stage] * self.h);
            for (found, field) in found.halves_mut().into_iter().zip(field.halves()) {
                for k in 0..field.len() {
                    found[k].set_part(stage, field[k]);
                }
            }
        }
    }

    /// Solves the lanes that are not settled by Newton's method.
    #[cfg(feature = "check")]
    fn without_contraction<W: Row<R>>(
        &self,
        increments: &mut Pair<H, W>,
        settled: R,
        _: R,
        evaluations: &mut u64,
    ) -> Vec<Option<Unsolved>> {
        super::without_contraction::solve(self, increments, settled, evaluations)
    }

    /// Returns an error for the lanes that are not settled, since there are no matrices without the feature `check`.
    #[cfg(not(feature = "check"))]
    fn without_contraction<W: Row<R>>(
        &self,
        _: &mut Pair<H, W>,
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
