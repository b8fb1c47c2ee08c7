//! Members of an ensemble in the lanes of motions.
//!
//! Always true: the lanes hold the members that are under way, in their order and without a gap; what is left of the
//! last motion repeats the last of them. So whoever is lost or leaves takes its share of the work along.

use crate::{
    coords::Coords,
    energies::{EnergyOf, energies},
    engine::{Clock, Engine, Moves, Solo},
    error::Divergence,
    group::GroupMoves,
    hamiltonian::Motion,
    pack::{Course, Pack, Start},
    phase::Phase,
    slot::Keep,
};
use alloc::sync::Arc;

/// Neighbours that are alike in what lanes have to share.
pub(crate) struct SideBySide<L, M, P, C> {
    first: usize,
    members: Vec<Member<P, C>>,
    /// The place in `members` of the one in each lane.
    lanes: Vec<usize>,
    motions: Vec<L>,
    /// The motions at the last look; kept here, like the next, so that no block allocates.
    snapshot: Vec<L>,
    /// Where a step is completed to be looked at.
    closed: Vec<L>,
    together: GroupMoves<L>,
    alone: Moves<M>,
    energy: EnergyOf<P, C>,
}

struct Member<P, C> {
    parameters: P,
    /// The state where the member halted; before, any state of the same shape.
    state: Phase<C>,
    /// How many steps it took, once it is no longer under way.
    halted: Option<u64>,
}

/// The motion and the lane in it that are the lane of this number.
fn lane<L>(motions: &[L], per_motion: usize, lane: usize) -> (&L, usize) {
    (&motions[lane / per_motion], lane % per_motion)
}

/// The states of motions with the same constants.
fn copy_states<L: Motion<C, P>, P, C: Coords>(to: &mut [L], from: &[L]) {
    to.iter_mut().zip(from).for_each(|(to, from)| to.copy_state(from));
}

impl<L, M, P, C> SideBySide<L, M, P, C>
where
    L: Motion<C, P>,
    M: Motion<C, P>,
    P: Clone + Send + Sync + 'static,
    C: Coords,
{
    pub(crate) fn new(
        first: usize,
        members: Vec<Start<P, C>>,
        together: GroupMoves<L>,
        alone: Moves<M>,
        energy: EnergyOf<P, C>,
    ) -> Self {
        let member = |(parameters, state)| Member { parameters, state, halted: None };
        let members: Vec<_> = members.into_iter().map(member).collect();
        let mut pack = Self {
            first,
            lanes: (0..members.len()).collect(),
            members,
            motions: Vec::new(),
            snapshot: Vec::new(),
            closed: Vec::new(),
            together,
            alone,
            energy,
        };
        pack.line_up();
        pack
    }

    /// Fills the lanes with the states of their members, which may be in the middle of a step.
    fn line_up(&mut self) {
        let in_lane = |place: &usize| (&self.members[*place].parameters, &self.members[*place].state);
        self.motions = (self.lanes.chunks(self.together.lanes))
            .map(|places| L::load(|lane| in_lane(&places[lane.min(places.len() - 1)])))
            .collect();
        self.snapshot.clone_from(&self.motions);
        self.closed.clone_from(&self.motions);
    }

    /// The state in a lane of these motions.
    fn in_lane(&self, motions: &[L], number: usize) -> Phase<C> {
        let mut state = self.members[self.lanes[number]].state.clone();
        let (motion, lane) = lane(motions, self.together.lanes, number);
        motion.store(lane, &mut state);
        state
    }

    /// Completes the step under way on a copy.
    fn close(&mut self, clock: Clock) {
        copy_states(&mut self.closed, &self.motions);
        (self.together.close)(&mut self.closed, clock);
    }

    /// Takes the members that halted out of the lanes.
    fn close_ranks(&mut self) {
        if self.lanes.iter().all(|place| self.members[*place].halted.is_none()) {
            return;
        }
        for number in 0..self.lanes.len() {
            let place = self.lanes[number];
            if self.members[place].halted.is_none() {
                self.members[place].state = self.in_lane(&self.motions, number);
            }
        }
        self.lanes.retain(|place| self.members[*place].halted.is_none());
        self.line_up();
    }

    /// The members that are not finite after a block from `clock`, whose end is in `closed`. What left the finite numbers never returns, since
    /// updates only add; so each of them runs alone from the snapshot, to its last finite state.
    fn lost(&mut self, clock: Clock, block: u64) -> Vec<(usize, Divergence)> {
        if (self.together.finite)(&self.closed) {
            return Vec::new();
        }
        let mut lost = Vec::new();
        for number in 0..self.lanes.len() {
            if is_finite(&self.in_lane(&self.closed, number)) {
                continue;
            }
            let (place, state) = (self.lanes[number], self.in_lane(&self.snapshot, number));
            let member = &mut self.members[place];
            let parameters = Arc::new(member.parameters.clone());
            let energies = energies(parameters.clone(), self.energy);
            let mut solo = Solo::<M, P, C>::new(parameters, state, self.alone, energies);
            let taken = solo.advance(clock, block);
            let at = Clock { steps: clock.steps + taken, ..clock };
            member.state = solo.state(at);
            member.halted = Some(at.steps);
            lost.push((self.first + place, at.divergence(&member.state)));
        }
        lost
    }

    /// Asks the members that are under way whether they stay; `closed` holds their states.
    fn ask(&mut self, course: &Course<C>, clock: Clock) {
        for number in 0..self.lanes.len() {
            let place = self.lanes[number];
            if self.members[place].halted.is_some() {
                continue;
            }
            let state = self.in_lane(&self.closed, number);
            if !(course.stays)(self.first + place, &state) {
                self.members[place].state = state;
                self.members[place].halted = Some(clock.steps);
            }
        }
    }
}

