//! Quadratic forms that are squares and products of sums over loops.

use integrator_core::{Aba864, check::certify, prelude::*};

/// Rotors of different inertia in a common field: their fluctuation about the mean, their flux, and both together.
struct Common {
    weights: Vec<f64>,
    strength: f64,
}

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Common {
    fn hamiltonian(&self, q: &[f64], p: &[f64]) -> f64 {
        let (mut sum, mut all, mut flux, mut both) = (0.0, 0.0, 0.0, 0.0);
        for i in 0..q.len() {
            sum += 0.5 * p[i] * p[i] + 0.1 * q[i].powi(4);
            all += q[i];
            flux += self.weights[i] * p[i];
            both += self.weights[i] * (q[i] - 0.5 * p[i]);
        }
        for i in 0..q.len() {
            sum += (q[i] - 0.2 * all + 0.1 * flux - 0.3).powi(2);
        }
        sum + self.strength * flux * flux + 0.1 * all * both
    }
}

/// The same, each product as one sum in two loops or more.
struct Written(Common);

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Written {
    fn hamiltonian(&self, q: &[f64], p: &[f64]) -> f64 {
        let w = &self.0.weights;
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += 0.5 * p[i] * p[i] + 0.1 * q[i].powi(4) + (q[i] - 0.3).powi(2);
            for j in 0..q.len() {
                sum += self.0.strength * w[i] * p[i] * w[j] * p[j] + 0.1 * q[i] * w[j] * (q[j] - 0.5 * p[j]);
                sum += 2.0 * (q[i] - 0.3) * (0.1 * w[j] * p[j] - 0.2 * q[j]);
                for k in 0..q.len() {
                    sum += (0.1 * w[j] * p[j] - 0.2 * q[j]) * (0.1 * w[k] * p[k] - 0.2 * q[k]);
                }
            }
        }
        sum
    }
}

fn common() -> Common {
    Common { weights: vec![0.4, -0.3, 0.7, 0.2], strength: 0.3 }
}

fn start() -> Phase<Vec<f64>> {
    Phase::new(vec![0.3, -0.2, 0.5, 0.1], vec![0.1, 0.4, -0.3, 0.2])
}

#[test]
fn products_of_sums_move_as_if_they_were_written_in_two_loops() {
    let end = |run: Result<Run<Vec<f64>>, Error>| {
        let mut run = run.expect("a good start");
        run.advance(100).expect("finite");
        let Phase { q, p } = run.state();
        [q, p, vec![run.energy()]].concat()
    };
    let (sums, loops) = (end(common().run(start(), 0.1)), end(Written(common()).run(start(), 0.1)));
    for (one, two) in sums.iter().zip(&loops) {
        // Coefficients of size one are rounded in another order, and so are states of size one in a hundred steps.
        assert!((one - two).abs() <= 1e-13, "{sums:?} {loops:?}");
    }
}

#[test]
fn products_of_sums_are_certified() {
    certify::<_, _, f64>(&common(), Aba864, start(), 0.05).unwrap_or_else(|error| panic!("{error}"));
}
