//! The equation of an implicit step by Newton's iteration with the Hessian of the generated code: for steps that are long
//! compared with the fastest motion.

use super::{
    field::{Constants, Pair, field_of_step},
    iteration::{Equation, stages_of},
};
use crate::{
    error::Unsolved,
    scalar::{
        dual::Dual,
        real::Real,
        simd::row::Row,
        tolerance::{largest, ratio},
    },
    system::{System, motion::Prepared},
};
use core::{array, ops::Range};
use nalgebra::{DMatrix, DVector};

/// The largest number of iterations. Newton's iteration doubles the digits with each, so that a handful reaches the
/// rounding from wherever it converges.
const ITERATIONS: u32 = 32;

/// The update at which the iteration has reached the rounding, in ε of the largest coordinate of its kind.
const SETTLED: f64 = 4.0;

/// An update that no longer shrinks is rounding too if it is as small as this, in ε: the equation is then worse
/// conditioned than the state is precise.
const STALLED: f64 = 1e6;

/// The increments of all lanes that are not settled.
pub(super) fn solve<H: System, R: Real, W: Row<R>, const S: usize>(
    equation: &Equation<'_, H, R, S>,
    increments: &mut Pair<H, W>,
    mut settled: R,
    evaluations: &mut u64,
) -> Vec<Option<Unsolved>> {
    let mut unsolved = vec![None; R::LANES];
    // A member may have its tangents in the lanes after its own.
    let together = R::LANES / R::MEMBERS.max(1);
    for own in (0..R::LANES).step_by(together.max(1)) {
        let lanes = own..own + together;
        if lanes.clone().all(|lane| settled.lane(lane) > 0.0) {
            continue;
        }
        match member(equation, own, evaluations) {
            Ok(slopes) => store::<H, R, W, S>(equation, &slopes, &lanes, increments),
            Err(update) => unsolved[own] = Some(Unsolved::Newton { iterations: ITERATIONS, update }),
        }
        settled = R::state(&|lane| if lanes.contains(&lane) { 1.0 } else { settled.lane(lane) });
    }
    if unsolved.iter().all(Option::is_none) { Vec::new() } else { unsolved }
}

/// Replaces the increments of some lanes by those of these slopes.
fn store<H: System, R: Real, W: Row<R>, const S: usize>(
    Equation { h, tableau, .. }: &Equation<'_, H, R, S>,
    slopes: &[Pair<H, R>; S],
    lanes: &Range<usize>,
    increments: &mut Pair<H, W>,
) {
    for (half, increments) in increments.halves_mut().into_iter().enumerate() {
        for (k, increments) in increments.iter_mut().enumerate() {
            let mut stages = stages_of::<R, W, S>(*increments);
            for ((stage, slopes), b) in stages.iter_mut().zip(slopes).zip(&tableau.b) {
                let (before, now) = (*stage, slopes.halves()[half][k].scale(R::of(b * h)));
                *stage = R::state(&|lane| if lanes.contains(&lane) { now.lane(lane) } else { before.lane(lane) });
            }
            *increments = W::read(&stages);
        }
    }
}

/// The field at the stages by the matrix of one member, or how far the last iteration moved.
fn member<H: System, R: Real, const S: usize>(
    equation: &Equation<'_, H, R, S>,
    own: usize,
    evaluations: &mut u64,
) -> Result<[Pair<H, R>; S], f64> {
    let Equation { constants, y, time, h, epsilon, tableau } = equation;
    let together = own..own + R::LANES / R::MEMBERS.max(1);
    let start = listed(&field_of_step::<H, R>(constants, y, *time));
    let y = listed(y);
    let size = y.len();
    let mut z: [Vec<R>; S] =
        array::from_fn(|i| y.iter().zip(&start).map(|(y, f)| *y + R::of(tableau.c[i] * h) * *f).collect());
    let mut update = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let fields: [Pair<H, R>; S] =
            array::from_fn(|j| field_of_step::<H, R>(constants, &paired(&z[j]), time + tableau.c[j] * h));
        let slopes: [Vec<R>; S] = array::from_fn(|j| listed(&fields[j]));
        let residual = |i: usize, k: usize| {
            (0..S).fold(z[i][k] - y[k], |residual, j| residual - R::of(tableau.a(i, j) * h) * slopes[j][k])
        };
        let residuals: Vec<R> = (0..S * size).map(|row| residual(row / size, row % size)).collect();
        let jacobians = array::from_fn::<_, S, _>(|j| {
            let values: Vec<f64> = z[j].iter().map(|z| z.lane(own)).collect();
            jacobian::<H, R>(constants, own, &values, time + tableau.c[j] * h)
        });
        *evaluations += (S * (1 + size)) as u64;
        let weights = array::from_fn::<_, S, _>(|i| array::from_fn::<_, S, _>(|j| tableau.a(i, j)));
        let weights = array::from_fn::<_, S, _>(|i| &weights[i][..]);
        let of_lane = |numbers: &[R], lane: usize| numbers.iter().map(|number| number.lane(lane)).collect::<Vec<_>>();
        let residuals: Vec<_> = together.clone().map(|lane| of_lane(&residuals, lane)).collect();
        // A matrix that is singular, or no number, leads nowhere: the last update says how far the iteration was.
        let lanes = updates(&jacobians, &weights, *h, &residuals).ok_or(update)?;
        for (stage, z) in z.iter_mut().enumerate() {
            for (k, z) in z.iter_mut().enumerate() {
                let row = stage * size + k;
                *z -= R::state(&|lane| if together.contains(&lane) { lanes[lane - own][row] } else { 0.0 });
            }
        }
        let mut relative = 0.0;
        for lane in together.clone() {
            let (y, moved) = (of_lane(&y, lane), &lanes[lane - own]);
            for (stage, z) in z.iter().enumerate() {
                let moved = &moved.as_slice()[stage * size..][..size];
                relative = largest([relative, moved_by(moved, &of_lane(z, lane), &y)]);
            }
        }
        let stalled = relative >= update / 2.0 && relative <= STALLED * epsilon;
        if relative <= SETTLED * epsilon || stalled {
            return Ok(array::from_fn(|j| field_of_step::<H, R>(constants, &paired(&z[j]), time + tableau.c[j] * h)));
        }
        update = relative;
    }
    Err(update)
}

