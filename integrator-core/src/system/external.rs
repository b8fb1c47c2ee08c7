//! External functions: methods of the user that generated code calls, as tables and splines, with stated derivatives;
//! and flows that the user wrote.

use crate::{
    scalar::real::Real,
    state::{coords::Coords, precision::Slot},
};
use alloc::{sync::Arc, vec, vec::Vec};

/// A function of a few numbers, one per lane.
pub type External<const N: usize> = Vec<Arc<dyn Fn([f64; N]) -> f64 + Send + Sync>>;

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

/// A flow that the user wrote, one per lane: it moves positions and momenta, points one after the other, for a duration.
pub type OwnFlow = Vec<Arc<Moves>>;

type Moves = dyn Fn(&mut [f64], &mut [f64], f64) + Send + Sync;

/// Moves the slots of positions and of momenta by a flow of the user, member by member.
///
/// Slots get the difference, so that those that carry rounding errors go on to do so. What a scalar of two parts has in
/// the second one, a tangent or a rounding error, is moved by a central difference of sixth order along it, whose error
/// is about `ε^(6/7)`.
pub fn own_flow<R: Real, C: Coords>(q: &mut C::Slots<R>, p: &mut C::Slots<R>, flow: &OwnFlow, duration: f64) {
    let lanes = || C::slots(q).iter().chain(C::slots(p)).map(|slot| slot.value());
    let number = |lane: usize| lanes().map(|value| value.lane(lane)).collect::<Vec<f64>>();
    let mut differences = Vec::with_capacity(R::LANES);
    for (lane, flow) in flow.iter().enumerate().take(R::MEMBERS) {
        let (start, mut end) = (number(lane), number(lane));
        apply(&**flow, &mut end, duration);
        differences.push(end.iter().zip(&start).map(|(end, start)| end - start).collect::<Vec<f64>>());
        if R::MEMBERS < R::LANES {
            let along = number(1);
            let mut moved = directional_difference(&**flow, &start, &along, duration);
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

/// The weights of the central difference of sixth order, for steps one, two and three.
const WEIGHTS: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];

/// The derivative of the end of a flow by its start along a tangent, as a central difference.
fn directional_difference(flow: &Moves, start: &[f64], along: &[f64], duration: f64) -> Vec<f64> {
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    let size = largest(along);
    if size == 0.0 {
        return along.to_vec();
    }
    // The seventh root of ε: there rounding and the seventh derivative are alike.
    let step = 5.8e-3 * largest(start).max(f64::MIN_POSITIVE) / size;
    let mut derivative = vec![0.0; start.len()];
    for (number, weight) in WEIGHTS.into_iter().enumerate() {
        let step_here = step * (number + 1) as f64;
        for (sign, step_here) in [(1.0, step_here), (-1.0, -step_here)] {
            let mut end: Vec<f64> = start.iter().zip(along).map(|(start, along)| start + step_here * along).collect();
            apply(flow, &mut end, duration);
            let factor = sign * weight / step;
            derivative.iter_mut().zip(&end).for_each(|(derivative, end)| *derivative += factor * end);
        }
    }
    derivative
}
