//! The flow of `O`: momenta in whole vectors, two numbers of each draw for neighbouring slots, or for two draws of a lone one.

use super::factors::Row;
use crate::{
    scalar::{
        noise::{Counter, gaussians},
        real::Real,
        simd::block::{Block, WIDEST},
    },
    state::precision::Slot,
};
use alloc::vec::Vec;
use core::marker::PhantomData;

/// The part of a random number's counter that all momenta of a stage have in common.
#[derive(Clone, Copy)]
pub(super) struct Draw<'m> {
    pub(super) key: [u32; 2],
    /// The number of the draw: the step, with the stage in its lowest byte; or, of the only coordinate of a system, how many came
    /// before.
    pub(super) number: u64,
    /// The members of the lanes of a motion.
    pub(super) members: &'m [u32],
}

impl Draw<'_> {
    /// The same with one check of the number of members in place of one for each number, which no vector has.
    #[inline(always)]
    fn checked<R: Real>(self) -> Self {
        Self { members: &self.members[..R::LANES], ..self }
    }

    /// The counter of a pair of neighbouring slots, and of a part of these.
    #[inline(always)]
    fn counter(&self, pair: usize, member: usize) -> [u32; 4] {
        [pair as u32, self.members[member], self.number as u32, (self.number >> 32) as u32]
    }
}

/// Friction alone.
#[inline(always)]
pub(super) fn damp<W: Real, S: Slot<W>>(momenta: &mut [S], rows: &[Row<W>]) {
    if let [row] = rows {
        for momentum in momenta {
            momentum.scale_add(row.friction, momentum.value());
        }
        return;
    }
    for (momentum, row) in momenta.iter_mut().zip(rows) {
        momentum.scale_add(row.friction, momentum.value());
    }
}

/// Friction with noise of the momenta from this slot on, which is an even one. `R` has the lanes of the motion.
#[inline(always)]
pub(super) fn thermalise<R: Real, W: Real, S: Slot<W>>(
    momenta: &mut [S],
    rows: &[Row<W>],
    draw: Draw<'_>,
    begin: usize,
) {
    let draw = draw.checked::<R>();
    let width = W::Block::WIDTH;
    let mut first = 0;
    if const { W::Block::WIDTH > 1 } {
        while first + 2 * width <= momenta.len() {
            let mut numbers = [W::of(0.0); 2 * WIDEST];
            let [low, high] = pair::<R, W, W::Block>(draw, begin + first);
            low.write(&mut numbers);
            high.write(&mut numbers[width..]);
            for index in 0..2 * width {
                add(&mut momenta[first + index], row(rows, first + index), numbers[index]);
            }
            first += 2 * width;
        }
    }
    while first < momenta.len() {
        let [one, other] = pair::<R, W, W>(draw, begin + first);
        add(&mut momenta[first], row(rows, first), one);
        if first + 1 < momenta.len() {
            add(&mut momenta[first + 1], row(rows, first + 1), other);
        }
        first += 2;
    }
}

/// The second number of a draw, which belongs to the draw with this index.
pub(super) type Kept<W> = Option<(u64, W)>;

/// Friction with noise of the only coordinate of a system. It takes two draws in a row from one pair of numbers.
#[inline(always)]
pub(super) fn thermalise_one<R: Real, W: Real, S: Slot<W>>(
    momenta: &mut [S],
    rows: &[Row<W>],
    draw: Draw<'_>,
    kept: &mut Kept<W>,
) {
    let ([momentum], [row]) = (momenta, rows) else { return };
    let (index, draw) = (draw.number, draw.checked::<R>());
    let number = match kept.take() {
        Some((of, number)) if of == index => number,
        _ => {
            let [one, other] = pair::<R, W, W>(Draw { number: index / 2, ..draw }, 0);
            if index % 2 == 0 {
                *kept = Some((index + 1, other));
                one
            } else {
                other
            }
        }
    };
    add(momentum, *row, number);
}

/// The momenta before friction.
#[inline(never)]
pub(super) fn values<W: Real, S: Slot<W>>(momenta: &[S]) -> Vec<W> {
    let mut values = Vec::with_capacity(momenta.len());
    for momentum in momenta {
        values.push(momentum.value());
    }
    values
}

/// Adds the changes of the kinetic energies of the members in the lanes, by momenta before and after friction.
#[inline(never)]
pub(super) fn add_heat<W: Real, S: Slot<W>>(heat: &mut [f64], before: &[W], after: &[S], inverse_masses: &[W]) {
    let members = heat.len();
    for ((before, after), inverse_mass) in before.iter().zip(after).zip(inverse_masses) {
        let (difference, sum) = (after.value() - *before, after.value() + *before);
        let change = difference * sum * *inverse_mass * W::of(0.5);
        for lane in 0..W::LANES {
            heat[lane % members] += change.lane(lane);
        }
    }
}

/// The numbers of two blocks of neighbouring slots.
#[inline(always)]
fn pair<R: Real, W: Real, B: Block<W>>(draw: Draw<'_>, first: usize) -> [B; 2] {
    let counter = CounterOf::<R, W> { draw, pair: first / 2, marker: PhantomData };
    let [even, odd] = gaussians::<B>(draw.key, counter);
    even.interleave(odd)
}

/// The counters of blocks from a pair of slots on.
struct CounterOf<'m, R, W> {
    draw: Draw<'m>,
    pair: usize,
    marker: PhantomData<(R, W)>,
}

impl<R: Real, W: Real> Counter for CounterOf<'_, R, W> {
    #[inline(always)]
    fn counter(&self, lane: usize) -> [u32; 4] {
        let (pair, lane) = (self.pair + lane / W::LANES, lane % W::LANES);
        let parts = W::LANES / R::LANES;
        self.draw.counter(pair * parts + lane / R::LANES, lane % R::LANES)
    }
}

/// The factors of a slot.
#[inline(always)]
fn row<W: Copy>(rows: &[Row<W>], slot: usize) -> Row<W> {
    if rows.len() == 1 { rows[0] } else { rows[slot] }
}

/// Friction and noise of one slot.
#[inline(always)]
fn add<W: Real, S: Slot<W>>(momentum: &mut S, row: Row<W>, number: W) {
    momentum.add(row.friction.scale_add(momentum.value(), row.noise.scale(number)));
}
