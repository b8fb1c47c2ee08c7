//! Numbers with derivatives in lanes, as bodies in a row and as sites in a block: a vector of the values, and one of
//! the derivatives along each direction.

use super::{Dual, dual};
use crate::scalar::{
    real::Real,
    simd::{
        block::{Block, PICKED, WIDEST, pick},
        row::Row,
    },
};

/// Writes values, and derivatives along each direction, to where they are numbers one by one, from a row or a block. As `dual!`,
/// without a call of its own.
macro_rules! write_apart {
    ($vector:ident, $to:ident) => {{
        let mut numbers = [F::of(0.0); WIDEST];
        $vector.value.write(&mut numbers);
        for (dual, number) in $to.iter_mut().zip(numbers) {
            dual.value = number;
        }
        for (direction, along) in $vector.along.into_iter().enumerate() {
            along.write(&mut numbers);
            for (dual, number) in $to.iter_mut().zip(numbers) {
                dual.along[direction] = number;
            }
        }
    }};
}

impl<F: Real, V: Block<F>, const N: usize, const SENSITIVE: bool> Block<Dual<F, N, false, SENSITIVE>>
    for Dual<V, N, true, SENSITIVE>
{
    const WIDTH: usize = V::WIDTH;

    #[inline(always)]
    fn read(from: &[Dual<F, N, false, SENSITIVE>]) -> Self {
        let from = &from[..V::WIDTH];
        if const { N == 1 } {
            let [value, along] = pairs::<F, V, N, SENSITIVE>(from);
            let [value, along] = value.deinterleave(along);
            return Self { value, along: [along; N] };
        }
        let mut numbers = [from[0].value; WIDEST];
        for (number, dual) in numbers.iter_mut().zip(from) {
            *number = dual.value;
        }
        dual!(V::read(&numbers), direction => {
            for (number, dual) in numbers.iter_mut().zip(from) {
                *number = dual.along[direction];
            }
            V::read(&numbers)
        })
    }
    #[inline(always)]
    fn write(self, to: &mut [Dual<F, N, false, SENSITIVE>]) {
        let to = &mut to[..V::WIDTH];
        if const { N == 1 } {
            return write_pairs(self.value.interleave(self.along[0]), to);
        }
        write_apart!(self, to);
    }
    #[inline(always)]
    fn splat(x: Dual<F, N, false, SENSITIVE>) -> Self {
        dual!(V::splat(x.value), direction => V::splat(x.along[direction]))
    }
    #[inline(always)]
    fn add_multiple(self, factor: Dual<F, N, false, SENSITIVE>, to: &mut [Dual<F, N, false, SENSITIVE>]) {
        if const { N == 1 } {
            let factor = V::splat(factor.value);
            // Pairs as they are in memory, so that only what is added takes an interleaving.
            let ([first, second], to) = (self.value.interleave(self.along[0]), &mut to[..V::WIDTH]);
            let pairs = pairs::<F, V, N, SENSITIVE>(to);
            return write_pairs([factor.fma(first, pairs[0]), factor.fma(second, pairs[1])], to);
        }
        // Number by number, so that what was read and is only added again is not moved between registers.
        let (mut numbers, to) = ([factor.value; WIDEST], &mut to[..V::WIDTH]);
        self.value.write(&mut numbers);
        for (dual, number) in to.iter_mut().zip(numbers) {
            dual.value = factor.value.fma(number, dual.value);
        }
        for (direction, along) in self.along.into_iter().enumerate() {
            along.write(&mut numbers);
            for (dual, number) in to.iter_mut().zip(numbers) {
                dual.along[direction] = factor.value.fma(number, dual.along[direction]);
            }
        }
    }
    #[inline(always)]
    fn less_bits(self, other: Self) -> u64 {
        self.value.less_bits(other.value)
    }
    #[inline(always)]
    fn pick(words: &[u32; PICKED], bits: u64, to: &mut [u32; PICKED]) -> usize {
        pick(words, bits, to)
    }
    #[inline(always)]
    fn after(self, next: Self) -> Self {
        dual!(self.value.after(next.value), direction => self.along[direction].after(next.along[direction]))
    }
    #[inline(always)]
    fn before(self, previous: Self) -> Self {
        dual!(self.value.before(previous.value), direction => self.along[direction].before(previous.along[direction]))
    }
    #[inline(always)]
    fn deinterleave(self, next: Self) -> [Self; 2] {
        let (mut even, mut odd) = (self, next);
        [even.value, odd.value] = self.value.deinterleave(next.value);
        for direction in 0..N {
            [even.along[direction], odd.along[direction]] = self.along[direction].deinterleave(next.along[direction]);
        }
        [even, odd]
    }
    #[inline(always)]
    fn interleave(self, odd: Self) -> [Self; 2] {
        let (mut first, mut second) = (self, odd);
        [first.value, second.value] = self.value.interleave(odd.value);
        for direction in 0..N {
            [first.along[direction], second.along[direction]] = self.along[direction].interleave(odd.along[direction]);
        }
        [first, second]
    }
}

