//! AVX-512 and AVX2 registers.

use crate::vector::{Row, Two, Vector};
use std::{
    arch::x86_64::*,
    ops::{Add, Div, Mul, Sub},
};

/// Calls intrinsics for detected instructions.
macro_rules! instruction {
    ($call:expr) => {
        // SAFETY: only `enter` uses the types of this file, after detecting their instructions.
        unsafe { $call }
    };
}

macro_rules! operators {
    ($name:ident; $($trait:ident $method:ident $instruction:ident),*) => {$(
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(instruction!($instruction(self.0, other.0)))
            }
        }
    )*};
}

macro_rules! vector {
    ($name:ident: $register:ident of $lanes:literal $number:ident, bits $to_bits:ident $from_bits:ident;
     operators $add:ident $sub:ident $mul:ident $div:ident $fma:ident $fnma:ident $sqrt:ident;
     memory $splat:ident $load:ident $store:ident;
     integers $of_integer:ident $shift:ident $xor:ident $and:ident $plus:ident, sign $top:literal mantissa $mantissa:literal;
     $($method:item)*) => {
        #[doc = concat!($lanes, " lanes of ", stringify!($number), ".")]
        #[derive(Clone, Copy)]
        pub(crate) struct $name($register);

        operators!($name; Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Vector for $name {
            type Number = $number;
            const LANES: usize = $lanes;

            #[inline(always)]
            fn splat(x: f64) -> Self {
                Self(instruction!($splat(x as $number)))
            }
            #[inline(always)]
            fn load(from: &[$number]) -> Self {
                let from = &from[..$lanes];
                Self(instruction!($load(from.as_ptr())))
            }
            #[inline(always)]
            fn store(self, to: &mut [$number]) {
                let to = &mut to[..$lanes];
                instruction!($store(to.as_mut_ptr(), self.0));
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                Self(instruction!($fma(self.0, b.0, c.0)))
            }
            #[inline(always)]
            fn fnma(self, b: Self, c: Self) -> Self {
                Self(instruction!($fnma(self.0, b.0, c.0)))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(instruction!($sqrt(self.0)))
            }
            #[inline(always)]
            fn negate<const BIT: u32>(self, of: Self) -> Self {
                Self(instruction!({
                    let turned = $shift($to_bits(of.0), $of_integer(($top - BIT as i32).into()));
                    let turned = $and(turned, $to_bits($splat(-0.0)));
                    $from_bits($xor($to_bits(self.0), turned))
                }))
            }
            #[inline(always)]
            fn scale(self, of: Self) -> Self {
                Self(instruction!({
                    let exponents = $shift($to_bits(of.0), $of_integer($mantissa));
                    $from_bits($plus($to_bits(self.0), exponents))
                }))
            }
            $($method)*
        }
    };
}

vector! {
    X8: __m512d of 8 f64, bits _mm512_castpd_si512 _mm512_castsi512_pd;
    operators _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_fmadd_pd _mm512_fnmadd_pd _mm512_sqrt_pd;
    memory _mm512_set1_pd _mm512_loadu_pd _mm512_storeu_pd;
    integers _mm512_set1_epi64 _mm512_sllv_epi64 _mm512_xor_si512 _mm512_and_si512 _mm512_add_epi64, sign 63 mantissa 52;

    /// A 14-bit estimate, improved by the series of (1 - e)^(-3/2) in its relative error.
    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        let y = Self(instruction!(_mm512_rsqrt14_pd(self.0)));
        let square = y * y;
        let lack = self.fnma(square, Self::splat(1.0));
        let series = Self::splat(35.0 / 16.0).fma(lack, Self::splat(15.0 / 8.0)).fma(lack, Self::splat(1.5));
        let cube = numerator * (square * y);
        (series * lack).fma(cube, cube)
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(instruction!({
            let mask = _mm512_test_epi64_mask(_mm512_castpd_si512(of.0), _mm512_set1_epi64(1));
            _mm512_mask_blend_pd(mask, even.0, odd.0)
        }))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(instruction!(_mm512_maskz_mov_pd(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(x.0, y.0), self.0)))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        instruction!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(x.0, y.0)) != 0
    }
}

