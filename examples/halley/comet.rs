//! The comet, the giant planets, and the dates of perihelion.

use super::system::{GRAVITY, measured};
use integrator_core::prelude::*;
use std::{error::Error, num::ParseFloatError};

/// Positions or momenta: the Sun with the inner planets, Jupiter, Saturn, Uranus, Neptune, Pluto, and the comet.
pub(crate) type Bodies = [[f64; 3]; 7];

/// Index of the comet in lists of bodies.
pub(crate) const COMET: usize = 6;

/// Mass of the comet in solar masses: 2.2e14 kg (Rickman 1989).
const COMET_MASS: f64 = 1.1e-16;

/// Julian day of the table of planets, 5 September 1994.
pub(crate) const BEGIN: f64 = 2_449_600.5;

/// Orbit of the comet on 17 February 1994, JD 2449400.5, ecliptic and equinox of J2000 (JPL, solution J863/77): perihelion
/// distance in AU, eccentricity, inclination, node and argument of the perihelion in degrees, and the Julian day of the
/// perihelion.
const ELEMENTS: [f64; 6] = [0.585_978_11, 0.967_142_91, 162.262_69, 58.420_08, 111.332_49, 2_446_467.395_32];

/// Angle between equator and ecliptic of J2000, in degrees.
const OBLIQUITY: f64 = 23.439_291_1;

/// Observed perihelia and the next predicted one (Yeomans and Kiang 1981, Mon. Not. R. Astron. Soc. 197, 633), as Julian
/// days.
pub(crate) const KNOWN: [(i32, f64); 5] =
    [(1759, 2_363_592.56), (1835, 2_391_598.94), (1910, 2_418_781.68), (1986, 2_446_470.96), (2061, 2_474_034.4)];

pub(crate) struct Solar {
    /// Masses in solar masses.
    masses: [f64; 7],
}

#[hamiltonian]
impl Solar {
    /// `Σ |pᵢ|² / 2mᵢ`
    fn kinetic(&self, p: &[[f64; 3]; 7]) -> f64 {
        (0..7).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.masses[i])).sum()
    }

    /// `-Σ G mᵢ mⱼ / |qᵢ - qⱼ|` over all pairs
    fn potential(&self, q: &[[f64; 3]; 7]) -> f64 {
        let mut energy = 0.0;
        for i in 0..7 {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= GRAVITY * self.masses[i] * self.masses[j] / square.sqrt();
            }
        }
        energy
    }

    /// Returns the angular velocity of a circular orbit at the distance of the comet, up to a factor.
    fn rate(&self, q: &[[f64; 3]; 7]) -> f64 {
        let square = (0..3).map(|d| (q[6][d] - q[0][d]).powi(2)).sum::<f64>();
        square.powf(-0.75)
    }
}

/// Returns the system and its state on the day of the table.
pub(crate) fn start() -> Result<(Solar, Phase<Bodies>), ParseFloatError> {
    let (planets, state) = measured()?;
    let mut masses = [COMET_MASS; 7];
    masses[..6].copy_from_slice(&planets.masses);
    let mut start = Phase::new([[0.0; 3]; 7], [[0.0; 3]; 7]);
    start.q[..6].copy_from_slice(&state.q);
    start.p[..6].copy_from_slice(&state.p);
    let (position, velocity) = from_elements();
    for d in 0..3 {
        start.q[COMET][d] = start.q[0][d] + position[d];
        start.p[COMET][d] = COMET_MASS * (start.p[0][d] / masses[0] + velocity[d]);
    }
    Ok((Solar { masses }, start))
}

/// Returns position and velocity of the comet relative to the Sun on the day of the table, in equatorial coordinates.
fn from_elements() -> ([f64; 3], [f64; 3]) {
    let [distance, e, inclination, node, argument, perihelion] = ELEMENTS;
    let axis = distance / (1.0 - e);
    let motion = (GRAVITY / axis.powi(3)).sqrt();
    // Kepler's equation by Newton's method.
    let mean = motion * (BEGIN - perihelion);
    let mut u = mean + e * mean.sin();
    for _ in 0..40 {
        u -= (u - e * u.sin() - mean) / (1.0 - e * u.cos());
    }
    let minor = axis * (1.0 - e * e).sqrt();
    let rate = motion / (1.0 - e * u.cos());
    let in_plane = [[axis * (u.cos() - e), minor * u.sin()], [-axis * u.sin() * rate, minor * u.cos() * rate]];
    let turned = |[x, y]: [f64; 2]| {
        let point = about_z([x, y, 0.0], argument);
        let point = about_z(about_x(point, inclination), node);
        about_x(point, OBLIQUITY)
    };
    let [position, velocity] = in_plane.map(turned);
    (position, velocity)
}

/// Rotates a vector by an angle in degrees.
fn about_x([x, y, z]: [f64; 3], degrees: f64) -> [f64; 3] {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    [x, cosine * y - sine * z, sine * y + cosine * z]
}

fn about_z([x, y, z]: [f64; 3], degrees: f64) -> [f64; 3] {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y, z]
}

/// Returns position and velocity of the comet relative to the Sun.
pub(crate) fn relative(system: &Solar, state: &Phase<Bodies>) -> [[f64; 3]; 2] {
    let velocity = |body: usize, d: usize| state.p[body][d] / system.masses[body];
    [
        std::array::from_fn(|d| state.q[COMET][d] - state.q[0][d]),
        std::array::from_fn(|d| velocity(COMET, d) - velocity(0, d)),
    ]
}

/// Returns the osculating semi-major axis in AU and the eccentricity of the comet.
pub(crate) fn axis_and_eccentricity(system: &Solar, state: &Phase<Bodies>) -> [f64; 2] {
    let [q, v] = relative(system, state);
    let pull = GRAVITY * system.masses[0];
    let [square, speed, radial] = [dot(q, q), dot(v, v), dot(q, v)];
    let axis = 1.0 / (2.0 / square.sqrt() - speed / pull);
    let along = 1.0 - square.sqrt() / axis;
    [axis, (along * along + radial * radial / (pull * axis)).sqrt()]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns a run whose time is the Julian day. Steps are about `h` half days at the perihelion and `200 h` at the aphelion.
pub(crate) fn run(system: &Solar, start: Phase<Bodies>, h: f64) -> Result<Run<Bodies>, integrator_core::Error> {
    Ok(system.run_with(Paced(SofroniouSpaletta8), start, h)?.at_time(BEGIN))
}

/// Returns the Julian days of perihelion between two dates.
pub(crate) fn perihelia(
    system: &Solar,
    start: Phase<Bodies>,
    [first, last]: [f64; 2],
) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut days = Vec::new();
    // Backwards in time, a minimum has the opposite direction of crossing.
    for (h, direction, until) in [(1.0, Direction::Rising, last), (-1.0, Direction::Falling, first)] {
        let approach = |state: &Phase<Bodies>, _: f64| {
            let [q, v] = relative(system, state);
            dot(q, v)
        };
        for perihelion in run(system, start, h)?.crossings(1 << 16, direction, approach) {
            let day = perihelion?.time;
            if (day - until) * h > 0.0 {
                break;
            }
            days.push(day);
        }
    }
    Ok(days)
}

/// Approximate period of the comet, in days.
pub(crate) const REVOLUTION: f64 = 76.0 * 365.25;
