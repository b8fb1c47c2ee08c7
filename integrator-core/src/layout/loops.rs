//! Innermost loops of flows: several iterations in the lanes of a vector.
//!
//! In: what an iteration computes, the points that it reads and the numbers that it has. Out: sums over the iterations, and
//! a gradient. Always true: in groups of eight, iteration `n` of a loop adds to partial sum `n` modulo [`PARTIAL`]; the rest
//! has a sum of its own; partial sums are added in pairs, and then the rest. So the bits of a sum do not depend on the
//! width of a vector.

use crate::{
    scalar::{
        real::Real,
        simd::block::{Block, WIDEST},
    },
    state::precision::Slot,
};
use core::ops::Range;

/// The number of partial sums: a multiple of the width of every block.
pub(super) const PARTIAL: usize = WIDEST;

/// The number of iterations in a group. Fewer are computed one by one, which takes less time than to add partial sums.
pub(super) const GROUP: usize = 8;

/// A point that an iteration reads.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// The part of the coordinates that the point belongs to, by its number among those that are read.
    pub part: usize,
    /// The index of the point, less that of the iteration.
    pub offset: isize,
}

/// An iteration, on points with `D` components each: the numbers that it adds to sums, and to one point of each of `TARGETS`
/// gradients. It computes them from the points that it reads, from constants of its own, and from numbers that are
/// the same in all iterations. Written by `#[hamiltonian]`.
pub trait Iteration<
    const READS: usize,
    const CONSTANTS: usize,
    const COMMON: usize,
    const SUMS: usize,
    const TARGETS: usize,
    const D: usize,
>
{
    /// The points that it reads.
    const READS: [Near; READS];
    /// The index of the point of a gradient that it adds to, less that of the iteration.
    const TARGET: isize = 0;

    /// The sums and the gradient after a vector of iterations.
    fn next<R: Real, W: Block<R>>(
        reads: [[W; D]; READS],
        constants: [W; CONSTANTS],
        common: [W; COMMON],
        sums: [W; SUMS],
        gradient: [[W; D]; TARGETS],
    ) -> ([W; SUMS], [[W; D]; TARGETS]);
}

