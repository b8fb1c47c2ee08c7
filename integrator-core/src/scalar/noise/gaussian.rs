//! Standard normal numbers: the transformation of G. E. P. Box and M. E. Muller, *A note on the generation of random normal
//! deviates*, Ann. Math. Statist. 29 (1958).
//!
//! Of four words `a`, `b`, `c`, `d`, the first two give a number of (0, 1], the others an angle:
//!
//! ```text
//! u = (2³²·a + b, its last bit set)·2⁻⁶⁴, rounded        r = sqrt(-2 ln u)
//! t = (the last 20 bits of c, then d)·2⁻⁵² - ½            φ = ½π·(q + t), q = c₃₁ + 2·c₃₀
//! the numbers r·cos φ and r·sin φ
//! ```
//!
//! `r` is at most 9.42. Below that, `u` is as fine as its last place is, so tails have no visible steps.
//!
//! Integers are handled as words of 64 bits and patterns of `f64`, in a plain loop over lanes that vectorises. What is
//! rounded is computed in `R`.

use super::philox::{LOW, ROUNDS, mixed, round_keys};
use crate::scalar::real::Real;
use core::f64::consts::LN_2;

/// Returns two independent standard normal numbers for each member in the lanes of `R`, without derivatives.
///
/// `counter` gives the counter of a lane, the first one of its member. The error of a number is at most 5 ulp, the factors of
/// the formula above included.
#[inline(always)]
pub(crate) fn gaussians<R: Real>(key: [u32; 2], counter: impl Counter) -> [R; 2] {
    // The lanes of a member are neighbours, the number without derivatives first.
    let parts = const { R::LANES / R::MEMBERS };
    of_words(Mixed { counter, keys: round_keys(key), parts })
}

/// The counter of each lane. A trait, because only a method can carry the `inline(always)` that brings it into the variant for
/// an instruction set.
pub(crate) trait Counter {
    /// Returns the counter of a lane.
    fn counter(&self, lane: usize) -> [u32; 4];
}

impl<F: Fn(usize) -> [u32; 4]> Counter for F {
    #[inline(always)]
    fn counter(&self, lane: usize) -> [u32; 4] {
        self(lane)
    }
}

/// The words of each member, whose upper halves may be anything.
pub(super) trait Words {
    /// Returns the words of a member.
    fn words(&self, member: usize) -> [u64; 4];
}

impl<F: Fn(usize) -> [u64; 4]> Words for F {
    #[inline(always)]
    fn words(&self, member: usize) -> [u64; 4] {
        self(member)
    }
}

/// The words of counters under a key.
struct Mixed<C> {
    counter: C,
    keys: [[u64; 2]; ROUNDS],
    /// The number of lanes of a member.
    parts: usize,
}

impl<C: Counter> Words for Mixed<C> {
    #[inline(always)]
    fn words(&self, member: usize) -> [u64; 4] {
        let [a, b, c, d] = self.counter.counter(member * self.parts);
        mixed([u64::from(a), u64::from(b), u64::from(c), u64::from(d)], self.keys)
    }
}

/// The numbers of the words of each member.
#[inline(always)]
pub(super) fn of_words<R: Real>(words: impl Words) -> [R; 2] {
    const { assert!(R::MEMBERS <= 128, "rows of eight bodies have at most 16 members each") };
    // As many as there are, so that the compiler sees whole vectors. Of a constant it compiles one arm.
    match const { R::MEMBERS.next_power_of_two() } {
        1 => of_members::<R, 1>(words),
        2 => of_members::<R, 2>(words),
        4 => of_members::<R, 4>(words),
        8 => of_members::<R, 8>(words),
        16 => of_members::<R, 16>(words),
        32 => of_members::<R, 32>(words),
        64 => of_members::<R, 64>(words),
        _ => of_members::<R, 128>(words),
    }
}

/// What is known of a pair of numbers without rounding.
#[derive(Clone, Copy)]
struct Exact {
    /// `u` is `2ᵏ·(1 + f)` with `√½ <= 1 + f < √2`.
    k: f64,
    f: f64,
    /// The place in the quarter, between -½ and ½.
    t: f64,
    /// The cosine and the sine of the angle at the middle of the quarter: 0, 1 or -1.
    middle: [f64; 2],
}

/// The patterns of numbers: 1, √½, -0, 2⁵² and 2⁸⁴.
const ONE: u64 = 0x3ff0_0000_0000_0000;
const ROOT: u64 = 0x3fe6_a09e_667f_3bcd;
const SIGN: u64 = 1 << 63;
const UNITS: u64 = 0x4330_0000_0000_0000;
const WORDS: u64 = 0x4530_0000_0000_0000;
/// The bits of a mantissa.
const MANTISSA: u64 = (1 << 52) - 1;

