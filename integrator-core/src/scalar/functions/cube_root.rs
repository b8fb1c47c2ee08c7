//! The cube root.
//!
//! A third of the pattern, subtracted from a constant, is that of `1/∛x` within 4 %; one correction makes it `p`, good
//! to 18 bits. The root `x·p²` is rounded to so few bits, `y`, that `y³` is exact, and so is its difference from `x`.
//! With `δ = (x - y³)/x`, the root is `y·(1 - δ)^(-1/3)`, of which a few terms of the series are enough.

use super::{
    Bits, cubic, linear,
    logarithm::{Logarithm, normal},
    with_fallback,
};
use crate::scalar::elementary::Elementary;

/// Constants of the cube root in one format.
pub(crate) trait CubeRoot: Logarithm {
    /// Of the pattern, the last bits that the first estimate does without.
    const UNUSED: u32;
    /// To a third of the others, negative, this is added, both in the last bits of a number: 4/3 of the exponent of
    /// one, a bit less because the pattern is not quite a logarithm.
    const ESTIMATE: f64;
    /// Half of the last of the bits that remain of the root, and these.
    const ROUNDED: [u64; 2];

    /// The function of the maths library, for arguments that are not normal.
    fn fallback(lanes: &mut [Self]);
}

/// `1/∛x` of a size, good to 18 bits.
#[cfg_attr(not(debug_assertions), inline(always))]
fn reciprocal<R: Bits<Scalar: CubeRoot>>(size: R) -> R {
    let [_, _, integer] = R::Scalar::PATTERNS;
    let unused = R::Scalar::UNUSED;
    let pattern = size.bits_right(unused).bits_add(R::pattern(integer));
    let p = pattern.fma(R::of(-1.0 / 3.0), R::of(R::Scalar::ESTIMATE)).bits_left(unused);
    let e = (-(size * p * p)).fma(p, R::of(1.0));
    // (1 - e)^(-1/3) within 2^-18.9 for |e| < 0.102: minimax.
    p * cubic(
        e,
        e * e,
        [0.999_998_014_951_179_6, 0.333_328_405_747_237_6, 0.223_738_253_261_815_98, 0.174_562_401_087_909_02],
    )
}

/// `value` where `x` is normal, that of the maths library elsewhere; with the sign of `x`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn signed_or_fallback<R: Bits<Scalar: CubeRoot>>(value: R, x: R, size: R) -> R {
    let value = value.bits_xor(x.bits_and(R::of(-0.0)));
    with_fallback(value, normal(size), x, <R::Scalar as CubeRoot>::fallback)
}

/// The cube root, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn cbrt<R: Bits<Scalar: CubeRoot>>(x: R) -> R {
    let size = x.abs();
    let p = reciprocal(size);
    let root = size * p * p;
    let [half, kept] = R::Scalar::ROUNDED.map(R::pattern);
    let y = root.bits_add(half).bits_and(kept);
    let e = (-root).fma(p, R::of(1.0));
    // 1/x is p³·(1 + e + e²).
    let delta = (size - y * y * y) * (p * p * p) * (R::of(1.0) + e.fma(e, e));
    let terms = delta.fma(linear(delta, [2.0 / 9.0, 14.0 / 81.0]), R::of(1.0 / 3.0));
    signed_or_fallback((y * delta).fma(terms, y), x, size)
}

/// The cube root, with an error of at most 4 ulp: of the root `x·p²` no bits are dropped, and the correction sees but a
/// third of its rounding errors.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_cbrt<R: Bits<Scalar: CubeRoot>>(x: R) -> R {
    let size = x.abs();
    let p = reciprocal(size);
    let root = size * p * p;
    let e = (-root).fma(p, R::of(1.0));
    signed_or_fallback((root * e).fma(linear(e, [2.0 / 3.0, 5.0 / 9.0]), root), x, size)
}

impl CubeRoot for f64 {
    const UNUSED: u32 = 32;
    const ESTIMATE: f64 = 6_004_800_933_347_021.0;
    const ROUNDED: [u64; 2] = [1 << 35, !0 << 36];

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f64]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::cbrt(*lane));
    }
}

impl CubeRoot for f32 {
    const UNUSED: u32 = 9;
    const ESTIMATE: f64 = 13_958_053.0;
    const ROUNDED: [u64; 2] = [1 << 15, !0 << 16];

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f32]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::cbrt(*lane));
    }
}
