//! A trajectory with deviation vectors, which are multiplied by the exact derivative of each step.
//!
//! The state is bitwise identical to that of a run without vectors. Vectors are rescaled by powers of two only, at steps
//! whose number is a multiple of [`BETWEEN_SCALES`], and only for methods whose runs depend on the state alone; the
//! exponents are returned.

#[cfg(feature = "checkpoint")]
mod stored;
#[cfg(feature = "check")]
mod units;
mod vectors;
mod within_step;

use crate::{
    error::{Error, VectorFault},
    scalar::exact::power_of_two,
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::{Shaped, System},
    trajectory::{
        admissible::admissible_with,
        dispatch::{Carried, Deviations, bound, is_compiled},
        method::Differentiable,
        motions::{Motions, copy},
        run::{Behind, Lane, Run},
    },
};
use alloc::{boxed::Box, vec, vec::Vec};
use core::{fmt, mem::take, ops::Range};
pub(crate) use vectors::{far_exponent, numbers, scaled};
#[cfg(feature = "check")]
pub(crate) use {
    units::Units,
    vectors::{may_be_far, squares, unit_vectors},
};

/// The number of steps after which the lengths of vectors are tested for a rescaling.
pub(crate) const BETWEEN_SCALES: u64 = 64;

/// The number of vectors that go with one copy of the state, where there are several: as many numbers as fill a
/// register of 256 bits.
pub(crate) const TOGETHER: usize = 4;

/// A trajectory with deviation vectors `(δq, δp)`, returned by [`Hamiltonian::tangent`](crate::Hamiltonian::tangent).
///
/// Each step multiplies the vectors by its exact derivative: a vector is the difference to a neighbouring orbit, to first
/// order in the initial distance and divided by it. This linear map is symplectic if the method is.
pub struct Tangent<C: Coords> {
    /// Trajectories of the same state, each with some of the vectors.
    runs: Vec<Run<C>>,
    /// The number of vectors that a run has room for.
    room: usize,
    /// The powers of two by which vectors were divided.
    exponents: Vec<i64>,
    /// The number of vectors that may be divided: those along parameters, after them, grow by a force of their own, and
    /// what a method has beside states belongs to the vectors as they are.
    linear: usize,
    /// The number of vectors along parameters.
    #[cfg_attr(not(feature = "checkpoint"), allow(dead_code, reason = "checkpoints alone tell it"))]
    parameters: usize,
    /// The motions before the steps in progress, where there are several that have to stop at one step.
    before: Vec<Box<dyn Motions>>,
    /// The lanes of all runs where they are shown while they stand at the step before.
    between: Option<Vec<Vec<Lane<C>>>>,
}

/// The initial data of a tangent.
pub(crate) struct Beginning<C: Coords> {
    pub(crate) start: Phase<C>,
    pub(crate) vectors: Vec<Phase<C>>,
    /// The number of vectors along parameters: after the others, or, in a resumed run, the last of these.
    pub(crate) parameters: usize,
    pub(crate) h: f64,
    /// The clock, and after how many steps the state was last changed from outside, where it continues from the middle
    /// of the step in progress.
    pub(crate) at: Option<(Clock, u64)>,
}

impl<C: Coords> Tangent<C> {
    pub(crate) fn start<H, X, K>(
        system: &H,
        method: X,
        start: Phase<C>,
        vectors: Vec<Phase<C>>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: System,
        X: Differentiable<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        if vectors.is_empty() {
            return Err(Error::VectorCount { count: 0, most: 2 * start.q.flat().len() });
        }
        let beginning = Beginning { start, vectors, parameters: 0, h, at: None };
        Self::along::<H, X, K, false>(system, method, beginning, |_| Vec::new())
    }

