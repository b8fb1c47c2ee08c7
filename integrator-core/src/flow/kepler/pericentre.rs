//! Kepler motion since the pericentre, in units in which the distance of the pericentre and the gravitational parameter are 1.
//!
//! There `η = 0`, `β = 1 - e` and `ζ = e`, so that no formula is a difference of numbers that are nearly equal, on any conic.

use super::{
    stumpff::{functions, shifted},
    universal::{Orbit, Root, root},
};
#[cfg(not(feature = "std"))]
use crate::scalar::elementary::Elementary;

/// Returns position and velocity, `[x, y, ẋ, ẏ]` with x towards the pericentre, a time after it. On an ellipse, the time is at most
/// half a period. `None` if Kepler's equation could not be solved.
pub(crate) fn state_since(eccentricity: f64, time: f64) -> Option<[f64; 4]> {
    let beta = 1.0 - eccentricity;
    let orbit = Orbit { mu: 1.0, distance: 1.0, eta: 0.0, beta, zeta: eccentricity, time };
    let Root { place, d, failed, .. } = root(&orbit, 1.0);
    let [first, second, _] = shifted(place.functions, beta, d);
    let distance = 1.0 + eccentricity * second;
    let speed = (1.0 + eccentricity).sqrt();
    let state = [1.0 - second, first * speed, -first / distance, (1.0 - beta * second) * speed / distance];
    (!failed && state.iter().all(|number| number.is_finite())).then_some(state)
}

/// Returns the time since the pericentre at a value of the universal variable.
pub(crate) fn time_at(eccentricity: f64, s: f64) -> f64 {
    let [_, _, _, third] = functions(1.0 - eccentricity, s);
    s + eccentricity * third
}
