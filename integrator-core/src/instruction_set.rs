//! Which instructions this machine has, and the way into code compiled for them. One of the two modules with
//! `unsafe`; the other holds the vectors.

use crate::real::Kernel;
use std::sync::OnceLock;

/// The instruction sets that the hot loops are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// What every machine of the target has.
    Baseline,
    /// Fused multiply-add: AVX2 and FMA on x86-64, every aarch64.
    Fused,
}

impl InstructionSet {
    /// The best set of this machine, or the one that the environment variable `INTEGRATOR_ISA` asks for (`baseline` or
    /// `avx2`), read once. A set that the machine lacks is not used, whatever the variable says.
    pub fn chosen() -> Self {
        static CHOSEN: OnceLock<InstructionSet> = OnceLock::new();
        *CHOSEN.get_or_init(|| Self::choose(std::env::var("INTEGRATOR_ISA").ok().as_deref(), fused_available()))
    }

    fn choose(asked: Option<&str>, fused: bool) -> Self {
        match asked {
            Some("baseline") => Self::Baseline,
            _ if fused => Self::Fused,
            _ => Self::Baseline,
        }
    }
}

#[cfg(target_arch = "x86_64")]
fn fused_available() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(not(target_arch = "x86_64"))]
fn fused_available() -> bool {
    cfg!(target_arch = "aarch64")
}

/// Runs `kernel` in code compiled for AVX2 and FMA; where the machine lacks them, in plain code with the same result.
#[cfg(target_arch = "x86_64")]
#[inline]
#[allow(unsafe_code, reason = "calling a function compiled for more than the target's features")]
pub(crate) fn enter_fused<K: Kernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx2,fma")]
    fn clone<K: Kernel>(kernel: K) -> K::Out {
        kernel.call()
    }

    if fused_available() {
        // SAFETY: the features that `clone` is compiled for were just detected.
        unsafe { clone(kernel) }
    } else {
        kernel.call()
    }
}

/// Fused multiply-add is part of the target here, or absent: there is no clone to enter.
#[cfg(not(target_arch = "x86_64"))]
#[inline]
pub(crate) fn enter_fused<K: Kernel>(kernel: K) -> K::Out {
    kernel.call()
}

#[cfg(test)]
mod tests {
    use super::InstructionSet::{self, Baseline, Fused};

    #[test]
    fn the_machine_decides_and_the_variable_only_restricts() {
        let table = [
            (None, true, Fused),
            (None, false, Baseline),
            (Some("baseline"), true, Baseline),
            (Some("avx2"), true, Fused),
            (Some("avx2"), false, Baseline),
            (Some("nonsense"), true, Fused),
        ];
        for (asked, available, expected) in table {
            assert_eq!(InstructionSet::choose(asked, available), expected, "{asked:?} where fused is {available}");
        }
    }
}
