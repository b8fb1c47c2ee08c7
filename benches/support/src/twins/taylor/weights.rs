//! The weights of the coefficients of accelerations at the end of a step: with `a = Σ aₖ tᵏ`, velocities gain
//! `Σ aₖ tᵏ⁺¹/(k+1)`, positions what the velocity takes them and `Σ aₖ tᵏ⁺²/((k+1)(k+2))`.

use super::course::HIGHEST;

/// Of accelerations, by their order.
pub(crate) struct Weights {
    /// In velocities.
    pub(crate) once: [f64; HIGHEST],
    /// In positions.
    pub(crate) twice: [f64; HIGHEST],
}

/// `1/(k+1)` and `1/((k+1)(k+2))`.
pub(crate) const INTEGRALS: Weights = {
    let mut integrals = Weights { once: [0.0; HIGHEST], twice: [0.0; HIGHEST] };
    let mut k = 0;
    while k < HIGHEST {
        integrals.once[k] = 1.0 / (k + 1) as f64;
        integrals.twice[k] = 1.0 / ((k + 1) * (k + 2)) as f64;
        k += 1;
    }
    integrals
};

impl Weights {
    /// Those of a step.
    #[inline(always)]
    pub(crate) fn of(t: f64) -> Self {
        // Eight powers at a time: four products from the first to the last.
        let square = t * t;
        let fourth = square * square;
        let mut powers =
            [t, square, square * t, fourth, fourth * t, fourth * square, fourth * (square * t), fourth * fourth];
        let eighth = powers[7];
        let mut weights = Self { once: [0.0; HIGHEST], twice: [0.0; HIGHEST] };
        for first in (0..HIGHEST).step_by(8) {
            for (place, power) in powers.iter_mut().enumerate() {
                weights.once[first + place] = *power * INTEGRALS.once[first + place];
                weights.twice[first + place] = *power * t * INTEGRALS.twice[first + place];
                *power *= eighth;
            }
        }
        weights
    }
}
