//! Members of an ensemble in the lanes of motions.
//!
//! Always true: the lanes hold the members that are under way, in their order and without a gap; what is left of the
//! last motion repeats the last of them. So whoever is lost or leaves takes its share of the work along.

use crate::{
    ensemble::{
        batch::{AdvanceRequest, Batch, States},
        motions::{Lane, Motions, copied, copy, gathered, loaded, shown},
    },
    error::Divergence,
    state::{clock::Clock, point::Point},
    trajectory::panics::Panics,
};
use std::ops::Range;

/// Neighbours that are alike in what lanes have to share.
pub(crate) struct LaneBatch {
    first: usize,
    /// Where each member halted that is no longer under way.
    halted: Vec<Option<Halt>>,
    /// The place in `halted` of the one in each lane.
    lanes: Vec<usize>,
    motions: Box<dyn Motions>,
    /// The motions at the last look; kept here, like the next, so that no block allocates.
    snapshot: Box<dyn Motions>,
    /// Where a step is completed to be looked at.
    closed: Box<dyn Motions>,
    /// Where a state is written to be looked at: any one of the members' shape.
    seen: Box<dyn Point>,
    /// How many steps were done when the states were last changed from outside.
    opened: u64,
}

/// The last state of a member, after so many steps.
struct Halt {
    steps: u64,
    state: Box<dyn Point>,
}

/// A member that was taken through a block on its own.
struct Replay {
    /// How many steps lead to good states.
    taken: u64,
    /// The last of these states.
    last: Box<dyn Point>,
    /// Where the last step led that was tried.
    next: Box<dyn Point>,
    motion: Box<dyn Motions>,
    /// Whether the next step is not taken because a function of the user panics in it.
    panicked: bool,
}

/// Writes the state that is shown of a lane: the end of the step of the kernel, where what undoes the processor leaves the finite
/// numbers.
fn show(completed: &dyn Motions, shown: Option<&dyn Motions>, lane: usize, to: &mut dyn Point) {
    if let Some(shown) = shown {
        shown.store(lane, to);
        if to.is_finite() {
            return;
        }
    }
    completed.store(lane, to);
}

/// Whether a lane may go on, whose state `seen` becomes.
fn is_good(motions: &dyn Motions, lane: usize, seen: &mut dyn Point) -> bool {
    motions.store(lane, seen);
    seen.is_finite() && motions.solved(lane)
}

impl LaneBatch {
    /// Members in lanes like those of some motions, from their states.
    pub(crate) fn new(members: Range<usize>, like: &dyn Motions, states: &States) -> Self {
        let first = members.start;
        let lanes: Vec<_> = (0..members.len()).collect();
        let motions = loaded(like, at(first, &lanes, states));
        Self {
            first,
            halted: members.map(|_| None).collect(),
            lanes,
            snapshot: copy(&*motions),
            closed: copy(&*motions),
            motions,
            seen: states(first).boxed_clone(),
            opened: 0,
        }
    }

    /// The clock of the motions, which begins where the states were last changed from outside.
    fn since_opened(&self, clock: Clock) -> Clock {
        clock.since(self.opened)
    }

