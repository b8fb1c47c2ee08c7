//! Members of an ensemble in the lanes of motions.
//!
//! Always true: the lanes hold the members that are under way, in their order and without a gap; what is left of the
//! last motion repeats the last of them. So whoever is lost or leaves takes its share of the work along.

use crate::{
    clock::Clock,
    coords::Coords,
    energies::{EnergyOf, Parts},
    error::Divergence,
    group::GroupMoves,
    hamiltonian::Motion,
    pack::{Course, Pack, Start},
    panics::Panics,
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
    /// How many steps were done when the states were last changed from outside.
    opened: u64,
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

/// A member that was taken through a block on its own.
struct Replay<L, C> {
    /// How many steps lead to good states.
    taken: u64,
    /// The last of these states.
    last: Phase<C>,
    /// Where the last step led that was tried.
    next: Phase<C>,
    motion: [L; 1],
    /// Whether the next step is not taken because a function of the user panics in it.
    panicked: bool,
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
        let lanes: Vec<_> = (0..members.len()).collect();
        let motions = Self::loaded(&members, &lanes, together.lanes);
        Self {
            first,
            lanes,
            members,
            snapshot: motions.clone(),
            closed: motions.clone(),
            motions,
            together,
            energy,
            opened: 0,
        }
    }

    /// Motions of the members at some places, as their states are.
    fn loaded(members: &[Member<P, Q, C>], places: &[usize], per_motion: usize) -> Vec<L> {
        let load = |places: &[usize]| {
            L::load(&|lane| {
                let member = &members[places[lane.min(places.len() - 1)]];
                (&*member.constants, &member.state)
            })
        };
        places.chunks(per_motion).map(load).collect()
    }

    /// The clock of the motions, which begins where the states were last changed from outside.
    fn since_opened(&self, clock: Clock) -> Clock {
        clock.since(self.opened)
    }

    /// A motion of the members that are in some lanes of these motions, of which there are no more than a motion has.
    fn gathered(&self, motions: &[L], numbers: &[usize]) -> L {
        let of_member = |number: &usize| {
            let (motion, lane) = lane(motions, self.together.lanes, *number);
            (self.lanes[*number], motion, lane)
        };
        self.motion_of(&numbers.iter().map(of_member).collect::<Vec<_>>())
    }

    /// A motion of some members, of which there are no more than a motion has, each with the motion and the lane that it is
    /// in.
    fn motion_of(&self, members: &[(usize, &L, usize)]) -> L {
        let of_lane = |to: usize| {
            let (place, motion, lane) = members[to.min(members.len() - 1)];
            (&*self.members[place].constants, motion, lane)
        };
        let from: Vec<_> = (0..self.together.lanes).map(of_lane).collect();
        L::gathered(&from, &self.members[members[0].0].state)
    }

    /// The state in a lane of these motions, of the shape of `shape`.
    fn in_lane(&self, motions: &[L], number: usize, shape: &Phase<C>) -> Phase<C> {
        let mut state = shape.clone();
        let (motion, lane) = lane(motions, self.together.lanes, number);
        motion.store(lane, &mut state);
        state
    }

    /// The state that is shown of a lane: the end of the step of the kernel, where what undoes the processor leaves the finite
    /// numbers.
    fn shown_in(&self, completed: &[L], shown: Option<&[L]>, number: usize, shape: &Phase<C>) -> Phase<C> {
        let shown = shown.map(|shown| self.in_lane(shown, number, shape)).filter(is_finite);
        shown.unwrap_or_else(|| self.in_lane(completed, number, shape))
    }

    /// Completes the step under way on a copy.
    fn complete(&mut self, clock: Clock) {
        copy_states(&mut self.closed, &self.motions);
        let clock = self.since_opened(clock);
        (self.together.complete)(&mut self.closed, clock);
    }

    /// Takes the members that halted out of the lanes.
    fn close_ranks(&mut self) {
        let is_under_way = |place: &usize| self.members[*place].halted.is_none();
        if self.lanes.iter().all(is_under_way) {
            return;
        }
        let stay: Vec<usize> = (0..self.lanes.len()).filter(|number| is_under_way(&self.lanes[*number])).collect();
        let motions = stay.chunks(self.together.lanes).map(|numbers| self.gathered(&self.motions, numbers)).collect();
        let places = stay.into_iter().map(|number| self.lanes[number]).collect();
        self.set_lanes(places, motions);
    }

    /// Puts the members at some places into the lanes of motions.
    fn set_lanes(&mut self, places: Vec<usize>, motions: Vec<L>) {
        self.lanes = places;
        self.motions = motions;
        self.snapshot.clone_from(&self.motions);
        self.closed.clone_from(&self.motions);
    }

    /// Takes a block of steps with all lanes and completes the last of them on a copy.
    fn advance_lanes(&mut self, clock: Clock, block: u64) {
        copy_states(&mut self.snapshot, &self.motions);
        let since = self.since_opened(clock);
        (self.together.advance)(&mut self.motions, since, block);
        self.complete(Clock { steps: clock.steps + block, ..clock });
    }

    /// The members that are lost in a block from `clock`, whose end is in `closed`.
    fn lost(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        if (self.together.finite)(&self.closed) {
            return Vec::new();
        }
        let mut lost = Vec::new();
        for number in 0..self.lanes.len() {
            let (motion, lane) = lane(&self.closed, self.together.lanes, number);
            let place = self.lanes[number];
            if is_good(motion, lane, &self.in_lane(&self.closed, number, &self.members[place].state)) {
                continue;
            }
            let Replay { taken, last, next, .. } = self.replayed(number, clock, block, panics);
            let at = Clock { steps: clock.steps + taken, ..clock };
            lost.push((self.first + place, at.divergence(&last, &next)));
            self.members[place].state = last;
            self.members[place].halted = Some(at.steps);
        }
        lost
    }

    /// Takes a block of steps in which a function of the user panicked again, from the snapshot, with each member on its own:
    /// those for whom it panics halt before that step. Returns those that are lost.
    fn one_by_one(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        let (mut places, mut motions, mut lost) = (Vec::new(), Vec::new(), Vec::new());
        for number in 0..self.lanes.len() {
            let (place, replay) = (self.lanes[number], self.replayed(number, clock, block, panics));
            if replay.taken == block {
                places.push(place);
                motions.push(replay.motion);
                continue;
            }
            let at = Clock { steps: clock.steps + replay.taken, ..clock };
            if !replay.panicked {
                lost.push((self.first + place, at.divergence(&replay.last, &replay.next)));
            }
            self.members[place].state = replay.last;
            self.members[place].halted = Some(at.steps);
        }
        let under_way: Vec<_> = places.iter().zip(&motions).map(|(place, [motion])| (*place, motion, 0)).collect();
        let motions = under_way.chunks(self.together.lanes).map(|members| self.motion_of(members)).collect();
        self.set_lanes(places, motions);
        self.complete(Clock { steps: clock.steps + block, ..clock });
        lost
    }

    /// Takes a member step by step through a block from `clock`, in all lanes of a motion of its own, from the snapshot to the
    /// last good state. What left the finite numbers never returns, since updates only add.
    fn replayed(&self, number: usize, clock: Clock, block: u64, panics: &Panics) -> Replay<L, C> {
        let mut motion = [self.gathered(&self.snapshot, &[number])];
        let (mut closed, mut last) = (motion.clone(), motion.clone());
        let mut state = self.members[self.lanes[number]].state.clone();
        let begin = self.since_opened(clock);
        let at = |taken| Clock { steps: begin.steps + taken, ..begin };
        let (mut taken, mut panicked) = (0, false);
        while taken < block {
            let step = panics.attempted(|| {
                (self.together.advance)(&mut motion, at(taken), 1);
                copy_states(&mut closed, &motion);
                (self.together.complete)(&mut closed, at(taken + 1));
            });
            panicked = step.is_none();
            closed[0].store(0, &mut state);
            if panicked || !is_good(&closed[0], 0, &state) {
                break;
            }
            copy_states(&mut last, &motion);
            taken += 1;
        }
        (self.together.complete)(&mut last, at(taken));
        let last = self.shown_in(&last, self.together.shown(&last, at(taken)).as_deref(), 0, &state);
        Replay { taken, last, next: state, motion, panicked }
    }

    /// Asks the members that are under way whether they stay; `closed` holds the ends of their steps.
    fn ask(&mut self, course: &Course<C>, clock: Clock) {
        let shown = self.together.shown(&self.closed, self.since_opened(clock));
        for number in 0..self.lanes.len() {
            let place = self.lanes[number];
            if self.members[place].halted.is_some() {
                continue;
            }
            let state = self.shown_in(&self.closed, shown.as_deref(), number, &self.members[place].state);
            if !course.stays(self.first + place, &state) {
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
            done += block;
            lost.extend(match course.panics.attempted(|| self.advance_lanes(before, block)) {
                Some(()) => self.lost(before, block, course.panics),
                None => self.one_by_one(before, block, course.panics),
            });
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
        let (mut closed, clock) = (self.motions.clone(), self.since_opened(clock));
        (self.together.complete)(&mut closed, clock);
        let shown = self.together.shown(&closed, clock);
        let mut states: Vec<_> = self.members.iter().map(|member| member.state.clone()).collect();
        for (number, place) in self.lanes.iter().enumerate() {
            states[*place] = self.shown_in(&closed, shown.as_deref(), number, &states[*place]);
        }
        states
    }

    fn state(&self, member: usize, clock: Clock) -> Phase<C> {
        let place = member - self.first;
        let Ok(number) = self.lanes.binary_search(&place) else {
            return self.members[place].state.clone();
        };
        let per_motion = self.together.lanes;
        let (mut closed, clock) = ([self.motions[number / per_motion].clone()], self.since_opened(clock));
        (self.together.complete)(&mut closed, clock);
        let shown = self.together.shown(&closed, clock);
        self.shown_in(&closed, shown.as_deref(), number % per_motion, &self.members[place].state)
    }

    fn energy(&self, member: usize, state: &Phase<C>, time: f64) -> Parts {
        (self.energy)(&self.members[member - self.first].parameters, state, time)
    }

    fn is_under_way(&self, member: usize) -> bool {
        self.members[member - self.first].halted.is_none()
    }

    fn restart(&mut self, states: Vec<Phase<C>>, steps: u64) {
        for (member, state) in self.members.iter_mut().zip(states).filter(|(member, _)| member.halted.is_none()) {
            member.state = state;
        }
        let motions = Self::loaded(&self.members, &self.lanes, self.together.lanes);
        self.set_lanes(self.lanes.clone(), motions);
        self.opened = steps;
    }
}

/// Whether a lane, whose state this is, may go on.
fn is_good<L: Motion<C, Q>, Q, C: Coords>(motion: &L, lane: usize, state: &Phase<C>) -> bool {
    is_finite(state) && motion.unsolved(lane).is_none()
}

fn is_finite<C: Coords>(state: &Phase<C>) -> bool {
    state.q.flat().iter().chain(state.p.flat()).all(|leaf| leaf.to_f64().is_finite())
}
