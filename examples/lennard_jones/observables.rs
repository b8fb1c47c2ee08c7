//! Observables of a liquid: radial distribution and mean square displacement.

use crate::liquid::{Argon, DENSITY};
use integrator_core::prelude::Phase;
use std::f64::consts::PI;

/// Positions and momenta of atoms.
type State = Phase<Vec<[f64; 3]>>;

/// Histogram of distances between atoms, for the radial distribution function.
pub(crate) struct Distances {
    side: f64,
    width: f64,
    counts: Vec<u64>,
    /// Number of samples, and of central atoms in them.
    samples: usize,
    atoms: usize,
}

/// Approximate number of central atoms per sample, different ones each time.
const CENTRES: usize = 500;

impl Distances {
    /// Creates an empty histogram of distances up to `radius`, at most half the side of the box.
    pub(crate) fn new(argon: &Argon, radius: f64, classes: usize) -> Self {
        let width = radius.min(argon.side / 2.0) / classes as f64;
        Self { side: argon.side, width, counts: vec![0; classes], samples: 0, atoms: 0 }
    }

    /// Adds a sample of the distances.
    pub(crate) fn add(&mut self, state: &State) {
        // Wrapped into the box, so that the nearest image is at most one box away.
        let (side, all) = (self.side, state.q.len());
        let in_box = |axis: usize| state.q.iter().map(move |q| q[axis].rem_euclid(side)).collect();
        let (places, stride): ([Vec<f64>; 3], usize) = ([0, 1, 2].map(in_box), (all / CENTRES).max(1));
        let last = self.counts.len() - 1;
        let limit = (self.width * (last + 1) as f64).powi(2);
        let mut squares = vec![0.0; all];
        for atom in (self.samples % stride..all).step_by(stride) {
            squares.fill(0.0);
            for along in &places {
                for (square, place) in squares.iter_mut().zip(along) {
                    let apart = (place - along[atom]).abs();
                    let apart = apart.min(side - apart);
                    *square += apart * apart;
                }
            }
            for (other, square) in squares.iter().enumerate() {
                if *square < limit && other != atom {
                    let class = (square.sqrt() / self.width) as usize;
                    self.counts[class.min(last)] += 1;
                }
            }
            self.atoms += 1;
        }
        self.samples += 1;
    }

    /// Returns `g(r)` at the centre of each class: the density of atoms relative to the mean density.
    pub(crate) fn distribution(&self) -> Vec<(f64, f64)> {
        let volume = |radius: f64| 4.0 / 3.0 * PI * radius.powi(3);
        let mut distribution = Vec::with_capacity(self.counts.len());
        for (class, count) in self.counts.iter().enumerate() {
            let [from, to] = [class, class + 1].map(|edge| edge as f64 * self.width);
            let expected = DENSITY * (volume(to) - volume(from)) * self.atoms as f64;
            distribution.push(((from + to) / 2.0, *count as f64 / expected));
        }
        distribution
    }
}

/// Returns position and height of the largest peak, by a parabola through three classes.
pub(crate) fn peak(distribution: &[(f64, f64)]) -> Option<(f64, f64)> {
    let highest = distribution.windows(3).max_by(|a, b| a[1].1.total_cmp(&b[1].1))?;
    let [(left, a), (middle, b), (_, c)] = [highest[0], highest[1], highest[2]];
    let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
    Some((middle + shift * (middle - left), b - 0.25 * (a - c) * shift))
}

/// Returns the mean square displacement.
pub(crate) fn mean_square(from: &State, to: &State) -> f64 {
    let square = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>();
    from.q.iter().zip(&to.q).map(square).sum::<f64>() / from.q.len() as f64
}

/// Returns the diffusion coefficient, a sixth of the slope of the mean square displacement (Einstein), by least squares.
pub(crate) fn diffusion(squares: &[(f64, f64)]) -> f64 {
    let mean = |of: fn(&(f64, f64)) -> f64| squares.iter().map(of).sum::<f64>() / squares.len() as f64;
    let (time, square) = (mean(|at| at.0), mean(|at| at.1));
    let [mut both, mut times] = [0.0; 2];
    for at in squares {
        both += (at.0 - time) * (at.1 - square);
        times += (at.0 - time).powi(2);
    }
    both / times / 6.0
}
