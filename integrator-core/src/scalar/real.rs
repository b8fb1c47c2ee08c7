//! The trait of scalars and vectors: generated code is one text for plain and fused scalars, duals and lanes.

use crate::scalar::{
    elementary::Elementary,
    functions::{self, elementary_functions, fast_kernels, kernel},
    implicit::{Image, Implicit},
    simd::{block::Block, lanes::Lanes, pair::Pair, row::Row},
};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A kernel: code of which the executor runs the variant compiled for one instruction set.
///
/// A trait and not a closure, because only a method can carry the `inline(always)` that brings the code into the
/// variant.
pub trait Kernel {
    /// The type that it returns.
    type Out;
    /// Whether its variant is never inlined, because it is seldom run: the compiler links such a function to the copy of the
    /// library, if that has one.
    const APART: bool = false;

    /// Runs it; implementations are `inline(always)`.
    fn call(self) -> Self::Out;
}

/// The proof that a scalar is `f64` or transparent over it. Only this crate has one.
#[derive(Clone, Copy, Debug)]
pub struct IsF64(());

impl IsF64 {
    /// The proof, for `f64` and for `Fused` of it.
    pub(crate) const fn of(holds: bool) -> Option<Self> {
        if holds { Some(Self(())) } else { None }
    }
}

/// A mask: the lanes in which a condition holds.
pub trait Mask: Copy + Send + Sync + 'static {
    /// The mask with all lanes alike.
    fn of(holds: bool) -> Self;
    /// Whether the condition holds in any lane: if not, the branch is skipped.
    fn any(self) -> bool;
    /// The lanes where both hold.
    fn and(self, other: Self) -> Self;
    /// The lanes where at least one holds.
    fn or(self, other: Self) -> Self;
    /// The lanes where it does not hold.
    fn not(self) -> Self;
}