impl<L, M, P, C> Pack<C> for SideBySide<L, M, P, C>
where
    L: Motion<C, P>,
    M: Motion<C, P>,
    P: Clone + Send + Sync + 'static,
    C: Coords,
{
    fn first(&self) -> usize {
        self.first
    }

    fn advance(&mut self, course: &Course<C>, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)> {
        let (mut done, mut lost) = (0, Vec::new());
        let all = self.members.len() as u64;
        while done < course.steps && !self.lanes.is_empty() {
            let block = course.block(done);
            let before = course.at(done);
            copy_states(&mut self.snapshot, &self.motions);
            (self.together.advance)(&mut self.motions, before, block);
            done += block;
            self.close(course.at(done));
            lost.extend(self.lost(before, block));
            if course.asks(done) {
                self.ask(course, course.at(done));
            }
            self.close_ranks();
            took(block * all);
        }
        took((course.steps - done) * all);
        lost
    }

    fn active(&self) -> usize {
        self.lanes.len()
    }

    fn steps(&self, member: usize, clock: Clock) -> u64 {
        self.members[member - self.first].halted.unwrap_or(clock.steps)
    }

    fn states(&self, clock: Clock) -> Vec<Phase<C>> {
        let mut closed = self.motions.clone();
        (self.together.close)(&mut closed, clock);
        let mut states: Vec<_> = self.members.iter().map(|member| member.state.clone()).collect();
        for (number, place) in self.lanes.iter().enumerate() {
            states[*place] = self.in_lane(&closed, number);
        }
        states
    }

    fn state(&self, member: usize, clock: Clock) -> Phase<C> {
        let place = member - self.first;
        let Ok(number) = self.lanes.binary_search(&place) else {
            return self.members[place].state.clone();
        };
        let (motion, lane) = lane(&self.motions, self.together.lanes, number);
        let mut motion = motion.clone();
        (self.together.close)(core::slice::from_mut(&mut motion), clock);
        let mut state = self.members[place].state.clone();
        motion.store(lane, &mut state);
        state
    }

    fn energy(&self, member: usize, clock: Clock) -> f64 {
        let (state, parameters) = (self.state(member, clock), &self.members[member - self.first].parameters);
        (self.energy)(parameters, &state, clock.at(self.steps(member, clock)))
    }
}

fn is_finite<C: Coords>(state: &Phase<C>) -> bool {
    state.q.flat().iter().chain(state.p.flat()).all(|leaf| leaf.to_f64().is_finite())
}
