//! Clusters of atoms with forces up to a cutoff.

use crate::{
    chains::half_squares,
    member::{Member, Number, pairs, points},
};
use integrator_core::prelude::*;

/// Argon: the Lennard-Jones potential with a cutoff.
pub(crate) struct LennardJones {
    mass: f64,
    sigma: f64,
    epsilon: f64,
    cutoff: f64,
}

#[hamiltonian]
impl LennardJones {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / self.mass).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let apart = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let square: f64 = apart.iter().map(|x| x * x).sum();
                if square < self.cutoff * self.cutoff {
                    let sixth = (self.sigma * self.sigma / square).powi(3);
                    energy += 4.0 * self.epsilon * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
}

impl Member for LennardJones {
    const STEP: f64 = 0.01;
    const ROUGH: Option<&'static str> =
        Some("the potential jumps where a pair passes the cutoff, so the energy is lost there");

    fn example() -> Self {
        Self { mass: 1.1, sigma: 1.0, epsilon: 0.9, cutoff: 1.9 }
    }
    fn energies(&self, at: &Phase<Vec<[f64; 3]>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / self.mass
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let pair = |square: D| {
            let sixth = (square / self.sigma.powi(2)).powi(-3);
            if square < self.cutoff.powi(2) { (sixth - 1.0) * sixth * (4.0 * self.epsilon) } else { D::zero() }
        };
        pairs::<D, 3>(q).into_iter().map(pair).sum()
    }
}

/// Sodium: the Morse potential in the plane; pairs beyond the cutoff are skipped.
pub(crate) struct Morse {
    depth: f64,
    width: f64,
    length: f64,
    cutoff: f64,
}

#[hamiltonian]
impl Morse {
    fn kinetic(&self, p: &[[f64; 2]; 4]) -> f64 {
        let mut sum = 0.0;
        for [x, y] in p {
            sum += (x * x + y * y) / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[[f64; 2]; 4]) -> f64 {
        let mut energy = 0.0;
        for i in 1..4 {
            for j in 0..i {
                let distance = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                if distance >= self.cutoff {
                    continue;
                }
                let bond = 1.0 - (-self.width * (distance - self.length)).exp();
                energy += self.depth * (bond * bond - 1.0);
            }
        }
        energy
    }
}

impl Member for Morse {
    const STEP: f64 = 0.02;
    const ROUGH: Option<&'static str> =
        Some("the potential jumps where a pair passes the cutoff, so the energy is lost there");

    fn example() -> Self {
        Self { depth: 1.2, width: 1.5, length: 1.1, cutoff: 2.25 }
    }
    fn energies(&self, at: &Phase<[[f64; 2]; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let pair = |square: D| {
            let distance = square.sqrt();
            let decayed = (-(distance - self.length) * self.width).exp();
            if distance < self.cutoff { (decayed - 2.0) * decayed * self.depth } else { D::zero() }
        };
        pairs::<D, 2>(q).into_iter().map(pair).sum()
    }
}

/// Colloids with a screened Coulomb repulsion; energy and force are shifted to vanish at the cutoff.
pub(crate) struct Colloids {
    strength: f64,
    screening: f64,
    cutoff: f64,
}

#[hamiltonian]
impl Colloids {
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        p.iter().map(|&[x, y]| 0.5 * (x * x + y * y)).sum()
    }
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                if i < j {
                    let distance = self.distance(q[i], q[j]);
                    energy += if distance < self.cutoff && self.strength > 0.0 {
                        self.yukawa(distance) - self.shift(distance)
                    } else {
                        0.0
                    };
                }
            }
        }
        energy
    }
    fn distance(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let apart = self.difference(a, b);
        (apart[0] * apart[0] + apart[1] * apart[1]).sqrt()
    }
    fn difference(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        [a[0] - b[0], a[1] - b[1]]
    }
    fn yukawa(&self, distance: f64) -> f64 {
        self.strength * (-self.screening * distance).exp() / distance
    }
    /// The tangent of the potential at the cutoff.
    fn shift(&self, distance: f64) -> f64 {
        self.yukawa(self.cutoff) * (1.0 - (self.screening + 1.0 / self.cutoff) * (distance - self.cutoff))
    }
}

impl Member for Colloids {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 1.5, screening: 0.8, cutoff: 2.0 }
    }
    fn energies(&self, at: &Phase<[[f64; 2]; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let Self { strength, screening, cutoff } = *self;
        let end = strength / cutoff * (-screening * cutoff).exp();
        let pair = |square: D| {
            let distance = square.sqrt();
            let beyond = distance - cutoff;
            let bare = (distance * -screening).exp() / distance * strength;
            if beyond < 0.0 { bare - end + beyond * ((screening + cutoff.recip()) * end) } else { D::zero() }
        };
        pairs::<D, 2>(q).into_iter().map(pair).sum()
    }
}

/// A simple model of silicon: bonds, and angles in degrees with a tetrahedral equilibrium (after Stillinger and Weber
/// 1985).
pub(crate) struct BondAngles {
    stiffness: f64,
    bending: f64,
}

#[hamiltonian]
impl BondAngles {
    fn kinetic(&self, p: &[[f64; 3]; 3]) -> f64 {
        p.iter().map(|p| p.iter().map(|x| x * x).sum::<f64>()).sum::<f64>() / 2.0
    }
    fn potential(&self, q: &[[f64; 3]; 3]) -> f64 {
        const TETRAHEDRAL: f64 = -1.0 / 3.0;
        let [centre, left, right] = *q;
        let (to_left, to_right) = (self.bond(&centre, &left), self.bond(&centre, &right));
        let (a, b) = (self.dot(to_left, to_left).sqrt(), self.dot(to_right, to_right).sqrt());
        let angle = (self.dot(to_left, to_right) / (a * b)).acos();
        let bent = (angle - TETRAHEDRAL.acos()).to_degrees();
        let bonds = (a - 1.0).powi(2) + (b - 1.0).powi(2);
        0.5 * self.stiffness * bonds + 0.5 * self.bending * bent.powi(2)
    }
    fn bond(&self, from: &[f64; 3], to: &[f64; 3]) -> [f64; 3] {
        let mut bond = [0.0; 3];
        for d in 0..3 {
            bond[d] = to[d] - from[d];
        }
        bond
    }
    fn dot(&self, [a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
        a * x + b * y + c * z
    }
}

impl Member for BondAngles {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { stiffness: 3.0, bending: 4e-4 }
    }
    fn energies(&self, at: &Phase<[[f64; 3]; 3]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let q = points::<D, 3>(q);
        let dot = |a: usize, b: usize| -> D { (0..3).map(|d| (q[a][d] - q[0][d]) * (q[b][d] - q[0][d])).sum() };
        let (a, b) = (dot(1, 1).sqrt(), dot(2, 2).sqrt());
        let bent = ((dot(1, 2) / (a * b)).acos() - (-1.0_f64 / 3.0).acos()) * (180.0 / std::f64::consts::PI);
        ((a - 1.0).powi(2) + (b - 1.0).powi(2)) * (self.stiffness / 2.0) + bent * bent * (self.bending / 2.0)
    }
}
