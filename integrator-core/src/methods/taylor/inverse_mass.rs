//! Diagonal inverse masses: positions with `q' = m p`, with a constant `m` for each coordinate.
//!
//! Always true: a coefficient of a position is the one of its momentum of the order below times `m`, divided by the
//! order, so that it is known as soon as that one is.

use super::{
    series::{scaled_by_order, scaled_by_two_orders},
    table::{Coefficients, EIGHT, Layout, Wide, is_narrow},
};
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::aligned::Aligned,
};

/// The inverse mass of each coordinate; empty before the first expansion.
pub struct InverseMass<R: Copy> {
    numbers: Aligned<R>,
}

impl<R: Real> Default for InverseMass<R> {
    fn default() -> Self {
        Self { numbers: Aligned::filled(0, R::of(0.0)) }
    }
}

impl<R: Real> InverseMass<R> {
    /// The inverse masses in an order slice.
    pub fn of(slice: &[R]) -> Self {
        let mut numbers = Aligned::filled(slice.len(), R::of(0.0));
        numbers.copy_from_slice(slice);
        Self { numbers }
    }

    /// Whether there are none yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Computes the coefficients of order 1 of positions.
    #[inline(always)]
    pub fn first_order(&self, q: &mut Coefficients<'_, R>, p: &Coefficients<'_, R>) {
        let unit = q.unit();
        for ((q, p), inverse_mass) in q[1].iter_mut().zip(&p[0]).zip(&*self.numbers) {
            *q = *inverse_mass * *p * unit;
        }
    }

    /// The inverse masses of all coordinates.
    #[inline(always)]
    pub fn of_all(&self, layout: Layout) -> InverseMasses<'_, R> {
        InverseMasses { numbers: &self.numbers[..layout.width()] }
    }

    /// Integrates the sums of momenta of an order, and computes the coefficients of positions of the next one.
    #[inline(always)]
    pub fn next_order(&self, q: &mut Coefficients<'_, R>, p: &mut Coefficients<'_, R>, order: usize) {
        let unit = q.unit();
        let square = unit * unit;
        if const { is_narrow::<R>() } || q.is_few() {
            for ((q, p), inverse_mass) in q[order + 1].iter_mut().zip(&mut p[order]).zip(&*self.numbers) {
                *q = scaled_by_two_orders(*inverse_mass * *p, square, order);
                *p = scaled_by_order(*p, unit, order);
            }
            return;
        }
        let [unit, square] = [unit, square].map(<Wide<R> as Row<R>>::splat);
        let vectors = q[order + 1].chunks_exact_mut(EIGHT).zip(p[order].chunks_exact_mut(EIGHT));
        for ((q, p), inverse_mass) in vectors.zip(self.numbers.chunks_exact(EIGHT)) {
            let sum = <Wide<R> as Row<R>>::read(p);
            scaled_by_order(sum, unit, order).write(p);
            scaled_by_two_orders(<Wide<R> as Row<R>>::read(inverse_mass) * sum, square, order).write(q);
        }
    }
}

/// The inverse masses of all coordinates.
#[derive(Clone, Copy)]
pub struct InverseMasses<'m, R> {
    numbers: &'m [R],
}

impl<R: Real> InverseMasses<'_, R> {
    /// Computes the coefficients of a vector of momenta from their sums, and those of their positions of the next order.
    #[inline(always)]
    pub fn next_order_of(
        &self,
        vector: usize,
        sum: Wide<R>,
        q: &mut Coefficients<'_, R>,
        p: &mut Coefficients<'_, R>,
        order: usize,
    ) {
        let begin = vector * (Wide::<R>::LANES / R::LANES);
        p.integral(sum, order).write(&mut p[order][begin..]);
        let inverse_mass = <Wide<R> as Row<R>>::read(&self.numbers[begin..]);
        q.second_integral(inverse_mass * sum, order).write(&mut q[order + 1][begin..]);
    }
}
