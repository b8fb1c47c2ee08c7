//! The scalars of machines with a fused multiply-add, one for each multiversioned variant of the hot loops.

use crate::scalar::{
    elementary::Elementary,
    functions::{self, elementary_functions, fast_kernels, kernel},
    instruction_set::enter_fused,
    real::{IsF64, Kernel, Real, compared},
    simd::{block::Block, lanes::Lanes, pair::Pair, row::Row},
};
use core::{
    fmt::Debug,
    marker::PhantomData,
    ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign},
};

/// `f64` or `f32`, with the estimate of a root that AVX-512 has.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
pub(crate) use crate::scalar::simd::x86::Estimate as Float;

/// `f64` or `f32`.
#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
pub trait Float {}
#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
impl Float for f64 {}
#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
impl Float for f32 {}

/// An instruction set with fused multiply-add: its vectors, and the variant of a kernel that is compiled for it.
pub trait Instructions: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Neighbours in an array of doubles.
    type Doubles: Block<Fused<f64, Self>>;
    /// Neighbours in an array of singles.
    type Singles: Block<Fused<f32, Self>>;
    /// Eight bodies in double precision.
    type RowOfDoubles: Row<Fused<f64, Self>>;
    /// Eight bodies in single precision.
    type RowOfSingles: Row<Fused<f32, Self>>;
    /// Several rows in double precision, as many as registers hold beside what is computed from them.
    type BundleOfDoubles: Row<Self::RowOfDoubles>;
    /// Several rows in single precision.
    type BundleOfSingles: Row<Self::RowOfSingles>;
    /// Two doubles.
    type PairOfDoubles: Pair<Fused<f64, Self>>;

    /// `n / x^(1/2)`.
    #[inline(always)]
    fn div_sqrt<F: Float>(n: Fused<F, Self>, x: Fused<F, Self>) -> Fused<F, Self>
    where
        Fused<F, Self>: Real,
    {
        n / x.sqrt()
    }
    /// `n / x^(3/2)`.
    #[inline(always)]
    fn div_pow_3_2<F: Float>(n: Fused<F, Self>, x: Fused<F, Self>) -> Fused<F, Self>
    where
        Fused<F, Self>: Real,
    {
        n / (x * x.sqrt())
    }
    /// Runs the variant of `kernel` for these instructions.
    fn enter<K: Kernel>(kernel: K) -> K::Out;
}

/// The instructions of `InstructionSet::Fused`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fma;

impl Instructions for Fma {
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type Doubles = crate::scalar::simd::x86::X4;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type Singles = crate::scalar::simd::x86::S8;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type RowOfDoubles = Lanes<crate::scalar::simd::x86::X4, 2>;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type RowOfSingles = crate::scalar::simd::x86::S8;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type BundleOfDoubles = Lanes<Self::RowOfDoubles, 2>;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type BundleOfSingles = Lanes<Self::RowOfSingles, 4>;
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    type PairOfDoubles = crate::scalar::simd::x86::X2;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type Doubles = Fused<f64>;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type Singles = Fused<f32>;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type RowOfDoubles = Lanes<Fused<f64>, 8>;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type RowOfSingles = Lanes<Fused<f32>, 8>;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type BundleOfDoubles = Self::RowOfDoubles;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type BundleOfSingles = Self::RowOfSingles;
    #[cfg(not(all(target_arch = "x86_64", feature = "std")))]
    type PairOfDoubles = Lanes<Fused<f64>, 2>;

    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Out {
        enter_fused(kernel)
    }
}

/// The instructions of `InstructionSet::Avx512`.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Avx512;

/// No other target has the set, so that nothing is compiled for it.
#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
pub(crate) type Avx512 = Fma;

#[cfg(all(target_arch = "x86_64", feature = "std"))]
impl Instructions for Avx512 {
    type Doubles = crate::scalar::simd::x86::X8;
    type Singles = crate::scalar::simd::x86::S16;
    type RowOfDoubles = crate::scalar::simd::x86::X8;
    type RowOfSingles = crate::scalar::simd::x86::V8;
    type BundleOfDoubles = Lanes<Self::RowOfDoubles, 4>;
    type BundleOfSingles = Lanes<Self::RowOfSingles, 4>;
    type PairOfDoubles = crate::scalar::simd::x86::X2;