vector! {
    X16: __m512 of 16 f32, bits _mm512_castps_si512 _mm512_castsi512_ps;
    operators _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_fmadd_ps _mm512_fnmadd_ps _mm512_sqrt_ps;
    memory _mm512_set1_ps _mm512_loadu_ps _mm512_storeu_ps;
    integers _mm512_set1_epi32 _mm512_sllv_epi32 _mm512_xor_si512 _mm512_and_si512 _mm512_add_epi32, sign 31 mantissa 23;

    /// As for `f64`, with one term less.
    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        let y = Self(instruction!(_mm512_rsqrt14_ps(self.0)));
        let square = y * y;
        let lack = self.fnma(square, Self::splat(1.0));
        let cube = numerator * (square * y);
        (Self::splat(1.5) * lack).fma(cube, cube)
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(instruction!({
            let mask = _mm512_test_epi32_mask(_mm512_castps_si512(of.0), _mm512_set1_epi32(1));
            _mm512_mask_blend_ps(mask, even.0, odd.0)
        }))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(instruction!(_mm512_maskz_mov_ps(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(x.0, y.0), self.0)))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        instruction!(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(x.0, y.0)) != 0
    }
}

vector! {
    X4: __m256d of 4 f64, bits _mm256_castpd_si256 _mm256_castsi256_pd;
    operators _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_fmadd_pd _mm256_fnmadd_pd _mm256_sqrt_pd;
    memory _mm256_set1_pd _mm256_loadu_pd _mm256_storeu_pd;
    integers _mm256_set1_epi64x _mm256_sllv_epi64 _mm256_xor_si256 _mm256_and_si256 _mm256_add_epi64, sign 63 mantissa 52;

    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        numerator / (self * self.sqrt())
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(instruction!({
            let lowest = _mm256_slli_epi64::<63>(_mm256_castpd_si256(of.0));
            _mm256_blendv_pd(even.0, odd.0, _mm256_castsi256_pd(lowest))
        }))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(instruction!(_mm256_and_pd(self.0, _mm256_cmp_pd::<_CMP_LT_OQ>(x.0, y.0))))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        instruction!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(x.0, y.0))) != 0
    }
}

vector! {
    Y8: __m256 of 8 f32, bits _mm256_castps_si256 _mm256_castsi256_ps;
    operators _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_fmadd_ps _mm256_fnmadd_ps _mm256_sqrt_ps;
    memory _mm256_set1_ps _mm256_loadu_ps _mm256_storeu_ps;
    integers _mm256_set1_epi32 _mm256_sllv_epi32 _mm256_xor_si256 _mm256_and_si256 _mm256_add_epi32, sign 31 mantissa 23;

    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        numerator / (self * self.sqrt())
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(instruction!({
            let lowest = _mm256_slli_epi32::<31>(_mm256_castps_si256(of.0));
            _mm256_blendv_ps(even.0, odd.0, _mm256_castsi256_ps(lowest))
        }))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(instruction!(_mm256_and_ps(self.0, _mm256_cmp_ps::<_CMP_LT_OQ>(x.0, y.0))))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        instruction!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(x.0, y.0))) != 0
    }
}

vector! {
    X2: __m128d of 2 f64, bits _mm_castpd_si128 _mm_castsi128_pd;
    operators _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_fmadd_pd _mm_fnmadd_pd _mm_sqrt_pd;
    memory _mm_set1_pd _mm_loadu_pd _mm_storeu_pd;
    integers _mm_set1_epi64x _mm_sllv_epi64 _mm_xor_si128 _mm_and_si128 _mm_add_epi64, sign 63 mantissa 52;

    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        numerator / (self * self.sqrt())
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(instruction!({
            let lowest = _mm_slli_epi64::<63>(_mm_castpd_si128(of.0));
            _mm_blendv_pd(even.0, odd.0, _mm_castsi128_pd(lowest))
        }))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(instruction!(_mm_and_pd(self.0, _mm_cmplt_pd(x.0, y.0))))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        instruction!(_mm_movemask_pd(_mm_cmplt_pd(x.0, y.0))) != 0
    }
}

