//! One half of a state, positions or momenta, with its Taylor polynomials.

use super::{
    states::{States, To},
    step_size::Norms,
    table::{Coefficients, EIGHT, FEW, Layout, Table, Wide, are_always_few, is_narrow},
};
use crate::{
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
};
use alloc::vec::Vec;

/// The positions or the momenta, in the order of the order slices of their table.
#[derive(Clone)]
pub(super) struct Half<R: Real, C: Coords> {
    /// The polynomials.
    table: Table<R>,
    /// The states of coordinates one by one, where they are few or numbers have lanes already.
    few: States<<C::Leaf as Precision>::Slot<R>>,
    /// The states of coordinates in vectors of eight, otherwise.
    vectors: States<<C::Leaf as Precision>::Slot<Wide<R>>>,
}

/// The norms of a group of coordinates in each lane.
#[derive(Clone, Copy)]
pub(super) struct LaneNorms<R>([R; 4]);

impl<R: Real> LaneNorms<R> {
    /// The norms of coordinates that are zero.
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self([R::of(0.0); 4])
    }

    /// The norms in a lane.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> Norms {
        // A loop: a closure would be compiled outside of the variant, and its vectors be passed through memory.
        let mut norms = [0.0; 4];
        for (norm, all) in norms.iter_mut().zip(&self.0) {
            *norm = all.lane(lane);
        }
        norms
    }
}

/// The maximum norm of numbers in each lane of vectors; NaN if one of them is NaN.
#[inline(always)]
fn max_norm<R: Real, W: Row<R>>(numbers: &[R]) -> W {
    let mut vectors = numbers.chunks_exact(W::LANES / R::LANES);
    let Some(first) = vectors.next() else { return W::of(0.0) };
    let mut most = W::read(first).abs();
    for numbers in vectors {
        let magnitude = W::read(numbers).abs();
        let stays = magnitude.less_or_equal(most).or(most.equal(most).not());
        most = W::select(stays, most, magnitude);
    }
    most
}

/// The slots of a half: of coordinates one by one, and of vectors.
type Slots<R, K> = (Vec<<K as Precision>::Slot<R>>, Vec<<K as Precision>::Slot<Wide<R>>>);

/// Whether all coordinates of a type are computed one by one, so that nothing else is compiled.
const fn are_single<R: Real, C: Coords>() -> bool {
    is_narrow::<R>() || are_always_few::<C>()
}

/// The slots of coordinates in this layout.
fn slots<R: Real, C: Coords>(layout: Layout, leaf: &dyn Fn(usize, usize) -> C::Leaf) -> Slots<R, C::Leaf> {
    let (mut few, mut vectors) = (Vec::new(), Vec::new());
    if const { are_single::<R, C>() } || layout.is_few() {
        for index in 0..layout.width() {
            few.push(C::Leaf::pack(&|lane| leaf(lane, layout.coordinate(index))));
        }
    } else {
        for begin in (0..layout.width()).step_by(EIGHT) {
            vectors.push(C::Leaf::pack(&|lane| leaf(lane % R::LANES, layout.coordinate(begin + lane / R::LANES))));
        }
    }
    (few, vectors)
}

/// A table of polynomials whose coefficients of order 0 are in storage.
fn table_from<R: Real, K: Precision>(layout: Layout, (few, vectors): &Slots<R, K>) -> Table<R> {
    let mut table = Table::new(layout);
    let numbers = table.numbers_mut(layout);
    for (index, slot) in few.iter().enumerate() {
        numbers[index] = slot.value();
    }
    for (vector, slot) in vectors.iter().enumerate() {
        slot.value().write(&mut numbers[vector * EIGHT..]);
    }
    table
}

/// The coordinate at an index of the storage.
fn leaf<R: Real, K: Precision>(few: &[K::Slot<R>], vectors: &[K::Slot<Wide<R>>], lane: usize, index: usize) -> K {
    match few.get(index) {
        Some(slot) => K::unpack(*slot, lane),
        None => K::unpack(vectors[index / EIGHT], index % EIGHT * R::LANES + lane),
    }
}

impl<R: Real, C: Coords> Half<R, C> {
    /// The coordinates of all lanes.
    pub(super) fn at(layout: Layout, leaf: &dyn Fn(usize, usize) -> C::Leaf) -> Self {
        let origin = slots::<R, C>(layout, leaf);
        Self {
            table: table_from::<R, C::Leaf>(layout, &origin),
            few: States::at(origin.0),
            vectors: States::at(origin.1),
        }
    }

