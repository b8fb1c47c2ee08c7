//! The slow precession of the orbits of the outer planets: eccentricities, inclinations and their frequencies.

use super::planets::{
    Planets,
    system::{Bodies, GRAVITY, angular_momentum, measured, norm},
};
use integrator_core::{
    chaos::{Line, frequencies},
    orbit::{Elements, Frame, elements},
    prelude::*,
};
use std::error::Error;

/// Length of a year in days.
const YEAR: f64 = 365.25;

/// Step in days: a tenth of Jupiter's period.
const STEP: f64 = 433.0;

/// Steps between samples: 304 years. The shortest secular period is 46,000 years.
const EVERY: u64 = 256;

/// Arc seconds of a radian.
const ARC_SECONDS: f64 = 648_000.0 / std::f64::consts::PI;

/// Terms of each variable.
const TERMS: usize = 8;

/// Frequencies in arc seconds per year: `g5` to `g8` of the perihelia, and `s6` to `s8` of the nodes, with their names.
pub(crate) type Fundamental = [(&'static str, f64); 7];

/// Frequencies of the solar system with all planets and relativity (Laskar and others 2004, Astronomy and Astrophysics 428, 261).
pub(crate) const PUBLISHED: Fundamental =
    [("g5", 4.257), ("g6", 28.245), ("g7", 3.088), ("g8", 0.673), ("s6", -26.348), ("s7", -2.993), ("s8", -0.692)];

/// Integrates the planets over a number of samples and returns their frequencies, and the time in years.
pub(crate) fn fundamental(samples: usize) -> Result<(Fundamental, f64), Box<dyn Error>> {
    let (system, start) = measured()?;
    let masses = system.masses;
    let start = in_invariable_plane(start);
    // For each of Jupiter, Saturn, Uranus and Neptune: `e exp(iϖ)` and `sin(i/2) exp(iΩ)`.
    let mut variables = vec![Vec::new(); 8];
    for sample in Planets(system).run_with(Verlet, start, STEP)?.samples(EVERY).take(samples) {
        let found = elements(Frame::Jacobi, GRAVITY, &masses, &sample?.state)?;
        for (planet, orbit) in found[..4].iter().enumerate() {
            let [eccentricity, inclination] = secular_variables(orbit);
            variables[planet].push(eccentricity);
            variables[4 + planet].push(inclination);
        }
    }
    let interval = STEP * EVERY as f64 / YEAR;
    let found: Vec<Vec<Line>> =
        variables.iter().map(|variable| frequencies(variable, interval, TERMS)).collect::<Result<_, _>>()?;
    let main = |variable: usize| found[variable].first().map_or(f64::NAN, |line| ARC_SECONDS * line.frequency);
    let g5 = main(0);
    // The largest term of Uranus is Jupiter's. Both are more than a second apart.
    let of_uranus =
        found[2].iter().map(|line| ARC_SECONDS * line.frequency).find(|frequency| (frequency - g5).abs() > 0.5);
    let values = [g5, main(1), of_uranus.unwrap_or(f64::NAN), main(3), main(5), main(6), main(7)];
    let mut fundamental = PUBLISHED;
    for ((_, frequency), value) in fundamental.iter_mut().zip(values) {
        *frequency = value;
    }
    Ok((fundamental, interval * (samples - 1) as f64))
}

/// Returns `e exp(iϖ)` and `sin(i/2) exp(iΩ)` of an orbit.
fn secular_variables(orbit: &Elements) -> [[f64; 2]; 2] {
    let longitude = orbit.node + orbit.argument;
    let (e, slope) = (orbit.eccentricity, (orbit.inclination / 2.0).sin());
    [[e * longitude.cos(), e * longitude.sin()], [slope * orbit.node.cos(), slope * orbit.node.sin()]]
}

/// Turns a state so that its angular momentum points along the third axis.
fn in_invariable_plane(state: Phase<Bodies>) -> Phase<Bodies> {
    let momentum = angular_momentum(&state);
    let third = momentum.map(|component| component / norm(&momentum));
    let [x, y, z] = third;
    // Perpendicular to the third axis and to the first one of the table.
    let second = [0.0, z, -y].map(|component| component / z.hypot(y));
    let first = [second[1] * z - second[2] * y, second[2] * x - second[0] * z, second[0] * y - second[1] * x];
    let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|d| a[d] * b[d]).sum::<f64>();
    let turned = |bodies: Bodies| bodies.map(|body| [first, second, third].map(|axis| dot(axis, body)));
    Phase::new(turned(state.q), turned(state.p))
}
