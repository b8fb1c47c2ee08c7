//! A bound on the energy of a run, checked after every step, so that portions do not matter.

use crate::{error::Error, state::coords::Coords, system::energy::Parts, trajectory::run::Run};

/// The energy that a run is compared with, and the bound on the difference.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    pub(crate) bound: f64,
    pub(crate) energy: f64,
    /// `|T| + |V|`, where the watch began.
    scale: f64,
}

impl Watch {
    pub(crate) fn new(bound: f64, Parts { kinetic, potential, total, .. }: Parts) -> Self {
        Self { bound, energy: total, scale: kinetic.abs() + potential.abs() }
    }

    /// Whether a step may lead to this energy, which has to be finite.
    pub(crate) fn admits(&self, energy: f64) -> bool {
        // A state of no energy at rest, such as an equilibrium, has no scale: nothing may change then.
        let allowed = if self.scale == 0.0 { 0.0 } else { self.bound * self.scale };
        energy.is_finite() && (energy - self.energy).abs() <= allowed
    }
}

impl Watch {
    /// The error of a step to this energy, if it may not be taken.
    pub(crate) fn strayed(&self, energy: f64, step: u64, time: f64) -> Option<Error> {
        let Self { bound, energy: before, .. } = *self;
        (!self.admits(energy)).then_some(Error::EnergyStrayed { step, time, energy, before, bound })
    }
}

/// Whether a watch may have a bound.
///
/// # Errors
/// [`Error::WatchBound`]; [`Error::NotConserved`].
pub(crate) fn check_bound(bound: f64, autonomous: bool) -> Result<(), Error> {
    match bound {
        _ if !autonomous => Err(Error::NotConserved),
        bound if bound.is_nan() || bound <= 0.0 => Err(Error::WatchBound { bound }),
        _ => Ok(()),
    }
}

impl<C: Coords> Run<C> {
    /// Stops [`Run::advance`] when the energy error exceeds a bound.
    ///
    /// The energy is checked after every step. The run rejects a step if `|H - H₀| > relative_bound · (|T₀| + |V₀|)`, or if
    /// `H` is not finite. `H₀`, `T₀` and `V₀` are the energies when this method is called. The bound is therefore useful
    /// even if `H₀` is zero, as on a parabolic Kepler orbit, and it does not grow in an encounter.
    ///
    /// - Another call sets another bound. `f64::INFINITY` rejects only energies that are not finite.
    /// - Accepted steps are bitwise identical to those without a watch.
    /// - Each step costs one evaluation of [`Run::energy`] more, which is noticeable if steps are cheap.
    /// - A checkpoint does not contain the watch.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Kepler;
    ///
    /// #[hamiltonian]
    /// impl Kepler {
    ///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
    ///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
    /// }
    ///
    /// // Nearly a fall into the centre, at a step that is far too long there.
    /// let mut run = Kepler.run(Phase::new([1.0, 0.0], [0.0, 0.05]), 0.1)?;
    /// run.watch_energy(0.01)?;
    /// assert!(matches!(run.advance(1_000), Err(Error::EnergyStrayed { .. })));
    /// assert!((run.energy() + 1.0).abs() < 0.02);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::WatchBound`]: the bound is not positive.
    /// - [`Error::NotConserved`]: `H` depends on time.
    /// - [`Error::Energy`]: the energy of the current state is not finite.
    pub fn watch_energy(&mut self, relative_bound: f64) -> Result<(), Error> {
        check_bound(relative_bound, self.autonomous)?;
        let parts = self.parts();
        parts.admissible(self.time())?;
        self.watch = Some(Watch::new(relative_bound, parts));
        Ok(())
    }
}
