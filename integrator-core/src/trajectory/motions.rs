//! Type-erased lists of motions: the single one of a run, or those whose lanes are members of an ensemble.
//!
//! Only what meets the motions themselves is compiled for a system and an instruction set: short loops, since a user
//! pays for each of them. All else is compiled once, in [`engine`](crate::trajectory::engine) and in `ensemble`.

#[cfg(feature = "checkpoint")]
use crate::system::motion::Beside;
use crate::{
    error::Unsolved,
    state::{
        clock::Clock,
        coords::Coords,
        phase::Phase,
        point::{Point, mixed_up, shaped, shaped_mut},
    },
    system::{
        counts::Counts,
        energy::Parts,
        motion::{Found, Motion, Noise},
    },
    trajectory::step_functions::StepFunctions,
};
use alloc::{boxed::Box, sync::Arc, vec, vec::Vec};
use core::{any::Any, marker::PhantomData, ops::Range};

/// A list of motions with their step functions. Lanes are numbered through all of them.
pub(crate) trait Motions: Any + Send + Sync {
    /// The number of lanes of a motion.
    fn lanes(&self) -> usize;
    /// The number of motions in a group, which go through each stage together.
    fn together(&self) -> usize;
    /// The number of motions.
    fn count(&self) -> usize;
    /// An empty list of such motions, with room for this number.
    fn none(&self, room: usize) -> Box<dyn Motions>;
    /// What the random numbers of steps depend on, if steps draw any.
    fn draws(&self) -> Draws;
    /// Sets what the random numbers of motions that are added depend on.
    fn put_draws(&mut self, draws: Draws);
    /// The part of a motion that its random numbers depend on, if its steps draw any.
    fn noise(&mut self, motion: usize) -> Option<&mut Noise>;
    /// Adds a motion of members, one in each lane, from their states in this form.
    fn push(&mut self, lanes: &[(usize, &dyn Point)], form: Form);
    /// Adds a motion of another list at other states of its members, with its constants; `false` if the motion cannot.
    fn push_reloaded(&mut self, from: &dyn Motions, motion: usize, lanes: &[(usize, &dyn Point)]) -> bool;
    /// Adds a motion with members from lanes of others, if their states do not determine it; else adds nothing.
    fn push_gathered(&mut self, lanes: &[Lane]) -> bool;
    /// Copies data that states do not contain to the last motion, from lanes of others.
    fn take_over(&mut self, lanes: &[Lane]);
    /// Adds a copy of a motion of another list.
    fn push_copy(&mut self, from: &dyn Motions, motion: usize);
    /// Copies the states of as many motions with the same constants, in place, on this number of threads or on all.
    fn copy_states(&mut self, from: &dyn Motions, threads: Option<usize>);
    /// Takes this number of steps, on this number of threads or on all.
    fn advance(&mut self, clock: Clock, steps: u64, threads: Option<usize>);
    /// Completes the current step, on this number of threads or on all.
    fn complete(&mut self, clock: Clock, threads: Option<usize>);
    /// Whether the states that are shown at the ends of completed steps differ from these.
    fn shows(&self) -> bool;
    /// Converts the completed states to those that are shown.
    fn show(&mut self, clock: Clock);
    /// Whether all numbers are finite, by this number of threads or by all.
    fn finite(&self, threads: Option<usize>) -> bool;
    /// Writes the state of a lane.
    fn store(&self, lane: usize, to: &mut dyn Point);
    /// Whether energies are computed from motions.
    fn has_energy(&self) -> bool;
    /// The energy of the first motion at the end of a step, if it is computed from the motion.
    fn energy(&self, time: f64) -> Option<Parts>;
    /// Writes the sums of the squares of the positions and the momenta of the vectors after all states, by way of a point
    /// of their shape; `false`, where they are to be had from the lanes alone.
    #[cfg(feature = "check")]
    fn squares(&self, point: &mut dyn Point, squares: &mut [[f64; 2]]) -> bool;
    /// Writes the state of a lane in the coordinates of the motion.
    fn store_own(&self, lane: usize, to: &mut dyn Point);
    /// Takes the motion a while into the step that the other one begins at the clock; `false`, and unchanged, where the
    /// method has no dense output.
    fn dense(&mut self, begin: &dyn Motions, clock: Clock, duration: f64) -> bool;
    /// The fault of a lane, if its steps end because they could not be solved.
    fn unsolved(&self, lane: usize) -> Option<&Unsolved>;
    /// The time of a lane since its motion was loaded, and its rounding error, where it is part of the state.
    fn elapsed(&self, lane: usize) -> Option<[f64; 2]>;
    /// Data of a single trajectory beside its state, where the time is part of it.
    #[cfg(feature = "checkpoint")]
    fn beside(&self) -> Option<Beside>;
    /// Continues with the data that a single trajectory had beside its state.
    #[cfg(feature = "checkpoint")]
    fn put_beside(&mut self, beside: &Beside);
    /// The counters of a single trajectory, if its steps count anything.
    fn counts(&self) -> Option<Counts>;
    /// Data that a single trajectory has found, such as lists of neighbours.
    fn found(&self) -> Option<Found>;
    /// Continues with the data that a single trajectory has found.
    fn use_found(&mut self, found: &Found);
    /// Lets this number of threads share the pairs of many bodies of a single trajectory, or all that the machine has.
    fn share_among(&mut self, threads: Option<usize>);
}

