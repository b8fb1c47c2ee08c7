//! The stages of an implicit step in rows: a row has a number of all stages.

use super::field::Pair;
use crate::{
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    system::System,
};
use core::marker::PhantomData;

/// The most stages, and the lanes of a row.
pub(super) const MOST: usize = 8;

impl<H: System, R: Real> Pair<H, R> {
    /// Reads the numbers of a stage from rows.
    #[inline(always)]
    pub(super) fn read_stage<W: Row<R>>(&mut self, rows: &Pair<H, W>, stage: usize) {
        for (numbers, rows) in self.halves_mut().into_iter().zip(rows.halves()) {
            for k in 0..numbers.len() {
                numbers[k] = rows[k].part(stage);
            }
        }
    }
}

/// The numbers of the stages in a row; those after the last stage are of no use.
#[inline(always)]
pub(super) fn stages_of<R: Real, W: Row<R>>(row: W) -> [R; MOST] {
    let mut stages = [R::of(0.0); MOST];
    row.write(&mut stages);
    stages
}

/// Numbers for each coordinate, of all stages.
pub(super) struct Rows<H: System, R: Real, W: Row<R>> {
    /// `L_i = h b_i f(Z_i)`, by which the stages and the end of the step are determined.
    pub(super) increments: Pair<H, W>,
    /// The same after another iteration.
    pub(super) found: Pair<H, W>,
    /// The stages `Z_i`.
    pub(super) places: Pair<H, W>,
    /// The smallest changes of increments in an iteration.
    pub(super) least: Pair<H, W>,
    row_of: PhantomData<fn(R)>,
}

impl<H: System, R: Real, W: Row<R>> Rows<H, R, W> {
    pub(super) fn new(count: usize) -> Self {
        let zero = || Pair::zero(count);
        Self { increments: zero(), found: zero(), places: zero(), least: zero(), row_of: PhantomData }
    }

    /// Places the stages of one half by the coefficients `μ_ij` of each increment: of the new ones, or of those before.
    #[inline(always)]
    pub(super) fn place<const S: usize>(&mut self, half: usize, y: &Pair<H, R>, columns: &[W; S], by_new: bool) {
        let increments = if by_new { &self.found } else { &self.increments };
        let (y, increments) = (y.halves()[half], increments.halves()[half]);
        let places = &mut *self.places.halves_mut()[half];
        for k in 0..y.len() {
            let stages = stages_of::<R, W>(increments[k]);
            let mut sum = W::splat(stages[0]).scale(columns[0]);
            for j in 1..S {
                sum = W::splat(stages[j]).scale_add(columns[j], sum);
            }
            places[k] = W::splat(y[k]) + sum;
        }
    }

    /// Multiplies the new numbers of one half by those of a row.
    #[inline(always)]
    pub(super) fn scale(&mut self, half: usize, by: W) {
        for number in &mut *self.found.halves_mut()[half] {
            *number = number.scale(by);
        }
    }

    /// Returns one if any change of a number is smaller than all before it, and updates the smallest ones: of one number in
    /// each stage.
    #[inline(always)]
    pub(super) fn shrink_together(&mut self) -> R {
        let mut any = false;
        for half in 0..2 {
            let (before, after) = (self.increments.halves()[half], self.found.halves()[half]);
            let least = &mut *self.least.halves_mut()[half];
            for k in 0..least.len() {
                let change = Real::abs(after[k] - before[k]);
                let is_less = change.less(least[k]);
                any |= is_less.and(W::of(0.0).less(change)).any();
                least[k] = W::select(is_less, change, least[k]);
            }
        }
        R::of(f64::from(u8::from(any)))
    }

    /// The same of each lane.
    #[inline(always)]
    pub(super) fn shrink<const S: usize>(&mut self) -> R {
        let mut shrinks = R::of(0.0);
        for half in 0..2 {
            let (before, after) = (self.increments.halves()[half], self.found.halves()[half]);
            let least = &mut *self.least.halves_mut()[half];
            for k in 0..least.len() {
                for stage in 0..S {
                    let (before, after, smallest) = (before[k].part(stage), after[k].part(stage), least[k].part(stage));
                    let change = R::state(&|lane| (after.lane(lane) - before.lane(lane)).abs());
                    shrinks = R::state(&|lane| {
                        let is_less = change.lane(lane) < smallest.lane(lane) && change.lane(lane) > 0.0;
                        f64::from(u8::from(is_less)).max(shrinks.lane(lane))
                    });
                    least[k].set_part(stage, R::state(&|lane| change.lane(lane).min(smallest.lane(lane))));
                }
            }
        }
        shrinks
    }

    /// Returns the largest change of a lane in an iteration, relative to the largest coordinate of the kind that
    /// changed.
    #[inline(always)]
    pub(super) fn update<const S: usize>(&self, y: &Pair<H, R>, lane: usize) -> f64 {
        let mut most = 0.0_f64;
        for half in 0..2 {
            let (before, after) = (self.increments.halves()[half], self.found.halves()[half]);
            let (mut moved, mut size) = (0.0_f64, 0.0_f64);
            let y = y.halves()[half];
            for k in 0..y.len() {
                size = size.max(y[k].lane(lane).abs());
                for stage in 0..S {
                    let at = stage * R::LANES + lane;
                    moved = larger(moved, (after[k].lane(at) - before[k].lane(at)).abs());
                    size = size.max(after[k].lane(at).abs());
                }
            }
            // Nothing in units of nothing is nothing.
            let relative = if moved == 0.0 { 0.0 } else { moved / size };
            most = larger(most, relative);
        }
        most
    }
}

/// The larger of two numbers, or what is no number: then nothing has settled, whatever the other coordinates do.
#[inline(always)]
fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other <= one { one } else { other }
}

/// Writes numbers to all lanes of rows.
#[inline(always)]
pub(super) fn spread<R: Real, W: Row<R>>(numbers: &[R], rows: &mut [W]) {
    for k in 0..numbers.len() {
        rows[k] = W::splat(numbers[k]);
    }
}

/// Restores the previous increments in the lanes that are settled.
#[inline(always)]
pub(super) fn keep_settled<H: System, R: Real, W: Row<R>>(
    settled: &R,
    increments: &Pair<H, W>,
    found: &mut Pair<H, W>,
) {
    if const { R::LANES == 1 } || (0..R::LANES).all(|lane| settled.lane(lane) == 0.0) {
        return;
    }
    for (before, after) in increments.halves().into_iter().zip(found.halves_mut()) {
        for (before, after) in before.iter().zip(after) {
            let (before, now) = (stages_of::<R, W>(*before), stages_of::<R, W>(*after));
            let kept: [R; MOST] = core::array::from_fn(|stage| {
                R::state(&|lane| {
                    if settled.lane(lane) > 0.0 { before[stage].lane(lane) } else { now[stage].lane(lane) }
                })
            });
            *after = W::read(&kept);
        }
    }
}
