//! Bodies in the lanes of a vector, or of two.

use super::{S8, X4, X8};
use crate::{
    fused::{Avx512, Fma, Fused},
    lanes::Lanes,
    real::Real,
    row::Row,
};
use core::arch::x86_64::{_mm256_loadu_si256, _mm256_permutevar8x32_ps, _mm512_loadu_si512, _mm512_permutexvar_pd};

/// The lane that each lane is taken from when `N` bodies are rotated. A constant, since both numbers are.
#[inline(always)]
const fn source<const N: usize>(lane: usize, by: usize) -> usize {
    (lane % N + by) % N
}

/// For each rotation of `N` bodies, the lanes that the eight lanes are taken from.
struct Sources<const N: usize>;

impl<const N: usize> Sources<N> {
    const DOUBLES: [[u64; 8]; 8] = {
        let mut sources = [[0; 8]; 8];
        let mut at = 0;
        while at < 64 {
            sources[at / 8][at % 8] = source::<N>(at % 8, at / 8) as u64;
            at += 1;
        }
        sources
    };
    const SINGLES: [[u32; 8]; 8] = {
        let mut sources = [[0; 8]; 8];
        let mut at = 0;
        while at < 64 {
            sources[at / 8][at % 8] = source::<N>(at % 8, at / 8) as u32;
            at += 1;
        }
        sources
    };
}

impl Row<Fused<f64, Avx512>> for X8 {
    #[inline(always)]
    fn splat(x: Fused<f64, Avx512>) -> Self {
        Self::of(x.0)
    }
    #[inline(always)]
    fn rotated<const N: usize>(self, by: usize) -> Self {
        let sources = &const { Sources::<N>::DOUBLES }[by];
        Self(instruction!(_mm512_permutexvar_pd(_mm512_loadu_si512(sources.as_ptr().cast()), self.0)))
    }
}

/// Eight singles, on either set.
macro_rules! singles {
    ($($set:ident)*) => {$(
        impl Row<Fused<f32, $set>> for S8 {
            #[inline(always)]
            fn splat(x: Fused<f32, $set>) -> Self {
                Self::of(f64::from(x.0))
            }
            #[inline(always)]
            fn rotated<const N: usize>(self, by: usize) -> Self {
                let sources = &const { Sources::<N>::SINGLES }[by];
                Self(instruction!(_mm256_permutevar8x32_ps(self.0, _mm256_loadu_si256(sources.as_ptr().cast()))))
            }
        }
    )*};
}
singles!(Fma Avx512);

impl Row<Fused<f64, Fma>> for Lanes<X4, 2> {
    #[inline(always)]
    fn splat(x: Fused<f64, Fma>) -> Self {
        Self::of(x.0)
    }
    #[inline(always)]
    fn rotated<const N: usize>(self, by: usize) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.part(0).lanes(), self.part(1).lanes());
        let x = [a, b, c, d, e, f, g, h];
        // Written out, since as a loop it goes through memory.
        let first = [x[source::<N>(0, by)], x[source::<N>(1, by)], x[source::<N>(2, by)], x[source::<N>(3, by)]];
        let second = [x[source::<N>(4, by)], x[source::<N>(5, by)], x[source::<N>(6, by)], x[source::<N>(7, by)]];
        Self::of_parts([X4::of_lanes(first), X4::of_lanes(second)])
    }
}
