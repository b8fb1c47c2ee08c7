//! The remainder of a division, `x - n y` with `n = trunc(x / y)`, exact as that of `std`.
//!
//! The quotient is `x` times the reciprocal of `y`, which a loop over `x` computes once. It is made larger by more than its
//! error, so `n` may be one too large if `x / y` is just below an integer, but never too small. Both `x - n y` and the same with
//! one more `y` are numbers: multiples of the last place of `x` or `y`, and not larger than `y`. So a fused multiply-add computes
//! the first, and a sum the second, without rounding.

use super::{Bits, with_fallback_of_two};
use crate::scalar::{elementary::Elementary, real::Mask};

/// The remainder in one format.
pub(crate) trait Remainder: Sized {
    /// Below, a quotient is less than one too large.
    const LARGEST_QUOTIENT: f64;
    /// A few roundings, by which a quotient is made larger.
    const MORE: f64;
    /// Below, a reciprocal is rounded by its last place.
    const LARGEST_DIVISOR: f64;

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
    let (product, divisor, sign) = (x * (R::of(1.0) / y), y.abs(), x.bits_and(R::of(-0.0)));
    let quotient = product.fma(R::of(R::Scalar::MORE), product);
    let rest = (-quotient.trunc()).fma(y, x).bits_xor(sign);
    let size = R::select(rest.less(R::of(0.0)), rest + divisor, rest);
    let value = size.abs().bits_xor(sign);
    let has_fraction = quotient.abs().less(R::of(R::Scalar::LARGEST_QUOTIENT));
    with_fallback_of_two(value, has_fraction.and(divisor.less(R::of(R::Scalar::LARGEST_DIVISOR))), [x, y], fallback)
}

macro_rules! remainder_of {
    ($scalar:ident) => {
        impl Remainder for $scalar {
            const LARGEST_QUOTIENT: f64 = 0.125 / $scalar::EPSILON as f64;
            const MORE: f64 = 2.0 * $scalar::EPSILON as f64;
            const LARGEST_DIVISOR: f64 = 0.125 / $scalar::MIN_POSITIVE as f64;

            #[cold]
            #[inline(never)]
            fn fallback(numbers: &mut [$scalar], divisors: &[$scalar]) {
                numbers.iter_mut().zip(divisors).for_each(|(x, &y)| *x = Elementary::remainder(*x, y));
            }
        }
    };
}
remainder_of!(f64);
remainder_of!(f32);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{
        fma::{Fma, Fused},
        instruction_set::InstructionSet,
        real::{Kernel, Real},
    };
    use core::marker::PhantomData;

    /// Numbers around multiples of divisors of all sizes, where a quotient is rounded to an integer.
    struct Multiples<R>(PhantomData<R>);

    impl<R: Bits<Scalar: Remainder> + Real> Kernel for Multiples<R> {
        type Out = ();

        fn call(self) {
            let mut state = 1_u64;
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            };
            for _ in 0..40_000 {
                let y = (random() - 0.5) * (2.0_f64).powi((random() * 60.0) as i32 - 30);
                let multiple = (random() * 53.0).exp2().trunc() * y;
                for x in [multiple.next_down(), multiple, multiple.next_up()] {
                    let found = remainder(R::of(x), R::of(y)).lane(0);
                    let expected = x % y;
                    assert_eq!(found.to_bits(), expected.to_bits(), "{x:e} % {y:e} is {expected:e}, not {found:e}");
                }
            }
        }
    }

    #[test]
    fn multiples_have_no_remainder() {
        if InstructionSet::available().contains(&InstructionSet::Fused) {
            <Fused<f64, Fma> as Real>::enter(Multiples(PhantomData::<Fused<f64, Fma>>));
        }
    }
}
