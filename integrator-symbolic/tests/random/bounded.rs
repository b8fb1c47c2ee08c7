//! Numbers with a running error bound: how far the value may be from that of the same formula in exact arithmetic.
//!
//! Every operation passes the bounds of its operands on by the largest slope between the bounds, and adds the rounding of
//! its own result. Two formulas for one function hence differ by no more than the sum of their bounds. A bound that is
//! not finite says that nothing is known, as near a pole.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Half a unit in the last place of one: arithmetic rounds to within this.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// What elementary functions of `std` and of the runtime are within; the runtime promises one unit in the last place.
const FUNCTION: f64 = 4.0 * ROUNDING;

/// A number and its bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounded {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// The arguments that random systems call a function with.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Arguments {
    Any,
    /// Between -1 and 1.
    Bounded,
    /// Above zero.
    Positive,
    /// Between -½ and ½.
    Inner,
    /// Above one, which no random number is known to be.
    Beyond,
}

/// A function of one argument: its value, and its slope as a number with a bound of its own.
pub(crate) struct Elementary {
    pub(crate) name: &'static str,
    pub(crate) arguments: Arguments,
    pub(crate) value: fn(f64) -> f64,
    pub(crate) slope: fn(Bounded) -> Bounded,
}

/// All functions of one argument but those with a jump or a kink.
pub(crate) const ELEMENTARY: &[Elementary] = &[
    row("sin", Arguments::Any, f64::sin, |x| x.bounded_slope(f64::cos)),
    row("cos", Arguments::Any, f64::cos, |x| -x.bounded_slope(f64::sin)),
    row("tan", Arguments::Bounded, f64::tan, |x| x.bounded_slope(f64::cos).square().recip()),
    row("asin", Arguments::Inner, f64::asin, |x| one_minus_square(x).sqrt().recip()),
    row("acos", Arguments::Inner, f64::acos, |x| -one_minus_square(x).sqrt().recip()),
    row("atan", Arguments::Any, f64::atan, |x| (x.square() + 1.0.into()).recip()),
    row("sinh", Arguments::Bounded, f64::sinh, |x| (x.exp() + (-x).exp()) * 0.5.into()),
    row("cosh", Arguments::Bounded, f64::cosh, |x| (x.exp() - (-x).exp()) * 0.5.into()),
    row("tanh", Arguments::Any, f64::tanh, |x| ((x.exp() + (-x).exp()) * 0.5.into()).square().recip()),
    row("asinh", Arguments::Any, f64::asinh, |x| (x.square() + 1.0.into()).sqrt().recip()),
    row("acosh", Arguments::Beyond, f64::acosh, |x| (-one_minus_square(x)).sqrt().recip()),
    row("atanh", Arguments::Inner, f64::atanh, |x| one_minus_square(x).recip()),
    row("exp", Arguments::Bounded, f64::exp, Bounded::exp),
    row("exp2", Arguments::Bounded, f64::exp2, |x| {
        (x * std::f64::consts::LN_2.into()).exp() * std::f64::consts::LN_2.into()
    }),
    row("exp_m1", Arguments::Bounded, f64::exp_m1, Bounded::exp),
    row("ln", Arguments::Positive, f64::ln, Bounded::recip),
    row("ln_1p", Arguments::Positive, f64::ln_1p, |x| (x + 1.0.into()).recip()),
    row("log2", Arguments::Positive, f64::log2, |x| (x * std::f64::consts::LN_2.into()).recip()),
    row("log10", Arguments::Positive, f64::log10, |x| (x * std::f64::consts::LN_10.into()).recip()),
    row("sqrt", Arguments::Positive, f64::sqrt, |x| (x.sqrt() * 2.0.into()).recip()),
    row("cbrt", Arguments::Positive, f64::cbrt, |x| (x.abs().ln() * (-2.0 / 3.0).into()).exp() / 3.0.into()),
    row("recip", Arguments::Positive, f64::recip, |x| -x.square().recip()),
    row("to_radians", Arguments::Any, f64::to_radians, |_| (std::f64::consts::PI / 180.0).into()),
    row("to_degrees", Arguments::Bounded, f64::to_degrees, |_| (180.0 / std::f64::consts::PI).into()),
];

const fn row(
    name: &'static str,
    arguments: Arguments,
    value: fn(f64) -> f64,
    slope: fn(Bounded) -> Bounded,
) -> Elementary {
    Elementary { name, arguments, value, slope }
}

/// The names of the functions with these arguments.
pub(crate) fn functions_of(arguments: Arguments) -> Vec<&'static str> {
    ELEMENTARY.iter().filter(|row| row.arguments == arguments).map(|row| row.name).collect()
}

