//! Sums whose ends differ from the rest: conditions on indices, tables beside them, and loops over components. A kick from rest is
//! the gradient of the user's own potential, at every length.

use integrator_core::prelude::*;

const STEP: f64 = 1.0;

/// The distance of central differences. With it they are good to 1e-10 times a third derivative, and to the rounding of an
/// energy over it, 1e-10: third derivatives and energies here are below a hundred.
const SHIFT: f64 = 1e-5;
const NEAR: f64 = 1e-7;

const LENGTHS: [usize; 9] = [1, 2, 3, 4, 5, 8, 9, 17, 40];

fn wave(k: usize) -> f64 {
    (0.37 * k as f64 + 0.2).sin()
}

/// Weights of sites, and an inverse mass.
struct Weights(Vec<f64>, f64);

fn weights() -> Weights {
    Weights((0..60).map(|i| 0.5 + 0.1 * i as f64).collect(), 1.0)
}

macro_rules! chain {
    ($name:ident, $shortest:literal, |$self:ident, $q:ident, $n:ident, $v:ident| $($body:tt)*) => {
        mod $name {
            use super::*;

            struct Chain(Weights);

            #[hamiltonian]
            impl Chain {
                fn kinetic(&self, p: &[f64]) -> f64 {
                    p.iter().map(|p| 0.5 * self.0.1 * p * p).sum()
                }
                fn potential(&$self, $q: &[f64]) -> f64 {
                    let $n = $q.len();
                    let mut $v = 0.0;
                    $($body)*
                    $v
                }
            }

            #[test]
            fn kicks_are_gradients() -> Result<(), Error> {
                for length in LENGTHS.into_iter().filter(|length| *length >= $shortest) {
                    let (system, q) = (Chain(weights()), (0..length).map(wave).collect::<Vec<_>>());
                    let mut run = Chain(weights()).run_with(Euler, Phase::new(q.clone(), vec![0.0; length]), STEP)?;
                    run.advance(1)?;
                    for (i, p) in run.state().p.into_iter().enumerate() {
                        let at = |shift: f64| {
                            let mut q = q.clone();
                            q[i] += shift;
                            system.potential(&q)
                        };
                        let slope = (at(SHIFT) - at(-SHIFT)) / (2.0 * SHIFT);
                        assert!((p + STEP * slope).abs() < NEAR * (1.0 + slope.abs()), "{i} of {length}: {p} for {}", -slope);
                    }
                }
                Ok(())
            }
        }
    };
}

chain!(a_table_beside_the_end, 3, |self, q, n, v|
    for i in 0..n {
        v += 0.5 * q[i].powi(2);
    }
    for i in n - 2..n {
        v += q[i].powi(4) + self.0.0[i] * q[i - 1].powi(2);
    }
);
chain!(a_table_on_a_ring, 2, |self, q, n, v| for i in 0..n {
    v += 0.5 * self.0.0[i] * q[i].powi(2);
    v += (q[(i + 1) % n] - q[i]).powi(4) / 4.0;
    if i == n - 1 {
        v += q[i] * q[i - 1];
    }
});
chain!(the_last_bonds, 1, |self, q, n, v|
    for i in 0..n {
        v += 0.5 * q[i].powi(2);
    }
    for i in n.saturating_sub(3)..n - 1 {
        v += 0.5 * (q[i + 1] - q[i]).powi(2);
    }
);
chain!(the_first_bond, 1, |self, q, n, v| for i in 0..n {
    v += 0.5 * q[i].powi(2);
    if i == 1 {
        v += 0.5 * (q[i] - q[i - 1]).powi(2);
    }
});
chain!(the_first_bonds, 1, |self, q, n, v| for i in 0..n {
    v += 0.5 * q[i].powi(2);
    if i > 0 && i < 3 {
        v += 0.25 * (q[i] - q[i - 1]).powi(4);
    }
});
chain!(a_table_at_the_end, 1, |self, q, n, v| for i in 0..n {
    if i > 0 {
        v += (q[i] - q[i - 1]).powi(4) / 4.0;
    }
    if i + 1 == n {
        v += 0.5 * self.0.0[i] * q[i].powi(2);
    }
});
chain!(the_next_on_a_ring_is_asked, 1, |self, q, n, v| for i in 0..n {
    if q[(i + 1) % n] > 0.0 {
        v += 0.5 * q[i].powi(2);
    }
});
chain!(the_next_of_the_first_ones, 1, |self, q, n, v| for i in 0..n {
    v += 0.5 * q[i].powi(2);
    if i < 2 {
        v += 0.3 * q[(i + 1) % n];
    }
});
chain!(the_bond_before_the_last, 1, |self, q, n, v| for i in 0..n {
    v += 0.1 * q[i].powi(4);
    if i + 2 == n {
        v += 0.5 * (q[i + 1] - q[i]).powi(2);
    }
});
chain!(one_coordinate_by_two_indices, 1, |self, q, n, v|
    let s: f64 = (0..n - 1).map(|i| (q[i + 1] * q[i]).sin() * q[1 + i].cos()).sum();
    v += s * s;
);

macro_rules! points {
    ($name:ident, |$q:ident, $v:ident| $($body:tt)*) => {
        mod $name {
            use super::*;

            struct Points;

            #[hamiltonian]
            impl Points {
                fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                    p.iter().flatten().map(|p| 0.5 * p * p).sum()
                }
                fn potential(&self, $q: &[[f64; 3]]) -> f64 {
                    let mut $v = 0.0;
                    $($body)*
                    $v
                }
            }

            #[test]
            fn kicks_are_gradients() -> Result<(), Error> {
                for length in LENGTHS {
                    let q: Vec<_> = (0..length).map(|i| [0, 1, 2].map(|d| wave(3 * i + d))).collect();
                    let mut run = Points.run_with(Euler, Phase::new(q.clone(), vec![[0.0; 3]; length]), STEP)?;
                    run.advance(1)?;
                    for (k, p) in run.state().p.as_flattened().iter().enumerate() {
                        let at = |shift: f64| {
                            let mut q = q.clone();
                            q[k / 3][k % 3] += shift;
                            Points.potential(&q)
                        };
                        let slope = (at(SHIFT) - at(-SHIFT)) / (2.0 * SHIFT);
                        let near = 10.0 * NEAR * (1.0 + slope.abs());
                        assert!((p + STEP * slope).abs() < near, "{k} of {length}: {p} for {}", -slope);
                    }
                }
                Ok(())
            }
        }
    };
}

points!(a_neighbour_that_may_not_exist, |q, v| for i in 0..q.len() {
    if i + 1 < q.len() {
        for j in 0..q.len() {
            let r2: f64 = (0..3).map(|d| (q[i + 1][d] - q[j][d]).powi(2)).sum();
            v += (1.0 + r2).sqrt();
        }
    }
});
points!(a_point_before, |q, v| for i in 0..q.len() {
    if i > 0 {
        for j in 0..i {
            let r2: f64 = (0..3).map(|d| (q[i - 1][d] - q[j][d]).powi(2)).sum();
            v += (1.0 + r2).sqrt();
        }
    }
});
points!(products_of_components, |q, v|
    let mut s = 0.0;
    for i in 0..q.len() {
        for d in 0..3 {
            for e in 0..d {
                s += 0.01 * q[i][d] * q[i][e];
            }
        }
    }
    v += s * s;
);
