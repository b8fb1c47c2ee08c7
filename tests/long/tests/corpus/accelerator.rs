//! Beams, and other systems with a kinetic energy that is not quadratic in the momenta.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// A focusing channel with sextupoles and octupoles; the path length along the beam is the time.
pub(crate) struct FocusingChannel {
    quadrupole: f64,
    sextupole: f64,
    octupole: f64,
}

#[hamiltonian]
impl FocusingChannel {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2], s: f64) -> f64 {
        let strength = self.quadrupole * (1.0 + 0.3 * (2.0 * s).sin());
        let linear = strength * x * x / 2.0 + self.quadrupole * y * y / 2.0;
        let sextupole = self.sextupole * (x.powi(3) - 3.0 * x * y.powi(2)) / 6.0;
        let octupole = self.octupole * (x.powi(4) - 6.0 * x.powi(2) * y.powi(2) + y.powi(4)) / 24.0;
        linear + sextupole + octupole
    }
}

impl Member for FocusingChannel {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { quadrupole: 1.1, sextupole: 0.7, octupole: 0.9 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let (xx, yy) = (q[0] * q[0], q[1] * q[1]);
        let linear = xx * (1.0 + 0.3 * (2.0 * time).sin()) + yy;
        linear * (self.quadrupole / 2.0)
            + q[0] * (xx - yy * 3.0) * (self.sextupole / 6.0)
            + (xx * xx - xx * yy * 6.0 + yy * yy) * (self.octupole / 24.0)
    }
}

/// Bunches in a radio-frequency bucket: the slip of the ring makes the kinetic energy negative above transition.
pub(crate) struct Bucket {
    slip: f64,
    voltage: f64,
    synchronous: f64,
}

#[hamiltonian]
impl Bucket {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * self.slip * p[0] * p[0]
    }
    fn potential(&self, [phase]: [f64; 1]) -> f64 {
        let acceleration = (phase - self.synchronous) * self.synchronous.sin();
        self.voltage * (phase.cos() + acceleration)
    }
}

impl Member for Bucket {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { slip: -0.8, voltage: 0.9, synchronous: 0.2 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) * self.slip
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        (q[0].cos() + (q[0] - self.synchronous) * self.synchronous.sin()) * self.voltage
    }
}

/// The exact drift of a beam: the longitudinal momentum follows from the transverse ones.
pub(crate) struct ExactDrift {
    deviation: f64,
    focusing: f64,
}

#[hamiltonian]
impl ExactDrift {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        -((1.0 + self.deviation).powi(2) - px * px - py * py).sqrt()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * self.focusing * (x * x + y * y) + 0.1 * self.focusing * x.powi(3)
    }
}

impl Member for ExactDrift {
    const STEP: f64 = 0.1;

    fn example() -> Self {
        Self { deviation: 0.02, focusing: 0.6 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        -(-p[0] * p[0] - p[1] * p[1] + (1.0 + self.deviation).powi(2)).sqrt()
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        ((q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0].powi(3) * 0.1) * self.focusing
    }
}

/// A relativistic particle in a Coulomb field with a core.
pub(crate) struct Relativistic {
    light: f64,
    charge: f64,
}

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        let square: f64 = p.iter().map(|p| p * p).sum();
        self.light * (self.light.powi(2) + square).sqrt()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -self.charge / (0.04 + q.iter().map(|q| q * q).sum::<f64>()).sqrt()
    }
}

impl Member for Relativistic {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { light: 1.5, charge: 0.7 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        (half_squares(p) * 2.0 + self.light.powi(2)).sqrt() * self.light
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -(half_squares(q) * 2.0 + 0.04).sqrt().recip() * self.charge
    }
}

/// Electrons of graphene in a harmonic trap: the energy is proportional to the momentum.
pub(crate) struct Massless {
    speed: f64,
    stiffness: f64,
}

#[hamiltonian]
impl Massless {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        self.speed * px.hypot(py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * self.stiffness * (x.powi(2) + 0.5 * y.powi(2)) + 0.1 * x.powi(2) * y
    }
}

impl Member for Massless {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { speed: 0.8, stiffness: 0.9 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        (p[0] * p[0] + p[1] * p[1]).sqrt() * self.speed
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let xx = q[0] * q[0];
        (xx / 2.0 + q[1] * q[1] / 4.0) * self.stiffness + xx * q[1] * 0.1
    }
}

/// An electron in a crystal and a constant field: it oscillates (Bloch 1929), here with a weak trap.
pub(crate) struct Bloch {
    band: f64,
    field: f64,
}

#[hamiltonian]
impl Bloch {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        2.0 * self.band * (1.0 - p.cos())
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.field * x + 0.05 * x * x
    }
}

impl Member for Bloch {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { band: 0.7, field: 0.3 }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        (p[0] / 2.0).sin().powi(2) * (4.0 * self.band)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        (q[0] * 0.05 + self.field) * q[0]
    }
}

/// Two rotors with momenta coupled by the mass matrix, and a quartic correction of the kinetic energy.
pub(crate) struct CoupledRotors {
    coupling: f64,
    quartic: f64,
}

#[hamiltonian]
impl CoupledRotors {
    fn kinetic(&self, [a, b]: [f64; 2]) -> f64 {
        a * a / 2.0 + b * b + self.coupling * a * b + self.quartic * (a.powi(4) + b.powi(4))
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -2.0 * x.cos() - (y - x).cos()
    }
}

impl Member for CoupledRotors {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { coupling: -0.8, quartic: 0.05 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        let (aa, bb) = (p[0] * p[0], p[1] * p[1]);
        aa / 2.0 + bb + p[0] * p[1] * self.coupling + (aa * aa + bb * bb) * self.quartic
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        q[0].cos() * -2.0 - (q[1] - q[0]).cos()
    }
}
