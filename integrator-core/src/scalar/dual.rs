//! The scalar of exact derivatives: a number and its derivatives along some directions, carried through the very code
//! that a run executes.
//!
//! In: lane 0 is the point, the lanes after it are directions. Out: lane 0 is the value, with the bits that the code
//! has without derivatives; the lanes after it are its derivatives along the directions. Always true: a direction that
//! is not a number, or a derivative that is infinite, comes out as not a number or infinite, never as a plausible
//! number; at kinks and jumps, of `abs`, `min`, `max` and steps, the derivative is that of one side.

mod in_memory;
mod side_by_side;

use crate::scalar::{
    functions::elementary_functions,
    implicit::{Image, Implicit},
    real::{Kernel, Mask, Real},
    simd::lanes::Lanes,
};
use core::{
    f64::consts::{LN_2, LN_10},
    ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign},
};

/// A number in `F` and its first derivatives along `N` directions; `ROW`, where it is a row of bodies or a block of
/// sites, each of them such a number; `SENSITIVE`, where prepared constants have derivatives of their own, since
/// directions lead along parameters as well.
///
/// If `F` has lanes itself, the value and the derivatives of one lane of `F` are neighbours. So they are in memory, that
/// an array of such numbers with one direction is one of pairs, which vectors read whole.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Dual<F = f64, const N: usize = 1, const ROW: bool = false, const SENSITIVE: bool = false> {
    value: F,
    along: [F; N],
}

/// A number with its derivative along each direction. A plain loop: what it calls belongs to a multiversioned variant, and
/// a closure might be compiled outside of it.
macro_rules! dual {
    ($value:expr, $direction:ident => $along:expr) => {{
        let value = $value;
        let mut along = [value; N];
        for $direction in 0..N {
            along[$direction] = $along;
        }
        Self { value, along }
    }};
}
use dual;

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Dual<F, N, ROW, SENSITIVE> {
    /// A function of this number that has a value and a slope here.
    #[inline(always)]
    fn chain(self, value: F, slope: F) -> Self {
        dual!(value, direction => slope * self.along[direction])
    }

    /// A function of two numbers that has a value and two slopes here.
    #[inline(always)]
    fn chain_of_two(x: Self, y: Self, value: F, by_x: F, by_y: F) -> Self {
        dual!(value, direction => by_x.fma(x.along[direction], by_y * y.along[direction]))
    }

    /// Returns a number with this value, and the derivatives of `a` in the lanes of `mask`, of `b` in the others.
    #[inline(always)]
    fn select_along(value: F, mask: F::Mask, a: Self, b: Self) -> Self {
        dual!(value, direction => F::select(mask, a.along[direction], b.along[direction]))
    }

    /// Whether the number is constant along all directions, in all lanes.
    #[inline(always)]
    fn is_constant(&self) -> bool {
        let mut constant = true;
        for along in self.along {
            constant = constant
                && if const { is_plain::<F>() } { !along.equal(F::of(0.0)).not().any() } else { vanishes(along) };
        }
        constant
    }
}

impl<F: Real> Dual<F> {
    /// A number with its derivative along one direction.
    #[inline(always)]
    pub(crate) fn along(value: F, slope: F) -> Self {
        Self { value, along: [slope] }
    }

    /// Returns the derivative along the direction.
    #[inline(always)]
    pub(crate) fn slope(self) -> F {
        self.along[0]
    }
}

/// Numbers of points without derivatives, or their derivatives along one direction.
macro_rules! apart {
    ($duals:expr, $dual:ident => $part:expr) => {{
        let duals = $duals;
        let mut numbers = [F::of(0.0); _];
        for (number, $dual) in numbers.iter_mut().zip(duals) {
            *number = $part;
        }
        numbers
    }};
}

/// Whether every lane of a number is a number of its own, and none a derivative of another one.
const fn is_plain<F: Real>() -> bool {
    F::LANES == F::MEMBERS
}

/// Whether a number is zero, with the derivatives that it has itself.
fn vanishes<F: Real>(number: F) -> bool {
    (0..F::LANES).all(|lane| number.lane(lane) == 0.0)
}

