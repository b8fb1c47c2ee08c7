//! A part of the members of an ensemble, looked after together.

use crate::{
    error::Divergence,
    state::{
        clock::Clock,
        coords::Coords,
        point::{Point, shaped, shaped_mut},
    },
    trajectory::{
        engine::{BLOCK, Engine},
        panics::Panics,
    },
};

/// The state that each member has by its number in the ensemble.
pub(crate) type States<'s> = dyn (Fn(usize) -> &'s dyn Point) + 's;

/// How an ensemble is carried on.
pub(crate) struct AdvanceRequest<'a> {
    /// From where.
    pub(crate) clock: Clock,
    /// How many steps.
    pub(crate) steps: u64,
    /// After how many steps each member is asked whether it goes on.
    pub(crate) interval: u64,
    /// Whether the member of this number goes on from this state.
    pub(crate) stays: &'a (dyn Fn(usize, &dyn Point) -> bool + Sync),
    /// Those of the user's functions: whoever is concerned halts at the last step before, and all others go on.
    pub(crate) panics: &'a Panics,
}

impl AdvanceRequest<'_> {
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
    pub(crate) fn stays(&self, member: usize, state: &dyn Point) -> bool {
        self.panics.attempted(|| (self.stays)(member, state)).unwrap_or(false)
    }

    /// The clock after `done` steps.
    pub(crate) fn at(&self, done: u64) -> Clock {
        Clock { steps: self.clock.steps + done, ..self.clock }
    }
}

/// Members of an ensemble that are carried on together.
pub(crate) trait Batch: Send + Sync {
    /// The number of the first member.
    fn first(&self) -> usize;
    /// Carries on the members that are under way, tells `took` how many steps the members have done meanwhile, all
    /// together, and returns those that are lost now. A member that is no longer under way counts as if it were.
    fn advance(&mut self, request: &AdvanceRequest, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)>;
    /// How many members are under way.
    fn active(&self) -> usize;
    /// How many steps a member has taken, by its number in the ensemble.
    fn steps(&self, member: usize, clock: Clock) -> u64;
    /// Shows the states of all members, in their order.
    fn states(&self, clock: Clock, visit: &mut dyn FnMut(usize, &dyn Point));
    /// The state of a member.
    fn state(&self, member: usize, clock: Clock) -> Box<dyn Point>;
    /// Whether a member is neither lost nor gone.
    fn is_under_way(&self, member: usize) -> bool;
    /// Lets the members that are under way go on from these states after so many steps.
    fn restart(&mut self, states: &States, steps: u64);
}

/// The engine of a member, whatever its shape.
pub(crate) trait Lone: Send + Sync {
    /// As [`Engine::advance`].
    fn advance(&mut self, clock: Clock, steps: u64, taken: &mut u64);
    /// Writes the state.
    fn state(&self, clock: Clock, to: &mut dyn Point);
    /// Writes where the last step led that was tried.
    fn tried(&self, to: &mut dyn Point);
    fn restart(&mut self, state: &dyn Point);
}

impl<C: Coords> Lone for Box<dyn Engine<C>> {
    fn advance(&mut self, clock: Clock, steps: u64, taken: &mut u64) {
        self.as_mut().advance(clock, steps, taken);
    }

    fn state(&self, clock: Clock, to: &mut dyn Point) {
        *shaped_mut(to) = self.as_ref().state(clock);
    }

    fn tried(&self, to: &mut dyn Point) {
        *shaped_mut(to) = self.as_ref().tried();
    }

    fn restart(&mut self, state: &dyn Point) {
        self.as_mut().restart(shaped(state));
    }
}

/// A member that shares no lanes.
pub(crate) struct LoneMember {
    number: usize,
    engine: Box<dyn Lone>,
    /// Where a state is written to be looked at: any one of the member's shape.
    seen: Box<dyn Point>,
    /// How many steps it took, once it is no longer under way.
    halted: Option<u64>,
    /// How many steps were done when the state was last changed from outside.
    opened: u64,
}

impl LoneMember {
    pub(crate) fn new(number: usize, engine: Box<dyn Lone>, start: &dyn Point) -> Self {
        Self { number, engine, seen: start.boxed_clone(), halted: None, opened: 0 }
    }

    /// Whether the member goes on from where it is.
    fn stays(&mut self, request: &AdvanceRequest, clock: Clock) -> bool {
        self.engine.state(clock.since(self.opened), &mut *self.seen);
        request.stays(self.number, &*self.seen)
    }
}

impl Batch for LoneMember {
    fn first(&self) -> usize {
        self.number
    }

    fn advance(&mut self, request: &AdvanceRequest, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)> {
        let (mut done, mut lost) = (0, Vec::new());
        while done < request.steps && self.halted.is_none() {
            let block = request.block(done);
            let mut taken = done;
            let before = request.at(done).since(self.opened);
            let outcome = request.panics.attempted(|| self.engine.advance(before, block, &mut taken));
            let clock = request.at(taken);
            done += block;
            if outcome.is_none() {
                self.halted = Some(clock.steps);
            } else if taken < done {
                self.engine.tried(&mut *self.seen);
                lost.push((self.number, self.state(self.number, clock).divergence(&*self.seen, clock)));
                self.halted = Some(clock.steps);
            } else if request.asks(done) && !self.stays(request, clock) {
                self.halted = Some(clock.steps);
            }
            took(block);
        }
        took(request.steps - done);
        lost
    }

    fn active(&self) -> usize {
        usize::from(self.halted.is_none())
    }

    fn steps(&self, _member: usize, clock: Clock) -> u64 {
        self.halted.unwrap_or(clock.steps)
    }

    fn states(&self, clock: Clock, visit: &mut dyn FnMut(usize, &dyn Point)) {
        visit(self.number, &*self.state(self.number, clock));
    }

    fn state(&self, member: usize, clock: Clock) -> Box<dyn Point> {
        let clock = Clock { steps: self.steps(member, clock), ..clock };
        let mut state = self.seen.boxed_clone();
        self.engine.state(clock.since(self.opened), &mut *state);
        state
    }

    fn is_under_way(&self, _member: usize) -> bool {
        self.halted.is_none()
    }

    fn restart(&mut self, states: &States, steps: u64) {
        if self.halted.is_none() {
            self.engine.restart(states(self.number));
            self.opened = steps;
        }
    }
}
