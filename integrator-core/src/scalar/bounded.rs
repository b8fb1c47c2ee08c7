//! The scalar of a running error analysis (Higham, Accuracy and Stability of Numerical Algorithms, section 3.3): a
//! number and a bound on its rounding error.
//!
//! In: exact coordinates, constants that are rounded a few times. Out: lane 0 is the value, as in `f64`; lane 1 the
//! bound. Always true: where a comparison or the edge of a domain lies within the bounds, both sides are allowed for,
//! and where there is no bound it is infinite. A number that is certainly not finite has the bound zero.

use crate::scalar::{
    functions::elementary_functions,
    real::{Mask, Real, real_of_two_parts},
};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The rounding error of an operation, relative to its result: half of this, and the other half for the roundings of
/// the bound.
const ROUNDING: f64 = f64::EPSILON;

/// The error of an elementary function: up to four units in the last index.
const FUNCTION: f64 = 4.0 * f64::EPSILON;

/// A number and a bound on its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded {
    value: f64,
    error: f64,
}

impl Bounded {
    /// A result of some operands with a bound that is made of theirs.
    fn of_operands<const N: usize>(value: f64, operands: [Self; N], error: f64) -> Self {
        let unknown = operands.iter().any(|operand| operand.error == f64::INFINITY);
        let error = match (unknown, value.is_finite()) {
            (false, true) if !error.is_nan() => error,
            (false, false) => 0.0,
            _ => f64::INFINITY,
        };
        Self { value, error }
    }

    /// A bound on the change of a smooth function within an interval: twice its change from `value` in the middle to
    /// the ends, or infinite where its domain ends within.
    fn spread(value: f64, ends: [f64; 2]) -> f64 {
        let inside = ends.iter().all(|end| end.is_finite() == value.is_finite());
        let farthest = ends.iter().fold(0.0, |most, end| f64::max(most, Real::abs(end - value)));
        if inside { 2.0 * farthest } else { f64::INFINITY }
    }

    /// A function of one argument.
    fn unary(self, function: impl Fn(f64) -> f64) -> Self {
        let Self { value: x, error } = self;
        let value = function(x);
        let moved = if error == 0.0 { 0.0 } else { Self::spread(value, [function(x - error), function(x + error)]) };
        if moved == f64::INFINITY {
            return Self { value, error: moved };
        }
        Self::of_operands(value, [self], moved + FUNCTION * Real::abs(value))
    }

    /// A function of two arguments.
    fn binary(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        let of_first = self.unary(|x| function(x, other.value));
        let of_second = other.unary(|y| function(self.value, y));
        Self::of_operands(of_first.value, [of_first, of_second], of_first.error + of_second.error)
    }

    /// A comparison, which is in doubt where the two are nearer to each other than their error bounds.
    fn compared(self, other: Self, holds: bool) -> Truth {
        let error = self.error + other.error;
        let apart = Real::abs(self.value - other.value) > error;
        Truth { holds, doubtful: error != 0.0 && !apart }
    }
}

/// Whether a condition holds, and whether rounding might have decided so.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Truth {
    holds: bool,
    doubtful: bool,
}

impl Mask for Truth {
    fn of(holds: bool) -> Self {
        Self { holds, doubtful: false }
    }
    fn any(self) -> bool {
        self.holds || self.doubtful
    }
    fn and(self, other: Self) -> Self {
        let possible = self.any() && other.any();
        Self { holds: self.holds && other.holds, doubtful: possible && (self.doubtful || other.doubtful) }
    }
    fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
    fn not(self) -> Self {
        Self { holds: !self.holds, ..self }
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self::of_operands(value, [self, other], self.error + other.error + ROUNDING * Real::abs(value))
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let of_operands = Real::abs(self.value) * other.error + (Real::abs(other.value) + other.error) * self.error;
        // The rounding error of a subnormal product is far below the smallest normal one; a product with zero is exact.
        let zero = self.value == 0.0 || other.value == 0.0;
        let rounding = if zero { 0.0 } else { ROUNDING * Real::abs(value) + f64::MIN_POSITIVE };
        Self::of_operands(value, [self, other], of_operands + rounding)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let nearest = Real::abs(other.value) - other.error;
        if nearest <= 0.0 && other.error > 0.0 {
            return Self { value, error: f64::INFINITY };
        }
        let of_operands = (self.error + Real::abs(value) * other.error) / nearest;
        let rounding = ROUNDING * Real::abs(value) + f64::MIN_POSITIVE;
        Self::of_operands(value, [self, other], of_operands + rounding)
    }
}

/// A function of one argument.
macro_rules! unary {
    ($function:ident $x:expr) => {
        $x.unary(<f64 as Real>::$function)
    };
}

/// A function of two arguments.
macro_rules! binary {
    ($function:ident $x:expr, $y:expr) => {
        $x.binary($y, <f64 as Real>::$function)
    };
}

