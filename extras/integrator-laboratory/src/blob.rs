//! A set of starts that moves with the flow, and its area: Poincaré's integral invariant `Σ ∮ pᵢ dqᵢ`.

use crate::{
    errors::Exact,
    plan::Plan,
    problem::{Problem, Stepped, numbers},
};
use integrator_core::{Coords, prelude::*};
use std::{error::Error, f64::consts::TAU};

/// The outline of the blob at some times, in the plane of the first position and its momentum, and its area.
#[derive(Clone, Debug, Default)]
pub(crate) struct Blob {
    pub(crate) outlines: Vec<Vec<(f64, f64)>>,
    /// Periods, and the area in units of that at the start.
    pub(crate) areas: Vec<(f64, f64)>,
}

impl Blob {
    /// The last area.
    pub(crate) fn area(&self) -> f64 {
        self.areas.last().map_or(f64::NAN, |(_, area)| *area)
    }
}

/// The duration over which the blob is integrated, in periods, and the number of samples.
const PERIODS: f64 = 1.5;
const LOOKS: usize = 30;
/// The interval in samples at which the outline is kept.
const SHOWN: usize = 5;
/// The largest factor by which an outline has more points.
const FOLDED: u32 = 4;
/// The radii of the blob in units of the orbit.
const BLOB: f64 = 0.02;

/// Follows the outline of the blob.
pub(crate) fn follow<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Blob, Box<dyn Error>> {
    let interval = ((PERIODS * problem.period / problem.step) as u64 / LOOKS as u64).max(1);
    let radii = problem.blob.map_or(exact.size.map(|size| BLOB * size), |radius| [radius; 2]);
    // For each look, all points of the outline.
    let mut looks: Vec<Vec<Vec<f64>>> = vec![Vec::new(); LOOKS + 1];
    // A part of the orbit that is fast folds the outline.
    let count = plan.outline * problem.haste.min(FOLDED) as usize;
    for point in 0..count {
        let (sine, cosine) = (TAU * point as f64 / count as f64).sin_cos();
        let mut start = problem.start.clone();
        // Against the sense of ∮ p dq, so that the area begins positive.
        start.q.flat_mut()[0] += radii[0] * cosine;
        start.p.flat_mut()[0] -= radii[1] * sine;
        let run = method.run(&start, problem.step)?;
        for (look, sample) in looks.iter_mut().zip(run.samples(interval).map_while(Result::ok)) {
            look.push(numbers(&sample.state));
        }
    }
    // Where a point is lost, so is the outline.
    looks.retain(|look| look.len() == count);
    let time = |look: usize| look as f64 * interval as f64 * problem.step / problem.period;
    let freedom = problem.start.q.flat().len();
    let first = invariant(&looks[0], freedom);
    let areas = looks.iter().enumerate().map(|(i, look)| (time(i), invariant(look, freedom) / first));
    let outline = |look: &Vec<Vec<f64>>| look.iter().map(|state| (state[0], state[freedom])).collect();
    Ok(Blob { areas: areas.collect(), outlines: looks.iter().step_by(SHOWN).map(outline).collect() })
}

/// `Σ ∮ pᵢ dqᵢ` around a closed curve that points at equal angles of its parameter tell. Both the derivative, that of
/// the trigonometric polynomial through the points, and the sum, which is the trapezoid rule, are exact up to the
/// resolution of the curve.
pub(crate) fn invariant(outline: &[Vec<f64>], freedom: usize) -> f64 {
    let count = outline.len();
    // The derivative at one point is a sum over the others, of (-1)ᵏ cot(kπ/N) / 2 at a distance of k points.
    let weight = |k: usize| {
        let sign = if k.is_multiple_of(2) { 0.5 } else { -0.5 };
        sign / (0.5 * TAU * k as f64 / count as f64).tan()
    };
    let weights: Vec<f64> = (1..count).map(weight).collect();
    let mut sum = 0.0;
    for i in 0..freedom {
        for (j, state) in outline.iter().enumerate() {
            let terms = weights.iter().enumerate().map(|(k, weight)| weight * outline[(j + count - k - 1) % count][i]);
            sum += state[freedom + i] * terms.sum::<f64>();
        }
    }
    sum * TAU / count as f64
}

#[cfg(test)]
mod tests {
    use super::invariant;

    /// The invariant of an ellipse is its area, whatever plane it lies in.
    #[test]
    fn the_invariant_is_the_area() {
        let circle = |freedom: usize, plane: usize| -> Vec<Vec<f64>> {
            let point = |k: usize| {
                let (sine, cosine) = (std::f64::consts::TAU * k as f64 / 64.0).sin_cos();
                let mut state = vec![0.3; 2 * freedom];
                state[plane] += 2.0 * cosine;
                state[freedom + plane] -= 0.5 * sine;
                state
            };
            (0..64).map(point).collect()
        };
        for (freedom, plane) in [(1, 0), (2, 0), (3, 2)] {
            let area = invariant(&circle(freedom, plane), freedom);
            assert!((area - std::f64::consts::PI).abs() < 1e-12, "{area}");
        }
    }
}
