//! Polynomials with a short dependency chain.

use super::course::{COEFFICIENTS, HIGHEST};
use crate::vector::Vector;

/// `Σ cₖ xᵏ` over the orders from 1 to `N`, by pairs, pairs of pairs and so on (Estrin 1960).
#[inline(always)]
pub(crate) fn estrin<V: Vector, const N: usize>(coefficients: &[V; COEFFICIENTS], x: V) -> V {
    let mut terms = [V::splat(0.0); HIGHEST / 2];
    for i in 0..N / 2 {
        terms[i] = coefficients[2 * i + 2].fma(x, coefficients[2 * i + 1]);
    }
    let (count, power) = halve(&mut terms, N / 2, x * x);
    let (count, power) = halve(&mut terms, count, power);
    let (count, power) = halve(&mut terms, count, power);
    halve(&mut terms, count, power);
    terms[0] * x
}

#[inline(always)]
fn halve<V: Vector>(terms: &mut [V; HIGHEST / 2], count: usize, x: V) -> (usize, V) {
    for i in 0..count / 2 {
        terms[i] = terms[2 * i + 1].fma(x, terms[2 * i]);
    }
    if count % 2 == 1 {
        terms[count / 2] = terms[count - 1];
    }
    (count.div_ceil(2), x * x)
}
