//! The drive: how fast `H` changes by the time that it reads.
//!
//! In: a system, a state, a time span. Out: how often `H` turns within the span while the state stays. Always true: an
//! oscillation turns twice in each period, and neither rounding nor a hundredth of the range is a turn.

use crate::{
    check::{
        CheckError,
        property::energies::{Differentiable, Energies, Part},
        start::IntoStart,
        statistics::{GOLDEN, points::begin},
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::largest,
    state::{
        flat::{Flat, flat},
        precision::Precision,
    },
    system::Shaped,
};

/// The number of times at which `H` is read. They are not equally spaced, so that an oscillation does not look like a
/// slower one.
const SAMPLES: u32 = 1024;

/// The share of its range by which `H` has to come back for a turn.
const TURN: f64 = 0.01;

/// Counts how often `H` rises and falls in turns within `span` by its explicit time, at the state of `start`.
///
/// An oscillation turns twice in each period. If there is more than one turn to a step, the step is longer than half
/// the period, and no method follows the motion. The count is correct up to some hundred turns, and large beyond.
///
/// ```
/// use integrator_core::{check::turns_in_time, prelude::*};
///
/// struct Shaken;
///
/// #[hamiltonian]
/// impl Shaken {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1], t: f64) -> f64 { -(1.0 + (20.0 * t).cos()) * q[0].cos() }
/// }
///
/// // At 3, 6, 9, ... twentieths of π.
/// assert_eq!(turns_in_time(&Shaken, Phase::new([1.0], [0.0]), 1.0)?, 6);
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// The start or the span is invalid for a run.
pub fn turns_in_time<H: Hamiltonian, K: Precision>(
    system: &H,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    span: f64,
) -> Result<u64, CheckError> {
    let start = begin::<H, _, K>(system, H::Compose::default(), &start.into_start(), span)?;
    if H::AUTONOMOUS {
        return Ok(0);
    }
    Ok(turns(&Energies::new(system, &start.phase), &flat(&start.phase), start.time, span))
}

/// [`turns_in_time`] of a state and a time.
pub(crate) fn turns(system: &dyn Differentiable, state: &Flat, time: f64, span: f64) -> u64 {
    let sample = |index: u32| {
        let share = (f64::from(index) + (GOLDEN * f64::from(index)).fract()) / f64::from(SAMPLES);
        let energies = Part::BOTH.map(|part| system.bounded_energy(part, state, time + share * span));
        [energies[0][0] + energies[1][0], energies[0][1] + energies[1][1]]
    };
    let samples: Vec<[f64; 2]> = (0..SAMPLES).map(sample).collect();
    let range = largest(samples.iter().map(|sample| sample[0] - samples[0][0]));
    let rounding = 2.0 * largest(samples.iter().map(|sample| sample[1]));
    turns_of(samples.iter().map(|sample| sample[0]), f64::max(TURN * range, rounding))
}

/// Counts the turns of a curve by more than a threshold.
fn turns_of(curve: impl Iterator<Item = f64>, threshold: f64) -> u64 {
    let (mut turns, mut rises, mut low, mut high) = (0, None, f64::INFINITY, f64::NEG_INFINITY);
    for value in curve {
        (low, high) = (value.min(low), value.max(high));
        let rising = match rises {
            Some(true) | None if high - value > threshold => false,
            Some(false) | None if value - low > threshold => true,
            _ => continue,
        };
        turns += u64::from(rises.is_some());
        (rises, low, high) = (Some(rising), value, value);
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::turns_of;

    #[test]
    fn a_curve_turns_twice_in_each_oscillation() {
        let turns = |of: fn(f64) -> f64| turns_of((0..4096).map(|index| of(f64::from(index) / 4096.0)), 0.01);
        let square = |t: f64| if (5.0 * t).fract() < 0.5 { 1.0 } else { 2.0 };
        let found = [turns(|t| (80.0 * core::f64::consts::PI * t).cos()), turns(|t| 3.0 + t * t), turns(square)];
        assert_eq!(found, [79, 0, 8]);
        assert_eq!(turns(|t| 1.0 + 0.004 * (1e3 * t).sin()), 0, "below the threshold");
    }
}
