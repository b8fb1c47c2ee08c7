//! Sine and exponential of the hand-written steppers, written so that they are inlined into the surrounding loop.
//!
//! The error of [`sine`] is less than one unit in the last place, that of [`sine_fast`] less than four. Both hold for
//! arguments up to some thousands, far above those of the problems. Coefficients of the accurate functions are those of
//! fdlibm (`s_sin.c`, `k_sin.c`, `k_cos.c`) and Cephes (`sinf.c`). The fast sine and the exponential use Taylor
//! coefficients, which are as good as any with so many terms.

use crate::vector::{Number, Vector};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, LN_2, LOG2_E, PI};

/// Adding this constant rounds to an integer; the lowest bits of the mantissa are then those of the integer.
#[inline(always)]
fn magic<V: Vector>() -> V {
    V::splat(1.5 * (1_u64 << V::Number::MANTISSA) as f64)
}

/// Evaluates a polynomial by Horner's rule, highest coefficient first.
#[inline(always)]
fn horner<V: Vector>(x: V, coefficients: &[f64]) -> V {
    let mut sum = V::splat(coefficients[0]);
    for coefficient in &coefficients[1..] {
        sum = sum.fma(x, V::splat(*coefficient));
    }
    sum
}

/// Evaluates a polynomial of six coefficients, highest first, with a shorter dependency chain.
#[inline(always)]
fn estrin<V: Vector>(x: V, [f, e, d, c, b, a]: [f64; 6]) -> V {
    let of = V::splat;
    let square = x * x;
    let low = of(b).fma(x, of(a));
    let middle = of(d).fma(x, of(c));
    let high = of(f).fma(x, of(e));
    high.fma(square, middle).fma(square, low)
}

const SINE: [f64; 6] = [
    1.589_690_995_211_55e-10,
    -2.505_076_025_340_686_3e-8,
    2.755_731_370_707_006_8e-6,
    -1.984_126_982_985_795e-4,
    8.333_333_333_322_49e-3,
    -1.666_666_666_666_663_2e-1,
];
const COSINE: [f64; 6] = [
    -1.135_964_755_778_819_5e-11,
    2.087_572_321_298_175e-9,
    -2.755_731_435_139_066_3e-7,
    2.480_158_728_947_673e-5,
    -1.388_888_888_887_411e-3,
    4.166_666_666_666_66e-2,
];

/// The sine, with an error of less than one unit in the last place.
#[inline(always)]
pub fn sine<V: Vector>(x: V) -> V {
    sine_and_cosine(x)[0]
}

/// Sine and cosine, with errors of less than one unit in the last place.
#[inline(always)]
pub fn sine_and_cosine<V: Vector>(x: V) -> [V; 2] {
    // π/2 as a sum of two numbers; integer multiples of the first one are exact.
    let (high, low) = if V::Number::BITS == 64 {
        (1.570_796_326_734_125_6, 6.077_100_506_506_192e-11)
    } else {
        (1.5707855224609375, 1.0804334124e-5)
    };
    let multiples = x.fma(V::splat(FRAC_2_PI), magic());
    let whole = multiples - magic();
    let head = whole.fnma(V::splat(high), x);
    // The reduced argument is `r + tail`.
    let r = whole.fnma(V::splat(low), head);
    let tail = whole.fnma(V::splat(low), head - r);
    let square = r * r;
    let (s, c) = if V::Number::BITS == 64 {
        (estrin(square, SINE), estrin(square, COSINE))
    } else {
        (
            horner(square, &[-1.9515295891e-4, 8.3321608736e-3, -1.6666654611e-1]),
            horner(square, &[2.443315711809948e-5, -1.388731625493765e-3, 4.166664568298827e-2]),
        )
    };
    // r + (r³ s + tail), and 1 - r²/2 + (r⁴ c - r tail) with the rounding error of the first difference.
    let sine = r + (square * r).fma(s, tail);
    let half = V::splat(0.5) * square;
    let main = V::splat(1.0) - half;
    let lost = (V::splat(1.0) - main) - half;
    let cosine = main + (square * square).fma(c, r.fnma(tail, lost));
    // The cosine is the sine a quarter of a revolution ahead.
    let ahead = multiples + V::splat(1.0);
    [V::choose(multiples, cosine, sine).negate::<1>(multiples), V::choose(multiples, sine, cosine).negate::<1>(ahead)]
}

/// The sine, with an error of less than four units in the last place.
#[inline(always)]
pub fn sine_fast<V: Vector>(x: V) -> V {
    let multiples = x.fma(V::splat(FRAC_1_PI), magic());
    let whole = multiples - magic();
    let (high, low) =
        if V::Number::BITS == 64 { (PI, 1.2246467991473532e-16) } else { (PI as f32 as f64, -8.742277657e-8) };
    let r = whole.fnma(V::splat(low), whole.fnma(V::splat(high), x));
    let square = r * r;
    let series = if V::Number::BITS == 64 {
        horner(
            square,
            &[
                -8.220_635_246_624_33e-18,
                2.8114572543455206e-15,
                -7.647163731819816e-13,
                1.6059043836821613e-10,
                -2.505210838544172e-8,
                2.7557319223985893e-6,
                -1.984126984126984e-4,
                8.333333333333333e-3,
                -1.6666666666666666e-1,
            ],
        )
    } else {
        horner(square, &[2.6083159809786593e-6, -1.981069071916863e-4, 8.333_078_585_565_09e-3, -1.6666659712791443e-1])
    };
    (square * series).fma(r, r).negate::<0>(multiples)
}

/// The exponential, with an error of less than one unit in the last place if the result is a normal number.
#[inline(always)]
pub fn exponential<V: Vector<Number = f64>>(x: V) -> V {
    let multiples = x.fma(V::splat(LOG2_E), magic());
    let whole = multiples - magic();
    // ln 2 as a sum of two numbers; integer multiples of the first one are exact.
    let high = 6.931_471_803_691_238e-1;
    let low = 1.908_214_929_270_587_7e-10;
    debug_assert!((high + low - LN_2).abs() < 1e-16);
    let head = whole.fnma(V::splat(high), x);
    let r = whole.fnma(V::splat(low), head);
    let tail = whole.fnma(V::splat(low), head - r);
    let inverse_factorials = [
        1.6059043836821613e-10,
        2.08767569878681e-9,
        2.505210838544172e-8,
        2.755731922398589e-7,
        2.7557319223985893e-6,
        2.48015873015873e-5,
        1.984126984126984e-4,
        1.388888888888889e-3,
        8.333333333333333e-3,
        4.1666666666666664e-2,
        1.6666666666666666e-1,
        0.5,
    ];
    let series = horner(r, &inverse_factorials);
    (V::splat(1.0) + (r + (r * r).fma(series, tail))).scale(multiples)
}
