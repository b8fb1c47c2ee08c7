//! Coupled angles.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// Rotors coupled to their mean field: two accumulators, and a square of sums (Antoni and Ruffo 1995).
pub(crate) struct MeanField {
    coupling: f64,
}

#[hamiltonian]
impl MeanField {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += 0.5 * p[i] * p[i];
        }
        sum
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let (mut along, mut across) = (0.0, 0.0);
        for angle in q {
            let (sine, cosine) = angle.sin_cos();
            along += cosine;
            across += sine;
        }
        let rotors = q.len() as f64;
        0.5 * self.coupling * (rotors - (along * along + across * across) / rotors)
    }
}

impl Member for MeanField {
    const STEP: f64 = 0.1;

    fn example() -> Self {
        Self { coupling: 1.4 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let (along, across): (D, D) = (q.iter().map(|x| x.cos()).sum(), q.iter().map(|x| x.sin()).sum());
        let rotors = q.len() as f64;
        (-(along * along + across * across) / rotors + rotors) * (self.coupling / 2.0)
    }
}

/// Rotors with a coupling that falls off with a power of their distance along the chain (Anteneodo and Tsallis 1998).
pub(crate) struct LongRange {
    decay: f64,
}

#[hamiltonian]
impl LongRange {
    fn kinetic(&self, p: &[f64; 5]) -> f64 {
        p.iter().map(|p| p * p).sum::<f64>() / 2.0
    }
    fn potential(&self, q: &[f64; 5]) -> f64 {
        let mut sum = 0.0;
        for i in 0..5 {
            for j in i + 1..5 {
                sum += (1.0 - (q[i] - q[j]).cos()) / ((j - i) as f64).powf(self.decay);
            }
        }
        sum
    }
}

impl Member for LongRange {
    const STEP: f64 = 0.1;

    fn example() -> Self {
        Self { decay: 0.75 }
    }
    fn energies(&self, at: &Phase<[f64; 5]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let mut sum = D::zero();
        for (i, j) in (0..5).flat_map(|i| (0..i).map(move |j| (i, j))) {
            sum += (-(q[i] - q[j]).cos() + 1.0) * ((i - j) as f64).powf(-self.decay);
        }
        sum
    }
}

/// Pendula on a torsion bar: the sine-Gordon equation on a lattice, with defects at every other site.
pub(crate) struct SineGordon {
    spacing: f64,
    defect: f32,
}

#[hamiltonian]
impl SineGordon {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / (2.0 * self.spacing)).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let bar: f64 = (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(2)).sum();
        let gravity: f64 = q.iter().map(|angle| 2.0 * (0.5 * angle).sin().powi(2)).sum();
        let defects: f64 = (0..q.len()).filter(|i| i % 2 == 1).map(|i| q[i].cos()).sum();
        bar / (2.0 * self.spacing) + self.spacing * gravity - self.defect as f64 * defects
    }
}

impl Member for SineGordon {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { spacing: 0.25, defect: 0.1 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p) / self.spacing
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let bar: D = q.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
        let gravity: D = q.iter().map(|angle| -angle.cos() + 1.0).sum();
        let defects: D = q.iter().skip(1).step_by(2).map(|angle| angle.cos()).sum();
        bar / (2.0 * self.spacing) + gravity * self.spacing - defects * f64::from(self.defect)
    }
}

/// A chain of pendulums with large amplitudes; `T` couples the momenta, as gears do.
pub(crate) struct GearedPendula {
    inertia: f64,
    gearing: f64,
    weights: [f64; 4],
}

#[hamiltonian]
impl GearedPendula {
    fn kinetic(&self, p: &[f64; 4]) -> f64 {
        let own: f64 = p.iter().map(|p| p * p).sum();
        let geared: f64 = p.windows(2).map(|pair| pair[0] * pair[1]).sum();
        (own + self.gearing * geared) / (2.0 * self.inertia)
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        let mut height = 0.0;
        for (angle, weight) in q.iter().zip(&self.weights) {
            height -= weight * angle.cos();
        }
        height
    }
}

impl Member for GearedPendula {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { inertia: 0.9, gearing: 0.6, weights: [1.0, 0.7, 1.3, 0.4] }
    }
    fn energies(&self, at: &Phase<[f64; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        let geared = p[0] * p[1] + p[1] * p[2] + p[2] * p[3];
        (half_squares(p) + geared * (self.gearing / 2.0)) / self.inertia
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        -q.iter().zip(self.weights).map(|(angle, weight)| angle.cos() * weight).sum::<D>()
    }
}

/// A free top with coupled axes: there is no potential.
pub(crate) struct FreeTop {
    inertia: f64,
}

#[hamiltonian]
impl FreeTop {
    fn kinetic(&self, [a, b]: [f64; 2]) -> f64 {
        (a * a + a * b + b * b) / (2.0 * self.inertia) + 0.1 * (a * b).cos()
    }
    fn potential(&self, _: [f64; 2]) -> f64 {
        0.0
    }
}

impl Member for FreeTop {
    const STEP: f64 = 0.1;
    const ROUGH: Option<&'static str> = Some("every composition is exact, so no order shows");

    fn example() -> Self {
        Self { inertia: 1.7 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        let product = p[0] * p[1];
        (p[0] * p[0] + product + p[1] * p[1]) / (2.0 * self.inertia) + product.cos() * 0.1
    }
    fn potential_formula<D: Number>(&self, _: &[D], _: f64) -> D {
        D::zero()
    }
}