/// What the random numbers of steps depend on.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Draws {
    pub(crate) seed: u64,
    /// The number of the first member, among those of all ranks.
    pub(crate) first: u32,
    /// Whether steps measure the heat that the momenta absorb.
    pub(crate) measures_heat: bool,
}

impl Draws {
    /// Prepares a new motion with these members in its lanes.
    fn begin(self, noise: &mut Noise, lanes: &[(usize, &dyn Point)]) {
        noise.seed = self.seed;
        noise.members.clear();
        noise.members.extend(lanes.iter().map(|(member, _)| self.first + *member as u32));
        noise.heat = self.measures_heat.then(|| vec![0.0; lanes.len()]);
    }
}

/// Sets what random numbers depend on. Where heat is measured, it begins at zero.
pub(crate) fn set_draws(motions: &mut dyn Motions, draws: Draws) {
    let before = motions.draws();
    motions.put_draws(draws);
    for motion in 0..motions.count() {
        let Some(noise) = motions.noise(motion) else { return };
        noise.seed = draws.seed;
        noise.heat = draws.measures_heat.then(|| vec![0.0; noise.members.len()]);
        for member in &mut noise.members {
            *member = *member - before.first + draws.first;
        }
    }
}

/// The coordinates of a state in the middle of the current step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// The user's own, as they were given: no step was taken since.
    Given,
    /// The coordinates of the motion.
    Own,
}

impl Form {
    /// The form of states that were given before the first of this number of steps.
    pub(crate) fn after(steps: u64) -> Self {
        if steps == 0 { Self::Given } else { Self::Own }
    }
}

/// The lane of a member.
#[derive(Clone, Copy)]
pub(crate) struct Lane<'m> {
    pub(crate) member: usize,
    pub(crate) motions: &'m dyn Motions,
    pub(crate) lane: usize,
}

/// Motions of members, from their states, of the same type as some.
pub(crate) fn load(like: &dyn Motions, members: Vec<(usize, &dyn Point)>) -> Box<dyn Motions> {
    load_from(like, Form::Given, members)
}

/// Motions of members, from their states in this form, of the same type as some.
pub(crate) fn load_from(like: &dyn Motions, form: Form, members: Vec<(usize, &dyn Point)>) -> Box<dyn Motions> {
    let mut motions = like.none(members.len().div_ceil(like.lanes()));
    for lanes in filled(members, like.lanes()).chunks(like.lanes()) {
        motions.push(lanes, form);
    }
    motions
}

/// The motions of the same members at other states.
pub(crate) fn reload(from: &dyn Motions, members: Vec<(usize, &dyn Point)>) -> Box<dyn Motions> {
    let mut motions = from.none(from.count());
    for (motion, lanes) in filled(members, from.lanes()).chunks(from.lanes()).enumerate() {
        if !motions.push_reloaded(from, motion, lanes) {
            motions.push(lanes, Form::Given);
        }
    }
    motions
}

/// Motions of the same type as some, with members from lanes of others; a state has the shape of `shape`.
pub(crate) fn gather(like: &dyn Motions, members: Vec<Lane>, shape: &dyn Point) -> Box<dyn Motions> {
    let mut motions = like.none(members.len().div_ceil(like.lanes()));
    for lanes in filled(members, like.lanes()).chunks(like.lanes()) {
        if motions.push_gathered(lanes) {
            continue;
        }
        let mut states: Vec<_> = lanes.iter().map(|_| shape.boxed_clone()).collect();
        for (state, from) in states.iter_mut().zip(lanes) {
            from.motions.store(from.lane, &mut **state);
        }
        let states = lanes.iter().zip(&states);
        motions.push(&states.map(|(from, state)| (from.member, &**state)).collect::<Vec<_>>(), Form::Given);
        motions.take_over(lanes);
    }
    motions
}

