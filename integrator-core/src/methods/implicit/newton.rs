//! The equation of an implicit step by Newton's iteration with the Hessian of the generated code: for steps that are long
//! compared with the fastest motion.

use super::{
    field::{Constants, Pair, field},
    iteration::{Equation, keep_settled},
};
use crate::{
    error::Unsolved,
    hamiltonian::Hamiltonian,
    scalar::{
        dual::Dual,
        real::Real,
        tolerance::{largest, ratio},
    },
    system::motion::Prepared,
};
use core::array;
use nalgebra::{DMatrix, DVector};

/// After so many iterations without an end there is none. Newton's iteration doubles the digits with each, so that a
/// handful reaches the rounding from wherever it converges.
const ITERATIONS: u32 = 32;

/// The update at which the iteration has reached the rounding, in ε of the largest coordinate of its kind.
const SETTLED: f64 = 4.0;

/// An update that no longer shrinks is rounding too if it is as small as this, in ε: the equation is then worse
/// conditioned than the state is precise.
const STALLED: f64 = 1e6;

/// The field at the stages, of all lanes that are not settled.
pub(super) fn solve<H: Hamiltonian, R: Real, const S: usize>(
    equation: &Equation<'_, H, R, S>,
    slopes: &mut [Pair<H, R>; S],
    mut settled: R,
    evaluations: &mut u64,
) -> Vec<Option<Unsolved>> {
    let mut unsolved = vec![None; R::LANES];
    // A member may have its tangents in the lanes behind its own.
    let together = R::LANES / R::MEMBERS.max(1);
    for own in (0..R::LANES).step_by(together.max(1)) {
        let lanes = own..own + together;
        if lanes.clone().all(|lane| settled.lane(lane) > 0.0) {
            continue;
        }
        match member(equation, own, evaluations) {
            Ok(mut found) => {
                let others = R::state(&|lane| f64::from(u8::from(!lanes.contains(&lane))));
                keep_settled(&others, slopes, &mut found);
                *slopes = found;
            }
            Err(update) => unsolved[own] = Some(Unsolved::Newton { iterations: ITERATIONS, update }),
        }
        settled = R::state(&|lane| if lanes.contains(&lane) { 1.0 } else { settled.lane(lane) });
    }
    if unsolved.iter().all(Option::is_none) { Vec::new() } else { unsolved }
}

/// The field at the stages by the matrix of one member, or how far the last iteration moved.
fn member<H: Hamiltonian, R: Real, const S: usize>(
    equation: &Equation<'_, H, R, S>,
    own: usize,
    evaluations: &mut u64,
) -> Result<[Pair<H, R>; S], f64> {
    let Equation { constants, y, time, h, epsilon, tableau } = equation;
    let together = own..own + R::LANES / R::MEMBERS.max(1);
    let start = listed(&field::<H, R>(constants, y, *time));
    let y = listed(y);
    let (size, half) = (y.len(), y.len() / 2);
    let mut z: [Vec<R>; S] =
        array::from_fn(|i| y.iter().zip(&start).map(|(y, f)| *y + R::of(tableau.c[i] * h) * *f).collect());
    let mut update = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let fields: [Pair<H, R>; S] =
            array::from_fn(|j| field::<H, R>(constants, &paired(&z[j]), time + tableau.c[j] * h));
        let slopes: [Vec<R>; S] = array::from_fn(|j| listed(&fields[j]));
        let residual = |i: usize, k: usize| {
            (0..S).fold(z[i][k] - y[k], |residual, j| residual - R::of(tableau.a[i][j] * h) * slopes[j][k])
        };
        let residuals: Vec<R> = (0..S * size).map(|row| residual(row / size, row % size)).collect();
        let mut matrix = DMatrix::identity(S * size, S * size);
        for j in 0..S {
            let values: Vec<f64> = z[j].iter().map(|z| z.lane(own)).collect();
            let jacobian = jacobian::<H, R>(constants, own, &values, time + tableau.c[j] * h);
            for (i, row) in tableau.a.iter().enumerate() {
                let mut block = matrix.view_mut((i * size, j * size), (size, size));
                block -= &jacobian * (row[j] * h);
            }
        }
        *evaluations += (S * (1 + size)) as u64;
        let factors = matrix.lu();
        let mut lanes = Vec::with_capacity(together.len());
        for lane in together.clone() {
            let residual = DVector::from_iterator(S * size, residuals.iter().map(|r| r.lane(lane)));
            // A matrix that is singular, or no number, leads nowhere: the last update says how far the iteration was.
            lanes.push(factors.solve(&residual).ok_or(update)?);
        }
        for (row, z) in z.iter_mut().flatten().enumerate() {
            *z -= R::state(&|lane| if together.contains(&lane) { lanes[lane - own][row] } else { 0.0 });
        }
        let relative = |lane: usize, stage: usize, range: core::ops::Range<usize>| {
            let moved = largest(range.clone().map(|k| lanes[lane - own][stage * size + k]));
            // Where the end is zero, the beginning tells what is rounding: they differ by what rounds.
            ratio(moved, largest(range.flat_map(|k| [z[stage][k].lane(lane), y[k].lane(lane)])))
        };
        let stages = together.clone().flat_map(|lane| (0..S).map(move |stage| (lane, stage)));
        let relative =
            largest(stages.flat_map(|(lane, stage)| [0..half, half..size].map(|range| relative(lane, stage, range))));
        let stalled = relative >= update / 2.0 && relative <= STALLED * epsilon;
        if relative <= SETTLED * epsilon || stalled {
            return Ok(array::from_fn(|j| field::<H, R>(constants, &paired(&z[j]), time + tableau.c[j] * h)));
        }
        update = relative;
    }
    Err(update)
}

/// The derivatives of the field of one member, column by column by duals.
fn jacobian<H: Hamiltonian, R: Real>(
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
        let field = field::<H, Dual>(&constants, &paired(&y), time);
        for (row, derivative) in listed(&field).into_iter().enumerate() {
            jacobian[(row, column)] = derivative.lane(1);
        }
    }
    jacobian
}

/// Positions, then momenta.
fn listed<H: Hamiltonian, R: Real>(pair: &Pair<H, R>) -> Vec<R> {
    pair.halves().concat()
}

/// The same in the shape of the coordinates.
fn paired<H: Hamiltonian, R: Real>(list: &[R]) -> Pair<H, R> {
    let mut pair = Pair::zero(list.len() / 2);
    let (q, p) = list.split_at(list.len() / 2);
    for (to, from) in pair.halves_mut().into_iter().zip([q, p]) {
        to.copy_from_slice(from);
    }
    pair
}
