//! The functions that have a kernel, from the table.

use super::{Big, Function, Points, Precision, SHARP, evaluate};
use crate::scalar::{
    elementary::Elementary,
    fma::{Avx512, Fma, Fused},
    functions::elementary_functions,
    instruction_set::InstructionSet,
    real::Real,
};
use dashu_float::ops::CubicRoot;

/// Values at many points.
type Sweep = fn(&[[f64; 2]]) -> Vec<f64>;

/// A function and what is claimed of it.
pub(super) struct Row {
    pub(super) name: &'static str,
    /// The error that it may have, in units of the last place.
    pub(super) ulps: f64,
    /// Rounded correctly.
    pub(super) exact: fn([f64; 2]) -> f64,
    /// The function of `std`, which special values are compared with.
    pub(super) std: fn([f64; 2]) -> f64,
    /// With as many digits as the arguments have.
    pub(super) sharp: fn([Big; 2]) -> Big,
    /// The points at which it is tested.
    pub(super) points: &'static [Points],
    /// The scalars and vectors that it is computed in: a name, the scalar whose bits it must have, and the instruction
    /// set that it needs.
    pub(super) scalars: [(&'static str, Precision, Sweep); 4],
    pub(super) vectors: &'static [(&'static str, InstructionSet, Sweep, Sweep)],
}

impl Row {
    /// The error of a value, in `unit`s.
    pub(super) fn sharp_error(&self, x: [f64; 2], value: f64, unit: f64) -> f64 {
        let big = |x: f64| Big::try_from(x).expect("a finite number").with_precision(SHARP).value();
        ((self.sharp)(x.map(big)) - big(value)).to_f64().value().abs() / unit
    }
}

macro_rules! row {
    ($name:ident($($argument:ident),*), $ulps:expr, $std:ident, $exact:path, $sharp:expr, $points:tt) => {{
        struct This;
        impl Function for This {
            #[inline(always)]
            fn call<R: Real>(x: R, y: R) -> R {
                let [$($argument,)* ..] = [x, y];
                R::$name($($argument),*)
            }
        }
        Row {
            name: stringify!($name),
            ulps: $ulps,
            exact: |arguments| {
                let [$($argument,)* ..] = arguments;
                $exact($($argument),*)
            },
            std: |arguments| {
                let [$($argument,)* ..] = arguments;
                Elementary::$std($($argument),*)
            },
            sharp: |arguments| {
                let [$($argument,)* ..] = &arguments;
                $sharp($($argument),*)
            },
            points: &$points,
            scalars: [
                ("f64", Precision::Double, evaluate::<This, f64>),
                ("fused f64", Precision::Double, evaluate::<This, Fused<f64, Fma>>),
                ("f32", Precision::Single, evaluate::<This, f32>),
                ("fused f32", Precision::Single, evaluate::<This, Fused<f32, Fma>>),
            ],
            vectors: &[
                #[cfg(target_arch = "x86_64")]
                ("X4", InstructionSet::Fused, evaluate::<This, crate::scalar::simd::x86::X4>, evaluate::<This, Fused<f64, Fma>>),
                #[cfg(target_arch = "x86_64")]
                ("S8", InstructionSet::Fused, evaluate::<This, crate::scalar::simd::x86::S8>, evaluate::<This, Fused<f32, Fma>>),
                #[cfg(target_arch = "x86_64")]
                ("X8", InstructionSet::Avx512, evaluate::<This, crate::scalar::simd::x86::X8>, evaluate::<This, Fused<f64, Fma>>),
                #[cfg(target_arch = "x86_64")]
                ("S16", InstructionSet::Avx512, evaluate::<This, crate::scalar::simd::x86::S16>, evaluate::<This, Fused<f32, Fma>>),
                ("the other variant", InstructionSet::Avx512, evaluate::<This, Fused<f64, Avx512>>, evaluate::<This, Fused<f64, Fma>>),
            ],
        }
    }};
}

macro_rules! rows {
    (
        {}
        $($kind:ident { $($name:ident $arguments:tt {
            value: $value:tt; $form:ident: $derivative:expr; bounds: $bounds:expr;
            $(kernel: $kernel:ident within $ulps:literal, $(fast $fast:ident,)? of $exact:path, $sharp:expr, at $points:tt;)?
        })* })*
    ) => {
        pub(super) const ROWS: &[Row] = &[$($($(
            row!($name $arguments, $ulps, $name, $exact, $sharp, $points),
            $(row!($fast $arguments, 4.0, $name, $exact, $sharp, $points),)?
        )?)*)*];
    };
}
elementary_functions!(rows of rows! {});
