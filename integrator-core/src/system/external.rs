//! External functions: methods of the user that generated code calls, as tables and splines, with stated derivatives;
//! and flows that the user wrote.

use crate::{
    scalar::real::Real,
    state::{coords::Coords, precision::Slot},
    system::shared_table::SharedTable,
};
use alloc::{sync::Arc, vec::Vec};

/// A function of a few numbers, one per lane.
pub type External<const N: usize> = SharedTable<Arc<dyn Fn([f64; N]) -> f64 + Send + Sync>>;

/// The value of a function in every lane; `None` where its value or a derivative is not stated.
#[inline]
pub fn external<R: Real, const N: usize>(
    arguments: [R; N],
    value: Option<&External<N>>,
    slopes: [Option<&External<N>>; N],
) -> R {
    let of = |function: Option<&External<N>>, lane: usize, x: [f64; N]| match function.and_then(|lanes| lanes.get(lane))
    {
        Some(function) => function(x),
        None => f64::NAN,
    };
    R::lane_by_lane(arguments, |lane, x| of(value, lane, x), |lane, x| slopes.map(|slope| of(slope, lane, x)))
}

/// A flow that the user wrote, one per lane: it moves positions and momenta, points one after the other, for a
/// duration.
pub type OwnFlow = SharedTable<Arc<Moves>>;

type Moves = dyn Fn(&mut [f64], &mut [f64], f64) + Send + Sync;

/// Moves the slots of positions and of momenta by a flow of the user, member by member.
///
/// Slots get the difference, so that those that carry rounding errors keep them. What a scalar has after
/// the value of a member, derivatives or a rounding error, is moved by extrapolated differences along it.
pub fn own_flow<R: Real, C: Coords>(q: &mut C::Slots<R>, p: &mut C::Slots<R>, flow: &OwnFlow, duration: f64) {
    let lanes = || C::slots(q).iter().chain(C::slots(p)).map(|slot| slot.value());
    let number = |lane: usize| lanes().map(|value| value.lane(lane)).collect::<Vec<f64>>();
    let mut differences = Vec::with_capacity(R::LANES);
    let together = R::LANES / R::MEMBERS.max(1);
    for (lane, flow) in flow.iter().enumerate().take(R::LANES).step_by(together) {
        let (start, mut end) = (number(lane), number(lane));
        apply(&**flow, &mut end, duration);
        differences.push(end.iter().zip(&start).map(|(end, start)| end - start).collect::<Vec<f64>>());
        for behind in lane + 1..lane + together {
            let along = number(behind);
            let mut moved = derivative_along(&**flow, &start, &along, &end, duration);
            moved.iter_mut().zip(&along).for_each(|(moved, along)| *moved -= along);
            differences.push(moved);
        }
    }
    let count = C::slots(q).len();
    for (at, slot) in C::slots_mut(q).iter_mut().enumerate() {
        slot.add(R::state(&|lane| differences[lane][at]));
    }
    for (at, slot) in C::slots_mut(p).iter_mut().enumerate() {
        slot.add(R::state(&|lane| differences[lane][count + at]));
    }
}

/// Moves a point, all positions and then all momenta.
fn apply(flow: &Moves, point: &mut [f64], duration: f64) {
    let (q, p) = point.split_at_mut(point.len() / 2);
    flow(q, p, duration);
}

/// The number of widths of differences, each half of the one before: from an eighth of the coordinates down to where
/// rounding takes half of the digits.
const WIDTHS: usize = 20;

