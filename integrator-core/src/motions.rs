//! Motions whose lanes are members of an ensemble, behind one type whatever they are computed in.
//!
//! Only what meets the motions themselves is compiled for a system and an instruction set: short loops, since a user pays
//! for each of them. All else is compiled once, in [`side_by_side`](crate::side_by_side).

use crate::{
    clock::Clock,
    coords::Coords,
    group::GroupMoves,
    hamiltonian::Motion,
    phase::Phase,
    point::{Point, mixed_up, shaped, shaped_mut},
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
    /// Motions of members, one in each lane, from their states; all lanes are filled.
    fn loaded(&self, lanes: &[(usize, &dyn Point)]) -> Box<dyn Motions>;
    /// Motions with members from lanes of others, of the shape of `shape`; all lanes are filled.
    fn gathered(&self, lanes: &[Lane], shape: &dyn Point) -> Box<dyn Motions>;
    /// Some of these motions once more.
    fn copied(&self, motions: Range<usize>) -> Box<dyn Motions>;
    /// Takes over the states of as many motions with the same constants, in place.
    fn copy_states(&mut self, from: &dyn Motions);
    fn advance(&mut self, clock: Clock, steps: u64);
    /// Completes the step under way.
    fn complete(&mut self, clock: Clock);
    /// The states that are shown at the ends of completed steps, where they differ from these.
    fn shown(&self, clock: Clock) -> Option<Box<dyn Motions>>;
    /// Whether all numbers are finite.
    fn finite(&self) -> bool;
    /// Writes the state of a lane.
    fn store(&self, lane: usize, to: &mut dyn Point);
    /// Whether the steps in a lane could be solved.
    fn solved(&self, lane: usize) -> bool;
}

/// The same motions once more.
pub(crate) fn copy(motions: &dyn Motions) -> Box<dyn Motions> {
    motions.copied(0..motions.count())
}

/// Where a member is.
#[derive(Clone, Copy)]
pub(crate) struct Lane<'m> {
    pub(crate) member: usize,
    pub(crate) motions: &'m dyn Motions,
    pub(crate) lane: usize,
}

/// Motions of one type.
pub(crate) struct Group<L, Q, C> {
    motions: Vec<L>,
    moves: GroupMoves<L>,
    /// Those of all members of the ensemble.
    constants: Arc<Vec<Arc<Q>>>,
    shape: PhantomData<fn(C)>,
}

impl<L, Q, C> Group<L, Q, C>
where
    L: Motion<C, Q>,
    Q: Send + Sync + 'static,
    C: Coords,
{
    /// No motions yet, of members with these constants.
    pub(crate) fn empty(moves: GroupMoves<L>, constants: Vec<Arc<Q>>) -> Box<dyn Motions> {
        Self::boxed(Vec::new(), moves, Arc::new(constants))
    }

    fn boxed(motions: Vec<L>, moves: GroupMoves<L>, constants: Arc<Vec<Arc<Q>>>) -> Box<dyn Motions> {
        Box::new(Self { motions, moves, constants, shape: PhantomData })
    }

    fn with(&self, motions: Vec<L>) -> Box<dyn Motions> {
        Self::boxed(motions, self.moves, self.constants.clone())
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

impl<L, Q, C> Motions for Group<L, Q, C>
where
    L: Motion<C, Q>,
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

    fn loaded(&self, lanes: &[(usize, &dyn Point)]) -> Box<dyn Motions> {
        let mut members: Vec<(&Q, &Phase<C>)> = Vec::with_capacity(lanes.len());
        for (member, state) in lanes {
            members.push((&self.constants[*member], shaped(*state)));
        }
        let (mut motions, mut first) = (Vec::new(), 0);
        while first < members.len() {
            motions.push(L::load(&|lane| members[first + lane]));
            first += self.moves.lanes;
        }
        self.with(motions)
    }

    fn gathered(&self, lanes: &[Lane], shape: &dyn Point) -> Box<dyn Motions> {
        let mut members: Vec<(&Q, &L, usize)> = Vec::with_capacity(lanes.len());
        for from in lanes {
            let (motion, lane) = Self::of(from.motions).place(from.lane);
            members.push((&self.constants[from.member], motion, lane));
        }
        let (mut motions, mut first) = (Vec::new(), 0);
        while first < members.len() {
            let next = first + self.moves.lanes;
            motions.push(L::gathered(&members[first..next], shaped(shape)));
            first = next;
        }
        self.with(motions)
    }

    fn copied(&self, motions: Range<usize>) -> Box<dyn Motions> {
        let mut copies = Vec::with_capacity(motions.len());
        for motion in &self.motions[motions] {
            copies.push(motion.clone());
        }
        self.with(copies)
    }

    fn copy_states(&mut self, from: &dyn Motions) {
        let from = Self::of(from);
        for (number, motion) in self.motions.iter_mut().enumerate() {
            motion.copy_state(&from.motions[number]);
        }
    }

    fn advance(&mut self, clock: Clock, steps: u64) {
        (self.moves.advance)(&mut self.motions, clock, steps);
    }

    fn complete(&mut self, clock: Clock) {
        (self.moves.complete)(&mut self.motions, clock);
    }

    fn shown(&self, clock: Clock) -> Option<Box<dyn Motions>> {
        let show = self.moves.show?;
        let mut shown = self.motions.clone();
        show(&mut shown, clock);
        Some(self.with(shown))
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
