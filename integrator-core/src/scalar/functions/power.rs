//! Powers, `xʸ = e^(y·ln x)`.
//!
//! The exponential magnifies what is wrong with its argument, so that the logarithm has to be good to a few bits more
//! than a number has, and comes in two. With `s = f / (2 + f)` as in [`logarithm`](super::logarithm) and `z = s²`,
//! `ln m = 2·s + s·z·(2/3 + z·L(z))`: the first two terms in two numbers each, the rest, 13 bits smaller, in one.
//!
//! `L` is minimax (Remez in 300 bits, weighted for the relative error of `ln m`, coefficients rounded one after the
//! other and the later ones fitted again).

use super::{
    Bits, cubic,
    exponential::{Exponential, parts, raised},
    linear,
    logarithm::{Logarithm, normal, split},
    with_fallback_of_two,
};
use crate::scalar::{
    elementary::Elementary,
    exact::{Parts, fast_two_sum, less_product, two_product},
    real::Mask,
};

/// Constants and polynomials of powers in one format.
pub(crate) trait Power: Logarithm + Parts {
    /// 2/3 in two parts.
    const TWO_THIRDS: [f64; 2];

    /// `L` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// The function of the maths library, for other bases and greater exponents.
    fn fallback(bases: &mut [Self], exponents: &[Self]);
}

/// The logarithm of a normal number, in two parts.
#[cfg_attr(not(debug_assertions), inline(always))]
fn logarithm<R: Bits<Scalar: Power>>(x: R) -> [R; 2] {
    let (k, f) = split(x);
    let [divisor, lost] = fast_two_sum(R::of(2.0), f);
    let reciprocal = R::of(1.0) / divisor;
    let s = f * reciprocal;
    let small_s = (less_product(f, s, divisor) - s * lost) * reciprocal;

    let [z, lost] = two_product(s, s);
    let small_z = (s + s).fma(small_s, lost);
    let [two_thirds, small] = R::Scalar::TWO_THIRDS.map(R::of);
    let [slope, lost] = two_product(two_thirds, z);
    let series = (z * z).fma(<R::Scalar as Power>::series(z), lost);
    let small_slope = z.fma(small, two_thirds.fma(small_z, series));
    let [term, lost] = two_product(s, slope);
    let small_term = s.fma(small_slope, small_s.fma(slope, lost));

    let [mantissa, lost] = fast_two_sum(s + s, term);
    let small_mantissa = lost + (small_s + small_s + small_term);
    let [first, second] = R::Scalar::LN_2.map(R::of);
    let [value, lost] = fast_two_sum(k * first, mantissa);
    fast_two_sum(value, lost + k.fma(second, small_mantissa))
}

/// The number `x` to the power `y`, with an error of at most 2 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn powf<R: Bits<Scalar: Power>>(x: R, y: R) -> R {
    let [logarithm, small] = logarithm(x);
    let [exponent, lost] = two_product(y, logarithm);
    let (n, [less_one, _]) = parts(exponent, y.fma(small, lost));
    let value = raised(n, less_one);
    let fast = normal(x).and(exponent.abs().less_or_equal(R::of(R::Scalar::MAX_FAST_ARGUMENT)));
    with_fallback_of_two(value, fast, [x, y], <R::Scalar as Power>::fallback)
}

/// The error of the polynomial: 2^-66.3.
impl Power for f64 {
    const TWO_THIRDS: [f64; 2] = [2.0 / 3.0, 3.700_743_415_417_188e-17];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let low = cubic(
            z,
            square,
            [0.400_000_000_000_022_5, 0.285_714_285_701_021_5, 0.222_222_225_194_817_82, 0.181_817_844_042_420_35],
        );
        let high =
            square.fma(R::of(0.131_959_991_496_181_1), linear(z, [0.153_867_556_859_759_56, 0.132_568_546_227_840_87]));
        (square * square).fma(high, low)
    }

    #[cold]
    #[inline(never)]
    fn fallback(bases: &mut [f64], exponents: &[f64]) {
        bases.iter_mut().zip(exponents).for_each(|(x, &y)| *x = Elementary::powf(*x, y));
    }
}

/// The error of the polynomial: 2^-36.8.
impl Power for f32 {
    const TWO_THIRDS: [f64; 2] = [0.666_666_686_534_881_6, -1.986_821_551_724_915_5e-8];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        (z * z).fma(R::of(0.234_198_897_483_978_27), linear(z, [0.400_001_525_878_906_25, 0.285_470_843_315_124_5]))
    }

    #[cold]
    #[inline(never)]
    fn fallback(bases: &mut [f32], exponents: &[f32]) {
        bases.iter_mut().zip(exponents).for_each(|(x, &y)| *x = Elementary::powf(*x, y));
    }
}