    /// Begins a run along vectors at the start, followed by vectors along this number of parameters; `slopes` gives the
    /// derivatives of prepared constants that belong to some of the vectors.
    pub(crate) fn along<H, X, K, const SENSITIVE: bool>(
        system: &H,
        method: X,
        beginning: Beginning<C>,
        slopes: impl Fn(Range<usize>) -> Vec<H::Parameters<f64>>,
    ) -> Result<Self, Error>
    where
        H: System,
        X: Differentiable<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        refused::<H, K>(&beginning.start)?;
        admissible_with::<H, _>(method, &beginning.start, beginning.h)?;
        check(&beginning.start, &beginning.vectors)?;
        Self::begin::<H, X, K, SENSITIVE>(system, method, beginning, slopes)
    }

    /// Begins a run whose start, vectors and step are checked already.
    pub(crate) fn begin<H, X, K, const SENSITIVE: bool>(
        system: &H,
        method: X,
        beginning: Beginning<C>,
        slopes: impl Fn(Range<usize>) -> Vec<H::Parameters<f64>>,
    ) -> Result<Self, Error>
    where
        H: System,
        X: Differentiable<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        let Beginning { start, mut vectors, parameters, h, at } = beginning;
        let count = if at.is_some() { vectors.len() } else { vectors.len() + parameters };
        let linear = if X::FROM_STATES { count - parameters } else { 0 };
        let together = count > 1 && is_compiled::<H, X, Deviations<TOGETHER, SENSITIVE>>();
        let room = if together { TOGETHER } else { 1 };
        vectors.resize(count.next_multiple_of(room), scaled(&start, 0.0));
        let mut runs = Vec::with_capacity(count.div_ceil(room));
        for (number, vectors) in vectors.chunks(room).enumerate() {
            let carried = (vectors, slopes(number * room..(number + 1) * room));
            runs.push(if room == 1 {
                run::<H, X, K, Deviations<1, SENSITIVE>>(system, method, &start, carried, (h, at))?
            } else {
                run::<H, X, K, Deviations<TOGETHER, SENSITIVE>>(system, method, &start, carried, (h, at))?
            });
        }
        Ok(Self { runs, room, exponents: vec![0; count], linear, parameters, before: Vec::new(), between: None })
    }

    /// Sets the seed of random numbers, like [`Run::with_seed`]. The state and its vectors share these numbers.
    #[must_use]
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.runs = take(&mut self.runs).into_iter().map(|run| run.with_seed(seed)).collect();
        self
    }

    /// Starts the clock at `t0` instead of 0.
    ///
    /// If `t0` is not finite, the first `advance` returns an error.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.runs = take(&mut self.runs).into_iter().map(|run| run.at_time(t0)).collect();
        self
    }

    /// Takes `steps` steps.
    ///
    /// `advance(a)` followed by `advance(b)` is bitwise identical to `advance(a + b)`.
    ///
    /// # Errors
    /// State and vectors stay at the last finite step.
    ///
    /// - Those of [`Run::advance`].
    /// - [`Error::Vector`]: a vector is not finite although the state is, because `H` has no second derivative there.
    ///
    /// # Panics
    /// If your own functions panic. If there are more than four vectors, these may be at different steps afterwards.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let end = self.runs[0].clock.end(steps)?;
        for run in &mut self.runs {
            run.advance(0)?;
        }
        self.between = None;
        while self.steps() < end && self.linear > 0 {
            let next = (self.steps() / BETWEEN_SCALES + 1) * BETWEEN_SCALES;
            self.take_steps_to(next.min(end))?;
            if self.steps() == next {
                self.scale();
            }
        }
        self.take_steps_to(end)
    }

    /// Takes steps up to this number of steps, or as many as all runs can take.
    fn take_steps_to(&mut self, end: u64) -> Result<(), Error> {
        let begin = self.steps();
        if let [run] = &mut self.runs[..] {
            return run.advance(end - begin).map_err(|error| of_vector(run, 0, error));
        }
        self.remember();
        let (mut reached, mut outcome) = (end, Ok(()));
        while let Some((steps, error)) = self.try_steps(reached - begin) {
            (reached, outcome) = (begin + steps, Err(error));
            for (run, before) in self.runs.iter_mut().zip(&self.before) {
                run.go_back(begin, &**before);
            }
            if steps == 0 {
                break;
            }
        }
        outcome
    }

    /// Keeps the motions as they are.
    fn remember(&mut self) {
        if self.before.is_empty() {
            for run in &self.runs {
                self.before.push(copy(&*run.engine.motions, 0..1));
            }
        }
        for (run, before) in self.runs.iter().zip(&mut self.before) {
            before.copy_states(&*run.engine.motions, run.engine.threads);
        }
    }

    /// Takes steps with all runs; how many the first of them that cannot take them all could take, and why.
    fn try_steps(&mut self, steps: u64) -> Option<(u64, Error)> {
        for (number, run) in self.runs.iter_mut().enumerate() {
            let begin = run.steps();
            if let Err(error) = run.advance(steps) {
                return Some((run.steps() - begin, of_vector(run, number * self.room, error)));
            }
        }
        None
    }

    /// Divides vectors by powers of two that are far from one.
    fn scale(&mut self) {
        // Plain loops, as below: they are compiled for every system.
        let (mut exponents, mut is_near) = (Vec::with_capacity(self.linear), true);
        for vector in 0..self.linear {
            let (run, lane) = self.place(vector);
            let exponent = far_exponent(&run.tried_lane(lane));
            is_near &= exponent == 0;
            exponents.push(exponent);
        }
        if is_near {
            return;
        }
        for (sum, exponent) in self.exponents.iter_mut().zip(&exponents) {
            *sum += i64::from(*exponent);
        }
        self.change_vectors(&mut |vectors| {
            for (vector, exponent) in vectors.iter_mut().zip(&exponents) {
                *vector = scaled(vector, power_of_two(-exponent));
            }
        });
    }

    /// Replaces the vectors by a linear map of them. They are seen in the middle of a step, in the coordinates of the
    /// motion, of which vectors at the end of a step are a linear map, too.
    pub(crate) fn change_vectors(&mut self, change: &mut dyn FnMut(&mut [Phase<C>])) {
        let room = self.room;
        let mut vectors = Vec::with_capacity(self.runs.len() * room);
        for run in &self.runs {
            for lane in 1..=room {
                vectors.push(run.unfinished_lane(lane));
            }
        }
        let count = self.exponents.len();
        change(&mut vectors[..count]);
        for (number, run) in self.runs.iter_mut().enumerate() {
            let state = run.unfinished_lane(0);
            run.resume_lanes(&state, &vectors[number * room..(number + 1) * room]);
        }
    }

    /// Replaces the vectors between two steps, and the state if another one is given. The method has no memory.
    pub(crate) fn reopen(&mut self, state: Option<&Phase<C>>, change: &mut dyn FnMut(&mut [Phase<C>])) {
        let room = self.room;
        let mut vectors = Vec::with_capacity(self.runs.len() * room);
        for run in &self.runs {
            for lane in 1..=room {
                vectors.push(run.lane(lane));
            }
        }
        let reached = self.runs[0].state_at_step();
        change(&mut vectors[..self.exponents.len()]);
        for (run, vectors) in self.runs.iter_mut().zip(vectors.chunks(room)) {
            run.reopen_lanes(state.unwrap_or(&reached), vectors);
        }
        (self.before, self.between) = (Vec::new(), None);
    }

    /// The run that a vector goes with, and its lane there.
    fn place(&self, vector: usize) -> (&Run<C>, usize) {
        (&self.runs[vector / self.room], 1 + vector % self.room)
    }

    /// Returns the time, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.runs[0].time()
    }

    /// Returns the step `h`.
    pub fn step(&self) -> f64 {
        self.runs[0].step()
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.runs[0].steps()
    }

    /// Returns the state at [`Tangent::time`], bitwise identical to that of a run without vectors.
    pub fn state(&self) -> Phase<C> {
        self.runs[0].state()
    }

    /// Returns the energy at [`Tangent::time`].
    pub fn energy(&self) -> f64 {
        self.runs[0].energy()
    }

    /// Returns the deviation vectors at [`Tangent::time`], in the order in which they were given.
    ///
    /// Vectors are rescaled by powers of two to avoid overflow. The true vector is the returned one times two to the power
    /// of its [exponent](Tangent::exponents).
    ///
    /// - A vector is rescaled if its largest component leaves the range from 2⁻²⁵⁶ to 2²⁵⁶ (in `f32` from 2⁻³² to 2³²), so
    ///   most exponents are zero.
    /// - Vectors along parameters are never rescaled, nor are those of [`Taylor`](crate::taylor::Taylor) and of methods with
    ///   a fictitious time. They can overflow.
    pub fn vectors(&self) -> Vec<Phase<C>> {
        (0..self.exponents.len()).map(|vector| self.vector(vector)).collect()
    }

    /// Returns the derivative of [`Tangent::time`] along each vector; zero if steps have a fixed length in time.
    ///
    /// For a method with a fictitious time, such as [`Logarithmic`](crate::Logarithmic), a neighbouring orbit reaches another
    /// time in the same number of steps. The vectors compare orbits after equal numbers of steps. Vectors at equal times
    /// differ from these by this multiple of `(∂H/∂p, -∂H/∂q)`.
    pub fn time_slopes(&self) -> Vec<f64> {
        (0..self.exponents.len()).map(|vector| self.time_slope(vector)).collect()
    }

    /// Returns the derivative of the time along a vector.
    pub(crate) fn time_slope(&self, vector: usize) -> f64 {
        let elapsed = match &self.between {
            Some(lanes) => lanes[vector / self.room][1 + vector % self.room].1,
            None => {
                let (run, lane) = self.place(vector);
                run.elapsed_in_lane(lane)
            }
        };
        elapsed.map_or(0.0, |[time, rounding]| time + rounding)
    }

    /// Returns a deviation vector.
    pub(crate) fn vector(&self, vector: usize) -> Phase<C> {
        if let Some(lanes) = &self.between {
            return lanes[vector / self.room][1 + vector % self.room].0.clone();
        }
        let (run, lane) = self.place(vector);
        run.lane(lane)
    }

    /// Returns the state and the first vector at the end of the last step, which are read together.
    #[cfg(feature = "check")]
    pub(crate) fn state_and_first_vector(&self) -> [Phase<C>; 2] {
        self.runs[0].state_and_next_lane()
    }

    /// Returns the first vector in the middle of the current step, in the coordinates of the motion.
    #[cfg(feature = "check")]
    pub(crate) fn unfinished_vector(&self) -> Phase<C> {
        self.runs[0].own_lane(1)
    }

    /// Returns the energy at the end of the last step, for the state there.
    #[cfg(feature = "check")]
    pub(crate) fn energy_of(&self, state: &Phase<C>) -> f64 {
        self.runs[0].parts_of(|| state.clone()).total
    }

    /// Counts the powers of two from here on.
    #[cfg(feature = "check")]
    pub(crate) fn reset_exponents(&mut self) {
        self.exponents.fill(0);
    }

    /// Returns the exponents of the powers of two by which the vectors have to be multiplied.
    pub fn exponents(&self) -> &[i64] {
        &self.exponents
    }
}