/// The derivative of the end of a flow by its start along a tangent: central differences, whose error is a series in
/// the square of the width, extrapolated by Neville's scheme. Of all extrapolations of a component that one is taken
/// whose neighbours are nearest to it, where rounding counts as a distance too (Ridders 1982), since the width at which
/// truncation and rounding are alike is another one for each.
fn derivative_along(flow: &Moves, start: &[f64], along: &[f64], end: &[f64], duration: f64) -> Vec<f64> {
    let mut width = 0.125 * length_of_scale(start, along, end);
    let mut best: Vec<[f64; 2]> = along.iter().map(|_| [f64::NAN, f64::INFINITY]).collect();
    let mut row: Vec<Vec<f64>> = Vec::new();
    if along.iter().all(|along| *along == 0.0) {
        return along.to_vec();
    }
    for _ in 0..WIDTHS {
        let before = core::mem::take(&mut row);
        row.push(central_difference(flow, start, along, width, duration));
        let mut fall = 1.0;
        for (column, coarser) in before.iter().enumerate() {
            fall *= 4.0;
            let (mut finer, weight) = (row[column].clone(), 1.0 / (fall - 1.0));
            for (at, finer) in finer.iter_mut().enumerate() {
                let correction = weight * (*finer - coarser[at]);
                let rounding = f64::EPSILON * end[at].abs() / width;
                let error = f64::max(correction.abs(), (*finer + correction - coarser[at]).abs()) + rounding;
                *finer += correction;
                if error <= best[at][1] {
                    best[at] = [*finer, error];
                }
            }
            row.push(finer);
        }
        width /= 2.0;
    }
    best.into_iter().map(|[value, _]| value).collect()
}

/// Returns the distance along a tangent over which a point moves by about its distance from the origin or by its
/// displacement: the shorter one of positions and momenta.
fn length_of_scale(start: &[f64], along: &[f64], end: &[f64]) -> f64 {
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |largest, number| f64::max(largest, number.abs()));
    let half = start.len() / 2;
    let mut shortest = f64::INFINITY;
    for half in [0..half, half..start.len()] {
        let size = f64::max(largest(&start[half.clone()]), largest(&end[half.clone()]));
        let length = if size > 0.0 { size } else { 1.0 } / largest(&along[half]);
        shortest = f64::min(shortest, length);
    }
    shortest
}

/// The central difference of the end of a flow along a tangent.
fn central_difference(flow: &Moves, start: &[f64], along: &[f64], width: f64, duration: f64) -> Vec<f64> {
    let end = |width: f64| {
        let mut point: Vec<f64> = start.iter().zip(along).map(|(start, along)| start + width * along).collect();
        apply(flow, &mut point, duration);
        point
    };
    let (ahead, behind) = (end(width), end(-width));
    ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * width)).collect()
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    /// A rotation by an angle that depends on the radius, and its derivative in closed form.
    #[test]
    fn derivatives_of_flows_have_nearly_all_digits() {
        let rotate = |q: &mut [f64], p: &mut [f64], duration: f64| {
            let (sine, cosine) = (duration * (q[0] * q[0] + p[0] * p[0]).sinh()).sin_cos();
            (q[0], p[0]) = (cosine * q[0] + sine * p[0], cosine * p[0] - sine * q[0]);
        };
        for [q, p] in [[0.4_f64, 0.3], [1e-3, 2.0], [0.0, 0.7], [1e-9, 1e-9]] {
            for duration in [0.05_f64, 1.0, -3.0] {
                let (square, angle) = (q * q + p * p, duration * (q * q + p * p).sinh());
                let (sine, cosine) = angle.sin_cos();
                let bend = 2.0 * q * duration * square.cosh();
                let end = [cosine * q + sine * p, cosine * p - sine * q];
                let expected = [cosine + bend * end[1], -sine - bend * end[0]];
                let found = derivative_along(&rotate, &[q, p], &[1.0, 0.0], &end, duration);
                for (found, expected) in found.iter().zip(expected) {
                    let size = 1.0 + bend.abs();
                    // `ε^(2/3)` is what central differences have without extrapolation.
                    assert!(
                        (found - expected).abs() < f64::EPSILON.powf(2.0 / 3.0) * size,
                        "{found} and {expected} at {q}, {p}, {duration}"
                    );
                }
            }
        }
    }
}
