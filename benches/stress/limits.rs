//! Steps across the stability limit of each composition, on a chain with a known highest frequency.

use integrator_core::{Visitor, check::stability, prelude::*};
use std::f64::consts::PI;

const SITES: usize = 4;

/// Springs between neighbours and to the walls; the fastest mode has the frequency 1.
struct Chain {
    stiffness: f64,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: [f64; SITES]) -> f64 {
        let mut energy = 0.0;
        for i in 0..SITES {
            energy += p[i] * p[i] / 2.0;
        }
        energy
    }
    fn potential(&self, q: [f64; SITES]) -> f64 {
        let mut energy = q[0] * q[0] + q[SITES - 1] * q[SITES - 1];
        for i in 0..SITES - 1 {
            energy += (q[i + 1] - q[i]).powi(2);
        }
        self.stiffness / 2.0 * energy
    }
}

/// Largest ratio of the energies of the second half of a run to those of the first half without growth. Beats close to
/// the limit are slow.
const GROWN: f64 = 10.0;

/// Number of energy samples in each half.
const LOOKS: u64 = 64;

/// Result of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// The energy is bounded.
    Bounded,
    /// The run returned an error.
    Reported,
    /// The energy grew, and `check::stability` warns of this step.
    Warned,
    /// The energy grew without any report.
    Silent,
}

/// One composition with one step.
#[derive(Debug)]
pub(crate) struct Trial {
    pub(crate) composition: &'static str,
    /// `h·ω` of the fastest mode.
    pub(crate) angle: f64,
    /// Largest stable `h·ω` of the composition.
    pub(crate) limit: f64,
    pub(crate) outcome: Outcome,
}

impl Trial {
    /// Returns whether the result is wrong: an instability below the limit, or one without any report.
    pub(crate) fn is_wrong(&self) -> bool {
        self.outcome == Outcome::Silent || (self.angle < self.limit && self.outcome != Outcome::Bounded)
    }
}

/// Runs all compositions with the steps `angles`.
pub(crate) fn trials(angles: &[f64], steps: u64) -> Vec<Trial> {
    let fastest = 2.0 * (PI * SITES as f64 / (2 * SITES + 2) as f64).sin();
    let mut sweep = Sweep { chain: Chain { stiffness: fastest.powi(-2) }, angles, steps, trials: Vec::new() };
    Chain::visit_compositions(&mut sweep);
    sweep.trials
}

struct Sweep<'t> {
    chain: Chain,
    angles: &'t [f64],
    steps: u64,
    trials: Vec<Trial>,
}

impl Visitor<Chain> for Sweep<'_> {
    fn visit<X: Composition<Chain>>(&mut self, composition: X) {
        for &angle in self.angles {
            let outcome = outcome(&self.chain, composition, angle, self.steps);
            self.trials.push(Trial { composition: X::NAME, angle, limit: X::STABILITY_LIMIT, outcome });
        }
    }
}

fn outcome<X: Composition<Chain>>(chain: &Chain, composition: X, h: f64, steps: u64) -> Outcome {
    let start = Phase::new([1.0, -0.3, 0.2, 0.5], [0.1, 0.4, -0.2, 0.3]);
    let grew = || -> Result<bool, Error> {
        let mut run = chain.run_with(composition, start, h)?;
        let mut half = || -> Result<f64, Error> {
            let mut largest = run.energy();
            for _ in 0..LOOKS {
                run.advance(steps / (2 * LOOKS))?;
                largest = largest.max(run.energy());
            }
            Ok(largest)
        };
        Ok(half()? * GROWN < half()?)
    };
    match grew() {
        Ok(false) => Outcome::Bounded,
        Err(_) => Outcome::Reported,
        Ok(true) if stability(chain, composition, start, h).is_ok_and(|stability| stability.is_near()) => {
            Outcome::Warned
        }
        Ok(true) => Outcome::Silent,
    }
}
