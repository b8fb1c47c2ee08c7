//! A bound on the energies of all members, looked at after every step.

use crate::{
    ensemble::{Ensemble, members::Members},
    error::Error,
    state::{coords::Coords, point::Point},
    trajectory::watch::{Watch, check_bound},
};

impl<C: Coords> Ensemble<C> {
    /// Makes [`Ensemble::advance`] end members where their energies leave a bound, as [`Run::watch_energy`](crate::Run::watch_energy)
    /// does with a run: a member takes no step whose energy `H` differs by more than `relative_bound` times `|T₀| + |V₀|` from
    /// `H₀`, or is not a number. `H₀`, `T₀` and `V₀` are its own at the time of this call, or where
    /// [`Ensemble::map_states`] has changed its state since. With a bound of infinity, members end at energies that are not
    /// numbers alone, such as those left of the zero of a logarithm.
    ///
    /// Such a member stays one step before and is named in [`Error::Strayed`]; the others go on, with the bits that they have
    /// without the watch. A step costs one energy of each member more. A checkpoint does not keep the watch, nor does
    /// [`Ensemble::run_of`]. [`Ensemble::advance_to`] looks after whole steps, and returns the error before it is at its time:
    /// call it again.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Gamma { shape: f64 }
    ///
    /// #[hamiltonian]
    /// impl Gamma {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] - self.shape * q[0].ln() }
    /// }
    ///
    /// // Steps of the first one are too long at the edge of the density.
    /// let members = [-3.0, 1.0].map(|p| (Gamma { shape: 0.1 }, Phase::new([0.5], [p])));
    /// let mut swarm = Ensemble::new(Verlet, members, 0.1)?;
    /// swarm.watch_energy(f64::INFINITY)?;
    /// let Err(Error::Strayed { members }) = swarm.advance(10) else { panic!("a member strays") };
    /// assert_eq!((members.len(), members[0].0, swarm.active()), (1, 0, 1));
    /// assert!(swarm.energy(0).is_some_and(f64::is_finite));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WatchBound`] for a bound that is not above zero; [`Error::NotConserved`] where `H` reads the time;
    /// [`Error::Member`] for a member under way that has no energy.
    pub fn watch_energy(&mut self, relative_bound: f64) -> Result<(), Error> {
        check_bound(relative_bound, self.kind.autonomous)?;
        self.members.watch(relative_bound)
    }
}

impl Members {
    /// Begins to watch the energies of all members with a bound.
    fn watch(&mut self, bound: f64) -> Result<(), Error> {
        let mut watches = Vec::with_capacity(self.count());
        let mut outcome = Ok(());
        for batch in 0..self.batches() {
            self.states_at_step(batch, &mut |member, state| {
                watches.push(self.watch_from(member, state, bound));
                if outcome.is_ok() && self.is_under_way(member) {
                    outcome = self.changed(member, state);
                }
            });
        }
        outcome?;
        self.watches = Some(watches);
        Ok(())
    }

    /// The watch on a member from a state on.
    fn watch_from(&self, member: usize, state: &dyn Point, bound: f64) -> Watch {
        Watch::new(bound, self.energies.parts(member, state, self.time_at_step()))
    }

    /// Lets the watches on some members begin anew from states.
    pub(super) fn watch_anew<'s>(&mut self, members: &[usize], states: &dyn Fn(usize) -> &'s dyn Point) {
        let Some(mut watches) = self.watches.take() else { return };
        for member in members {
            watches[*member] = self.watch_from(*member, states(*member), watches[*member].bound);
        }
        self.watches = Some(watches);
    }

    fn is_under_way(&self, member: usize) -> bool {
        self.batch_of(member).is_some_and(|batch| batch.is_under_way(member))
    }
}
