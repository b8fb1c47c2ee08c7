//! Lattices: sites with neighbours.

use crate::{
    chains::half_squares,
    member::{Member, Number, points},
};
use integrator_core::prelude::*;

/// The scalar field with two vacua, on a ring.
pub(crate) struct PhiFour {
    spacing: f64,
}

#[hamiltonian]
impl PhiFour {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p.powi(2)).sum::<f64>() / (2.0 * self.spacing)
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let sites = q.len();
        let mut sum = 0.0;
        for i in 0..sites {
            let slope = (q[(i + 1) % sites] - q[i]) / self.spacing;
            let well = q[i].powi(2) - 1.0;
            sum += self.spacing * (0.5 * slope * slope + 0.25 * well * well);
        }
        sum
    }
}

impl Member for PhiFour {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { spacing: 0.5 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / self.spacing
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let next = q.iter().cycle().skip(1);
        let slopes: D = q.iter().zip(next).map(|(here, there)| (*there - *here).powi(2)).sum();
        let wells: D = q.iter().map(|x| (*x * *x - 1.0).powi(2)).sum();
        slopes / (2.0 * self.spacing) + wells * (self.spacing / 4.0)
    }
}

/// Planar spins on a square lattice with periodic boundaries, by index arithmetic.
pub(crate) struct PlanarSpins {
    width: u32,
    height: usize,
    field: f64,
}

#[hamiltonian]
impl PlanarSpins {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let (w, h) = (self.width as usize, self.height);
        let mut sum = 0.0;
        for i in 0..h {
            for j in 0..w {
                let here = q[i * w + j];
                let (right, below) = (q[i * w + (j + 1) % w], q[(i + 1) % h * w + j]);
                sum -= (right - here).cos() + (below - here).cos() + self.field * here.cos();
            }
        }
        sum
    }
}

impl Member for PlanarSpins {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { width: 3, height: 2, field: 0.3 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let (w, h) = (self.width as usize, self.height);
        let at = |i: usize, j: usize| q[i % h * w + j % w];
        let mut sum = D::zero();
        for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
            let spin = at(i, j);
            sum -= (at(i, j + 1) - spin).cos() + (at(i + 1, j) - spin).cos() + spin.cos() * self.field;
        }
        sum
    }
}

/// Oscillators on a graph, joined by a list of bonds with individual stiffnesses.
pub(crate) struct Network {
    bonds: Vec<(usize, usize)>,
    stiffness: Vec<f64>,
    pinning: f64,
}

#[hamiltonian]
impl Network {
    const SITES: usize = 5;

    fn kinetic(&self, p: &[f64; Self::SITES]) -> f64 {
        let mut sum = 0.0;
        for &p in p {
            sum += p.powi(2);
        }
        0.5 * sum
    }
    fn potential(&self, q: &[f64; Self::SITES]) -> f64 {
        let mut sum = 0.0;
        for (k, &(a, b)) in self.bonds.iter().enumerate() {
            sum += self.stiffness[k] * (q[a] - q[b]).powi(2) / 2.0;
        }
        for &(a, b) in &self.bonds {
            sum += 0.1 * (q[a] - q[b]).powi(4);
        }
        sum + q.iter().map(|q| self.pinning * q.powi(4)).sum::<f64>()
    }
}

impl Member for Network {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        let bonds = vec![(0, 1), (1, 2), (2, 0), (3, 1), (2, 4)];
        Self { bonds, stiffness: vec![1.0, 0.6, 1.4, 0.8, 0.5], pinning: 0.2 }
    }
    fn energies(&self, at: &Phase<[f64; 5]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let bond = |(&(a, b), stiffness): (&(usize, usize), &f64)| {
            let square = (q[b] - q[a]).powi(2);
            square * (stiffness / 2.0) + square * square * 0.1
        };
        let bonds: D = self.bonds.iter().zip(&self.stiffness).map(bond).sum();
        bonds + q.iter().map(|x| x.powi(4)).sum::<D>() * self.pinning
    }
}

/// A membrane: points in space, attached to the neighbours in a table.
pub(crate) struct Membrane<'n, const N: usize> {
    neighbours: &'n [[usize; 2]; N],
    length: f64,
    tension: f64,
}

#[hamiltonian]
impl<const N: usize> Membrane<'_, N> {
    fn kinetic(&self, p: &[[f64; 3]; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            for d in 0..3 {
                sum += p[i][d] * p[i][d];
            }
        }
        0.5 * sum
    }
    fn potential(&self, q: &[[f64; 3]; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            for k in 0..2 {
                let other = self.neighbours[i][k];
                let mut square = 0.0;
                for d in 0..3 {
                    square += (q[i][d] - q[other][d]).powi(2);
                }
                sum += self.tension * (square.sqrt() - self.length).powi(2);
            }
        }
        sum
    }
}

impl Member for Membrane<'static, 4> {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { neighbours: &[[1, 2], [3, 0], [0, 3], [1, 2]], length: 0.9, tension: 0.7 }
    }
    fn energies(&self, at: &Phase<[[f64; 3]; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let q = points::<D, 3>(q);
        let spring = |a: usize, b: usize| {
            let square: D = q[a].iter().zip(&q[b]).map(|(a, b)| (*a - *b).powi(2)).sum();
            (square.sqrt() - self.length).powi(2) * self.tension
        };
        self.neighbours.iter().enumerate().flat_map(|(i, row)| row.map(|k| spring(i, k))).sum()
    }
}

/// Source of a chain's stiffness.
pub(crate) trait Law: Sync + 'static {
    fn stiffness(&self) -> f64;
}

impl Law for f64 {
    fn stiffness(&self) -> f64 {
        *self
    }
}

/// A chain of any length with alternating strong and weak bonds (Su, Schrieffer and Heeger 1979), and a few heavy ends.
pub(crate) struct Dimers<L> {
    law: L,
    weak: f64,
    pinned: usize,
}

#[hamiltonian]
impl<L> Dimers<L>
where
    L: Law,
{
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum::<f64>() + p.iter().rev().step_by(2).map(|p| 0.1 * p * p).sum::<f64>()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let next = i + 1;
            let bond = q[next] - q[i];
            energy += if i % 2 == 0 { self.law.stiffness() } else { self.weak } * (bond.cosh() - 1.0);
        }
        for i in 0..self.pinned {
            energy += (i as f64 + 0.5) * q[i].powi(4);
        }
        energy
    }
}

impl Member for Dimers<f64> {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { law: 1.3, weak: 0.6, pinned: 2 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        let last = p.len() - 1;
        p.iter().enumerate().map(|(i, p)| *p * *p * [0.6, 0.5][(last - i) % 2]).sum()
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let stiffness = [self.law, self.weak].into_iter().cycle();
        let bond = |(pair, stiffness): (&[D], f64)| ((pair[1] - pair[0]).cosh() - 1.0) * stiffness;
        q.windows(2).zip(stiffness).map(bond).sum::<D>() + q[0].powi(4) * 0.5 + q[1].powi(4) * 1.5
    }
}
