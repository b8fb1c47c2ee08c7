//! An ion in Paul's trap (1953) with hyperbolic electrodes, in Mathieu's units, and where it is held.

use integrator_core::prelude::*;
use std::f64::consts::PI;

/// A trap with a constant and an alternating voltage, which focus in one direction and defocus in the other.
#[derive(Clone, Copy)]
pub(crate) struct PaulTrap {
    /// Parameter of the constant voltage.
    pub(crate) a: f64,
    /// Parameter of the alternating voltage.
    pub(crate) q: f64,
}

#[hamiltonian(compose = BlanesMoanSrkn6)]
impl PaulTrap {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2], t: f64) -> f64 {
        0.5 * (self.a - 2.0 * self.q * (2.0 * t).cos()) * (x * x - y * y)
    }
}

/// Steps per period of the voltage, which is π.
pub(crate) const STEPS: u64 = 32;

/// Returns the traces of the maps of one period in `x` and in `y`, for each trap. Motion is bounded if a trace is between
/// -2 and 2, where both eigenvalues are on the unit circle.
///
/// `x` and `y` are independent, so two initial states give both maps: displaced by 1, and with momentum 1.
pub(crate) fn traces(traps: impl IntoIterator<Item = PaulTrap>) -> Result<Vec<[f64; 2]>, Error> {
    let starts = |trap| [(trap, Phase::new([1.0; 2], [0.0; 2])), (trap, Phase::new([0.0; 2], [1.0; 2]))];
    let mut ions = Ensemble::new(BlanesMoanSrkn6, traps.into_iter().flat_map(starts), PI / STEPS as f64)?;
    ions.advance(STEPS)?;
    let states: Vec<_> = ions.states().collect();
    let traces = states
        .as_chunks()
        .0
        .iter()
        .map(|[displaced, kicked]: &[_; 2]| std::array::from_fn(|axis| displaced.q[axis] + kicked.p[axis]));
    Ok(traces.collect())
}

/// Returns `x` of an ion over some periods of the voltage, which are the unit of time.
pub(crate) fn orbit(trap: PaulTrap, periods: u64) -> Result<Vec<(f64, f64)>, Error> {
    let run = trap.run(Phase::new([1.0, 1.0], [0.0, 0.0]), PI / STEPS as f64)?;
    let samples = run.samples(1).take((periods * STEPS) as usize + 1);
    samples.map(|sample| sample.map(|sample| (sample.time / PI, sample.state.q[0]))).collect()
}

/// Returns whether the trap confines ions, from the traces in both directions.
pub(crate) fn holds([x, y]: [f64; 2]) -> bool {
    x.abs() < 2.0 && y.abs() < 2.0
}

/// Returns the largest stable `q` for `a = 0`, by bisection.
pub(crate) fn edge() -> Result<f64, Error> {
    let (mut held, mut lost) = (0.5, 1.2);
    while lost - held > 1e-12 {
        let q = 0.5 * (held + lost);
        match traces([PaulTrap { a: 0.0, q }])?.into_iter().all(holds) {
            true => held = q,
            false => lost = q,
        }
    }
    Ok(held)
}
