//! Metropolis steps: proposals by a composition with noise, accepted or rejected, so that the step has no bias.

use super::scheme::FrictionScheme;
use crate::{
    error::Error,
    scalar::noise::gaussians,
    state::{coords::Coords, phase::StartOf, precision::Precision},
    system::{Shaped, dissipation::WithFriction},
    trajectory::{method::Method, run::Run},
};
use core::ops::Neg;

/// The first word of the counters of the numbers that decide on acceptance. No pair of coordinates has it.
const DECISION: u32 = u32::MAX;
/// What the seed changes by after each rejection: 2⁶⁴ over the golden ratio.
const AFTER_REJECTION: u64 = 0x9e37_79b9_7f4a_7c15;

/// A Markov chain whose steps are those of a composition with noise, accepted or rejected: generalised hybrid Monte Carlo.
///
/// A step is accepted with the probability `min(1, exp(-W/kT))`, where `W` is its shadow work: the change of the energy
/// without the heat of `O`. A rejected step leaves the positions and reverses the momenta. The canonical distribution
/// `exp(-H/kT)` is invariant at any step; without rejections there is a bias by the step, which
/// `check::oscillator_equilibrium` states for harmonic motion.
///
/// Sources: A. M. Horowitz, Phys. Lett. B 268, 247 (1991); N. Bou-Rabee and E. Vanden-Eijnden, Comm. Pure Appl. Math. 63, 655
/// (2010); D. A. Sivak, J. D. Chodera and G. E. Crooks, Phys. Rev. X 3, 011007 (2013) for sequences other than `Obabo`.
///
/// ```
/// use integrator_core::prelude::*;
///
/// /// The distribution exp(-q⁴/4).
/// struct Quartic;
///
/// #[hamiltonian(split = kinetic + potential + friction)]
/// impl Quartic {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(4) / 4.0 }
///     #[friction]
///     fn friction(&self, _i: usize) -> f64 { 1.0 }
///     #[temperature]
///     fn temperature(&self, _i: usize) -> f64 { 1.0 }
/// }
///
/// let mut chain = Quartic.metropolised(Obabo, Phase::new([0.0_f64], [0.0]), 0.5)?.with_seed(7);
/// let mut square = 0.0;
/// for _ in 0..20_000 {
///     chain.advance(1)?;
///     square += chain.run().state().q[0].powi(2) / 20_000.0;
/// }
/// // <q²> = 2 Γ(3/4)/Γ(1/4)
/// assert!((square - 0.676).abs() < 0.05);
/// assert!(chain.accepted() > 18_000 && chain.accepted() < chain.steps());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct Metropolised<C: Coords> {
    run: Run<C>,
    /// The energy of the present state.
    energy: f64,
    temperature: f64,
    seed: u64,
    steps: u64,
    accepted: u64,
}

/// Systems with a temperature, whose canonical distribution [`Metropolised`] chains sample.
pub trait Metropolis: WithFriction {
    /// Starts a chain from `start` with the step `h`, whose proposals are steps of a composition with the letter `O`.
    ///
    /// # Errors
    /// As [`Hamiltonian::run`](crate::Hamiltonian::run); [`Error::NoTemperature`]; [`Error::NotMetropolised`] if the composition is
    /// not symmetric, the coordinates have different temperatures, or `H`, the friction or the temperature depends on time.
    fn metropolised<K, X>(
        &self,
        composition: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
    ) -> Result<Metropolised<Shaped<Self, K>>, Error>
    where
        K: Precision + Neg<Output = K>,
        X: FrictionScheme + Method<Self>,
    {
        let refused = |requirement, help| Err(Error::NotMetropolised { requirement, help });
        if !X::SYMMETRIC {
            return refused("a symmetric composition", "use one such as `Obabo` or `Baoab`");
        }
        if !Self::AUTONOMOUS || Self::READS_TIME {
            return refused("a system that does not depend on time", "use `run_with`, whose steps follow the time");
        }
        let start = start.into_phase();
        let length = start.q.length();
        let mut run = Run::start::<Self, X, K>(self, composition, start, h)?;
        run.measure_heat(true);
        run.heat()?;
        let temperature = |index| self.stated_rates(index, 0.0)[1];
        let first = temperature(0);
        if !(first > 0.0 && (1..length).all(|index| temperature(index) == first)) {
            return refused("one positive temperature for all coordinates", "return the same number for each index");
        }
        Ok(Metropolised { energy: run.energy(), run, temperature: first, seed: 0, steps: 0, accepted: 0 })
    }
}

impl<H: WithFriction> Metropolis for H {}

impl<C: Coords<Leaf: Neg<Output = C::Leaf>>> Metropolised<C> {
    /// Sets the seed of the random numbers; the default is 0.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { run: self.run.with_seed(seed), seed, ..self }
    }

    /// Takes `steps` steps, accepted or not.
    ///
    /// A step whose end is not finite is rejected.
    ///
    /// # Errors
    /// As [`Run::advance`], except [`Error::Diverged`]. The chain stays at its last state.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        for _ in 0..steps {
            self.step()?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<(), Error> {
        let (before, heat) = (self.run.state(), self.run.heat()?);
        let (energy, absorbed) = match self.run.advance(1) {
            Ok(()) => (self.run.energy(), self.run.heat()? - heat),
            Err(Error::Diverged(_)) => (f64::INFINITY, 0.0),
            Err(error) => return Err(error),
        };
        self.steps += 1;
        if (energy - self.energy - absorbed) / self.temperature <= self.exponential() {
            (self.energy, self.accepted) = (energy, self.accepted + 1);
            return Ok(());
        }
        self.run.map_state(|state| *state = before.reversed())?;
        // A step that failed left the time of the run, and with it the random numbers of the next one.
        let rejected = self.steps - self.accepted;
        let seed = self.seed.wrapping_add(rejected.wrapping_mul(AFTER_REJECTION));
        self.run.engine.change_draws(&|draws| draws.seed = seed);
        Ok(())
    }

    /// An exponentially distributed number of the mean 1 for the present step: half of the sum of two normal squares.
    fn exponential(&self) -> f64 {
        let [key, counter] = [self.seed, self.steps].map(|word| [word as u32, (word >> 32) as u32]);
        let [one, other] = gaussians::<f64>(key, |_: usize| [DECISION, 0, counter[0], counter[1]]);
        (one * one + other * other) / 2.0
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Returns the number of steps that were accepted.
    pub fn accepted(&self) -> u64 {
        self.accepted
    }

    /// Returns the run of the chain, with its state and its energy. The time of the run has no meaning.
    pub fn run(&self) -> &Run<C> {
        &self.run
    }
}
