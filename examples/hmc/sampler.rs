//! Hamiltonian Monte Carlo (Duane, Kennedy, Pendleton and Roweth 1987) for Hamiltonians of two coordinates with `T = |p|²/2`.

use integrator_core::prelude::*;

#[path = "../support/normal.rs"]
mod normal;
use normal::normal;

/// Sampler of the density `exp(-V)`.
pub(crate) struct Sampler {
    run: Run<[f64; 2]>,
    /// Largest number of steps of a trajectory; each has a random number from 1 to this one.
    steps: u64,
    random: fastrand::Rng,
    at: [f64; 2],
    proposed: u64,
    accepted: u64,
}

impl Sampler {
    pub(crate) fn new<H>(system: &H, step: f64, steps: u64, seed: u64) -> Result<Self, Error>
    where
        H: Hamiltonian<Coords = [f64; 2]>,
    {
        let (random, at) = (fastrand::Rng::with_seed(seed), [0.0; 2]);
        let run = system.run(Phase::new(at, [0.0; 2]), step)?;
        Ok(Self { run, steps, random, at, proposed: 0, accepted: 0 })
    }

    /// The next point: where a trajectory with fresh momenta leads, or the last one again.
    ///
    /// A symplectic and reversible step makes this exact, whatever the step: the change of the energy alone decides. One
    /// length for all trajectories could be a whole period of the motion; hence they differ.
    pub(crate) fn draw(&mut self) -> Result<[f64; 2], Error> {
        let momenta = [normal(&mut self.random), normal(&mut self.random)];
        let Self { run, at, .. } = self;
        run.map_state(|state| *state = Phase::new(*at, momenta))?;
        let before = run.energy();
        self.proposed += 1;
        match run.advance(self.random.u64(1..=self.steps)) {
            Ok(()) if self.random.f64() < (before - run.energy()).exp() => {
                *at = run.state().q;
                self.accepted += 1;
            }
            // A diverged trajectory has infinite energy and is rejected.
            Ok(()) | Err(Error::Diverged(_)) => {}
            Err(error) => return Err(error),
        }
        Ok(self.at)
    }

    /// Returns the share of accepted trajectories.
    pub(crate) fn acceptance(&self) -> f64 {
        self.accepted as f64 / self.proposed as f64
    }
}

/// Returns mean and variance.
pub(crate) fn moments(series: &[f64]) -> (f64, f64) {
    let mean = series.iter().sum::<f64>() / series.len() as f64;
    (mean, series.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / series.len() as f64)
}

/// Returns the effective sample size: the number of draws divided by the sum of autocorrelations, truncated where two
/// adjacent ones have a negative sum (Geyer 1992).
pub(crate) fn effective_size(series: &[f64]) -> f64 {
    let (mean, variance) = moments(series);
    let correlation = |lag: usize| {
        let pairs = series.iter().zip(&series[lag..]);
        pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() / (series.len() as f64 * variance)
    };
    let pairs = (0..series.len() / 2).map(|pair| correlation(2 * pair) + correlation(2 * pair + 1));
    let time = 2.0 * pairs.take_while(|sum| *sum > 0.0).sum::<f64>() - 1.0;
    series.len() as f64 / time
}
