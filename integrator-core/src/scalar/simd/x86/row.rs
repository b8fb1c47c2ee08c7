//! Rows of bodies in the lanes of one vector or two.

use super::{S8, V8, X4, X8};
use crate::scalar::{
    fma::{Avx512, Fma, Fused},
    real::Real,
    simd::{block::Block, lanes::Lanes, row::Row},
};
use core::arch::x86_64::{
    __m256d, __m256i, __m512d, __m512i, _MM_HINT_NTA, _mm_prefetch, _mm256_loadu_pd, _mm256_loadu_si256,
    _mm256_permutevar8x32_ps, _mm512_castpd256_pd512, _mm512_insertf64x4, _mm512_loadu_si512, _mm512_permutexvar_pd,
    _mm512_shuffle_f64x2, _mm512_unpackhi_pd, _mm512_unpacklo_pd,
};

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

/// Eight indices of lanes in a register.
#[inline(always)]
fn words(indices: &[u64; 8]) -> __m512i {
    // SAFETY: eight words of 64 bits are the 512 bits that are read; for the instruction set as in `instruction!`.
    unsafe { _mm512_loadu_si512(indices.as_ptr().cast()) }
}

/// Eight indices of lanes in half a register.
#[inline(always)]
fn half_words(indices: &[u32; 8]) -> __m256i {
    // SAFETY: eight words of 32 bits are the 256 bits that are read; for the instruction set as in `instruction!`.
    unsafe { _mm256_loadu_si256(indices.as_ptr().cast()) }
}

