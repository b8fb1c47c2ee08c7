//! Entry into code compiled for the best instruction set of the machine.

use crate::vector::{Many, Row, Two, Vector};
#[cfg(target_arch = "x86_64")]
use crate::x86::{X2, X4, X8, X16, Y8};
use std::sync::OnceLock;

/// Code written once for all instruction sets.
pub(crate) trait Kernel {
    /// Return type.
    type Out;
    /// Runs the code with vectors of `f64`, rows of eight `f64`, and vectors of `f32`. Implementations are
    /// `inline(always)`, which is not possible for closures.
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> Self::Out;
}

/// Code written for two values in two lanes.
pub(crate) trait PairKernel {
    /// Return type.
    type Out;
    /// Runs the code.
    fn run<T: Two>(self) -> Self::Out;
}

/// Instruction set of the hand-written steppers: the best one of this machine that `INTEGRATOR_ISA` allows, as for
/// generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd)]
pub enum Instructions {
    /// The instructions of the compilation target, including fused multiply-add on aarch64.
    Baseline,
    /// AVX2 and FMA.
    Avx2,
    /// AVX-512.
    Avx512,
}

impl Instructions {
    /// Returns the best available and allowed instruction set.
    pub fn chosen() -> Self {
        static CHOSEN: OnceLock<Instructions> = OnceLock::new();
        *CHOSEN.get_or_init(|| {
            let allowed = match std::env::var("INTEGRATOR_ISA").as_deref() {
                Ok("baseline") => Self::Baseline,
                Ok("avx2") => Self::Avx2,
                _ => Self::Avx512,
            };
            let detected = detected();
            if detected < allowed { detected } else { allowed }
        })
    }
}

#[cfg(target_arch = "x86_64")]
fn detected() -> Instructions {
    use std::arch::is_x86_feature_detected as has;
    match (has!("avx2") && has!("fma"), has!("avx512f") && has!("avx512dq") && has!("avx512vl")) {
        (true, true) => Instructions::Avx512,
        (true, false) => Instructions::Avx2,
        _ => Instructions::Baseline,
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn detected() -> Instructions {
    Instructions::Baseline
}

/// Runs `kernel` with the widest vectors.
#[cfg(target_arch = "x86_64")]
pub(crate) fn enter<K: Kernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn widest<K: Kernel>(kernel: K) -> K::Out {
        kernel.run::<X8, X8, X16>()
    }
    #[target_feature(enable = "avx2,fma")]
    fn wide<K: Kernel>(kernel: K) -> K::Out {
        kernel.run::<X4, Many<f64, 8>, Y8>()
    }
    match Instructions::chosen() {
        // SAFETY: these instructions were detected.
        Instructions::Avx512 => unsafe { widest(kernel) },
        // SAFETY: these instructions were detected.
        Instructions::Avx2 => unsafe { wide(kernel) },
        Instructions::Baseline => kernel.run::<Many<f64, 4>, Many<f64, 8>, Many<f32, 8>>(),
    }
}

/// Runs `kernel` with arrays in place of vectors.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn enter<K: Kernel>(kernel: K) -> K::Out {
    kernel.run::<Many<f64, 4>, Many<f64, 8>, Many<f32, 8>>()
}

/// Runs `kernel` in code for AVX2 and FMA. For scalar code, this is often faster than code for AVX-512.
#[cfg(target_arch = "x86_64")]
pub(crate) fn enter_scalar<K: Kernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx2,fma")]
    fn scalar<K: Kernel>(kernel: K) -> K::Out {
        kernel.run::<Many<f64, 1>, Many<f64, 8>, Many<f32, 1>>()
    }
    match Instructions::chosen() {
        Instructions::Baseline => kernel.run::<Many<f64, 1>, Many<f64, 8>, Many<f32, 1>>(),
        // SAFETY: these instructions were detected; a machine with AVX-512 has them as well.
        _ => unsafe { scalar(kernel) },
    }
}

/// Runs `kernel` with scalars.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn enter_scalar<K: Kernel>(kernel: K) -> K::Out {
    kernel.run::<Many<f64, 1>, Many<f64, 8>, Many<f32, 1>>()
}

/// Runs `kernel` in code for AVX2 and FMA, or for AVX-512, which also has twice as many registers of this width.
#[cfg(target_arch = "x86_64")]
pub(crate) fn enter_pair<K: PairKernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn many<K: PairKernel>(kernel: K) -> K::Out {
        kernel.run::<X2>()
    }
    #[target_feature(enable = "avx2,fma")]
    fn few<K: PairKernel>(kernel: K) -> K::Out {
        kernel.run::<X2>()
    }
    match Instructions::chosen() {
        // SAFETY: these instructions were detected.
        Instructions::Avx512 => unsafe { many(kernel) },
        // SAFETY: these instructions were detected.
        Instructions::Avx2 => unsafe { few(kernel) },
        Instructions::Baseline => kernel.run::<Many<f64, 2>>(),
    }
}

/// Runs `kernel` with arrays of two.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn enter_pair<K: PairKernel>(kernel: K) -> K::Out {
    kernel.run::<Many<f64, 2>>()
}