    /// The coordinates of all lanes, from lanes of other halves of the same layout. Their polynomials have to be
    /// expanded again.
    pub(super) fn gathered<'h>(layout: Layout, of_lane: impl Fn(usize) -> (&'h Self, usize)) -> Self {
        let origin = slots::<R, C>(layout, &|lane, coordinate| {
            let (half, lane) = of_lane(lane);
            leaf::<R, C::Leaf>(&half.few.origin, &half.vectors.origin, lane, layout.index_of(coordinate))
        });
        let current = slots::<R, C>(layout, &|lane, coordinate| {
            let (half, lane) = of_lane(lane);
            half.leaf(lane, layout.index_of(coordinate))
        });
        Self {
            table: table_from::<R, C::Leaf>(layout, &origin),
            few: States { origin: origin.0, current: current.0 },
            vectors: States { origin: origin.1, current: current.1 },
        }
    }

    /// The coefficients in a unit of time; those of order 0 are the state at the origin.
    #[inline(always)]
    pub(super) fn coefficients(&mut self, layout: Layout, unit: R) -> Coefficients<'_, R> {
        self.table.of(layout, unit)
    }

    /// Evaluates the polynomials at `t` from the origin, in the unit of time.
    #[inline(always)]
    pub(super) fn evaluate(&mut self, layout: Layout, order: usize, t: R, to: To<R>) {
        let table = self.table.numbers_mut(layout);
        if const { are_single::<R, C>() } || layout.is_few() {
            self.few.evaluate::<R, R, FEW>(table, layout, order, t, to);
        } else {
            self.vectors.evaluate::<R, Wide<R>, 1>(table, layout, order, t, to);
        }
    }

    /// The number of groups of coordinates that have a scale in common: each of a few, which may have a unit of its own,
    /// and all of many.
    #[inline(always)]
    pub(super) fn groups(layout: Layout) -> usize {
        if layout.is_few() { layout.width() } else { 1 }
    }

    /// The maximum norm of the coefficients of an order of a group in each lane; NaN if one of them is NaN.
    #[inline(always)]
    pub(super) fn norm(&self, layout: Layout, group: usize, order: usize) -> R {
        let numbers = self.table.order(layout, order);
        if layout.is_few() {
            return numbers[group].abs();
        }
        if R::MEMBERS > 1 {
            return max_norm::<R, R>(numbers);
        }
        // As integers, magnitudes have the same order, with NaN above infinity.
        let most = if const { are_single::<R, C>() } {
            numbers.iter().map(|number| number.lane(0).abs().to_bits() as i64).fold(0, i64::max)
        } else {
            let most = max_norm::<R, Wide<R>>(numbers);
            let mut norms = [0; EIGHT];
            for (index, norm) in norms.iter_mut().enumerate() {
                *norm = most.lane(index * R::LANES).to_bits() as i64;
            }
            let mut most = norms;
            for half in [4, 2, 1] {
                for index in 0..half {
                    most[index] = most[index].max(most[index + half]);
                }
            }
            most[0]
        };
        R::of(f64::from_bits(most as u64))
    }

    /// The norms of the orders that determine the step size.
    #[inline(always)]
    pub(super) fn norms(&self, layout: Layout, group: usize, order: usize) -> LaneNorms<R> {
        let mut norms = [R::of(0.0); 4];
        for (norm, order) in norms.iter_mut().zip([0, 1, order - 1, order]) {
            *norm = self.norm(layout, group, order);
        }
        LaneNorms(norms)
    }

    /// Removes all coefficients above the first order in the lanes that are not in `keeps`.
    pub(super) fn cut(&mut self, layout: Layout, keeps: R::Mask) {
        for number in &mut self.table.numbers_mut(layout)[2 * layout.width()..] {
            *number = R::select(keeps, *number, R::of(0.0));
        }
    }

    /// The current coordinate at an index.
    pub(super) fn leaf(&self, lane: usize, index: usize) -> C::Leaf {
        leaf::<R, C::Leaf>(&self.few.current, &self.vectors.current, lane, index)
    }

    /// A coefficient of the coordinate at an index, in a lane.
    pub(super) fn coefficient(&self, layout: Layout, order: usize, index: usize, lane: usize) -> f64 {
        self.table.order(layout, order)[index].lane(lane)
    }

    /// Whether all coordinates are finite.
    pub(super) fn finite(&self) -> bool {
        self.few.current.iter().all(|slot| slot.value().finite())
            && self.vectors.current.iter().all(|slot| slot.value().finite())
    }

    /// Copies another half of as many coordinates.
    pub(super) fn copy(&mut self, from: &Self) {
        self.table.clone_from(&from.table);
        self.few.copy(&from.few);
        self.vectors.copy(&from.vectors);
    }
}
