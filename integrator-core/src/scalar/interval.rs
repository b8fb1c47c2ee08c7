//! Interval arithmetic: a scalar that encloses all values of an expression over a range of its arguments.
//!
//! In: intervals of coordinates and of the time. Out: an interval that contains the value of the expression at every point
//! of them, whatever roundings of `f64` it had. Always true: bounds are rounded outwards; an expression that is not
//! defined on the whole range has no bounds.

use crate::scalar::{
    exact::two_sum,
    functions::elementary_functions,
    real::{Mask, Real, real_of_two_parts},
};
use core::{
    f64::consts::PI,
    ops::{Add, Div, Mul, Neg, Sub},
};

/// The error of an elementary function relative to its value: four units in the last place, and their own rounding.
const FUNCTION: f64 = 8.0 * f64::EPSILON;

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// Whether a condition can hold and whether it can fail somewhere on the intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Outcomes {
    holds: bool,
    fails: bool,
}

impl Mask for Outcomes {
    fn of(holds: bool) -> Self {
        Self { holds, fails: !holds }
    }
    fn any(self) -> bool {
        self.holds
    }
    fn and(self, other: Self) -> Self {
        Self { holds: self.holds && other.holds, fails: self.fails || other.fails }
    }
    fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
    fn not(self) -> Self {
        Self { holds: self.fails, fails: self.holds }
    }
}

impl Interval {
    /// All numbers.
    const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The interval from one number to the other; all numbers where one of them is NaN.
    pub(crate) fn new(low: f64, high: f64) -> Self {
        if low <= high { Self { low, high } } else { Self::WHOLE }
    }

    /// The interval with bounds that were rounded to nearest.
    fn rounded(low: f64, high: f64) -> Self {
        Self::new(low.next_down(), high.next_up())
    }

    /// The interval with bounds that an elementary function returned, within its range.
    fn of_function(low: f64, high: f64, range: [f64; 2]) -> Self {
        let error = |bound: f64| if bound == 0.0 { 0.0 } else { FUNCTION * Real::abs(bound) + f64::MIN_POSITIVE };
        let (low, high) = (low - error(low), high + error(high));
        Self::new(f64::max(low, range[0]), f64::min(high, range[1]))
    }

    /// A function that increases on its domain.
    fn increasing(self, function: impl Fn(f64) -> f64, domain: [f64; 2], range: [f64; 2]) -> Self {
        let (low, high) = (f64::max(self.low, domain[0]), f64::min(self.high, domain[1]));
        if low > high { Self::WHOLE } else { Self::of_function(function(low), function(high), range) }
    }

    /// A function that returns whole numbers and does not decrease.
    fn whole(self, function: impl Fn(f64) -> f64) -> Self {
        Self::new(function(self.low), function(self.high))
    }

    /// The number that this interval consists of, if it is one.
    fn point(self) -> Option<f64> {
        (self.low == self.high).then_some(self.low)
    }

    pub(crate) fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// The middle.
    pub(crate) fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    fn union(self, other: Self) -> Self {
        Self::new(f64::min(self.low, other.low), f64::max(self.high, other.high))
    }

    /// The absolute values of all numbers.
    fn magnitudes(self) -> Self {
        let (low, high) = (Real::abs(self.low), Real::abs(self.high));
        let least = if self.contains(0.0) { 0.0 } else { f64::min(low, high) };
        Self::new(least, f64::max(low, high))
    }

    /// The interval of the least and the largest of some values at the corners.
    fn of_corners(corners: [f64; 4], bounds: impl Fn(f64, f64) -> Self) -> Self {
        let mut extremes = [f64::INFINITY, f64::NEG_INFINITY];
        for corner in corners {
            if corner.is_nan() {
                return Self::WHOLE;
            }
            extremes = [f64::min(extremes[0], corner), f64::max(extremes[1], corner)];
        }
        bounds(extremes[0], extremes[1])
    }

    /// The values of a function of two numbers at the corners of two intervals.
    fn corners(self, other: Self, function: impl Fn(f64, f64) -> f64) -> [f64; 4] {
        [
            function(self.low, other.low),
            function(self.low, other.high),
            function(self.high, other.low),
            function(self.high, other.high),
        ]
    }

    /// Sine or cosine, whose values change by no more than their argument.
    fn wave(self, function: impl Fn(f64) -> f64) -> Self {
        let middle = self.middle();
        let radius = 0.5 * (self.high - self.low) * (1.0 + FUNCTION) + f64::EPSILON * Real::abs(middle) + FUNCTION;
        if radius >= 2.0 || radius.is_nan() {
            return Self { low: -1.0, high: 1.0 };
        }
        let value = function(middle);
        Self::new(f64::max(value - radius, -1.0), f64::min(value + radius, 1.0))
    }

    fn tangent(self) -> Self {
        let [low, high] = [self.low, self.high].map(|end| (Real::cos(end), FUNCTION * (1.0 + Real::abs(end))));
        let is_apart = |(cosine, error): (f64, f64)| Real::abs(cosine) > error;
        let has_pole =
            self.high - self.low >= PI || !is_apart(low) || !is_apart(high) || (low.0 > 0.0) != (high.0 > 0.0);
        if has_pole { Self::WHOLE } else { Self::of_function(Real::tan(self.low), Real::tan(self.high), ALL) }
    }

