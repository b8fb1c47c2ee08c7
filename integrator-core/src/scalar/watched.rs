//! A scalar that records comparisons: an `f64` with a record of its conditions, signs and roundings.
//!
//! In: a state. Out: what code does in `f64` at it, and a list of the sides that its comparisons took, in their order.
//! Always true: values are those of `f64`; between two lists that are alike up to some place, the same comparisons stand.

use crate::scalar::{
    functions::elementary_functions,
    real::{Real, real_of_two_parts},
};
use core::{
    cell::RefCell,
    ops::{Add, Div, Mul, Neg, Sub},
};

std::thread_local! {
    static TAKEN: RefCell<Vec<Side>> = const { RefCell::new(Vec::new()) };
}

/// The side that a comparison took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Side {
    /// The operator or function that compares, as it is written.
    pub(crate) by: &'static str,
    /// Whether the condition holds, the sign, or the whole number.
    pub(crate) taken: f64,
    /// The numbers that are compared.
    pub(crate) operands: [f64; 2],
}

/// Returns the result of some code, and the sides that its comparisons take on this thread.
pub(crate) fn sides_of<T>(code: impl FnOnce() -> T) -> (T, Vec<Side>) {
    let outer = TAKEN.take();
    let value = code();
    (value, TAKEN.replace(outer))
}

fn note(by: &'static str, taken: f64, operands: [f64; 2]) {
    TAKEN.with_borrow_mut(|sides| sides.push(Side { by, taken, operands }));
}

/// Notes whether a condition holds.
fn noted(by: &'static str, holds: bool, [a, b]: [Watched; 2]) -> bool {
    note(by, f64::from(u8::from(holds)), [a.0, b.0]);
    holds
}

/// A number whose comparisons are noted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watched(f64);

impl Add for Watched {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Watched {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Watched {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Watched {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Watched {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// A function of one argument; those with kinks and jumps note their side of these.
macro_rules! unary {
    (abs $x:ident) => {
        unary!(@sign abs $x)
    };
    (signum $x:ident) => {
        unary!(@sign signum $x)
    };
    (@sign $function:ident $x:ident) => {{
        note(stringify!($function), if $x.0 < 0.0 { -1.0 } else { 1.0 }, [$x.0, 0.0]);
        Self(Real::$function($x.0))
    }};
    (floor $x:ident) => {
        unary!(@whole floor $x)
    };
    (ceil $x:ident) => {
        unary!(@whole ceil $x)
    };
    (trunc $x:ident) => {
        unary!(@whole trunc $x)
    };
    (round $x:ident) => {
        unary!(@whole round $x)
    };
    (round_ties_even $x:ident) => {
        unary!(@whole round_ties_even $x)
    };
    (@whole $function:ident $x:ident) => {{
        let whole = Real::$function($x.0);
        note(stringify!($function), whole, [$x.0, whole]);
        Self(whole)
    }};
    ($function:ident $x:ident) => {
        Self(Real::$function($x.0))
    };
}

/// A function of two arguments.
macro_rules! binary {
    (min $x:ident, $y:ident) => {{
        noted("min", $x.0 <= $y.0, [$x, $y]);
        Self(Real::min($x.0, $y.0))
    }};
    (max $x:ident, $y:ident) => {{
        noted("max", $x.0 >= $y.0, [$x, $y]);
        Self(Real::max($x.0, $y.0))
    }};
    (remainder $x:ident, $y:ident) => {{
        note("%", Real::trunc($x.0 / $y.0), [$x.0, $y.0]);
        Self(Real::remainder($x.0, $y.0))
    }};
    ($function:ident $x:ident, $y:ident) => {
        Self(Real::$function($x.0, $y.0))
    };
}

elementary_functions!(real_of_two_parts! {
    Watched: inline; lanes of self: self.0, 0.0;
    {
        type Mask = bool;

        fn of(x: f64) -> Self {
            Self(x)
        }
        fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self(of_lane(0))
        }
        fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
            Self(of_lane(0))
        }
        fn sin_cos(self) -> (Self, Self) {
            (Self(Real::sin(self.0)), Self(Real::cos(self.0)))
        }
        fn finite(self) -> bool {
            self.0.is_finite()
        }
        fn less(self, other: Self) -> bool {
            noted("<", self.0 < other.0, [self, other])
        }
        fn less_or_equal(self, other: Self) -> bool {
            noted("<=", self.0 <= other.0, [self, other])
        }
        fn equal(self, other: Self) -> bool {
            noted("==", self.0 == other.0, [self, other])
        }
        fn select(mask: bool, a: Self, b: Self) -> Self {
            if mask { a } else { b }
        }
    }
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_comparison_notes_its_side() {
        let code = |x: f64| {
            let (x, one) = (Watched(x), Watched(1.0));
            let (_, inner) = sides_of(|| x.less(one));
            assert_eq!(inner.len(), 1);
            let below = Watched::select(x.less(one), Real::abs(x), Real::floor(x));
            (below + Real::sqrt(Real::max(x, one))).0
        };
        let (value, sides) = sides_of(|| code(2.5));
        assert_eq!(value, 2.0 + 2.5_f64.sqrt());
        let taken: Vec<_> = sides.iter().map(|side| (side.by, side.taken)).collect();
        assert_eq!(taken, [("<", 0.0), ("abs", 1.0), ("floor", 2.0), ("max", 1.0)]);
        let (_, other) = sides_of(|| code(-0.5));
        let taken: Vec<_> = other.iter().map(|side| side.taken).collect();
        assert_eq!(taken, [1.0, -1.0, -1.0, 0.0]);
        assert_eq!(other[0].operands, [-0.5, 1.0]);
        assert!(sides_of(|| Real::sin(Watched(1.0)) * Watched(2.0)).1.is_empty());
    }
}
