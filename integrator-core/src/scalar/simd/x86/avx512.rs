//! The registers of AVX-512, of 512 bits.

use super::{bits::bits, real::vector};
use crate::scalar::{fma::Avx512, functions::elementary_functions, real::Mask, simd::block::PICKED};
use core::arch::x86_64::{
    __m512, __m512d, __mmask8, __mmask16, _mm512_add_epi32, _mm512_add_epi64, _mm512_add_pd, _mm512_add_ps,
    _mm512_alignr_epi32, _mm512_alignr_epi64, _mm512_and_pd, _mm512_and_ps, _mm512_andnot_pd, _mm512_andnot_ps,
    _mm512_castpd_si512, _mm512_castps_si512, _mm512_castsi512_pd, _mm512_castsi512_ps, _mm512_cmp_pd_mask,
    _mm512_cmp_ps_mask, _mm512_div_pd, _mm512_div_ps, _mm512_fmadd_pd, _mm512_fmadd_ps, _mm512_loadu_pd,
    _mm512_loadu_ps, _mm512_loadu_si512, _mm512_mask_blend_pd, _mm512_mask_blend_ps, _mm512_maskz_compress_epi32,
    _mm512_mul_pd, _mm512_mul_ps, _mm512_permutex2var_pd, _mm512_permutex2var_ps, _mm512_roundscale_pd,
    _mm512_roundscale_ps, _mm512_set1_epi32, _mm512_set1_epi64, _mm512_set1_pd, _mm512_set1_ps, _mm512_setr_epi32,
    _mm512_setr_epi64, _mm512_sll_epi32, _mm512_sll_epi64, _mm512_sqrt_pd, _mm512_sqrt_ps, _mm512_srl_epi32,
    _mm512_srl_epi64, _mm512_storeu_pd, _mm512_storeu_ps, _mm512_storeu_si512, _mm512_sub_pd, _mm512_sub_ps,
    _mm512_test_epi32_mask, _mm512_test_epi64_mask, _mm512_xor_pd, _mm512_xor_ps,
};

