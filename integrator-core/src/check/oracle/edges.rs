//! Edges: the times at which pieces of a Hamiltonian meet, relative to the steps of a run.
//!
//! In: a system, some points, a step. Out: the spacing of the edges in steps. Always true: two times belong to one
//! piece where the flows with the conditions of either do the same to all of these points.

use crate::{
    check::CheckError,
    hamiltonian::Hamiltonian,
    scalar::tolerance::within,
    state::{coords::Coords, phase::Phase},
    system::motion::Motion,
};

/// The tolerance of an edge at the end of a step, in units of ε of the time: both are computed with a few roundings of
/// numbers up to it.
const ROUNDINGS: f64 = 16.0;

/// The greatest common divisor of the numbers of steps that lie between edges, from time `t0`; zero, if there are none
/// among this number of steps.
///
/// # Errors
/// An edge inside of a step.
pub(crate) fn spacing<H: Hamiltonian>(
    system: &H,
    points: &[Phase<H::Coords>],
    t0: f64,
    h: f64,
    steps: u64,
) -> Result<u64, CheckError> {
    let length = points.first().map_or(0, |point| point.q.length());
    let pieces = Pieces::<H> { parameters: system.parameters(length), points, h };
    let mut apart = 0;
    // From the start to the middle of the first step, then from middle to middle, so that none lies between two of them.
    let mut before = t0;
    for step in 0..steps {
        let end = t0 + step as f64 * h;
        let middle = end + h / 2.0;
        let edge = pieces.edge(before, middle);
        before = middle;
        let Some(time) = edge else { continue };
        let size = end.abs().max(t0.abs()).max(h.abs());
        if !within(time - end, ROUNDINGS * f64::EPSILON * size) {
            return Err(CheckError::EdgeInside { time, h });
        }
        apart = greatest_common_divisor(apart, step);
    }
    Ok(apart)
}

/// The number of parts of a span in which edges are searched for, one in each at most, and the largest number of steps
/// that is tried to meet them.
const PARTS: u32 = 1 << 13;

/// The fewest equal steps over a span from `t0` that end at all edges in it.
///
/// # Errors
/// The first edge that no number of steps meets.
pub(crate) fn fewest_steps<H: Hamiltonian>(
    system: &H,
    points: &[Phase<H::Coords>],
    t0: f64,
    span: f64,
) -> Result<u64, f64> {
    let length = points.first().map_or(0, |point| point.q.length());
    let at = |part: u32| t0 + span * (f64::from(part) / f64::from(PARTS));
    let pieces = Pieces::<H> { parameters: system.parameters(length), points, h: span / f64::from(PARTS) };
    let edges = (0..PARTS).filter_map(|part| pieces.edge(at(part), at(part + 1)));
    let edges: Vec<f64> = edges.filter(|edge| *edge != t0 && *edge != t0 + span).collect();
    let rounding = ROUNDINGS * f64::EPSILON * (t0.abs() + span.abs());
    let off = |edge: f64, steps: f64| {
        let place = (edge - t0) / span * steps;
        (place - place.round()) * span / steps
    };
    let met = |steps: &u32| edges.iter().all(|edge| within(off(*edge, f64::from(*steps)), rounding));
    let first_off = |edge: &f64| (1..=PARTS).all(|steps| !within(off(*edge, f64::from(steps)), rounding));
    match (1..=PARTS).find(met) {
        Some(steps) => Ok(u64::from(steps)),
        None => Err(edges.iter().copied().find(first_off).or(edges.first().copied()).unwrap_or(t0)),
    }
}

struct Pieces<'p, H: Hamiltonian> {
    parameters: H::Parameters<f64>,
    points: &'p [Phase<H::Coords>],
    h: f64,
}

impl<H: Hamiltonian> Pieces<'_, H> {
    /// The edge between two times, if there is one.
    fn edge(&self, mut before: f64, mut behind: f64) -> Option<f64> {
        // Where formulas meet without a jump, they differ after the edge.
        let time = behind;
        if !self.differ(before, behind, time) {
            return None;
        }
        loop {
            let middle = before + (behind - before) / 2.0;
            if middle == before || middle == behind {
                return Some(behind);
            }
            if self.differ(before, middle, time) {
                behind = middle;
            } else {
                before = middle;
            }
        }
    }

    /// Whether flows at a time differ when one time decides on the piece and when the other one does.
    fn differ(&self, one: f64, other: f64, time: f64) -> bool {
        self.points.iter().any(|point| {
            let (one, other) = (self.moved(point, one, time), self.moved(point, other, time));
            one.q.flat() != other.q.flat() || one.p.flat() != other.p.flat()
        })
    }

    fn moved(&self, point: &Phase<H::Coords>, middle: f64, time: f64) -> Phase<H::Coords> {
        let mut motion = H::Motion::<f64, f64>::load(&[&self.parameters], &[point]);
        H::begin_step::<f64, f64>(&mut motion, middle);
        H::drift::<f64, f64>(&mut motion, self.h, time);
        H::middle::<f64, f64>(&mut motion, self.h, time, false);
        H::kick::<f64, f64>(&mut motion, self.h, time);
        let mut moved = point.clone();
        motion.store(0, &mut moved);
        moved
    }
}

pub(crate) fn greatest_common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
