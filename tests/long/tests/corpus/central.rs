//! One particle with one centre or two.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// Two bodies (Kepler), with a mass other than one.
pub(crate) struct Kepler {
    mass: f64,
    mu: f64,
}

#[hamiltonian(compose = V(1/2) T(1) V(1/2))]
impl Kepler {
    /// Kinetic energy.
    pub(crate) fn kinetic(&self, p: &[f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * self.mass)
    }
    /// Potential energy.
    pub(crate) fn potential(&self, q: &[f64; 2]) -> f64 {
        -self.mu / (q[0].powi(2) + q[1] * q[1]).sqrt()
    }
}

impl Member for Kepler {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { mass: 0.8, mu: 1.1 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / self.mass
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -(q[0] * q[0] + q[1] * q[1]).sqrt().recip() * self.mu
    }
}

/// An electron in a semiconductor with an anisotropic mass: chaotic (Gutzwiller 1973).
pub(crate) struct AnisotropicKepler {
    heavy: f64,
    light: f64,
}

#[hamiltonian]
impl AnisotropicKepler {
    fn kinetic(&self, [u, v]: [f64; 2]) -> f64 {
        u * u / (2.0 * self.heavy) + v * v / (2.0 * self.light)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / x.hypot(y)
    }
}

impl Member for AnisotropicKepler {
    const STEP: f64 = 0.002;

    fn example() -> Self {
        Self { heavy: 1.2, light: 0.85 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        p[0] * p[0] / (2.0 * self.heavy) + p[1] * p[1] / (2.0 * self.light)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -(q[0] * q[0] + q[1] * q[1]).sqrt().recip()
    }
}

/// Two quarks: a Coulomb force at short distances, a constant one at large distances (Eichten and others 1978).
pub(crate) struct Quarkonium {
    coulomb: f64,
    tension: f64,
    mass: f64,
}

#[hamiltonian]
impl Quarkonium {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        let [x, y, z] = p;
        (x.powi(2) + y.powi(2) + z.powi(2)) / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let square = q[0].powi(2) + q[1].powi(2) + q[2].powi(2);
        let distance = square.powf(0.5);
        self.tension * distance - self.coulomb / distance
    }
}

impl Member for Quarkonium {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { coulomb: 0.5, tension: 0.9, mass: 0.75 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / self.mass
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let distance = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
        distance * self.tension - distance.recip() * self.coulomb
    }
}

/// A vibrating and rotating molecule (Kratzer 1920); the centrifugal power is a parameter.
pub(crate) struct Kratzer {
    depth: f64,
    length: f64,
    power: i32,
}

#[hamiltonian]
impl Kratzer {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let ratio = self.length / (q[0] * q[0] + q[1] * q[1]).sqrt();
        self.depth * (0.5 * ratio.powi(self.power) - ratio)
    }
}

impl Member for Kratzer {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { depth: 1.5, length: 0.9, power: 2 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let ratio = (q[0] * q[0] + q[1] * q[1]).sqrt().recip() * self.length;
        (ratio.powi(self.power) / 2.0 - ratio) * self.depth
    }
}

/// Two fixed suns (Euler 1760): parameters in an array of points.
pub(crate) struct FixedCentres {
    suns: [[f64; 2]; 2],
    masses: [f64; 2],
}

#[hamiltonian]
impl FixedCentres {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0].powi(2) / 2.0 + p[1].powi(2) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let mut sum = 0.0;
        for (sun, mass) in self.suns.iter().zip(&self.masses) {
            sum -= mass / (x - sun[0]).hypot(y - sun[1]);
        }
        sum
    }
}

impl Member for FixedCentres {
    const STEP: f64 = 0.01;

    fn example() -> Self {
        Self { suns: [[-0.5, 0.0], [0.5, 0.1]], masses: [1.0, 0.6] }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let pull = |([x, y], mass): ([f64; 2], f64)| -((q[0] - x).powi(2) + (q[1] - y).powi(2)).sqrt().recip() * mass;
        self.suns.into_iter().zip(self.masses).map(pull).sum()
    }
}

/// A swinging weight on a spring; a flag selects the direction of gravity.
pub(crate) struct SpringPendulum {
    stiffness: f64,
    length: f64,
    weight: f64,
    tilted: bool,
}

#[hamiltonian]
impl SpringPendulum {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let stretch = x.hypot(y) - self.length;
        let height = if self.tilted { 0.6 * x + 0.8 * y } else { y };
        0.5 * self.stiffness * stretch * stretch + self.weight * height
    }
}

impl Member for SpringPendulum {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { stiffness: 4.0, length: 0.9, weight: 1.1, tilted: true }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let stretch = (q[0] * q[0] + q[1] * q[1]).sqrt() - self.length;
        stretch * stretch * (self.stiffness / 2.0) + (q[0] * 0.6 + q[1] * 0.8) * self.weight
    }
}

/// A particle in a box with soft walls, a step inside, and two sharp slopes: all forms of branches.
pub(crate) struct SoftBox {
    half: f64,
    hardness: f64,
    friction: f64,
}

#[hamiltonian]
impl SoftBox {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * p.iter().map(|p| p * p).sum::<f64>()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        // The nearest image in a box of 16, in all supported notations. The particle stays within half the box, where
        // none of them changes its coordinates.
        let x = x - 16.0 * (x / 16.0).round();
        let x = x - 16.0 * (x / 16.0 + 0.5).floor();
        let y = y - 16.0 * (y / 16.0 - 0.5).ceil();
        let y = 16.0 * (y / 16.0).fract();
        let y = y - 16.0 * (y / 16.0).trunc();
        let y = y - 16.0 * (y / 16.0).round_ties_even();
        let mut energy = 0.0;
        let inside = x >= -self.half && x <= self.half;
        if x > self.half {
            energy += 0.5 * self.hardness * (x - self.half).powi(2);
        } else if !inside || x < -2.0 * self.half {
            energy += 0.5 * self.hardness * (x + self.half).powi(2);
        }
        let outside = (y.abs() % 16.0).rem_euclid(16.0).max(self.half) - self.half;
        energy += 0.5 * self.hardness * outside * outside;
        energy + self.friction * x.min(y) + self.friction * y.signum() * y.powi(3)
    }
}

impl Member for SoftBox {
    const STEP: f64 = 0.02;
    const ROUGH: Option<&'static str> = Some("the force jumps where the smaller coordinate becomes the larger one");

    fn example() -> Self {
        Self { half: 0.75, hardness: 6.0, friction: 0.2 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let magnitude = |x: D| if x < 0.0 { -x } else { x };
        let wall = |x: D| {
            let outside = magnitude(x) - self.half;
            if outside > 0.0 { outside * outside * (self.hardness / 2.0) } else { D::zero() }
        };
        let lower = if q[0] < q[1] { q[0] } else { q[1] };
        wall(q[0]) + wall(q[1]) + (lower + magnitude(q[1]).powi(3)) * self.friction
    }
}
