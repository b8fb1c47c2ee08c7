//! Ensembles without their types: what the Python class `Ensemble` calls.

use crate::{errors::Fault, interrupt::Report, run::AnyRun};
use integrator_core::{Coords, Ensemble};

/// An ensemble of any system, by any method, in any precision.
pub(crate) trait AnyEnsemble: Send + Sync {
    fn advance(&mut self, steps: u64, report: Report<'_>) -> Result<(), Fault>;
    /// The positions and the momenta of all members.
    fn states(&self) -> [Vec<f64>; 2];
    fn energies(&self) -> Vec<f64>;
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault>;
    fn time(&self) -> f64;
    fn steps(&self) -> u64;
    fn steps_of_members(&self) -> Vec<u64>;
    fn members(&self) -> usize;
    fn active(&self) -> usize;
    fn run_of(&self, member: usize) -> Option<Box<dyn AnyRun>>;
}

impl<C: Coords> AnyEnsemble for Ensemble<C> {
    fn advance(&mut self, steps: u64, report: Report<'_>) -> Result<(), Fault> {
        self.advance_with(steps, |progress| report(progress.done, progress.steps))?;
        Ok(())
    }
    fn states(&self) -> [Vec<f64>; 2] {
        let (mut q, mut p) = (Vec::new(), Vec::new());
        for state in Self::states(self) {
            let state = state.to_f64();
            q.extend_from_slice(state.q.flat());
            p.extend_from_slice(state.p.flat());
        }
        [q, p]
    }
    fn energies(&self) -> Vec<f64> {
        Self::energies(self)
    }
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault> {
        Ok(Self::watch_energy(self, bound)?)
    }
    fn time(&self) -> f64 {
        Self::time(self)
    }
    fn steps(&self) -> u64 {
        Self::steps(self)
    }
    fn steps_of_members(&self) -> Vec<u64> {
        (0..self.len()).filter_map(|member| self.steps_of(member)).collect()
    }
    fn members(&self) -> usize {
        self.len()
    }
    fn active(&self) -> usize {
        Self::active(self)
    }
    fn run_of(&self, member: usize) -> Option<Box<dyn AnyRun>> {
        Some(Box::new(Self::run_of(self, member)?))
    }
}
