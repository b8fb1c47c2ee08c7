//! Toda's lattice (1967) as a ring, and the wave that keeps its shape on it.

use integrator_core::prelude::*;

/// A Toda lattice on a ring, whose springs are exponentially stiff in compression.
pub(crate) struct Ring {
    /// Excess of the length of the ring over that of the undisplaced lattice; negative in compression.
    pub(crate) length: f64,
}

#[hamiltonian(compose = BlanesMoanSrkn11)]
impl Ring {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        // The linear terms of the springs sum to the length of the ring, a constant.
        let mut energy = (q[q.len() - 1] - q[0] - self.length).exp();
        for i in 0..q.len() - 1 {
            energy += (q[i] - q[i + 1]).exp();
        }
        energy
    }
}

/// A soliton on a ring so large that its tails do not overlap.
#[derive(Clone, Copy)]
pub(crate) struct Soliton {
    pub(crate) sites: usize,
    /// Inverse width κ: `exp(q[n-1] - q[n]) - 1 = sinh²κ / cosh²(κ n - t sinh κ)`.
    pub(crate) kappa: f64,
}

impl Soliton {
    /// Returns the speed in sites per unit of time.
    pub(crate) fn speed(&self) -> f64 {
        self.kappa.sinh() / self.kappa
    }

    /// Returns the time of one revolution around the ring.
    pub(crate) fn period(&self) -> f64 {
        self.sites as f64 / self.speed()
    }

    pub(crate) fn ring(&self) -> Ring {
        Ring { length: -2.0 * self.kappa }
    }

    /// Returns the closed form at time `t`, with the soliton at the middle site at time 0: `q[n]` is the logarithm of `cosh
    /// θ[n-1] / cosh θ[n]`, where `θ[n] = κ n - t sinh κ`.
    pub(crate) fn state(&self, t: f64) -> Phase<Vec<f64>> {
        let Self { sites, kappa } = *self;
        let (mut q, mut p) = (Vec::with_capacity(sites), Vec::with_capacity(sites));
        for site in 0..sites {
            let apart = site as f64 - (sites / 2) as f64 - self.speed() * t;
            // Each passage of the soliton displaces a site by the shortening of the ring.
            let passes = -(apart / sites as f64).round();
            let (theta, displaced) = (kappa * (apart + passes * sites as f64), 2.0 * kappa * passes);
            q.push(displaced + ln_cosh(theta - kappa) - ln_cosh(theta));
            p.push(kappa.sinh() * (theta.tanh() - (theta - kappa).tanh()));
        }
        Phase::new(q, p)
    }

    /// Returns the distances from the closed form in momenta and in positions, relative to the amplitudes of the soliton.
    pub(crate) fn distance(&self, state: &Phase<Vec<f64>>, t: f64) -> [f64; 2] {
        let expected = self.state(t);
        let greatest = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let height = expected.p.iter().copied().fold(0.0, f64::max);
        [greatest(&state.p, &expected.p) / height, greatest(&state.q, &expected.q) / (2.0 * self.kappa)]
    }
}

/// Returns the values of a state without their compensations.
pub(crate) fn values(state: &Phase<Vec<Compensated<f64>>>) -> Phase<Vec<f64>> {
    let values = |leaves: &[Compensated<f64>]| leaves.iter().map(|leaf| leaf.value).collect();
    Phase::new(values(&state.q), values(&state.p))
}

/// Returns `ln cosh x` without overflow.
fn ln_cosh(x: f64) -> f64 {
    x.abs() + (-2.0 * x.abs()).exp().ln_1p() - std::f64::consts::LN_2
}
