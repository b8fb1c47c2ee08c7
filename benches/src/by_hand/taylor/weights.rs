//! Weights of the coefficients of accelerations at the end of a step. With `a = Σ aₖ tᵏ`, velocities change by
//! `Σ aₖ tᵏ⁺¹/(k+1)`, and positions by `v t + Σ aₖ tᵏ⁺²/((k+1)(k+2))`.

use super::course::HIGHEST;
use crate::vector::Row;

/// Weights of the coefficients of accelerations, by order.
pub(crate) struct Weights {
    /// Weights in velocities.
    pub(crate) once: [f64; HIGHEST],
    /// Weights in positions.
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

/// Row `b` contains 1 in lane `l` if bit `b` of `l + 1` is set.
const BITS: [[f64; 8]; 4] = [
    [1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0],
    [0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
];

/// Returns `x` in the lanes with this bit, and 1 in the others.
#[inline(always)]
fn factor<R: Row>(x: R, bit: usize) -> R {
    let lanes = R::load(&BITS[bit]);
    lanes.fma(x, R::splat(1.0) - lanes)
}

impl Weights {
    /// Returns the weights for a step `t`.
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
