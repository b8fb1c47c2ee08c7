//! Chains of masses and springs.

use crate::member::{Member, Number};
use integrator_core::prelude::*;

/// Cubic springs between free ends (Fermi, Pasta, Ulam and Tsingou 1955).
pub(crate) struct FputAlpha {
    alpha: f64,
}

#[hamiltonian]
impl FputAlpha {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        q.windows(2)
            .map(|pair| {
                let stretch = pair[1] - pair[0];
                0.5 * stretch * stretch + self.alpha / 3.0 * stretch.powi(3)
            })
            .sum()
    }
}

impl Member for FputAlpha {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { alpha: 0.25 }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        q.windows(2).map(|pair| spring(pair[1] - pair[0], self.alpha, 0.0)).sum()
    }
}

/// Quartic springs between walls, with a helper method.
pub(crate) struct FputBeta {
    beta: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl FputBeta {
    fn kinetic(&self, p: &[f64; 8]) -> f64 {
        let mut sum = 0.0;
        for momentum in p {
            sum += momentum * momentum / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[f64; 8]) -> f64 {
        let mut sum = self.spring(q[0]) + Self::spring(self, -q[7]);
        for i in (1..q.len()).rev() {
            sum += self.spring(q[i] - q[i - 1]);
        }
        sum
    }
    #[inline]
    fn spring(&self, stretch: f64) -> f64 {
        let square = stretch * stretch;
        square / 2.0 + self.beta * square * square / 4.0
    }
}

impl Member for FputBeta {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { beta: 1.3 }
    }
    fn energies(&self, at: &Phase<[f64; 8]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let ends = spring(q[0], 0.0, self.beta) + spring(-q[7], 0.0, self.beta);
        ends + q.windows(2).map(|pair| spring(pair[1] - pair[0], 0.0, self.beta)).sum::<D>()
    }
}

/// Exponential springs around a ring of any size (Toda 1967).
pub(crate) struct Toda<const N: usize> {
    strength: f64,
    range: f64,
}

#[hamiltonian]
impl<const N: usize> Toda<N> {
    fn kinetic(&self, p: [f64; N]) -> f64 {
        let mut sum = 0.0;
        for momentum in p {
            sum += momentum * momentum;
        }
        sum / 2.0
    }
    fn potential(&self, q: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            let stretch = q[(i + 1) % N] - q[i];
            sum += self.strength / self.range * (-self.range * stretch).exp() + self.strength * stretch;
        }
        sum
    }
}

impl Member for Toda<5> {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { strength: 0.8, range: 1.2 }
    }
    fn energies(&self, at: &Phase<[f64; 5]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let bond = |i: usize| {
            let stretch = q[(i + 1) % 5] - q[i];
            (stretch * -self.range).exp() * (self.strength / self.range) + stretch * self.strength
        };
        (0..5).map(bond).sum()
    }
}

/// Atoms on a corrugated surface, joined by springs with a different natural length (Frenkel and Kontorova 1938).
pub(crate) struct FrenkelKontorova {
    stiffness: f64,
    depth: f64,
    misfit: f64,
}

#[hamiltonian]
impl FrenkelKontorova {
    fn kinetic(&self, p: &[f64; 6]) -> f64 {
        p.iter().fold(0.0, |sum, p| sum + p * p / 2.0)
    }
    fn potential(&self, q: &[f64; 6]) -> f64 {
        let wave = 2.0 * std::f64::consts::PI;
        let (mut springs, mut surface) = (0.0, 0.0);
        for i in 0..=4 {
            springs += (q[i + 1] - q[i] - self.misfit).powi(2);
        }
        for x in q.iter().copied() {
            surface += 1.0 - (wave * x).cos();
        }
        0.5 * self.stiffness * springs + self.depth / wave.powi(2) * surface
    }
}

impl Member for FrenkelKontorova {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { stiffness: 0.9, depth: 1.1, misfit: 0.4 }
    }
    fn energies(&self, at: &Phase<[f64; 6]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let wave = std::f64::consts::TAU;
        let springs: D = q.windows(2).map(|pair| (pair[1] - pair[0] - self.misfit).powi(2)).sum();
        let surface: D = q.iter().map(|x| -(*x * wave).cos() + 1.0).sum();
        springs * (self.stiffness / 2.0) + surface * (self.depth / (wave * wave))
    }
}

/// Opening base pairs of DNA: Morse potentials of different depths with nonlinear stacking (Dauxois, Peyrard, Bishop
/// 1993).
pub(crate) struct PeyrardBishop {
    depth: Vec<f64>,
    width: f64,
    stacking: Stacking,
}

