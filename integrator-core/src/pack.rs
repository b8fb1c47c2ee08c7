//! A part of the members of an ensemble, looked after together.

use crate::{
    clock::Clock,
    coords::Coords,
    energies::{EnergyOf, Parts, energies},
    engine::{BLOCK, Engine, Solo},
    error::Divergence,
    hamiltonian::Motion,
    moves::Moves,
    panics::Panics,
    phase::Phase,
};
use alloc::sync::Arc;

/// How an ensemble is carried on.
pub(crate) struct Course<'a, C> {
    /// From where.
    pub(crate) clock: Clock,
    /// How many steps.
    pub(crate) steps: u64,
    /// After how many steps each member is asked whether it goes on.
    pub(crate) interval: u64,
    /// Whether the member of this number goes on from this state.
    pub(crate) stays: &'a (dyn Fn(usize, &Phase<C>) -> bool + Sync),
    /// Those of the user's functions: whoever is concerned halts at the last step before, and all others go on.
    pub(crate) panics: &'a Panics,
}

impl<C> Course<'_, C> {
    /// How many steps lie between the first `done` ones and the next look at the state.
    pub(crate) fn block(&self, done: u64) -> u64 {
        let to_next_question = self.interval - done % self.interval;
        BLOCK.min(self.steps - done).min(to_next_question)
    }

    /// Whether the members are asked after `done` steps.
    pub(crate) fn asks(&self, done: u64) -> bool {
        done.is_multiple_of(self.interval)
    }

    /// Whether a member goes on from this state; not if the question panics.
    pub(crate) fn stays(&self, member: usize, state: &Phase<C>) -> bool {
        self.panics.attempted(|| (self.stays)(member, state)).unwrap_or(false)
    }

    /// The clock after `done` steps.
    pub(crate) fn at(&self, done: u64) -> Clock {
        Clock { steps: self.clock.steps + done, ..self.clock }
    }
}

/// Members of an ensemble that are carried on together.
pub(crate) trait Pack<C: Coords>: Send + Sync {
    /// The number of the first member.
    fn first(&self) -> usize;
    /// Carries on the members that are under way, tells `took` how many steps the members have done meanwhile, all
    /// together, and returns those that are lost now. A member that is no longer under way counts as if it were.
    fn advance(&mut self, course: &Course<C>, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)>;
    /// How many members are under way.
    fn active(&self) -> usize;
    /// How many steps a member has taken, by its number in the ensemble.
    fn steps(&self, member: usize, clock: Clock) -> u64;
    /// The states of all members.
    fn states(&self, clock: Clock) -> Vec<Phase<C>>;
    /// The state of a member.
    fn state(&self, member: usize, clock: Clock) -> Phase<C>;
    /// The energy of a member in some state.
    fn energy(&self, member: usize, state: &Phase<C>, time: f64) -> Parts;
    /// Whether a member is neither lost nor gone.
    fn is_under_way(&self, member: usize) -> bool;
    /// Lets the members that are under way go on from these states, one for each member, after so many steps.
    fn restart(&mut self, states: Vec<Phase<C>>, steps: u64);
}

/// A member as it starts: the prepared constants of the system, those of a run by the method, and the state.
pub(crate) struct Start<P, Q, C> {
    pub(crate) parameters: Arc<P>,
    pub(crate) constants: Arc<Q>,
    pub(crate) state: Phase<C>,
}

/// A member that shares no lanes.
pub(crate) struct Alone<M, Q, C> {
    number: usize,
    solo: Solo<M, Q, C>,
    /// How many steps it took, once it is no longer under way.
    halted: Option<u64>,
    /// How many steps were done when the state was last changed from outside.
    opened: u64,
}

impl<M: Motion<C, Q>, Q: Send + Sync + 'static, C: Coords> Alone<M, Q, C> {
    pub(crate) fn new<P: Send + Sync + 'static>(
        number: usize,
        Start { parameters, constants, state }: Start<P, Q, C>,
        moves: Moves<M>,
        energy: EnergyOf<P, C>,
    ) -> Self {
        let energies = energies(parameters, energy);
        Self { number, solo: Solo::new(constants, state, moves, energies), halted: None, opened: 0 }
    }

    /// The state after the steps of this clock.
    fn state_at(&self, clock: Clock) -> Phase<C> {
        self.solo.state(clock.since(self.opened))
    }
}

impl<M: Motion<C, Q>, Q: Send + Sync + 'static, C: Coords> Pack<C> for Alone<M, Q, C> {
    fn first(&self) -> usize {
        self.number
    }

    fn advance(&mut self, course: &Course<C>, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)> {
        let (mut done, mut lost) = (0, Vec::new());
        while done < course.steps && self.halted.is_none() {
            let block = course.block(done);
            let mut taken = done;
            let before = course.at(done).since(self.opened);
            let outcome = course.panics.attempted(|| self.solo.advance(before, block, &mut taken));
            let clock = course.at(taken);
            done += block;
            if outcome.is_none() {
                self.halted = Some(clock.steps);
            } else if taken < done {
                lost.push((self.number, clock.divergence(&self.state_at(clock), &self.solo.tried())));
                self.halted = Some(clock.steps);
            } else if course.asks(done) && !course.stays(self.number, &self.state_at(clock)) {
                self.halted = Some(clock.steps);
            }
            took(block);
        }
        took(course.steps - done);
        lost
    }

    fn active(&self) -> usize {
        usize::from(self.halted.is_none())
    }

    fn steps(&self, _member: usize, clock: Clock) -> u64 {
        self.halted.unwrap_or(clock.steps)
    }

    fn states(&self, clock: Clock) -> Vec<Phase<C>> {
        vec![self.state(self.number, clock)]
    }

    fn state(&self, member: usize, clock: Clock) -> Phase<C> {
        self.state_at(Clock { steps: self.steps(member, clock), ..clock })
    }

    fn energy(&self, _member: usize, state: &Phase<C>, time: f64) -> Parts {
        self.solo.energies().parts(state, time)
    }

    fn is_under_way(&self, _member: usize) -> bool {
        self.halted.is_none()
    }

    fn restart(&mut self, states: Vec<Phase<C>>, steps: u64) {
        if let (None, Some(state)) = (self.halted, states.first()) {
            self.solo.restart(state);
            self.opened = steps;
        }
    }
}
