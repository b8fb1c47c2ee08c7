//! A batch: neighbouring members of an ensemble in the lanes of motions.
//!
//! Always true: the lanes hold the members that are in progress, in their order and without a gap; what remains of the
//! last motion repeats the last of them. So the work of a member ends when it diverges or leaves.

#[cfg(feature = "checkpoint")]
use crate::trajectory::motions::{Form, load_from};
use crate::{
    ensemble::request::{AdvanceRequest, Ended},
    error::{Divergence, Error},
    state::{
        clock::{Clock, durations, time_after},
        point::Point,
    },
    trajectory::{
        engine::Engine,
        motions::{Draws, Lane, Motions, copy, elapsed, gather, load, show, shown},
        panics::Panics,
    },
};
use std::ops::Range;

/// The end of a failed or finished member.
#[cfg(feature = "checkpoint")]
#[derive(Clone, Copy, Debug, serde::Serialize, serde::Deserialize)]
pub(crate) struct Finished {
    /// The number of steps that the member has taken.
    pub(crate) steps: u64,
    /// The time at its last step.
    pub(crate) time: f64,
}

/// The states of members, by their numbers in the ensemble.
pub(crate) type States<'s> = dyn (Fn(usize) -> &'s dyn Point) + 's;

/// A batch: members that are alike in what lanes have to share, or one alone.
#[derive(Clone)]
pub(crate) struct Batch {
    first: usize,
    /// The last states of the members that are no longer in progress.
    finished: Vec<Option<Finish>>,
    /// The index in `finished` of the member in each lane.
    lanes: Vec<usize>,
    engine: Engine,
    /// A buffer for the state of a member.
    sample: Box<dyn Point>,
    /// The number of steps done when the states were last changed from outside.
    opened: u64,
    /// The times of the members at that change, where these are part of their states: sums of two numbers.
    opened_at: Vec<[f64; 2]>,
}

/// The last state of a member, the number of steps that led there, and when that was.
#[derive(Clone)]
pub(crate) struct Finish {
    pub(crate) steps: u64,
    pub(crate) time: f64,
    pub(crate) state: Box<dyn Point>,
}

/// A member alone, from where it is on.
pub(crate) struct Alone {
    pub(crate) engine: Engine,
    /// The number of steps done when the state was last changed from outside.
    pub(crate) opened: u64,
    /// The member's time at that change, where that is part of its state.
    pub(crate) opened_at: [f64; 2],
}

/// The replay of a block of steps with one member.
struct Replay {
    /// The number of steps that lead to finite states.
    taken: u64,
    /// The member's engine after these steps.
    engine: Engine,
    /// Whether the next step is not taken because a function of the user panics in it.
    panicked: bool,
}

/// Whether the state of a lane, which is written to `sample`, is finite, and its steps could be solved.
fn is_valid(motions: &dyn Motions, lane: usize, sample: &mut dyn Point) -> bool {
    motions.store(lane, sample);
    sample.is_finite() && motions.unsolved(lane).is_none()
}

impl Batch {
    /// Members in lanes like those of some motions, from their states.
    pub(crate) fn new(members: Range<usize>, like: &dyn Motions, states: &States) -> Self {
        let first = members.start;
        let lanes: Vec<_> = (0..members.len()).collect();
        let motions = load(like, with_states(first, &lanes, states));
        Self {
            first,
            finished: members.clone().map(|_| None).collect(),
            lanes,
            engine: Engine::new(motions),
            sample: states(first).boxed_clone(),
            opened: 0,
            opened_at: vec![[0.0; 2]; members.len()],
        }
    }

    /// Changes what random numbers depend on.
    pub(super) fn change_draws(&mut self, change: &dyn Fn(&mut Draws)) {
        self.engine.change_draws(change);
    }

    /// The seed of random numbers.
    #[cfg(feature = "checkpoint")]
    pub(super) fn seed(&self) -> u64 {
        self.engine.motions.draws().seed
    }

    /// The clock of the motions, which begins where the states were last changed from outside.
    fn since_opened(&self, clock: Clock) -> Clock {
        clock.since(self.opened)
    }

    /// The time of a member after this number of steps, or by its own time.
    fn time(&self, index: usize, clock: Clock, elapsed: Option<[f64; 2]>) -> f64 {
        match elapsed {
            Some(elapsed) => time_after(clock.t0, durations(self.opened_at[index], elapsed)),
            None => clock.at(clock.steps),
        }
    }

