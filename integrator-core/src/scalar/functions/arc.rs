//! The arc tangent, of one argument and of two.
//!
//! The argument is a ratio of two sizes; with the smaller one over the larger one, `t`, the angle is
//! `t - t·z/4 + t·z·A(z)`, `z = t²`, or what a quarter turn exceeds that by. What the division and the first difference
//! lost is added with the last term, which is small, so that one rounding of the result's size is left.
//!
//! `A` is minimax (Remez in 300 bits, weighted for the relative error of the result, coefficients rounded one after the
//! other and the later ones fitted again).

use super::{Bits, cubic, linear, with_fallback_of_two};
use crate::scalar::{
    elementary::Elementary,
    exact::{Parts, fast_two_sum, lost_by_quotient},
    real::Mask,
};
use core::f64::consts::FRAC_PI_2;

/// Constants and polynomials of the arc tangent in one format.
pub(crate) trait Arc: Parts {
    /// π/2 in two parts.
    const QUARTER: [f64; 2];
    /// Between these, neither ratios nor what divisions lose leave the normal numbers.
    const MODERATE: [f64; 2];

    /// `A` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// `A - 1/4` at `z`, with the digits that 4 ulp need.
    fn short_series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// The function of the maths library, for arguments that are not moderate.
    fn fallback(lanes: &mut [Self], others: &[Self]);
}

/// The angle in the first octant whose tangent is `small / big`, in two parts.
#[cfg_attr(not(debug_assertions), inline(always))]
fn octant<R: Bits<Scalar: Arc>>(small: R, big: R) -> [R; 2] {
    let t = small / big;
    let z = t * t;
    // The slope is 1/(1 + z), of which a few bits are enough.
    let slope = z.fma(R::of(-0.5), R::of(1.0));
    let cube = t * z;
    let [angle, lost] = fast_two_sum(t, cube * R::of(-0.25));
    [angle, cube.fma(R::Scalar::series(z), lost_by_quotient(t, small, big).fma(slope, lost))]
}

/// The sum of this number of quarter turns, if there are any, and an angle that is smaller and in two parts.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add_quarters<R: Bits<Scalar: Arc>>(quarters: R, [angle, rest]: [R; 2]) -> R {
    let [quarter, small] = R::Scalar::QUARTER.map(R::of);
    let [sum, lost] = fast_two_sum(quarters * quarter, angle);
    sum + (lost + quarters.fma(small, rest))
}

/// The sign of the first, as a pattern.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn sign<R: Bits>(x: R) -> R {
    x.bits_and(R::of(-0.0))
}

/// The smaller one of two sizes, the larger one, and whether the first is larger.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sorted<R: Bits>(height: R, width: R) -> (R, R, R::Mask) {
    let steep = width.less(height);
    (R::select(steep, width, height), R::select(steep, height, width), steep)
}

/// The size of a number, but for infinity, which has no reciprocal to be corrected.
#[cfg_attr(not(debug_assertions), inline(always))]
fn size<R: Bits<Scalar: Arc>>(x: R) -> R {
    let farthest = R::of(R::Scalar::MODERATE[1]);
    R::select(farthest.less(x.abs()), farthest, x.abs())
}

/// The number of quarter turns that the angle of a point is counted from, and the sign that it is counted with, as a
/// pattern.
#[cfg_attr(not(debug_assertions), inline(always))]
fn quadrant<R: Bits>(x: R, steep: R::Mask) -> (R, R) {
    let (zero, one, two) = (R::of(0.0), R::of(1.0), R::of(2.0));
    let flip = sign(x).bits_xor(R::select(steep, R::of(-0.0), zero));
    (R::select(steep, one, R::select(x.less(zero), two, zero)), flip)
}

/// `value` where the sizes are moderate, that of the maths library elsewhere.
#[cfg_attr(not(debug_assertions), inline(always))]
fn with_fallback<R: Bits<Scalar: Arc>>(value: R, [y, x]: [R; 2], [small, big]: [R; 2]) -> R {
    let [least, greatest] = R::Scalar::MODERATE.map(R::of);
    let moderate = least.less(big).and(big.less(greatest)).and(least.less(small).or(small.equal(R::of(0.0))));
    with_fallback_of_two(value, moderate, [y, x], R::Scalar::fallback)
}

/// The arc tangent, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn atan<R: Bits<Scalar: Arc>>(x: R) -> R {
    let one = R::of(1.0);
    let (small, big, steep) = sorted(size(x), one);
    let [angle, rest] = octant(small, big);
    let (quarters, flip) = quadrant(one, steep);
    add_quarters(quarters, [angle.bits_xor(flip), rest.bits_xor(flip)]).bits_xor(sign(x))
}

/// The angle of the point `(x, y)`, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn atan2<R: Bits<Scalar: Arc>>(y: R, x: R) -> R {
    let (small, big, steep) = sorted(y.abs(), x.abs());
    let [angle, rest] = octant(small, big);
    let (quarters, flip) = quadrant(x, steep);
    let value = add_quarters(quarters, [angle.bits_xor(flip), rest.bits_xor(flip)]).bits_xor(sign(y));
    with_fallback(value, [y, x], [small, big])
}

/// The angle in the first octant whose tangent is `small / big`, rounded.
#[cfg_attr(not(debug_assertions), inline(always))]
fn short_octant<R: Bits<Scalar: Arc>>(small: R, big: R) -> R {
    let t = small / big;
    let z = t * t;
    (t * z).fma(R::Scalar::short_series(z), t)
}

