//! The scalar of exact derivatives: a number and its tangent, carried through the very code that a run executes.
//!
//! In: lane 0 is the point, lane 1 a tangent at the point. Out: lane 0 is the value, lane 1 its derivative along the
//! tangent. Always true: a tangent that is not a number, or a derivative that does not exist, comes out as not a
//! number or infinite, never as a plausible number.

use crate::scalar::real::{Real, compared, elementary_functions, real_of_two_parts};
use std::{
    f64::consts::{LN_2, LN_10},
    ops::{Add, Div, Mul, Neg, Sub},
};

/// A number in `f64` and its first derivative along one direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dual {
    re: f64,
    eps: f64,
}

impl Dual {
    /// The number `re` that changes by `eps`.
    fn new(re: f64, eps: f64) -> Self {
        Self { re, eps }
    }

    /// A function of this number that has the value `value` and the derivative `slope` here.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self::new(value, slope * self.eps)
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.eps + other.eps)
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.eps - other.eps)
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re, self.eps * other.re + self.re * other.eps)
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.re / other.re;
        Self::new(value, (self.eps - value * other.eps) / other.re)
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.eps)
    }
}

/// The slope of a function of one argument at `x`, where it has this value.
macro_rules! slope {
    (sqrt $x:ident $value:ident) => {
        0.5 / $value
    };
    (cbrt $x:ident $value:ident) => {
        1.0 / (3.0 * $value * $value)
    };
    (exp $x:ident $value:ident) => {
        $value
    };
    (exp2 $x:ident $value:ident) => {
        LN_2 * $value
    };
    (exp_m1 $x:ident $value:ident) => {
        $x.exp()
    };
    (ln $x:ident $value:ident) => {
        1.0 / $x
    };
    (ln_1p $x:ident $value:ident) => {
        1.0 / (1.0 + $x)
    };
    (log2 $x:ident $value:ident) => {
        1.0 / (LN_2 * $x)
    };
    (log10 $x:ident $value:ident) => {
        1.0 / (LN_10 * $x)
    };
    (sin $x:ident $value:ident) => {
        $x.cos()
    };
    (cos $x:ident $value:ident) => {
        -$x.sin()
    };
    (tan $x:ident $value:ident) => {
        1.0 + $value * $value
    };
    (asin $x:ident $value:ident) => {
        1.0 / ((1.0 - $x) * (1.0 + $x)).sqrt()
    };
    (acos $x:ident $value:ident) => {
        -1.0 / ((1.0 - $x) * (1.0 + $x)).sqrt()
    };
    (atan $x:ident $value:ident) => {
        1.0 / (1.0 + $x * $x)
    };
    (sinh $x:ident $value:ident) => {
        $x.cosh()
    };
    (cosh $x:ident $value:ident) => {
        $x.sinh()
    };
    // sinh / cosh is inf / inf from 711 on; 1 - tanh² has no such end.
    (tanh $x:ident $value:ident) => {
        1.0 - $value * $value
    };
    (asinh $x:ident $value:ident) => {
        1.0 / $x.hypot(1.0)
    };
    (acosh $x:ident $value:ident) => {
        1.0 / (($x - 1.0) * ($x + 1.0)).sqrt()
    };
    (atanh $x:ident $value:ident) => {
        1.0 / ((1.0 - $x) * (1.0 + $x))
    };
    (abs $x:ident $value:ident) => {
        $x.signum()
    };
    // Steps have the slope zero wherever they have one: signum, floor, ceil, trunc, round.
    ($step:ident $x:ident $value:ident) => {
        0.0
    };
}

/// A function of one argument.
macro_rules! unary {
    ($function:ident $x:expr) => {{
        let x = $x.re;
        let value = x.$function();
        $x.chain(value, slope!($function x value))
    }};
}

/// A function of two arguments.
macro_rules! binary {
    // d(xʸ) = y·x^(y-1) dx + xʸ·ln x dy; a constant exponent must not meet the logarithm of a negative base.
    (powf $x:expr, $y:expr) => {{
        let (Dual { re: base, eps: of_base }, Dual { re: exponent, eps: of_exponent }) = ($x, $y);
        let value = base.powf(exponent);
        let by_base = if exponent == 0.0 { 0.0 } else { exponent * base.powf(exponent - 1.0) * of_base };
        let by_exponent = if of_exponent == 0.0 { 0.0 } else { value * base.ln() * of_exponent };
        Dual::new(value, by_base + by_exponent)
    }};
    // d atan2(y, x) = (x dy - y dx) / (x² + y²), divided by the hypotenuse twice so that no square overflows.
    (atan2 $y:expr, $x:expr) => {{
        let (y, x) = ($y, $x);
        let radius = y.re.hypot(x.re);
        Dual::new(y.re.atan2(x.re), (x.re / radius * y.eps - y.re / radius * x.eps) / radius)
    }};
    (hypot $x:expr, $y:expr) => {{
        let (x, y) = ($x, $y);
        let radius = x.re.hypot(y.re);
        Dual::new(radius, x.re / radius * x.eps + y.re / radius * y.eps)
    }};
    // x - n y, with the whole number n that stays the same nearby.
    (remainder $x:expr, $y:expr) => {{
        let (x, y) = ($x, $y);
        let by_y = if y.eps == 0.0 { 0.0 } else { (x.re / y.re).trunc() * y.eps };
        Dual::new(x.re % y.re, x.eps - by_y)
    }};
    // As in std, a NaN gives way to the other argument; the tangent goes with the value.
    (min $x:expr, $y:expr) => {
        if $x.re <= $y.re || $y.re.is_nan() { $x } else { $y }
    };
    (max $x:expr, $y:expr) => {
        if $x.re >= $y.re || $y.re.is_nan() { $x } else { $y }
    };
}

