//! The one table of the functions that have a kernel.

use super::{Big, Function, Points, Precision, SHARP, evaluate};
use crate::scalar::{
    fma::{Avx512, Fma, Fused},
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

macro_rules! rows {
    ($($name:ident($($argument:ident),*) as $std:path, within $ulps:literal of $exact:path, $sharp:expr, at [$($points:expr),*];)*) => {
        pub(super) const ROWS: &[Row] = &[$({
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
                    $std($($argument),*)
                },
                sharp: |arguments| {
                    let [$($argument,)* ..] = &arguments;
                    $sharp($($argument),*)
                },
                points: &[$($points),*],
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
        }),*];
    };
}

rows! {
    tan(x) as f64::tan, within 2.0 of pxfm::f_tan, Big::tan, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    exp(x) as f64::exp, within 1.0 of pxfm::f_exp, Big::exp, at [Points::Even(-1.0, 1.0), Points::Even(-760.0, 720.0), Points::Even(-110.0, 90.0), Points::Powers(-60.0, 9.0)];
    ln(x) as f64::ln, within 1.0 of pxfm::f_log, Big::ln, at [Points::Even(0.5, 2.0), Points::Even(0.999, 1.001), Points::Sizes(-1080.0, 1024.0)];
    tanh(x) as f64::tanh, within 2.0 of pxfm::f_tanh, Big::tanh, at [Points::Even(-1.0, 1.0), Points::Even(-22.0, 22.0), Points::Powers(-60.0, 9.0)];
    sin(x) as f64::sin, within 1.0 of pxfm::f_sin, Big::sin, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    fast_sin(x) as f64::sin, within 4.0 of pxfm::f_sin, Big::sin, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    fast_cos(x) as f64::cos, within 4.0 of pxfm::f_cos, Big::cos, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    cos(x) as f64::cos, within 1.0 of pxfm::f_cos, Big::cos, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    atan(x) as f64::atan, within 1.0 of pxfm::f_atan, Big::atan, at [Points::Even(-1.0, 1.0), Points::Even(-4.0, 4.0), Points::Powers(-60.0, 70.0)];
    asin(x) as f64::asin, within 1.0 of pxfm::f_asin, Big::asin, at [Points::Even(-1.0, 1.0), Points::Powers(-60.0, 0.0)];
    acos(x) as f64::acos, within 1.0 of pxfm::f_acos, Big::acos, at [Points::Even(-1.0, 1.0), Points::Even(0.999, 1.0), Points::Powers(-60.0, 0.0)];
    cbrt(x) as f64::cbrt, within 1.0 of pxfm::f_cbrt, CubicRoot::cbrt, at [Points::Even(-8.0, 8.0), Points::Powers(-1080.0, 1024.0), Points::Powers(-130.0, 128.0)];
    powf(x, y) as f64::powf, within 2.0 of pxfm::f_pow, |x: &Big, y: &Big| x.powf(y), at [
        Points::Pairs(&Points::Sizes(-4.0, 4.0), &Points::Even(-30.0, 30.0)),
        Points::Pairs(&Points::Sizes(-120.0, 120.0), &Points::Even(-9.0, 9.0)),
        Points::Pairs(&Points::Sizes(-0.01, 0.01), &Points::Powers(0.0, 17.0))
    ];
    atan2(y, x) as f64::atan2, within 1.0 of pxfm::f_atan2, Big::atan2, at [
        Points::Pairs(&Points::Even(-1.0, 1.0), &Points::Even(-1.0, 1.0)),
        Points::Pairs(&Points::Powers(-60.0, 60.0), &Points::Powers(-20.0, 20.0))
    ];
    fast_tan(x) as f64::tan, within 4.0 of pxfm::f_tan, Big::tan, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    fast_exp(x) as f64::exp, within 4.0 of pxfm::f_exp, Big::exp, at [Points::Even(-1.0, 1.0), Points::Even(-760.0, 720.0), Points::Even(-110.0, 90.0), Points::Powers(-60.0, 9.0)];
    fast_ln(x) as f64::ln, within 4.0 of pxfm::f_log, Big::ln, at [Points::Even(0.5, 2.0), Points::Even(0.999, 1.001), Points::Sizes(-1080.0, 1024.0)];
    fast_tanh(x) as f64::tanh, within 4.0 of pxfm::f_tanh, Big::tanh, at [Points::Even(-1.0, 1.0), Points::Even(-22.0, 22.0), Points::Powers(-60.0, 9.0)];
    fast_atan(x) as f64::atan, within 4.0 of pxfm::f_atan, Big::atan, at [Points::Even(-1.0, 1.0), Points::Even(-4.0, 4.0), Points::Powers(-60.0, 70.0)];
    fast_asin(x) as f64::asin, within 4.0 of pxfm::f_asin, Big::asin, at [Points::Even(-1.0, 1.0), Points::Powers(-60.0, 0.0)];
    fast_acos(x) as f64::acos, within 4.0 of pxfm::f_acos, Big::acos, at [Points::Even(-1.0, 1.0), Points::Even(0.999, 1.0), Points::Powers(-60.0, 0.0)];
    fast_cbrt(x) as f64::cbrt, within 4.0 of pxfm::f_cbrt, CubicRoot::cbrt, at [Points::Even(-8.0, 8.0), Points::Powers(-1080.0, 1024.0), Points::Powers(-130.0, 128.0)];
    fast_atan2(y, x) as f64::atan2, within 4.0 of pxfm::f_atan2, Big::atan2, at [
        Points::Pairs(&Points::Even(-1.0, 1.0), &Points::Even(-1.0, 1.0)),
        Points::Pairs(&Points::Powers(-60.0, 60.0), &Points::Powers(-20.0, 20.0))
    ];
}
