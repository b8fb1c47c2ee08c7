//! Elementary functions of plain scalars: those of `std`, or where there is no `std`, those of libm.

use crate::scalar::functions::elementary_functions;

macro_rules! declare {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        /// The elementary functions of `f64` and `f32`, which `core` has not. Without the feature `std` the prelude brings
        /// the trait into scope, so that `kinetic` and `potential` read the same with and without it.
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

/// One function of a scalar: that of `std`.
#[cfg(feature = "std")]
macro_rules! library {
    ($scalar:ident $name:ident($($x:expr),*) (libm $double:ident $single:ident)) => {
        $scalar::$name($($x),*)
    };
    ($scalar:ident $name:ident($($x:expr),*) (libm $double:ident $single:ident, std $value:expr)) => {
        $value
    };
    ($scalar:ident $name:ident($($x:expr),*) ($value:expr)) => {
        $value
    };
}

/// One function of a scalar: that of libm.
#[cfg(not(feature = "std"))]
macro_rules! library {
    (f64 $name:ident($($x:expr),*) (libm $double:ident $single:ident $(, std $value:expr)?)) => {
        libm::$double($($x),*)
    };
    (f32 $name:ident($($x:expr),*) (libm $double:ident $single:ident $(, std $value:expr)?)) => {
        libm::$single($($x),*)
    };
    ($scalar:ident $name:ident($($x:expr),*) ($value:expr)) => {
        $value
    };
}

macro_rules! implement {
    (
        { $scalar:ident }
        unary { $($unary:ident($x:ident) {
            value: $value:tt; slope: $slope:expr; bounds: $bounds:expr; $(kernel: $($kernel:tt)*)?
        })* }
        binary { $($binary:ident($a:ident, $b:ident) {
            value: $value_of_two:tt; dual: $dual:expr; bounds: $bounds_of_two:expr; $(kernel: $($kernel_of_two:tt)*)?
        })* }
    ) => {
        impl Elementary for $scalar {
            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                library!($scalar mul_add(self, b, c) (libm fma fmaf))
            }
            #[inline(always)]
            fn powi(self, power: i32) -> Self {
                library!($scalar powi(self, power as $scalar) (libm pow powf, std $scalar::powi(self, power)))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                library!($scalar sin_cos(self) (libm sincos sincosf))
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    let $x = self;
                    library!($scalar $unary($x) $value)
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    let ($a, $b) = (self, other);
                    library!($scalar $binary($a, $b) $value_of_two)
                }
            )*
        }
    };
}
elementary_functions!(rows of implement! { f64 });
elementary_functions!(rows of implement! { f32 });
