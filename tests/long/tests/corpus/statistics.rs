//! Targets of Hamiltonian Monte Carlo: `V` is the negative logarithm of a posterior density.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// Number of weights of a regression.
const WEIGHTS: usize = 3;

/// Logistic regression with a normal prior.
pub(crate) struct Logistic {
    rows: Vec<[f64; WEIGHTS]>,
    labels: Vec<bool>,
    prior: f64,
}

#[hamiltonian]
impl Logistic {
    fn kinetic(&self, p: &[f64; WEIGHTS]) -> f64 {
        0.5 * p.iter().map(|p| p * p).sum::<f64>()
    }
    fn potential(&self, w: &[f64; WEIGHTS]) -> f64 {
        let mut energy = w.iter().map(|w| 0.5 * self.prior * w * w).sum::<f64>();
        for n in 0..self.rows.len() {
            let mut logit = 0.0;
            for k in 0..WEIGHTS {
                logit += self.rows[n][k] * w[k];
            }
            let sign = if self.labels[n] { -1.0 } else { 1.0 };
            energy += (sign * logit).exp().ln_1p();
        }
        energy
    }
}

impl Member for Logistic {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        let rows = vec![[1.0, 0.5, -1.2], [1.0, -0.3, 0.8], [1.0, 1.4, 0.1], [1.0, -0.9, -0.6]];
        Self { rows, labels: vec![true, false, true, false], prior: 0.25 }
    }
    fn energies(&self, at: &Phase<[f64; WEIGHTS]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let loss = |(row, label): (&[f64; WEIGHTS], &bool)| {
            let logit: D = q.iter().zip(row).map(|(w, x)| *w * *x).sum();
            (if *label { -logit } else { logit }).exp().ln_1p()
        };
        half_squares(q) * self.prior + self.rows.iter().zip(&self.labels).map(loss).sum::<D>()
    }
}

/// Counts with a rate that is the exponential of a line (Poisson regression).
pub(crate) struct Poisson {
    x: Vec<f64>,
    counts: Vec<usize>,
}

#[hamiltonian]
impl Poisson {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, [offset, slope]: [f64; 2]) -> f64 {
        let mut energy = 0.5 * (offset.powi(2) + slope.powi(2));
        for (x, count) in self.x.iter().zip(self.counts.iter()) {
            let rate = offset + slope * x;
            energy += rate.exp() - *count as f64 * rate;
        }
        energy
    }
}

impl Member for Poisson {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { x: vec![-0.5, 0.25, 1.0, 1.5], counts: vec![1, 0, 3, 4] }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let loss = |(x, count): (&f64, &usize)| {
            let rate = q[1] * *x + q[0];
            rate.exp() - rate * *count as f64
        };
        half_squares(q) + self.x.iter().zip(&self.counts).map(loss).sum::<D>()
    }
}

/// A funnel: one coordinate is the logarithm of the width of all others (Neal 2003).
pub(crate) struct Funnel;

#[hamiltonian]
impl Funnel {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let width = q[0];
        let others = (q.len() - 1) as f64;
        let squares: f64 = q.iter().skip(1).map(|x| x * x).sum();
        width * width / 18.0 + 0.5 * (-width).exp() * squares + 0.5 * others * width
    }
}

impl Member for Funnel {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self
    }
    fn energies(&self, at: &Phase<Vec<f64>>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let others = &q[1..];
        q[0] * q[0] / 18.0 + half_squares(others) * (-q[0]).exp() + q[0] * (others.len() as f64 / 2.0)
    }
}

/// A banana: the Rosenbrock (1960) valley as a density, over pairs of coordinates.
pub(crate) struct Rosenbrock {
    steepness: f64,
}

#[hamiltonian]
impl Rosenbrock {
    fn kinetic(&self, p: &[f64; 4]) -> f64 {
        0.5 * p.iter().map(|p| p.powi(2)).sum::<f64>()
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        let mut energy = 0.0;
        for i in (0..4).step_by(2) {
            energy += self.steepness * (q[i + 1] - q[i].powi(2)).powi(2) + (1.0 - q[i]).powi(2);
        }
        energy / 20.0
    }
}

impl Member for Rosenbrock {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { steepness: 100.0 }
    }
    fn energies(&self, at: &Phase<[f64; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let valley = |pair: &[D]| {
            let (wall, floor) = (pair[1] - pair[0] * pair[0], pair[0] - 1.0);
            wall * wall * (self.steepness / 20.0) + floor * floor / 20.0
        };
        q.chunks(2).map(valley).sum()
    }
}

/// A mixture of two normal densities, with a logarithm that cannot overflow.
pub(crate) struct Mixture {
    means: [[f64; 2]; 2],
    weight: f64,
}