/// The arc tangent, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_atan<R: Bits<Scalar: Arc>>(x: R) -> R {
    let one = R::of(1.0);
    let (small, big, steep) = sorted(x.abs(), one);
    let (quarters, flip) = quadrant(one, steep);
    let angle = short_octant(small, big).bits_xor(flip);
    quarters.fma(R::of(FRAC_PI_2), angle).bits_xor(sign(x))
}

/// The angle of the point `(x, y)`, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_atan2<R: Bits<Scalar: Arc>>(y: R, x: R) -> R {
    let (small, big, steep) = sorted(y.abs(), x.abs());
    let (quarters, flip) = quadrant(x, steep);
    let angle = short_octant(small, big).bits_xor(flip);
    with_fallback(quarters.fma(R::of(FRAC_PI_2), angle).bits_xor(sign(y)), [y, x], [small, big])
}

/// The errors of the polynomials: 2^-56.4 and 2^-52.3.
impl Arc for f64 {
    const QUARTER: [f64; 2] = [FRAC_PI_2, 6.123_233_995_736_766e-17];
    const MODERATE: [f64; 2] = [1e-140, 1e140];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let fourth = square * square;
        let low = cubic(
            z,
            square,
            [-0.083_333_333_333_330_7, 0.199_999_999_999_517_5, -0.142_857_142_825_881_72, 0.111_111_110_073_441_1],
        );
        let second = cubic(
            z,
            square,
            [-0.090_909_070_078_252_27, 0.076_922_798_890_873_63, -0.066_664_044_237_033_98, 0.058_805_298_049_375_75],
        );
        let third = cubic(
            z,
            square,
            [
                -0.052_535_267_489_496_086,
                0.047_223_482_094_269_35,
                -0.042_192_431_066_084_404,
                0.036_643_149_597_772_06,
            ],
        );
        let fifth = cubic(
            z,
            square,
            [
                -0.029_905_730_336_280_873,
                0.021_987_056_150_293_827,
                -0.013_902_555_924_551_727,
                0.007_197_867_569_850_056,
            ],
        );
        let high = cubic(
            z,
            square,
            [
                -0.002_885_598_737_462_079_8,
                0.000_831_555_190_445_926_1,
                -0.000_152_210_073_524_236_67,
                1.322_988_350_719_387_6e-5,
            ],
        );
        let upper = fourth.fma(fourth.fma(high, fifth), third);
        fourth.fma(fourth.fma(upper, second), low)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let fourth = square * square;
        let low = cubic(
            z,
            square,
            [-0.333_333_333_333_251_6, 0.199_999_999_987_728_9, -0.142_857_142_206_616_6, 0.111_111_093_462_383_35],
        );
        let second = cubic(
            z,
            square,
            [-0.090_908_801_995_915_39, 0.076_919_942_609_555_16, -0.066_642_737_689_358_5, 0.058_689_548_899_711_98],
        );
        let third = cubic(
            z,
            square,
            [
                -0.052_064_763_677_548_89,
                0.045_765_907_881_848_714,
                -0.038_710_594_025_388_304,
                0.030_190_500_504_913_37,
            ],
        );
        let fifth = cubic(
            z,
            square,
            [
                -0.020_621_202_197_113_68,
                0.011_664_659_907_040_275,
                -0.005_136_641_875_852_91,
                0.001_627_704_078_587_895_3,
            ],
        );
        let high = linear(z, [-0.000_327_091_422_562_970_24, 3.111_448_928_764_677_6e-5]);
        let upper = fourth.fma(fourth.fma(high, fifth), third);
        fourth.fma(fourth.fma(upper, second), low)
    }

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f64], others: &[f64]) {
        lanes.iter_mut().zip(others).for_each(|(y, &x)| *y = Elementary::atan2(*y, x));
    }
}

/// The errors of the polynomials: 2^-29.2 and 2^-25.6.
impl Arc for f32 {
    const QUARTER: [f64; 2] = [1.570_796_370_506_286_5, -4.371_138_828_673_793e-8];
    const MODERATE: [f64; 2] = [1e-13, 1e13];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        let first = linear(z, [-0.083_333_283_662_796_02, 0.199_997_156_858_444_2]);
        let second = linear(z, [-0.142_803_430_557_250_98, 0.110_612_332_820_892_33]);
        let third = linear(z, [-0.088_214_620_947_837_83, 0.067_636_489_868_164_06]);
        let fourth = linear(z, [-0.044_983_256_608_247_76, 0.022_777_616_977_691_65]);
        let fifth = linear(z, [-0.007_425_365_969_538_689, 0.001_134_525_868_110_358_7]);
        let square = z * z;
        let high = square.fma(square.fma(fifth, fourth), third);
        square.fma(square.fma(high, second), first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f32>>(z: R) -> R {
        let square = z * z;
        let low = cubic(
            z,
            square,
            [-0.333_331_525_325_775_15, 0.199_937_671_422_958_37, -0.142_110_034_823_417_66, 0.106_657_817_959_785_46],
        );
        let high = cubic(
            z,
            square,
            [
                -0.075_517_013_669_013_98,
                0.043_205_369_263_887_405,
                -0.016_363_667_324_185_37,
                0.002_919_561_229_646_206,
            ],
        );
        (square * square).fma(high, low)
    }

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f32], others: &[f32]) {
        lanes.iter_mut().zip(others).for_each(|(y, &x)| *y = Elementary::atan2(*y, x));
    }
}
