//! One part of a state, with the polynomials that it follows for a while.

use super::{
    method::ORDERS,
    table::{Coefficients, EIGHT, Eight, Layout, Table},
};
use crate::{
    real::{Mask, Real},
    row::Row,
    slot::{Keep, Slot},
};
use alloc::vec::Vec;

/// The coordinates of a part, in the order of the rows of its table.
#[derive(Clone)]
pub(super) struct Part<R: Real, K: Keep> {
    /// The polynomials.
    table: Table<R>,
    /// A few coordinates, one by one.
    few: States<K::Slot<R>>,
    /// More than a few, side by side in registers.
    rows: States<K::Slot<Eight<R>>>,
}

/// Coordinates, with what they carry.
#[derive(Clone)]
struct States<S> {
    /// Where the polynomial begins.
    begin: Vec<S>,
    /// Where the run is.
    shown: Vec<S>,
}

impl<S: Copy> States<S> {
    fn at(begin: Vec<S>) -> Self {
        Self { shown: begin.clone(), begin }
    }
    fn copy(&mut self, from: &Self) {
        self.begin.clone_from(&from.begin);
        self.shown.clone_from(&from.shown);
    }

    /// Follows the polynomials from the beginning: `Σ cₖ tᵏ`. The higher orders are four polynomials in `t⁴`, whose sums
    /// do not wait for each other; the lowest come in one after the other (Horner), with one rounding each, since theirs
    /// are the roundings that count.
    #[inline(always)]
    fn follow<R: Real, W: Row<R>>(&mut self, table: &Coefficients<'_, R>, order: usize, t: R, to: To<R>)
    where
        S: Slot<W>,
    {
        let t = W::splat(t);
        let square = t * t;
        let fourth = square * square;
        for (row, begin) in self.begin.iter_mut().enumerate() {
            let place = row * (W::LANES / R::LANES);
            let coefficient = |k: usize| &table[k][place..];
            let mut sums = [W::of(0.0); 4];
            let (tail, rest) = ((order - LOWEST) / 4, (order - LOWEST) % 4);
            for (k, sum) in sums.iter_mut().enumerate().take(rest) {
                *sum = W::read(coefficient(order - rest + 1 + k));
            }
            for first in (0..tail).rev() {
                for (k, sum) in sums.iter_mut().enumerate() {
                    *sum = Real::fma(*sum, fourth, W::read(coefficient(LOWEST + 4 * first + 1 + k)));
                }
            }
            let [a, b, c, d] = sums;
            let mut sum = Real::fma(Real::fma(d, t, c), square, Real::fma(b, t, a));
            for k in (1..LOWEST + 1).rev() {
                sum = Real::fma(sum, t, W::read(coefficient(k)));
            }
            let mut slot = *begin;
            Slot::fma(&mut slot, t, sum);
            match to {
                To::Begin { .. } if R::MEMBERS == 1 => *begin = slot,
                To::Begin { moves } => *begin = S::select(W::of(0.0).less(W::splat(moves)), slot, *begin),
                To::Shown => self.shown[row] = slot,
            }
        }
    }
}

/// How many orders are summed up one after the other; as many as the lowest order of the method.
const LOWEST: usize = ORDERS[0];

/// How large the first coefficients of a part are, and the last ones.
pub(super) struct Ends<R> {
    value: R,
    slope: R,
    before: R,
    last: R,
}

impl<R: Real> Ends<R> {
    /// Those in a lane.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> [f64; 4] {
        [self.value.lane(lane), self.slope.lane(lane), self.before.lane(lane), self.last.lane(lane)]
    }
}

/// What is to be where a polynomial leads.
#[derive(Clone, Copy)]
pub(super) enum To<R> {
    /// The beginning of the next one, in the lanes in which this is above zero.
    Begin { moves: R },
    /// The state that a run shows.
    Shown,
}

/// The slots of a part, one by one and side by side.
type Slots<R, K> = (Vec<<K as Keep>::Slot<R>>, Vec<<K as Keep>::Slot<Eight<R>>>);

/// The slots of coordinates in this layout.
fn slots<R: Real, K: Keep>(layout: Layout, leaf: impl Fn(usize, usize) -> K) -> Slots<R, K> {
    let (few, rows) = if layout.is_few() { (layout.width(), 0) } else { (0, layout.width() / EIGHT) };
    let few = (0..few).map(|place| K::inward(|lane| leaf(lane, layout.coordinate(place))));
    let rows =
        (0..rows).map(|row| K::inward(|lane| leaf(lane % R::LANES, layout.coordinate(row * EIGHT + lane / R::LANES))));
    (few.collect(), rows.collect())
}

