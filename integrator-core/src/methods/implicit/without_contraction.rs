//! The lanes of an implicit step whose fixed-point iteration does not settle, by Newton's iteration.

use super::{
    field::{Constants, Field, Pair},
    iteration::Equation,
    motion::together,
    newton::{self, by_columns},
    rows::stages_of,
};
use crate::{
    error::Unsolved,
    scalar::{dual::Dual, real::Real, simd::row::Row},
    system::{System, motion::Prepared},
};
use alloc::{vec, vec::Vec};
use core::ops::Range;
use nalgebra::DMatrix;

/// The increments of all lanes that are not settled.
pub(super) fn solve<F: Field<H>, H: System, R: Real, W: Row<R>, const S: usize>(
    equation: &Equation<'_, F, H, R, S>,
    increments: &mut Pair<H, W>,
    settled: R,
    evaluations: &mut u64,
) -> Vec<Option<Unsolved>> {
    let mut unsolved = vec![None; R::LANES];
    for own in (0..R::LANES).step_by(together::<R>()) {
        let lanes = own..own + together::<R>();
        if lanes.clone().all(|lane| settled.lane(lane) > 0.0) {
            continue;
        }
        match slopes(equation, &lanes, evaluations) {
            Ok(slopes) => store::<F, H, R, W, S>(equation, &slopes, &lanes, increments),
            Err(reason) => unsolved[own] = Some(reason),
        }
    }
    if unsolved.iter().all(Option::is_none) { Vec::new() } else { unsolved }
}

/// The field at the stages of the member in these lanes.
fn slopes<F: Field<H>, H: System, R: Real, const S: usize>(
    Equation { constants, conjugate, y, time, h, epsilon, tableau, .. }: &Equation<'_, F, H, R, S>,
    lanes: &Range<usize>,
    evaluations: &mut u64,
) -> Result<Vec<newton::Lists>, Unsolved> {
    let lists = |point: &Pair<H, R>| -> newton::Lists { lanes.clone().map(|lane| listed(point, lane)).collect() };
    let size = y.halves()[0].len();
    newton::Equation {
        y: lists(y),
        time: *time,
        h: *h,
        epsilon: *epsilon,
        a: (0..S).map(|i| (0..S).map(|j| tableau.a(i, j)).collect()).collect(),
        nodes: &tableau.c,
        field: &|place, time| {
            // Other lanes stay where they are, and their field is not read.
            let mut point = Pair::clone(y);
            for (half, numbers) in point.halves_mut().into_iter().enumerate() {
                for k in 0..size {
                    let before = numbers[k];
                    numbers[k] = R::state(&|lane| match lanes.contains(&lane) {
                        true => place[lane - lanes.start][half * size + k],
                        false => before.lane(lane),
                    });
                }
            }
            lists(&F::at(constants, *conjugate, &point, time))
        },
        jacobian: &|place, time| jacobian::<F, H, R>(constants, conjugate.lane(lanes.start), lanes.start, place, time),
    }
    .solve(evaluations)
}

/// Replaces the increments of some lanes by those of these slopes.
fn store<F, H: System, R: Real, W: Row<R>, const S: usize>(
    Equation { h, tableau, .. }: &Equation<'_, F, H, R, S>,
    slopes: &[newton::Lists],
    lanes: &Range<usize>,
    increments: &mut Pair<H, W>,
) {
    for (half, increments) in increments.halves_mut().into_iter().enumerate() {
        let size = increments.len();
        for k in 0..size {
            let mut stages = stages_of::<R, W>(increments[k]);
            for stage in 0..S {
                let (before, factor) = (stages[stage], tableau.b[stage] * h);
                stages[stage] = R::state(&|lane| match lanes.contains(&lane) {
                    true => factor * slopes[stage][lane - lanes.start][half * size + k],
                    false => before.lane(lane),
                });
            }
            increments[k] = W::read(&stages);
        }
    }
}

/// The derivatives of the field of one member, column by column by duals.
fn jacobian<F: Field<H>, H: System, R: Real>(
    Constants { of_lanes, shape, middle, .. }: &Constants<'_, H, R>,
    conjugate: f64,
    own: usize,
    place: &[f64],
    time: f64,
) -> DMatrix<f64> {
    let of_lanes = vec![of_lanes[own].clone(); <Dual>::LANES];
    let members: Vec<_> = of_lanes.iter().collect();
    let mut gathered = H::Parameters::<Dual>::gather(&members);
    gathered.begin_step(*middle);
    let constants = Constants { gathered: &gathered, of_lanes: &of_lanes, shape, middle: *middle };
    by_columns(place.len(), &|column| {
        let mut point = Pair::<H, Dual>::zero(place.len() / 2);
        for (half, numbers) in point.halves_mut().into_iter().enumerate() {
            for (k, number) in numbers.iter_mut().enumerate() {
                let at = half * place.len() / 2 + k;
                let slope = f64::from(u8::from(at == column));
                *number = <Dual>::state(&|lane| if lane == 0 { place[at] } else { slope });
            }
        }
        listed(&F::at::<Dual>(&constants, <Dual>::of(conjugate), &point, time), 1)
    })
}

/// Positions, then momenta of a lane.
fn listed<H: System, R: Real>(pair: &Pair<H, R>, lane: usize) -> Vec<f64> {
    let mut list = Vec::with_capacity(2 * pair.halves()[0].len());
    for numbers in pair.halves() {
        for number in numbers {
            list.push(number.lane(lane));
        }
    }
    list
}
