//! Motions whose lanes are members of an ensemble, behind one type whatever they are computed in.
//!
//! Only what meets the motions themselves is compiled for a system and an instruction set: short loops, since a user pays
//! for each of them. All else is compiled once, in [`lane_batch`](crate::ensemble::lane_batch).

use crate::{
    ensemble::interleaved::GroupMoves,
    state::{
        clock::Clock,
        coords::Coords,
        phase::Phase,
        point::{Point, mixed_up, shaped, shaped_mut},
    },
    system::motion::Motion,
};
use std::{any::Any, marker::PhantomData, ops::Range, sync::Arc};

/// Motions, and how they go on. Lanes are numbered through all of them.
pub(crate) trait Motions: Any + Send + Sync {
    /// How many lanes a motion has.
    fn lanes(&self) -> usize;
    /// How many motions go together.
    fn together(&self) -> usize;
    /// How many motions there are.
    fn count(&self) -> usize;
    /// No motions of this kind yet, with room for as many.
    fn none(&self, room: usize) -> Box<dyn Motions>;
    /// Adds a motion of members, one in each lane, from their states.
    fn push(&mut self, lanes: &[(usize, &dyn Point)]);
    /// Adds a motion with members from lanes of others, if their states do not tell all of it; else adds nothing.
    fn push_gathered(&mut self, lanes: &[Lane]) -> bool;
    /// Adds one of others once more.
    fn push_copy(&mut self, from: &dyn Motions, motion: usize);
    /// Takes over the states of as many motions with the same constants, in place.
    fn copy_states(&mut self, from: &dyn Motions);
    fn advance(&mut self, clock: Clock, steps: u64);
    /// Completes the step under way.
    fn complete(&mut self, clock: Clock);
    /// Whether the states that are shown at the ends of completed steps differ from these.
    fn shows(&self) -> bool;
    /// Makes these of them.
    fn show(&mut self, clock: Clock);
    /// Whether all numbers are finite.
    fn finite(&self) -> bool;
    /// Writes the state of a lane.
    fn store(&self, lane: usize, to: &mut dyn Point);
    /// Whether the steps in a lane could be solved.
    fn solved(&self, lane: usize) -> bool;
}

/// Where a member is.
#[derive(Clone, Copy)]
pub(crate) struct Lane<'m> {
    pub(crate) member: usize,
    pub(crate) motions: &'m dyn Motions,
    pub(crate) lane: usize,
}

/// Motions of members like some, from the states of the members.
pub(crate) fn loaded(like: &dyn Motions, members: Vec<(usize, &dyn Point)>) -> Box<dyn Motions> {
    let mut motions = like.none(members.len().div_ceil(like.lanes()));
    for lanes in filled(members, like.lanes()).chunks(like.lanes()) {
        motions.push(lanes);
    }
    motions
}

/// Motions like some with members from lanes of others, of the shape of `shape`.
pub(crate) fn gathered(like: &dyn Motions, members: Vec<Lane>, shape: &dyn Point) -> Box<dyn Motions> {
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
        motions.push(&states.map(|(from, state)| (from.member, &**state)).collect::<Vec<_>>());
    }
    motions
}

/// What lanes are filled with, where the last of these takes what it leaves of its motion.
fn filled<T: Copy>(mut lanes: Vec<T>, per_motion: usize) -> Vec<T> {
    if let Some(last) = lanes.last() {
        lanes.resize(lanes.len().next_multiple_of(per_motion), *last);
    }
    lanes
}

/// Some motions once more.
pub(crate) fn copied(from: &dyn Motions, motions: Range<usize>) -> Box<dyn Motions> {
    let mut copies = from.none(motions.len());
    for motion in motions {
        copies.push_copy(from, motion);
    }
    copies
}

/// All motions once more.
pub(crate) fn copy(motions: &dyn Motions) -> Box<dyn Motions> {
    copied(motions, 0..motions.count())
}

/// The states that are shown at the ends of completed steps, where they differ from these.
pub(crate) fn shown(completed: &dyn Motions, clock: Clock) -> Option<Box<dyn Motions>> {
    completed.shows().then(|| {
        let mut shown = copy(completed);
        shown.show(clock);
        shown
    })
}

/// What stays the same of a member.
pub(crate) struct Member<P, Q> {
    pub(crate) parameters: Arc<P>,
    /// Those of a run by the method.
    pub(crate) constants: Arc<Q>,
}

