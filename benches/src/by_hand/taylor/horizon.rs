//! Step size with the rule of the generated code: `h = min (ε S / |cₘ|)^(1/m)` over the last two orders `m` of
//! positions and of momenta. The bits of positive doubles approximate their logarithms.

/// The bits of 1.0.
const ONE: i64 = 1023 << 52;

/// The largest coefficients of one part of the state.
#[derive(Clone, Copy)]
pub(crate) struct Sizes {
    /// Size at order 0.
    pub(crate) value: f64,
    /// Size at order 1.
    pub(crate) slope: f64,
    /// Size at the second last order.
    pub(crate) before: f64,
    /// Size at the last order.
    pub(crate) last: f64,
}

/// Returns the step size for polynomials of order `N` from the sizes of positions and momenta.
#[inline(always)]
pub(crate) fn reach<const N: usize>(tolerance: f64, parts: [Sizes; 2]) -> f64 {
    let tolerance = bits(tolerance) - ONE;
    let [q, p] = parts.map(|Sizes { value, slope, before, last }| {
        let [value, slope, before, last] = [value, slope, before, last].map(bits);
        // Contribution of the first derivative within the convergence radius estimated from a high coefficient.
        let grown = slope + (slope - before.max(last)) / (N as i64 - 1);
        let share = tolerance + value.max(grown);
        ((share - before) / (N as i64 - 1)).min((share - last) / N as i64)
    });
    f64::from_bits((ONE + q.min(p)) as u64)
}

#[inline(always)]
fn bits(x: f64) -> i64 {
    x.to_bits() as i64
}