impl Mask for bool {
    #[inline(always)]
    fn of(holds: bool) -> Self {
        holds
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn not(self) -> Self {
        !self
    }
}

macro_rules! declare_fast {
    (unary: $($unary:ident $precise:ident)*; binary: $($binary:ident $other:ident)*;) => {
        $(
            #[doc = concat!("`", stringify!($precise), "` within 4 ulp, where that is faster.")]
            #[inline(always)]
            fn $unary(self) -> Self {
                self.$precise()
            }
        )*
        $(
            #[doc = concat!("`", stringify!($other), "` within 4 ulp, where that is faster.")]
            #[inline(always)]
            fn $binary(self, other: Self) -> Self {
                self.$other(other)
            }
        )*
    };
}

macro_rules! declare_real {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        /// A scalar, or a vector of lanes, that flows are computed in.
        pub trait Real:
            Copy + Send + Sync + 'static
            + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
            + AddAssign + SubAssign
        {
            /// The number of lanes: members of an ensemble, or the parts of a dual.
            const LANES: usize;
            /// The number of lanes that are members of an ensemble: all, but for a number that is made of two parts.
            const MEMBERS: usize = Self::LANES;
            /// Whether a linear map with constant coefficients maps each lane by itself: lanes are not parts of one number.
            const LANEWISE: bool = true;
            /// The proof that it is `f64` or `Fused` of it, if it is.
            const IS_F64: Option<IsF64> = None;
            /// Whether the numbers are those of an instruction set beyond the least of the architecture.
            const BEYOND_BASELINE: bool = false;
            /// The mask of its lanes.
            type Mask: Mask;
            /// A vector of consecutive numbers of an array, as wide as the variant's registers; `Self` where a value
            /// has lanes or parts already.
            type Block: Block<Self>;
            /// A row of up to eight bodies.
            type Row<const N: usize>: Row<Self>;
            /// A vector of eight numbers, where registers hold them; `Self` where they would be computed one by one,
            /// which takes eight times the code.
            type Wide: Row<Self>;
            /// Several vectors of eight numbers, as many as registers hold beside sums of products of each: their chains of
            /// operations do not wait for each other.
            type Bundle: Row<Self::Wide>;
            /// A vector of two numbers, where a register holds them.
            type Pair: Pair<Self>;

            /// Returns the same number in every lane, rounded to the precision of the scalar; a dual has no tangent
            /// here.
            fn of(x: f64) -> Self;
            /// The smallest number whose square is a normal number.
            #[inline(always)]
            fn least() -> Self {
                Self::power_of_two(-511, -63)
            }
            /// A number far above all divisors that matter, and far below those that overflow.
            #[inline(always)]
            fn huge() -> Self {
                Self::power_of_two(896, 112)
            }
            /// A power of two with one exponent in the range of `f64`, and another one where scalars are `f32`.
            #[inline(always)]
            fn power_of_two(double: i16, single: i16) -> Self {
                let is_single = Self::of(f64::MIN_POSITIVE).lane(0) == 0.0;
                let exponent = 1023 + if is_single { single } else { double };
                Self::of(f64::from_bits((exponent as u64) << 52))
            }
            /// One lane, widened to `f64`.
            fn lane(self, lane: usize) -> f64;
            /// A number that does not depend on the state, one per lane; a dual ignores all but the first.
            fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self;
            /// A prepared constant, one number per lane; for a dual along parameters, lane 1 is the tangent.
            #[inline(always)]
            fn prepared(of_lane: &dyn Fn(usize) -> f64) -> Self {
                Self::parameter(of_lane)
            }
            /// A coordinate, one number per lane; for a dual, lane 1 is the tangent.
            fn state(of_lane: &dyn Fn(usize) -> f64) -> Self;
            /// `self * b + c`, in one rounding where the scalar has it.
            fn fma(self, b: Self, c: Self) -> Self;
            /// `self * x`, where this is a number of the step or of parameters: derivatives by the start are those of `x`.
            #[inline(always)]
            fn scale(self, x: Self) -> Self {
                self * x
            }
            /// `self * x + y`, likewise.
            #[inline(always)]
            fn scale_add(self, x: Self, y: Self) -> Self {
                self.fma(x, y)
            }
            /// `self * self`.
            #[inline(always)]
            fn square(self) -> Self {
                self * self
            }
            /// `self * self + c`, in one rounding where the scalar has it.
            #[inline(always)]
            fn square_add(self, c: Self) -> Self {
                self.fma(self, c)
            }
            /// `c - self * self`, likewise.
            #[inline(always)]
            fn square_from(self, c: Self) -> Self {
                (-self).fma(self, c)
            }
            /// A function known in `f64` alone, lane by lane. Only a dual evaluates the derivatives, which come in the
            /// order of the arguments.
            #[inline]
            fn lane_by_lane<const N: usize>(
                arguments: [Self; N],
                value: impl Fn(usize, [f64; N]) -> f64,
                slopes: impl Fn(usize, [f64; N]) -> [f64; N],
            ) -> Self {
                let _ = slopes;
                Self::state(&|lane| {
                    let mut at = [0.0; N];
                    for number in 0..N {
                        at[number] = arguments[number].lane(lane);
                    }
                    value(lane, at)
                })
            }
            /// The image of a point under a map that is solved for. A dual solves in numbers without derivatives.
            #[inline(always)]
            fn solved<M: Implicit<D, C>, const D: usize, const C: usize>(
                point: [[Self; D]; 2],
                constants: [Self; C],
            ) -> Image<Self, D> {
                M::solve(point, constants).0
            }
            /// `self / sqrt(x)`. The formula, or on AVX-512 a kernel of at most two ulp that scalar and vectors share.
            #[inline(always)]
            fn div_sqrt(self, x: Self) -> Self {
                self / x.sqrt()
            }
            /// `self / x^(3/2)`, the radial factor of inverse-square forces. Computed as `div_sqrt`.
            #[inline(always)]
            fn div_pow_3_2(self, x: Self) -> Self {
                self / (x * x.sqrt())
            }
            /// The same number, which no optimisation puts into a vector with others.
            #[inline(always)]
            fn apart(self) -> Self {
                self
            }
            /// Sine and cosine of one argument.
            fn sin_cos(self) -> (Self, Self);
            elementary_functions!(fast ones of declare_fast!);
            /// Whether all lanes are finite.
            fn finite(self) -> bool;
            /// The mask of the lanes that are less than those of `other`.
            fn less(self, other: Self) -> Self::Mask;
            /// The mask of the lanes that are less than or equal to those of `other`.
            fn less_or_equal(self, other: Self) -> Self::Mask;
            /// The mask of the lanes that are equal to those of `other`.
            fn equal(self, other: Self) -> Self::Mask;
            /// `a` in the lanes of `mask`, `b` in the others.
            fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
            $(
                #[doc = concat!("`", stringify!($unary), "` of every lane, as in `std`.")]
                fn $unary(self) -> Self;
            )*
            $(
                #[doc = concat!("`", stringify!($binary), "` of every lane, as in `std`.")]
                fn $binary(self, other: Self) -> Self;
            )*

            /// Runs the variant of `kernel` for the instruction set that this scalar is made for.
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                $crate::scalar::instruction_set::enter_baseline(kernel)
            }
        }
    };
}
elementary_functions!(declare_real! {});