#[hamiltonian]
impl Mixture {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + p[1] * p[1] / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let first = self.weight.ln() - self.distance(q, 0);
        let second = (1.0 - self.weight).ln() - self.distance(q, 1);
        let largest = first.max(second);
        -largest - ((first - largest).exp() + (second - largest).exp()).ln()
    }
    fn distance(&self, [x, y]: [f64; 2], mode: usize) -> f64 {
        0.5 * ((x - self.means[mode][0]).powi(2) + (y - self.means[mode][1]).powi(2))
    }
}

impl Member for Mixture {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { means: [[-1.0, 0.5], [1.5, 0.0]], weight: 0.3 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let mode =
            |(weight, [x, y]): (f64, [f64; 2])| (-((q[0] - x).powi(2) + (q[1] - y).powi(2)) / 2.0).exp() * weight;
        -[self.weight, 1.0 - self.weight].into_iter().zip(self.means).map(mode).sum::<D>().ln()
    }
}

/// Eight schools with different coaching effects (Rubin 1981): a hierarchical normal model with the logarithm of its
/// width as a coordinate.
pub(crate) struct Schools {
    effects: [f64; 3],
    errors: [f64; 3],
}

#[hamiltonian]
impl Schools {
    /// Scale of the common width.
    const UNIT: f64 = 5.0;

    fn kinetic(&self, p: &[f64; 5]) -> f64 {
        p.iter().map(|p| p * p).sum::<f64>() * 0.5
    }
    fn potential(&self, q: &[f64; 5]) -> f64 {
        let (mean, log_width) = (q[3], q[4]);
        let width = log_width.exp();
        let mut energy = 0.5 * (mean / Self::UNIT).powi(2) + 0.5 * log_width * log_width;
        for i in 0..3 {
            let school = mean + width * q[i];
            energy += 0.5 * q[i].powi(2) + 0.5 * ((self.effects[i] - school) / self.errors[i]).powi(2);
        }
        energy
    }
}

impl Member for Schools {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { effects: [2.8, 0.8, -0.3], errors: [1.5, 1.0, 1.6] }
    }
    fn energies(&self, at: &Phase<[f64; 5]>, _: f64) -> [f64; 2] {
        [self.kinetic(&at.p), self.potential(&at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let width = q[4].exp();
        let school = |i: usize| ((q[3] + width * q[i] - self.effects[i]) / self.errors[i]).powi(2);
        half_squares(&q[..3])
            + (q[3] * q[3] / Self::UNIT.powi(2) + q[4] * q[4] + school(0) + school(1) + school(2)) / 2.0
    }
}

/// A robust location: errors follow Student's distribution.
pub(crate) struct Student {
    data: Vec<f64>,
    freedom: f64,
}

#[hamiltonian]
impl Student {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0].powi(2) + p[1].powi(2))
    }
    fn potential(&self, [location, log_scale]: [f64; 2]) -> f64 {
        let precision = (-2.0 * log_scale).exp();
        let mut energy = 0.1 * (location * location + log_scale * log_scale) + self.data.len() as f64 * log_scale;
        for x in &self.data {
            let residual = x - location;
            energy += 0.5 * (self.freedom + 1.0) * (precision * residual * residual / self.freedom).ln_1p();
        }
        energy
    }
}

impl Member for Student {
    const STEP: f64 = 0.02;

    fn example() -> Self {
        Self { data: vec![0.3, -0.4, 0.9, 5.5, 0.1], freedom: 3.0 }
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let scaled = |x: &f64| (((q[0] - *x) / q[1].exp()).powi(2) / self.freedom).ln_1p();
        let tails: D = self.data.iter().map(scaled).sum();
        half_squares(q) * 0.2 + q[1] * self.data.len() as f64 + tails * ((self.freedom + 1.0) / 2.0)
    }
}

/// Heavy tails multiplied before the logarithm, and an exponent that is a coordinate.
pub(crate) struct HeavyTails {
    scale: f64,
}

#[hamiltonian]
impl HeavyTails {
    fn kinetic(&self, p: [f64; 4]) -> f64 {
        let pairs = ([p[0], p[1]], (p[2], p[3]));
        let ([a, b], last) = pairs;
        (a * a + b * b + last.0 * last.0 + last.1 * last.1) / 2.0
    }
    fn potential(&self, q: [f64; 4]) -> f64 {
        let mut product = 1.0;
        for i in 0..4 {
            product *= 1.0 + (q[i] / self.scale).powi(2);
        }
        let mut far = q[1] * q[1];
        far += 15e-1_f64;
        product.ln() + 0.05 * [q[0], q[3]].iter().map(|x| x * x).sum::<f64>() + far.powf(0.1 * q[2])
    }
}

impl Member for HeavyTails {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { scale: 0.8 }
    }
    fn energies(&self, at: &Phase<[f64; 4]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let tails: D = q.iter().map(|x| (x.powi(2) / self.scale.powi(2)).ln_1p()).sum();
        let power = ((q[1] * q[1] + 1.5).ln() * q[2] * 0.1).exp();
        tails + (q[0] * q[0] + q[3] * q[3]) * 0.05 + power
    }
}
