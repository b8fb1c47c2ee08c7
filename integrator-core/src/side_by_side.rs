//! Members of an ensemble in the lanes of motions.
//!
//! Always true: the lanes hold the members that are under way, in their order and without a gap; what is left of the
//! last motion repeats the last of them. So whoever is lost or leaves takes its share of the work along.

use crate::{
    coords::Coords,
    energies::{EnergyOf, Parts},
    engine::Clock,
    error::Divergence,
    group::GroupMoves,
    hamiltonian::Motion,
    pack::{Course, Pack, Start},
    phase::Phase,
    slot::Keep,
};
use alloc::sync::Arc;

/// Neighbours that are alike in what lanes have to share.
pub(crate) struct SideBySide<L, P, Q, C> {
    first: usize,
    members: Vec<Member<P, Q, C>>,
    /// The place in `members` of the one in each lane.
    lanes: Vec<usize>,
    motions: Vec<L>,
    /// The motions at the last look; kept here, like the next, so that no block allocates.
    snapshot: Vec<L>,
    /// Where a step is completed to be looked at.
    closed: Vec<L>,
    together: GroupMoves<L>,
    energy: EnergyOf<P, C>,
}

struct Member<P, Q, C> {
    parameters: Arc<P>,
    /// Those of a run by the method.
    constants: Arc<Q>,
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
fn copy_states<L: Motion<C, Q>, Q, C: Coords>(to: &mut [L], from: &[L]) {
    to.iter_mut().zip(from).for_each(|(to, from)| to.copy_state(from));
}

impl<L, P, Q, C> SideBySide<L, P, Q, C>
where
    L: Motion<C, Q>,
    P: Send + Sync + 'static,
    Q: Send + Sync + 'static,
    C: Coords,
{
    pub(crate) fn new(
        first: usize,
        members: Vec<Start<P, Q, C>>,
        together: GroupMoves<L>,
        energy: EnergyOf<P, C>,
    ) -> Self {
        let member = |Start { parameters, constants, state }| Member { parameters, constants, state, halted: None };
        let members: Vec<_> = members.into_iter().map(member).collect();
        let load = |members: &[Member<P, Q, C>]| {
            L::load(|lane| {
                let member = &members[lane.min(members.len() - 1)];
                (&*member.constants, &member.state)
            })
        };
        let motions: Vec<_> = members.chunks(together.lanes).map(load).collect();
        Self {
            first,
            lanes: (0..members.len()).collect(),
            members,
            snapshot: motions.clone(),
            closed: motions.clone(),
            motions,
            together,
            energy,
        }
    }

    /// A motion of the members that are in some lanes of these motions, of which there are no more than a motion has.
    fn gathered(&self, motions: &[L], numbers: &[usize]) -> L {
        let from: Vec<_> = (0..self.together.lanes)
            .map(|to| {
                let number = numbers[to.min(numbers.len() - 1)];
                let (motion, lane) = lane(motions, self.together.lanes, number);
                (&*self.members[self.lanes[number]].constants, motion, lane)
            })
            .collect();
        L::gathered(&from, &self.members[self.lanes[numbers[0]]].state)
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
        let is_under_way = |place: &usize| self.members[*place].halted.is_none();
        if self.lanes.iter().all(is_under_way) {
            return;
        }
        let stay: Vec<usize> = (0..self.lanes.len()).filter(|number| is_under_way(&self.lanes[*number])).collect();
        let motions = stay.chunks(self.together.lanes).map(|numbers| self.gathered(&self.motions, numbers)).collect();
        self.lanes = stay.into_iter().map(|number| self.lanes[number]).collect();
        self.motions = motions;
        self.snapshot.clone_from(&self.motions);
        self.closed.clone_from(&self.motions);
    }

    /// The members that are lost in a block from `clock`, whose end is in `closed`.
    fn lost(&mut self, clock: Clock, block: u64) -> Vec<(usize, Divergence)> {
        if (self.together.finite)(&self.closed) {
            return Vec::new();
        }
        let mut lost = Vec::new();
        for number in 0..self.lanes.len() {
            let (motion, lane) = lane(&self.closed, self.together.lanes, number);
            let place = self.lanes[number];
            if is_good(motion, lane, &self.in_lane(&self.closed, number)) {
                continue;
            }
            let (taken, state) = self.replayed(number, clock, block);
            let at = Clock { steps: clock.steps + taken, ..clock };
            lost.push((self.first + place, at.divergence(&state)));
            self.members[place].state = state;
            self.members[place].halted = Some(at.steps);
        }
        lost
    }

    /// How many steps of a block from `clock` lead a member to good states, and the last of these. What left the finite numbers
    /// never returns, since updates only add; so it goes from the snapshot step by step, in all lanes of a motion of its own.
    fn replayed(&self, number: usize, clock: Clock, block: u64) -> (u64, Phase<C>) {
        let mut motion = [self.gathered(&self.snapshot, &[number])];
        let (mut closed, mut last) = (motion.clone(), self.members[self.lanes[number]].state.clone());
        for taken in 0..=block {
            let at = Clock { steps: clock.steps + taken, ..clock };
            copy_states(&mut closed, &motion);
            (self.together.close)(&mut closed, at);
            let mut state = last.clone();
            closed[0].store(0, &mut state);
            // The block began at a good one.
            if taken > 0 && !is_good(&closed[0], 0, &state) {
                return (taken - 1, last);
            }
            last = state;
            (self.together.advance)(&mut motion, at, 1);
        }
        (block, last)
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

impl<L, P, Q, C> Pack<C> for SideBySide<L, P, Q, C>
where
    L: Motion<C, Q>,
    P: Send + Sync + 'static,
    Q: Send + Sync + 'static,
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

    fn energy(&self, member: usize, clock: Clock) -> Parts {
        let (state, parameters) = (self.state(member, clock), &self.members[member - self.first].parameters);
        (self.energy)(parameters, &state, clock.at(self.steps(member, clock)))
    }
}

/// Whether a lane, whose state this is, may go on.
fn is_good<L: Motion<C, Q>, Q, C: Coords>(motion: &L, lane: usize, state: &Phase<C>) -> bool {
    let finite = state.q.flat().iter().chain(state.p.flat()).all(|leaf| leaf.to_f64().is_finite());
    finite && motion.unsolved(lane).is_none()
}
