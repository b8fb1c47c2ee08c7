//! Stars in the potentials of galaxies.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// The oblate or prolate logarithmic potential with a core, which gives flat rotation curves.
pub(crate) struct Logarithmic {
    speed: f64,
    core: f64,
    flattening: f64,
}

#[hamiltonian]
impl Logarithmic {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
        let height = z / self.flattening;
        0.5 * self.speed.powi(2) * (self.core * self.core + x * x + y * y + height * height).ln()
    }
}

impl Member for Logarithmic {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { speed: 1.1, core: 0.2, flattening: 0.8 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let squares = q[0].powi(2) + q[1].powi(2) + (q[2] / self.flattening).powi(2) + self.core.powi(2);
        squares.ln() * (self.speed.powi(2) / 2.0)
    }
}

/// A disk (Miyamoto and Nagai 1975).
pub(crate) struct MiyamotoNagai {
    strength: f64,
    length: f64,
    height: f64,
}

#[hamiltonian]
impl MiyamotoNagai {
    fn kinetic(&self, p: &[f64; 3]) -> f64 {
        p.iter().map(|p| p.powi(2)).sum::<f64>() / 2.0
    }
    fn potential(&self, q: &[f64; 3]) -> f64 {
        let &[x, y, z] = q;
        let thickened = self.length + z.hypot(self.height);
        -self.strength / (x.powi(2) + y.powi(2) + thickened.powi(2)).sqrt()
    }
}

impl Member for MiyamotoNagai {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 1.3, length: 0.7, height: 0.3 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let thickened = (q[2] * q[2] + self.height.powi(2)).sqrt() + self.length;
        -(q[0] * q[0] + q[1] * q[1] + thickened * thickened).sqrt().recip() * self.strength
    }
}

/// A globular cluster (Plummer 1911).
pub(crate) struct Plummer {
    strength: f64,
    radius: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Plummer {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -self.strength * (x * x + y * y + self.radius * self.radius).powf(-0.5)
    }
}

impl Member for Plummer {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 1.0, radius: 0.6 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -(q[0] * q[0] + q[1] * q[1] + self.radius.powi(2)).sqrt().recip() * self.strength
    }
}

/// A spheroid with a cusp (Hernquist 1990).
pub(crate) struct Hernquist {
    strength: f64,
    scale: f64,
}

#[hamiltonian]
impl Hernquist {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p.iter().map(|p| p * p).sum::<f64>() / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -self.strength / (x.hypot(y) + self.scale)
    }
}

impl Member for Hernquist {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 1.5, scale: 0.5 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -((q[0] * q[0] + q[1] * q[1]).sqrt() + self.scale).recip() * self.strength
    }
}

/// A halo of dark matter (Navarro, Frenk and White 1996).
pub(crate) struct NavarroFrenkWhite {
    strength: f64,
    scale: f64,
}

#[hamiltonian]
impl NavarroFrenkWhite {
    fn kinetic(&self, p: &[f64; 3]) -> f64 {
        let [x, y, z] = *p;
        x.mul_add(x, y.mul_add(y, z * z)) * 0.5
    }
    fn potential(&self, q: &[f64; 3]) -> f64 {
        let radius = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        -self.strength * (radius / self.scale).ln_1p() / radius
    }
}

impl Member for NavarroFrenkWhite {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 4.0, scale: 1.7 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let radius = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
        -(radius / self.scale).ln_1p() / radius * self.strength
    }
}

/// The potential in which the radial period depends on energy alone (Hénon 1959).
pub(crate) struct Isochrone {
    strength: f64,
    scale: f64,
}

#[hamiltonian]
impl Isochrone {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * px.powi(2) + 0.5 * py.powi(2)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let distance = f64::sqrt(self.scale.powi(2) + x.powi(2) + y.powi(2));
        -self.strength * (self.scale + distance).recip()
    }
}

impl Member for Isochrone {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 1.2, scale: 0.4 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let distance = (q[0] * q[0] + q[1] * q[1] + self.scale.powi(2)).sqrt();
        -(distance + self.scale).recip() * self.strength
    }
}

/// A disk, a bulge and a rotating bar: helper methods that return tuples, and an angle.
pub(crate) struct RotatingBar {
    disk: f64,
    bulge: f64,
    strength: f64,
    speed: f64,
}

#[hamiltonian]
impl RotatingBar {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) * 0.5
    }
    fn potential(&self, [x, y]: [f64; 2], t: f64) -> f64 {
        let (radius, angle) = self.polar(x, y);
        let axisymmetric = {
            let disk = -self.disk / (1.0 + radius * radius).sqrt();
            disk - self.bulge / (0.25 + radius)
        };
        let bar = self.strength * radius.powi(2) / (1.0 + radius.powi(2)).powi(3);
        axisymmetric + bar * (2.0 * (angle - self.speed * t)).cos()
    }
    fn polar(&self, x: f64, y: f64) -> (f64, f64) {
        (x.hypot(y), y.atan2(x))
    }
}

impl Member for RotatingBar {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { disk: 1.4, bulge: 0.3, strength: 0.6, speed: 0.45 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, time: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q, time)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D {
        let square = q[0] * q[0] + q[1] * q[1];
        let (radius, spread) = (square.sqrt(), square + 1.0);
        let bar = square / spread.powi(3) * self.strength;
        let turned = (q[1].atan2(q[0]) - self.speed * time) * 2.0;
        bar * turned.cos() - spread.sqrt().recip() * self.disk - (radius + 0.25).recip() * self.bulge
    }
}
