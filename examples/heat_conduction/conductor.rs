//! A chain of oscillators between two heat baths, its temperatures and its heat current.

use integrator_core::prelude::*;

/// Equal masses and springs between walls. Both ends are in heat baths.
#[derive(Clone, Copy)]
pub(crate) struct Chain {
    /// Number of sites.
    pub(crate) sites: usize,
    /// Strength of the pinning `q⁴/4` of each site.
    pub(crate) pinning: f64,
    /// Rate of the friction at both ends.
    pub(crate) rate: f64,
    /// Temperatures of the baths at the first and at the last site.
    pub(crate) baths: [f64; 2],
}

/// `Obabo` has exact mean squares of momenta for oscillators in equilibrium.
#[hamiltonian(compose = Obabo, split = kinetic + potential + friction)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.5 * (q[0].powi(2) + q[q.len() - 1].powi(2));
        for i in 0..q.len() - 1 {
            energy += 0.5 * (q[i + 1] - q[i]).powi(2);
        }
        for i in 0..q.len() {
            energy += 0.25 * self.pinning * q[i].powi(4);
        }
        energy
    }
    #[friction]
    fn friction(&self, i: usize) -> f64 {
        if i == 0 || i + 1 == self.sites { self.rate } else { 0.0 }
    }
    #[temperature]
    fn temperature(&self, i: usize) -> f64 {
        if i == 0 { self.baths[0] } else { self.baths[1] }
    }
}

/// A mean and its standard error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mean {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

impl Mean {
    /// Returns the mean of independent values.
    pub(crate) fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let count = values.clone().count() as f64;
        let value = values.clone().sum::<f64>() / count;
        let variance = values.map(|x| (x - value).powi(2)).sum::<f64>() / (count - 1.0);
        Self { value, error: (variance / count).sqrt() }
    }
}

/// Means over the stationary state.
pub(crate) struct Stationary {
    /// Mean square of the momentum of each site.
    pub(crate) temperatures: Vec<Mean>,
    /// Heat current through a bond, the mean over all bonds.
    pub(crate) current: Mean,
    /// Ratio of the current to the temperature gradient, by a straight line through the chain without an eighth at each end.
    pub(crate) conductivity: Mean,
}

/// Length of a step, and steps between two samples.
pub(crate) const STEP: f64 = 0.1;
const INTERVAL: u64 = 5;

/// Integrates independent copies of the chain. Each one gives a mean over `samples` times, after it has settled for `settling`
/// steps.
pub(crate) fn stationary(chain: Chain, copies: usize, settling: u64, samples: u64) -> Result<Stationary, Error> {
    let start = Phase::new(vec![0.0; chain.sites], vec![0.0; chain.sites]);
    let mut ensemble = Ensemble::new(Obabo, (0..copies).map(|_| (chain, start.clone())), STEP)?.with_seed(1967);
    ensemble.advance(settling)?;
    let mut squares = vec![vec![0.0; chain.sites]; copies];
    let mut currents = vec![0.0; copies];
    for _ in 0..samples {
        ensemble.advance(INTERVAL)?;
        for ((state, squares), current) in ensemble.states().zip(&mut squares).zip(&mut currents) {
            let Phase { q, p } = &state;
            squares.iter_mut().zip(p).for_each(|(sum, p)| *sum += p * p / samples as f64);
            // The work of the spring between two sites is that of its force at their mean velocity.
            let bonds = q.windows(2).zip(p.windows(2)).map(|(q, p)| -0.5 * (p[0] + p[1]) * (q[1] - q[0]));
            *current += bonds.sum::<f64>() / (samples * (chain.sites as u64 - 1)) as f64;
        }
    }
    let temperatures = (0..chain.sites).map(|site| Mean::of(squares.iter().map(|squares| squares[site]))).collect();
    let current = Mean::of(currents.iter().copied());
    let slopes = squares.iter().map(|squares| slope(&squares[chain.sites / 8..chain.sites - chain.sites / 8]));
    let (slope, value) = (Mean::of(slopes), current.value);
    let relative = (current.error / value).hypot(slope.error / slope.value);
    let conductivity = Mean { value: -value / slope.value, error: (relative * value / slope.value).abs() };
    Ok(Stationary { temperatures, current, conductivity })
}

/// Returns the slope of the line with the least squares through values at integers.
fn slope(values: &[f64]) -> f64 {
    let centre = 0.5 * (values.len() as f64 - 1.0);
    let places = || (0..values.len()).map(|i| i as f64 - centre);
    places().zip(values).map(|(x, y)| x * y).sum::<f64>() / places().map(|x| x * x).sum::<f64>()
}

/// Returns current and temperatures of the harmonic chain in closed form (Rieder, Lebowitz and Lieb 1967).
pub(crate) fn harmonic(Chain { sites, rate, baths: [hot, cold], .. }: Chain) -> (f64, Vec<f64>) {
    let (mean, half) = (0.5 * (hot + cold), 0.5 * (hot - cold));
    let ratio = rate.powi(-2);
    let decay = -(1.0 + 0.5 * ratio - (ratio + 0.25 * ratio * ratio).sqrt()).ln();
    let phi = |j: usize| ((sites - j) as f64 * decay).sinh() / (sites as f64 * decay).sinh();
    let deviation = |from_end: usize| match from_end {
        0 => half * (1.0 - ratio * phi(1)),
        _ => -ratio * half * phi(2 * from_end + 1),
    };
    let temperature = |site: usize| match (site, sites - 1 - site) {
        (left, right) if left < right => mean + deviation(left),
        (left, right) if left > right => mean - deviation(right),
        _ => mean,
    };
    (half * ratio * rate * phi(1), (0..sites).map(temperature).collect())
}