/// The coordinate in a place of such slots.
fn leaf<R: Real, K: Keep>(few: &[K::Slot<R>], rows: &[K::Slot<Eight<R>>], lane: usize, place: usize) -> K {
    match few.get(place) {
        Some(slot) => K::outward(*slot, lane),
        None => K::outward(rows[place / EIGHT], place % EIGHT * R::LANES + lane),
    }
}

impl<R: Real, K: Keep> Part<R, K> {
    /// The coordinates of each lane.
    pub(super) fn at(layout: Layout, leaf: impl Fn(usize, usize) -> K) -> Self {
        let (few, rows) = slots(layout, leaf);
        Self { table: Table::new(layout), few: States::at(few), rows: States::at(rows) }
    }

    /// The coordinates of each lane, from lanes of others of the same layout. Their polynomials have to be found again.
    pub(super) fn gathered<'p>(layout: Layout, of_lane: impl Fn(usize) -> (&'p Self, usize)) -> Self {
        let begin = slots(layout, |lane, coordinate| {
            let (part, lane) = of_lane(lane);
            leaf::<R, K>(&part.few.begin, &part.rows.begin, lane, layout.place(coordinate))
        });
        let shown = slots(layout, |lane, coordinate| {
            let (part, lane) = of_lane(lane);
            part.leaf(lane, layout.place(coordinate))
        });
        Self {
            table: Table::new(layout),
            few: States { begin: begin.0, shown: shown.0 },
            rows: States { begin: begin.1, shown: shown.1 },
        }
    }

    /// The coefficients, those of order 0 being where the polynomials begin.
    #[inline(always)]
    pub(super) fn begun(&mut self, layout: Layout) -> Coefficients<'_, R> {
        let mut table = self.table.of(layout);
        for (number, slot) in table[0].iter_mut().zip(&self.few.begin) {
            *number = slot.value();
        }
        for (row, slot) in self.rows.begin.iter().enumerate() {
            slot.value().write(&mut table[0][row * EIGHT..]);
        }
        table
    }

    /// Follows the polynomials for a while.
    #[inline(always)]
    pub(super) fn follow(&mut self, layout: Layout, order: usize, t: R, to: To<R>) {
        let table = self.table.of(layout);
        if layout.is_few() {
            self.few.follow::<R, R>(&table, order, t, to);
        } else {
            self.rows.follow::<R, Eight<R>>(&table, order, t, to);
        }
    }

    /// The largest coefficient of an order in each lane; no number, if one of them is none.
    #[inline(always)]
    pub(super) fn size(&self, layout: Layout, order: usize) -> R {
        let numbers = self.table.order(layout, order);
        if R::MEMBERS == 1 {
            // As integers, sizes are in the same order, behind infinity those that are no numbers.
            let bits = |number: &R| number.lane(0).abs().to_bits();
            let (rows, few) = numbers.as_chunks::<EIGHT>();
            let mut most = [0; EIGHT];
            for row in rows {
                for (most, number) in most.iter_mut().zip(row) {
                    *most = bits(number).max(*most);
                }
            }
            let most = most.into_iter().chain(few.iter().map(bits)).fold(0, u64::max);
            return R::of(f64::from_bits(most));
        }
        let mut most = R::of(0.0);
        for number in numbers {
            let size = number.abs();
            let stays = size.less_or_equal(most).or(most.equal(most).not());
            most = R::select(stays, most, size);
        }
        most
    }

    /// The sizes of the coefficients of the orders that a horizon is found from.
    #[inline(always)]
    pub(super) fn ends(&self, layout: Layout, order: usize) -> Ends<R> {
        Ends {
            value: self.size(layout, 0),
            slope: self.size(layout, 1),
            before: self.size(layout, order - 1),
            last: self.size(layout, order),
        }
    }

    /// The coordinate in a place, as the run shows it.
    pub(super) fn leaf(&self, lane: usize, place: usize) -> K {
        leaf::<R, K>(&self.few.shown, &self.rows.shown, lane, place)
    }

    /// Whether all coordinates are finite.
    pub(super) fn finite(&self) -> bool {
        self.few.shown.iter().all(|slot| slot.value().finite())
            && self.rows.shown.iter().all(|slot| slot.value().finite())
    }

    /// Takes over another one of as many coordinates.
    pub(super) fn copy(&mut self, from: &Self) {
        self.table.clone_from(&from.table);
        self.few.copy(&from.few);
        self.rows.copy(&from.rows);
    }
}