/// Splits four words.
#[inline(always)]
fn split([a, b, c, d]: [u64; 4]) -> Exact {
    // The integer of both words: each is the mantissa of a number whose last bit is worth 2³² or 1.
    let high = f64::from_bits(WORDS | (a & LOW)) - (19_342_813_113_834_066_795_298_816.0 + 4_503_599_627_370_496.0);
    let integer = high + f64::from_bits((UNITS | 1) | (b & LOW));
    // Moved so that the mantissa begins at √½.
    let moved = integer.to_bits().wrapping_add(ONE - ROOT);
    let k = f64::from_bits(UNITS | (moved >> 52)) - (4_503_599_627_370_496.0 + 1023.0 + 64.0);
    let f = f64::from_bits((moved & MANTISSA) + ROOT) - 1.0;
    let angle = (c << 32) | (d & LOW);
    // All bits, or none.
    let odd = (angle >> 63).wrapping_neg();
    let unit = ONE | ((angle << 1) & SIGN);
    Exact {
        k,
        f,
        t: f64::from_bits(ONE | (angle & MANTISSA)) - 1.5,
        middle: [f64::from_bits(unit & !odd), f64::from_bits(unit & odd)],
    }
}

#[inline(always)]
fn of_members<R: Real, const N: usize>(words: impl Words) -> [R; 2] {
    let (mut k, mut f, mut t, mut x, mut y) = ([0.0; N], [0.0; N], [0.0; N], [0.0; N], [0.0; N]);
    for member in 0..R::MEMBERS {
        let exact = split(words.words(member));
        k[member] = exact.k;
        f[member] = exact.f;
        t[member] = exact.t;
        [x[member], y[member]] = exact.middle;
    }
    let radius = radius::<R>(lanes(&k), lanes(&f));
    let (sine, cosine) = sin_cos::<R>(lanes(&t));
    // Exact, and without a choice, which a scalar would make by a branch that no processor predicts.
    let (x, y) = (lanes::<R, N>(&x), lanes::<R, N>(&y));
    [radius * (-sine).fma(y, cosine * x), radius * cosine.fma(y, sine * x)]
}

/// One number of each member, without derivatives.
#[inline(always)]
fn lanes<R: Real, const N: usize>(of_members: &[f64; N]) -> R {
    let parts = const { R::LANES / R::MEMBERS };
    R::parameter(&|lane| of_members[lane / parts])
}

/// `sqrt(-2 ln u)` where `u` is `2ᵏ·(1 + f)`.
///
/// With `s = f / (2 + f)`, `ln(1 + f) = s·(2 + s²·L(s²))`. `L` is that of [`fast_ln`](crate::scalar::functions::fast_ln),
/// whose error is 2^-52.2; the factor -2 is in the coefficients.
#[inline(always)]
fn radius<R: Real>(k: R, f: R) -> R {
    let c = R::of;
    let s = f / (f + c(2.0));
    let z = s * s;
    let square = z * z;
    let first = z.fma(c(-2.0 * 0.400_000_000_521_325_3), c(-2.0 * 0.666_666_666_665_875));
    let second = z.fma(c(-2.0 * 0.222_233_701_872_076_3), c(-2.0 * 0.285_714_171_517_861_77));
    let third = z.fma(c(-2.0 * 0.168_192_909_214_938_04), c(-2.0 * 0.181_236_887_716_446_67));
    let series = square.fma(square.fma(third, second), first);
    k.fma(c(-2.0 * LN_2), s * z.fma(series, c(-4.0))).sqrt()
}

/// The sine and the cosine of `½π·t` for `|t| <= ½`: `t·S(t²)` and `1 + t²·C(t²)`.
///
/// Minimax as in `functions/sine.rs`: the errors are 2^-54.5 for the sine and 2^-53.8 for the cosine.
#[inline(always)]
fn sin_cos<R: Real>(t: R) -> (R, R) {
    let c = R::of;
    let z = t * t;
    let square = z * z;
    let first = z.fma(c(-0.645_964_097_506_228), c(core::f64::consts::FRAC_PI_2));
    let second = z.fma(c(-0.004_681_754_119_169_512), c(0.079_692_626_245_275_04));
    let third = z.fma(c(-3.598_279_470_312_218e-6), c(1.604_410_487_309_961_7e-4));
    let fourth = square.fma(c(5.585_285_087_564_329e-8), third);
    let sine = t * square.fma(square.fma(fourth, second), first);
    let first = z.fma(c(0.253_669_507_899_956_3), c(-1.233_700_550_136_155_3));
    let second = z.fma(c(9.192_599_536_132_382e-4), c(-0.020_863_480_735_806_027));
    let third = z.fma(c(4.655_306_789_728_077_4e-7), c(-2.520_014_096_080_627e-5));
    let cosine = z.fma(square.fma(square.fma(third, second), first), c(1.0));
    (sine, cosine)
}
