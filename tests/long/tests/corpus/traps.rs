//! Driven systems: the time is an argument of `V`, of `T`, or of both.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// One ion in a radio-frequency trap (Paul and Steinwedel 1953).
pub(crate) struct PaulTrap {
    charge: f64,
    steady: f64,
    drive: f64,
    frequency: f64,
}

#[hamiltonian]
impl PaulTrap {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, [x, y, z]: [f64; 3], t: f64) -> f64 {
        let voltage = self.steady + self.drive * (self.frequency * t).cos();
        0.5 * self.charge * voltage * (x * x + y * y - 2.0 * z * z)
    }
}

impl Member for PaulTrap {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { charge: 0.8, steady: 0.05, drive: 0.9, frequency: 2.0 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let voltage = self.steady + self.drive * (self.frequency * time).cos();
        (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] * 2.0) * (self.charge / 2.0 * voltage)
    }
}

/// A periodically driven pendulum.
pub(crate) struct DrivenPendulum {
    amplitude: f64,
    frequency: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl DrivenPendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -q[0].cos() - self.amplitude * q[0] * (self.frequency * t).sin()
    }
}

impl Member for DrivenPendulum {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { amplitude: 0.4, frequency: 1.7 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        -q[0].cos() - q[0] * (self.amplitude * (self.frequency * time).sin())
    }
}

/// A pendulum with a vibrating pivot, which stabilises the upright position (Kapitza 1951).
pub(crate) struct Kapitza {
    gravity: f64,
    shake: f64,
    frequency: f64,
}

#[hamiltonian]
impl Kapitza {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / 2.0
    }
    fn potential(&self, [angle]: [f64; 1], t: f64) -> f64 {
        let pull = self.gravity + self.shake * self.frequency.powi(2) * (self.frequency * t).cos();
        -pull * angle.cos()
    }
}

impl Member for Kapitza {
    const STEP: f64 = 0.01;

    fn example() -> Self {
        Self { gravity: 1.0, shake: 0.2, frequency: 9.0 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let shaken = self.shake * self.frequency.powi(2) * (self.frequency * time).cos();
        q[0].cos() * -(self.gravity + shaken)
    }
}

/// A particle in two waves of different speed (Escande and Doveil 1981).
pub(crate) struct TwoWaves {
    standing: f64,
    running: f64,
}

#[hamiltonian]
impl TwoWaves {
    fn kinetic(&self, [v]: [f64; 1]) -> f64 {
        v * v * 0.5
    }
    fn potential(&self, [x]: [f64; 1], t: f64) -> f64 {
        -self.standing * x.cos() - self.running * (2.0 * (x - t)).cos()
    }
}

impl Member for TwoWaves {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { standing: 0.3, running: 0.2 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        -q[0].cos() * self.standing - ((q[0] - time) * 2.0).cos() * self.running
    }
}

/// Friction as a growing mass: both parts depend on time (Caldirola 1941, Kanai 1948).
pub(crate) struct GrowingMass {
    rate: f64,
    stiffness: f64,
}

#[hamiltonian]
impl GrowingMass {
    fn kinetic(&self, p: [f64; 2], t: f64) -> f64 {
        (-self.rate * t).exp() * (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let spring = q[0] * q[0] + q[1] * q[1] + q[0] * q[0] * q[1];
        (self.rate * t).exp() * self.stiffness * spring / 2.0
    }
}

impl Member for GrowingMass {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { rate: 0.1, stiffness: 1.3 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p, time), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], time: f64) -> D {
        half_squares(p) * (-self.rate * time).exp()
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let spring = q[0] * q[0] + q[1] * q[1] + q[0] * q[0] * q[1];
        spring * ((self.rate * time).exp() * self.stiffness / 2.0)
    }
}

/// The ion in a trap.
enum Species {
    Light,
    Heavy,
}

/// An ion in an optical lattice that is ramped up and then constant.
pub(crate) struct RampedLattice {
    species: Species,
    charge: i32,
    tilted: bool,
    depth: f64,
    ramp: f64,
}

#[hamiltonian]
impl RampedLattice {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        let mass = match self.species {
            Species::Light => 1.0,
            Species::Heavy => 2.5,
        };
        p * p / (2.0 * mass)
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        use std::f64::consts::PI;
        let x = &q[0];
        let strength: f64 = if t < self.ramp { (t / self.ramp).powi(2) * (3.0 - 2.0 * t / self.ramp) } else { 1.0 };
        let mut slope = self.field() + 0.01 * self.tilted as u8 as f64;
        if matches!(self.species, Species::Heavy) {
            slope *= 1.5;
        }
        strength * self.depth * (PI * *x).sin().powi(2) + f64::from(self.charge) * slope * x
    }
    /// Any Rust code is allowed, because no coordinate enters.
    fn field(&self) -> f64 {
        let candidates = [0.1, 0.2];
        candidates.into_iter().fold(0.0, f64::max)
    }
}

impl Member for RampedLattice {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        let started = [Species::Light, Species::Heavy].into_iter().next_back();
        Self { species: started.unwrap_or(Species::Light), charge: 2, tilted: true, depth: 0.9, ramp: 0.7 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / 2.5
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let s = (time / self.ramp).min(1.0);
        let light = (q[0] * std::f64::consts::TAU).cos() - 1.0;
        q[0] * (2.0 * 1.5 * 0.21) - light * (s * s * (3.0 - 2.0 * s) * self.depth / 2.0)
    }
}
