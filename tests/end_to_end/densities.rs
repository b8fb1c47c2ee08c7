//! Energies of bodies that depend on sums over their partners, such as those of embedded atoms, and sums over pairs in several loops:
//! many bodies move as the formulas say.

use super::beside_pairs::{Parameters, ROUNDING, are_near, narrow};
use integrator_core::{System, prelude::*};
use std::any::type_name;

potential!(embedded_atoms, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    for i in 0..q.len() {
        let mut density = 0.0;
        for j in 0..q.len() {
            if j != i {
                let r2 = square(i, j);
                if r2 < self.0.cutoff {
                    density += (self.0.cutoff - r2).powi(2);
                }
            }
        }
        v -= self.0.weights[i] * density.sqrt();
    }
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            let r2 = square(i, j);
            if r2 < self.0.shorter {
                v += (self.0.shorter - r2).powi(3);
            }
        }
    }
);

potential!(a_density_in_an_array, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    let mut density = vec![0.1; q.len()];
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            let r2 = square(i, j);
            if r2 < self.0.cutoff {
                let addend = self.0.charges[i] * self.0.charges[j] / (1.0 + r2).powi(2);
                density[i] += addend;
                density[j] += addend;
                v += 0.5 * r2;
            }
        }
    }
    for i in 0..q.len() {
        v += density[i] * density[i].ln();
    }
);

potential!(densities_by_type, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    for i in 0..q.len() {
        let (mut density, mut other) = (0.0, 0.0);
        for j in 0..q.len() {
            if i == j {
                continue;
            }
            let r2 = square(i, j);
            if r2 < self.0.cutoff {
                density += self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] / (1.0 + r2);
                other += self.0.charges[j] * (self.0.cutoff - r2).powi(2) * self.0.weights[i];
            }
        }
        v += (density + 0.3 * other * other).sqrt() + 0.2 * self.0.charges[i] * density * density;
    }
);

potential!(a_density_without_a_cutoff, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    for i in 0..q.len() {
        v += 0.01 * q[i][1].powi(4);
        let density: f64 = (0..q.len()).filter(|&j| j != i).map(|j| self.0.weights[j] * (-square(i, j)).exp()).sum();
        v += density.powi(2) * 0.1;
        if density > 0.5 {
            v += (density - 0.5).powi(2);
        }
    }
    for &[a, b] in &self.0.bonds {
        v += (q[a][0] - q[b][0]).powi(4);
    }
);

potential!(pairs_in_loops_of_three_orders, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    for i in 0..q.len() {
        for j in 0..q.len() {
            if i != j {
                let r2 = square(i, j);
                if r2 < self.0.cutoff {
                    v += self.0.charges[i] * self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] / (1.0 + r2);
                }
                if r2 < self.0.shorter && self.0.types[i] != self.0.types[j] {
                    v += 0.5 * r2;
                }
            }
        }
        for j in i + 1..q.len() {
            let r2 = square(i, j);
            if r2 < self.0.shorter {
                v += self.0.preceding[j - 1] as f64 * self.0.charges[i] / (30.0 + r2);
            }
        }
    }
    for i in 1..q.len() {
        for j in 0..i {
            let r2 = square(i, j);
            if r2 < self.0.cutoff {
                v += self.0.strengths[j] * self.0.weights[i] * r2;
            }
        }
    }
);

potential!(pairs_of_types_that_come_twice, self, q, v;
    let square = |i: usize, j: usize| {
        let image = |x: f64| x - self.0.side * (x / self.0.side).round();
        (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>()
    };
    for i in 0..q.len() {
        for j in 0..q.len() {
            if j == i {
                continue;
            }
            let r2 = square(i, j);
            let (a, b) = (self.0.types[i], self.0.types[j]);
            if r2 < self.0.strengths_of_types[a][b] && self.0.allowed.contains(&(a, b)) {
                v += (self.0.strengths_of_types[a][b] - r2).powi(2) / (2.0 + self.0.charges[j]);
            }
        }
    }
);

/// The derivative of a step along a direction, by a difference of steps: a sixth of the third derivative of the flow, which is of the
/// order of one, times the square of the displacement.
#[test]
fn deviation_vectors_follow_densities() -> Result<(), Error> {
    let system = embedded_atoms::InLanes(Parameters::new());
    let start = Parameters::start();
    let direction: Vec<[f64; 3]> =
        (0..start.q.len()).map(|i| [0, 1, 2].map(|d| (2.1 * i as f64 + f64::from(d)).cos())).collect();
    let displaced = |by: f64| -> Result<Vec<[f64; 3]>, Error> {
        let mut q = start.q.clone();
        for (q, direction) in q.iter_mut().flatten().zip(direction.iter().flatten()) {
            *q += by * direction;
        }
        let mut run = system.run_with(Euler, Phase::new(q, start.p.clone()), 0.1)?;
        run.advance(1)?;
        Ok(run.state().p)
    };
    let by = 1e-5;
    let (more, less) = (displaced(by)?, displaced(-by)?);
    let expected: Vec<[f64; 3]> =
        more.iter().zip(&less).map(|(more, less)| [0, 1, 2].map(|d| (more[d] - less[d]) / (2.0 * by))).collect();
    let vector = Phase::new(direction, vec![[0.0; 3]; start.q.len()]);
    let mut tangent = system.tangent(Euler, start, [vector], 0.1)?;
    tangent.advance(1)?;
    are_near(&tangent.vectors()[0].p, &expected, 1e-6);
    Ok(())
}

/// On any number of threads, and after the lists of neighbours were made anew.
#[test]
fn threads_change_no_bit_of_densities() -> Result<(), Error> {
    for threads in [2, 3] {
        let system = embedded_atoms::InLanes(Parameters::new());
        let mut alone = system.run_with(Verlet, Parameters::start(), 0.02)?;
        let mut shared = system.run_with(Verlet, Parameters::start(), 0.02)?.with_threads(threads);
        for _ in 0..3 {
            alone.advance(20)?;
            shared.advance(20)?;
            assert_eq!(alone.state(), shared.state());
            assert_eq!(alone.energy().to_bits(), shared.energy().to_bits());
        }
    }
    Ok(())
}
