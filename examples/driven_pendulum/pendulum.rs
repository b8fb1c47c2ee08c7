//! A damped pendulum with a periodic torque: its states once per period of the drive, its periodic orbits, and the torques at which
//! their period doubles.

use integrator_core::prelude::*;
use nalgebra::{Matrix2, Vector2};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A pendulum of natural frequency 1, with the friction 1/2 and a drive of frequency 2/3.
#[derive(Clone, Copy)]
pub(crate) struct Driven {
    /// Amplitude of the torque, in units of the largest torque of gravity.
    pub(crate) torque: f64,
}

#[hamiltonian(compose = DampedFourth, split = kinetic + potential + friction)]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -q[0].cos() - self.torque * q[0] * (2.0 / 3.0 * t).cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        0.5
    }
}

composition! {
    /// Order 4 for damped motion without noise.
    pub struct DampedFourth: order 4, symmetric = triple_jump(V(1/2) T(1/2) O(1) T(1/2) V(1/2));
}

/// Period of the drive, and the number of steps in it.
const PERIOD: f64 = 1.5 * TAU;
const STEPS: u64 = 100;
const STEP: f64 = PERIOD / STEPS as f64;

type State = Phase<[f64; 1]>;

/// Returns the initial state of all runs: at rest with a horizontal rod.
fn start() -> State {
    Phase::new([-FRAC_PI_2], [0.0])
}

/// Returns `(angle, angular velocity)` once per period of the drive, with the angle between -π and π, after `forgotten` periods.
pub(crate) fn section(torque: f64, forgotten: u64, periods: usize) -> Result<Vec<(f64, f64)>, Error> {
    let mut run = Driven { torque }.run(start(), STEP)?;
    run.advance(forgotten * STEPS)?;
    let samples = run.samples(STEPS).take(periods);
    samples
        .map(|sample| sample.map(|Sample { state, .. }| ((state.q[0] + PI).rem_euclid(TAU) - PI, state.p[0])))
        .collect()
}

/// Returns `(torque, angular velocity)` once per period of the drive for many torques, after `forgotten` periods.
pub(crate) fn diagram(torques: &[f64], forgotten: u64, periods: u64) -> Result<Vec<(f64, f64)>, Error> {
    let members = torques.iter().map(|torque| (Driven { torque: *torque }, start()));
    let mut pendulums = Ensemble::new(DampedFourth, members, STEP)?;
    pendulums.advance(forgotten * STEPS)?;
    let mut points = Vec::new();
    for _ in 0..periods {
        pendulums.advance(STEPS)?;
        points.extend(torques.iter().copied().zip(pendulums.states().map(|state| state.p[0])));
    }
    Ok(points)
}

/// Returns the state after some periods, and its derivative by the initial state.
fn map(torque: f64, state: State, periods: u64) -> Result<(Vector2<f64>, Matrix2<f64>), Error> {
    let units = [Phase::new([1.0], [0.0]), Phase::new([0.0], [1.0])];
    let mut tangent = Driven { torque }.tangent(DampedFourth, state, units, STEP)?;
    tangent.advance(periods * STEPS)?;
    let columns: Vec<_> = tangent.vectors().iter().map(|vector| Vector2::new(vector.q[0], vector.p[0])).collect();
    let end = tangent.state();
    Ok((Vector2::new(end.q[0], end.p[0]), Matrix2::from_columns(&columns)))
}

/// Finds the periodic orbit near a state, stable or not, by Newton's method. Returns it with `(1 + λ₁)(1 + λ₂)` of its Floquet
/// multipliers, which is zero where the period doubles.
fn periodic(torque: f64, mut near: Vector2<f64>, periods: u64) -> Result<(Vector2<f64>, f64), Error> {
    let mut value = f64::NAN;
    for _ in 0..20 {
        let (end, derivative) = map(torque, Phase::new([near[0]], [near[1]]), periods)?;
        let correction = (derivative - Matrix2::identity()).lu().solve(&(near - end)).unwrap_or_default();
        (near, value) = (near + correction, 1.0 + derivative.trace() + derivative.determinant());
        if correction.norm() < 1e-11 {
            break;
        }
    }
    Ok((near, value))
}

/// Returns the first `count` torques at which the period doubles: those of the orbit of one period, of two, of four and so on.
pub(crate) fn doublings(count: usize) -> Result<Vec<f64>, Error> {
    let mut found: Vec<f64> = Vec::new();
    // Two torques at which the orbit of one period is stable, for the secant method.
    let (mut first, mut second) = (1.063, 1.065);
    for number in 0..count {
        let periods = 1 << number;
        // Newton's method needs a state near the orbit, to which the motion tends there.
        let (mut orbit, mut value) = periodic(first, settled(first, 100 + 20 * periods)?, periods)?;
        // The slope is a few units per interval to the next doubling, so this is the error in such intervals.
        while value.abs() > 1e-8 {
            let (next_orbit, next) = periodic(second, orbit, periods)?;
            let slope = (next - value) / (second - first);
            (first, orbit, value) = (second, next_orbit, next);
            second -= next / slope;
        }
        // The next interval is shorter by a factor of about 4.67.
        let interval = found.last().map_or(0.06, |last| first - last) / 4.67;
        found.push(first);
        (first, second) = (first + 0.8 * interval, first + 0.9 * interval);
    }
    Ok(found)
}

/// Returns the state after some periods from the initial one.
fn settled(torque: f64, periods: u64) -> Result<Vector2<f64>, Error> {
    let mut run = Driven { torque }.run(start(), STEP)?;
    run.advance(periods * STEPS)?;
    let state = run.state();
    Ok(Vector2::new(state.q[0], state.p[0]))
}

/// Returns the ratios of successive intervals between doublings, which tend to Feigenbaum's number.
pub(crate) fn ratios(doublings: &[f64]) -> Vec<f64> {
    doublings.windows(3).map(|three| (three[1] - three[0]) / (three[2] - three[1])).collect()
}
