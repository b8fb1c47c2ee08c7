//! Pairs in loops over all bodies, under conditions on their indices, and tables that several loops read: many bodies move as the formulas
//! say.

use super::beside_pairs::{Parameters, ROUNDING, are_near, narrow};
use integrator_core::{System, prelude::*};
use std::any::type_name;

potential!(indices_beside_a_cutoff, self, q, v;
    for i in 0..q.len() {
        for j in 0..q.len() {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if j == i || r2 >= self.0.cutoff {
                continue;
            }
            v += self.0.charges[i] * self.0.weights[j] * (self.0.cutoff - r2).powi(2);
            if !(r2 >= self.0.shorter || self.0.types[i] == self.0.types[j]) {
                v += (self.0.shorter - r2).powi(2);
            }
        }
    }
);

potential!(indices_in_order, self, q, v;
    for i in 0..q.len() {
        for j in 0..q.len() {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff && j < i {
                v += self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] * (self.0.cutoff - r2).powi(2);
            } else if i != j && r2 < self.0.shorter {
                v += self.0.charges[i] * self.0.weights[j] * (self.0.shorter - r2).powi(3);
            }
            // A list without the last body, which is read for the lesser one of a pair only.
            if j > i && r2 < self.0.shorter {
                v += (self.0.following[i] % 3) as f64 * (self.0.shorter - r2).powi(2);
            }
        }
    }
);

// The table has no entries for bodies in the other order.
potential!(half_a_table, self, q, v;
    for i in 0..q.len() {
        for j in 0..q.len() {
            if i > j {
                let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                if r2 < self.0.cutoff {
                    v += self.0.reaches_of_types[self.0.layers[i]][self.0.layers[j]] * (self.0.cutoff - r2).powi(2);
                }
            }
        }
    }
);

potential!(tables_in_both_orders, self, q, v;
    for i in 0..q.len() {
        for j in 0..q.len() {
            if i != j {
                let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                if r2 < self.0.cutoff {
                    v += self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] * (self.0.cutoff - r2).powi(2);
                }
            }
        }
    }
);

potential!(tables_in_several_loops, self, q, v;
    let square = |i: usize, j: usize| (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
    let near = |i: usize, j: usize| if square(i, j) < self.0.cutoff { (self.0.cutoff - square(i, j)).powi(2) } else { 0.0 };
    for i in 0..q.len() {
        for j in 0..i {
            v += 0.3 * self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] * near(i, j);
        }
        for j in i + 1..q.len() {
            v -= self.0.offset * self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] * near(i, j);
        }
        for j in 0..q.len() {
            if j != i {
                v += 0.7 * self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] * near(i, j);
            }
        }
    }
);
