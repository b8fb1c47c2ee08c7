//! Elementary functions of our own: one text for scalars and vectors, so that every lane has the bits of the scalar.
//!
//! Comes in: scalars or vectors whose bits can be handled. Goes out: the function in every lane, within a few ulp of
//! the exact value (the documentation of each gives its bound), with the zeros, infinities and NaNs of `std`. Always
//! true: there is one branch on a value, which is hardly ever taken: the fallback to the maths library.

mod arc;
mod arc_sine;
mod bits;
mod cube_root;
mod exponential;
mod fast_sine;
mod fast_tangent;
mod logarithm;
mod power;
mod remainder;
mod sine;
mod table;
#[cfg(test)]
mod tests;

pub(crate) use bits::Bits;

use crate::scalar::real::Mask;

pub(crate) use table::elementary_functions;

macro_rules! define_kernel {
    (
        { $d:tt }
        $($kind:ident { $($name:ident $arguments:tt {
            value: $value:tt; $form:ident: $derivative:expr; bounds: $bounds:expr; $(kernel: $kernel:ident $($more:tt)*)?
        })* })*
    ) => {
        /// A function: its kernel, or `otherwise` where it has none.
        macro_rules! kernel {
            $($($(
                ($name $d($d x:expr),*; $d otherwise:expr) => {
                    $crate::scalar::functions::$kernel($d($d x),*)
                };
            )?)*)*
            ($d name:ident $d($d x:expr),*; $d otherwise:expr) => {
                $d otherwise
            };
        }
        pub(crate) use kernel;
    };
}
elementary_functions!(rows of define_kernel! { $ });

/// The methods of `Real` for these, where a number has the bits that kernels handle.
macro_rules! fast_kernels {
    (unary: $($unary:ident $precise:ident)*; binary: $($binary:ident $other:ident)*;) => {
        $(
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $unary(self) -> Self {
                crate::scalar::functions::$unary(self)
            }
        )*
        $(
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $binary(self, other: Self) -> Self {
                crate::scalar::functions::$binary(self, other)
            }
        )*
    };
}
pub(crate) use fast_kernels;

pub(crate) use arc::{atan, atan2, fast_atan, fast_atan2};
pub(crate) use arc_sine::{acos, asin, fast_acos, fast_asin};
pub(crate) use cube_root::{cbrt, fast_cbrt};
pub(crate) use exponential::{exp, fast_exp, fast_tanh, tanh};
pub(crate) use fast_sine::{fast_cos, fast_sin};
pub(crate) use fast_tangent::fast_tan;
pub(crate) use logarithm::{fast_ln, fast_ln_1p, ln, ln_1p};
pub(crate) use power::powf;
pub(crate) use remainder::remainder;
pub(crate) use sine::{cos, sin, sin_cos, tan};

/// The first two terms of a polynomial. A function and not a closure, because only functions are sure to be inlined.
#[cfg_attr(not(debug_assertions), inline(always))]
fn linear<R: Bits>(x: R, [a, b]: [f64; 2]) -> R {
    x.fma(R::of(b), R::of(a))
}

/// The first four terms of a polynomial, summed in pairs.
#[cfg_attr(not(debug_assertions), inline(always))]
fn cubic<R: Bits>(x: R, square: R, [a, b, c, d]: [f64; 4]) -> R {
    square.fma(linear(x, [c, d]), linear(x, [a, b]))
}

/// The quotient of two numbers that carry their rounding errors, correct but for the rounding of the quotient.
#[cfg_attr(not(debug_assertions), inline(always))]
fn quotient<R: Bits>([a, error_of_a]: [R; 2], [b, error_of_b]: [R; 2]) -> R {
    let quotient = a / b;
    let left = error_of_a - quotient * error_of_b;
    // Without a fused multiply-add the rest of the division is not at hand; it is half a unit at most.
    let left = if R::FUSED { left + (-quotient).fma(b, a) } else { left };
    quotient + left / b
}

/// `value` in the lanes where `fast` holds, and the fallback of the maths library, a function of `x`, in the others.
#[cfg_attr(not(debug_assertions), inline(always))]
fn with_fallback<R: Bits>(value: R, fast: R::Mask, x: R, fallback: fn(&mut [R::Scalar])) -> R {
    let outside = fast.not();
    if outside.any() { R::select(outside, x.map_scalars(fallback), value) } else { value }
}

/// The same with a fallback of two arguments.
#[cfg_attr(not(debug_assertions), inline(always))]
fn with_fallback_of_two<R: Bits>(
    value: R,
    fast: R::Mask,
    [x, y]: [R; 2],
    fallback: fn(&mut [R::Scalar], &[R::Scalar]),
) -> R {
    let outside = fast.not();
    if outside.any() { R::select(outside, x.zip_scalars(y, fallback), value) } else { value }
}
