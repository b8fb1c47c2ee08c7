//! The limit of a step at the first edge that the motion crosses.

use super::{
    Recurrences,
    edges::{BOUNDS, Edge, Enclosure, Polynomials, Search},
    expansion::Of,
    table::{Coefficients, Layout},
    time::Time,
};
use crate::{
    error::Unsolved,
    scalar::real::Real,
    state::{clock::Clock, precision::Precision},
    system::{System, motion::Prepared},
};

/// Looks for edges on the polynomials of a member up to a time, and returns the step within which there are none. The
/// polynomials are searched in ranges that double, beginning with the step of the run, so that the outcome does not depend
/// on the time.
#[inline(never)]
pub(super) fn limit<H: Recurrences, R: Real, K: Precision>(
    expansion: &mut Of<H, R, K>,
    member: usize,
    clock: Clock,
    end: Time,
) -> f64 {
    let segment = &expansion.segments[member];
    let step = segment.step.unwrap_or(0.0);
    let ahead = Real::abs(end.since(segment.origin)).min(step.abs());
    if segment.unsolved.is_some() || segment.free >= ahead {
        return step;
    }
    let free = segment.free;
    match search::<H, R, K>(expansion, member, clock, [free, ahead]) {
        Ok((free, edge)) => {
            let segment = &mut expansion.segments[member];
            segment.free = free;
            if let Some(Edge { duration, is_of_time }) = edge {
                segment.step = Some(duration.min(step.abs()).copysign(step));
                segment.ends_at_edge = !is_of_time;
            }
            segment.step.unwrap_or(step)
        }
        Err(unsolved) => {
            expansion.segments[member].unsolved = Some(unsolved);
            step
        }
    }
}

/// The duration up to which there is no edge, and the edge that follows it.
fn search<H: Recurrences, R: Real, K: Precision>(
    expansion: &Of<H, R, K>,
    member: usize,
    clock: Clock,
    [mut free, ahead]: [f64; 2],
) -> Result<(f64, Option<Edge>), Unsolved> {
    let main = expansion.layout;
    let segment = &expansion.segments[member];
    let (step, time) = (segment.step.unwrap_or(0.0), clock.t0 + segment.origin.nearest());
    // The coefficients are in a unit of time of their own, and so is the search.
    let unit = segment.unit::<R>(clock.h);
    let single = &*expansion.of_members[member];
    let parameters = <H::Parameters<Enclosure> as Prepared<Enclosure>>::gather(&[single; BOUNDS]);
    let layout = Layout::of::<<H as System>::Coords>(main.length(), false);
    let (order, count) = (expansion.method.order(), layout.coordinates());
    let halves = [&expansion.q, &expansion.p];
    let spacing = halves[0].leaf(member, main.index_of(0)).spacing();
    let polynomials =
        Polynomials::new([order, 2 * count], step < 0.0, [2.0 * K::EPSILON, spacing.unwrap_or(0.0)], |k, number| {
            halves[number / count].coefficient(main, k, main.index_of(number % count), member)
        });
    let search = Search {
        polynomials: &polynomials,
        layout,
        conditions: &|q: &Coefficients<'_, _>, p: &Coefficients<'_, _>, time, watch| {
            H::edges(&parameters, layout.length(), q, p, time, watch);
        },
        time,
        unit: unit.copysign(step),
        resolution: f64::EPSILON * f64::max(time.abs(), clock.h.abs()) / unit,
        epsilon: K::EPSILON,
    };
    while free < ahead {
        let next = f64::max(2.0 * free, clock.h.abs()).min(step.abs());
        match search.first([free / unit, next / unit]) {
            Ok(None) => free = next,
            Ok(Some(Edge { duration, is_of_time })) => {
                let duration = duration * unit;
                return Ok((duration, Some(Edge { duration, is_of_time })));
            }
            Err(_) => return Err(Unsolved::Edges { time }),
        }
    }
    Ok((free, None))
}
