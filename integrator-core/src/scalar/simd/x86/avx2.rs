//! The registers of AVX2 and FMA, of 256 bits.

use super::{bits::bits, real::vector};
use crate::scalar::{
    fma::{Avx512, Fma},
    functions::elementary_functions,
    real::Mask,
};
use core::arch::x86_64::{
    __m256, __m256d, _mm256_add_epi32, _mm256_add_epi64, _mm256_add_pd, _mm256_add_ps, _mm256_alignr_epi8,
    _mm256_and_pd, _mm256_and_ps, _mm256_andnot_pd, _mm256_andnot_ps, _mm256_blendv_pd, _mm256_blendv_ps,
    _mm256_castpd_si256, _mm256_castps_si256, _mm256_castsi256_pd, _mm256_castsi256_ps, _mm256_cmp_pd, _mm256_cmp_ps,
    _mm256_div_pd, _mm256_div_ps, _mm256_fmadd_pd, _mm256_fmadd_ps, _mm256_loadu_pd, _mm256_loadu_ps,
    _mm256_movemask_pd, _mm256_movemask_ps, _mm256_mul_pd, _mm256_mul_ps, _mm256_or_pd, _mm256_or_ps,
    _mm256_permute2f128_pd, _mm256_permute2f128_ps, _mm256_permute2x128_si256, _mm256_round_pd, _mm256_round_ps,
    _mm256_set1_pd, _mm256_set1_ps, _mm256_shuffle_pd, _mm256_shuffle_ps, _mm256_sll_epi32, _mm256_sll_epi64,
    _mm256_slli_epi32, _mm256_slli_epi64, _mm256_sqrt_pd, _mm256_sqrt_ps, _mm256_srl_epi32, _mm256_srl_epi64,
    _mm256_storeu_pd, _mm256_storeu_ps, _mm256_sub_pd, _mm256_sub_ps, _mm256_unpackhi_pd, _mm256_unpackhi_ps,
    _mm256_unpacklo_pd, _mm256_unpacklo_ps, _mm256_xor_pd, _mm256_xor_ps,
};

/// A mask in a register as wide as the numbers: the sign of a lane says whether the condition holds there.
macro_rules! mask {
    ($(#[$documentation:meta])* $mask:ident of $scalar:ident in $register:ident:
     $splat:ident $movemask:ident $and:ident $or:ident $xor:ident) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug)]
        pub struct $mask($register);

        impl $mask {
            #[inline(always)]
            pub(super) fn bits(self) -> u64 {
                u64::from(instruction!($movemask(self.0)).cast_unsigned())
            }
        }

        impl Mask for $mask {
            #[inline(always)]
            fn of(holds: bool) -> Self {
                let bits = if holds { $scalar::from_bits(!0) } else { 0.0 };
                Self(instruction!($splat(bits)))
            }
            #[inline(always)]
            fn any(self) -> bool {
                instruction!($movemask(self.0)) != 0
            }
            #[inline(always)]
            fn and(self, other: Self) -> Self {
                Self(instruction!($and(self.0, other.0)))
            }
            #[inline(always)]
            fn or(self, other: Self) -> Self {
                Self(instruction!($or(self.0, other.0)))
            }
            #[inline(always)]
            fn not(self) -> Self {
                Self(instruction!($xor(self.0, Self::of(true).0)))
            }
        }
    };
}

mask! {
    /// A mask of four lanes.
    X4Mask of f64 in __m256d: _mm256_set1_pd _mm256_movemask_pd _mm256_and_pd _mm256_or_pd _mm256_xor_pd
}
mask! {
    /// A mask of eight lanes.
    S8Mask of f32 in __m256: _mm256_set1_ps _mm256_movemask_ps _mm256_and_ps _mm256_or_ps _mm256_xor_ps
}

