//! Systems to choose a composition for, with initial states and time spans.

use integrator_core::prelude::*;

/// A system, its initial state, and a time span of some periods of its slowest motion.
pub(crate) struct Problem<H: Hamiltonian> {
    pub(crate) system: H,
    pub(crate) start: Phase<H::Coords>,
    pub(crate) span: f64,
}

pub(crate) struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// A pendulum over ten periods of large amplitude.
pub(crate) fn pendulum() -> Problem<Pendulum> {
    Problem { system: Pendulum, start: Phase::new([2.0], [0.0]), span: 83.0 }
}

pub(crate) struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// The Hénon–Heiles system over about fifteen revolutions of the star.
pub(crate) fn henon_heiles() -> Problem<HenonHeiles> {
    Problem { system: HenonHeiles, start: Phase::new([0.1, 0.0], [0.0, 0.5]), span: 99.0 }
}

pub(crate) struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

/// A Kepler orbit of eccentricity 0.6, from the pericentre, over slightly more than ten periods.
pub(crate) fn kepler() -> Problem<Kepler> {
    Problem { system: Kepler, start: Phase::new([0.4, 0.0], [0.0, 2.0]), span: 64.0 }
}

/// The chain of Fermi, Pasta, Ulam and Tsingou: 32 particles between fixed ends.
pub(crate) struct Chain {
    pub(crate) alpha: f64,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: [f64; 32]) -> f64 {
        let mut energy = 0.0;
        for i in 0..32 {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: [f64; 32]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[31]);
        for i in 0..31 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        0.5 * stretch * stretch + self.alpha * stretch.powi(3) / 3.0
    }
}

/// The chain over fifty periods of its lowest mode, which has all the energy at the start.
pub(crate) fn fput() -> Problem<Chain> {
    let wave = |i: usize| (std::f64::consts::PI * (i + 1) as f64 / 33.0).sin();
    Problem { system: Chain { alpha: 0.25 }, start: Phase::new(std::array::from_fn(wave), [0.0; 32]), span: 3300.0 }
}
