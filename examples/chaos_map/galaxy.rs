//! The section of the Hénon–Heiles system (1964).

use integrator_core::{
    chaos::{self, Indicator},
    check::CheckError,
    prelude::*,
};

struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

pub(crate) const ENERGY: f64 = 0.125;
const STEP: f64 = 0.2;
const STEPS: u64 = 2_500;

/// Returns the mean MEGNO of the orbits that pass `x = 0` with `p_x > 0` at these `(y, p_y)`. NaN where the energy allows
/// no orbit.
pub(crate) fn megno(places: impl Iterator<Item = (f64, f64)>) -> Result<Vec<f64>, CheckError> {
    let starts: Vec<_> = places
        .map(|(y, py)| {
            let square = 2.0 * ENERGY - py * py - y * y + 2.0 / 3.0 * y.powi(3);
            (square >= 0.0 && y < 1.0).then(|| Phase::new([0.0, y], [square.sqrt(), py]))
        })
        .collect();
    let allowed = starts.iter().flatten().copied();
    let mut found = chaos::map(&HenonHeiles, BlanesMoanSrkn11, allowed, STEP, STEPS, Indicator::Megno)?.into_iter();
    Ok(starts.iter().map(|start| start.and_then(|_| found.next()).unwrap_or(f64::NAN)).collect())
}
