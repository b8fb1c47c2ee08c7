//! The damped and driven oscillator of Duffing: its states once per period of the drive, the contraction of areas, and Lyapunov
//! exponents.

use integrator_core::{
    chaos::{Spectrum, lyapunov_spectrum},
    check::CheckError,
    prelude::*,
};
use std::f64::consts::TAU;

/// `x'' + δ x' - x + x³ = drive · cos(ω t)`.
#[derive(Clone, Copy)]
pub(crate) struct Duffing {
    pub(crate) drive: f64,
}

/// Rate of the friction, and frequency of the drive.
pub(crate) const DELTA: f64 = 0.3;
const OMEGA: f64 = 1.2;

#[hamiltonian(split = kinetic + potential + friction)]
impl Duffing {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, x: [f64; 1], t: f64) -> f64 {
        0.25 * x[0].powi(4) - 0.5 * x[0] * x[0] - self.drive * x[0] * (OMEGA * t).cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        DELTA
    }
}

/// Period of the drive, and the number of steps in it.
pub(crate) const PERIOD: f64 = TAU / OMEGA;
pub(crate) const STEPS: u64 = 200;
const STEP: f64 = PERIOD / STEPS as f64;

/// Returns the state after some periods.
pub(crate) fn settled(system: Duffing, x: f64, periods: u64) -> Result<Phase<[f64; 1]>, Error> {
    let mut run = system.run(Phase::new([x], [0.0]), STEP)?;
    run.advance(periods * STEPS)?;
    Ok(run.state())
}

/// Returns `(x, x')` of many oscillators from different starts, once per period of the drive, after `forgotten` periods.
pub(crate) fn section(
    system: Duffing,
    oscillators: u32,
    forgotten: u64,
    periods: u64,
) -> Result<Vec<(f64, f64)>, Error> {
    let starts = (0..oscillators).map(|i| Phase::new([f64::from(i) / f64::from(oscillators)], [0.0]));
    let mut ensemble = Ensemble::new(Baoab, starts.map(|start| (system, start)), STEP)?;
    ensemble.advance(forgotten * STEPS)?;
    let mut points = Vec::new();
    for _ in 0..periods {
        ensemble.advance(STEPS)?;
        points.extend(ensemble.states().map(|state| (state.q[0], state.p[0])));
    }
    Ok(points)
}

/// Returns the factor by which areas near a state shrink in some periods, from the derivative of the steps.
pub(crate) fn contraction(system: Duffing, state: Phase<[f64; 1]>, periods: u64) -> Result<f64, Error> {
    let units = [Phase::new([1.0], [0.0]), Phase::new([0.0], [1.0])];
    let mut tangent = system.tangent(Baoab, state, units, STEP)?;
    tangent.advance(periods * STEPS)?;
    let vectors = tangent.vectors();
    Ok(vectors[0].q[0] * vectors[1].p[0] - vectors[0].p[0] * vectors[1].q[0])
}

/// Returns both Lyapunov exponents with their uncertainties, from a state at the beginning of a period.
pub(crate) fn exponents(system: Duffing, state: Phase<[f64; 1]>, periods: u64) -> Result<Spectrum, CheckError> {
    lyapunov_spectrum(&system, Baoab, state, STEP, periods * STEPS)
}

/// Returns the dimension of an attractor from its exponents (Kaplan and Yorke 1979).
pub(crate) fn dimension([positive, negative]: [f64; 2]) -> f64 {
    1.0 - positive / negative
}