/// Returns the update of Newton's iteration for each list of residuals, by the Jacobians at the stages and the weights
/// of a tableau. In plain numbers, so that it is compiled with this crate and not with each system; `None` where the
/// matrix is singular.
fn updates(
    jacobians: &[DMatrix<f64>],
    weights: &[&[f64]],
    h: f64,
    residuals: &[Vec<f64>],
) -> Option<Vec<DVector<f64>>> {
    let size = jacobians.first().map_or(0, DMatrix::nrows);
    let rows = weights.len() * size;
    let mut matrix = DMatrix::identity(rows, rows);
    for (j, jacobian) in jacobians.iter().enumerate() {
        for (i, row) in weights.iter().enumerate() {
            let mut block = matrix.view_mut((i * size, j * size), (size, size));
            block -= jacobian * (row[j] * h);
        }
    }
    let factors = matrix.lu();
    residuals.iter().map(|residual| factors.solve(&DVector::from_column_slice(residual))).collect()
}

/// The largest update of positions, and of momenta, in units of these at the stage and at the beginning: where the end is zero,
/// the beginning shows the size of the rounding, since they differ by what rounds.
fn moved_by(moved: &[f64], stage: &[f64], beginning: &[f64]) -> f64 {
    let half = moved.len() / 2;
    let of = |range: Range<usize>| {
        let size = largest(stage[range.clone()].iter().chain(&beginning[range.clone()]).copied());
        ratio(largest(moved[range].iter().copied()), size)
    };
    largest([of(0..half), of(half..moved.len())])
}

/// The derivatives of the field of one member, column by column by duals.
fn jacobian<H: System, R: Real>(
    Constants { of_lanes, shape, middle, .. }: &Constants<'_, H, R>,
    own: usize,
    y: &[f64],
    time: f64,
) -> DMatrix<f64> {
    let of_lanes = vec![of_lanes[own].clone(); <Dual>::LANES];
    let members: Vec<_> = of_lanes.iter().collect();
    let mut gathered = H::Parameters::<Dual>::gather(&members);
    gathered.begin_step(*middle);
    let constants = Constants { gathered: &gathered, of_lanes: &of_lanes, shape, middle: *middle };
    let mut jacobian = DMatrix::zeros(y.len(), y.len());
    for column in 0..y.len() {
        let along = |i: usize| <Dual>::state(&|lane| if lane == 0 { y[i] } else { f64::from(u8::from(i == column)) });
        let y: Vec<Dual> = (0..y.len()).map(along).collect();
        let field = field_of_step::<H, Dual>(&constants, &paired(&y), time);
        for (row, derivative) in listed(&field).into_iter().enumerate() {
            jacobian[(row, column)] = derivative.lane(1);
        }
    }
    jacobian
}

/// Positions, then momenta.
fn listed<H: System, R: Real>(pair: &Pair<H, R>) -> Vec<R> {
    pair.halves().concat()
}

/// A list of positions, then momenta, in the shape of the coordinates.
fn paired<H: System, R: Real>(list: &[R]) -> Pair<H, R> {
    let mut pair = Pair::zero(list.len() / 2);
    let (q, p) = list.split_at(list.len() / 2);
    for (to, from) in pair.halves_mut().into_iter().zip([q, p]) {
        to.copy_from_slice(from);
    }
    pair
}