/// A mask with one bit per lane.
macro_rules! mask {
    ($(#[$documentation:meta])* $mask:ident in $bits:ident) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug)]
        pub struct $mask($bits);

        impl $mask {
            #[inline(always)]
            pub(super) fn bits(self) -> u64 {
                u64::from(self.0)
            }
        }

        impl Mask for $mask {
            #[inline(always)]
            fn of(holds: bool) -> Self {
                Self(if holds { !0 } else { 0 })
            }
            #[inline(always)]
            fn any(self) -> bool {
                self.0 != 0
            }
            #[inline(always)]
            fn and(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
            #[inline(always)]
            fn or(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
            #[inline(always)]
            fn not(self) -> Self {
                Self(!self.0)
            }
        }
    };
}

mask! {
    /// A mask of eight lanes.
    X8Mask in __mmask8
}
mask! {
    /// A mask of sixteen lanes.
    S16Mask in __mmask16
}

/// Sixteen words at a time.
#[inline(always)]
fn pick(words: &[u32; PICKED], bits: u64, to: &mut [u32; PICKED]) -> usize {
    let mut count = 0;
    for (part, words) in words.as_chunks::<16>().0.iter().enumerate() {
        let bits = (bits >> (16 * part)) as u16;
        // SAFETY: sixteen words are read. As many are written after those of the earlier parts, which had sixteen each at
        // most; for the instruction set as in `instruction!`.
        unsafe {
            let picked = _mm512_maskz_compress_epi32(bits, _mm512_loadu_si512(words.as_ptr().cast()));
            _mm512_storeu_si512(to.as_mut_ptr().add(count).cast(), picked);
        }
        count += bits.count_ones() as usize;
    }
    count
}

elementary_functions!(vector! {
    /// Eight doubles.
    X8: 8 of f64 in __m512d, masked by X8Mask, of the instructions Avx512;
    load _mm512_loadu_pd, store _mm512_storeu_pd, splat _mm512_set1_pd,
    add _mm512_add_pd, sub _mm512_sub_pd, mul _mm512_mul_pd, div _mm512_div_pd,
    fma _mm512_fmadd_pd, sqrt _mm512_sqrt_pd, xor _mm512_xor_pd, andnot _mm512_andnot_pd, to whole numbers _mm512_roundscale_pd,
    compare _mm512_cmp_pd_mask, select |mask, a, b| _mm512_mask_blend_pd(mask, b, a),
    after |low, high| {
        let (low, high) = (_mm512_castpd_si512(low), _mm512_castpd_si512(high));
        _mm512_castsi512_pd(_mm512_alignr_epi64::<1>(high, low))
    },
    before |low, high| {
        let (low, high) = (_mm512_castpd_si512(low), _mm512_castpd_si512(high));
        _mm512_castsi512_pd(_mm512_alignr_epi64::<7>(high, low))
    },
    deinterleave |one, two| {
        let evens = _mm512_permutex2var_pd(one, _mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14), two);
        [evens, _mm512_permutex2var_pd(one, _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15), two)]
    },
    interleave |evens, odds| {
        let first = _mm512_permutex2var_pd(evens, _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11), odds);
        [first, _mm512_permutex2var_pd(evens, _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15), odds)]
    },
    pick pick;
    quotients super::div_sqrt, super::div_pow_3_2;
});
elementary_functions!(vector! {
    /// Sixteen singles.
    S16: 16 of f32 in __m512, masked by S16Mask, of the instructions Avx512;
    load _mm512_loadu_ps, store _mm512_storeu_ps, splat _mm512_set1_ps,
    add _mm512_add_ps, sub _mm512_sub_ps, mul _mm512_mul_ps, div _mm512_div_ps,
    fma _mm512_fmadd_ps, sqrt _mm512_sqrt_ps, xor _mm512_xor_ps, andnot _mm512_andnot_ps, to whole numbers _mm512_roundscale_ps,
    compare _mm512_cmp_ps_mask, select |mask, a, b| _mm512_mask_blend_ps(mask, b, a),
    after |low, high| {
        let (low, high) = (_mm512_castps_si512(low), _mm512_castps_si512(high));
        _mm512_castsi512_ps(_mm512_alignr_epi32::<1>(high, low))
    },
    before |low, high| {
        let (low, high) = (_mm512_castps_si512(low), _mm512_castps_si512(high));
        _mm512_castsi512_ps(_mm512_alignr_epi32::<15>(high, low))
    },
    deinterleave |one, two| {
        let evens = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
        let odds = _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
        [_mm512_permutex2var_ps(one, evens, two), _mm512_permutex2var_ps(one, odds, two)]
    },
    interleave |evens, odds| {
        let first = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
        let second = _mm512_setr_epi32(8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
        [_mm512_permutex2var_ps(evens, first, odds), _mm512_permutex2var_ps(evens, second, odds)]
    },
    pick pick;
    quotients super::div_sqrt, super::div_pow_3_2;
});

bits! {
    X8 of f64, words of u64, masked by X8Mask;
    to integers _mm512_castpd_si512, back _mm512_castsi512_pd, and _mm512_and_pd, xor _mm512_xor_pd,
    add _mm512_add_epi64, left _mm512_sll_epi64, right _mm512_srl_epi64, splat _mm512_set1_pd,
    odd |x| _mm512_test_epi64_mask(x, _mm512_set1_epi64(1))
}
bits! {
    S16 of f32, words of u32, masked by S16Mask;
    to integers _mm512_castps_si512, back _mm512_castsi512_ps, and _mm512_and_ps, xor _mm512_xor_ps,
    add _mm512_add_epi32, left _mm512_sll_epi32, right _mm512_srl_epi32, splat _mm512_set1_ps,
    odd |x| _mm512_test_epi32_mask(x, _mm512_set1_epi32(1))
}
