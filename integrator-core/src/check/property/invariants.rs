//! Declared invariants: `#[invariant]`.
//!
//! In: a system with invariants and some states. Out: the Poisson bracket of each with `H`, and its deviation during a
//! run. Always true: the bracket is a property of the system and not of a method, computed by exact derivatives of the
//! generated code. The deviation during a run is measured but not judged, since a step conserves only what each of its
//! flows conserves.

use super::energies::{Differentiable, Part, slopes};
use crate::{
    check::{
        CheckError,
        start::Start,
        statistics::points::{coordinate, numbers, origin, resolution, run},
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, ratio},
    state::{flat::Flat, precision::Precision},
    system::Shaped,
    trajectory::method::Method,
};
use std::fmt;

/// The largest bracket that rounding explains, in units of its terms: half of the digits allow for any sum that is of
/// use, and a function that is not conserved has a bracket of the size of its terms.
const TOLERANCE: f64 = 1.0 / (1_u64 << 26) as f64;

/// The number of samples of a longer run.
const SAMPLES: u64 = 1024;

/// The measurements of one function that the system declares as conserved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct InvariantDrift {
    /// The name of the function.
    pub name: &'static str,
    /// The largest Poisson bracket with `H` at the start and along the orbit, in units of its terms.
    pub bracket: f64,
    /// The largest deviation from the start during a run, in units of the largest `Σ |x ∂I/∂x|`.
    pub deviation: f64,
    /// The part of the deviation that rounding explains.
    pub rounding: f64,
    /// The number of steps of the run.
    pub steps: u64,
}

impl InvariantDrift {
    /// Whether rounding explains the Poisson bracket with `H`.
    pub fn is_conserved(&self) -> bool {
        self.bracket <= TOLERANCE
    }
}

impl fmt::Display for InvariantDrift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, bracket, deviation, rounding, steps } = self;
        write!(f, "{name}: bracket with H {bracket:.1e}; deviates by {deviation:.1e} in {steps} steps ")?;
        write!(f, "(rounding tolerance {rounding:.1e})")
    }
}

/// The Poisson bracket of an invariant with H at a state, in units of its terms. Where no term is left, as for the
/// momentum of a free particle, it is zero.
pub(crate) fn bracket(system: &dyn Differentiable, number: usize, state: &Flat, time: f64) -> Result<f64, CheckError> {
    let [kinetic, potential] = Part::BOTH.map(|part| slopes(system, part, state, time));
    let of_energy: Vec<f64> = kinetic.iter().zip(potential).map(|(kinetic, potential)| kinetic + potential).collect();
    let of_invariant = slopes_of(system, number, state);
    if of_invariant.iter().all(|slope| *slope == 0.0) {
        return Err(CheckError::ConstantInvariant { name: system.invariants()[number] });
    }
    let half = state.q.len();
    let (mut sum, mut size) = (0.0, 0.0);
    for index in 0..half {
        let forth = of_invariant[index] * of_energy[half + index];
        let back = of_invariant[half + index] * of_energy[index];
        sum += forth - back;
        size += forth.abs() + back.abs();
    }
    let bracket = ratio(sum, size);
    if bracket.is_nan() {
        Err(CheckError::NotFinite { what: "the bracket of an invariant with H" })
    } else {
        Ok(bracket.abs())
    }
}

/// The derivatives of an invariant by all coordinates.
fn slopes_of(system: &dyn Differentiable, number: usize, state: &Flat) -> Vec<f64> {
    let still = origin(state);
    let slope = |index: usize| {
        let mut along = still.clone();
        *coordinate(&mut along, index) = 1.0;
        system.invariant(number, state, Some(&along))
    };
    (0..2 * state.q.len()).map(slope).collect()
}

/// `Σ |x ∂I/∂x|`: what an invariant is made of, where its own value may be zero.
pub(crate) fn scale(system: &dyn Differentiable, number: usize, state: &Flat) -> f64 {
    slopes_of(system, number, state).iter().zip(numbers(state)).map(|(slope, number)| (slope * number).abs()).sum()
}

/// The deviation of invariants in a run.
pub(crate) struct Strayed {
    pub(crate) deviations: Vec<f64>,
    pub(crate) steps: u64,
    /// The relative deviation that rounding explains.
    pub(crate) rounding: f64,
}

/// Follows all invariants over this number of steps.
pub(crate) fn strayed<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
    steps: u64,
) -> Result<Strayed, CheckError> {
    let mut run = run::<H, X, K>(system, method, start, h)?;
    let interval = steps.div_ceil(SAMPLES);
    let energies = run.energies();
    let values =
        |state| (0..H::INVARIANTS.len()).map(|number| energies.invariant(number, &state)).collect::<Vec<f64>>();
    let first = values(run.state());
    let mut deviations = vec![0.0; first.len()];
    for _ in 0..steps / interval {
        run.advance(interval)?;
        for ((deviation, first), value) in deviations.iter_mut().zip(&first).zip(values(run.state())) {
            *deviation = largest([*deviation, value - first]);
        }
    }
    // The walk of the state by roundings, as that of the energy.
    let rounding = 16.0 * resolution(&[&start.phase, &run.state()]) * method.facts().roundings_in(run.steps()).sqrt();
    Ok(Strayed { deviations, steps: run.steps(), rounding })
}