    fn power(self, exponent: Self) -> Self {
        if self.low >= 0.0 {
            let corners = self.corners(exponent, <f64 as Real>::powf);
            return Self::of_corners(corners, |low, high| Self::of_function(low, high, POSITIVE));
        }
        let Some(whole) = exponent.point().filter(|exponent| Real::trunc(*exponent) == *exponent) else {
            return Self::WHOLE;
        };
        let of = |x: f64| Real::powf(x, whole);
        match (Real::remainder(whole, 2.0) == 0.0, whole > 0.0) {
            (true, true) => self.magnitudes().increasing(of, POSITIVE, POSITIVE),
            (false, true) => self.increasing(of, ALL, ALL),
            (true, false) if self.high < 0.0 => (-self).power(exponent),
            (false, false) if self.high < 0.0 => -(-self).power(exponent),
            _ => Self::WHOLE,
        }
    }

    /// The angle of the points with these ordinates and abscissas.
    fn angle(self, abscissa: Self) -> Self {
        let is_cut = abscissa.low <= 0.0 && self.contains(0.0);
        if is_cut {
            return Self::of_function(-PI, PI, ALL);
        }
        let corners = self.corners(abscissa, <f64 as Real>::atan2);
        Self::of_corners(corners, |low, high| Self::of_function(low, high, ALL))
    }

    fn modulo(self, divisor: Self) -> Self {
        let whole = Real::trunc(self / divisor);
        let most = divisor.magnitudes().high;
        match whole.point() {
            Some(_) => self - whole * divisor,
            None => Self::new(-most, most),
        }
    }
}

/// The range, or the domain, of a function that has no edges.
const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
const POSITIVE: [f64; 2] = [0.0, f64::INFINITY];
const UNIT: [f64; 2] = [-1.0, 1.0];

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([low, below], [high, above]) = (two_sum(self.low, other.low), two_sum(self.high, other.high));
        Self::new(if below == 0.0 { low } else { low.next_down() }, if above == 0.0 { high } else { high.next_up() })
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        for (factor, other) in [(self, other), (other, self)] {
            match factor.point() {
                Some(0.0) => return factor,
                Some(1.0) => return other,
                Some(-1.0) => return -other,
                _ => {}
            }
        }
        Self::of_corners(self.corners(other, |a, b| a * b), Self::rounded)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Self::WHOLE;
        }
        Self::of_corners(self.corners(other, |a, b| a / b), Self::rounded)
    }
}

macro_rules! enclose {
    (
        {}
        $($kind:ident { $($name:ident($($x:ident),*) {
            value: $value:tt; $form:ident: $derivative:expr; bounds: $bounds:expr; $($more:tt)*
        })* })*
    ) => {
        /// Bounds of every function.
        mod enclosures {
            use super::*;

            $($(
                pub(super) fn $name($($x: Interval),*) -> Interval {
                    $bounds
                }
            )*)*
        }
    };
}
elementary_functions!(rows of enclose! {});

macro_rules! unary {
    ($function:ident $x:expr) => {
        enclosures::$function($x)
    };
}

macro_rules! binary {
    ($function:ident $x:expr, $y:expr) => {
        enclosures::$function($x, $y)
    };
}

elementary_functions!(real_of_two_parts! {
    Interval: inline; lanes of self: self.low, self.high;
    {
        type Mask = Outcomes;

        fn of(x: f64) -> Self {
            Self::new(x, x)
        }
        fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::of(of_lane(0))
        }
        fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::new(of_lane(0), of_lane(1))
        }
        fn square(self) -> Self {
            let Self { low, high } = self.magnitudes();
            Self::new(f64::max((low * low).next_down(), 0.0), (high * high).next_up())
        }
        fn square_add(self, c: Self) -> Self {
            self.square() + c
        }
        fn square_from(self, c: Self) -> Self {
            c - self.square()
        }
        /// Methods of the user have no bounds.
        fn lane_by_lane<const N: usize>(
            _arguments: [Self; N],
            _value: impl Fn(usize, [f64; N]) -> f64,
            _slopes: impl Fn(usize, [f64; N]) -> [f64; N],
        ) -> Self {
            Self::WHOLE
        }
        fn sin_cos(self) -> (Self, Self) {
            (Real::sin(self), Real::cos(self))
        }
        fn finite(self) -> bool {
            self.low.is_finite() && self.high.is_finite()
        }
        fn less(self, other: Self) -> Outcomes {
            Outcomes { holds: self.low < other.high, fails: self.high >= other.low }
        }
        fn less_or_equal(self, other: Self) -> Outcomes {
            Outcomes { holds: self.low <= other.high, fails: self.high > other.low }
        }
        fn equal(self, other: Self) -> Outcomes {
            let same = self.point().is_some_and(|point| other.point() == Some(point));
            Outcomes { holds: self.low <= other.high && other.low <= self.high, fails: !same }
        }
        fn select(mask: Outcomes, a: Self, b: Self) -> Self {
            match mask {
                Outcomes { holds: true, fails: true } => a.union(b),
                Outcomes { holds, .. } => if holds { a } else { b },
            }
        }
    }
});

#[cfg(test)]
mod tests;
