//! The evaluation of Taylor polynomials.
//!
//! Always true: the value of a polynomial follows from its coefficients alone, in an order of its own, so that bits do
//! not depend on how many coordinates are evaluated together.

use super::table::Layout;
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::precision::Slot,
};
use alloc::vec::Vec;

/// The number of lowest orders that are summed one after the other. With the order for a tolerance near the rounding,
/// terms fall by a factor of four from one to the next, and the roundings of all higher ones count a fifteenth of those
/// of the last two sums.
const LOWEST: usize = 2;

/// The state that the value of a polynomial becomes.
#[derive(Clone, Copy)]
pub(super) enum To<R> {
    /// The origin of the next polynomial, in the lanes in which this is above zero.
    Origin { lanes: R },
    /// The current state of the run.
    Current,
}

/// States of coordinates, with the roundings that they carry.
#[derive(Clone)]
pub(super) struct States<S> {
    /// The states at the origin of the polynomial.
    pub(super) origin: Vec<S>,
    /// The current states of the run.
    pub(super) current: Vec<S>,
}

impl<S: Copy> States<S> {
    /// States at the origin.
    pub(super) fn at(origin: Vec<S>) -> Self {
        Self { current: origin.clone(), origin }
    }
    /// Copies other states, of as many coordinates.
    pub(super) fn copy(&mut self, from: &Self) {
        self.origin.clone_from(&from.origin);
        self.current.clone_from(&from.current);
    }

    /// Evaluates the polynomials of a table at `t` from the origin, `Σ cₖ tᵏ`, and stores the next origin in the table.
    /// The higher orders are summed by fours that do not wait for each other (Estrin); the lowest one after the other
    /// (Horner), with one rounding each, since theirs are the roundings that matter. `BATCH` numbers or vectors are
    /// evaluated together.
    #[inline(always)]
    pub(super) fn evaluate<R: Real, W: Row<R>, const BATCH: usize>(
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
            let batch = BATCH.min(count - first);
            let indices = first * step..(first + batch) * step;
            let mut sums = [W::of(0.0); BATCH];
            macro_rules! add_order {
                ($k:expr) => {
                    let numbers = &table[$k * width..][indices.clone()];
                    for (i, sum) in sums[..batch].iter_mut().enumerate() {
                        *sum = Real::fma(*sum, t, W::read(&numbers[i * step..]));
                    }
                };
            }
            for k in (order - rest + 1..order + 1).rev() {
                add_order!(k);
            }
            for four in (0..fours).rev() {
                let numbers = &table[(LOWEST + 1 + 4 * four) * width..][..4 * width];
                for (i, sum) in sums[..batch].iter_mut().enumerate() {
                    let numbers = &numbers[(first + i) * step..];
                    let low = Real::fma(W::read(&numbers[width..]), t, W::read(numbers));
                    let high = Real::fma(W::read(&numbers[3 * width..]), t, W::read(&numbers[2 * width..]));
                    *sum = Real::fma(*sum, fourth, Real::fma(high, square, low));
                }
            }
            for k in (1..LOWEST + 1).rev() {
                add_order!(k);
            }
            let origins = &mut self.origin[first..][..batch];
            match to {
                To::Origin { lanes } => {
                    let values = &mut table[indices];
                    for (i, sum) in sums[..batch].iter_mut().enumerate() {
                        let mut slot = origins[i];
                        Slot::fma(&mut slot, t, *sum);
                        if R::MEMBERS > 1 {
                            slot = S::select(W::of(0.0).less(W::splat(lanes)), slot, origins[i]);
                        }
                        origins[i] = slot;
                        slot.value().write(&mut values[i * step..]);
                    }
                }
                To::Current => {
                    let current = &mut self.current[first..][..batch];
                    for (i, sum) in sums[..batch].iter_mut().enumerate() {
                        current[i] = origins[i];
                        Slot::fma(&mut current[i], t, *sum);
                    }
                }
            }
            first += BATCH;
        }
    }
}
