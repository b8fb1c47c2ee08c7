//! Positions that merely follow momenta: `q' = m p`, with a number `m` for each coordinate.
//!
//! Always true: a coefficient of a position is the one of its momentum of the order below times `m`, divided by the order,
//! so that it is known as soon as that one is.

use super::{
    series::over,
    table::{Coefficients, EIGHT, Wide, is_narrow},
};
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::aligned::Aligned,
};

/// What each position multiplies its momentum by; nothing, before it is found.
pub struct Mobility<R: Copy> {
    numbers: Aligned<R>,
}

impl<R: Real> Default for Mobility<R> {
    fn default() -> Self {
        Self { numbers: Aligned::new(0, &|_| R::of(0.0)) }
    }
}

impl<R: Real> Mobility<R> {
    /// The mobilities of a row of coordinates.
    pub fn of(row: &[R]) -> Self {
        Self { numbers: Aligned::new(row.len(), &|place| row[place]) }
    }

    /// Whether nothing has been found.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Finds the coefficients of order 1 of positions.
    #[inline(always)]
    pub fn begin(&self, q: &mut Coefficients<'_, R>, p: &Coefficients<'_, R>) {
        for ((q, p), mobility) in q[1].iter_mut().zip(&p[0]).zip(&*self.numbers) {
            *q = *mobility * *p;
        }
    }

    /// Divides what momenta have got by their order, and finds the coefficients of positions of the next one.
    #[inline(always)]
    pub fn follow(&self, q: &mut Coefficients<'_, R>, p: &mut Coefficients<'_, R>, order: usize) {
        if const { is_narrow::<R>() } || q.is_few() {
            for ((q, p), mobility) in q[order + 1].iter_mut().zip(&mut p[order]).zip(&*self.numbers) {
                *p = over(*p, order);
                *q = over(*mobility * *p, order + 1);
            }
            return;
        }
        let rows = q[order + 1].chunks_exact_mut(EIGHT).zip(p[order].chunks_exact_mut(EIGHT));
        for ((q, p), mobility) in rows.zip(self.numbers.chunks_exact(EIGHT)) {
            let momentum = over(<Wide<R> as Row<R>>::read(p), order);
            momentum.write(p);
            over(<Wide<R> as Row<R>>::read(mobility) * momentum, order + 1).write(q);
        }
    }
}