    #[inline(always)]
    fn div_sqrt<F: Float>(n: Fused<F, Self>, x: Fused<F, Self>) -> Fused<F, Self>
    where
        Fused<F, Self>: Real,
    {
        crate::scalar::simd::x86::div_sqrt(n, x)
    }
    #[inline(always)]
    fn div_pow_3_2<F: Float>(n: Fused<F, Self>, x: Fused<F, Self>) -> Fused<F, Self>
    where
        Fused<F, Self>: Real,
    {
        crate::scalar::simd::x86::div_pow_3_2(n, x)
    }
    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Out {
        crate::scalar::instruction_set::enter_avx512(kernel)
    }
}

/// `f64` or `f32` whose `fma` is one instruction with one rounding. The variant that it belongs to changes no bit.
///
/// Only worth using inside [`Real::enter`]: elsewhere the same bits come from a call into the maths library.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Fused<F, S = Fma>(pub F, PhantomData<S>);

impl<F, S> Fused<F, S> {
    /// The number `x`.
    #[inline(always)]
    pub fn new(x: F) -> Self {
        Self(x, PhantomData)
    }
}

macro_rules! operators {
    ($scalar:ty: $($trait:ident $method:ident $operator:tt),*) => {$(
        impl<S: Instructions> $trait for Fused<$scalar, S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::new(self.0 $operator other.0)
            }
        }
    )*};
}

macro_rules! fused_real {
    ($scalar:ty, $is_f64:literal, $block:ident, $row:ident, $bundle:ident, $pair:ty; unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        operators!($scalar: Add add +, Sub sub -, Mul mul *, Div div /);

        impl<S: Instructions> Neg for Fused<$scalar, S> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::new(-self.0)
            }
        }
        impl<S: Instructions> AddAssign for Fused<$scalar, S> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                self.0 += other.0;
            }
        }
        impl<S: Instructions> SubAssign for Fused<$scalar, S> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                self.0 -= other.0;
            }
        }

        impl<S: Instructions> Real for Fused<$scalar, S> {
            const LANES: usize = 1;
            const IS_F64: Option<IsF64> = IsF64::of($is_f64);
            const BEYOND_BASELINE: bool = true;
            type Mask = bool;
            type Block = S::$block;
            type Row<const N: usize> = S::$row;
            type Wide = S::$row;
            type Bundle = S::$bundle;
            type Pair = $pair;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self::new(x as $scalar)
            }
            #[inline(always)]
            fn lane(self, _lane: usize) -> f64 {
                f64::from(self.0)
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
                Self::new(Elementary::mul_add(self.0, b.0, c.0))
            }
            #[inline(always)]
            fn div_sqrt(self, x: Self) -> Self {
                S::div_sqrt(self, x)
            }
            #[inline(always)]
            fn div_pow_3_2(self, x: Self) -> Self {
                S::div_pow_3_2(self, x)
            }
            #[cfg(all(target_arch = "x86_64", feature = "std"))]
            #[inline(always)]
            fn apart(self) -> Self {
                Self::new(crate::scalar::simd::x86::apart(f64::from(self.0)) as $scalar)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                functions::sin_cos(self)
            }
            elementary_functions!(fast ones of fast_kernels!);
            #[inline(always)]
            fn finite(self) -> bool {
                self.0.is_finite()
            }
            compared!(0);
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    kernel!($unary self; Self::new(<$scalar as Elementary>::$unary(self.0)))
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    kernel!($binary self, other; Self::new(<$scalar as Elementary>::$binary(self.0, other.0)))
                }
            )*
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                S::enter(kernel)
            }
        }
    };
}
elementary_functions!(fused_real! { f64, true, Doubles, RowOfDoubles, BundleOfDoubles, S::PairOfDoubles; });
elementary_functions!(fused_real! { f32, false, Singles, RowOfSingles, BundleOfSingles, Lanes<Self, 2>; });