    /// Where the member in a lane of these motions is.
    fn lane<'m>(&self, motions: &'m dyn Motions, lane: usize) -> Lane<'m> {
        Lane { member: self.first + self.lanes[lane], motions, lane }
    }

    /// Motions of members from lanes of others.
    fn gathered(&self, lanes: Vec<Lane>) -> Box<dyn Motions> {
        gathered(&*self.motions, lanes, &*self.seen)
    }

    /// Completes the step under way on a copy.
    fn complete(&mut self, clock: Clock) {
        self.closed.copy_states(&*self.motions);
        let clock = self.since_opened(clock);
        self.closed.complete(clock);
    }

    /// Takes the members that halted out of the lanes.
    fn compact_lanes(&mut self) {
        let is_under_way = |place: usize| self.halted[place].is_none();
        if self.lanes.iter().all(|place| is_under_way(*place)) {
            return;
        }
        let stay: Vec<_> = (0..self.lanes.len()).filter(|lane| is_under_way(self.lanes[*lane])).collect();
        let motions = self.gathered(stay.iter().map(|lane| self.lane(&*self.motions, *lane)).collect());
        let places = stay.into_iter().map(|lane| self.lanes[lane]).collect();
        self.set_lanes(places, motions);
    }

    /// Puts the members at some places into the lanes of motions.
    fn set_lanes(&mut self, places: Vec<usize>, motions: Box<dyn Motions>) {
        self.lanes = places;
        self.snapshot = copy(&*motions);
        self.closed = copy(&*motions);
        self.motions = motions;
    }

    /// Takes a block of steps with all lanes and completes the last of them on a copy.
    fn advance_lanes(&mut self, clock: Clock, block: u64) {
        self.snapshot.copy_states(&*self.motions);
        let since = self.since_opened(clock);
        self.motions.advance(since, block);
        self.complete(Clock { steps: clock.steps + block, ..clock });
    }

    /// Lets the member at a place halt.
    fn halt(&mut self, place: usize, steps: u64, state: Box<dyn Point>) {
        self.halted[place] = Some(Halt { steps, state });
    }

    /// The members that are lost in a block from `clock`, whose end is in `closed`.
    fn lost(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        let mut lost = Vec::new();
        if self.closed.finite() {
            return lost;
        }
        for lane in 0..self.lanes.len() {
            if is_good(&*self.closed, lane, &mut *self.seen) {
                continue;
            }
            let place = self.lanes[lane];
            let Replay { taken, last, next, .. } = self.replayed(lane, clock, block, panics);
            let at = Clock { steps: clock.steps + taken, ..clock };
            lost.push((self.first + place, last.divergence(&*next, at)));
            self.halt(place, at.steps, last);
        }
        lost
    }

    /// Takes a block of steps in which a function of the user panicked again, from the snapshot, with each member on its own:
    /// those for whom it panics halt before that step. Returns those that are lost.
    fn one_by_one(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        let (mut places, mut motions, mut lost) = (Vec::new(), Vec::new(), Vec::new());
        for lane in 0..self.lanes.len() {
            let (place, replay) = (self.lanes[lane], self.replayed(lane, clock, block, panics));
            if replay.taken == block {
                places.push(place);
                motions.push(replay.motion);
                continue;
            }
            let at = Clock { steps: clock.steps + replay.taken, ..clock };
            if !replay.panicked {
                lost.push((self.first + place, replay.last.divergence(&*replay.next, at)));
            }
            self.halt(place, at.steps, replay.last);
        }
        let under_way = places.iter().zip(&motions);
        let lanes = under_way.map(|(place, motion)| Lane { member: self.first + place, motions: &**motion, lane: 0 });
        let motions = self.gathered(lanes.collect());
        self.set_lanes(places, motions);
        self.complete(Clock { steps: clock.steps + block, ..clock });
        lost
    }

    /// Takes a member step by step through a block from `clock`, in all lanes of a motion of its own, from the snapshot to the
    /// last good state. What left the finite numbers never returns, since updates only add.
    fn replayed(&self, lane: usize, clock: Clock, block: u64, panics: &Panics) -> Replay {
        let mut motion = self.gathered(vec![self.lane(&*self.snapshot, lane)]);
        let (mut closed, mut before) = (copy(&*motion), copy(&*motion));
        let (mut next, mut last) = (self.seen.boxed_clone(), self.seen.boxed_clone());
        let begin = self.since_opened(clock);
        let at = |taken| Clock { steps: begin.steps + taken, ..begin };
        let (mut taken, mut panicked) = (0, false);
        while taken < block {
            let step = panics.attempted(|| {
                motion.advance(at(taken), 1);
                closed.copy_states(&*motion);
                closed.complete(at(taken + 1));
            });
            panicked = step.is_none();
            if !is_good(&*closed, 0, &mut *next) || panicked {
                break;
            }
            before.copy_states(&*motion);
            taken += 1;
        }
        before.complete(at(taken));
        show(&*before, shown(&*before, at(taken)).as_deref(), 0, &mut *last);
        Replay { taken, last, next, motion, panicked }
    }

    /// Asks the members that are under way whether they stay; `closed` holds the ends of their steps.
    fn ask(&mut self, request: &AdvanceRequest, clock: Clock) {
        let shown = shown(&*self.closed, self.since_opened(clock));
        for lane in 0..self.lanes.len() {
            let place = self.lanes[lane];
            if self.halted[place].is_some() {
                continue;
            }
            show(&*self.closed, shown.as_deref(), lane, &mut *self.seen);
            if !request.stays(self.first + place, &*self.seen) {
                self.halt(place, clock.steps, self.seen.boxed_clone());
            }
        }
    }
}

