//! One part of a state, with the polynomials that it follows for a while.

use super::{
    horizon::Sizes,
    states::{States, To},
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

/// The coordinates of a part, in the order of the rows of its table.
#[derive(Clone)]
pub(super) struct Part<R: Real, C: Coords> {
    /// The polynomials.
    table: Table<R>,
    /// Coordinates one by one, a few, or all where nothing else is computed on,
    few: States<<C::Leaf as Precision>::Slot<R>>,
    /// or side by side in registers.
    rows: States<<C::Leaf as Precision>::Slot<Wide<R>>>,
}

/// How large the first two coefficients of a part are, and the last two.
pub(super) struct Ends<R>([R; 4]);

impl<R: Real> Ends<R> {
    /// Those in a lane.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> Sizes {
        // A loop: a closure would be compiled outside of the clone, and its vectors be passed through memory.
        let mut sizes = [0.0; 4];
        for (size, all) in sizes.iter_mut().zip(&self.0) {
            *size = all.lane(lane);
        }
        sizes
    }
}

/// The largest size in each lane of numbers or rows; no number, if one of them is none.
#[inline(always)]
fn largest<R: Real, W: Row<R>>(numbers: &[R]) -> W {
    let mut rows = numbers.chunks_exact(W::LANES / R::LANES);
    let Some(first) = rows.next() else { return W::of(0.0) };
    let mut most = W::read(first).abs();
    for numbers in rows {
        let size = W::read(numbers).abs();
        let stays = size.less_or_equal(most).or(most.equal(most).not());
        most = W::select(stays, most, size);
    }
    most
}

/// The slots of a part, one by one and side by side.
type Slots<R, K> = (Vec<<K as Precision>::Slot<R>>, Vec<<K as Precision>::Slot<Wide<R>>>);

/// Whether all coordinates of a type are computed on one by one, so that nothing else is compiled.
const fn are_single<R: Real, C: Coords>() -> bool {
    is_narrow::<R>() || are_always_few::<C>()
}

/// The slots of coordinates in this layout.
fn slots<R: Real, C: Coords>(layout: Layout, leaf: &dyn Fn(usize, usize) -> C::Leaf) -> Slots<R, C::Leaf> {
    let (mut few, mut rows) = (Vec::new(), Vec::new());
    if const { are_single::<R, C>() } || layout.is_few() {
        for place in 0..layout.width() {
            few.push(C::Leaf::pack(&|lane| leaf(lane, layout.coordinate(place))));
        }
    } else {
        for begin in (0..layout.width()).step_by(EIGHT) {
            rows.push(C::Leaf::pack(&|lane| leaf(lane % R::LANES, layout.coordinate(begin + lane / R::LANES))));
        }
    }
    (few, rows)
}

/// A table of polynomials that begin in such slots.
fn begun<R: Real, K: Precision>(layout: Layout, (few, rows): &Slots<R, K>) -> Table<R> {
    let mut table = Table::new(layout);
    let numbers = table.numbers_mut(layout);
    for (place, slot) in few.iter().enumerate() {
        numbers[place] = slot.value();
    }
    for (row, slot) in rows.iter().enumerate() {
        slot.value().write(&mut numbers[row * EIGHT..]);
    }
    table
}

/// The coordinate in a place of such slots.
fn leaf<R: Real, K: Precision>(few: &[K::Slot<R>], rows: &[K::Slot<Wide<R>>], lane: usize, place: usize) -> K {
    match few.get(place) {
        Some(slot) => K::unpack(*slot, lane),
        None => K::unpack(rows[place / EIGHT], place % EIGHT * R::LANES + lane),
    }
}

impl<R: Real, C: Coords> Part<R, C> {
    /// The coordinates of each lane.
    pub(super) fn at(layout: Layout, leaf: &dyn Fn(usize, usize) -> C::Leaf) -> Self {
        let begin = slots::<R, C>(layout, leaf);
        Self { table: begun::<R, C::Leaf>(layout, &begin), few: States::at(begin.0), rows: States::at(begin.1) }
    }

    /// The coordinates of each lane, from lanes of others of the same layout. Their polynomials have to be found again.
    pub(super) fn gathered<'p>(layout: Layout, of_lane: impl Fn(usize) -> (&'p Self, usize)) -> Self {
        let begin = slots::<R, C>(layout, &|lane, coordinate| {
            let (part, lane) = of_lane(lane);
            leaf::<R, C::Leaf>(&part.few.begin, &part.rows.begin, lane, layout.place_of(coordinate))
        });
        let shown = slots::<R, C>(layout, &|lane, coordinate| {
            let (part, lane) = of_lane(lane);
            part.leaf(lane, layout.place_of(coordinate))
        });
        Self {
            table: begun::<R, C::Leaf>(layout, &begin),
            few: States { begin: begin.0, shown: shown.0 },
            rows: States { begin: begin.1, shown: shown.1 },
        }
    }

    /// The coefficients, those of order 0 being where the polynomials begin.
    #[inline(always)]
    pub(super) fn coefficients(&mut self, layout: Layout) -> Coefficients<'_, R> {
        self.table.of(layout)
    }

    /// Follows the polynomials for a while.
    #[inline(always)]
    pub(super) fn follow(&mut self, layout: Layout, order: usize, t: R, to: To<R>) {
        let table = self.table.numbers_mut(layout);
        if const { are_single::<R, C>() } || layout.is_few() {
            self.few.follow::<R, R, FEW>(table, layout, order, t, to);
        } else {
            self.rows.follow::<R, Wide<R>, 1>(table, layout, order, t, to);
        }
    }

    /// The largest coefficient of an order in each lane; no number, if one of them is none.
    #[inline(always)]
    pub(super) fn size(&self, layout: Layout, order: usize) -> R {
        let numbers = self.table.order(layout, order);
        if R::MEMBERS > 1 {
            return largest::<R, R>(numbers);
        }
        // As integers, sizes are in the same order, behind infinity those that are no numbers.
        let most = if const { are_single::<R, C>() } || layout.is_few() {
            numbers.iter().map(|number| number.lane(0).abs().to_bits() as i64).fold(0, i64::max)
        } else {
            let most = largest::<R, Wide<R>>(numbers);
            let mut sizes = [0; EIGHT];
            for (place, size) in sizes.iter_mut().enumerate() {
                *size = most.lane(place * R::LANES).to_bits() as i64;
            }
            let mut most = sizes;
            for half in [4, 2, 1] {
                for place in 0..half {
                    most[place] = most[place].max(most[place + half]);
                }
            }
            most[0]
        };
        R::of(f64::from_bits(most as u64))
    }

    /// The sizes of the coefficients of the orders that a horizon is found from.
    #[inline(always)]
    pub(super) fn ends(&self, layout: Layout, order: usize) -> Ends<R> {
        let mut sizes = [R::of(0.0); 4];
        for (size, order) in sizes.iter_mut().zip([0, 1, order - 1, order]) {
            *size = self.size(layout, order);
        }
        Ends(sizes)
    }

    /// The coordinate in a place, as the run shows it.
    pub(super) fn leaf(&self, lane: usize, place: usize) -> C::Leaf {
        leaf::<R, C::Leaf>(&self.few.shown, &self.rows.shown, lane, place)
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
