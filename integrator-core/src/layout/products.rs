//! Loops in lanes that only multiply: those over the entries of a row of data or of a matrix.
//!
//! In: a loop with one table of constants. Out: an inner product, or a gradient. Always true: the result is bitwise that of
//! [`Loop::run`] with the same iterations. A system has one such function for all of these loops, which takes fewer lines of
//! LLVM IR than iterations of their own.

use super::loops::{GROUP, Loop, PARTIAL, total};
use crate::{
    scalar::{real::Real, simd::block::Block},
    state::precision::Slot,
};
use core::ops::Range;

/// The number of rows whose products are added up together: their partial sums are in registers.
const SUMMED: usize = 4;

/// The number of blocks of a gradient that are in registers while rows are added. Each sum waits for the one before, and blocks do
/// not wait for each other.
const BLOCKS: usize = 8;

/// The number of rows that are added to some blocks before others.
const ADDED: usize = 64;

impl<R: Real, S: Slot<R>> Loop<'_, R, S, 1, 1, 0, 1> {
    /// Returns the sum of products of constants and coordinates. The index of a coordinate is that of its constant plus `offset`.
    #[inline(always)]
    pub fn inner_product(self, offset: isize) -> R {
        let (from, count) = (self.range.start, self.range.len());
        if count == 0 {
            return R::of(0.0);
        }
        let coordinates = &self.parts[0].as_flattened()[from.wrapping_add_signed(offset)..][..count];
        products_of([&self.constants[0][from..][..count]], coordinates)[0]
    }
}

/// Writes the inner product of each row, which is the same as that of a loop of its own. Rows that are computed together share
/// the reads of coordinates, and none waits for the sums of another.
#[inline(always)]
pub fn inner_products<R: Real, S: Slot<R>, T: AsRef<[R]>>(
    rows: &[T],
    range: Range<usize>,
    offset: isize,
    coordinates: &[[S; 1]],
    products: &mut [R],
) {
    let (from, count) = (range.start, range.len());
    if count == 0 {
        return;
    }
    let coordinates = &coordinates.as_flattened()[from.wrapping_add_signed(offset)..][..count];
    let rows = &rows[..products.len()];
    let mut row = 0;
    while row + SUMMED <= products.len() {
        let mut several: [&[R]; SUMMED] = [&[]; SUMMED];
        let mut number = 0;
        while number < SUMMED {
            several[number] = &rows[row + number].as_ref()[from..][..count];
            number += 1;
        }
        products[row..row + SUMMED].copy_from_slice(&products_of(several, coordinates));
        row += SUMMED;
    }
    while row < products.len() {
        products[row] = products_of([&rows[row].as_ref()[from..][..count]], coordinates)[0];
        row += 1;
    }
}

/// The inner products of rows with one coordinate at least, and as many numbers in each row.
#[inline(always)]
fn products_of<R: Real, S: Slot<R>, const ROWS: usize>(rows: [&[R]; ROWS], coordinates: &[S]) -> [R; ROWS] {
    let (count, mut next) = (coordinates.len(), 0);
    // The places of partial sums are constants, which lets these stay in registers.
    let mut partial = [[R::of(0.0); PARTIAL]; ROWS];
    while count - next >= PARTIAL {
        add_round::<R, S, PARTIAL, ROWS>(rows, coordinates, next, &mut partial);
        next += PARTIAL;
    }
    if count - next >= GROUP {
        add_round::<R, S, GROUP, ROWS>(rows, coordinates, next, &mut partial);
        next += GROUP;
    }
    let mut rest = [R::of(0.0); ROWS];
    while next < count {
        let coordinate = coordinates[next].value();
        let mut row = 0;
        while row < ROWS {
            rest[row] = rows[row][next].scale_add(coordinate, rest[row]);
            row += 1;
        }
        next += 1;
    }
    if count >= GROUP {
        let mut row = 0;
        while row < ROWS {
            rest[row] = total::<R, R::Block>(partial[row]) + rest[row];
            row += 1;
        }
    }
    rest
}

