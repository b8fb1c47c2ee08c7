//! Reversibility: whether steps by `-h` invert steps by `h`.
//!
//! In: a system, a method, a start, a step, a number of steps. Out: the distance from the start after a run forward and
//! back. Always true: the runs are the user's own, in the precision of the user's state, and the clock is reversed at
//! the end of the forward run.

use crate::{
    check::{
        CheckError,
        oracle::tangent::{Carry, Tangents},
        start::{IntoStart, Start},
        statistics::{
            GOLDEN,
            points::{coordinate, numbers, origin, plain, resolution, run},
        },
    },
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, ratio},
    state::{
        flat::{Flat, flat},
        precision::Precision,
    },
    system::Shaped,
    trajectory::method::Method,
};

/// Measures the distance from `start` after `steps` steps by `h` and as many by `-h`.
///
/// The distance is the largest difference of a position in units of the largest position, or of a momentum in units of
/// the largest momentum. A symmetric composition returns to the start up to rounding, for every step size. Other
/// compositions miss the start by about their own error, which grows with the step.
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The run diverges.
pub fn reversibility<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<f64, CheckError> {
    Ok(Endpoints::take::<H, X, K>(system, method, &start.into_start(), h, steps)?.distance())
}

/// The distance of the end of a round trip from its start, and the one that rounding alone explains.
pub(crate) struct RoundTrip {
    pub(crate) distance: f64,
    pub(crate) tolerance: f64,
}

/// The round trip and its tolerance.
///
/// Each of the `2 n f` flows on the way rounds every coordinate, by at most 2 ε of the largest one with the error of
/// the update itself. Tangents that begin with that size show what an error grows to until the end of the trip:
/// the largest they become on the way there, or on the way back. The errors are independent, so that they add up to the
/// root of their number, `2 ε √(2 n f)` times this growth. A factor 8 covers the tail of such a sum and what tangents
/// in two directions may miss of the growth.
pub(crate) fn round_trip<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
    steps: u64,
) -> Result<RoundTrip, CheckError> {
    let trip = Endpoints::take::<H, X, K>(system, method, start, h, steps)?;
    let shape = plain::<H, K>(&start.phase);
    let [there, back] = [h, -h].map(|h| Tangents::<H, X>::new(system, method, &shape, h));
    let growth = largest([
        growth(&there, &trip.start, trip.size, (start.time, h), steps),
        growth(&back, &trip.turnaround, trip.size, (trip.time, -h), steps),
    ]);
    // Tangents that outgrow all numbers leave no number: rounding explains any distance there.
    let growth = if growth.is_nan() { f64::INFINITY } else { growth };
    let roundings = 16.0 * (2.0 * method.facts().roundings_in(steps)).sqrt();
    Ok(RoundTrip { distance: trip.distance(), tolerance: roundings * trip.resolution * growth })
}

/// Start, turnaround and end of a round trip.
struct Endpoints {
    start: Flat,
    turnaround: Flat,
    end: Flat,
    /// The time of the turnaround.
    time: f64,
    /// The size of one rounding, in the unit of the coordinate.
    resolution: f64,
    size: Size,
}

impl Endpoints {
    fn take<H: Hamiltonian, X: Method<H>, K: Precision>(
        system: &H,
        method: X,
        start: &Start<Shaped<H, K>>,
        h: f64,
        steps: u64,
    ) -> Result<Self, CheckError> {
        let turnaround = after::<H, X, K>(system, method, start, h, steps)?;
        let end = after::<H, X, K>(system, method, &turnaround, -h, steps)?;
        let (resolution, time) = (resolution(&[&start.phase, &turnaround.phase]), turnaround.time);
        let (start, turnaround) = (flat(&start.phase), flat(&turnaround.phase));
        let size = Size::of(&[&start, &turnaround]);
        Ok(Self { start, turnaround, end: flat(&end.phase), time, resolution, size })
    }

    fn distance(&self) -> f64 {
        self.size.relative(numbers(&self.start).zip(numbers(&self.end)).map(|(start, end)| start - end))
    }
}

/// The point and the time of a run after some steps.
fn after<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
    steps: u64,
) -> Result<Start<Shaped<H, K>>, Error> {
    let mut run = run::<H, X, K>(system, method, start, h)?;
    run.advance(steps)?;
    Ok(run.state().at_time(run.time()))
}

/// The largest position and the largest momentum.
#[derive(Clone, Copy)]
struct Size {
    q: f64,
    p: f64,
    positions: usize,
}

impl Size {
    fn of(points: &[&Flat]) -> Self {
        Self {
            q: largest(points.iter().flat_map(|point| point.q.iter().copied())),
            p: largest(points.iter().flat_map(|point| point.p.iter().copied())),
            positions: points.first().map_or(0, |point| point.q.len()),
        }
    }

    /// The unit of one number of a point, positions counted first.
    fn unit(self, index: usize) -> f64 {
        if index < self.positions { self.q } else { self.p }
    }

    /// The largest of some numbers, positions first, in these units.
    fn relative(self, numbers: impl Iterator<Item = f64>) -> f64 {
        largest(numbers.enumerate().map(|(index, number)| ratio(number, self.unit(index))))
    }
}

/// The largest size, in units of `size`, that tangents reach within `steps` steps, where every number of a tangent
/// begins with one unit.
fn growth(tangents: &dyn Carry, point: &Flat, size: Size, (t0, h): (f64, f64), steps: u64) -> f64 {
    largest([1.0, -1.0].map(|sign_of_p| {
        let (mut point, mut tangent) = (point.clone(), origin(point));
        for index in 0..2 * size.positions {
            // Signs that share no symmetry with the system: a shift of all bodies together, for example, would not change
            // the forces between them.
            let sign = if (index as f64 * GOLDEN).fract() < 0.5 { 1.0 } else { -1.0 };
            let relative = if index < size.positions { 1.0 } else { sign_of_p };
            *coordinate(&mut tangent, index) = sign * relative * size.unit(index);
        }
        largest((0..steps).map(|step| {
            (point, tangent) = tangents.carry(&point, &tangent, t0 + step as f64 * h, 1);
            size.relative(numbers(&tangent))
        }))
    }))
}