elementary_functions!(real_of_two_parts! {
    Dual: inline; lanes of self: self.re, self.eps;
    {
        type Mask = bool;

        fn of(x: f64) -> Self {
            Self::new(x, 0.0)
        }
        fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::of(of_lane(0))
        }
        fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::new(of_lane(0), of_lane(1))
        }
        fn lane_by_lane<const N: usize>(
            arguments: [Self; N],
            value: impl Fn(usize, [f64; N]) -> f64,
            slopes: impl Fn(usize, [f64; N]) -> [f64; N],
        ) -> Self {
            let at = arguments.map(|argument| argument.re);
            // An unknown slope is NaN; it must not reach a result that it does not change.
            let along = |(slope, argument): (f64, Self)| match argument.eps {
                0.0 => 0.0,
                tangent => slope * tangent,
            };
            Self::new(value(0, at), slopes(0, at).into_iter().zip(arguments).map(along).sum())
        }
        fn sin_cos(self) -> (Self, Self) {
            let (sine, cosine) = self.re.sin_cos();
            (self.chain(sine, cosine), self.chain(cosine, -sine))
        }
        fn finite(self) -> bool {
            self.re.is_finite() && self.eps.is_finite()
        }
        compared!(re);
    }
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{elementary::Elementary, tolerance::within};

    /// The difference quotient of fourth order, good to about 1e-11 at unit scale.
    fn quotient(f: impl Fn(f64) -> f64, x: f64) -> f64 {
        let d = 1e-3;
        (8.0 * (f(x + d) - f(x - d)) - (f(x + 2.0 * d) - f(x - 2.0 * d))) / (12.0 * d)
    }

    macro_rules! every_function {
        (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
            /// Every unary function at a point inside its domain: the name, the dual outcome, value and quotient.
            fn unary_table() -> Vec<(&'static str, Dual, f64, f64)> {
                vec![$({
                    let name = stringify!($unary);
                    let x = if name == "acosh" { 1.7 } else { 0.6 };
                    (name, Real::$unary(Dual::new(x, 2.0)), f64::$unary(x), quotient(f64::$unary, x))
                }),*]
            }
            /// Every binary function, both arguments moving.
            fn binary_table() -> Vec<(&'static str, Dual, f64, f64)> {
                vec![$({
                    let (x, y) = (Dual::new(0.8, 2.0), Dual::new(1.3, -1.0));
                    let along = |s: f64| Elementary::$binary(0.8 + 2.0 * s, 1.3 - s);
                    (stringify!($binary), Real::$binary(x, y), along(0.0), quotient(along, 0.0) / 2.0)
                }),*]
            }
        };
    }
    elementary_functions!(every_function! {});

    #[test]
    fn every_elementary_function_has_its_value_and_derivative() {
        for (name, dual, value, derivative) in unary_table().into_iter().chain(binary_table()) {
            assert!(within(dual.lane(0) - value, 4.0 * f64::EPSILON), "{name}: {dual:?} has the value {value}");
            assert!(within(dual.lane(1) / 2.0 - derivative, 1e-9), "{name}: {dual:?} changes by {derivative}");
        }
    }

    #[test]
    fn derivatives_survive_the_edges_of_a_domain() {
        let at = |x| Dual::new(x, 1.0);
        let table = [
            ("tanh far out", at(800.0).tanh(), 1.0, 0.0),
            ("a negative base", at(-2.0).powf(Dual::of(3.0)), -8.0, 12.0),
            ("a power at zero", at(0.0).powf(Dual::of(2.0)), 0.0, 0.0),
            ("the angle on the axis", at(1.0).atan2(Dual::new(0.0, 1.0)), std::f64::consts::FRAC_PI_2, -1.0),
            ("a huge hypotenuse", at(3e200).hypot(Dual::of(4e200)), 5e200, 0.6),
        ];
        for (name, dual, value, derivative) in table {
            assert!(within(dual.lane(0) - value, 4.0 * f64::EPSILON * value.abs()), "{name}: {dual:?}");
            assert!(within(dual.lane(1) - derivative, 4.0 * f64::EPSILON), "{name}: {dual:?}");
        }
        assert!(!at(0.0).sqrt().finite(), "a derivative that does not exist is not finite");
    }

    #[test]
    fn a_prepared_constant_has_no_tangent() {
        let constant = Dual::parameter(&|lane| [3.0, 5.0][lane]);
        assert_eq!((constant.lane(0), constant.lane(1)), (3.0, 0.0));
    }
}