elementary_functions!(real_of_two_parts! {
    Bounded: inline; lanes of self: self.value, self.error;
    {
        type Mask = Truth;

        fn of(x: f64) -> Self {
            Self { value: x, error: 0.0 }
        }
        /// Constants are products of parameters in another order than the user's.
        fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
            let value = of_lane(0);
            Self::of_operands(value, [], FUNCTION * Real::abs(value))
        }
        fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::of(of_lane(0))
        }
        fn lane_by_lane<const N: usize>(
            arguments: [Self; N],
            value: impl Fn(usize, [f64; N]) -> f64,
            _slopes: impl Fn(usize, [f64; N]) -> [f64; N],
        ) -> Self {
            let at = arguments.map(|argument| argument.value);
            let by_each = core::array::from_fn::<Self, N, _>(|index| {
                arguments[index].unary(|x| value(0, core::array::from_fn(|other| if other == index { x } else { at[other] })))
            });
            let error = by_each.iter().map(|by| by.error).sum();
            Self::of_operands(value(0, at), by_each, error)
        }
        fn sin_cos(self) -> (Self, Self) {
            (Real::sin(self), Real::cos(self))
        }
        fn finite(self) -> bool {
            self.value.is_finite()
        }
        fn less(self, other: Self) -> Truth {
            self.compared(other, self.value < other.value)
        }
        fn less_or_equal(self, other: Self) -> Truth {
            self.compared(other, self.value <= other.value)
        }
        fn equal(self, other: Self) -> Truth {
            self.compared(other, self.value == other.value)
        }
        fn select(mask: Truth, a: Self, b: Self) -> Self {
            let chosen = if mask.holds { a } else { b };
            if !mask.doubtful {
                return chosen;
            }
            let apart = Real::abs(a.value - b.value);
            let error = if apart.is_finite() { a.error + b.error + apart } else { f64::INFINITY };
            Self { error, ..chosen }
        }
    }
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::double_double::DoubleDouble;

    /// A number that is as far off as the bound says at most.
    fn about(value: f64, error: f64) -> Bounded {
        Bounded { value, error }
    }

    #[test]
    fn sums_that_cancel_lose_no_more_than_the_bound() {
        // Σ (xᵢ - xᵢ₊₁)² expanded, where nearly all cancels; double-double arithmetic gives the true value.
        fn expanded<R: Real>(x: &[f64]) -> R {
            let [two, mut sum] = [R::of(2.0), R::of(0.0)];
            for pair in x.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(R::of);
                sum += a * a - two * a * b + b * b;
            }
            sum
        }
        for shift in [0.0, 1e3, 1e6, 1e9] {
            let x: Vec<f64> = (0..40).map(|k| shift + 1.0 / f64::from(k + 3)).collect();
            let (found, exact) = (expanded::<Bounded>(&x), expanded::<DoubleDouble>(&x).lane(0));
            let off = (found.value - exact).abs();
            assert!(off <= found.error, "{found:?}, {exact} at {shift}");
            assert!(found.error <= 1e-12 * (1.0 + shift * shift), "{found:?} says something at {shift}");
            assert_eq!(found.value, expanded::<f64>(&x), "the value is that of f64");
        }
    }

    #[test]
    fn every_operation_bounds_what_its_operands_may_be() {
        type Two = fn(Bounded, Bounded) -> Bounded;
        let table: [(&str, Two); 8] = [
            ("+", |a, b| a + b),
            ("-", |a, b| a - b),
            ("*", |a, b| a * b),
            ("/", |a, b| a / b),
            ("hypot", Real::hypot),
            ("powf", Real::powf),
            ("sin", |a, _| Real::sin(a)),
            ("if", |a, b| Real::select(a.less(b), a * a, b)),
        ];
        for (name, operation) in table {
            for (x, y) in [(0.7, 1.3), (2.0, 2.0), (1.0, 1.0 + 1e-9), (3.0, 1e-3)] {
                let (a, b) = (about(x, 1e-8), about(y, 1e-9));
                let found = operation(a, b);
                for (dx, dy) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0), (0.3, 0.0)] {
                    // A little less, since these sums round.
                    let moved = operation(Bounded::of(x + dx * 0.99e-8), Bounded::of(y + dy * 0.99e-9));
                    let off = (moved.value - found.value).abs();
                    assert!(off <= found.error + moved.error, "{name} at {x}, {y}: {found:?}, {moved:?}");
                }
            }
        }
    }

    #[test]
    fn unknown_values_are_unbounded() {
        assert_eq!(Real::sqrt(about(1e-17, 1e-16)).error, f64::INFINITY);
        assert_eq!((Bounded::of(1.0) / about(0.0, 1e-16)).error, f64::INFINITY);
        assert_eq!((about(1.0, f64::INFINITY) * Bounded::of(0.0)).error, f64::INFINITY);
        assert_eq!(Real::sqrt(Bounded::of(0.0) * Bounded::of(0.0)).error, 0.0, "the distance of what coincides");
        // Numbers that are certainly infinite or NaN are known to be.
        for value in [Bounded::of(1.0) / Bounded::of(0.0), Real::sqrt(Bounded::of(-1.0)), Real::ln(Bounded::of(-1.0))] {
            assert!(!value.value.is_finite() && value.error == 0.0, "{value:?}");
        }
        let (yes, doubtful) = (Truth::of(true), about(1.0, 1e-9).less(Bounded::of(1.0)));
        assert!(doubtful.any() && doubtful.not().any() && !yes.not().any());
        assert!(yes.and(doubtful).doubtful && !yes.or(doubtful).doubtful && !yes.not().and(doubtful).any());
    }
}