impl Row<Fused<f64, Avx512>> for X8 {
    #[inline(always)]
    fn splat(x: Fused<f64, Avx512>) -> Self {
        Self::of(x.0)
    }
    #[inline(always)]
    fn rotate<const N: usize>(self, by: usize) -> Self {
        let sources = &const { Sources::<N>::DOUBLES }[by];
        Self(instruction!(_mm512_permutexvar_pd(words(sources), self.0)))
    }
    #[inline(always)]
    fn read(from: &[Fused<f64, Avx512>]) -> Self {
        Block::read(from)
    }
    #[inline(always)]
    fn write(self, to: &mut [Fused<f64, Avx512>]) {
        Block::write(self, to);
    }
    #[inline(always)]
    fn permute(self, indices: &[u64; 8]) -> Self {
        Self(instruction!(_mm512_permutexvar_pd(words(indices), self.0)))
    }
    #[inline(always)]
    fn transposed(points: &[[Fused<f64, Avx512>; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4] {
        let point = |lane: usize| quadruple(&points[indices[lane] as usize * stride + offset]);
        // Two points in a register each, so that lanes are in order once halves of four registers are put together.
        let two = |low: usize, high: usize| {
            instruction!(_mm512_insertf64x4::<1>(_mm512_castpd256_pd512(point(low)), point(high)))
        };
        let [a, b, c, d] = [two(0, 2), two(1, 3), two(4, 6), two(5, 7)];
        let low = [instruction!(_mm512_unpacklo_pd(a, b)), instruction!(_mm512_unpacklo_pd(c, d))];
        let high = [instruction!(_mm512_unpackhi_pd(a, b)), instruction!(_mm512_unpackhi_pd(c, d))];
        let even = |[a, b]: [__m512d; 2]| Self(instruction!(_mm512_shuffle_f64x2::<0b10_00_10_00>(a, b)));
        let odd = |[a, b]: [__m512d; 2]| Self(instruction!(_mm512_shuffle_f64x2::<0b11_01_11_01>(a, b)));
        [even(low), even(high), odd(low), odd(high)]
    }
    #[inline(always)]
    fn fetch_once<T>(address: *const T) {
        fetch_once(address);
    }
}

/// Four numbers in half a register.
#[inline(always)]
fn quadruple(point: &[Fused<f64, Avx512>; 4]) -> __m256d {
    // SAFETY: four numbers are the 256 bits that are read, and `Fused` is transparent; for the instruction set as in
    // `instruction!`.
    unsafe { _mm256_loadu_pd(point.as_ptr().cast()) }
}

/// Brings a cache line near that is read once, past the caches that keep what is read again.
#[inline(always)]
fn fetch_once<T>(address: *const T) {
    // A hint, which no address makes a fault.
    instruction!(_mm_prefetch::<_MM_HINT_NTA>(address.cast()));
}

/// Eight singles, on either set.
macro_rules! singles {
    ($($vector:ident on $set:ident)*) => {$(
        impl Row<Fused<f32, $set>> for $vector {
            #[inline(always)]
            fn splat(x: Fused<f32, $set>) -> Self {
                Self::of(f64::from(x.0))
            }
            #[inline(always)]
            fn rotate<const N: usize>(self, by: usize) -> Self {
                let sources = &const { Sources::<N>::SINGLES }[by];
                Self(instruction!(_mm256_permutevar8x32_ps(self.0, half_words(sources))))
            }
            #[inline(always)]
            fn read(from: &[Fused<f32, $set>]) -> Self {
                Self::load(from)
            }
            #[inline(always)]
            fn write(self, to: &mut [Fused<f32, $set>]) {
                self.store(to);
            }
            #[inline(always)]
            fn permute(self, indices: &[u64; 8]) -> Self {
                let indices = indices.map(|index| index as u32);
                Self(instruction!(_mm256_permutevar8x32_ps(self.0, half_words(&indices))))
            }
            #[inline(always)]
            fn transposed(points: &[[Fused<f32, $set>; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4] {
                let mut numbers = [[Fused::of(0.0); 8]; 4];
                for (lane, index) in indices.iter().enumerate() {
                    let point = points[*index as usize * stride + offset];
                    for (row, number) in numbers.iter_mut().zip(point) {
                        row[lane] = number;
                    }
                }
                numbers.map(|numbers| Self::load(&numbers))
            }
            #[inline(always)]
            fn fetch_once<T>(address: *const T) {
                fetch_once(address);
            }
        }
    )*};
}
singles!(S8 on Fma V8 on Avx512);

impl Row<Fused<f64, Fma>> for Lanes<X4, 2> {
    #[inline(always)]
    fn splat(x: Fused<f64, Fma>) -> Self {
        Self::of(x.0)
    }
    #[inline(always)]
    fn rotate<const N: usize>(self, by: usize) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.part(0).lanes(), self.part(1).lanes());
        let x = [a, b, c, d, e, f, g, h];
        // Unrolled, since as a loop it goes through memory.
        let first = [x[source::<N>(0, by)], x[source::<N>(1, by)], x[source::<N>(2, by)], x[source::<N>(3, by)]];
        let second = [x[source::<N>(4, by)], x[source::<N>(5, by)], x[source::<N>(6, by)], x[source::<N>(7, by)]];
        Self::of_parts([X4::of_lanes(first), X4::of_lanes(second)])
    }
    #[inline(always)]
    fn read(from: &[Fused<f64, Fma>]) -> Self {
        Self::of_parts([Block::read(from), Block::read(&from[4..])])
    }
    #[inline(always)]
    fn write(self, to: &mut [Fused<f64, Fma>]) {
        Block::write(self.part(0), to);
        Block::write(self.part(1), &mut to[4..]);
    }
    #[inline(always)]
    fn permute(self, indices: &[u64; 8]) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.part(0).lanes(), self.part(1).lanes());
        let x = [a, b, c, d, e, f, g, h];
        let at = |lane: usize| x[indices[lane] as usize % 8];
        Self::of_parts([X4::of_lanes([at(0), at(1), at(2), at(3)]), X4::of_lanes([at(4), at(5), at(6), at(7)])])
    }
    #[inline(always)]
    fn transposed(points: &[[Fused<f64, Fma>; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4] {
        let mut numbers = [[Fused::of(0.0); 8]; 4];
        for (lane, index) in indices.iter().enumerate() {
            let point = points[*index as usize * stride + offset];
            for (row, number) in numbers.iter_mut().zip(point) {
                row[lane] = number;
            }
        }
        numbers.map(|numbers| <Self as Row<_>>::read(&numbers))
    }
    #[inline(always)]
    fn fetch_once<T>(address: *const T) {
        fetch_once(address);
    }
}

#[cfg(test)]
mod tests {
    use super::{Avx512, Fma, Fused, Lanes, Real, Row, S8, V8, X4, X8};
    use crate::scalar::instruction_set::InstructionSet;

    /// All rotations of `N` bodies: each lane gets the body that is this number of lanes ahead, and lanes after the last
    /// body repeat the first ones.
    fn rotations<W: Row<R>, R: Real, const N: usize>() {
        let number = |body: usize| 1.5 + body as f64;
        let row = W::state(&|lane| number(lane % N));
        for by in 0..N {
            let rotated = row.rotate::<N>(by);
            for lane in 0..W::LANES {
                assert_eq!(rotated.lane(lane), number((lane % N + by) % N), "lane {lane} of {N} bodies, by {by}");
            }
        }
        assert!((0..W::LANES).all(|lane| W::splat(R::of(2.5)).lane(lane) == 2.5));
    }

    /// Rows are read and written where they are, and their lanes are permuted in any order.
    fn permutations<W: Row<R>, R: Real>() {
        let array: Vec<R> = (0..12).map(|i| R::of(f64::from(i) + 0.5)).collect();
        for first in 0..4 {
            let (row, mut copy) = (W::read(&array[first..]), array.clone());
            (row + W::of(100.0)).write(&mut copy[first..]);
            for (i, number) in copy.iter().enumerate() {
                let moved = if (first..first + W::LANES).contains(&i) { 100.0 } else { 0.0 };
                assert_eq!(number.lane(0), i as f64 + 0.5 + moved, "number {i} of a row at {first}");
            }
            let permuted = row.permute(&[3, 3, 0, 7, 6, 1, 2, 0]);
            for (lane, from) in [3, 3, 0, 7, 6, 1, 2, 0].into_iter().enumerate() {
                assert_eq!(permuted.lane(lane), row.lane(from), "lane {lane} gets lane {from}");
            }
        }
    }

    fn all_rotations<W: Row<R>, R: Real>(set: InstructionSet) {
        if InstructionSet::available().contains(&set) {
            // A prefetch reads nothing.
            W::fetch_once(core::ptr::null::<R>());
            permutations::<W, R>();
            rotations::<W, R, 2>();
            rotations::<W, R, 3>();
            rotations::<W, R, 4>();
            rotations::<W, R, 5>();
            rotations::<W, R, 6>();
            rotations::<W, R, 7>();
            rotations::<W, R, 8>();
        }
    }

    #[test]
    fn rows_of_all_sets_rotate_alike() {
        all_rotations::<X8, Fused<f64, Avx512>>(InstructionSet::Avx512);
        all_rotations::<V8, Fused<f32, Avx512>>(InstructionSet::Avx512);
        all_rotations::<S8, Fused<f32, Fma>>(InstructionSet::Fused);
        all_rotations::<Lanes<X4, 2>, Fused<f64, Fma>>(InstructionSet::Fused);
        permutations::<Lanes<f64, 8>, f64>();
        rotations::<Lanes<f64, 5>, f64, 5>();
        rotations::<Lanes<f64, 8>, f64, 8>();
    }
}
