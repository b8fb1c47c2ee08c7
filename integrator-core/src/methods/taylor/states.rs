//! Coordinates that follow polynomials for a while.
//!
//! Always true: where a polynomial leads is found from its coefficients alone, in an order of its own, so that bits do not
//! depend on how many coordinates take their turns together.

use super::table::Layout;
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::precision::Slot,
};
use alloc::vec::Vec;

/// How many of the lowest orders are summed up one after the other. With the order that a tolerance asks for, terms fall by
/// a factor of e² from one to the next, and the roundings of all higher ones count a fiftieth of those of the last two sums.
const LOWEST: usize = 2;

/// What is to be where a polynomial leads.
#[derive(Clone, Copy)]
pub(super) enum To<R> {
    /// The beginning of the next one, in the lanes in which this is above zero.
    Begin { moves: R },
    /// The state that a run shows.
    Shown,
}

/// Coordinates, with what they carry.
#[derive(Clone)]
pub(super) struct States<S> {
    /// Where the polynomial begins.
    pub(super) begin: Vec<S>,
    /// Where the run is.
    pub(super) shown: Vec<S>,
}

impl<S: Copy> States<S> {
    /// At the beginning.
    pub(super) fn at(begin: Vec<S>) -> Self {
        Self { shown: begin.clone(), begin }
    }
    /// Takes over others, as many.
    pub(super) fn copy(&mut self, from: &Self) {
        self.begin.clone_from(&from.begin);
        self.shown.clone_from(&from.shown);
    }

    /// Follows the polynomials of a table from the beginning, `Σ cₖ tᵏ`, and tells it the next one. The higher orders come
    /// in by fours that do not wait for each other; the lowest one after the other (Horner), with one rounding each, since
    /// theirs are the roundings that count. So many numbers or rows take their turns together.
    #[inline(always)]
    pub(super) fn follow<R: Real, W: Row<R>, const ABREAST: usize>(
        &mut self,
        table: &mut [R],
        layout: Layout,
        order: usize,
        t: R,
        to: To<R>,
    ) where
        S: Slot<W>,
    {
        let t = W::splat(t);
        let square = t * t;
        let fourth = square * square;
        let (fours, rest) = ((order - LOWEST) / 4, (order - LOWEST) % 4);
        let (width, step) = (layout.width(), W::LANES / R::LANES);
        let count = width / step;
        let mut first = 0;
        while first < count {
            let abreast = ABREAST.min(count - first);
            let places = first * step..(first + abreast) * step;
            let mut sums = [W::of(0.0); ABREAST];
            macro_rules! add_order {
                ($k:expr) => {
                    let numbers = &table[$k * width..][places.clone()];
                    for (i, sum) in sums[..abreast].iter_mut().enumerate() {
                        *sum = Real::fma(*sum, t, W::read(&numbers[i * step..]));
                    }
                };
            }
            for k in (order - rest + 1..order + 1).rev() {
                add_order!(k);
            }
            for four in (0..fours).rev() {
                let numbers = &table[(LOWEST + 1 + 4 * four) * width..][..4 * width];
                for (i, sum) in sums[..abreast].iter_mut().enumerate() {
                    let numbers = &numbers[(first + i) * step..];
                    let low = Real::fma(W::read(&numbers[width..]), t, W::read(numbers));
                    let high = Real::fma(W::read(&numbers[3 * width..]), t, W::read(&numbers[2 * width..]));
                    *sum = Real::fma(*sum, fourth, Real::fma(high, square, low));
                }
            }
            for k in (1..LOWEST + 1).rev() {
                add_order!(k);
            }
            let begins = &mut self.begin[first..][..abreast];
            match to {
                To::Begin { moves } => {
                    let values = &mut table[places];
                    for (i, sum) in sums[..abreast].iter_mut().enumerate() {
                        let mut slot = begins[i];
                        Slot::fma(&mut slot, t, *sum);
                        if R::MEMBERS > 1 {
                            slot = S::select(W::of(0.0).less(W::splat(moves)), slot, begins[i]);
                        }
                        begins[i] = slot;
                        slot.value().write(&mut values[i * step..]);
                    }
                }
                To::Shown => {
                    let shown = &mut self.shown[first..][..abreast];
                    for (i, sum) in sums[..abreast].iter_mut().enumerate() {
                        shown[i] = begins[i];
                        Slot::fma(&mut shown[i], t, *sum);
                    }
                }
            }
            first += ABREAST;
        }
    }
}