/// The comparisons of `Real` for one number, perhaps in a field, whose mask is a `bool`.
macro_rules! compared {
    ($($field:tt).*) => {
        #[inline(always)]
        fn less(self, other: Self) -> bool {
            self $(.$field)* < other $(.$field)*
        }
        #[inline(always)]
        fn less_or_equal(self, other: Self) -> bool {
            self $(.$field)* <= other $(.$field)*
        }
        #[inline(always)]
        fn equal(self, other: Self) -> bool {
            self $(.$field)* == other $(.$field)*
        }
        #[inline(always)]
        fn select(mask: bool, a: Self, b: Self) -> Self {
            if mask { a } else { b }
        }
    };
}
pub(crate) use compared;

/// A number that is made of two parts, as a scalar: lane 0 is its value, lane 1 the other part, and several of them in
/// a row are an array. Functions are those of the macros `unary` and `binary` where this is called.
macro_rules! real_of_two_parts {
    (
        $number:ident: $inline:meta; lanes of $this:ident: $value:expr, $other:expr; { $($own:tt)* }
        unary: $($unary:ident)*; binary: $($binary:ident)*;
    ) => {
        impl Real for $number {
            const LANES: usize = 2;
            const MEMBERS: usize = 1;
            const LANEWISE: bool = false;
            type Block = Self;
            type Row<const N: usize> = $crate::scalar::simd::lanes::Lanes<Self, N>;
            type Wide = Self;
            type Bundle = Self;
            type Pair = $crate::scalar::simd::lanes::Lanes<Self, 2>;

            #[$inline]
            fn lane($this, lane: usize) -> f64 {
                if lane == 0 { $value } else { $other }
            }
            #[$inline]
            fn fma(self, b: Self, c: Self) -> Self {
                self * b + c
            }
            $($own)*
            $(
                #[$inline]
                fn $unary(self) -> Self {
                    unary!($unary self)
                }
            )*
            $(
                #[$inline]
                fn $binary(self, other: Self) -> Self {
                    binary!($binary self, other)
                }
            )*
        }

        impl core::ops::AddAssign for $number {
            #[$inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl core::ops::SubAssign for $number {
            #[$inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}
pub(crate) use real_of_two_parts;

/// The scalar as it is: `fma` is a multiplication and an addition, so that no machine calls a library for it.
macro_rules! plain_real {
    ($scalar:ty, $is_f64:literal; unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        impl Real for $scalar {
            const LANES: usize = 1;
            const IS_F64: Option<IsF64> = IsF64::of($is_f64);
            type Mask = bool;
            type Block = Self;
            type Row<const N: usize> = Lanes<Self, N>;
            type Wide = Self;
            type Bundle = Self;
            type Pair = Lanes<Self, 2>;

            #[inline(always)]
            fn of(x: f64) -> Self {
                x as $scalar
            }
            #[inline(always)]
            fn lane(self, _lane: usize) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
                Self::of(of_lane(0))
            }
            #[inline(always)]
            fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
                Self::of(of_lane(0))
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                self * b + c
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                functions::sin_cos(self)
            }
            elementary_functions!(fast ones of fast_kernels!);
            #[inline(always)]
            fn finite(self) -> bool {
                self.is_finite()
            }
            compared!();
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    kernel!($unary self; <$scalar as Elementary>::$unary(self))
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    kernel!($binary self, other; <$scalar as Elementary>::$binary(self, other))
                }
            )*
        }
    };
}
elementary_functions!(plain_real! { f64, true; });
elementary_functions!(plain_real! { f32, false; });