elementary_functions!(vector! {
    /// Four doubles.
    X4: 4 of f64 in __m256d, masked by X4Mask, of the instructions Fma;
    load _mm256_loadu_pd, store _mm256_storeu_pd, splat _mm256_set1_pd,
    add _mm256_add_pd, sub _mm256_sub_pd, mul _mm256_mul_pd, div _mm256_div_pd,
    fma _mm256_fmadd_pd, sqrt _mm256_sqrt_pd, xor _mm256_xor_pd, andnot _mm256_andnot_pd, to whole numbers _mm256_round_pd,
    compare _mm256_cmp_pd, select |mask, a, b| _mm256_blendv_pd(b, a, mask),
    after |low, high| _mm256_shuffle_pd::<0b0101>(low, _mm256_permute2f128_pd::<0x21>(low, high)),
    before |low, high| _mm256_shuffle_pd::<0b0101>(_mm256_permute2f128_pd::<0x21>(low, high), high),
    deinterleave |one, two| {
        let (low, high) = (_mm256_permute2f128_pd::<0x20>(one, two), _mm256_permute2f128_pd::<0x31>(one, two));
        [_mm256_unpacklo_pd(low, high), _mm256_unpackhi_pd(low, high)]
    },
    interleave |evens, odds| {
        let (low, high) = (_mm256_unpacklo_pd(evens, odds), _mm256_unpackhi_pd(evens, odds));
        [_mm256_permute2f128_pd::<0x20>(low, high), _mm256_permute2f128_pd::<0x31>(low, high)]
    },
    pick crate::scalar::simd::block::pick;
});
bits! {
    X4 of f64, words of u64, masked by X4Mask;
    to integers _mm256_castpd_si256, back _mm256_castsi256_pd, and _mm256_and_pd, xor _mm256_xor_pd,
    add _mm256_add_epi64, left _mm256_sll_epi64, right _mm256_srl_epi64, splat _mm256_set1_pd,
    odd |x| _mm256_castsi256_pd(_mm256_slli_epi64::<63>(x))
}
/// Eight singles, on either set.
macro_rules! eight_singles {
    ($(#[$documentation:meta])* $vector:ident on $set:ident $(, quotients $div_sqrt:path, $div_pow_3_2:path)?) => {
        elementary_functions!(vector! {
            $(#[$documentation])*
            $vector: 8 of f32 in __m256, masked by S8Mask, of the instructions $set;
            load _mm256_loadu_ps, store _mm256_storeu_ps, splat _mm256_set1_ps,
            add _mm256_add_ps, sub _mm256_sub_ps, mul _mm256_mul_ps, div _mm256_div_ps,
            fma _mm256_fmadd_ps, sqrt _mm256_sqrt_ps, xor _mm256_xor_ps, andnot _mm256_andnot_ps, to whole numbers _mm256_round_ps,
            compare _mm256_cmp_ps, select |mask, a, b| _mm256_blendv_ps(b, a, mask),
            after |low, high| {
                let (low, high) = (_mm256_castps_si256(low), _mm256_castps_si256(high));
                _mm256_castsi256_ps(_mm256_alignr_epi8::<4>(_mm256_permute2x128_si256::<0x21>(low, high), low))
            },
            before |low, high| {
                let (low, high) = (_mm256_castps_si256(low), _mm256_castps_si256(high));
                _mm256_castsi256_ps(_mm256_alignr_epi8::<12>(high, _mm256_permute2x128_si256::<0x21>(low, high)))
            },
            deinterleave |one, two| {
                let (low, high) = (_mm256_permute2f128_ps::<0x20>(one, two), _mm256_permute2f128_ps::<0x31>(one, two));
                [_mm256_shuffle_ps::<0x88>(low, high), _mm256_shuffle_ps::<0xdd>(low, high)]
            },
            interleave |evens, odds| {
                let (low, high) = (_mm256_unpacklo_ps(evens, odds), _mm256_unpackhi_ps(evens, odds));
                [_mm256_permute2f128_ps::<0x20>(low, high), _mm256_permute2f128_ps::<0x31>(low, high)]
            },
            pick crate::scalar::simd::block::pick;
            $(quotients $div_sqrt, $div_pow_3_2;)?
        });
        bits! {
            $vector of f32, words of u32, masked by S8Mask;
            to integers _mm256_castps_si256, back _mm256_castsi256_ps, and _mm256_and_ps, xor _mm256_xor_ps,
            add _mm256_add_epi32, left _mm256_sll_epi32, right _mm256_srl_epi32, splat _mm256_set1_ps,
            odd |x| _mm256_castsi256_ps(_mm256_slli_epi32::<31>(x))
        }
    };
}

eight_singles! {
    /// Eight singles.
    S8 on Fma
}
eight_singles! {
    /// Eight singles beside the vectors of AVX-512.
    V8 on Avx512, quotients super::div_sqrt, super::div_pow_3_2
}
