//! The errors of normal numbers.

use super::{draws, lanes};
use crate::scalar::{
    fma::{Fma, Fused},
    real::Real,
};
use dashu_float::{FBig, round::mode::HalfEven};
use std::ops::Neg;

/// A number with [`DIGITS`] digits.
type Big = FBig<HalfEven, 2>;

/// Digits in base 2 of references.
const DIGITS: usize = 140;

fn big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(DIGITS).value()
}

/// `u`, `t` and `q` of the documentation, all exact.
fn formula([a, b, c, d]: [u64; 4]) -> ([f64; 2], u64) {
    let u = ((a << 32 | b | 1) as f64) * 0.5_f64.powi(64);
    let t = (((c & 0xf_ffff) << 32 | d) as f64) * 0.5_f64.powi(52) - 0.5;
    ([u, t], (c >> 31) + 2 * (c >> 30 & 1))
}

/// A point turned by quarters.
fn turned<X: Neg<Output = X>>([x, y]: [X; 2], quarters: u64) -> [X; 2] {
    (0..quarters).fold([x, y], |[x, y], _| [-y, x])
}

/// The pair with 53 digits: the logarithm, the root, the function of the angle and the product are rounded.
fn near([u, t]: [f64; 2], quarters: u64) -> [f64; 2] {
    let radius = (-2.0 * pxfm::f_log(u)).sqrt();
    turned([pxfm::f_cospi(0.5 * t), pxfm::f_sinpi(0.5 * t)].map(|x| radius * x), quarters)
}

/// The pair with [`DIGITS`] digits.
fn exact([u, t]: [f64; 2], quarters: u64) -> [Big; 2] {
    let radius = (big(-2.0) * big(u).ln()).sqrt();
    let angle = big(0.5 * t) * big(-1.0).acos();
    turned([angle.cos(), angle.sin()].map(|x| x * radius.clone()), quarters)
}

/// The largest error of the numbers of `R`, in units of the last place of a format with `digits`.
///
/// `near` is at most 3.5 units wrong in double precision: half a unit each for the root and the angle and the product,
/// which is up to one of the result, and half as much for the logarithm. Where that leaves a doubt of `limit`, the exact
/// number decides.
fn largest_error<R: Real>(words: &[[u64; 4]], digits: i32, limit: f64) -> (f64, [u64; 4]) {
    let mut largest = (0.0, [0; 4]);
    for (numbers, &words) in lanes::of_all::<R>(words).iter().zip(words) {
        let (at, quarters) = formula(words);
        for (place, reference) in near(at, quarters).into_iter().enumerate() {
            let value = numbers[place][0];
            let power = f64::from_bits(reference.to_bits() & f64::INFINITY.to_bits());
            let unit = power * 0.5_f64.powi(digits - 1);
            let doubt = 3.5 * power * f64::EPSILON / unit;
            let mut error =
                if reference == 0.0 { value.abs() / f64::MIN_POSITIVE } else { (value - reference).abs() / unit };
            if error + doubt > limit && reference != 0.0 {
                error = (exact(at, quarters)[place].clone() - big(value)).to_f64().value().abs() / unit;
            }
            if error.is_nan() || error > largest.0 {
                largest = (error, words);
            }
        }
    }
    largest
}

/// The bound in the documentation.
const LIMIT: f64 = 5.0;

#[test]
fn numbers_are_as_near_as_they_say() {
    let words = lanes::words(draws() / 200);
    let table = [
        ("f64", largest_error::<f64>(&words, 53, LIMIT)),
        ("fused f64", largest_error::<Fused<f64, Fma>>(&words, 53, LIMIT)),
        ("f32", largest_error::<f32>(&words, 24, LIMIT)),
        ("fused f32", largest_error::<Fused<f32, Fma>>(&words, 24, LIMIT)),
    ];
    for (name, (error, at)) in table {
        assert!(error <= LIMIT, "{name}: {error} ulp off at {at:x?}");
    }
}

#[test]
fn numbers_of_fewer_digits_are_too_far() {
    assert!(largest_error::<f32>(&lanes::words(1_000), 26, LIMIT).0 > LIMIT);
}
