//! The field on both sides of an edge, for motions with deviation vectors.
//!
//! Where the field is continuous, the derivative of a motion across an edge is the product of those on both sides. Where
//! it jumps, neighbours cross the edge at other times, and the product lacks what they gain there.

use super::{expansion::Expansion, half::Half, table::Layout};
use crate::{
    error::Unsolved,
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    system::motion::Prepared,
};
use core::mem::take;

/// The rate of each coordinate at a duration from the origin, in units of time, and the size of the terms of its half.
fn rates<R: Real, C: Coords>(
    half: &Half<R, C>,
    layout: Layout,
    order: usize,
    [duration, unit]: [f64; 2],
) -> impl Iterator<Item = [f64; 2]> {
    let (mut size, count) = (0.0, layout.coordinates());
    let of = move |k: usize, coordinate: usize| half.coefficient(layout, k, layout.index_of(coordinate), 0);
    let power = move |k: usize| if duration.is_finite() { Real::powf(duration, k as f64 - 1.0) } else { 0.0 };
    for k in 0..=order {
        let power = if k == 1 { 1.0 } else { power(k) };
        for coordinate in 0..count {
            size = f64::max(size, Real::abs(of(k, coordinate) * power));
        }
    }
    let rate = move |coordinate| (1..=order).rev().fold(0.0, |sum, k| sum * duration + k as f64 * of(k, coordinate));
    (0..count).map(move |coordinate| [rate(coordinate), size].map(|number| number / unit))
}

impl<R: Real, C: Coords, P: Prepared<R>, T> Expansion<R, C, P, T> {
    /// Keeps the rates at the end of a step at an edge, if there are deviation vectors.
    pub(super) fn keep_rates(&mut self, layout: Layout, duration: f64, unit: f64) {
        let ends_at_edge = take(&mut self.segments[0].ends_at_edge);
        if const { R::MEMBERS == 1 && R::LANES > 1 } && ends_at_edge {
            let order = self.method.order();
            self.rates = rates(&self.q, layout, order, [duration, unit])
                .chain(rates(&self.p, layout, order, [duration, unit]))
                .collect();
        }
    }

    /// Compares the rates on both sides of an edge where the motion has crossed one.
    pub(super) fn compare_rates(&mut self, layout: Layout, [t0, h]: [f64; 2]) {
        if const { !(R::MEMBERS == 1 && R::LANES > 1) } || self.rates.is_empty() {
            return;
        }
        let order = self.method.order();
        let unit = self.segments[0].unit::<R>(h);
        let step = self.segments[0].step.unwrap_or(0.0) / unit;
        let here = [&self.q, &self.p].into_iter().flat_map(|half| {
            let at_origin = rates(half, layout, order, [0.0, unit]).map(|[rate, _]| rate);
            at_origin.zip(rates(half, layout, order, [step, unit]).map(|[_, size]| size))
        });
        let least = Real::sqrt(C::Leaf::EPSILON);
        let jumps = take(&mut self.rates).into_iter().zip(here).any(|([before, size_before], (after, size_after))| {
            Real::abs(after - before) > least * f64::max(size_before, size_after)
        });
        if jumps {
            let time = t0 + self.segments[0].origin.nearest();
            self.segments[0].unsolved = Some(Unsolved::Jump { time });
        }
    }
}