fn one_minus_square(x: Bounded) -> Bounded {
    (Bounded::from(1.0) - x) * (Bounded::from(1.0) + x)
}

impl From<f64> for Bounded {
    fn from(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
}

impl Bounded {
    /// A result whose operands explain so much; the result itself is rounded.
    fn rounded(value: f64, error: f64, unit: f64) -> Self {
        // What is below the normal numbers is rounded to their spacing.
        let rounding = if value == 0.0 && error == 0.0 { 0.0 } else { unit * value.abs() + f64::MIN_POSITIVE };
        Self { value, error: error + rounding }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }

    /// Whether both the value and its bound are known.
    pub(crate) fn is_known(self) -> bool {
        self.value.is_finite() && self.error.is_finite()
    }

    /// Whether two numbers are so near that their order is not known.
    pub(crate) fn is_near(self, other: Self) -> bool {
        let bound = self.error + other.error;
        bound != 0.0 && (self.value - other.value).abs() <= bound
    }

    /// A function whose own slope is nowhere above one, as those of sine and cosine.
    fn bounded_slope(self, function: fn(f64) -> f64) -> Self {
        Self::rounded(function(self.value), self.error, FUNCTION)
    }

    pub(crate) fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }

    pub(crate) fn square(self) -> Self {
        self * self
    }

    pub(crate) fn recip(self) -> Self {
        Self::from(1.0) / self
    }

    pub(crate) fn exp(self) -> Self {
        let value = self.value.exp();
        Self::rounded(value, value * self.error.exp_m1(), FUNCTION)
    }

    pub(crate) fn ln(self) -> Self {
        let nearest = self.value - self.error;
        let error = if nearest > 0.0 || self.error == 0.0 { self.error / nearest } else { f64::INFINITY };
        Self::rounded(self.value.ln(), if self.error == 0.0 { 0.0 } else { error }, FUNCTION)
    }

    pub(crate) fn sqrt(self) -> Self {
        let nearest = self.value - self.error;
        let error = match self.error {
            0.0 => 0.0,
            _ if nearest <= 0.0 => f64::INFINITY,
            error => error / (2.0 * nearest.sqrt()),
        };
        Self::rounded(self.value.sqrt(), error, FUNCTION)
    }

    /// A function of the table: the slope's own bound says how much it varies between the bounds of the argument.
    pub(crate) fn apply(self, function: &Elementary) -> (Self, Self) {
        let slope = (function.slope)(self);
        let steepest = slope.value.abs() + slope.error;
        let error = if self.error == 0.0 { 0.0 } else { self.error * steepest };
        (Self::rounded((function.value)(self.value), error, FUNCTION), slope)
    }

    /// An integral power, as `std` and repeated multiplication compute it: one rounding for each factor.
    pub(crate) fn powi(self, exponent: i32) -> Self {
        let value = self.value.powi(exponent);
        let count = f64::from(exponent.unsigned_abs());
        let error = match self.error {
            _ if exponent == 0 => return Self::from(1.0),
            0.0 => 0.0,
            error => {
                // The power of the outermost value that the bound allows, less the power itself.
                let far = self.value.abs() + if exponent > 0 { error } else { -error };
                if far <= 0.0 { f64::INFINITY } else { (far.powi(exponent) - value.abs()).abs() * (1.0 + 1e-6) }
            }
        };
        Self::rounded(value, error, FUNCTION * (count + 1.0))
    }

    /// A power with any exponent, by way of the logarithm.
    pub(crate) fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        let whole = exponent.value as i32;
        if exponent.error == 0.0 && f64::from(whole) == exponent.value && whole.abs() < 64 {
            return Self { value, ..self.powi(whole) };
        }
        if self.value == 0.0 && self.error == 0.0 && exponent.error == 0.0 {
            return Self::from(value);
        }
        Self { value, ..(self.ln() * exponent).exp() }
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let error = self.error + other.error;
        if self.is_zero() || other.is_zero() {
            return Self { value: self.value + other.value, error };
        }
        Self::rounded(self.value + other.value, error, ROUNDING)
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value.abs(), other.value.abs());
        let part = |error: f64, factor: f64| if error == 0.0 { 0.0 } else { error * factor };
        let error = part(other.error, a) + part(self.error, b) + part(self.error, other.error);
        Self::rounded(self.value * other.value, error, ROUNDING)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let nearest = other.value.abs() - other.error;
        let error = match self.error + other.error {
            0.0 => 0.0,
            _ if nearest <= 0.0 => f64::INFINITY,
            _ => (self.error + value.abs() * other.error) / nearest,
        };
        Self::rounded(value, error, ROUNDING)
    }
}
