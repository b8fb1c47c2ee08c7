//! Read access to the members of an ensemble on a device.

use crate::{
    ensemble::{Ended, Ensemble},
    error::Error,
};
use integrator_core::{
    __private::{Coords, energy_in, under_way},
    Phase,
};

impl<C: Coords> Ensemble<C> {
    /// Returns the number of members.
    pub fn len(&self) -> usize {
        self.processor.len()
    }

    /// Returns `false`: an ensemble has at least one member.
    pub fn is_empty(&self) -> bool {
        self.processor.is_empty()
    }

    /// Returns the number of active members, which have neither failed nor finished.
    pub fn active(&self) -> usize {
        if self.place.is_some() { self.len() - self.ended.len() } else { self.processor.active() }
    }

    /// Returns the failed and finished members, each with its last step.
    pub fn lost(&self) -> Vec<(usize, u64)> {
        if self.place.is_some() {
            return self.ended.iter().map(|(member, ended)| (*member, ended.steps)).collect();
        }
        let mut under_way = under_way(&self.processor).into_iter().peekable();
        let ended = (0..self.len()).filter(|member| under_way.next_if_eq(member).is_none());
        ended.filter_map(|member| Some((member, self.processor.steps_of(member)?))).collect()
    }

    /// Returns the time of the active members: `t0 + n·h`, or the time to which [`Ensemble::advance_to`] advanced.
    pub fn time(&self) -> f64 {
        if self.place.is_none() || self.is_between { self.processor.time() } else { self.time_after(self.steps()) }
    }

    /// Returns the number of steps of a member, which is smaller for failed and finished members. `None` if there is no
    /// such member.
    pub fn steps_of(&self, member: usize) -> Option<u64> {
        if self.place.is_none() || self.is_between {
            return self.processor.steps_of(member);
        }
        let steps = self.ended.get(&member).map_or(self.steps(), |ended| ended.steps);
        (member < self.len()).then_some(steps)
    }

    /// Returns the time of a member; for failed and finished members, that of the last step. `None` if there is no such
    /// member.
    pub fn time_of(&self, member: usize) -> Option<f64> {
        if self.place.is_none() || self.is_between {
            return self.processor.time_of(member);
        }
        let time = self.ended.get(&member).map_or(self.time(), |ended| ended.time);
        (member < self.len()).then_some(time)
    }

    /// Returns the states of all members; for failed members, the last finite ones.
    ///
    /// # Errors
    /// [`Error::Call`] and [`Error::Program`], if the device fails.
    pub fn states(&mut self) -> Result<Vec<Phase<C>>, Error> {
        let columns = match &mut self.place {
            Some(place) if !self.is_between => place.show(&self.launch)?,
            _ => return Ok(self.processor.states().collect()),
        };
        let state = |member| match self.ended.get(&member) {
            Some(Ended { state, .. }) => state.clone(),
            None => self.read(&columns, member),
        };
        Ok((0..self.len()).map(state).collect())
    }

    /// Returns the state of a member, or `None` if there is no such member.
    ///
    /// [`Ensemble::states`] is faster for many members, since it accesses the device once.
    ///
    /// # Errors
    /// Those of [`Ensemble::states`].
    pub fn state(&mut self, member: usize) -> Result<Option<Phase<C>>, Error> {
        Ok(self.states()?.into_iter().nth(member))
    }

    /// Returns the energies of all members, computed on the processor from their states.
    ///
    /// # Errors
    /// Those of [`Ensemble::states`].
    pub fn energies(&mut self) -> Result<Vec<f64>, Error> {
        let states = self.states()?.into_iter().enumerate();
        let energy = |(member, state)| {
            // There is a time of each member that has a state.
            energy_in(&self.processor, member, &state, self.time_of(member).unwrap_or(f64::NAN))
        };
        Ok(states.map(energy).collect())
    }
}