/// Returns as many numbers with one derivative each as a vector has lanes, in the order of memory.
#[inline(always)]
fn pairs<F: Real, V: Block<F>, const N: usize, const SENSITIVE: bool>(from: &[Dual<F, N, false, SENSITIVE>]) -> [V; 2] {
    let numbers = &Dual::in_memory(from)[..2 * V::WIDTH];
    [V::read(numbers), V::read(&numbers[V::WIDTH..])]
}

/// Writes such pairs where they were.
#[inline(always)]
fn write_pairs<F: Real, V: Block<F>, const N: usize, const SENSITIVE: bool>(
    [first, second]: [V; 2],
    to: &mut [Dual<F, N, false, SENSITIVE>],
) {
    let numbers = &mut Dual::in_memory_mut(to)[..2 * V::WIDTH];
    first.write(numbers);
    second.write(&mut numbers[V::WIDTH..]);
}

impl<F: Real, V: Row<F>, const N: usize, const SENSITIVE: bool> Row<Dual<F, N, false, SENSITIVE>>
    for Dual<V, N, true, SENSITIVE>
{
    const UNROLLED: bool = V::UNROLLED;
    const PARTS: usize = V::PARTS;

    #[inline(always)]
    fn splat(x: Dual<F, N, false, SENSITIVE>) -> Self {
        dual!(V::splat(x.value), direction => V::splat(x.along[direction]))
    }
    #[inline(always)]
    fn rotate<const BODIES: usize>(self, by: usize) -> Self {
        dual!(self.value.rotate::<BODIES>(by), direction => self.along[direction].rotate::<BODIES>(by))
    }
    #[inline(always)]
    fn read(from: &[Dual<F, N, false, SENSITIVE>]) -> Self {
        let width = V::LANES / F::LANES;
        let (from, mut pairs) = (&from[..width], [from[0].value; 2 * WIDEST]);
        if const { N == 1 } {
            // Whole vectors, which the compiler then separates in registers.
            let numbers = &Dual::in_memory(from)[..2 * width];
            V::read(numbers).write(&mut pairs);
            V::read(&numbers[width..]).write(&mut pairs[width..]);
        }
        let mut numbers = [from[0].value; WIDEST];
        for (lane, number) in numbers[..width].iter_mut().enumerate() {
            *number = if const { N == 1 } { pairs[2 * lane] } else { from[lane].value };
        }
        dual!(V::read(&numbers), direction => {
            for (lane, number) in numbers[..width].iter_mut().enumerate() {
                *number = if const { N == 1 } { pairs[2 * lane + 1] } else { from[lane].along[direction] };
            }
            V::read(&numbers)
        })
    }
    #[inline(always)]
    fn write(self, to: &mut [Dual<F, N, false, SENSITIVE>]) {
        let to = &mut to[..V::LANES / F::LANES];
        write_apart!(self, to);
    }
    #[inline(always)]
    fn permute(self, indices: &[u64; 8]) -> Self {
        dual!(self.value.permute(indices), direction => self.along[direction].permute(indices))
    }
    #[inline(always)]
    fn part(&self, body: usize) -> Dual<F, N, false, SENSITIVE> {
        let mut part = Dual { value: self.value.part(body), along: [F::of(0.0); N] };
        for (part, along) in part.along.iter_mut().zip(&self.along) {
            *part = along.part(body);
        }
        part
    }
    #[inline(always)]
    fn set_part(&mut self, body: usize, number: Dual<F, N, false, SENSITIVE>) {
        self.value.set_part(body, number.value);
        for (along, number) in self.along.iter_mut().zip(number.along) {
            along.set_part(body, number);
        }
    }
    #[inline(always)]
    fn transposed(
        points: &[[Dual<F, N, false, SENSITIVE>; 4]],
        indices: &[u32; 8],
        stride: usize,
        offset: usize,
    ) -> [Self; 4] {
        let mut numbers = [[Dual::of(0.0); 8]; 4];
        for (lane, index) in indices.iter().enumerate() {
            let point = points[*index as usize * stride + offset];
            for (row, number) in numbers.iter_mut().zip(point) {
                row[lane] = number;
            }
        }
        numbers.map(|numbers| Row::read(&numbers))
    }
}