/// All members of an ensemble.
pub(crate) type Everyone<P, Q> = Arc<Vec<Member<P, Q>>>;

/// Motions of one type.
pub(crate) struct Group<L, P, Q, C> {
    motions: Vec<L>,
    moves: GroupMoves<L>,
    members: Everyone<P, Q>,
    shape: PhantomData<fn(C)>,
}

impl<L, P, Q, C> Group<L, P, Q, C>
where
    L: Motion<C, Q>,
    P: Send + Sync + 'static,
    Q: Send + Sync + 'static,
    C: Coords,
{
    /// No motions yet of some of these members, with room for so many.
    pub(crate) fn empty(moves: GroupMoves<L>, members: Everyone<P, Q>, room: usize) -> Box<dyn Motions> {
        Box::new(Self { motions: Vec::with_capacity(room), moves, members, shape: PhantomData })
    }

    fn of(motions: &dyn Motions) -> &Self {
        match (motions as &dyn Any).downcast_ref() {
            Some(motions) => motions,
            None => mixed_up(),
        }
    }

    /// The motion that a lane is in, and its number there.
    fn place(&self, lane: usize) -> (&L, usize) {
        (&self.motions[lane / self.moves.lanes], lane % self.moves.lanes)
    }
}

/// What goes into the lanes of a motion: constants and states.
fn filling<'m, P, Q, C: Coords>(
    members: &'m [Member<P, Q>],
    lanes: &[(usize, &'m dyn Point)],
) -> (Vec<&'m Q>, Vec<&'m Phase<C>>) {
    let (mut constants, mut states) = (Vec::with_capacity(lanes.len()), Vec::with_capacity(lanes.len()));
    for (member, state) in lanes {
        constants.push(&*members[*member].constants);
        states.push(shaped(*state));
    }
    (constants, states)
}

impl<L, P, Q, C> Motions for Group<L, P, Q, C>
where
    L: Motion<C, Q>,
    P: Send + Sync + 'static,
    Q: Send + Sync + 'static,
    C: Coords,
{
    fn lanes(&self) -> usize {
        self.moves.lanes
    }

    fn together(&self) -> usize {
        self.moves.together
    }

    fn count(&self) -> usize {
        self.motions.len()
    }

    fn none(&self, room: usize) -> Box<dyn Motions> {
        Self::empty(self.moves, self.members.clone(), room)
    }

    fn push(&mut self, lanes: &[(usize, &dyn Point)]) {
        let (constants, states) = filling(&self.members, lanes);
        self.motions.push(L::load(&constants, &states));
    }

    fn push_gathered(&mut self, lanes: &[Lane]) -> bool {
        let motion = L::gathered(&|lane| {
            let from = &lanes[lane];
            let (motion, lane) = Self::of(from.motions).place(from.lane);
            (&*self.members[from.member].constants, motion, lane)
        });
        let Some(motion) = motion else { return false };
        self.motions.push(motion);
        true
    }

    fn push_copy(&mut self, from: &dyn Motions, motion: usize) {
        self.motions.push(Self::of(from).motions[motion].clone());
    }

    fn copy_states(&mut self, from: &dyn Motions) {
        let (from, mut number) = (&Self::of(from).motions, 0);
        while number < from.len() {
            self.motions[number].copy_state(&from[number]);
            number += 1;
        }
    }

    fn advance(&mut self, clock: Clock, steps: u64) {
        (self.moves.advance)(&mut self.motions, clock, steps);
    }

    fn complete(&mut self, clock: Clock) {
        (self.moves.complete)(&mut self.motions, clock);
    }

    fn shows(&self) -> bool {
        self.moves.show.is_some()
    }

    fn show(&mut self, clock: Clock) {
        if let Some(show) = self.moves.show {
            show(&mut self.motions, clock);
        }
    }

    fn finite(&self) -> bool {
        (self.moves.finite)(&self.motions)
    }

    fn store(&self, lane: usize, to: &mut dyn Point) {
        let (motion, lane) = self.place(lane);
        motion.store(lane, shaped_mut(to));
    }

    fn solved(&self, lane: usize) -> bool {
        let (motion, lane) = self.place(lane);
        motion.unsolved(lane).is_none()
    }
}
