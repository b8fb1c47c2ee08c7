//! The equation of an implicit step, by fixed-point iteration down to the rounding.
//!
//! Steps of a motion that oscillates are accurate where they turn by much less than a radian, and there each iteration
//! gains digits for the price of the field alone. Where it does not, Newton's iteration takes over.
//!
//! The stages are the lanes of a row, so that the field is evaluated once for all of them where such rows are vectors. The
//! iteration ends where no number comes nearer to its limit any more (Antoñana, Makazaga and Murua 2017), so that no tolerance
//! biases the rounding errors.

use super::{
    field::{Constants, Field, Pair},
    motion::{Implicit, together},
    rows::{Rows, keep_settled, spread, stages_of},
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
    system::{
        Shaped, System,
        motion::{Motion, Prepared},
    },
    trajectory::step_functions::{Executor, StepFunctions},
};
use alloc::vec::Vec;
use core::{marker::PhantomData, mem::swap, slice::from_mut};

/// The largest number of iterations. A usable iteration at least halves the distance each time, so that more lead
/// nowhere.
const ITERATIONS: u32 = 64;

/// An update that no longer shrinks is rounding if it is as small as this, in ε of the largest coordinate of its kind.
const STALLED: f64 = 64.0;

/// The motion of an implicit step.
pub(super) type Moved<F, H, R, K> = Implicit<F, R, Shaped<H, K>, <H as System>::Parameters<R>>;

/// The step functions of a method with the stages of `M`.
pub(super) fn step_functions<F, H, R, K, E, M, const S: usize>() -> StepFunctions<Moved<F, H, R, K>>
where
    F: Field<H>,
    H: System,
    R: Real,
    K: Precision,
    E: Executor,
    M: Stages<S>,
{
    let functions = |advance, dense| {
        let dense = if const { F::IS_FICTITIOUS } { Some(dense) } else { None };
        StepFunctions::of_whole_steps(R::LANES, advance, dense)
    };
    match const { F::IS_FICTITIOUS && E::ALONG_STARTS } {
        true => functions(advance::<F, H, R, K, M, S, true>, dense::<F, H, R, K, M, S, true>),
        false => functions(advance::<F, H, R, K, M, S, false>, dense::<F, H, R, K, M, S, false>),
    }
}

/// Takes steps with each motion. `ALONG_STARTS` is that of the executor.
fn advance<F, H, R, K, M, const S: usize, const ALONG_STARTS: bool>(
    motions: &mut [Moved<F, H, R, K>],
    clock: Clock,
    steps: u64,
    _threads: Option<usize>,
) where
    F: Field<H>,
    H: System,
    R: Real,
    K: Precision,
    M: Stages<S>,
{
    for motion in motions {
        R::enter(Steps::<F, H, R, K, S> { motion, along_starts: ALONG_STARTS, clock, steps, tableau: &M::TABLEAU });
    }
}

/// Takes a motion a while into the step that begins at the other one: by one shorter step.
fn dense<F, H, R, K, M, const S: usize, const ALONG_STARTS: bool>(
    to: &mut Moved<F, H, R, K>,
    begin: &Moved<F, H, R, K>,
    clock: Clock,
    duration: f64,
) where
    F: Field<H>,
    H: System,
    R: Real,
    K: Precision,
    M: Stages<S>,
{
    to.copy_state(begin);
    advance::<F, H, R, K, M, S, ALONG_STARTS>(from_mut(to), Clock { h: duration, ..clock }, 1, None);
}

/// Whether the field may be evaluated for all stages at once: they have the time in common, and eight lanes take less time than
/// these stages one after the other.
pub(super) const fn may_be_together<F: Field<H>, H: System>(stages: usize) -> bool {
    stages > 2 && F::MAY_BE_TOGETHER
}

/// Whether it is: the lanes of rows are those of one number, not of a dual, whose derivatives settle later than its value.
const fn are_together<F: Field<H>, H: System, R: Real, const S: usize>() -> bool {
    may_be_together::<F, H>(S) && R::LANES == 1 && <R::Row<S> as Row<R>>::PARTS == 0
}

/// Steps of one motion.
struct Steps<'m, F: Field<H>, H: System, R: Real, K: Precision, const S: usize> {
    motion: &'m mut Moved<F, H, R, K>,
    /// Whether derivatives are taken along starts, each with its own energy, and not at the same energy.
    along_starts: bool,
    clock: Clock,
    steps: u64,
    tableau: &'m Tableau<S>,
}

