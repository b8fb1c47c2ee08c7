//! Jupiter with its four large moons, the Sun and the other outer planets. Units: astronomical units, days and solar masses.

use super::system::{GRAVITY, measured};
use integrator_core::{
    orbit::{Anomaly, Elements, Frame, OrbitError, elements, state},
    prelude::*,
};
use std::error::Error;

/// Positions or momenta: Jupiter, Io, Europa, Ganymede, Callisto, the Sun with the inner planets, Saturn, Uranus, Neptune, Pluto.
pub(crate) type Bodies = [[f64; 3]; 10];

/// Kilometres of an astronomical unit.
const UNIT: f64 = 149_597_870.7;

/// Gravitational parameters in km³/s²: of the Sun (DE440), and of Jupiter and its moons (JPL Solar System Dynamics).
const SUN: f64 = 132_712_440_041.279_42;
const JUPITER: f64 = 126_686_531.9;
const MOONS: [f64; 4] = [5_959.915_5, 3_202.712_1, 9_887.832_8, 7_179.283_4];

/// Second zonal harmonic of Jupiter, and the radius to which it refers, in km (JUP310 of JPL).
const OBLATENESS: f64 = 0.014_696_43;
const RADIUS: f64 = 71_492.0;

/// Right ascension and declination of Jupiter's pole in degrees.
const POLE: [f64; 2] = [268.057, 64.495];

/// Orbits of the moons relative to Jupiter at J2000, in the plane of its equator: semi-major axis in km, eccentricity, argument of the
/// pericentre, mean anomaly, inclination and node in degrees (Paita, Celletti and Pucacco 2018, Astronomy and Astrophysics 617, A35,
/// table 3).
const ELEMENTS: [[f64; 6]; 4] = [
    [422_038.829_62, 4.720_818_035e-3, 161.680_785_67, 335.182_211_13, 0.037_583_969, 243.077_404_01],
    [671_252.502_27, 9.818_535_762e-3, 48.941_393_24, 345.420_028_54, 0.462_242_250, 180.097_764_70],
    [1_070_503.757_06, 1.457_932_049e-3, 231.605_801_30, 277.276_637_36, 0.206_867_788, 72.912_129_53],
    [1_882_783.985_80, 7.439_860_903e-3, 197.547_117_27, 85.074_032_87, 0.199_646_043, 158.336_296_81],
];

/// The observed periods of the moons in days.
pub(crate) const PERIODS: [f64; 4] = [1.769_138, 3.551_181, 7.154_553, 16.689_017];

/// Masses of Jupiter, its moons, the Sun and the planets, in solar masses.
#[derive(Clone, Copy)]
pub(crate) struct Masses([f64; 10]);

/// A Hamiltonian of the same energies, in parts or as one potential.
macro_rules! jupiter {
    ($(#[$words:meta])* $name:ident ($($arguments:tt)*): $($potential:tt)*) => {
        $(#[$words])*
        pub(crate) struct $name(pub(crate) Masses);

        #[hamiltonian($($arguments)*)]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]; 10]) -> f64 {
                (0..10).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.0.0[i])).sum()
            }
            /// Jupiter, which is oblate, and its moons.
            fn near(&self, q: &[[f64; 3]; 10]) -> f64 {
                let mut energy = 0.0;
                for i in 1..5 {
                    let [x, y, z] = [q[i][0] - q[0][0], q[i][1] - q[0][1], q[i][2] - q[0][2]];
                    let square = x * x + y * y + z * z;
                    let oblate = OBLATENESS * (RADIUS / UNIT).powi(2) * (1.5 * z * z / square - 0.5) / square;
                    energy -= GRAVITY * self.0.0[0] * self.0.0[i] / square.sqrt() * (1.0 - oblate);
                    for j in 1..i {
                        let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                        energy -= GRAVITY * self.0.0[i] * self.0.0[j] / (x * x + y * y + z * z).sqrt();
                    }
                }
                energy
            }
            /// The Sun and the planets, with all other bodies.
            fn far(&self, q: &[[f64; 3]; 10]) -> f64 {
                let mut energy = 0.0;
                for i in 5..10 {
                    for j in 0..i {
                        let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                        energy -= GRAVITY * self.0.0[i] * self.0.0[j] / (x * x + y * y + z * z).sqrt();
                    }
                }
                energy
            }
            $($potential)*
        }
    };
}

jupiter!(
    /// Moons in inner steps of the fourth order, and the Sun and the planets in outer steps.
    Moons(split = far + 4 * BlanesMoan4(near + kinetic)):
);
jupiter!(
    /// All forces in steps of one length.
    Together():
    fn potential(&self, q: &[[f64; 3]; 10]) -> f64 {
        self.near(q) + self.far(q)
    }
);

