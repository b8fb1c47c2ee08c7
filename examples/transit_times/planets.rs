//! A star with four planets in one plane, their transits, and the sum of the squares of the misses of measured transit times.

use integrator_core::{Gradient, Sample, prelude::*};
use std::{cell::RefCell, f64::consts::TAU};

/// The gravitational constant in au³ / (day² solar masses).
const GRAVITY: f64 = 2.959_122_082_855_911e-4;
/// The number of planets.
pub(crate) const PLANETS: usize = 4;
/// The step in days.
pub(crate) const STEP: f64 = 0.02;
/// The number of steps between two looks for transits.
const INTERVAL: u64 = 4;

/// Positions, or momenta, of the star and the planets.
pub(crate) type Bodies = [[f64; 2]; PLANETS + 1];

/// The masses of the planets, in masses of the star.
pub(crate) struct System {
    pub(crate) b: f64,
    pub(crate) c: f64,
    pub(crate) d: f64,
    pub(crate) e: f64,
}

#[hamiltonian(sensitive(b, c, d, e), compose = BlanesMoanSrkn11)]
impl System {
    fn kinetic(&self, p: &[[f64; 2]; 5]) -> f64 {
        let masses = [1.0, self.b, self.c, self.d, self.e];
        let mut energy = 0.0;
        for i in 0..5 {
            energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 2]; 5]) -> f64 {
        let masses = [1.0, self.b, self.c, self.d, self.e];
        let mut energy = 0.0;
        for i in 0..5 {
            for j in 0..i {
                let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                energy -= GRAVITY * masses[i] * masses[j] / (x * x + y * y).sqrt();
            }
        }
        energy
    }
}

impl System {
    /// The masses of the planets.
    pub(crate) fn masses(&self) -> [f64; PLANETS] {
        [self.b, self.c, self.d, self.e]
    }

    /// The system of these masses.
    pub(crate) fn of([b, c, d, e]: [f64; PLANETS]) -> Self {
        Self { b, c, d, e }
    }
}

/// The orbit of a planet around the star at time 0, and its mass.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Orbit {
    /// The mean longitude in radians; 0 is at the transit.
    pub(crate) longitude: f64,
    /// The period in days.
    pub(crate) period: f64,
    /// The eccentricity times the cosine and the sine of the longitude of the pericentre.
    pub(crate) eccentricity: [f64; 2],
    /// The natural logarithm of the mass in masses of the star.
    pub(crate) mass: f64,
}

impl Orbit {
    /// Position and velocity relative to the star, by Kepler's equation in equinoctial elements.
    fn state(&self) -> ([f64; 2], [f64; 2]) {
        let [k, h] = self.eccentricity;
        let parameter = GRAVITY * (1.0 + self.mass.exp());
        let (rate, beta) = (TAU / self.period, 1.0 / (1.0 + (1.0 - k * k - h * h).sqrt()));
        let axis = (parameter / (rate * rate)).cbrt();
        let mut anomaly = self.longitude;
        // Newton's method: the error is squared by each of these, and begins at the eccentricity.
        for _ in 0..8 {
            let (sin, cos) = anomaly.sin_cos();
            anomaly -= (anomaly - k * sin + h * cos - self.longitude) / (1.0 - k * cos - h * sin);
        }
        let (sin, cos) = anomaly.sin_cos();
        let distance = 1.0 - k * cos - h * sin;
        let speed = axis * rate / distance;
        let x = axis * ((1.0 - h * h * beta) * cos + h * k * beta * sin - k);
        let y = axis * ((1.0 - k * k * beta) * sin + h * k * beta * cos - h);
        let vx = speed * (h * k * beta * cos - (1.0 - h * h * beta) * sin);
        let vy = speed * ((1.0 - k * k * beta) * cos - h * k * beta * sin);
        // The line of sight is along y: a planet transits where x changes its sign from minus to plus.
        ([y, -x], [vy, -vx])
    }
}

