//! Model problems, on which some claims of the course are measured: the oscillator, Kepler's ellipse and a stiff equation. They are the
//! same for all systems.

use crate::{
    adaptive::{Ellipse, ellipse},
    gear::{Gear, gear},
    linear::{Linear, linear},
    multistep::{Multistep, multistep},
    radius::{Radius, radius},
};
use integrator_core::prelude::*;
use std::sync::OnceLock;

/// The oscillator of frequency 1, on which a step of a method is a matrix.
#[derive(Clone, Copy)]
pub(crate) struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

/// A planet with a mass of one.
#[derive(Clone, Copy)]
pub(crate) struct Kepler;

#[hamiltonian(taylor)]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

/// The eccentricity of the planet's orbit, whose semi-major axis is 1.
pub(crate) const ECCENTRICITY: f64 = 0.8;

/// The planet where it is farthest from the centre, for `side = 1`, or nearest, for −1.
pub(crate) fn apsis(side: f64) -> Phase<[f64; 2]> {
    let e = side * ECCENTRICITY;
    Phase::new([1.0 + e, 0.0], [0.0, ((1.0 - e) / (1.0 + e)).sqrt()])
}

/// What is measured on the model problems; none where a method comes to no end.
#[derive(Clone, Debug)]
pub(crate) struct Models {
    pub(crate) linear: Option<Linear>,
    pub(crate) multistep: Option<Multistep>,
    pub(crate) ellipse: Option<Ellipse>,
    pub(crate) radius: Option<Radius>,
    pub(crate) gear: Gear,
}

/// Measures the methods on the model problems, once for all pages.
pub(crate) fn models() -> Models {
    static MODELS: OnceLock<Models> = OnceLock::new();
    let measure =
        || Models { linear: linear(), multistep: multistep(), ellipse: ellipse(), radius: radius(), gear: gear() };
    MODELS.get_or_init(measure).clone()
}
