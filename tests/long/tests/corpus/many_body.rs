//! Systems with interactions between all bodies.

use crate::{
    chains::half_squares,
    member::{Member, Number, pairs, points},
};
use integrator_core::prelude::*;

/// Stars with individual masses; close encounters are softened.
pub(crate) struct Gravity {
    masses: [f64; 4],
    constant: f64,
    softening: f64,
}

#[hamiltonian]
impl Gravity {
    fn kinetic(&self, p: &[[f64; 3]; 4]) -> f64 {
        let mut energy = 0.0;
        for (p, mass) in p.iter().zip(self.masses.iter()) {
            energy += (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * mass);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]; 4]) -> f64 {
        let mut energy = 0.0;
        for i in 0..4 {
            for j in 0..i {
                let mut square = self.softening.powi(2);
                for d in 0..3 {
                    let apart = q[i][d] - q[j][d];
                    square += apart * apart;
                }
                energy -= self.constant * self.masses[i] * self.masses[j] / square.sqrt();
            }
        }
        energy
    }
}

impl Member for Gravity {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { masses: [1.0, 0.5, 0.8, 0.2], constant: 0.9, softening: 0.1 }
    }
    fn energies(&self, at: &Phase<[[f64; 3]; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        p.chunks(3).zip(self.masses).map(|(p, mass)| half_squares(p) / mass).sum()
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let products = (0..4).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| self.masses[i] * self.masses[j]);
        let softened = |square: D| (square + self.softening.powi(2)).sqrt().recip();
        let pair = |(square, product): (D, f64)| -softened(square) * (self.constant * product);
        pairs::<D, 3>(q).into_iter().zip(products).map(pair).sum()
    }
}

/// Three equal bodies, with coordinates written out. The initial state is near the figure eight of Chenciner and
/// Montgomery.
pub(crate) struct ThreeBodies;

#[hamiltonian]
impl ThreeBodies {
    fn kinetic(&self, [[ux, uy], [vx, vy], [wx, wy]]: [[f64; 2]; 3]) -> f64 {
        0.5 * (ux * ux + uy * uy + vx * vx + vy * vy + wx * wx + wy * wy)
    }
    fn potential(&self, [[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> f64 {
        let ab = ((ax - bx).powi(2) + (ay - by).powi(2)).sqrt();
        let bc = ((bx - cx).powi(2) + (by - cy).powi(2)).sqrt();
        let ca = ((cx - ax).powi(2) + (cy - ay).powi(2)).sqrt();
        -1.0 / ab - 1.0 / bc - 1.0 / ca
    }
}

impl Member for ThreeBodies {
    const STEP: f64 = 0.01;

    fn example() -> Self {
        Self
    }
    fn energies(&self, at: &Phase<[[f64; 2]; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -pairs::<D, 2>(q).into_iter().map(|square| square.sqrt().recip()).sum::<D>()
    }
}

/// Ions in an anisotropic trap (James 1998).
pub(crate) struct CoulombCrystal {
    stiffness: [f64; 3],
}

#[hamiltonian]
impl CoulombCrystal {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        0.5 * p.iter().map(|p| p.iter().map(|x| x.powi(2)).sum::<f64>()).sum::<f64>()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut trap = 0.0;
        let mut repulsion = 0.0;
        for (i, ion) in q.iter().enumerate() {
            for (x, stiffness) in ion.iter().zip(&self.stiffness) {
                trap += 0.5 * stiffness * x * x;
            }
            for other in q.iter().take(i) {
                let square = (ion[0] - other[0]).powi(2) + (ion[1] - other[1]).powi(2) + (ion[2] - other[2]).powi(2);
                repulsion += 1.0 / square.sqrt();
            }
        }
        trap + repulsion
    }
}

impl Member for CoulombCrystal {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { stiffness: [4.0, 3.2, 0.7] }
    }
    fn energies(&self, at: &Phase<Vec<[f64; 3]>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let trap = |ion: [D; 3]| -> D { ion.iter().zip(self.stiffness).map(|(x, k)| *x * *x * (k / 2.0)).sum() };
        let repulsion: D = pairs::<D, 3>(q).into_iter().map(|square| square.sqrt().recip()).sum();
        repulsion + points(q).into_iter().map(trap).sum::<D>()
    }
}

/// Particles on a line with inverse-square interaction, integrable (Calogero 1971, Moser 1975).
pub(crate) struct CalogeroMoser {
    coupling: f64,
    frequency: f64,
}

#[hamiltonian]
impl CalogeroMoser {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p.powi(2) / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let well: f64 = q.iter().map(|q| 0.5 * (self.frequency * q).powi(2)).sum();
        let repulsion: f64 = (0..q.len()).map(|i| (0..i).map(|j| (q[i] - q[j]).powi(-2)).sum::<f64>()).sum();
        well + self.coupling * repulsion
    }
}

impl Member for CalogeroMoser {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { coupling: 0.4, frequency: 1.3 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let repulsion: D = pairs::<D, 1>(q).into_iter().map(|square| square.recip()).sum();
        half_squares(q) * self.frequency.powi(2) + repulsion * self.coupling
    }
}

/// The same on a circle (Sutherland 1971).
pub(crate) struct Sutherland<const N: usize> {
    coupling: f64,
    circumference: f64,
}

#[hamiltonian]
impl<const N: usize> Sutherland<N> {
    #[allow(clippy::assign_op_pattern, reason = "both ways to add are understood")]
    fn kinetic(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            sum = sum + p[i].powi(2) / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[f64; N]) -> f64 {
        let wave = std::f64::consts::PI / self.circumference;
        let mut sum = 0.0;
        for i in 1..N {
            for j in 0..i {
                sum += (wave / (wave * (q[i] - q[j])).sin()).powi(2);
            }
        }
        self.coupling * sum
    }
}

impl Member for Sutherland<4> {
    const STEP: f64 = 0.01;

    fn example() -> Self {
        Self { coupling: 0.3, circumference: 5.0 }
    }
    fn energies(&self, at: &Phase<[f64; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let wave = std::f64::consts::PI / self.circumference;
        let chord = |square: D| (square.sqrt() * wave).sin().powi(-2) * wave.powi(2);
        pairs::<D, 1>(q).into_iter().map(chord).sum::<D>() * self.coupling
    }
}

/// Sheets of mass that pass through each other: the force jumps, so the potential has kinks.
pub(crate) struct Sheets {
    density: f64,
}

#[hamiltonian]
impl Sheets {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|p| p * p).sum::<f64>() * 0.5
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in (0..i).rev() {
                sum += (q[i] - q[j]).abs();
            }
        }
        self.density * sum
    }
}

impl Member for Sheets {
    const STEP: f64 = 0.02;
    const ROUGH: Option<&'static str> = Some("the force jumps where two sheets pass, so no order above 1 shows");

    fn example() -> Self {
        Self { density: 0.7 }
    }
    fn energies(&self, at: &Phase<[f64; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let apart = [q[1] - q[0], q[2] - q[0], q[2] - q[1]];
        apart.into_iter().map(|x| if x < 0.0 { -x } else { x }).sum::<D>() * self.density
    }
}
