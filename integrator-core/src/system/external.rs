//! External functions: methods of the user that generated code calls, as tables and splines, with stated derivatives;
//! and flows that the user wrote.

use crate::{
    scalar::real::Real,
    state::{coords::Coords, precision::Slot},
};
use alloc::{sync::Arc, vec::Vec};

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
/// the second one, a tangent or a rounding error, is moved by a central difference along it, whose error is about
/// `ε^(2/3)`.
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

/// The derivative of the end of a flow by its start along a tangent, as a central difference.
fn directional_difference(flow: &Moves, start: &[f64], along: &[f64], duration: f64) -> Vec<f64> {
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    let size = largest(along);
    if size == 0.0 {
        return along.to_vec();
    }
    // The cube root of ε: there rounding and the third derivative are alike.
    let step = 6.0554544523933395e-6 * largest(start).max(f64::MIN_POSITIVE) / size;
    let end = |step: f64| {
        let mut point: Vec<f64> = start.iter().zip(along).map(|(start, along)| start + step * along).collect();
        apply(flow, &mut point, duration);
        point
    };
    let (ahead, behind) = (end(step), end(-step));
    ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * step)).collect()
}