/// A loop: the indices of its iterations, and what they read.
pub struct Loop<'m, R, S, const PARTS: usize, const CONSTANTS: usize, const COMMON: usize, const D: usize> {
    /// The indices of the iterations, which are places in parts and constants.
    pub range: Range<usize>,
    /// The parts of the coordinates that are read.
    pub parts: [&'m [[S; D]]; PARTS],
    /// The constants of each iteration.
    pub constants: [&'m [R]; CONSTANTS],
    /// The numbers that all iterations share.
    pub common: [R; COMMON],
}

// Loops count by themselves: iterators and ranges take more lines of LLVM IR.
impl<R: Real, S: Slot<R>, const PARTS: usize, const CONSTANTS: usize, const COMMON: usize, const D: usize>
    Loop<'_, R, S, PARTS, CONSTANTS, COMMON, D>
{
    /// Runs all iterations. They add to the gradient, if to any, and the result is the sums.
    #[inline(always)]
    pub fn run<T, const READS: usize, const SUMS: usize, const TARGETS: usize>(
        self,
        gradient: &mut [[R; D]],
    ) -> [R; SUMS]
    where
        T: Iteration<READS, CONSTANTS, COMMON, SUMS, TARGETS, D>,
    {
        self.run_apart::<T, READS, SUMS, TARGETS>(&mut [gradient][..TARGETS])
    }

    /// The same with iterations that add to several gradients.
    #[inline(always)]
    pub fn run_apart<T, const READS: usize, const SUMS: usize, const TARGETS: usize>(
        mut self,
        gradients: &mut [&mut [[R; D]]],
    ) -> [R; SUMS]
    where
        T: Iteration<READS, CONSTANTS, COMMON, SUMS, TARGETS, D>,
    {
        let grouped = self.range.len() / GROUP * GROUP;
        let mut partial = [[R::of(0.0); PARTIAL]; SUMS];
        if grouped > 0 {
            let left = self.run_blocks::<R::Block, T, READS, SUMS, TARGETS>(grouped, &mut partial, gradients);
            if const { R::Block::WIDTH > GROUP } {
                self.run_blocks::<R, T, READS, SUMS, TARGETS>(left, &mut partial, gradients);
            }
        }
        let mut sums = [R::of(0.0); SUMS];
        while self.range.start < self.range.end {
            sums = self.run_block::<R, T, READS, SUMS, TARGETS>(self.common, sums, gradients);
        }
        if grouped > 0 {
            let mut sum = 0;
            while sum < SUMS {
                sums[sum] = total::<R, R::Block>(partial[sum]) + sums[sum];
                sum += 1;
            }
        }
        sums
    }

    /// Runs groups of iterations in whole blocks, beginning with the first partial sum. Returns how many iterations are left.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run_blocks<W: Block<R>, T, const READS: usize, const SUMS: usize, const TARGETS: usize>(
        &mut self,
        mut left: usize,
        partial: &mut [[R; PARTIAL]; SUMS],
        gradients: &mut [&mut [[R; D]]],
    ) -> usize
    where
        T: Iteration<READS, CONSTANTS, COMMON, SUMS, TARGETS, D>,
    {
        let mut common = [W::of(0.0); COMMON];
        let mut number = 0;
        while number < COMMON {
            common[number] = W::splat(self.common[number]);
            number += 1;
        }
        // The places of partial sums are constants, which lets these stay in registers.
        while left >= PARTIAL {
            let mut place = 0;
            while place < PARTIAL {
                self.add_block::<W, T, READS, SUMS, TARGETS>(place, common, partial, gradients);
                place += W::WIDTH;
            }
            left -= PARTIAL;
        }
        if const { W::WIDTH <= GROUP } && left > 0 {
            let mut place = 0;
            while place < GROUP {
                self.add_block::<W, T, READS, SUMS, TARGETS>(place, common, partial, gradients);
                place += W::WIDTH;
            }
            left = 0;
        }
        left
    }

    /// Runs the next block of iterations, which add to the partial sums from a place on.
    #[inline(always)]
    fn add_block<W: Block<R>, T, const READS: usize, const SUMS: usize, const TARGETS: usize>(
        &mut self,
        place: usize,
        common: [W; COMMON],
        partial: &mut [[R; PARTIAL]; SUMS],
        gradients: &mut [&mut [[R; D]]],
    ) where
        T: Iteration<READS, CONSTANTS, COMMON, SUMS, TARGETS, D>,
    {
        let mut sums = [W::of(0.0); SUMS];
        let mut sum = 0;
        while sum < SUMS {
            sums[sum] = W::read(&partial[sum][place..]);
            sum += 1;
        }
        let sums = self.run_block::<W, T, READS, SUMS, TARGETS>(common, sums, gradients);
        sum = 0;
        while sum < SUMS {
            sums[sum].write(&mut partial[sum][place..]);
            sum += 1;
        }
    }

    /// Runs the next block of iterations, and returns the sums after it.
    #[inline(always)]
    fn run_block<W: Block<R>, T, const READS: usize, const SUMS: usize, const TARGETS: usize>(
        &mut self,
        common: [W; COMMON],
        sums: [W; SUMS],
        gradients: &mut [&mut [[R; D]]],
    ) -> [W; SUMS]
    where
        T: Iteration<READS, CONSTANTS, COMMON, SUMS, TARGETS, D>,
    {
        let first = self.range.start;
        self.range.start += W::WIDTH;
        let mut number = 0;
        let mut reads = [[W::of(0.0); D]; READS];
        while number < READS {
            let Near { part, offset } = T::READS[number];
            reads[number] = points(&self.parts[part][first.wrapping_add_signed(offset)..]);
            number += 1;
        }
        let mut constants = [W::of(0.0); CONSTANTS];
        number = 0;
        while number < CONSTANTS {
            constants[number] = W::read(&self.constants[number][first..]);
            number += 1;
        }
        let target = first.wrapping_add_signed(T::TARGET);
        let mut moved = [[W::of(0.0); D]; TARGETS];
        number = 0;
        while number < TARGETS {
            moved[number] = points(&gradients[number][target..]);
            number += 1;
        }
        let (sums, moved) = T::next::<R, W>(reads, constants, common, sums, moved);
        number = 0;
        while number < TARGETS {
            write(moved[number], &mut gradients[number][target..]);
            number += 1;
        }
        sums
    }
}

