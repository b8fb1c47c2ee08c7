//! Asteroids inside Jupiter's orbit, attracted by Jupiter on a circle.

use crate::asteroid::{Asteroid, JUPITER};
use integrator_core::{
    chaos::{self, Indicator},
    check::CheckError,
    prelude::*,
};

/// Jupiter's distance in astronomical units.
pub(crate) const DISTANCE: f64 = 5.2044;

/// Step size: 157 steps per period of Jupiter.
const STEP: f64 = 0.04;
const STEPS: u64 = 12_000;

/// Initial state of an asteroid at its perihelion, in the direction of Jupiter, from the semi-major axis in AU and the
/// eccentricity.
fn start((axis, eccentricity): (f64, f64)) -> Phase<[f64; 2]> {
    let distance = axis / DISTANCE * (1.0 - eccentricity);
    let speed = ((1.0 - JUPITER) * (1.0 + eccentricity) / distance).sqrt();
    Phase::new([distance - JUPITER, 0.0], [0.0, speed - JUPITER])
}

/// Returns the mean MEGNO of asteroids with these semi-major axes and eccentricities.
pub(crate) fn megno(places: impl Iterator<Item = (f64, f64)>) -> Result<Vec<f64>, CheckError> {
    chaos::map(&Asteroid, Aba864, places.map(start), STEP, STEPS, Indicator::Megno)
}

/// Returns the semi-major axes of resonances by Kepler's third law.
pub(crate) fn resonances() -> [f64; 6] {
    let axis = |(own, of_jupiter): (f64, f64)| DISTANCE * (of_jupiter / own).powf(2.0 / 3.0);
    [(3.0, 1.0), (5.0, 2.0), (7.0, 3.0), (2.0, 1.0), (3.0, 2.0), (4.0, 3.0)].map(axis)
}
