//! Logistic regression of O-ring distress on the temperature, as a Hamiltonian.

#[path = "../support/table.rs"]
mod table;

use integrator_core::prelude::*;
use std::num::ParseFloatError;
use table::{numbers, rows};

/// The observations, and the prior of intercept and slope.
#[derive(Clone)]
pub(crate) struct Posterior {
    /// Temperatures minus their mean, in units of their standard deviation.
    scaled: Vec<f64>,
    /// 1 for distress, 0 for none.
    distress: Vec<f64>,
    mean: f64,
    deviation: f64,
    /// Standard deviation of the normal prior of both coefficients.
    pub(crate) prior: f64,
}

#[hamiltonian(compose = VelocityVerlet)]
impl Posterior {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    /// Returns the negative logarithm of the posterior density, up to a constant.
    pub(crate) fn potential(&self, b: [f64; 2]) -> f64 {
        let mut energy = 0.5 * (b[0] * b[0] + b[1] * b[1]) / self.prior.powi(2);
        for i in 0..self.scaled.len() {
            let x = b[0] + b[1] * self.scaled[i];
            energy += x.exp().ln_1p() - self.distress[i] * x;
        }
        energy
    }
}

impl Posterior {
    /// Reads the launches from the table.
    pub(crate) fn measured(prior: f64) -> Result<Self, ParseFloatError> {
        let table = include_str!("../data/challenger.csv");
        let launches: Vec<[f64; 2]> = rows(table).map(|row| numbers(&row, 0)).collect::<Result<_, _>>()?;
        let count = launches.len() as f64;
        let mean = launches.iter().map(|[temperature, _]| temperature).sum::<f64>() / count;
        let variance = launches.iter().map(|[temperature, _]| (temperature - mean).powi(2)).sum::<f64>() / count;
        let (scaled, distress) = launches.iter().map(|[t, distress]| ((t - mean) / variance.sqrt(), *distress)).unzip();
        Ok(Self { scaled, distress, mean, deviation: variance.sqrt(), prior })
    }

    /// Returns `(temperature, distress)` of every launch.
    pub(crate) fn launches(&self) -> impl Iterator<Item = (f64, f64)> {
        let temperature = |scaled: &f64| self.mean + self.deviation * scaled;
        self.scaled.iter().map(temperature).zip(self.distress.iter().copied())
    }

    /// Converts coefficients of scaled temperatures to an intercept and a slope per degree.
    pub(crate) fn per_degree(&self, b: [f64; 2]) -> [f64; 2] {
        [b[0] - b[1] * self.mean / self.deviation, b[1] / self.deviation]
    }

    /// Returns the probability of distress at a temperature.
    pub(crate) fn probability(&self, b: [f64; 2], temperature: f64) -> f64 {
        1.0 / (1.0 + (-b[0] - b[1] * (temperature - self.mean) / self.deviation).exp())
    }

    /// Returns the posterior mean of a function by a sum over a grid with `side` points per axis.
    ///
    /// Beyond eight in either direction the density is below 1e-9 of its greatest; a sum over equal distances of a smooth
    /// density that vanishes at the border converges faster than any power.
    pub(crate) fn mean_on_grid<const N: usize>(&self, side: u32, function: impl Fn([f64; 2]) -> [f64; N]) -> [f64; N] {
        let (mut whole, mut sums) = (0.0, [0.0; N]);
        let place = |i: u32| 20.0 * (f64::from(i) + 0.5) / f64::from(side) - 10.0;
        for b in (0..side).flat_map(|i| (0..side).map(move |j| [place(i), place(j)])) {
            let density = (-self.potential(b)).exp();
            whole += density;
            for (sum, value) in sums.iter_mut().zip(function(b)) {
                *sum += density * value;
            }
        }
        sums.map(|sum| sum / whole)
    }
}
