//! The remainder of a division, `x - n y` with `n = trunc(x / y)`, exact as that of `std`.
//!
//! The quotient is rounded, so `n` may be one too large if `x / y` is just below an integer; never too small, since rounding is
//! monotone. Both `x - n y` and the same with one more `y` are numbers: multiples of the last place of `x` or `y`, and not
//! larger than `y`. So a fused multiply-add computes the first, and a sum the second, without rounding.

use super::{Bits, with_fallback_of_two};
use crate::scalar::{elementary::Elementary, real::Mask};

/// The remainder in one format.
pub(crate) trait Remainder: Sized {
    /// From here on, quotients are rounded to integers or more.
    const LARGEST_QUOTIENT: f64;

    /// The function of the maths library, for other quotients.
    fn fallback(numbers: &mut [Self], divisors: &[Self]);
}

/// The remainder of `x / y`, with the sign of `x`; exact.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn remainder<R: Bits<Scalar: Remainder>>(x: R, y: R) -> R {
    let fallback = <R::Scalar as Remainder>::fallback;
    // Without a fused multiply-add, the product is rounded.
    if !R::FUSED {
        return x.zip_scalars(y, fallback);
    }
    let (quotient, divisor, sign) = (x / y, y.abs(), x.bits_and(R::of(-0.0)));
    let rest = (-quotient.trunc()).fma(y, x).bits_xor(sign);
    let size = R::select(rest.less(R::of(0.0)), rest + divisor, rest);
    let value = size.abs().bits_xor(sign);
    let has_fraction = quotient.abs().less(R::of(R::Scalar::LARGEST_QUOTIENT));
    with_fallback_of_two(value, has_fraction.and(divisor.less(R::of(f64::INFINITY))), [x, y], fallback)
}

macro_rules! remainder_of {
    ($scalar:ident, $digits:literal) => {
        impl Remainder for $scalar {
            const LARGEST_QUOTIENT: f64 = (1_u64 << $digits) as f64;

            #[cold]
            #[inline(never)]
            fn fallback(numbers: &mut [$scalar], divisors: &[$scalar]) {
                numbers.iter_mut().zip(divisors).for_each(|(x, &y)| *x = Elementary::remainder(*x, y));
            }
        }
    };
}
remainder_of!(f64, 52);
remainder_of!(f32, 23);