/// The start of a run from orbits, with its centre of mass at rest at the origin.
pub(crate) fn start(orbits: &[Orbit; PLANETS]) -> (System, Phase<Bodies>) {
    let masses = orbits.map(|orbit| orbit.mass.exp());
    let (mut q, mut p): (Bodies, Bodies) = Default::default();
    let total = 1.0 + masses.iter().sum::<f64>();
    for direction in 0..2 {
        let states = orbits.map(|orbit| orbit.state());
        let mean =
            |of: &dyn Fn(usize) -> f64| (0..PLANETS).map(|planet| masses[planet] * of(planet)).sum::<f64>() / total;
        let centre = mean(&|planet| states[planet].0[direction]);
        let drift = mean(&|planet| states[planet].1[direction]);
        (q[0][direction], p[0][direction]) = (-centre, -drift);
        for planet in 0..PLANETS {
            q[planet + 1][direction] = states[planet].0[direction] - centre;
            p[planet + 1][direction] = masses[planet] * (states[planet].1[direction] - drift);
        }
    }
    (System::of(masses), Phase::new(q, p))
}

/// A measured transit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transit {
    pub(crate) planet: usize,
    /// The time in days.
    pub(crate) time: f64,
}

/// All transits in this number of steps, in the order of their times.
pub(crate) fn transits(system: &System, start: Phase<Bodies>, steps: u64) -> Result<Vec<Transit>, Error> {
    let mut found = Vec::new();
    for planet in 0..PLANETS {
        let across = |state: &Phase<Bodies>, _| state.q[planet + 1][0] - state.q[0][0];
        let run = system.run(start, STEP)?;
        for crossing in run.crossings(steps, Direction::Rising, across) {
            let crossing = crossing?;
            if crossing.state.q[planet + 1][1] < crossing.state.q[0][1] {
                found.push(Transit { planet, time: crossing.time });
            }
        }
    }
    found.sort_by(|a, b| a.time.total_cmp(&b.time));
    Ok(found)
}

/// The sum of the squares of the misses of measured transits in units of their errors, and its derivatives with respect to the
/// start and to the masses.
///
/// A planet at the horizontal distance `x` from the star, with the velocity `v`, passes it after the time `-x/v`: the sample next to
/// a transit tells its time. The error is about the square of the mean motion times the cube of half an interval: 2 s.
pub(crate) fn misses(
    system: &System,
    start: Phase<Bodies>,
    measured: &[Transit],
    error: f64,
) -> Result<(Gradient<Bodies>, [f64; PLANETS]), Error> {
    let masses = [1.0, system.b, system.c, system.d, system.e];
    // Velocities depend on masses beside the state. The function is called twice for each step.
    let by_masses = RefCell::new(vec![[0.0; PLANETS + 1]; measured.len()]);
    let loss = |sample: &Sample<Bodies>| {
        let (mut sum, mut slopes) = (0.0, Phase::new(Bodies::default(), Bodies::default()));
        let Phase { q, p } = sample.state;
        for (number, transit) in measured.iter().enumerate() {
            let interval = STEP * INTERVAL as f64;
            if INTERVAL * (transit.time / interval).round() as u64 != sample.step {
                continue;
            }
            let body = transit.planet + 1;
            let (x, v) = (q[body][0] - q[0][0], p[body][0] / masses[body] - p[0][0] / masses[0]);
            let miss = (sample.time - x / v - transit.time) / error;
            sum += miss * miss;
            let outer = 2.0 * miss / error;
            let (by_x, by_v) = (-outer / v, outer * x / (v * v));
            slopes.q[body][0] += by_x;
            slopes.q[0][0] -= by_x;
            slopes.p[body][0] += by_v / masses[body];
            slopes.p[0][0] -= by_v / masses[0];
            by_masses.borrow_mut()[number][body] = -by_v * p[body][0] / (masses[body] * masses[body]);
        }
        (sum, slopes)
    };
    let last = measured.iter().fold(0.0_f64, |last, transit| last.max(transit.time));
    let steps = (last / STEP) as u64 + INTERVAL;
    let gradient = system.gradient_of_samples(BlanesMoanSrkn11, start, STEP, INTERVAL, steps, loss)?;
    let mut slopes = [0.0; PLANETS];
    for (planet, slope) in slopes.iter_mut().enumerate() {
        let direct: f64 = by_masses.borrow().iter().map(|of_transit| of_transit[planet + 1]).sum();
        *slope = gradient.parameters[planet] + direct;
    }
    Ok((gradient, slopes))
}
