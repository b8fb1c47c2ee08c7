//! Double-double numbers, the scalar of energies that are accurate to the last bit: a number and its rest, which
//! together have twice as many digits.
//!
//! In: lane 0 is a number, lane 1 what it carries. Out: lane 0 is the value, rounded once. Always true: sums, products,
//! quotients and roots are right to about 2^-104 (Dekker 1971); other functions are those of the rounded argument, as
//! good as in `f64`. What is not finite has no rest.

use crate::scalar::{
    elementary::Elementary,
    exact::{fast_two_sum, two_product, two_sum},
    fma::Fused,
    functions::elementary_functions,
    instruction_set::enter_fused_or_baseline,
    real::{Kernel, Real, compared, real_of_two_parts},
};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A sum of two doubles, the second one below half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    value: f64,
    rest: f64,
}

impl DoubleDouble {
    /// `value + rest`, where the rest is the smaller one.
    #[inline(always)]
    fn new(value: f64, rest: f64) -> Self {
        let [sum, lost] = fast_two_sum(value, rest);
        if sum.is_finite() { Self { value: sum, rest: lost } } else { Self { value, rest: 0.0 } }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let [sum, lost] = two_sum(self.value, other.value);
        Self::new(sum, lost + (self.rest + other.rest))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, rest: -self.rest }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let [product, lost] = two_product(<Fused<f64>>::new(self.value), Fused::new(other.value)).map(|part| part.0);
        Self::new(product, lost + (self.value * other.rest + self.rest * other.value))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let left = Elementary::mul_add(-quotient, other.value, self.value);
        Self::new(quotient, (left + (self.rest - quotient * other.rest)) / other.value)
    }
}

/// A function of one argument: exact but for one rounding where that takes no more than arithmetic.
macro_rules! unary {
    (sqrt $x:expr) => {{
        let root = Elementary::sqrt($x.value);
        let left = Elementary::mul_add(-root, root, $x.value) + $x.rest;
        DoubleDouble::new(root, left / (root + root))
    }};
    (abs $x:expr) => {
        if $x.value.is_sign_negative() { -$x } else { $x }
    };
    ($function:ident $x:expr) => {
        DoubleDouble::of(<f64 as Real>::$function($x.value))
    };
}

/// A function of two arguments. As in std, a NaN gives way to the other one.
macro_rules! binary {
    (min $x:expr, $y:expr) => {
        if $x <= $y || $y.value.is_nan() { $x } else { $y }
    };
    (max $x:expr, $y:expr) => {
        if $x >= $y || $y.value.is_nan() { $x } else { $y }
    };
    // The remainder of the values is exact, and what lies below their last digits is left as it is.
    (remainder $x:expr, $y:expr) => {
        DoubleDouble::new(
            Elementary::remainder($x.value, $y.value),
            $x.rest - Elementary::trunc($x.value / $y.value) * $y.rest,
        )
    };
    ($function:ident $x:expr, $y:expr) => {
        DoubleDouble::of(<f64 as Real>::$function($x.value, $y.value))
    };
}