impl<C: Coords> Clone for Tangent<C> {
    fn clone(&self) -> Self {
        let exponents = self.exponents.clone();
        let between = self.between.clone();
        Self { runs: self.runs.clone(), exponents, before: Vec::new(), between, ..*self }
    }
}

impl<C: Coords> fmt::Debug for Tangent<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut tangent = f.debug_struct("Tangent");
        tangent.field("run", &self.runs[0]).field("vectors", &self.vectors()).field("exponents", &self.exponents);
        tangent.finish()
    }
}

/// Whether steps of a system in a precision have no derivatives, or derivatives that a state does not determine.
///
/// # Errors
/// [`Error::NoTangent`]
pub(crate) fn refused<H: System, K: Precision>(start: &Phase<Shaped<H, K>>) -> Result<(), Error> {
    if start.q.flat().is_empty() {
        return Err(Error::NoTangent { reason: "the state has no coordinates" });
    }
    if K::REVERSIBLE {
        return Err(Error::NoTangent {
            reason: "a state on a grid moves by multiples of its spacing\nhelp: use `Phase::new`",
        });
    }
    if H::COPIES {
        let reason =
            "`split = symmetric` evolves two copies of the state\nhelp: use `split = none` with `GaussLegendre4`";
        return Err(Error::NoTangent { reason });
    }
    Ok(())
}

