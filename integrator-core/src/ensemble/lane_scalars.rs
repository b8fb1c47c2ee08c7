//! The vectors whose lanes are members of an ensemble, for each instruction set.

use crate::{
    scalar::{
        fma::{Avx512, Fma, Fused},
        real::Real,
    },
    state::{compensated::Compensated, fixed::Fixed, precision::Precision},
};

#[cfg(not(target_arch = "x86_64"))]
use crate::scalar::simd::lanes::Lanes;

/// The scalars with lanes that members of an ensemble are computed in. Named nowhere outside, like the types it leads
/// to: vectors may only be used where their instructions were detected.
pub trait LaneScalars: Precision {
    /// The scalar for every machine.
    type Plain: Real;
    /// The scalar for machines with fused multiply-add.
    type Fused: Real;
    /// The scalar for machines with AVX-512.
    type Avx512: Real;
}

/// A register where its instructions are known, else as many scalars as the 128 bits of every baseline hold.
#[cfg(target_arch = "x86_64")]
type Vector<F, S, const N: usize> = <Fused<F, S> as Real>::Block;
#[cfg(not(target_arch = "x86_64"))]
type Vector<F, S, const N: usize> = Lanes<Fused<F, S>, N>;

/// Scalars on x86, where nearly every processor has fused multiply-add: vectors for the others are a quarter of what an ensemble
/// takes to compile. Elsewhere as many as 128 bits hold.
#[cfg(target_arch = "x86_64")]
type Least<F, const N: usize> = F;
#[cfg(not(target_arch = "x86_64"))]
type Least<F, const N: usize> = Lanes<F, N>;

macro_rules! lane_scalars {
    ($($leaf:ty: $lanes:literal of $scalar:ident;)*) => {$(
        impl LaneScalars for $leaf {
            type Plain = Least<$scalar, $lanes>;
            type Fused = Vector<$scalar, Fma, $lanes>;
            type Avx512 = Vector<$scalar, Avx512, $lanes>;
        }
    )*};
}
lane_scalars! {
    f64: 2 of f64;
    Compensated<f64>: 2 of f64;
    Fixed<f64>: 2 of f64;
    f32: 4 of f32;
}