/// The contents of lanes, where the last of them is repeated until its motion is full.
fn filled<T: Copy>(mut lanes: Vec<T>, per_motion: usize) -> Vec<T> {
    if let Some(last) = lanes.last() {
        lanes.resize(lanes.len().next_multiple_of(per_motion), *last);
    }
    lanes
}

/// A copy of some motions.
pub(crate) fn copy(from: &dyn Motions, motions: Range<usize>) -> Box<dyn Motions> {
    let mut copies = from.none(motions.len());
    for motion in motions {
        copies.push_copy(from, motion);
    }
    copies
}

impl Clone for Box<dyn Motions> {
    fn clone(&self) -> Self {
        copy(&**self, 0..self.count())
    }
}

/// The states that are shown at the ends of completed steps, where they differ from these.
pub(crate) fn shown(completed: &dyn Motions, clock: Clock) -> Option<Box<dyn Motions>> {
    completed.shows().then(|| {
        let mut shown = copy(completed, 0..completed.count());
        shown.show(clock);
        shown
    })
}

/// Writes the shown state of a lane: the end of the step of the kernel, if the inverse of the processor diverges.
pub(crate) fn show(completed: &dyn Motions, shown: Option<&dyn Motions>, lane: usize, to: &mut dyn Point) {
    if let Some(shown) = shown {
        shown.store(lane, to);
        if to.is_finite() {
            return;
        }
    }
    completed.store(lane, to);
}

/// The time of the state that is shown of a lane, where it is part of the state.
pub(crate) fn elapsed(completed: &dyn Motions, shown: Option<&dyn Motions>, lane: usize) -> Option<[f64; 2]> {
    let of_shown = shown.and_then(|shown| shown.elapsed(lane)).filter(|[time, _]| time.is_finite());
    of_shown.or_else(|| completed.elapsed(lane))
}

/// The constants of a run by the method, of every member.
pub(crate) type Constants<Q> = Arc<Vec<Arc<Q>>>;

/// Motions of one type.
pub(crate) struct Group<L, Q, C> {
    motions: Vec<L>,
    functions: StepFunctions<L>,
    constants: Constants<Q>,
    draws: Draws,
    shape: PhantomData<fn(C)>,
}

impl<L, Q, C> Group<L, Q, C>
where
    L: Motion<C, Q>,
    Q: Send + Sync + 'static,
    C: Coords,
{
    /// An empty list of motions of some of these members, with room for this number.
    pub(crate) fn empty(functions: StepFunctions<L>, constants: Constants<Q>, room: usize) -> Box<dyn Motions> {
        Box::new(Self {
            motions: Vec::with_capacity(room),
            functions,
            constants,
            draws: Draws::default(),
            shape: PhantomData,
        })
    }

    fn of(motions: &dyn Motions) -> &Self {
        match (motions as &dyn Any).downcast_ref() {
            Some(motions) => motions,
            None => mixed_up(),
        }
    }

    /// The motion that a lane is in, and its number there.
    fn motion_of(&self, lane: usize) -> (&L, usize) {
        (&self.motions[lane / self.functions.lanes], lane % self.functions.lanes)
    }
}

