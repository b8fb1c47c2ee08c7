//! Growth of rounding errors in the energies of many ensemble members over a long time.
//!
//! Unbiased rounding changes the energy by a random walk, so the error grows with the root of the number of steps (Brouwer
//! 1937). Any bias finally grows in proportion to the number of steps.

use integrator_core::{Coords, prelude::*};

/// Number of consecutive steps over which an energy is averaged. The average removes the rounding of the energy itself
/// and most of the oscillation of the method.
const AVERAGED: u64 = 64;

/// Number of energy samples; the number of steps doubles from one to the next.
const LOOKS: u32 = 10;

/// Growth of the energy errors of an ensemble.
pub(crate) struct Growth {
    /// Number of steps, and root mean square change of the energies in units of their mean size.
    pub(crate) looks: Vec<(u64, f64)>,
    /// Exponent of the power law fitted to these samples.
    pub(crate) exponent: f64,
    /// Mean change at the end in units of its standard error.
    pub(crate) bias: f64,
}

/// Measures the growth over `steps` steps.
pub(crate) fn growth<C: Coords>(mut swarm: Ensemble<C>, steps: u64) -> Result<Growth, Error> {
    let begin = energies(&mut swarm)?;
    // The energy of a single member may be zero.
    let scale = begin.iter().map(|energy| energy.abs()).sum::<f64>() / begin.len() as f64;
    let mut looks = Vec::new();
    let mut changes = Vec::new();
    for halvings in (0..LOOKS).rev() {
        let at = (steps >> halvings).max(swarm.steps());
        swarm.advance(at - swarm.steps())?;
        let now = energies(&mut swarm)?;
        changes = begin.iter().zip(&now).map(|(begin, now)| (now - begin) / scale).collect();
        looks.push((at, (changes.iter().map(|change| change * change).sum::<f64>() / changes.len() as f64).sqrt()));
    }
    let logarithms: Vec<(f64, f64)> = looks.iter().map(|(steps, change)| ((*steps as f64).ln(), change.ln())).collect();
    Ok(Growth { exponent: slope(&logarithms), bias: bias(&changes), looks })
}

/// Returns the energies of all members, each averaged over the next steps.
fn energies<C: Coords>(swarm: &mut Ensemble<C>) -> Result<Vec<f64>, Error> {
    let mut sums = vec![0.0; swarm.len()];
    for _ in 0..AVERAGED {
        swarm.advance(1)?;
        for (member, sum) in sums.iter_mut().enumerate() {
            *sum += swarm.energy(member).unwrap_or(f64::NAN) / AVERAGED as f64;
        }
    }
    Ok(sums)
}

/// Returns the slope of the least-squares line through the points.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x_mean, y_mean) = (mean(|point| point.0), mean(|point| point.1));
    let of = |weight: fn(f64, f64) -> f64| points.iter().map(|(x, y)| weight(x - x_mean, y - y_mean)).sum::<f64>();
    of(|x, y| x * y) / of(|x, _| x * x)
}

/// Returns the mean in units of its standard error.
fn bias(values: &[f64]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
    mean / (variance / count).sqrt()
}
