//! A potential tabulated at a few distances, with a user-provided derivative of the spline between them.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// A bond with tabulated energies and forces, and cubic Hermite polynomials in between.
#[derive(Clone)]
pub(crate) struct Tabulated {
    cell: f64,
    values: [f64; 4],
    slopes: [f64; 4],
}

#[hamiltonian]
impl Tabulated {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.spline(x) + 0.01 * x.powi(2)
    }
    #[derivative(slope)]
    fn spline(&self, x: f64) -> f64 {
        let (s, [a, u, b, v]) = self.around(x);
        (a * (1.0 + 2.0 * s) + u * s) * (1.0 - s).powi(2) + (b * (3.0 - 2.0 * s) - v * (1.0 - s)) * s.powi(2)
    }
    #[derivative(curvature)]
    fn slope(&self, x: f64) -> f64 {
        let (s, [a, u, b, v]) = self.around(x);
        ((b - a) * 6.0 * s * (1.0 - s) + u * (1.0 - s) * (1.0 - 3.0 * s) + v * s * (3.0 * s - 2.0)) / self.cell
    }
    fn curvature(&self, x: f64) -> f64 {
        let (s, [a, u, b, v]) = self.around(x);
        ((b - a) * (6.0 - 12.0 * s) + u * (6.0 * s - 4.0) + v * (6.0 * s - 2.0)) / self.cell.powi(2)
    }
    /// Returns the relative position within a cell, and the values and slopes (per cell) at both ends of the cell.
    fn around(&self, x: f64) -> (f64, [f64; 4]) {
        let cells = x / self.cell;
        let left = (cells as usize).min(2);
        let slope = |node: usize| self.slopes[node] * self.cell;
        (cells - left as f64, [self.values[left], slope(left), self.values[left + 1], slope(left + 1)])
    }
}

impl Member for Tabulated {
    const STEP: f64 = 0.05;

    fn example() -> Self {
        Self { cell: 0.75, values: [1.5, -0.2, -0.4, 0.3], slopes: [-3.0, -1.1, 0.4, 1.2] }
    }
    fn energies(&self, at: &Phase<[f64; 1]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        half_squares(p)
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let left = (0..2).take_while(|left| q[0] >= (left + 1) as f64 * self.cell).count();
        let s = q[0] / self.cell - left as f64;
        let end = |node: usize, s: D| {
            let inward = if node == left { self.cell } else { -self.cell };
            (s * 2.0 + 1.0) * self.values[node] + s * (inward * self.slopes[node])
        };
        let rest = -s + 1.0;
        end(left, s) * rest * rest + end(left + 1, rest) * s * s + q[0] * q[0] * 0.01
    }
}