impl Two for X2 {
    #[inline(always)]
    fn of(first: f64, second: f64) -> Self {
        Self(instruction!(_mm_set_pd(second, first)))
    }
    #[inline(always)]
    fn first(self) -> f64 {
        instruction!(_mm_cvtsd_f64(self.0))
    }
    #[inline(always)]
    fn swap(self) -> Self {
        Self(instruction!(_mm_permute_pd::<0b01>(self.0)))
    }
    #[inline(always)]
    fn firsts(self) -> Self {
        Self(instruction!(_mm_movedup_pd(self.0)))
    }
    #[inline(always)]
    fn seconds(self) -> Self {
        Self(instruction!(_mm_unpackhi_pd(self.0, self.0)))
    }
    #[inline(always)]
    fn conjugate(self) -> Self {
        Self(instruction!(_mm_xor_pd(self.0, _mm_set_pd(-0.0, 0.0))))
    }
}

impl Row for X8 {
    #[inline(always)]
    fn rotate<const BY: usize, const N: usize>(self) -> Self {
        let lanes: [i64; 8] = std::array::from_fn(|lane| if lane < N { (lane + BY) % N } else { lane } as i64);
        Self(instruction!(_mm512_permutexvar_pd(_mm512_loadu_epi64(lanes.as_ptr()), self.0)))
    }
    #[inline(always)]
    fn after(self, next: Self) -> Self {
        let (low, high) = instruction!((_mm512_castpd_si512(self.0), _mm512_castpd_si512(next.0)));
        Self(instruction!(_mm512_castsi512_pd(_mm512_alignr_epi64::<1>(high, low))))
    }
    #[inline(always)]
    fn before(self, previous: Self) -> Self {
        let (low, high) = instruction!((_mm512_castpd_si512(previous.0), _mm512_castpd_si512(self.0)));
        Self(instruction!(_mm512_castsi512_pd(_mm512_alignr_epi64::<7>(high, low))))
    }
    #[inline(always)]
    fn pick(self, more: Self, lanes: &[i64; 8]) -> Self {
        Self(instruction!(_mm512_permutex2var_pd(self.0, _mm512_loadu_epi64(lanes.as_ptr()), more.0)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(instruction!(_mm512_max_pd(_mm512_abs_pd(self.0), _mm512_abs_pd(other.0))))
    }
    #[inline(always)]
    fn largest(self) -> f64 {
        instruction!(_mm512_reduce_max_pd(_mm512_abs_pd(self.0)))
    }
}

impl Row for X4 {
    #[inline(always)]
    fn rotate<const BY: usize, const N: usize>(self) -> Self {
        const { assert!(N == 4, "a ring of all lanes") };
        (0..BY).fold(self, |turned, _| turned.after(turned))
    }
    #[inline(always)]
    fn after(self, next: Self) -> Self {
        Self(instruction!({
            let middle = _mm256_permute2f128_pd::<0x21>(self.0, next.0);
            _mm256_shuffle_pd::<0b0101>(self.0, middle)
        }))
    }
    #[inline(always)]
    fn before(self, previous: Self) -> Self {
        Self(instruction!({
            let middle = _mm256_permute2f128_pd::<0x21>(previous.0, self.0);
            _mm256_shuffle_pd::<0b0101>(middle, self.0)
        }))
    }
    #[inline(always)]
    fn pick(self, more: Self, lanes: &[i64; 8]) -> Self {
        let mut numbers = [0.0; 8];
        self.store(&mut numbers);
        more.store(&mut numbers[4..]);
        Self::load(&[0, 1, 2, 3].map(|lane| numbers[lanes[lane] as usize]))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(instruction!({
            let sign = _mm256_set1_pd(-0.0);
            _mm256_max_pd(_mm256_andnot_pd(sign, self.0), _mm256_andnot_pd(sign, other.0))
        }))
    }
    #[inline(always)]
    fn largest(self) -> f64 {
        let mut numbers = [0.0; 4];
        self.larger(self).store(&mut numbers);
        numbers.into_iter().fold(0.0, f64::max)
    }
}
