//! Temperatures, heat and work of runs with friction and noise.

use crate::{error::Error, state::coords::Coords, trajectory::run::Run};

/// The changes of the energy of a system with a temperature, in the units of `H`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBalance {
    /// The heat that the momenta absorbed from the bath: the sum of the changes of the kinetic energy by `O`.
    pub heat: f64,
    /// The remaining change of the energy. If `H` does not depend on time, this is the shadow work: the energy error of the
    /// flows of `T` and `V`. Otherwise it contains the work of the external force as well.
    pub work: f64,
}

impl<C: Coords> Run<C> {
    /// Returns the kinetic temperature `2T/n` at [`Run::time`], for a kinetic energy `T = Σ p²/(2m)` of `n` momenta.
    ///
    /// The unit is that of the energy: Boltzmann's constant is 1. In equilibrium, the mean is the temperature of the bath.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Gas;
    ///
    /// #[hamiltonian]
    /// impl Gas {
    ///     fn kinetic(&self, p: [[f64; 3]; 2]) -> f64 {
    ///         p.iter().map(|p| (p[0].powi(2) + p[1].powi(2) + p[2].powi(2)) / 2.0).sum()
    ///     }
    ///     fn potential(&self, q: [[f64; 3]; 2]) -> f64 { 0.0 * q[0][0] }
    /// }
    ///
    /// let run = Gas.run(Phase::new([[0.0; 3]; 2], [[1.0; 3], [3.0; 3]]), 0.1)?;
    /// assert_eq!(run.kinetic_temperature(), 5.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn kinetic_temperature(&self) -> f64 {
        let state = self.state();
        let count = state.p.flat().len();
        2.0 * self.parts_of(|| state).kinetic / count as f64
    }

    /// Takes `steps` steps like [`Run::advance`], and returns how much the energy changed by heat and by work.
    ///
    /// Both are sums over these steps, with the rounding errors of the energy. The steps are bitwise those of `advance`.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian(split = kinetic + potential + friction)]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(2) / 2.0 }
    ///     #[friction]
    ///     fn friction(&self, _i: usize) -> f64 { 1.0 }
    ///     #[temperature]
    ///     fn temperature(&self, _i: usize) -> f64 { 0.5 }
    /// }
    ///
    /// let mut run = Oscillator.run(Phase::new([0.0], [0.0]), 0.01)?.with_seed(7);
    /// let balance = run.advance_with_balance(10_000)?;
    /// assert!((balance.heat + balance.work - run.energy()).abs() < 1e-9);
    /// // The energy of the start was zero: all of it came from the bath, up to the error of the step.
    /// assert!(balance.work.abs() < 0.01);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Run::advance`]; [`Error::NoTemperature`] if the system has none.
    pub fn advance_with_balance(&mut self, steps: u64) -> Result<EnergyBalance, Error> {
        // Steps begin where the last one ended, also after `advance_to`.
        self.show_step();
        let before = self.energy();
        self.measure_heat(true);
        let advanced = self.heat().and_then(|_| self.advance(steps));
        let heat = self.heat();
        self.measure_heat(false);
        let heat = advanced.and(heat)?;
        Ok(EnergyBalance { heat, work: self.energy() - before - heat })
    }

    /// Begins to measure the heat that steps absorb, or ends it.
    pub(crate) fn measure_heat(&mut self, measures_heat: bool) {
        self.engine.change_draws(&|draws| draws.measures_heat = measures_heat);
    }

    /// The heat that steps absorbed since this began to be measured, or since the state was last changed from outside.
    pub(crate) fn heat(&mut self) -> Result<f64, Error> {
        let noise = self.engine.motions.noise(0);
        noise.and_then(|noise| noise.heat.as_ref()?.first().copied()).ok_or(Error::NoTemperature)
    }
}