/// Returns the orbits of the moons.
fn orbits() -> [Elements; 4] {
    ELEMENTS.map(|[axis, eccentricity, argument, anomaly, inclination, node]| Elements {
        inclination: inclination.to_radians(),
        node: node.to_radians(),
        argument: argument.to_radians(),
        anomaly: Anomaly::Mean(anomaly.to_radians()),
        ..Elements::with_axis(axis / UNIT, eccentricity)
    })
}

/// Rotates a vector of equatorial coordinates: the third axis is Jupiter's pole, and the first one is where Jupiter's equator rises
/// above that of the Earth.
fn to_jupiters_equator([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [(sine, cosine), (up, along)] = POLE.map(|angle| angle.to_radians().sin_cos());
    let [node, across] = [cosine * y - sine * x, cosine * x + sine * y];
    [node, along * z - up * across, along * across + up * z]
}

/// Returns the masses and the state: the moons at J2000, and the planets of the table of the outer solar system, on 5 September 1994.
/// The moons hardly depend on where the Sun and the planets are.
pub(crate) fn start() -> Result<(Masses, Phase<Bodies>), Box<dyn Error>> {
    let (planets, at_table) = measured()?;
    let mut masses = [0.0; 10];
    masses[0] = JUPITER / SUN;
    masses[1..5].copy_from_slice(&MOONS.map(|moon| moon / SUN));
    masses[5] = planets.masses[0];
    masses[6..].copy_from_slice(&planets.masses[2..]);
    let moons: Phase<[[f64; 3]; 5]> = state(Frame::Heliocentric, GRAVITY, &masses[..5], &orbits())?;
    let mut start = Phase::new([[0.0; 3]; 10], [[0.0; 3]; 10]);
    for body in 0..10 {
        // The table has the barycentre of Jupiter and its moons.
        let row = [1, 1, 1, 1, 1, 0, 2, 3, 4, 5][body];
        start.q[body] = to_jupiters_equator(at_table.q[row]);
        start.p[body] = to_jupiters_equator(at_table.p[row]).map(|p| p / planets.masses[row] * masses[body]);
    }
    for (body, d) in (0..5).flat_map(|body| [0, 1, 2].map(|d| (body, d))) {
        start.q[body][d] += moons.q[body][d];
        start.p[body][d] += moons.p[body][d];
    }
    Ok((Masses(masses), start))
}

/// Returns the mean longitudes of the moons around Jupiter in degrees.
pub(crate) fn longitudes(Masses(masses): &Masses, state: &Phase<Bodies>) -> Result<[f64; 4], OrbitError> {
    let mut near = Phase::new([[0.0; 3]; 5], [[0.0; 3]; 5]);
    near.q.copy_from_slice(&state.q[..5]);
    near.p.copy_from_slice(&state.p[..5]);
    let orbits = elements(Frame::Heliocentric, GRAVITY, &masses[..5], &near)?;
    let mut longitudes = [0.0; 4];
    for ((longitude, orbit), mass) in longitudes.iter_mut().zip(orbits).zip(&masses[1..5]) {
        let anomaly = orbit.mean_anomaly(GRAVITY * (masses[0] + mass))?;
        *longitude = (orbit.node + orbit.argument + anomaly).to_degrees();
    }
    Ok(longitudes)
}

/// Mean longitudes of the moons over some days.
pub(crate) struct Course {
    /// Mean period of each moon in days.
    pub(crate) periods: [f64; 4],
    /// Least, mean and largest angle of Laplace, `λ₁ - 3 λ₂ + 2 λ₃` of Io, Europa and Ganymede, in degrees.
    pub(crate) laplace: [f64; 3],
}

/// Integrates for a number of days, in steps of `h` of at most half a day, and samples the longitudes after each step.
pub(crate) fn course(moons: &Moons, start: Phase<Bodies>, h: f64, days: f64) -> Result<Course, Box<dyn Error>> {
    let mut before = longitudes(&moons.0, &start)?;
    let (mut degrees, mut angles) = ([0.0; 4], Vec::new());
    let steps = (days / h).round() as usize;
    for sample in moons.run(start, h)?.samples(1).skip(1).take(steps) {
        let now = longitudes(&moons.0, &sample?.state)?;
        for (sum, (now, before)) in degrees.iter_mut().zip(now.into_iter().zip(before)) {
            *sum += (now - before).rem_euclid(360.0);
        }
        angles.push((now[0] - 3.0 * now[1] + 2.0 * now[2]).rem_euclid(360.0));
        before = now;
    }
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = angles.iter().copied().fold(0.0, f64::max);
    let mean = angles.iter().sum::<f64>() / angles.len() as f64;
    Ok(Course { periods: degrees.map(|sum| 360.0 * steps as f64 * h / sum), laplace: [least, mean, largest] })
}
