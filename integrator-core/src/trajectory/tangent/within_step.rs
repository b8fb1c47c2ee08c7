//! Tangents at a given time: whole steps to the last one before it, and a shorter one on a copy, as of runs.

use super::{Tangent, of_vector};
use crate::{error::Error, state::coords::Coords, trajectory::run::Lane};
use alloc::vec::Vec;

impl<C: Coords> Tangent<C> {
    /// Advances to a time like [`Run::advance_to`](crate::Run::advance_to): the state is bitwise identical to that run,
    /// and the vectors are the derivatives of the whole steps and of the shorter one after them. [`Tangent::advance`]
    /// continues from the last whole step.
    ///
    /// By a method in a fictitious time, such as [`Logarithmic`](crate::Logarithmic), the shorter step is as long as
    /// that of the state: neighbours arrive at other times, see [`Tangent::time_slopes`].
    ///
    /// # Errors
    /// As [`Run::advance_to`](crate::Run::advance_to), and as [`Tangent::advance`] for vectors.
    pub fn advance_to(&mut self, time: f64) -> Result<(), Error> {
        let [first, ..] = &self.runs[..] else { return Ok(()) };
        first.check_time_ahead(time)?;
        self.advance(0)?;
        let first = &self.runs[0];
        let mut outcome = Ok(());
        let end = match first.time_in_state() {
            None => first.clock.whole_steps_to(time),
            Some(_) => {
                let mut ahead = first.clone();
                outcome = ahead.steps_in_own_time_to(time).map_err(|error| of_vector(&ahead, 0, error));
                ahead.steps()
            }
        };
        self.advance(end.saturating_sub(self.steps()))?;
        outcome?;
        if self.runs[0].time_at_step() != time {
            self.show_within_step(time)?;
        }
        Ok(())
    }

    /// Shows state and vectors at a time within the next step.
    fn show_within_step(&mut self, time: f64) -> Result<(), Error> {
        let began = self.runs[0].time_at_step();
        let (mut duration, mut shown) = (None, Vec::new());
        for number in 0..self.runs.len() {
            let lanes = self.lanes_within_step(number, began, time, &mut duration);
            let error = |error| of_vector(&self.runs[number], number * self.room, error);
            shown.push(lanes.map_err(error)?);
        }
        self.runs[0].show_at(time, shown[0][0].0.clone());
        self.between = Some(shown);
        Ok(())
    }

    /// The lanes of a run at a time within its next step, which begins at another one; all runs go there by the same
    /// `duration`.
    fn lanes_within_step(
        &mut self,
        number: usize,
        began: f64,
        time: f64,
        duration: &mut Option<f64>,
    ) -> Result<Vec<Lane<C>>, Error> {
        let run = &mut self.runs[number];
        let from: Vec<_> = (0..=self.room).map(|lane| run.lane(lane)).collect();
        // The next step as a whole, for methods that know what is within.
        run.take_step()?;
        let known = match (*duration, run.time_in_state()) {
            (Some(duration), _) => Ok(duration),
            (None, None) => Ok(time - began),
            (None, Some(end)) => {
                run.at_time_within(&from[0], [(0.0, began), (run.step(), end)], time).map(|(duration, _)| duration)
            }
        };
        let lanes = known.and_then(|known| {
            *duration = Some(known);
            run.lanes_within(&from, known)
        });
        run.take_back(1);
        lanes
    }
}
