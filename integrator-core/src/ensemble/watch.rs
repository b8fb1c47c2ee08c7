//! A bound on the energies of all members, looked at after every step.

use crate::{
    ensemble::{Ensemble, members::Members},
    error::Error,
    state::{coords::Coords, point::Point},
    trajectory::watch::{Watch, check_bound},
};

impl<C: Coords> Ensemble<C> {
    /// Stops members whose energy error exceeds a bound, like [`Run::watch_energy`](crate::Run::watch_energy).
    ///
    /// A member rejects a step if `|H - H₀| > relative_bound · (|T₀| + |V₀|)`, or if `H` is not finite. `H₀`, `T₀` and `V₀` are
    /// the energies of the member when this method is called, or after [`Ensemble::map_states`] changed its state.
    /// `f64::INFINITY` rejects only energies that are not finite.
    ///
    /// - Such a member stays at the step before, and [`Error::Strayed`] lists it. The other members continue, bitwise
    ///   identical to those without a watch.
    /// - Each step costs one evaluation of the energy per member more.
    /// - Neither a checkpoint nor [`Ensemble::run_of`] contains the watch.
    /// - [`Ensemble::advance_to`] checks after whole steps. It returns the error before it has reached its time; call it
    ///   again.
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
    /// - [`Error::WatchBound`]: the bound is not positive.
    /// - [`Error::NotConserved`]: `H` depends on time.
    /// - [`Error::Member`]: the energy of an active member is not finite.
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

    /// Restarts the watches on some members from states.
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