/// Adds the products from an index on to `COUNT` partial sums of each row.
#[inline(always)]
fn add_round<R: Real, S: Slot<R>, const COUNT: usize, const ROWS: usize>(
    rows: [&[R]; ROWS],
    coordinates: &[S],
    from: usize,
    partial: &mut [[R; PARTIAL]; ROWS],
) {
    let coordinates = &coordinates[from..from + COUNT];
    let mut row = 0;
    while row < ROWS {
        let constants = &rows[row][from..from + COUNT];
        let mut place = 0;
        while place + R::Block::WIDTH <= COUNT {
            add::<R, R::Block>(&constants[place..], S::read(&coordinates[place..]), &mut partial[row][place..]);
            place += R::Block::WIDTH;
        }
        while place < COUNT {
            add::<R, R>(&constants[place..], coordinates[place].value(), &mut partial[row][place..]);
            place += 1;
        }
        row += 1;
    }
}

/// Adds the products of the first constants and other numbers to the first ones of a list.
#[inline(always)]
fn add<R: Real, W: Block<R>>(constants: &[R], others: W, to: &mut [R]) {
    W::read(constants).scale_add(others, W::read(to)).write(to);
}

impl<R: Real, S: Slot<R>> Loop<'_, R, S, 1, 1, 1, 1> {
    /// Adds the constants, times the number that all iterations share, to a gradient. The index of a component is that of its
    /// constant plus `offset`.
    #[inline(always)]
    pub fn add_multiples(self, offset: isize, gradient: &mut [[R; 1]]) {
        let (from, count) = (self.range.start, self.range.len());
        if count == 0 {
            return;
        }
        let gradient = &mut gradient.as_flattened_mut()[from.wrapping_add_signed(offset)..][..count];
        add_rows(&self.constants, from, &self.common, gradient);
    }
}

/// Adds the constants of each row, times its own factor, to a gradient: one row after the other. The gradient is read and
/// written once for several rows.
#[inline(always)]
pub fn add_multiples_of_rows<R: Real, T: AsRef<[R]>>(
    rows: &[T],
    range: Range<usize>,
    offset: isize,
    factors: &[R],
    gradient: &mut [[R; 1]],
) {
    let (from, count) = (range.start, range.len());
    if count == 0 {
        return;
    }
    let gradient = &mut gradient.as_flattened_mut()[from.wrapping_add_signed(offset)..][..count];
    for (rows, factors) in rows[..factors.len()].chunks(ADDED).zip(factors.chunks(ADDED)) {
        add_rows(rows, from, factors, gradient);
    }
}

/// Adds multiples of rows to as many components of a gradient. Rows are read from an index on.
#[inline(always)]
fn add_rows<R: Real, T: AsRef<[R]>>(rows: &[T], from: usize, factors: &[R], gradient: &mut [R]) {
    let mut next = 0;
    while gradient.len() - next >= R::Block::WIDTH {
        let count = (gradient.len() - next).min(BLOCKS * R::Block::WIDTH);
        add_blocks::<R, R::Block, T>(rows, from + next, factors, &mut gradient[next..next + count]);
        next += count;
    }
    while next < gradient.len() {
        let count = (gradient.len() - next).min(BLOCKS);
        add_blocks::<R, R, T>(rows, from + next, factors, &mut gradient[next..next + count]);
        next += count;
    }
}

/// The same for one block at least, and `BLOCKS` at most. If there are fewer, the last ones overlap, and compute the same numbers.
#[inline(always)]
fn add_blocks<R: Real, W: Block<R>, T: AsRef<[R]>>(rows: &[T], from: usize, factors: &[R], gradient: &mut [R]) {
    let last = gradient.len() - W::WIDTH;
    let (mut places, mut sums) = ([0; BLOCKS], [W::of(0.0); BLOCKS]);
    let mut block = 0;
    while block < BLOCKS {
        places[block] = (block * W::WIDTH).min(last);
        sums[block] = W::read(&gradient[places[block]..]);
        block += 1;
    }
    let mut row = 0;
    while row < rows.len() && row < factors.len() {
        let (constants, factor) = (&rows[row].as_ref()[from..][..gradient.len()], W::splat(factors[row]));
        block = 0;
        while block < BLOCKS {
            sums[block] = W::read(&constants[places[block]..]).scale_add(factor, sums[block]);
            block += 1;
        }
        row += 1;
    }
    block = 0;
    while block < BLOCKS {
        sums[block].write(&mut gradient[places[block]..]);
        block += 1;
    }
}