/// The constants and the states of the members in the lanes of a motion.
fn filling<'m, Q, C: Coords>(
    of_member: &'m [Arc<Q>],
    lanes: &[(usize, &'m dyn Point)],
) -> (Vec<&'m Q>, Vec<&'m Phase<C>>) {
    let (mut constants, mut states) = (Vec::with_capacity(lanes.len()), Vec::with_capacity(lanes.len()));
    for (member, state) in lanes {
        constants.push(&*of_member[*member]);
        states.push(shaped(*state));
    }
    (constants, states)
}

impl<L, Q, C> Motions for Group<L, Q, C>
where
    L: Motion<C, Q>,
    Q: Send + Sync + 'static,
    C: Coords,
{
    fn lanes(&self) -> usize {
        self.functions.lanes
    }

    fn together(&self) -> usize {
        self.functions.together
    }

    fn count(&self) -> usize {
        self.motions.len()
    }

    fn none(&self, room: usize) -> Box<dyn Motions> {
        let mut none = Self::empty(self.functions, self.constants.clone(), room);
        none.put_draws(self.draws);
        none
    }

    fn draws(&self) -> Draws {
        self.draws
    }

    fn put_draws(&mut self, draws: Draws) {
        self.draws = draws;
    }

    fn noise(&mut self, motion: usize) -> Option<&mut Noise> {
        self.motions[motion].noise()
    }

    fn push(&mut self, lanes: &[(usize, &dyn Point)], form: Form) {
        let (constants, states) = filling(&self.constants, lanes);
        let mut motion = match form {
            Form::Given => L::load(&constants, &states),
            Form::Own => L::load_own(&constants, &states),
        };
        if let Some(noise) = motion.noise() {
            self.draws.begin(noise, lanes);
        }
        self.motions.push(motion);
    }

    fn push_reloaded(&mut self, from: &dyn Motions, motion: usize, lanes: &[(usize, &dyn Point)]) -> bool {
        let (_, states) = filling(&self.constants, lanes);
        let Some(motion) = Self::of(from).motions[motion].reloaded(&states) else { return false };
        self.motions.push(motion);
        true
    }

    fn push_gathered(&mut self, lanes: &[Lane]) -> bool {
        let motion = L::gathered(&|lane| {
            let from = &lanes[lane];
            let (motion, lane) = Self::of(from.motions).motion_of(from.lane);
            (&*self.constants[from.member], motion, lane)
        });
        let Some(motion) = motion else { return false };
        self.motions.push(motion);
        true
    }

    fn take_over(&mut self, lanes: &[Lane]) {
        if const { L::TIMED }
            && let Some(last) = self.motions.last_mut()
        {
            last.take_over(&|lane| {
                let (from, lane) = Self::of(lanes[lane].motions).motion_of(lanes[lane].lane);
                (lane, from)
            });
        }
    }

    fn push_copy(&mut self, from: &dyn Motions, motion: usize) {
        self.motions.push(Self::of(from).motions[motion].clone());
    }

    fn copy_states(&mut self, from: &dyn Motions, threads: Option<usize>) {
        let (from, mut number) = (&Self::of(from).motions, 0);
        while number < from.len() {
            self.motions[number].copy_state_on(&from[number], threads);
            number += 1;
        }
    }

    fn advance(&mut self, clock: Clock, steps: u64, threads: Option<usize>) {
        (self.functions.advance)(&mut self.motions, clock, steps, threads);
    }

    fn complete(&mut self, clock: Clock, threads: Option<usize>) {
        for motion in &mut self.motions {
            (self.functions.complete)(motion, clock, threads);
        }
    }

    fn shows(&self) -> bool {
        self.functions.show.is_some()
    }

    fn show(&mut self, clock: Clock) {
        if let Some(show) = self.functions.show {
            for motion in &mut self.motions {
                show(motion, clock);
            }
        }
    }

    fn finite(&self, threads: Option<usize>) -> bool {
        (self.functions.finite)(&self.motions, threads)
    }

    fn store(&self, lane: usize, to: &mut dyn Point) {
        let (motion, lane) = self.motion_of(lane);
        motion.store(lane, shaped_mut(to));
    }

    fn has_energy(&self) -> bool {
        self.functions.energy.is_some()
    }

    fn energy(&self, time: f64) -> Option<Parts> {
        let energy = self.functions.energy?;
        Some(energy(&self.motions[0], time))
    }

    #[cfg(feature = "check")]
    fn squares(&self, point: &mut dyn Point, squares: &mut [[f64; 2]]) -> bool {
        let Some(write) = self.functions.squares else { return false };
        write(&self.motions, point, squares);
        true
    }

    fn store_own(&self, lane: usize, to: &mut dyn Point) {
        let (motion, lane) = self.motion_of(lane);
        motion.store_own(lane, shaped_mut(to));
    }

    fn dense(&mut self, begin: &dyn Motions, clock: Clock, duration: f64) -> bool {
        let Some(dense) = self.functions.dense else { return false };
        dense(&mut self.motions[0], &Self::of(begin).motions[0], clock, duration);
        true
    }

    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        let (motion, lane) = self.motion_of(lane);
        motion.unsolved(lane)
    }

    fn elapsed(&self, lane: usize) -> Option<[f64; 2]> {
        if !const { L::TIMED } {
            return None;
        }
        let (motion, lane) = self.motion_of(lane);
        motion.elapsed(lane)
    }

    #[cfg(feature = "checkpoint")]
    fn beside(&self) -> Option<Beside> {
        if const { L::TIMED } { self.motions.first()?.beside() } else { None }
    }

    #[cfg(feature = "checkpoint")]
    fn put_beside(&mut self, beside: &Beside) {
        if const { L::TIMED }
            && let Some(motion) = self.motions.first_mut()
        {
            motion.put_beside(beside);
        }
    }

    fn counts(&self) -> Option<Counts> {
        self.motions.first()?.counts()
    }

    fn found(&self) -> Option<Found> {
        self.motions.first()?.found()
    }

    fn use_found(&mut self, found: &Found) {
        if let Some(motion) = self.motions.first_mut() {
            motion.use_found(found);
        }
    }

    fn share_among(&mut self, threads: Option<usize>) {
        if let Some(motion) = self.motions.first_mut() {
            motion.share_among(threads);
        }
    }
}
