//! The change of the main frequency between the halves of a series.

use super::line::frequencies;
use crate::check::CheckError;

/// The main frequency of a function, and its change between the first and the second half of the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Drift {
    /// The frequency with the largest amplitude in all samples, in radians per unit of time.
    pub frequency: f64,
    /// The same of the first and the second half.
    pub halves: [f64; 2],
}

impl Drift {
    /// Returns the change between both halves, in radians per unit of time.
    ///
    /// It is of the order of the accuracy of the analysis on regular orbits, and larger on chaotic ones.
    pub fn change(&self) -> f64 {
        (self.halves[1] - self.halves[0]).abs()
    }

    /// Returns the diffusion indicator, the decimal logarithm of [`change`](Self::change); `-∞` if it is zero.
    pub fn diffusion(&self) -> f64 {
        self.change().log10()
    }
}

/// Computes the main frequency of samples `[real, imaginary]` at equal intervals, and its drift between both halves.
///
/// The change of frequency measures diffusion in phase space (Laskar 1993, Physica D 67, 257). For a real function,
/// all frequencies are positive. The frequencies of a function that is zero are zero.
///
/// # Errors
/// Those of [`frequencies()`]; each half requires 32 samples.
pub fn drift(samples: &[[f64; 2]], interval: f64) -> Result<Drift, CheckError> {
    // The terms of both signs are equal, and rounding would choose one of them.
    let is_real = samples.iter().all(|[_, imaginary]| *imaginary == 0.0);
    let main = |samples: &[[f64; 2]]| -> Result<f64, CheckError> {
        let frequency = frequencies(samples, interval, 1)?.first().map_or(0.0, |line| line.frequency);
        Ok(if is_real { frequency.abs() } else { frequency })
    };
    let (first, second) = samples.split_at(samples.len() / 2);
    Ok(Drift { halves: [main(first)?, main(second)?], frequency: main(samples)? })
}
