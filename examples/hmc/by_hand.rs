//! Hamiltonian Monte Carlo with the leapfrog as a hand-written loop and a hand-written gradient, for comparison.

use crate::{
    normal_density::{COUNT, Normal},
    sampler::normal::normal,
};

/// Sampler with the method and the random numbers of [`Sampler`](crate::sampler::Sampler).
pub(crate) struct ByHand {
    density: Normal,
    step: f64,
    steps: u64,
    random: fastrand::Rng,
    at: [f64; COUNT],
}

impl ByHand {
    pub(crate) fn new(density: Normal, step: f64, steps: u64, seed: u64) -> Self {
        Self { density, step, steps, random: fastrand::Rng::with_seed(seed), at: [0.0; COUNT] }
    }

    /// Returns the next point.
    pub(crate) fn draw(&mut self) -> [f64; COUNT] {
        let (mut q, mut p) = (self.at, std::array::from_fn(|_| normal(&mut self.random)));
        let before = self.energy(&q, &p);
        self.kick(&q, &mut p, 0.5 * self.step);
        for _ in 0..self.random.u64(1..=self.steps) {
            for i in 0..COUNT {
                q[i] += self.step * p[i];
            }
            self.kick(&q, &mut p, self.step);
        }
        self.kick(&q, &mut p, -0.5 * self.step);
        if self.random.f64() < (before - self.energy(&q, &p)).exp() {
            self.at = q;
        }
        self.at
    }

    fn kick(&self, q: &[f64; COUNT], p: &mut [f64; COUNT], by: f64) {
        for i in 0..COUNT {
            p[i] -= by * self.density.stiffness[i] * q[i];
        }
    }

    fn energy(&self, q: &[f64; COUNT], p: &[f64; COUNT]) -> f64 {
        (0..COUNT).map(|i| 0.5 * (p[i] * p[i] + self.density.stiffness[i] * q[i] * q[i])).sum()
    }
}