/// Returns the points of a gradient before an index and from it on. Without an iteration, there may be none from it on.
pub fn apart<T>(gradient: &mut [T], from: usize) -> [&mut [T]; 2] {
    gradient.split_at_mut(from.min(gradient.len())).into()
}

/// The same of a gradient of numbers; each point has `D` of them.
pub fn groups_apart<T, const D: usize>(gradient: &mut [T], from: usize) -> [&mut [[T; D]]; 2] {
    let [first, second] = apart(gradient, from);
    [first.as_chunks_mut().0, second.as_chunks_mut().0]
}

/// A block of the first points of a slice.
#[cfg_attr(not(debug_assertions), inline(always))]
fn points<R: Real, S: Slot<R>, W: Block<R>, const D: usize>(from: &[[S; D]]) -> [W; D] {
    if const { D == 1 } {
        return [S::read(from.as_flattened()); D];
    }
    let (from, mut vectors) = (&from[..W::WIDTH], [W::of(0.0); D]);
    if const { D == 2 } {
        let numbers = from.as_flattened();
        let both = S::read::<W>(numbers).deinterleave(S::read(&numbers[W::WIDTH..]));
        vectors.copy_from_slice(&both);
        return vectors;
    }
    for component in 0..D {
        let mut numbers = [R::of(0.0); WIDEST];
        for lane in 0..W::WIDTH {
            numbers[lane] = from[lane][component].value();
        }
        vectors[component] = W::read(&numbers);
    }
    vectors
}

/// Writes a block to the first points of a slice.
#[cfg_attr(not(debug_assertions), inline(always))]
fn write<R: Real, W: Block<R>, const D: usize>(points: [W; D], to: &mut [[R; D]]) {
    if const { D == 1 } {
        points[0].write(to.as_flattened_mut());
        return;
    }
    let to = &mut to[..W::WIDTH];
    if const { D == 2 } {
        let (numbers, [first, second]) = (to.as_flattened_mut(), points[0].interleave(points[1]));
        first.write(numbers);
        second.write(&mut numbers[W::WIDTH..]);
        return;
    }
    for component in 0..D {
        let mut numbers = [R::of(0.0); WIDEST];
        points[component].write(&mut numbers);
        for lane in 0..W::WIDTH {
            to[lane][component] = numbers[lane];
        }
    }
}

/// The sum of `count` numbers, which come in blocks or one by one: number `n` adds to partial sum `n` modulo [`PARTIAL`].
#[inline(always)]
pub(super) fn sum<R: Real>(count: usize, block: impl Fn(usize) -> R::Block, number: impl Fn(usize) -> R) -> R {
    let (mut partial, mut next) = ([R::of(0.0); PARTIAL], 0);
    while next + <R::Block as Block<R>>::WIDTH <= count {
        let to = &mut partial[next & (PARTIAL - <R::Block as Block<R>>::WIDTH)..];
        let sum = <R::Block as Block<R>>::read(to) + block(next);
        sum.write(to);
        next += <R::Block as Block<R>>::WIDTH;
    }
    for next in next..count {
        partial[next & (PARTIAL - 1)] += number(next);
    }
    total::<R, R::Block>(partial)
}

