//! A heavy symmetric top. Units: the moment of inertia perpendicular to the axis, and the weight times the distance of the centre of
//! mass from the fixed point.

use crate::elliptic::Elliptic;
use integrator_core::{GaussLegendre, prelude::*};

/// A symmetric top with a fixed point below its centre of mass.
#[derive(Clone, Copy)]
pub(crate) struct Top {
    /// The moment of inertia about the axis.
    pub(crate) axial: f64,
}

/// H in Euler angles (θ, φ, ψ): the tilt of the axis, the precession and the rotation about the axis.
#[hamiltonian(split = none, compose = GaussLegendre<8>)]
impl Top {
    fn hamiltonian(&self, [theta, _, _]: [f64; 3], [ptheta, pphi, ppsi]: [f64; 3]) -> f64 {
        let (sine, cosine) = theta.sin_cos();
        let across = (pphi - ppsi * cosine) / sine;
        0.5 * (ptheta * ptheta + across * across + ppsi * ppsi / self.axial) + cosine
    }
}

/// A start at the smallest tilt of the motion.
#[derive(Clone, Copy)]
pub(crate) struct Release {
    /// The cosine of the tilt.
    pub(crate) height: f64,
    /// The angular momentum about the axis.
    pub(crate) spin: f64,
    /// The rate of precession at the start. The top is released at rest if it is zero.
    pub(crate) precession: f64,
}

impl Release {
    /// Returns the initial state.
    pub(crate) fn state(&self) -> Phase<[f64; 3]> {
        Phase::new([self.height.acos(), 0.0, 0.0], [0.0, self.vertical(), self.spin])
    }

    /// Returns the angular momentum about the vertical.
    fn vertical(&self) -> f64 {
        self.spin * self.height + self.precession * (1.0 - self.height * self.height)
    }

    /// Returns the nutation in closed form (Goldstein, Classical Mechanics, section 5.7): `u = cos θ` oscillates between two roots
    /// of the cubic polynomial that `u′²` is.
    pub(crate) fn nutation(&self) -> Nutation {
        let Self { height, spin, precession } = *self;
        // The start is a root. The others are those of 2 u² - sum · u + product.
        let flow = precession * precession * (1.0 - height * height);
        let sum = spin * spin + flow;
        let product = (spin * spin - flow) * height + 2.0 * spin * precession * (1.0 - height * height) - 2.0;
        let beyond = 0.25 * (sum + (sum * sum - 8.0 * product).sqrt());
        let lowest = product / (2.0 * beyond);
        let rate = (0.5 * (beyond - lowest)).sqrt();
        let elliptic = Elliptic::new(((beyond - height) / (beyond - lowest)).sqrt());
        Nutation { release: *self, lowest, rate, elliptic }
    }
}

/// The closed form `u = lowest + (height - lowest) sn²(rate · t + K)`.
pub(crate) struct Nutation {
    release: Release,
    pub(crate) lowest: f64,
    rate: f64,
    elliptic: Elliptic,
}

/// Points of the trapezoidal rule over a period. Its error decreases exponentially, because the precession rate is analytic.
const POINTS: u32 = 128;

impl Nutation {
    /// Returns the period of the nutation.
    pub(crate) fn period(&self) -> f64 {
        2.0 * self.elliptic.quarter_period() / self.rate
    }

    /// Returns the cosine of the tilt at a time.
    pub(crate) fn height(&self, time: f64) -> f64 {
        let sn = self.elliptic.sn(self.rate * (time % self.period()) + self.elliptic.quarter_period());
        self.lowest + (self.release.height - self.lowest) * sn * sn
    }

    /// Returns the precession per nutation: the integral of the precession rate over a period of the closed form.
    pub(crate) fn precession(&self) -> f64 {
        let rate = |point: u32| {
            let u = self.height(self.period() * f64::from(point) / f64::from(POINTS));
            (self.release.vertical() - self.release.spin * u) / (1.0 - u * u)
        };
        (0..POINTS).map(rate).sum::<f64>() * self.period() / f64::from(POINTS)
    }
}

/// Measured quantities of a motion.
pub(crate) struct Motion {
    /// The mean nutation period, and the mean precession per nutation.
    pub(crate) period: f64,
    pub(crate) precession: f64,
    /// The largest errors of `cos θ`, compared with the closed form, and of H.
    pub(crate) height_error: f64,
    pub(crate) energy_error: f64,
}

/// Integrates this number of nutations with step `h`, and compares the state after each step with the closed form.
///
/// # Errors
/// A step has no solution.
pub(crate) fn motion(top: &Top, release: &Release, h: f64, nutations: usize) -> Result<Motion, Error> {
    let nutation = release.nutation();
    let mut run = top.run(release.state(), h)?;
    let energy = run.energy();
    let (mut height_error, mut energy_error) = (0.0_f64, 0.0_f64);
    let steps = (nutations as f64 * nutation.period() / h).ceil() as u64 + 1;
    for sample in run.by_ref().samples(1).take(steps as usize) {
        let sample = sample?;
        height_error = height_error.max((sample.state.q[0].cos() - nutation.height(sample.time)).abs());
        energy_error = energy_error.max((sample.energy() - energy).abs());
    }
    // θ is smallest where its momentum rises through zero.
    let returns = top.run(release.state(), h)?.crossings(steps, Direction::Rising, |state, _| state.p[0]);
    let (mut time, mut angle) = (0.0, 0.0);
    for passage in returns.take(nutations) {
        let passage = passage?;
        (time, angle) = (passage.time, passage.state.q[1]);
    }
    let count = nutations as f64;
    Ok(Motion { period: time / count, precession: angle / count, height_error, energy_error })
}

/// Returns the tilt at the end of the first fall, or that of the start if the top does not rise again within these steps.
///
/// # Errors
/// A step has no solution.
pub(crate) fn largest_tilt(top: &Top, release: &Release, h: f64, steps: u64) -> Result<f64, Error> {
    let mut turns = top.run(release.state(), h)?.crossings(steps, Direction::Falling, |state, _| state.p[0]);
    Ok(turns.next().transpose()?.map_or(release.height.acos(), |turn| turn.state.q[0]))
}
