//! Runs whose state is changed wherever a function passes through zero: bounces, kicks, particles that come back at the other
//! end.
//!
//! Comes in: a run, a function and an action. Goes out: the run, some whole steps later. Always true: steps end at `t0 + n·h`. A
//! step with a crossing consists of a shorter one to the crossing and another one from the changed state to its end, by the
//! same method; a step without one has the bits of `advance`.

use crate::{
    error::Error,
    scalar::exact::two_sum,
    state::{clock::Clock, coords::Coords, phase::Phase},
    trajectory::{
        crossings::{Direction, Point, between, crosses, point, present},
        run::Run,
    },
};

/// A zero that is reached from a changed state within this fraction of a step is the one at which it was changed: an action that
/// rounds, such as `rem_euclid`, may put the state a little before it. Half of the digits of a step are left to see others.
const SAME: f64 = 1.0 / (1_u64 << 26) as f64;

impl<C: Coords> Run<C> {
    /// Takes `steps` steps and calls `action` at each zero of `function`; returns the number of these crossings.
    ///
    /// Examples are a bouncing ball, a kick at each pericentre, or a particle that re-enters a box at the other end.
    ///
    /// Crossings are those of [`Run::crossings`]. `action(state, time)` changes the state at the crossing. The changed state
    /// counts as lying beyond this zero, so that the same crossing is not found again. A shorter step then leads to the end
    /// of the step in which the crossing was.
    ///
    /// - [`Run::time`] remains `t0 + n·h`; crossings do not accumulate an error of the time.
    /// - Steps without a crossing are bitwise identical to those of [`Run::advance`].
    /// - With [`Taylor`](crate::taylor::Taylor), a new polynomial begins at each crossing.
    /// - Two crossings within one step, or within the remainder of a step after a crossing, are not found. A ball that
    ///   bounces lower and lower falls through the floor once it returns within one step; let `action` stop such a ball.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Ball;
    ///
    /// #[hamiltonian]
    /// impl Ball {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] }
    /// }
    ///
    /// let mut run = Ball.run(Phase::new([0.0], [1.0]), 0.125)?;
    /// let mut times = Vec::new();
    /// let bounces = run.on_crossing(800, Direction::Falling, |state, _| state.q[0], |state, time| {
    ///     state.p[0] = -state.p[0];
    ///     times.push(time);
    /// })?;
    /// // From the floor and back takes 2 units of time.
    /// assert_eq!((bounces, run.time()), (49, 100.0));
    /// assert!((times[48] - 98.0).abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// The run is at the end of the last complete step after an error.
    ///
    /// - Those of [`Run::advance`].
    /// - [`Error::Crossing`]: the function is not finite.
    /// - Those of [`Run::map_state`], for the state that `action` leaves.
    pub fn on_crossing(
        &mut self,
        steps: u64,
        direction: Direction,
        mut function: impl FnMut(&Phase<C>, f64) -> f64,
        mut action: impl FnMut(&mut Phase<C>, f64),
    ) -> Result<u64, Error> {
        self.clock.end(steps)?;
        self.show_step();
        let mut before = present(self, &mut function)?;
        let mut passing = Passing { side: before.value, direction, whole: self.clock.h, is_changed: false };
        let mut crossings = 0;
        for _ in 0..steps {
            self.advance(1)?;
            let mut after = present(self, &mut function)?;
            match passing.found(self, &mut function, [&before, &after])? {
                None => passing.is_changed = false,
                Some(found) => {
                    let mut rest = self.clone();
                    self.take_back(1);
                    crossings += rest.through(found, &mut passing, &mut function, &mut action)?;
                    *self = rest;
                    after = present(self, &mut function)?;
                }
            }
            before = after;
        }
        Ok(crossings)
    }

    /// Goes from a crossing in the last step of this run to the end of this step, through others that are on the way. The run
    /// restarts there; it is unusable after an error. Returns the number of crossings.
    fn through(
        &mut self,
        (mut fraction, mut crossing): (f64, Point<C>),
        passing: &mut Passing,
        function: &mut impl FnMut(&Phase<C>, f64) -> f64,
        action: &mut impl FnMut(&mut Phase<C>, f64),
    ) -> Result<u64, Error> {
        let end = self.clock;
        let (mut duration, mut crossings) = (end.h, 0);
        loop {
            let time = crossing.time;
            self.map_state(|state| {
                *state = crossing.state;
                action(state, time);
            })?;
            crossings += 1;
            duration -= fraction * duration;
            self.begin_at(time, duration);
            let changed = point(time, self.state(), function)?;
            (passing.side, passing.is_changed) = (changed.value, true);
            // Too near to the end of the step for a clock: it is there.
            if self.clock.end(1).is_err() {
                break;
            }
            self.advance(1)?;
            let after = present(self, function)?;
            let Some(next) = passing.found(self, function, [&changed, &after])? else {
                // Closed at the end of the step, as for a change of the state there.
                self.map_state(|_| {})?;
                passing.is_changed = false;
                break;
            };
            (fraction, crossing) = next;
        }
        (self.clock, self.opened) = (end, end.steps);
        Ok(crossings)
    }

    /// Sets the start time of the clock of a run that has just restarted, with steps of another duration.
    fn begin_at(&mut self, time: f64, h: f64) {
        // A time that is part of the state is counted from where the run was begun.
        if self.time_in_state().is_some() {
            self.opened_at = two_sum(time, -self.clock.t0);
            self.clock = Clock { h, steps: 0, ..self.clock };
        } else {
            self.clock = Clock { t0: time, h, steps: 0 };
        }
        self.opened = 0;
    }
}

/// The state of the search for zeros of the function during a run.
struct Passing {
    /// The last value that was not zero, or the value at a changed state.
    side: f64,
    direction: Direction,
    /// A whole step.
    whole: f64,
    /// Whether the current step begins at a state that the action left.
    is_changed: bool,
}

impl Passing {
    /// The crossing in the last step of a run, between two points, with the fraction of the step at which it is.
    fn found<C: Coords>(
        &mut self,
        run: &mut Run<C>,
        function: &mut impl FnMut(&Phase<C>, f64) -> f64,
        [before, after]: [&Point<C>; 2],
    ) -> Result<Option<(f64, Point<C>)>, Error> {
        if !crosses(&mut self.side, after.value, self.direction) {
            return Ok(None);
        }
        let found = between(run, function, before, after)?;
        let is_same = self.is_changed && (found.0 * run.step()).abs() <= SAME * self.whole.abs();
        Ok((!is_same).then_some(found))
    }
}
