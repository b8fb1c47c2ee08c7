//! The comet, the giant planets, and the dates of perihelion.

use super::system::{GRAVITY, measured};
use integrator_core::{
    orbit::{Anomaly, Elements, OrbitError},
    prelude::*,
};
use std::error::Error;

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
pub(crate) fn start() -> Result<(Solar, Phase<Bodies>), Box<dyn Error>> {
    let (planets, state) = measured()?;
    let mut masses = [COMET_MASS; 7];
    masses[..6].copy_from_slice(&planets.masses);
    let mut start = Phase::new([[0.0; 3]; 7], [[0.0; 3]; 7]);
    start.q[..6].copy_from_slice(&state.q);
    start.p[..6].copy_from_slice(&state.p);
    let [position, velocity] = from_elements()?;
    for d in 0..3 {
        start.q[COMET][d] = start.q[0][d] + position[d];
        start.p[COMET][d] = COMET_MASS * (start.p[0][d] / masses[0] + velocity[d]);
    }
    Ok((Solar { masses }, start))
}

/// Returns position and velocity of the comet relative to the Sun on the day of the table, in equatorial coordinates.
fn from_elements() -> Result<[[f64; 3]; 2], OrbitError> {
    let [distance, eccentricity, inclination, node, argument, perihelion] = ELEMENTS;
    let comet = Elements {
        inclination: inclination.to_radians(),
        node: node.to_radians(),
        argument: argument.to_radians(),
        anomaly: Anomaly::SincePericentre(BEGIN - perihelion),
        ..Elements::with_pericentre(distance, eccentricity)
    };
    let (sine, cosine) = OBLIQUITY.to_radians().sin_cos();
    Ok(comet.state(GRAVITY)?.map(|[x, y, z]| [x, cosine * y - sine * z, sine * y + cosine * z]))
}

/// Returns position and velocity of the comet relative to the Sun.
pub(crate) fn relative(system: &Solar, state: &Phase<Bodies>) -> [[f64; 3]; 2] {
    let velocity = |body: usize, d: usize| state.p[body][d] / system.masses[body];
    [
        std::array::from_fn(|d| state.q[COMET][d] - state.q[0][d]),
        std::array::from_fn(|d| velocity(COMET, d) - velocity(0, d)),
    ]
}

/// Returns the osculating elements of the orbit of the comet around the Sun.
pub(crate) fn osculating(system: &Solar, state: &Phase<Bodies>) -> Result<Elements, OrbitError> {
    let [position, velocity] = relative(system, state);
    Elements::from_state(position, velocity, GRAVITY * system.masses[0])
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
