//! The one table of the functions that have a kernel.

use super::{Big, Points, Precision, SHARP, Unary, sweep};
use crate::{
    fused::{Avx512, Fma, Fused},
    instruction_set::InstructionSet,
    real::Real,
};

/// Values at many points.
type Sweep = fn(&[f64]) -> Vec<f64>;

/// A function and what is claimed of it.
pub(super) struct Row {
    pub(super) name: &'static str,
    /// The error that it may have, in units of the last place.
    pub(super) ulps: f64,
    /// Rounded correctly.
    pub(super) exact: fn(f64) -> f64,
    /// With as many digits as the argument has.
    pub(super) sharp: fn(&Big) -> Big,
    /// Where it is tested.
    pub(super) points: &'static [Points],
    /// What it is computed in: a name, the scalar whose bits it must have, and the instruction set that it needs.
    pub(super) scalars: [(&'static str, Precision, Sweep); 4],
    pub(super) vectors: &'static [(&'static str, InstructionSet, Sweep, Sweep)],
}

impl Row {
    /// The error of a value, in `unit`s.
    pub(super) fn sharp_error(&self, x: f64, value: f64, unit: f64) -> f64 {
        let big = |x: f64| Big::try_from(x).expect("a finite number").with_precision(SHARP).value();
        ((self.sharp)(&big(x)) - big(value)).to_f64().value().abs() / unit
    }
}

macro_rules! rows {
    ($($name:ident within $ulps:literal of $exact:path, $sharp:expr, at [$($points:expr),*];)*) => {
        pub(super) const ROWS: &[Row] = &[$({
            struct Function;
            impl Unary for Function {
                #[inline(always)]
                fn call<R: Real>(x: R) -> R {
                    x.$name()
                }
            }
            Row {
                name: stringify!($name),
                ulps: $ulps,
                exact: $exact,
                sharp: $sharp,
                points: &[$($points),*],
                scalars: [
                    ("f64", Precision::Double, sweep::<Function, f64>),
                    ("fused f64", Precision::Double, sweep::<Function, Fused<f64, Fma>>),
                    ("f32", Precision::Single, sweep::<Function, f32>),
                    ("fused f32", Precision::Single, sweep::<Function, Fused<f32, Fma>>),
                ],
                vectors: &[
                    #[cfg(target_arch = "x86_64")]
                    ("X4", InstructionSet::Fused, sweep::<Function, crate::vector::X4>, sweep::<Function, Fused<f64, Fma>>),
                    #[cfg(target_arch = "x86_64")]
                    ("S8", InstructionSet::Fused, sweep::<Function, crate::vector::S8>, sweep::<Function, Fused<f32, Fma>>),
                    #[cfg(target_arch = "x86_64")]
                    ("X8", InstructionSet::Avx512, sweep::<Function, crate::vector::X8>, sweep::<Function, Fused<f64, Fma>>),
                    #[cfg(target_arch = "x86_64")]
                    ("S16", InstructionSet::Avx512, sweep::<Function, crate::vector::S16>, sweep::<Function, Fused<f32, Fma>>),
                    ("the other clone", InstructionSet::Avx512, sweep::<Function, Fused<f64, Avx512>>, sweep::<Function, Fused<f64, Fma>>),
                ],
            }
        }),*];
    };
}

rows! {
    tan within 2.0 of pxfm::f_tan, Big::tan, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    exp within 1.0 of pxfm::f_exp, Big::exp, at [Points::Even(-1.0, 1.0), Points::Even(-760.0, 720.0), Points::Even(-110.0, 90.0), Points::Powers(-60.0, 9.0)];
    ln within 1.0 of pxfm::f_log, Big::ln, at [Points::Even(0.5, 2.0), Points::Even(0.999, 1.001), Points::Sizes(-1080.0, 1024.0)];
    tanh within 2.0 of pxfm::f_tanh, Big::tanh, at [Points::Even(-1.0, 1.0), Points::Even(-22.0, 22.0), Points::Powers(-60.0, 9.0)];
    sin within 1.0 of pxfm::f_sin, Big::sin, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    fast_sin within 4.0 of pxfm::f_sin, Big::sin, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    fast_cos within 4.0 of pxfm::f_cos, Big::cos, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
    cos within 1.0 of pxfm::f_cos, Big::cos, at [Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters];
}