elementary_functions!(real_of_two_parts! {
    DoubleDouble: inline(always); lanes of self: self.value, self.rest;
    {
        type Mask = bool;

        #[inline(always)]
        fn of(x: f64) -> Self {
            Self { value: x, rest: 0.0 }
        }
        #[inline(always)]
        fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::of(of_lane(0))
        }
        #[inline(always)]
        fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self::new(of_lane(0), of_lane(1))
        }
        #[inline(always)]
        fn lane_by_lane<const N: usize>(
            arguments: [Self; N],
            value: impl Fn(usize, [f64; N]) -> f64,
            _slopes: impl Fn(usize, [f64; N]) -> [f64; N],
        ) -> Self {
            Self::of(value(0, arguments.map(|argument| argument.value)))
        }
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            let (sine, cosine) = Real::sin_cos(self.value);
            (Self::of(sine), Self::of(cosine))
        }
        #[inline(always)]
        fn finite(self) -> bool {
            self.value.is_finite()
        }
        compared!();
        /// The products' errors are one instruction each in there, and the same bits as elsewhere.
        #[inline(always)]
        fn enter<K: Kernel>(kernel: K) -> K::Out {
            enter_fused_or_baseline(kernel)
        }
    }
});

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_float::{FBig, round::mode::HalfEven};

    type Big = FBig<HalfEven, 2>;

    fn big(x: f64) -> Big {
        Big::try_from(x).expect("a finite number").with_precision(400).value()
    }
    fn exact(x: DoubleDouble) -> Big {
        big(x.value) + big(x.rest)
    }

    /// Numbers with two parts: quotients have rests of all kinds.
    fn numbers() -> Vec<DoubleDouble> {
        let tenths = |k: i32| DoubleDouble::of(f64::from(k)) / DoubleDouble::of(10.0);
        (-30..30).map(tenths).chain([1e-9, 1e9, 3e17].map(|x| tenths(7) * DoubleDouble::of(x))).collect()
    }

    #[test]
    fn arithmetic_has_twice_the_digits() {
        // The bounds of these algorithms are a few 2^-104.
        let bound = big(2.0_f64.powi(-101));
        let off = |found: DoubleDouble, exact: Big, scale: Big| {
            let far = (self::exact(found) - exact).to_f64().value().abs();
            assert!(found.rest.abs() <= found.value.abs() * f64::EPSILON / 2.0, "{found:?} is rounded");
            far <= (scale * bound.clone()).to_f64().value().abs()
        };
        for &x in &numbers() {
            for &y in &numbers() {
                let (a, b) = (exact(x), exact(y));
                // A sum is as exact as its terms are long.
                let longer = if x.value.abs() > y.value.abs() { a.clone() } else { b.clone() };
                assert!(off(x + y, a.clone() + b.clone(), longer.clone()), "{x:?} + {y:?}");
                assert!(off(x - y, a.clone() - b.clone(), longer), "{x:?} - {y:?}");
                assert!(off(x * y, a.clone() * b.clone(), a.clone() * b.clone()), "{x:?} * {y:?}");
                if y.value != 0.0 {
                    assert!(off(x / y, a.clone() / b.clone(), a / b), "{x:?} / {y:?}");
                }
            }
            if x.value > 0.0 {
                let root = exact(Real::sqrt(x));
                let square = (root.clone() * root - exact(x)).to_f64().value().abs();
                assert!(square <= x.value * 2.0_f64.powi(-100), "sqrt({x:?})");
            }
        }
    }

    #[test]
    fn non_finite_values_are_those_of_f64() {
        let edges = [0.0, -0.0, 1.0, -1.0, f64::MAX, f64::MIN_POSITIVE, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        let same = |found: DoubleDouble, expected: f64, what: &str| {
            let equal = found.value == expected || (found.value.is_nan() && expected.is_nan());
            // The root of the largest number lies between two, and both parts together are nearer to it than either.
            let near = (found.value - expected).abs() <= f64::EPSILON * expected.abs();
            assert!((equal || near) && found.rest.is_finite(), "{what}: {found:?}, {expected}");
        };
        for x in edges {
            same(Real::sqrt(DoubleDouble::of(x)), x.sqrt(), &format!("sqrt({x})"));
            same(Real::abs(DoubleDouble::of(x)), x.abs(), &format!("abs({x})"));
            same(Real::cos(DoubleDouble::of(x)), Real::cos(x), &format!("cos({x})"));
            for y in edges {
                let (a, b) = (DoubleDouble::of(x), DoubleDouble::of(y));
                same(a + b, x + y, &format!("{x} + {y}"));
                same(a - b, x - y, &format!("{x} - {y}"));
                same(a * b, x * y, &format!("{x} * {y}"));
                same(a / b, x / y, &format!("{x} / {y}"));
                same(Real::min(a, b), x.min(y), &format!("min({x}, {y})"));
                same(Real::max(a, b), x.max(y), &format!("max({x}, {y})"));
            }
        }
    }
}