impl<F: Field<H>, H: System, R: Real, K: Precision, const S: usize> Kernel for Steps<'_, F, H, R, K, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        if const { are_together::<F, H, R, S>() } {
            let of_lanes: Vec<_> = (0..<R::Row<S>>::LANES).map(|_| &self.motion.constants[0]).collect();
            let gathered = H::Parameters::<R::Row<S>>::gather(&of_lanes);
            return self.take::<R::Row<S>>(Some(gathered));
        }
        self.take::<Lanes<R, S>>(None);
    }
}

impl<F: Field<H>, H: System, R: Real, K: Precision, const S: usize> Steps<'_, F, H, R, K, S> {
    /// Takes the steps, with the stages in rows `W`, and the constants in such rows if the stages are computed together.
    ///
    /// An end that was not found is remembered, and the member has no step from there, while others go on.
    #[inline(always)]
    fn take<W: Row<R>>(self, mut gathered: Option<H::Parameters<W>>) {
        let Self { motion, along_starts, clock, steps, tableau } = self;
        let count = Shaped::<H, K>::slots(&motion.state.q).len();
        let (mut y, mut rows) = (Pair::zero(count), Rows::<H, R, W>::new(count));
        for step in clock.steps..clock.steps + steps {
            let stopped = if motion.unsolved.is_empty() { R::of(0.0) } else { motion.stopped() };
            if (0..R::LANES).all(|lane| stopped.lane(lane) > 0.0) {
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
            let conjugate = *motion.conjugate.get_or_insert_with(|| {
                let conjugate = F::conjugate(&motion.state.parameters, &y);
                if along_starts { conjugate } else { R::parameter(&|lane| conjugate.lane(lane)) }
            });
            let constants = Constants {
                gathered: &motion.state.parameters,
                of_lanes: &motion.constants,
                shape: &motion.shape,
                middle,
            };
            let field = PhantomData::<F>;
            let equation = Equation { constants, conjugate, y: &y, time, h, epsilon: K::EPSILON, tableau, field };
            let (evaluations, mut faults) = equation.solve(stopped, gathered.as_ref(), &mut rows);
            if const { F::IS_FICTITIOUS } {
                let rates = equation.rates(gathered.as_ref(), &mut rows);
                let duration = equation.duration(&stages_of::<R, W>(rates), &mut faults);
                motion.time.add(duration);
            }
            motion.evaluations += evaluations;
            motion.stop(faults);
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

/// A number of each stage, that of the last one in the lanes after it too.
#[inline(always)]
fn of_stages<R: Real, W: Row<R>, const S: usize>(of: &dyn Fn(usize) -> f64) -> W {
    W::parameter(&|lane| of((lane / R::LANES).min(S - 1)))
}

/// The equation of a step from a point.
pub(super) struct Equation<'m, F, H: System, R: Real, const S: usize> {
    pub(super) constants: Constants<'m, H, R>,
    /// The momentum that is conjugate to the time.
    pub(super) conjugate: R,
    pub(super) y: &'m Pair<H, R>,
    pub(super) time: f64,
    pub(super) h: f64,
    /// The spacing of numbers just above one in this precision.
    pub(super) epsilon: f64,
    pub(super) tableau: &'m Tableau<S>,
    pub(super) field: PhantomData<F>,
}

impl<F: Field<H>, H: System, R: Real, const S: usize> Equation<'_, F, H, R, S> {
    /// Finds the increments, and returns the number of evaluations and the faults of lanes without a solution, an empty list if
    /// all have one. Lanes that have settled keep their result, so no lane iterates because of another one; some may have settled
    /// before.
    #[inline(always)]
    fn solve<W: Row<R>>(
        &self,
        mut settled: R,
        gathered: Option<&H::Parameters<W>>,
        rows: &mut Rows<H, R, W>,
    ) -> (u64, Vec<Option<Unsolved>>) {
        let Self { tableau: Tableau { b, .. }, y, h, .. } = self;
        let columns = self.columns::<W>();
        let weights = of_stages::<R, W, S>(&|stage| b[stage] * h);
        for numbers in rows.least.halves_mut() {
            numbers.fill(W::state(&|_| f64::INFINITY));
        }
        self.begin(gathered, rows);
        for half in 0..2 {
            rows.scale(half, weights);
        }
        swap(&mut rows.increments, &mut rows.found);
        let mut evaluations = u64::from(!F::HAS_HALVES);
        for _ in 0..ITERATIONS {
            if const { F::HAS_HALVES } {
                // Velocities follow the new forces, so that half as many iterations are needed.
                rows.place(0, y, &columns, false);
                self.half_of_fields(1, gathered, rows);
                rows.scale(1, weights);
                rows.place(1, y, &columns, true);
                self.half_of_fields(0, gathered, rows);
                rows.scale(0, weights);
            } else {
                for half in 0..2 {
                    rows.place(half, y, &columns, false);
                }
                self.fields(gathered, rows);
                for half in 0..2 {
                    rows.scale(half, weights);
                }
            }
            evaluations += S as u64;
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

    /// The coefficients `μ_ij` of each increment.
    #[inline(always)]
    fn columns<W: Row<R>>(&self) -> [W; S] {
        let mut columns = [W::of(0.0); S];
        for (j, column) in columns.iter_mut().enumerate() {
            *column = of_stages::<R, W, S>(&|stage| self.tableau.mu[stage][j]);
        }
        columns
    }

    /// The rates at the stages of the step that was found.
    #[inline(always)]
    fn rates<W: Row<R>>(&self, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) -> W {
        let columns = self.columns();
        for half in 0..2 {
            rows.place(half, self.y, &columns, false);
        }
        if const { are_together::<F, H, R, S>() } {
            return gathered.map_or(W::of(f64::NAN), |gathered| F::rate(gathered, &rows.places));
        }
        let (mut place, mut rates) = (self.y.clone(), W::of(1.0));
        for stage in 0..S {
            place.read_stage(&rows.places, stage);
            rates.set_part(stage, F::rate(self.constants.gathered, &place));
        }
        rates
    }

    /// The duration of the step by the rates at its stages. Members with a rate that is not positive have a fault.
    #[inline(always)]
    fn duration(&self, rates: &[R], faults: &mut Vec<Option<Unsolved>>) -> R {
        let (mut duration, mut least) = (R::of(0.0), rates[0]);
        for (rate, weight) in rates.iter().zip(&self.tableau.b) {
            duration += R::of(weight * self.h) / *rate;
            least = least.min(*rate);
        }
        for lane in (0..R::LANES).step_by(together::<R>()) {
            let value = least.lane(lane);
            if value <= 0.0 {
                faults.resize(R::LANES, None);
                faults[lane].get_or_insert(Unsolved::Rate { value });
            }
        }
        duration
    }

    /// The field at the beginning of the step, for all stages; velocities alone where the first forces follow them.
    #[inline(always)]
    fn begin<W: Row<R>>(&self, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) {
        for (places, y) in rows.places.halves_mut().into_iter().zip(self.y.halves()) {
            spread(y, places);
        }
        if const { F::HAS_HALVES } {
            rows.found.halves_mut()[1].fill(W::of(0.0));
            return self.half_of_fields(0, gathered, rows);
        }
        if const { W::PARTS == 0 } {
            return self.fields(gathered, rows);
        }
        let first = F::at(&self.constants, self.conjugate, self.y, self.time);
        for (found, first) in rows.found.halves_mut().into_iter().zip(first.halves()) {
            spread(first, found);
        }
    }

    /// One half of the field at all stages.
    #[inline(always)]
    fn half_of_fields<W: Row<R>>(&self, half: usize, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) {
        let Rows { found, places, .. } = rows;
        if const { are_together::<F, H, R, S>() } {
            let Some(gathered) = gathered else { return };
            found.halves_mut()[half].fill(W::of(0.0));
            return F::add_half(gathered, W::splat(self.conjugate), half, places, found, self.time);
        }
        let mut place = self.y.clone();
        for stage in 0..S {
            place.read_stage(places, stage);
            let time = self.time + self.tableau.c[stage] * self.h;
            let field = F::half_at(&self.constants, self.conjugate, half, &place, time);
            let (field, found) = (H::Coords::slots(&field), &mut *found.halves_mut()[half]);
            for k in 0..field.len() {
                found[k].set_part(stage, field[k]);
            }
        }
    }

    /// The field at all stages.
    #[inline(always)]
    fn fields<W: Row<R>>(&self, gathered: Option<&H::Parameters<W>>, rows: &mut Rows<H, R, W>) {
        let Rows { found, places, .. } = rows;
        if const { are_together::<F, H, R, S>() } {
            let Some(gathered) = gathered else { return };
            for numbers in found.halves_mut() {
                numbers.fill(W::of(0.0));
            }
            return F::add(gathered, W::splat(self.conjugate), places, found, self.time);
        }
        let mut place = self.y.clone();
        for stage in 0..S {
            place.read_stage(places, stage);
            let field = F::at(&self.constants, self.conjugate, &place, self.time + self.tableau.c[stage] * self.h);
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
            let unsolved = Unsolved::Contraction { h: self.h, iterations: ITERATIONS, update: update.lane(lane) };
            (settled.lane(lane) == 0.0).then_some(unsolved)
        };
        (0..R::LANES).map(reason).collect()
    }
}