/// A run with what it carries: from its start, or from the middle of the current step at a clock.
fn run<H, X, K, V>(
    system: &H,
    method: X,
    start: &Phase<Shaped<H, K>>,
    (vectors, slopes): Behind<'_, Shaped<H, K>, H::Parameters<f64>>,
    (h, at): (f64, Option<(Clock, u64)>),
) -> Result<Run<Shaped<H, K>>, Error>
where
    H: System,
    X: Differentiable<H>,
    K: Precision,
    V: Carried,
{
    let method = &bound::<H, X, K, V>(method);
    let Some((clock, opened)) = at else {
        return Run::carrying::<H, K>(system, method, start.clone(), (vectors, slopes), h);
    };
    let mut run = Run::from_unfinished::<H, K>(system, method, start.clone(), (vectors, slopes), clock, opened)?;
    run.resume_lanes(start, vectors);
    Ok(run)
}

/// Checks that these are deviation vectors at a state.
fn check<C: Coords>(start: &Phase<C>, vectors: &[Phase<C>]) -> Result<(), Error> {
    let positions = start.q.flat().len();
    let (count, most) = (vectors.len(), 2 * positions);
    if count > most {
        return Err(Error::VectorCount { count, most });
    }
    for (number, vector) in vectors.iter().enumerate() {
        let lengths = [vector.q.flat().len(), vector.p.flat().len()];
        let fault = if lengths != [positions; 2] {
            VectorFault::Length { lengths, positions }
        } else if !numbers(vector).all(f64::is_finite) {
            VectorFault::NotFinite
        } else if numbers(vector).all(|number| number == 0.0) {
            VectorFault::Zero
        } else {
            continue;
        };
        return Err(Error::Vector { vector: number, fault });
    }
    Ok(())
}

/// The error of a run that failed: that of a vector, if the state is finite.
fn of_vector<C: Coords>(run: &Run<C>, first: usize, error: Error) -> Error {
    let finite = |lane: usize| numbers(&run.tried_lane(lane)).all(f64::is_finite);
    match error {
        Error::Diverged(divergence) if finite(0) => {
            let lane = (1..=TOGETHER).find(|lane| !finite(*lane)).unwrap_or(1);
            let fault = VectorFault::Lost { step: divergence.step, time: divergence.time };
            Error::Vector { vector: first + lane - 1, fault }
        }
        error => error,
    }
}
