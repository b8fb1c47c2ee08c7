//! Numbers of 106 bits, kept as an unevaluated sum of two `f64`.
//!
//! The order conditions cancel, and published coefficients have up to 45 digits; both need more precision than `f64`.
//! The error of each operation is a few units of 2^-104 at most, and `high` is always the `f64` nearest to the sum.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sum `high + low`, where `low` is at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    pub(super) const ZERO: Self = Self { high: 0.0, low: 0.0 };
    pub(super) const ONE: Self = Self { high: 1.0, low: 0.0 };

    /// The nearest value to an integer; exact up to 2^106.
    pub(super) fn integer(value: u128) -> Self {
        let high = value as f64;
        // `as` saturates, so a value that rounds up to 2^128 still has a small, exact remainder.
        let rounded = high as u128;
        let low = if rounded >= value { -((rounded - value) as f64) } else { (value - rounded) as f64 };
        quick_sum(high, low)
    }

    /// The nearest `f64`.
    pub(super) fn value(self) -> f64 {
        self.high
    }

    pub(super) fn is_finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }

    pub(super) fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub(super) fn power(self, exponent: u32) -> Self {
        let (mut product, mut square, mut rest) = (Self::ONE, self, exponent);
        while rest > 0 {
            if rest & 1 == 1 {
                product = product * square;
            }
            square = square * square;
            rest >>= 1;
        }
        product
    }

    /// The positive `degree`-th root of a number that is not negative, `degree` at least 1.
    ///
    /// Newton's step doubles the 53 correct bits of the `f64` root once; the second step removes what rounding left.
    pub(super) fn root(self, degree: u32) -> Self {
        if self.high == 0.0 {
            return Self::ZERO;
        }
        let n = Self::from(f64::from(degree));
        let mut root = Self::from(self.high.powf(1.0 / f64::from(degree)));
        for _ in 0..2 {
            let slope = root.power(degree - 1);
            root = root - (root * slope - self) / (n * slope);
        }
        root
    }
}

impl From<f64> for Double {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let sum = quick_sum(high, high_error + low);
        quick_sum(sum.high, sum.low + low_error)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        quick_sum(high, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        quick_sum(first, second) + Self::from(rest.high / other.high)
    }
}

/// `a + b` and the error of that sum, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    (sum, (a - (sum - from_b)) + (b - from_b))
}

/// Renormalises a sum whose first part is the larger one.
fn quick_sum(high: f64, low: f64) -> Double {
    let sum = high + low;
    Double { high: sum, low: low - (sum - high) }
}

#[cfg(test)]
mod tests {
    use super::Double;

    fn close(a: Double, b: Double) -> bool {
        (a - b).abs().value() <= 1e-31 * b.abs().value()
    }

    fn number(value: u128) -> Double {
        Double::integer(value)
    }

    #[test]
    fn integers_keep_106_bits() {
        let large = (1_u128 << 105) + 1;
        assert_eq!((number(large) - number(large - 1)).value(), 1.0);
        assert!(number(u128::MAX).is_finite());
    }

    #[test]
    fn operations_undo_each_other() {
        let third = Double::ONE / number(3);
        assert!(close(third * number(3), Double::ONE));
        assert!(close(third + third + third, Double::ONE));
        assert!(close(number(7) / (number(7) / number(11)), number(11)));
        assert!(close(third.power(5) * number(243), Double::ONE));
    }

    #[test]
    fn roots_are_exact_to_the_last_bits() {
        for degree in 1..12 {
            assert!(close(number(2).root(degree).power(degree), number(2)), "root {degree} of 2");
        }
        assert_eq!(Double::ZERO.root(3), Double::ZERO);
        // The first 32 digits of the square root of 2.
        let digits = number(14142135623730950488016887242097) / number(10).power(31);
        assert!(close(number(2).root(2), digits));
    }

    #[test]
    fn a_difference_below_f64_is_seen() {
        let nearly = Double::ONE + Double::from(1e-25);
        assert_eq!((nearly - Double::ONE).value(), 1e-25);
        assert_eq!(nearly.value(), 1.0);
    }
}
