//! A random molecule: atoms held together by lists of bonds, angles and dihedrals.

use integrator_core::prelude::*;
use std::f64::consts::TAU;

/// A molecule without charges; its terms refer to atoms by index.
#[derive(Clone)]
pub struct Molecule {
    /// Masses of the atoms.
    pub masses: Vec<f64>,
    /// Two atoms, and their equilibrium distance.
    pub bonds: Vec<(usize, usize, f64)>,
    /// Stiffness of each bond.
    pub stiffness: Vec<f64>,
    /// Three consecutive atoms, and the cosine of their equilibrium angle (GROMOS).
    pub angles: Vec<(usize, usize, usize, f64)>,
    /// Four consecutive atoms.
    pub dihedrals: Vec<(usize, usize, usize, usize)>,
    /// Height of the three equal barriers of each dihedral.
    pub barriers: Vec<f64>,
    /// Stiffness of all angles.
    pub bending: f64,
}

#[hamiltonian]
impl Molecule {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for (k, &(a, b, length)) in self.bonds.iter().enumerate() {
            let distance = Self::dot(Self::arm(q[a], q[b]), Self::arm(q[a], q[b])).sqrt();
            energy += 0.5 * self.stiffness[k] * (distance - length).powi(2);
        }
        for &(a, b, c, cosine) in &self.angles {
            let (u, v) = (Self::arm(q[b], q[a]), Self::arm(q[b], q[c]));
            let own = Self::dot(u, v) / (Self::dot(u, u) * Self::dot(v, v)).sqrt();
            energy += 0.5 * self.bending * (own - cosine).powi(2);
        }
        for (k, &(a, b, c, d)) in self.dihedrals.iter().enumerate() {
            let (u, v, w) = (Self::arm(q[a], q[b]), Self::arm(q[b], q[c]), Self::arm(q[c], q[d]));
            let (m, n) = (Self::cross(u, v), Self::cross(v, w));
            let cosine = Self::dot(m, n) / (Self::dot(m, m) * Self::dot(n, n)).sqrt();
            // Half of the barrier times 1 + cos 3φ.
            energy += self.barriers[k] * (0.5 + cosine * (2.0 * cosine * cosine - 1.5));
        }
        energy
    }
    fn arm(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
    }
    fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
        u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    }
    fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    }
}

/// Creates a molecule with `count` bonds, angles and dihedrals each, at rest and slightly displaced from equilibrium.
/// Every atom is bonded to one of the eight before it.
pub fn molecule(count: usize) -> (Molecule, Phase<Vec<[f64; 3]>>) {
    let mut state = 1_u64;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut parents = vec![0, 0, 1, 2];
    let mut q = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.3, 0.95, 0.0], [2.3, 1.0, 0.3]];
    let mut system = Molecule {
        masses: Vec::new(),
        bonds: Vec::new(),
        stiffness: Vec::new(),
        angles: Vec::new(),
        dihedrals: Vec::new(),
        barriers: Vec::new(),
        bending: 20.0,
    };
    while parents.len() < count + 3 {
        let atom = parents.len();
        let parent = atom - 1 - (uniform() * (atom - 3).min(8) as f64) as usize;
        // The new bond points into a hollow cone about the direction of the previous bond.
        let before = q[parents[parent]];
        let axis: [f64; 3] = std::array::from_fn(|d| q[parent][d] - before[d]);
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let direction = loop {
            let (height, turn) = (2.0 * uniform() - 1.0, TAU * uniform());
            let radius = (1.0 - height * height).sqrt();
            let direction = [radius * turn.cos(), radius * turn.sin(), height];
            let along = direction.iter().zip(axis).map(|(x, y)| x * y).sum::<f64>() / length;
            if (0.2..0.8).contains(&along) {
                break direction;
            }
        };
        q.push(std::array::from_fn(|d| q[parent][d] + direction[d]));
        parents.push(parent);
    }
    for atom in 0..parents.len() {
        system.masses.push(1.0 + (atom % 3) as f64);
        let [b, c, d] = [parents[atom], parents[parents[atom]], parents[parents[parents[atom]]]];
        if atom > 0 && system.bonds.len() < count {
            system.bonds.push((atom, b, 0.95 + 0.1 * uniform()));
            system.stiffness.push(50.0 + 50.0 * uniform());
        }
        if atom > 1 && system.angles.len() < count {
            system.angles.push((atom, b, c, -0.5 + 0.2 * uniform()));
        }
        if atom > 2 && system.dihedrals.len() < count {
            system.dihedrals.push((atom, b, c, d));
            system.barriers.push(1.0 + uniform());
        }
    }
    let p = vec![[0.0; 3]; q.len()];
    (system, Phase::new(q, p))
}
