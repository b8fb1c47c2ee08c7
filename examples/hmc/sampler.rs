//! Hamiltonian Monte Carlo (Duane, Kennedy, Pendleton and Roweth 1987) for Hamiltonians with `T = |p|²/2`.

#[path = "../support/normal.rs"]
pub(crate) mod normal;

use integrator_core::{Method, prelude::*};
use normal::normal;

composition! {
    /// Two kicks, with the smallest mean energy error on normal distributions whose frequencies times the step are below 2.
    pub struct MinimumError2: order 2, symmetric,
        citation "Blanes, Casas and Sanz-Serna 2014, SIAM J. Sci. Comput. 36, A1556"
    = symmetric(V(0.21178) T(1/2) V(_));
    /// The same with three kicks, for frequencies times the step below 3.
    pub struct MinimumError3: order 2, symmetric,
        citation "Blanes, Casas and Sanz-Serna 2014, SIAM J. Sci. Comput. 36, A1556"
    = symmetric(V(0.11888010966548) T(0.29619504261126) V(_) T(_));
}

/// Sampler of the density `exp(-V)`.
pub(crate) struct Sampler<const N: usize> {
    run: Run<[f64; N]>,
    /// Largest number of steps of a trajectory; each has a random number from 1 to this one.
    steps: u64,
    random: fastrand::Rng,
    at: [f64; N],
    proposed: u64,
    accepted: u64,
}

impl<const N: usize> Sampler<N> {
    pub(crate) fn new<H, X>(system: &H, method: X, step: f64, steps: u64, seed: u64) -> Result<Self, Error>
    where
        H: Hamiltonian<Coords = [f64; N]>,
        X: Method<H>,
    {
        let (random, at) = (fastrand::Rng::with_seed(seed), [0.0; N]);
        let run = system.run_with(method, Phase::new(at, [0.0; N]), step)?;
        Ok(Self { run, steps, random, at, proposed: 0, accepted: 0 })
    }

    /// The next point: where a trajectory with fresh momenta leads, or the last one again.
    ///
    /// A symplectic and reversible step makes this exact, whatever the step: the change of the energy alone decides. One
    /// length for all trajectories could be a whole period of the motion; hence they differ.
    pub(crate) fn draw(&mut self) -> Result<[f64; N], Error> {
        let momenta = std::array::from_fn(|_| normal(&mut self.random));
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