    /// Returns the lane of the member in a lane of these motions.
    fn lane<'m>(&self, motions: &'m dyn Motions, lane: usize) -> Lane<'m> {
        Lane { member: self.first + self.lanes[lane], motions, lane }
    }

    /// Motions of members from lanes of others.
    fn gather(&self, lanes: Vec<Lane>) -> Box<dyn Motions> {
        gather(&*self.engine.motions, lanes, &*self.sample)
    }

    /// Takes the members that finished out of the lanes.
    fn compact_lanes(&mut self) {
        let is_under_way = |index: usize| self.finished[index].is_none();
        if self.lanes.iter().all(|index| is_under_way(*index)) {
            return;
        }
        let stay: Vec<_> = (0..self.lanes.len()).filter(|lane| is_under_way(self.lanes[*lane])).collect();
        let motions = self.gather(stay.iter().map(|lane| self.lane(&*self.engine.motions, *lane)).collect());
        self.lanes = stay.into_iter().map(|lane| self.lanes[lane]).collect();
        self.engine = Engine::new(motions);
    }

    /// Finishes a member whose replay of a block from `clock` ended early, and returns its divergence unless a function
    /// of the user panicked.
    fn finish(&mut self, index: usize, clock: Clock, replay: &Replay) -> Option<(usize, Divergence)> {
        let clock = Clock { steps: clock.steps + replay.taken, ..clock };
        let mut state = self.sample.boxed_clone();
        replay.engine.lane(self.since_opened(clock), 0, &mut *state);
        replay.engine.completed.store(0, &mut *self.sample);
        let elapsed = replay.engine.elapsed(self.since_opened(clock), 0);
        let time = self.time(index, clock, elapsed);
        let divergence =
            (!replay.panicked).then(|| state.divergence(&*self.sample, clock).at_own_time(elapsed.map(|_| time)));
        self.finished[index] = Some(Finish { steps: clock.steps, time, state });
        Some((self.first + index, divergence?))
    }

    /// The members that fail in a block from `clock`, in which the engine reached states that are not all finite.
    fn lost(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        let mut lost = Vec::new();
        for lane in 0..self.lanes.len() {
            if !is_valid(&*self.engine.completed, lane, &mut *self.sample) {
                let replay = self.replay(lane, clock, block, panics);
                lost.extend(self.finish(self.lanes[lane], clock, &replay));
            }
        }
        lost
    }

    /// Takes a block of steps in which a function of the user panicked again, from the snapshot, with each member on
    /// its own: those for whom it panics finish before that step. Returns those that fail.
    fn one_by_one(&mut self, clock: Clock, block: u64, panics: &Panics) -> Vec<(usize, Divergence)> {
        let (mut indices, mut engines, mut lost) = (Vec::new(), Vec::new(), Vec::new());
        for lane in 0..self.lanes.len() {
            let (index, replay) = (self.lanes[lane], self.replay(lane, clock, block, panics));
            if replay.taken == block {
                indices.push(index);
                engines.push(replay.engine);
            } else {
                lost.extend(self.finish(index, clock, &replay));
            }
        }
        let mut lanes = Vec::with_capacity(indices.len());
        for (index, engine) in indices.iter().zip(&engines) {
            lanes.push(Lane { member: self.first + index, motions: &*engine.motions, lane: 0 });
        }
        let motions = self.gather(lanes);
        self.lanes = indices;
        self.engine = Engine::new(motions);
        self.engine.complete(self.since_opened(Clock { steps: clock.steps + block, ..clock }));
        lost
    }

    /// Takes a member step by step through a block from `clock`, in all lanes of a motion of its own, from the snapshot
    /// to the last finite state.
    fn replay(&self, lane: usize, clock: Clock, block: u64, panics: &Panics) -> Replay {
        let mut engine = Engine::new(self.gather(vec![self.lane(&*self.engine.snapshot, lane)]));
        let mut taken = 0;
        let end = panics.attempt(|| engine.replay(self.since_opened(clock), block, &mut taken));
        Replay { taken, engine, panicked: end.is_none() }
    }

    /// Tests whether the active members continue; `completed` holds the ends of their steps.
    fn test(&mut self, request: &AdvanceRequest, clock: Clock) {
        let completed = &*self.engine.completed;
        let shown = shown(completed, self.since_opened(clock));
        for (lane, index) in self.lanes.iter().enumerate() {
            if self.finished[*index].is_some() {
                continue;
            }
            show(completed, shown.as_deref(), lane, &mut *self.sample);
            if !request.stays(self.first + index, &*self.sample) {
                let time = self.time(*index, clock, elapsed(completed, shown.as_deref(), lane));
                self.finished[*index] = Some(Finish { steps: clock.steps, time, state: self.sample.boxed_clone() });
            }
        }
    }

    /// Finishes the members whose energies have strayed in the step from `before`, where it began; `completed` holds the ends of
    /// their steps, `snapshot` the beginnings.
    fn strayed(&mut self, request: &AdvanceRequest, before: Clock) -> Vec<(usize, Error)> {
        let Some(strays) = request.strays else { return Vec::new() };
        let after = Clock { steps: before.steps + 1, ..before };
        let completed = &*self.engine.completed;
        let shown_after = shown(completed, self.since_opened(after));
        let mut found = Vec::new();
        for (lane, index) in self.lanes.iter().enumerate().filter(|(_, index)| self.finished[**index].is_none()) {
            show(completed, shown_after.as_deref(), lane, &mut *self.sample);
            let time = self.time(*index, after, elapsed(completed, shown_after.as_deref(), lane));
            let error = strays(self.first + index, &*self.sample, after.steps, time);
            found.extend(error.map(|error| (lane, *index, error)));
        }
        let mut strayed = Vec::with_capacity(found.len());
        for (lane, index, error) in found {
            let mut motion = self.gather(vec![self.lane(&*self.engine.snapshot, lane)]);
            motion.complete(self.since_opened(before), Some(1));
            let shown_before = shown(&*motion, self.since_opened(before));
            let mut state = self.sample.boxed_clone();
            show(&*motion, shown_before.as_deref(), 0, &mut *state);
            let time = self.time(index, before, elapsed(&*motion, shown_before.as_deref(), 0));
            self.finished[index] = Some(Finish { steps: before.steps, time, state });
            strayed.push((self.first + index, error));
        }
        strayed
    }

    /// The number of the first member.
    pub(crate) fn first(&self) -> usize {
        self.first
    }

    /// Advances the active members, and returns those that diverge or exceed the bound on their energy.
    pub(crate) fn advance(&mut self, request: &AdvanceRequest) -> Ended {
        let (mut done, mut ended) = (0, Ended::default());
        while done < request.steps && !self.lanes.is_empty() {
            let block = request.block(done);
            let (before, since) = (request.clock_after(done), self.since_opened(request.clock_after(done)));
            done += block;
            match request.panics.attempt(|| self.engine.take_steps(since, block)) {
                Some(true) => ended.strayed.extend(self.strayed(request, before)),
                Some(false) => {
                    ended.lost.extend(self.lost(before, block, request.panics));
                    ended.strayed.extend(self.strayed(request, before));
                }
                // The begins of the others' steps are not kept, so the next step computes them.
                None => ended.lost.extend(self.one_by_one(before, block, request.panics)),
            }
            if request.tests_after(done) {
                self.test(request, request.clock_after(done));
            }
            self.compact_lanes();
        }
        ended
    }

    /// The number of members in progress.
    pub(crate) fn active(&self) -> usize {
        self.lanes.len()
    }

    /// The number of steps that a member, by its number in the ensemble, has taken.
    pub(crate) fn steps(&self, member: usize, clock: Clock) -> u64 {
        self.finished[member - self.first].as_ref().map_or(clock.steps, |finish| finish.steps)
    }

    /// Shows the states of all members, in their order.
    pub(crate) fn states(&self, clock: Clock, visit: &mut dyn FnMut(usize, &dyn Point)) {
        let (mut completed, clock) = (self.engine.motions.clone(), self.since_opened(clock));
        completed.complete(clock, Some(1));
        let shown = shown(&*completed, clock);
        let mut sample = self.sample.boxed_clone();
        // The members in progress are in the lanes, in their order.
        let mut lane = 0;
        for (member, finished) in (self.first..).zip(&self.finished) {
            if let Some(finish) = finished {
                visit(member, &*finish.state);
                continue;
            }
            show(&*completed, shown.as_deref(), lane, &mut *sample);
            visit(member, &*sample);
            lane += 1;
        }
    }

    /// The state of a member.
    pub(crate) fn state(&self, member: usize, clock: Clock) -> Box<dyn Point> {
        match &self.finished[member - self.first] {
            Some(finish) => finish.state.boxed_clone(),
            None => self.under_way(member, clock).0,
        }
    }

    /// The time of a member.
    pub(crate) fn time_of(&self, member: usize, clock: Clock) -> f64 {
        let index = member - self.first;
        match &self.finished[index] {
            Some(finish) => finish.time,
            None if !self.is_timed() => self.time(index, clock, None),
            None => self.time(index, clock, self.under_way(member, clock).1),
        }
    }

    /// Shows the times of all members, in their order.
    pub(crate) fn times(&self, clock: Clock, visit: &mut dyn FnMut(f64)) {
        let mut completed = None;
        if self.is_timed() {
            let mut motions = self.engine.motions.clone();
            motions.complete(self.since_opened(clock), Some(1));
            let shown = shown(&*motions, self.since_opened(clock));
            completed = Some((motions, shown));
        }
        let mut lane = 0;
        for (index, finished) in self.finished.iter().enumerate() {
            if let Some(finish) = finished {
                visit(finish.time);
                continue;
            }
            let elapsed = completed.as_ref().and_then(|(motions, shown)| elapsed(&**motions, shown.as_deref(), lane));
            visit(self.time(index, clock, elapsed));
            lane += 1;
        }
    }

    /// Whether the time is part of the states of members in progress.
    pub(crate) fn is_timed(&self) -> bool {
        !self.lanes.is_empty() && self.engine.motions.elapsed(0).is_some()
    }

    /// A member that is in progress, alone.
    pub(crate) fn alone(&self, member: usize) -> Alone {
        let index = member - self.first;
        let lane = self.lanes.partition_point(|other| *other < index);
        let motions = self.gather(vec![self.lane(&*self.engine.motions, lane)]);
        let engine = Engine::of_member(motions, member);
        Alone { engine, opened: self.opened, opened_at: self.opened_at[index] }
    }

    /// A member alone, from a state in the middle of the current step.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn alone_from(&self, member: usize, form: Form, state: &dyn Point) -> Engine {
        Engine::of_member(load_from(&*self.engine.motions, form, vec![(member, state)]), member)
    }

    /// Takes a member out of the lanes that was lost beyond the steps of all.
    pub(crate) fn lose(&mut self, member: usize, finish: Finish) {
        self.finished[member - self.first] = Some(finish);
        self.compact_lanes();
    }

    /// The state of a member that is in progress, and its time since the states were changed where that is part of it.
    fn under_way(&self, member: usize, clock: Clock) -> (Box<dyn Point>, Option<[f64; 2]>) {
        let index = member - self.first;
        // The members before it that are in progress are in the lanes before.
        let (lane, motions) = (self.lanes.partition_point(|other| *other < index), &*self.engine.motions);
        let (motion, lane) = (lane / motions.lanes(), lane % motions.lanes());
        let (mut completed, clock) = (copy(motions, motion..motion + 1), self.since_opened(clock));
        completed.complete(clock, Some(1));
        let mut state = self.sample.boxed_clone();
        let shown = shown(&*completed, clock);
        show(&*completed, shown.as_deref(), lane, &mut *state);
        (state, elapsed(&*completed, shown.as_deref(), lane))
    }

    /// Whether a member is active: neither failed nor finished.
    pub(crate) fn is_under_way(&self, member: usize) -> bool {
        self.finished[member - self.first].is_none()
    }

    /// Returns the number of steps after which the states were last changed from outside.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn opened(&self) -> u64 {
        self.opened
    }

    /// Shows all members, in their order: those in progress in the middle of the step.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn unfinished(&self, form: Form, visit: &mut dyn FnMut(Option<Finished>, &dyn Point)) {
        let (mut sample, mut lane) = (self.sample.boxed_clone(), 0);
        for finished in &self.finished {
            if let Some(Finish { steps, time, state }) = finished {
                visit(Some(Finished { steps: *steps, time: *time }), &**state);
                continue;
            }
            self.engine.unfinished(form, lane, &mut *sample);
            visit(None, &*sample);
            lane += 1;
        }
    }

    /// Continues from what [`Batch::unfinished`] has shown.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn resume(
        &mut self,
        form: Form,
        opened: u64,
        states: &States,
        finished: &dyn Fn(usize) -> Option<Finished>,
    ) {
        for (member, end) in (self.first..).zip(&mut self.finished) {
            let state = || states(member).boxed_clone();
            *end = finished(member).map(|Finished { steps, time }| Finish { steps, time, state: state() });
        }
        self.lanes = (0..self.finished.len()).filter(|index| self.finished[*index].is_none()).collect();
        let members = with_states(self.first, &self.lanes, states);
        self.engine = Engine::new(load_from(&*self.engine.motions, form, members));
        self.opened = opened;
    }

    /// Sets the states of the active members after this number of steps.
    pub(crate) fn restart(&mut self, states: &States, clock: Clock) {
        if self.is_timed() {
            for lane in 0..self.lanes.len() {
                let index = self.lanes[lane];
                if let (_, Some(elapsed)) = self.under_way(self.first + index, clock) {
                    self.opened_at[index] = durations(self.opened_at[index], elapsed);
                }
            }
        }
        self.engine.restart(self.engine.reloaded(with_states(self.first, &self.lanes, states)));
        self.opened = clock.steps;
    }
}

/// The members at some indices after the first one, with their states.
fn with_states<'s>(first: usize, indices: &[usize], states: &States<'s>) -> Vec<(usize, &'s dyn Point)> {
    indices.iter().map(|index| (first + index, states(first + index))).collect()
}
