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

impl<R: Real, S: Slot<R>> Loop<'_, R, S, 1, 1, 0, 1> {
    /// Returns the sum of products of constants and coordinates. The index of a coordinate is that of its constant plus `offset`.
    #[inline(always)]
    pub fn inner_product(self, offset: isize) -> R {
        let (from, count) = (self.range.start, self.range.len());
        if count == 0 {
            return R::of(0.0);
        }
        let mut constants = &self.constants[0][from..][..count];
        let mut coordinates = &self.parts[0].as_flattened()[from.wrapping_add_signed(offset)..][..count];
        // The places of partial sums are constants, which lets these stay in registers.
        let mut partial = [R::of(0.0); PARTIAL];
        while constants.len() >= PARTIAL && coordinates.len() >= PARTIAL {
            add_round::<R, S, PARTIAL>(constants, coordinates, &mut partial);
            (constants, coordinates) = (&constants[PARTIAL..], &coordinates[PARTIAL..]);
        }
        if constants.len() >= GROUP && coordinates.len() >= GROUP {
            add_round::<R, S, GROUP>(constants, coordinates, &mut partial);
            (constants, coordinates) = (&constants[GROUP..], &coordinates[GROUP..]);
        }
        let (mut rest, mut next) = (R::of(0.0), 0);
        while next < constants.len() && next < coordinates.len() {
            rest = constants[next].scale_add(coordinates[next].value(), rest);
            next += 1;
        }
        if count >= GROUP { total::<R, R::Block>(partial) + rest } else { rest }
    }
}

/// Adds the first `COUNT` products to as many partial sums.
#[inline(always)]
fn add_round<R: Real, S: Slot<R>, const COUNT: usize>(constants: &[R], coordinates: &[S], partial: &mut [R; PARTIAL]) {
    let mut place = 0;
    while place + R::Block::WIDTH <= COUNT {
        add::<R, R::Block>(&constants[place..], S::read(&coordinates[place..]), &mut partial[place..]);
        place += R::Block::WIDTH;
    }
    while place < COUNT {
        add::<R, R>(&constants[place..], coordinates[place].value(), &mut partial[place..]);
        place += 1;
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
        let mut constants = &self.constants[0][from..][..count];
        let mut gradient = &mut gradient.as_flattened_mut()[from.wrapping_add_signed(offset)..][..count];
        let factor = R::Block::splat(self.common[0]);
        while constants.len() >= R::Block::WIDTH && gradient.len() >= R::Block::WIDTH {
            add(constants, factor, gradient);
            (constants, gradient) = (&constants[R::Block::WIDTH..], &mut gradient[R::Block::WIDTH..]);
        }
        let mut next = 0;
        while next < constants.len() && next < gradient.len() {
            gradient[next] = constants[next].scale_add(self.common[0], gradient[next]);
            next += 1;
        }
    }
}