/// Stacking interaction of neighbouring base pairs.
struct Stacking {
    stiffness: f64,
    gain: f64,
    decay: f64,
}

#[hamiltonian]
impl PeyrardBishop {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum::<f64>()
    }
    fn potential(&self, y: &[f64]) -> f64 {
        debug_assert_eq!(self.depth.len(), y.len());
        let opening: f64 = y.iter().enumerate().map(|(n, y)| self.depth[n] * (-self.width * y).exp_m1().powi(2)).sum();
        let stacking: f64 = y
            .iter()
            .skip(1)
            .zip(y.iter())
            .map(|(right, left)| {
                let softening = 1.0 + self.stacking.gain * (-self.stacking.decay * (right + left)).exp();
                0.5 * self.stacking.stiffness * softening * (right - left).powi(2)
            })
            .sum();
        opening + stacking
    }
}

impl Member for PeyrardBishop {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        let stacking = Stacking { stiffness: 0.6, gain: 2.0, decay: 0.35 };
        Self { depth: vec![0.05, 0.075, 0.05, 0.075, 0.05], width: 4.2, stacking }
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, y: &[D], _: f64) -> D {
        let Stacking { stiffness, gain, decay } = self.stacking;
        let morse = |(y, depth): (&D, &f64)| (*y * -self.width).exp_m1().powi(2) * *depth;
        let stack = |pair: &[D]| {
            let softening = ((pair[0] + pair[1]) * -decay).exp() * gain + 1.0;
            (pair[1] - pair[0]).powi(2) * softening * (stiffness / 2.0)
        };
        y.iter().zip(&self.depth).map(morse).sum::<D>() + y.windows(2).map(stack).sum::<D>()
    }
}

/// Alternating light and heavy masses on springs with both anharmonic terms.
pub(crate) struct Diatomic {
    masses: (f64, f64),
    alpha: f64,
    beta: f64,
}

#[hamiltonian]
impl Diatomic {
    fn kinetic(&self, p: &[f64; 6]) -> f64 {
        let (light, heavy) = self.masses;
        p.chunks_exact(2).map(|cell| cell[0].powi(2) / (2.0 * light) + cell[1].powi(2) / (2.0 * heavy)).sum()
    }
    fn potential(&self, q: &[f64; 6]) -> f64 {
        let mut powers = [0.0; 3];
        for pair in q.windows(2) {
            let stretch = pair[1] - pair[0];
            powers[0] += stretch.powi(2);
            powers[1] += stretch.powi(3);
            powers[2] += stretch.powi(4);
        }
        powers[0] / 2.0 + self.alpha * powers[1] / 3.0 + self.beta * powers[2] / 4.0
    }
}

impl Member for Diatomic {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { masses: (0.7, 1.9), alpha: 0.3, beta: 0.9 }
    }
    fn energies(&self, at: &Phase<[f64; 6]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        let (light, heavy) = self.masses;
        p.iter().enumerate().map(|(i, p)| *p * *p / (2.0 * if i % 2 == 0 { light } else { heavy })).sum()
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        q.windows(2).map(|pair| spring(pair[1] - pair[0], self.alpha, self.beta)).sum()
    }
}

/// Beads with contact and separation: the Hertz contact law acts where they overlap (Nesterenko 1983).
pub(crate) struct HertzBeads {
    diameter: f64,
    hardness: f64,
}

#[hamiltonian]
impl HertzBeads {
    fn kinetic(&self, p: &[f64; 4]) -> f64 {
        0.5 * p.iter().map(|p| p.powi(2)).sum::<f64>()
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        let mut energy = 0.0;
        for i in 1..4 {
            let overlap = self.diameter - (q[i] - q[i - 1]);
            if overlap > 0.0 {
                energy += 0.4 * self.hardness * overlap.powf(2.5);
            }
        }
        energy
    }
}

impl Member for HertzBeads {
    const STEP: f64 = 0.01;

    fn example() -> Self {
        Self { diameter: 1.0, hardness: 3.1 }
    }
    fn energies(&self, at: &Phase<[f64; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let contact = |pair: &[D]| {
            let overlap = pair[0] - pair[1] + self.diameter;
            if overlap > 0.0 { overlap.powf(2.5) * (0.4 * self.hardness) } else { D::zero() }
        };
        q.windows(2).map(contact).sum()
    }
}

/// `Σ p²/2`
pub(crate) fn half_squares<D: Number>(p: &[D]) -> D {
    p.iter().map(|p| *p * *p).sum::<D>() / 2.0
}

fn spring<D: Number>(stretch: D, alpha: f64, beta: f64) -> D {
    stretch.powi(2) / 2.0 + stretch.powi(3) * (alpha / 3.0) + stretch.powi(4) * (beta / 4.0)
}