/// The sum of partial sums: each of the second half is added to one of the first half, and so on.
#[inline(always)]
pub(super) fn total<R: Real, W: Block<R>>(mut partial: [R; PARTIAL]) -> R {
    let mut half = PARTIAL / 2;
    while half >= W::WIDTH {
        for lane in (0..half).step_by(W::WIDTH) {
            let sum = W::read(&partial[lane..]) + W::read(&partial[lane + half..]);
            sum.write(&mut partial[lane..]);
        }
        half /= 2;
    }
    while half > 0 {
        for lane in 0..half {
            let other = partial[lane + half];
            partial[lane] += other;
        }
        half /= 2;
    }
    partial[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        layout::products::{add_multiples_of_rows, inner_products},
        scalar::{
            fma::{Fma, Fused},
            instruction_set::InstructionSet,
            real::Kernel,
            simd::lanes::Lanes,
        },
    };
    use core::marker::PhantomData;

    /// Adds `factor constant (x - y)`, where `y` is the second component of the point before, to a sum, the square root of
    /// its square to another one, and the constant to the gradient of the point after.
    struct Difference;

    impl Iteration<2, 1, 1, 2, 1, 2> for Difference {
        const READS: [Near; 2] = [Near { part: 1, offset: 0 }, Near { part: 0, offset: -1 }];
        const TARGET: isize = 1;

        fn next<R: Real, W: Block<R>>(
            [[x, _], [_, y]]: [[W; 2]; 2],
            [constant]: [W; 1],
            [factor]: [W; 1],
            [mut first, mut second]: [W; 2],
            [[mut along, across]]: [[W; 2]; 1],
        ) -> ([W; 2], [[W; 2]; 1]) {
            let difference = factor * constant * (x - y);
            first += difference;
            second = difference.fma(difference, second).sqrt();
            along += constant;
            ([first, second], [[along, across]])
        }
    }

    /// The same with one component: adds products of neighbours to a sum.
    struct Product;

    impl Iteration<2, 0, 0, 1, 0, 1> for Product {
        const READS: [Near; 2] = [Near { part: 0, offset: 0 }, Near { part: 0, offset: 2 }];

        fn next<R: Real, W: Block<R>>(
            [[x], [y]]: [[W; 1]; 2],
            []: [W; 0],
            []: [W; 0],
            [sum]: [W; 1],
            []: [[W; 1]; 0],
        ) -> ([W; 1], [[W; 1]; 0]) {
            ([x.fma(y, sum)], [])
        }
    }

    /// The most iterations, beside those of an empty loop: some rests after two rounds of all partial sums.
    const MOST: usize = 40;
    const BEFORE: usize = 3;
    const POINTS: usize = BEFORE + MOST + 2;
    /// The number of rows: some that are computed together, and some that are left.
    const ROWS: usize = 6;

    /// Bits of all lanes.
    fn bits<R: Real>(number: R) -> Vec<u64> {
        (0..R::LANES).map(|lane| number.lane(lane).to_bits()).collect()
    }

    /// Where an iteration adds to: a partial sum, or that of the rest after them.
    fn place(number: usize, count: usize) -> usize {
        if number < count / GROUP * GROUP { number % PARTIAL } else { PARTIAL }
    }

    /// The sum of a loop, of numbers one by one.
    fn in_pairs<R: Real>(sums: [R; PARTIAL + 1], count: usize) -> R {
        if count < GROUP {
            return sums[PARTIAL];
        }
        let mut left = sums[..PARTIAL].to_vec();
        while left.len() > 1 {
            let (first, second) = left.split_at(left.len() / 2);
            left = first.iter().zip(second).map(|(a, b)| *a + *b).collect();
        }
        left[0] + sums[PARTIAL]
    }

    /// Runs loops of all lengths, and compares every bit with the definition.
    struct Compare<R>(PhantomData<R>);

    impl<R: Real> Kernel for Compare<R> {
        type Out = ();

        fn call(self) {
            let number = |seed: usize| {
                R::state(&|lane| (1.7 * seed as f64 + 0.3 * lane as f64).sin() * (1.0 + seed as f64 / 7.0))
            };
            let points = |seed: usize| -> Vec<[R; 2]> {
                (0..POINTS).map(|i| [0, 1].map(|d| number(seed + 2 * i + d))).collect()
            };
            let (q, p, start) = (points(1), points(500), points(900));
            let constants: Vec<R> = (0..POINTS + ROWS).map(|i| number(2000 + i)).collect();
            let factor = number(7);
            for count in 0..=MOST {
                let range = BEFORE..BEFORE + count;
                let (mut expected, mut partial) = (start.clone(), [[R::of(0.0); PARTIAL + 1]; 2]);
                let [mut products, mut inner] = [[R::of(0.0); PARTIAL + 1]; 2];
                let numbers = q.as_flattened();
                let mut multiples = start.as_flattened().to_vec();
                for (n, i) in range.clone().enumerate() {
                    let place = place(n, count);
                    let sums = [partial[0][place], partial[1][place]];
                    let (sums, [point]) =
                        Difference::next::<R, R>([p[i], q[i - 1]], [constants[i]], [factor], sums, [expected[i + 1]]);
                    (partial[0][place], partial[1][place], expected[i + 1]) = (sums[0], sums[1], point);
                    products[place] = numbers[i].fma(numbers[i + 2], products[place]);
                    inner[place] = constants[i].scale_add(numbers[i + 2], inner[place]);
                    multiples[i - 1] = constants[i].scale_add(factor, multiples[i - 1]);
                }
                let mut gradient = start.clone();
                let both = Loop {
                    range: range.clone(),
                    parts: [&q[..], &p[..]],
                    constants: [&constants[..]],
                    common: [factor],
                };
                let found = both.run::<Difference, _, _, _>(&mut gradient);
                assert_eq!(found.map(bits), partial.map(|sums| bits(in_pairs(sums, count))), "{count} iterations");
                for (point, expected) in gradient.iter().zip(&expected) {
                    assert_eq!(point.map(bits), expected.map(bits), "{count} iterations");
                }
                let parts = [numbers.as_chunks::<1>().0];
                let row = Loop { range: range.clone(), parts, constants: [&constants[..]], common: [] };
                assert_eq!(bits(row.inner_product(2)), bits(in_pairs(inner, count)), "{count} products");
                let mut gradient = start.as_flattened().to_vec();
                let row = Loop { range: range.clone(), parts, constants: [&constants[..]], common: [factor] };
                row.add_multiples(-1, gradient.as_chunks_mut::<1>().0);
                let all = |numbers: Vec<R>| numbers.into_iter().map(bits).collect::<Vec<_>>();
                assert_eq!(all(gradient), all(multiples), "{count} multiples");
                // Rows together are rows one after the other.
                let rows: Vec<&[R]> = (0..ROWS).map(|row| &constants[row..]).collect();
                let factors: Vec<R> = (0..ROWS).map(|row| number(3000 + row)).collect();
                let (mut inner, mut multiples) = (Vec::new(), start.as_flattened().to_vec());
                for (constants, factor) in rows.iter().zip(&factors) {
                    let row = Loop { range: range.clone(), parts, constants: [constants], common: [] };
                    inner.push(row.inner_product(2));
                    let row = Loop { range: range.clone(), parts, constants: [constants], common: [*factor] };
                    row.add_multiples(-1, multiples.as_chunks_mut::<1>().0);
                }
                let mut found = vec![R::of(0.0); ROWS];
                inner_products(&rows, range.clone(), 2, parts[0], &mut found);
                assert_eq!(all(found), all(inner), "{count} columns");
                let mut found = start.as_flattened().to_vec();
                add_multiples_of_rows(&rows, range.clone(), -1, &factors, found.as_chunks_mut::<1>().0);
                assert_eq!(all(found), all(multiples), "{count} columns");
                let line = Loop { range, parts, constants: [], common: [] };
                assert_eq!(
                    line.run::<Product, _, _, _>(&mut []).map(bits),
                    [bits(in_pairs(products, count))],
                    "{count} iterations"
                );
            }
        }
    }

    #[test]
    fn every_width_has_the_bits_of_the_definition() {
        fn compare<R: Real>() {
            R::enter(Compare(PhantomData::<R>));
        }
        compare::<f64>();
        compare::<f32>();
        compare::<Lanes<f64, 4>>();
        for set in InstructionSet::available() {
            match set {
                InstructionSet::Baseline => {}
                InstructionSet::Fused => {
                    compare::<Fused<f64, Fma>>();
                    compare::<Fused<f32, Fma>>();
                    compare::<Lanes<Fused<f64, Fma>, 8>>();
                }
                #[cfg(target_arch = "x86_64")]
                InstructionSet::Avx512 => {
                    compare::<Fused<f64, crate::scalar::fma::Avx512>>();
                    compare::<Fused<f32, crate::scalar::fma::Avx512>>();
                }
                #[cfg(not(target_arch = "x86_64"))]
                InstructionSet::Avx512 => {}
            }
        }
    }

    #[test]
    fn an_empty_loop_reads_nothing() {
        let empty = Loop::<f64, f64, 1, 0, 0, 1> { range: 5..5, parts: [&[]], constants: [], common: [] };
        assert_eq!(empty.run::<Product, _, _, _>(&mut []), [0.0]);
    }
}
