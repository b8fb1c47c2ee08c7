//! The weights of the coefficients of accelerations at the end of a step: with `a = Σ aₖ tᵏ`, velocities gain
//! `Σ aₖ tᵏ⁺¹/(k+1)`, positions what the velocity takes them and `Σ aₖ tᵏ⁺²/((k+1)(k+2))`.

use super::course::HIGHEST;
use crate::vector::Row;

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

/// Lane `l` of these is one where `l + 1` has the bit 1, 2, 4 or 8.
const BITS: [[f64; 8]; 4] = [
    [1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0],
    [0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
];

/// `x` in the lanes of a bit, one in the others.
#[inline(always)]
fn factor<R: Row>(x: R, bit: usize) -> R {
    let lanes = R::load(&BITS[bit]);
    lanes.fma(x, R::splat(1.0) - lanes)
}

impl Weights {
    /// Those of a step.
    #[inline(always)]
    pub(crate) fn of<R: Row>(t: f64) -> Self {
        let square = t * t;
        let fourth = square * square;
        let (step, eighth) = (R::splat(t), R::splat(fourth * fourth));
        let mut powers =
            factor(step, 0) * factor(R::splat(square), 1) * (factor(R::splat(fourth), 2) * factor(eighth, 3));
        let mut weights = Self { once: [0.0; HIGHEST], twice: [0.0; HIGHEST] };
        for first in (0..HIGHEST).step_by(8) {
            (powers * R::load(&INTEGRALS.once[first..])).store(&mut weights.once[first..]);
            (powers * step * R::load(&INTEGRALS.twice[first..])).store(&mut weights.twice[first..]);
            powers = powers * eighth;
        }
        weights
    }
}
