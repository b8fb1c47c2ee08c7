//! Runtime dispatch: detection of the instruction sets of this machine, and calls of the code compiled for them.

use crate::scalar::real::Kernel;
use core::fmt;
#[cfg(all(target_arch = "x86_64", feature = "std"))]
use core::{hint::black_box, mem::MaybeUninit};
#[cfg(feature = "std")]
use std::{env, sync::OnceLock};

/// The instruction sets for which hot loops are compiled, in increasing order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InstructionSet {
    /// The baseline of the target: instructions that all of its machines have.
    Baseline,
    /// Fused multiply-add: AVX2 and FMA on x86-64; always available on aarch64.
    Fused,
    /// Vectors of 512 bits: AVX-512 with its extensions F, DQ, VL and BW, on x86-64 only.
    Avx512,
}

impl InstructionSet {
    /// All sets, from the least to the most; a machine that has one has those before it.
    const ALL: [Self; 3] = [Self::Baseline, Self::Fused, Self::Avx512];

    /// Returns the instruction set for runs: the best one of this machine, or the one in the environment variable
    /// `INTEGRATOR_ISA`.
    ///
    /// The values of the variable are `baseline`, `avx2` and `avx512`; it is read once. A set that the machine lacks is
    /// never used. Without the feature `std` the machine cannot be queried, and the result is the baseline.
    pub fn chosen() -> Self {
        #[cfg(feature = "std")]
        {
            static CHOSEN: OnceLock<InstructionSet> = OnceLock::new();
            *CHOSEN.get_or_init(|| Self::choose(env::var("INTEGRATOR_ISA").ok().as_deref(), best()))
        }
        #[cfg(not(feature = "std"))]
        best()
    }

    /// Returns the instruction sets of this machine, the best one last.
    pub fn available() -> &'static [Self] {
        let best = best();
        &Self::ALL[..Self::ALL.iter().filter(|set| **set <= best).count()]
    }

    #[cfg(any(feature = "std", test))]
    fn choose(requested: Option<&str>, best: Self) -> Self {
        let requested = Self::ALL.into_iter().find(|set| Some(set.name()) == requested);
        requested.map_or(best, |requested| requested.min(best))
    }

    /// Returns the name in `INTEGRATOR_ISA`.
    fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Fused => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

/// Writes its name in the environment variable `INTEGRATOR_ISA`.
impl fmt::Display for InstructionSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The best set of this machine.
fn best() -> InstructionSet {
    if avx512_available() {
        InstructionSet::Avx512
    } else if fused_available() {
        InstructionSet::Fused
    } else {
        InstructionSet::Baseline
    }
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
fn fused_available() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
fn fused_available() -> bool {
    cfg!(all(target_arch = "aarch64", feature = "std"))
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[inline]
fn avx512_available() -> bool {
    // Asked once: each feature by itself takes as long as a short lattice for a few sites.
    static AVAILABLE: OnceLock<bool> = OnceLock::new();
    *AVAILABLE.get_or_init(|| {
        fused_available()
            && std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
            && std::arch::is_x86_feature_detected!("avx512vl")
            && std::arch::is_x86_feature_detected!("avx512bw")
            && std::arch::is_x86_feature_detected!("popcnt")
    })
}

#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
fn avx512_available() -> bool {
    false
}

/// Runs `kernel` in code compiled for the target as it is: a function of its own, so that a kernel is compiled once and
/// not wherever it is run, and not at all where the library has a copy.
#[inline(never)]
pub(crate) fn enter_baseline<K: Kernel>(kernel: K) -> K::Out {
    kernel.call()
}

/// Aligns the stack of the function that this is inlined into. The compiler aligns what it spills of registers only where
/// something in memory requires it: otherwise, whether such a register lies across two cache lines, whose access takes
/// twice as long, is decided by the address at which a process finds its stack.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[inline(always)]
fn align_stack() {
    /// A cache line, as long as the longest register.
    #[repr(align(64))]
    struct Line {
        _bytes: MaybeUninit<[u8; 64]>,
    }

    black_box(&Line { _bytes: MaybeUninit::uninit() });
}

/// Runs `kernel` in code compiled for AVX2 and FMA. Nothing else is compiled for it: its scalars are those of machines
/// that have them, and [`InstructionSet::chosen`] decides who gets these.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[inline]
#[allow(unsafe_code, reason = "calling a function compiled for more than the target's features")]
pub(crate) fn enter_fused<K: Kernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx2,fma")]
    fn variant<K: Kernel>(kernel: K) -> K::Out {
        align_stack();
        kernel.call()
    }

    #[inline(never)]
    #[target_feature(enable = "avx2,fma")]
    fn apart<K: Kernel>(kernel: K) -> K::Out {
        variant(kernel)
    }

    if !fused_available() {
        lacking(InstructionSet::Fused);
    }
    // SAFETY: the features that the variants are compiled for were detected.
    unsafe { if const { K::APART } { apart(kernel) } else { variant(kernel) } }
}

/// Fused multiply-add is part of the target here, or absent: there is no variant to enter.
#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
#[inline]
pub(crate) fn enter_fused<K: Kernel>(kernel: K) -> K::Out {
    enter_baseline(kernel)
}

/// Runs `kernel` as [`enter_fused`] where the machine has what that requires, and otherwise as [`enter_baseline`], with
/// the same result: for scalars that every machine computes in.
#[inline]
pub(crate) fn enter_fused_or_baseline<K: Kernel>(kernel: K) -> K::Out {
    if fused_available() { enter_fused(kernel) } else { enter_baseline(kernel) }
}

/// Runs `kernel` in code compiled for AVX-512, as [`enter_fused`] for its set.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[inline]
#[allow(unsafe_code, reason = "calling a function compiled for more than the target's features")]
pub(crate) fn enter_avx512<K: Kernel>(kernel: K) -> K::Out {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,popcnt")]
    fn variant<K: Kernel>(kernel: K) -> K::Out {
        align_stack();
        kernel.call()
    }

    #[inline(never)]
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,popcnt")]
    fn apart<K: Kernel>(kernel: K) -> K::Out {
        variant(kernel)
    }

    if !avx512_available() {
        lacking(InstructionSet::Avx512);
    }
    // SAFETY: the features that the variants are compiled for were detected.
    unsafe { if const { K::APART } { apart(kernel) } else { variant(kernel) } }
}

/// Nobody chooses a set that the machine lacks.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[cold]
#[inline(never)]
fn lacking(set: InstructionSet) -> ! {
    unreachable!("scalars of {set} on a machine without it");
}

#[cfg(test)]
mod tests {
    use super::InstructionSet::{self, Avx512, Baseline, Fused};

    #[test]
    fn the_machine_decides_and_the_variable_only_restricts() {
        let table = [
            (None, Avx512, Avx512),
            (None, Fused, Fused),
            (None, Baseline, Baseline),
            (Some("baseline"), Avx512, Baseline),
            (Some("avx2"), Avx512, Fused),
            (Some("avx2"), Fused, Fused),
            (Some("avx2"), Baseline, Baseline),
            (Some("avx512"), Avx512, Avx512),
            (Some("avx512"), Fused, Fused),
            (Some("nonsense"), Fused, Fused),
        ];
        for (requested, best, expected) in table {
            assert_eq!(InstructionSet::choose(requested, best), expected, "{requested:?} where {best} is the best");
        }
    }

    #[test]
    fn the_chosen_instruction_set_is_available() {
        let available = InstructionSet::available();
        assert_eq!(available.first(), Some(&Baseline));
        assert!(available.contains(&InstructionSet::chosen()), "{available:?}");
    }
}
