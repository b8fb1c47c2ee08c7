//! Runs to a given time: whole steps to the last one before it, and a shorter one on a copy.
//!
//! Always true: the run itself stands at the end of a whole step, so that where it is looked at changes nothing of it.

use crate::{
    error::Error,
    state::{coords::Coords, phase::Phase},
    trajectory::{engine::BLOCK, run::Run},
};

/// The fraction of the time to a target that is integrated in one block, at the mean rate.
const CAUTION: f64 = 0.875;

/// The largest number of shorter steps, after which the time is as near as possible.
const TRIALS: u32 = 200;

/// Returns the number of steps that lead over a part of the way, at a pace.
pub(crate) fn steps_at_once(way: f64, step: f64) -> u64 {
    (CAUTION * way / step) as u64
}

impl<C: Coords> Run<C> {
    /// Advances to the time `time`, up to rounding.
    ///
    /// The run takes whole steps up to the last one that does not end after `time`. From there, a copy takes one shorter
    /// step of the same method, or evaluates the polynomial of [`Taylor`](crate::taylor::Taylor).
    ///
    /// [`Run::time`], [`Run::state`] and [`Run::energy`] then refer to `time`. [`Run::steps`] counts whole steps, and
    /// [`Run::advance`] continues from the last whole step. The trajectory therefore does not depend on output times. If
    /// `h` is negative, times decrease.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian(compose = BlanesMoan6)]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    ///
    /// let mut run = Oscillator.run(Phase::new([1.0_f64], [0.0]), 0.1)?;
    /// run.advance_to(std::f64::consts::PI)?;
    /// assert_eq!((run.time(), run.steps()), (std::f64::consts::PI, 31));
    /// assert!((run.state().q[0] + 1.0).abs() < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - Those of [`Run::advance`].
    /// - [`Error::Time`]: `time` is not finite.
    /// - [`Error::Passed`]: `time` is before the last whole step.
    pub fn advance_to(&mut self, time: f64) -> Result<(), Error> {
        self.check_time_ahead(time)?;
        self.advance(0)?;
        match self.time_in_state() {
            None => self.advance(self.clock.whole_steps_to(time).saturating_sub(self.clock.steps))?,
            Some(_) => self.steps_in_own_time_to(time)?,
        }
        if self.time_at_step() != time {
            self.show_within_step(time)?;
        }
        Ok(())
    }

    /// Checks that the run can go to a time.
    pub(crate) fn check_time_ahead(&self, time: f64) -> Result<(), Error> {
        let present = self.time_at_step();
        if !time.is_finite() {
            return Err(Error::Time { time });
        }
        if self.clock.is_beyond(present, time) {
            return Err(Error::Passed { time, present });
        }
        Ok(())
    }

    /// Advances to a time that is part of the state: by blocks with more and more steps, but fewer than lead there at
    /// the recent mean rate. Blocks that lead beyond the time are taken back.
    pub(crate) fn steps_in_own_time_to(&mut self, time: f64) -> Result<(), Error> {
        let mut block = 1;
        let mut before = self.time_at_step();
        while before != time {
            let earlier = (block > 1).then(|| self.clone());
            let outcome = self.advance(block);
            let after = self.time_at_step();
            if let (Err(_), Some(earlier), true) = (&outcome, earlier, self.clock.is_beyond(after, time)) {
                // What ends the run beyond the time is not on the way there.
                *self = earlier;
                block /= 2;
                continue;
            }
            outcome?;
            if after == before {
                return Err(Error::Clock { h: self.clock.h, time: after });
            }
            let step = (after - before) / block as f64;
            let longest = if self.clock.is_beyond(after, time) {
                self.take_back(block);
                if block == 1 {
                    break;
                }
                block / 2
            } else {
                before = after;
                // A watch reads each step; it can undo at most a block of the engine.
                if self.watch.is_some() { 1 } else { BLOCK.min(2 * block) }
            };
            block = steps_at_once(time - before, step).clamp(1, longest);
        }
        Ok(())
    }

    /// Shows the run at a time within the next step.
    fn show_within_step(&mut self, time: f64) -> Result<(), Error> {
        let from = self.state_at_step();
        let began = self.time_at_step();
        // The next step as a whole, for methods that know what is within.
        self.take_step()?;
        let state = match self.time_in_state() {
            None => self.within(&from, time - began).map(|(_, state)| state),
            Some(end) => self.at_time_within(&from, [(0.0, began), (self.clock.h, end)], time).map(|(_, state)| state),
        };
        self.take_back(1);
        self.show_at(time, state?);
        Ok(())
    }

    /// The duration and the state at a time between two durations of the last step and the times that they lead to, where
    /// durations are of another time: by secants, of which the side that stays twice counts half, so that both close in (the Illinois
    /// algorithm).
    pub(crate) fn at_time_within(
        &mut self,
        from: &Phase<C>,
        ends: [(f64, f64); 2],
        time: f64,
    ) -> Result<(f64, Phase<C>), Error> {
        let [mut near, mut far] = ends;
        let mut weights = [1.0, 1.0];
        let (mut state, mut duration) = (from.clone(), 0.0);
        for _ in 0..TRIALS {
            let [below, above] = [(near.1 - time) * weights[0], (far.1 - time) * weights[1]];
            let secant = (near.0 * above - far.0 * below) / (above - below);
            let is_inside = (secant - near.0) * (secant - far.0) < 0.0;
            duration = if is_inside { secant } else { near.0 + (far.0 - near.0) / 2.0 };
            let reached;
            (reached, state) = self.within(from, duration)?;
            if reached == time || duration == near.0 || duration == far.0 {
                break;
            }
            if self.clock.is_beyond(reached, time) {
                (far, weights) = ((duration, reached), [weights[0] / 2.0, 1.0]);
            } else {
                (near, weights) = ((duration, reached), [1.0, weights[1] / 2.0]);
            }
        }
        Ok((duration, state))
    }
}
