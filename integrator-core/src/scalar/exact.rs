//! Error-free transformations: sums, products and quotients with the rounding errors that they lose, and powers of two.

use crate::scalar::{functions::Bits, real::Real};

/// Two-sum (Knuth 1969): the sum and its rounding error, exactly.
#[inline(always)]
pub(crate) fn two_sum<R: Real>(a: R, b: R) -> [R; 2] {
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

/// Fast two-sum (Dekker 1971): the sum and its rounding error, exactly where `large` is zero or not the smaller one.
#[inline(always)]
pub(crate) fn fast_two_sum<R: Real>(large: R, small: R) -> [R; 2] {
    let sum = large + small;
    [sum, small - (sum - large)]
}

/// Two-product (Dekker 1971): the product and its rounding error, exactly where `fma` rounds once.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn two_product<R: Bits<Scalar: Parts>>(a: R, b: R) -> [R; 2] {
    let product = a * b;
    [product, if R::FUSED { a.fma(b, -product) } else { -less_product(product, a, b) }]
}

/// The constants that split and invert numbers of one format.
pub(crate) trait Parts: Sized {
    /// The bits of the upper half of a number: the product of two such halves is exact.
    const UPPER: u64;
    /// From this pattern that of a number is subtracted for its reciprocal, off by 5 % at most.
    const RECIPROCAL: u64;
}

impl Parts for f64 {
    const UPPER: u64 = !0 << 27;
    const RECIPROCAL: u64 = 0x7fde_624d_d2f1_a9fb;
}

impl Parts for f32 {
    const UPPER: u64 = !0 << 12;
    const RECIPROCAL: u64 = 0x7ef3_126e;
}

/// The two halves of a number.
#[cfg_attr(not(debug_assertions), inline(always))]
fn halves<R: Bits<Scalar: Parts>>(a: R) -> [R; 2] {
    let upper = a.bits_and(R::pattern(R::Scalar::UPPER));
    [upper, a - upper]
}

/// `c - a·b`, which is exact, but for the bits beyond those of a number, where `c` is next to the product.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn less_product<R: Bits<Scalar: Parts>>(c: R, a: R, b: R) -> R {
    if R::FUSED {
        (-a).fma(b, c)
    } else {
        let ([a, small_a], [b, small_b]) = (halves(a), halves(b));
        (((c - a * b) - a * small_b) - small_a * b) - small_a * small_b
    }
}

/// The difference of the patterns as integers.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn pattern_less<R: Bits>(pattern: u64, x: R) -> R {
    x.bits_xor(R::pattern(!0)).bits_add(R::pattern(pattern.wrapping_add(1)))
}

/// The rounding error of the quotient of `a` and `b`, to a few digits.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn lost_by_quotient<R: Bits<Scalar: Parts>>(quotient: R, a: R, b: R) -> R {
    less_product(a, quotient, b) * pattern_less(R::Scalar::RECIPROCAL, b)
}

/// The number of bits of a number below those of its exponent.
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;

/// The stored exponent of one.
const BIAS: i32 = f64::MAX_EXP - 1;

/// Returns the exponent of the power of two at or below a magnitude, clamped so that this power and its reciprocal are
/// normal numbers.
#[inline(always)]
pub(crate) fn exponent(magnitude: f64) -> i32 {
    ((magnitude.to_bits() >> MANTISSA) as i32 - BIAS).clamp(1 - BIAS, BIAS - 1)
}

/// Returns the power of two with an exponent as [`exponent`] returns it.
#[inline(always)]
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + BIAS) as u64) << MANTISSA)
}

#[cfg(test)]
mod tests {
    use super::{exponent, power_of_two};

    #[test]
    fn powers_of_two_are_at_or_below_their_magnitude() {
        for exact in [-1022, -300, -1, 0, 1, 52, 300, 1022] {
            let power = 2.0_f64.powi(exact);
            assert_eq!([power, 1.99 * power].map(exponent), [exact; 2]);
            assert_eq!(power_of_two(exact), power);
        }
        for extreme in [0.0, 5e-324, f64::MAX, f64::INFINITY, f64::NAN] {
            let power = power_of_two(exponent(extreme));
            assert!(power.is_normal() && power.recip().is_normal(), "{extreme}: {power:e}");
        }
    }
}