/// Returns the contribution of a slope along a direction. An unknown slope is NaN; it must not reach a result that it
/// does not change.
#[inline(always)]
fn product<F: Real>(slope: F, along: F) -> F {
    let zero = F::of(0.0);
    if const { is_plain::<F>() } {
        return F::select(along.equal(zero), zero, slope * along);
    }
    if vanishes(along) { zero } else { slope * along }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Add for Dual<F, N, ROW, SENSITIVE> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        dual!(self.value + other.value, direction => self.along[direction] + other.along[direction])
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Sub for Dual<F, N, ROW, SENSITIVE> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        dual!(self.value - other.value, direction => self.along[direction] - other.along[direction])
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Mul for Dual<F, N, ROW, SENSITIVE> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::chain_of_two(self, other, self.value * other.value, other.value, self.value)
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Div for Dual<F, N, ROW, SENSITIVE> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let inverse = F::of(1.0) / other.value;
        Self::chain_of_two(self, other, value, inverse, -(value * inverse))
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> Neg for Dual<F, N, ROW, SENSITIVE> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        dual!(-self.value, direction => -self.along[direction])
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> AddAssign for Dual<F, N, ROW, SENSITIVE> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<F: Real, const N: usize, const ROW: bool, const SENSITIVE: bool> SubAssign for Dual<F, N, ROW, SENSITIVE> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// The faster functions of `Real`: their values, with slopes that need not be fast.
macro_rules! fast_dual {
    (unary: $($unary:ident $precise:ident)*; binary: $($binary:ident $other:ident)*;) => {
        $(
            #[inline]
            fn $unary(self) -> Self {
                Self { value: self.value.$unary(), ..Real::$precise(self) }
            }
        )*
        $(
            #[inline]
            fn $binary(self, other: Self) -> Self {
                Self { value: self.value.$binary(other.value), ..Real::$other(self, other) }
            }
        )*
    };
}

macro_rules! dual_real {
    (
        { $is_row:literal, Block = $block:ty, Row<$bodies:ident> = $row:ty, Wide = $wide:ty; }
        unary { $($unary:ident($x:ident) { value: $value:tt; slope: $value_and_slope:expr; $($more:tt)* })* }
        binary { $($binary:ident($a:ident, $b:ident) { value: $value_of_two:tt; dual: $dual:expr; $($more_of_two:tt)* })* }
    ) => {
        impl<F: Real, const N: usize, const SENSITIVE: bool> Real for Dual<F, N, $is_row, SENSITIVE> {
            const LANES: usize = F::LANES * (1 + N);
            const BEYOND_BASELINE: bool = F::BEYOND_BASELINE;
            const MEMBERS: usize = F::MEMBERS;
            const LANEWISE: bool = F::LANEWISE;
            type Mask = F::Mask;
            type Block = $block;
            type Row<const $bodies: usize> = $row;
            type Wide = $wide;
            type Bundle = $wide;
            type Pair = Lanes<Self, 2>;

            #[inline(always)]
            fn of(x: f64) -> Self {
                // Minus zero, which changes no number that it is added to, so that the compiler leaves the addition out.
                Self { value: F::of(x), along: [F::of(-0.0); N] }
            }
            #[inline(always)]
            fn lane(self, lane: usize) -> f64 {
                match lane % (1 + N) {
                    0 => self.value.lane(lane / (1 + N)),
                    behind => self.along[behind - 1].lane(lane / (1 + N)),
                }
            }
            #[inline(always)]
            fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
                Self { value: F::parameter(&|lane| of_lane(lane * (1 + N))), along: [F::of(0.0); N] }
            }
            #[inline(always)]
            fn prepared(of_lane: &dyn Fn(usize) -> f64) -> Self {
                if const { SENSITIVE } { Self::state(of_lane) } else { Self::parameter(of_lane) }
            }
            #[inline(always)]
            fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
                let part = |part: usize| F::state(&|lane| of_lane(lane * (1 + N) + part));
                dual!(part(0), direction => part(direction + 1))
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                dual!(self.value.fma(b.value, c.value), direction => {
                    let by_b = self.value.fma(b.along[direction], c.along[direction]);
                    b.value.fma(self.along[direction], by_b)
                })
            }
            #[inline(always)]
            fn scale(self, x: Self) -> Self {
                if const { SENSITIVE } {
                    return self * x;
                }
                dual!(self.value.scale(x.value), direction => self.value.scale(x.along[direction]))
            }
            #[inline(always)]
            fn scale_add(self, x: Self, y: Self) -> Self {
                if const { SENSITIVE } {
                    return self.fma(x, y);
                }
                dual!(self.value.scale_add(x.value, y.value), direction => {
                    self.value.scale_add(x.along[direction], y.along[direction])
                })
            }
            #[inline(always)]
            fn square(self) -> Self {
                self.chain(self.value.square(), self.value + self.value)
            }
            #[inline(always)]
            fn square_add(self, c: Self) -> Self {
                let slope = self.value + self.value;
                dual!(self.value.square_add(c.value), direction => slope.fma(self.along[direction], c.along[direction]))
            }
            #[inline(always)]
            fn square_from(self, c: Self) -> Self {
                let slope = -(self.value + self.value);
                dual!(self.value.square_from(c.value), direction => slope.fma(self.along[direction], c.along[direction]))
            }
            #[inline]
            fn lane_by_lane<const A: usize>(
                arguments: [Self; A],
                value: impl Fn(usize, [f64; A]) -> f64,
                slopes: impl Fn(usize, [f64; A]) -> [f64; A],
            ) -> Self {
                let at = arguments.map(|argument| argument.value);
                // Of a slope, no derivatives are known.
                let parts = F::LANES / F::MEMBERS.max(1);
                let slope = |number: usize| {
                    F::state(&|lane| match lane % parts {
                        0 => slopes(lane, at.map(|argument| argument.lane(lane)))[number],
                        _ => f64::NAN,
                    })
                };
                let mut result = Self::of(0.0);
                result.value = F::lane_by_lane(at, &value, &slopes);
                for (number, argument) in arguments.iter().enumerate() {
                    let slope = slope(number);
                    for (sum, along) in result.along.iter_mut().zip(argument.along) {
                        *sum += product(slope, along);
                    }
                }
                result
            }
            #[inline(always)]
            fn solved<M: Implicit<D, C>, const D: usize, const C: usize>(
                [q, p]: [[Self; D]; 2],
                constants: [Self; C],
            ) -> Image<Self, D> {
                let point = [apart!(q, dual => dual.value), apart!(p, dual => dual.value)];
                let of_constants = apart!(constants, dual => dual.value);
                let (image, solution) = M::solve(point, of_constants);
                let at = M::slopes(point, of_constants, solution);
                let mut to = [[Self::of(0.0); D]; 2];
                for half in 0..2 {
                    for d in 0..D {
                        to[half][d].value = image.point[half][d];
                    }
                }
                for direction in 0..N {
                    let point = [apart!(q, dual => dual.along[direction]), apart!(p, dual => dual.along[direction])];
                    let slopes = M::slope(&at, point, apart!(constants, dual => dual.along[direction]));
                    for half in 0..2 {
                        for d in 0..D {
                            to[half][d].along[direction] = slopes[half][d];
                        }
                    }
                }
                image.with(to)
            }
            #[inline(always)]
            fn div_sqrt(self, x: Self) -> Self {
                let value = self.value.div_sqrt(x.value);
                let by_x = F::of(-0.5) * value / x.value;
                if self.is_constant() {
                    return x.chain(value, by_x);
                }
                Self::chain_of_two(self, x, value, F::of(1.0).div_sqrt(x.value), by_x)
            }
            #[inline(always)]
            fn div_pow_3_2(self, x: Self) -> Self {
                let value = self.value.div_pow_3_2(x.value);
                let by_x = F::of(-1.5) * value / x.value;
                if self.is_constant() {
                    return x.chain(value, by_x);
                }
                Self::chain_of_two(self, x, value, F::of(1.0).div_pow_3_2(x.value), by_x)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = self.value.sin_cos();
                (self.chain(sine, cosine), self.chain(cosine, -sine))
            }
            elementary_functions!(fast ones of fast_dual!);
            #[inline(always)]
            fn finite(self) -> bool {
                let mut finite = self.value.finite();
                for along in self.along {
                    finite = finite && along.finite();
                }
                finite
            }
            #[inline(always)]
            fn less(self, other: Self) -> Self::Mask {
                self.value.less(other.value)
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> Self::Mask {
                self.value.less_or_equal(other.value)
            }
            #[inline(always)]
            fn equal(self, other: Self) -> Self::Mask {
                self.value.equal(other.value)
            }
            #[inline(always)]
            fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
                Self::select_along(F::select(mask, a.value, b.value), mask, a, b)
            }
            $(
                #[inline]
                fn $unary(self) -> Self {
                    let $x = self.value;
                    let (value, slope) = $value_and_slope;
                    dual!(value, direction => product(slope, self.along[direction]))
                }
            )*
            $(
                #[inline]
                fn $binary(self, other: Self) -> Self {
                    let ($a, $b) = (self, other);
                    $dual
                }
            )*
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                F::enter(kernel)
            }
        }
    };
}
elementary_functions!(rows of dual_real! {
    false,
    Block = Dual<F::Block, N, true, SENSITIVE>,
    Row<BODIES> = Dual<F::Row<BODIES>, N, true, SENSITIVE>,
    Wide = Dual<F::Wide, N, true, SENSITIVE>;
});
elementary_functions!(rows of dual_real! { true, Block = Self, Row<BODIES> = Lanes<Self, BODIES>, Wide = Self; });

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{elementary::Elementary, tolerance::within};

    fn new(value: f64, along: f64) -> Dual {
        Dual { value, along: [along] }
    }

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
                    (name, Real::$unary(new(x, 2.0)), Elementary::$unary(x), quotient(Elementary::$unary, x))
                }),*]
            }
            /// Every binary function, both arguments moving.
            fn binary_table() -> Vec<(&'static str, Dual, f64, f64)> {
                vec![$({
                    let (x, y) = (new(0.8, 2.0), new(1.3, -1.0));
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
        let at = |x| new(x, 1.0);
        let table = [
            ("tanh far out", at(800.0).tanh(), 1.0, 0.0),
            ("a negative base", at(-2.0).powf(<Dual>::of(3.0)), -8.0, 12.0),
            ("a power at zero", at(0.0).powf(<Dual>::of(2.0)), 0.0, 0.0),
            ("the angle on the axis", at(1.0).atan2(new(0.0, 1.0)), std::f64::consts::FRAC_PI_2, -1.0),
            ("a huge hypotenuse", at(3e200).hypot(<Dual>::of(4e200)), 5e200, 0.6),
        ];
        for (name, dual, value, derivative) in table {
            assert!(within(dual.lane(0) - value, 4.0 * f64::EPSILON * value.abs()), "{name}: {dual:?}");
            assert!(within(dual.lane(1) - derivative, 4.0 * f64::EPSILON), "{name}: {dual:?}");
        }
        assert!(!at(0.0).sqrt().finite(), "a derivative that does not exist is not finite");
    }

    /// The second derivatives of a function of one number along one direction, by duals over duals, against those of
    /// its slope.
    #[test]
    fn duals_over_duals_have_second_derivatives() {
        let at = |x: f64, mixed: f64| Dual { value: new(x, 1.0), along: [new(1.0, mixed)] };
        let second = |number: Dual<Dual>| number.lane(3);
        for (name, dual, exact) in [
            ("sine", at(0.6, 0.0).sin(), -0.6_f64.sin()),
            ("quotient", Dual::of(1.0) / at(2.0, 0.0), 0.25),
            ("a power", at(2.0, 0.0).powf(Dual::of(3.0)), 12.0),
            ("a square", at(3.0, 0.5).square(), 5.0),
            ("a square and a line", at(3.0, 0.5).square_add(at(3.0, 0.25)), 5.25),
            ("a reciprocal root", at(2.0, 0.0).div_sqrt(at(2.0, 0.0)), -0.25 * 2.0_f64.powf(-1.5)),
            ("a line and a square below it", at(3.0, 0.5).square_from(at(3.0, 0.25)), -4.75),
            ("radial", at(2.0, 0.0).div_pow_3_2(at(2.0, 0.0)), 0.75 * 2.0_f64.powf(-2.5)),
        ] {
            assert!(within(second(dual) - exact, 8.0 * f64::EPSILON), "{name}: {dual:?} for {exact}");
        }
        // What moves in the second order alone is not constant.
        let bent = Dual { value: new(0.6, 0.0), along: [new(0.0, 1.0)] };
        assert!(within(second(bent.sin()) - 0.6_f64.cos(), 4.0 * f64::EPSILON));
        assert!(within(second(bent.div_pow_3_2(Dual::of(4.0))) - 0.125, 4.0 * f64::EPSILON));
    }

    #[test]
    fn a_prepared_constant_has_a_tangent_where_it_is_requested() {
        let of_lane = |lane| [3.0, 5.0][lane];
        for constant in [<Dual>::parameter(&of_lane), <Dual>::prepared(&of_lane)] {
            assert_eq!((constant.lane(0), constant.lane(1)), (3.0, 0.0));
        }
        let [constant, other] =
            [Dual::<f64, 1, false, true>::prepared(&of_lane), Dual::<f64, 1, false, true>::parameter(&of_lane)];
        assert_eq!((constant.lane(1), other.lane(1)), (5.0, 0.0));
        // Its products follow: 3 (2 + dx) with d3 = 5, or without.
        let along = |x: f64| move |lane: usize| [2.0, x][lane];
        let (x, sensitive) = (<Dual>::state(&along(7.0)), Dual::<f64, 1, false, true>::state(&along(7.0)));
        assert_eq!((<Dual>::of(3.0).scale(x).lane(1), constant.scale(sensitive).lane(1)), (21.0, 31.0));
        let sums = (<Dual>::of(3.0).scale_add(x, x).lane(1), constant.scale_add(sensitive, sensitive).lane(1));
        assert_eq!(sums, (28.0, 38.0));
    }
}