/// The members at some places behind the first one, with their states.
fn at<'s>(first: usize, places: &[usize], states: &States<'s>) -> Vec<(usize, &'s dyn Point)> {
    places.iter().map(|place| (first + place, states(first + place))).collect()
}

impl Batch for LaneBatch {
    fn first(&self) -> usize {
        self.first
    }

    fn advance(&mut self, request: &AdvanceRequest, took: &mut dyn FnMut(u64)) -> Vec<(usize, Divergence)> {
        let (mut done, mut lost) = (0, Vec::new());
        let all = self.halted.len() as u64;
        while done < request.steps && !self.lanes.is_empty() {
            let block = request.block(done);
            let before = request.at(done);
            done += block;
            lost.extend(match request.panics.attempted(|| self.advance_lanes(before, block)) {
                Some(()) => self.lost(before, block, request.panics),
                None => self.one_by_one(before, block, request.panics),
            });
            if request.asks(done) {
                self.ask(request, request.at(done));
            }
            self.compact_lanes();
            took(block * all);
        }
        took((request.steps - done) * all);
        lost
    }

    fn active(&self) -> usize {
        self.lanes.len()
    }

    fn steps(&self, member: usize, clock: Clock) -> u64 {
        self.halted[member - self.first].as_ref().map_or(clock.steps, |halt| halt.steps)
    }

    fn states(&self, clock: Clock, visit: &mut dyn FnMut(usize, &dyn Point)) {
        let (mut closed, clock) = (copy(&*self.motions), self.since_opened(clock));
        closed.complete(clock);
        let shown = shown(&*closed, clock);
        let mut seen = self.seen.boxed_clone();
        // Those who are under way are in the lanes, in their order.
        let mut lane = 0;
        for (member, halted) in (self.first..).zip(&self.halted) {
            if let Some(halt) = halted {
                visit(member, &*halt.state);
                continue;
            }
            show(&*closed, shown.as_deref(), lane, &mut *seen);
            visit(member, &*seen);
            lane += 1;
        }
    }

    fn state(&self, member: usize, clock: Clock) -> Box<dyn Point> {
        let place = member - self.first;
        if let Some(halt) = &self.halted[place] {
            return halt.state.boxed_clone();
        }
        // Those before it that are under way are in the lanes before.
        let lane = self.lanes.partition_point(|other| *other < place);
        let (motion, lane) = (lane / self.motions.lanes(), lane % self.motions.lanes());
        let (mut closed, clock) = (copied(&*self.motions, motion..motion + 1), self.since_opened(clock));
        closed.complete(clock);
        let mut state = self.seen.boxed_clone();
        show(&*closed, shown(&*closed, clock).as_deref(), lane, &mut *state);
        state
    }

    fn is_under_way(&self, member: usize) -> bool {
        self.halted[member - self.first].is_none()
    }

    fn restart(&mut self, states: &States, steps: u64) {
        // The copies take over what they need of these before they are looked at.
        self.motions = loaded(&*self.motions, at(self.first, &self.lanes, states));
        self.opened = steps;
    }
}
