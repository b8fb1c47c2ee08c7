//! Elementary functions of plain scalars: those of `std`, or where there is no `std`, those of libm.

use crate::scalar::real::elementary_functions;

macro_rules! declare {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        /// The functions that `std` has for `f64` and `f32` and `core` has not. Without the feature `std` the prelude
        /// brings it into scope, so that `kinetic` and `potential` read the same with and without it.
        pub trait Elementary: Copy {
            /// `self * b + c` in one rounding.
            #[must_use]
            fn mul_add(self, b: Self, c: Self) -> Self;
            /// `self` raised to an integer power.
            #[must_use]
            fn powi(self, power: i32) -> Self;
            /// Sine and cosine of one argument.
            #[must_use]
            fn sin_cos(self) -> (Self, Self);
            $(
                #[doc = concat!("`", stringify!($unary), "`, as in `std`.")]
                #[must_use]
                fn $unary(self) -> Self;
            )*
            $(
                #[doc = concat!("`", stringify!($binary), "`, as in `std`.")]
                #[must_use]
                fn $binary(self, other: Self) -> Self;
            )*
        }
    };
}
elementary_functions!(declare! {});

/// A function of two arguments in `std`, where the remainder of a division is an operator.
#[cfg(feature = "std")]
macro_rules! std_binary {
    (remainder $scalar:ident $x:expr, $y:expr) => {
        $x % $y
    };
    ($binary:ident $scalar:ident $x:expr, $y:expr) => {
        $scalar::$binary($x, $y)
    };
}

#[cfg(feature = "std")]
macro_rules! of_std {
    ($scalar:ident; unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        impl Elementary for $scalar {
            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                $scalar::mul_add(self, b, c)
            }
            #[inline(always)]
            fn powi(self, power: i32) -> Self {
                $scalar::powi(self, power)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $scalar::sin_cos(self)
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    $scalar::$unary(self)
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    std_binary!($binary $scalar self, other)
                }
            )*
        }
    };
}
#[cfg(feature = "std")]
elementary_functions!(of_std! { f64; });
#[cfg(feature = "std")]
elementary_functions!(of_std! { f32; });

#[cfg(not(feature = "std"))]
macro_rules! of_libm {
    (
        $scalar:ident, fma $fma:ident, pow $pow:ident, sincos $sincos:ident;
        core: $($core:ident)*; unary: $($unary:ident $function:ident)*; binary: $($binary:ident $other:ident)*;
    ) => {
        impl Elementary for $scalar {
            fn mul_add(self, b: Self, c: Self) -> Self {
                libm::$fma(self, b, c)
            }
            fn powi(self, power: i32) -> Self {
                libm::$pow(self, power as $scalar)
            }
            fn sin_cos(self) -> (Self, Self) {
                libm::$sincos(self)
            }
            fn min(self, other: Self) -> Self {
                $scalar::min(self, other)
            }
            fn max(self, other: Self) -> Self {
                $scalar::max(self, other)
            }
            $(
                fn $core(self) -> Self {
                    $scalar::$core(self)
                }
            )*
            $(
                fn $unary(self) -> Self {
                    libm::$function(self)
                }
            )*
            $(
                fn $binary(self, other: Self) -> Self {
                    libm::$other(self, other)
                }
            )*
        }
    };
}
#[cfg(not(feature = "std"))]
of_libm! {
    f64, fma fma, pow pow, sincos sincos;
    core: abs signum;
    unary: sqrt sqrt cbrt cbrt exp exp exp2 exp2 exp_m1 expm1 ln log ln_1p log1p log2 log2 log10 log10
           sin sin cos cos tan tan asin asin acos acos atan atan
           sinh sinh cosh cosh tanh tanh asinh asinh acosh acosh atanh atanh
           floor floor ceil ceil trunc trunc round round round_ties_even rint;
    binary: powf pow atan2 atan2 hypot hypot remainder fmod;
}
#[cfg(not(feature = "std"))]
of_libm! {
    f32, fma fmaf, pow powf, sincos sincosf;
    core: abs signum;
    unary: sqrt sqrtf cbrt cbrtf exp expf exp2 exp2f exp_m1 expm1f ln logf ln_1p log1pf log2 log2f log10 log10f
           sin sinf cos cosf tan tanf asin asinf acos acosf atan atanf
           sinh sinhf cosh coshf tanh tanhf asinh asinhf acosh acoshf atanh atanhf
           floor floorf ceil ceilf trunc truncf round roundf round_ties_even rintf;
    binary: powf powf atan2 atan2f hypot hypotf remainder fmodf;
}
