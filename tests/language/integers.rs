//! Integers of every type, in indices, exponents, conditions and ranges. Each potential is linear in `q`, so that rustc's own
//! reading of it tells the force: the difference between its values at a unit vector and at zero.

use crate::{START, TIME, close, kicked};
use integrator_core::prelude::*;

const LEVELS: i32 = 3;
const STATES: u8 = 4;

fn outside(level: i32) -> f64 {
    0.25 * level as f64 + 1.0
}

macro_rules! linear {
    (($self:ident, $q:ident) $($name:ident { $($body:tt)* })*) => {
        $(mod $name {
            use super::*;

            struct System {
                kinds: usize,
                kind: Vec<usize>,
                table: Vec<f64>,
                order: Vec<i32>,
                charge: Vec<i64>,
                ring: Vec<i8>,
                first: Vec<usize>,
                second: Vec<usize>,
                weights: Vec<f64>,
                least: i32,
                most: i32,
                none: i32,
                small: u8,
                count: usize,
                starts: Vec<usize>,
                lengths: Vec<i16>,
                bytes: Vec<u8>,
            }

            impl System {
                fn level(&self, level: i32) -> f64 {
                    0.5 + level as f64
                }
                fn place(&self, place: usize) -> f64 {
                    1.5 + place as f64
                }
            }

            #[hamiltonian]
            impl System {
                fn kinetic(&self, p: [f64; 4]) -> f64 {
                    p.iter().map(|p| p * p / 2.0).sum()
                }
                fn potential(&$self, $q: [f64; 4], t: f64) -> f64 {
                    let _ = t;
                    $($body)*
                }
                fn well(&self, i: usize, j: usize) -> f64 {
                    self.table[i * self.kinds + j]
                }
            }

            #[test]
            fn moves_as_rustc_reads_it() {
                let system = System {
                    kinds: 2,
                    kind: vec![0, 1, 1, 0],
                    table: vec![0.5, 1.5, 2.5, 3.5],
                    order: vec![1, 2, 3, -4],
                    charge: vec![1, -2, 3, -4],
                    ring: vec![0, 1, 3, -2],
                    first: vec![0, 1, 1, 0],
                    second: vec![2, 1, 0, 1],
                    weights: vec![0.5, 0.75, 1.25, 1.5],
                    least: -1,
                    most: 3,
                    none: -1,
                    small: 2,
                    count: 4,
                    starts: vec![0, 1, 3, 3, 4],
                    lengths: vec![2, 0, -1, 1],
                    bytes: vec![3, 1, 0, 2],
                };
                let (found, _) = kicked(&system, START, TIME);
                let zero = system.potential([0.0; 4], TIME);
                let gradient = [0, 1, 2, 3].map(|i| system.potential([0, 1, 2, 3].map(|j| f64::from(i == j)), TIME) - zero);
                close(&found, &gradient);
            }
        })*
    };
}

linear! {
    (self, q)

    bits_of_indices {
        let mut v = 0.0;
        for i in 0..4 {
            v += self.table[i ^ 1] * q[i] + self.weights[i >> 1] * q[i ^ 1] + ((i & 1) << 2) as f64 * q[i];
        }
        for i in 0..4_u32 {
            for j in 0..=i {
                if (i + j) & 1 == 0 {
                    v += (j ^ 1) as f64 * q[(i >> 1) as usize];
                }
            }
        }
        v
    }

    tables_of_two_lists {
        let mut v = 0.0;
        for i in 0..4 {
            for j in 0..i {
                let k: usize = self.kind[i] + self.kind[j];
                let larger = if i > 1 { self.kind[i] } else { self.kind[j] };
                v += self.table[self.kind[i] * self.kinds + self.kind[j]] * (q[i] - 2.0 * q[j]);
                v += (self.table[k] + self.table[larger]) * q[i] + self.well(self.kind[i] * self.kind[j], self.kind[i]) * q[j];
                v += self.table[self.kind[i].min(self.kind[j]) * self.kinds + self.kind[i].max(self.kind[j])] * q[j];
            }
        }
        for i in 0..2 {
            for j in 0..2 {
                v += self.weights[i] * q[self.first[i] + self.second[j]];
                for k in 0..self.first[i] + self.second[j] {
                    v += self.weights[k] * q[i];
                }
            }
        }
        v + (0..4).map(|i| (0..i).map(|j| self.table[self.kind[i] + self.kind[j]] * q[i]).sum::<f64>()).sum::<f64>()
    }

    arithmetic_of_two_lists {
        let mut v = 0.0;
        for i in 0..4 {
            for j in 0..i {
                v += self.weights[0].powi(self.order[i] + self.order[j]) * q[i];
                v += self.weights[1].powi((self.order[i] - self.order[j]).abs()) * q[j];
                v += ((self.order[i] + self.order[j]) / 2) as f64 * q[i] + f64::from(self.order[i] * self.order[j]) * q[j];
                v += (self.order[i] + self.order[j]) as f64 * q[i] + -(self.order[i] * self.order[j]) as f64 * q[j];
                v += outside(self.order[i] - self.order[j]) * q[i] + (self.order[i] * self.order[j]).pow(2) as f64 * q[j];
                v += (self.weights[i] + self.weights[j]).abs() * self.weights[i] * q[i];
            }
        }
        v
    }

    conditions_on_two_lists {
        let mut v = 0.0;
        for i in 0..4 {
            for j in 0..i {
                if (self.order[i] + self.order[j]) % 2 == 0 { v += q[i]; }
                if self.charge[i] * self.charge[j] < 0 { v += 2.0 * q[j]; }
                if (self.ring[i] - self.ring[j]).abs() > 1 { v += 3.0 * q[i]; }
                if self.charge[i] * self.charge[j] < self.charge[0] { v += 4.0 * q[j]; }
                if self.weights[i] * self.weights[j] < self.weights[1] { v += 5.0 * q[i]; }
                if self.order[i] + self.order[j] > 0 && self.order[i] - self.order[j] != 2 { v += 6.0 * q[j]; }
                if (self.order[i] + self.order[j]) & 1 == 0 { v += 7.0 * q[i]; }
                let both = self.order[i] + self.order[j];
                match both { 3 => { v += q[i]; } _ => { v += 2.0 * q[j]; } }
            }
        }
        v
    }

    ranges_of_other_types {
        let mut v = 0.0;
        for l in 0..=self.most { v += l as f64 * q[0] + self.level(l) * q[1]; }
        for l in 1..=LEVELS { v += q[0] / l as f64 + outside(2 * l) * q[2]; }
        for l in 0..STATES { v += q[1] / (1.0 + f64::from(l)); }
        for l in 0..self.small { v += self.level(l as i32) * q[0] + q[l as usize]; }
        for l in 0..=self.none { v += q[0] + l as f64; }
        for l in 0..self.none { v += q[0] + l as f64; }
        for l in 0..=5_i32 { v += outside(l) * q[3]; }
        for l in 0..self.most + 1 { v += outside(l - 1) * q[0]; }
        for l in 0..2 * self.most - 1 { v += (l.pow(2) + (l - 2).abs()) as f64 * q[1]; }
        for a in 0..self.bytes[0] { for b in 0..self.bytes[a as usize] { v += f64::from(a + b) * q[2]; } }
        v
    }

    ranges_below_zero {
        let mut v = 0.0;
        for l in -self.most..=self.most { v += (l * l + 1) as f64 * q[0] + outside(l) * q[1]; }
        for l in self.least..self.most { if l != 0 { v += q[(l + 1) as usize] / l as f64; } }
        for l in -2..=self.most { v += self.level(l) * q[2]; }
        for l in self.least..3 { v += self.level(l - 1) * q[3]; }
        for l in -(self.count as i64)..=self.count as i64 { v += (l * l) as f64 * q[0] + l as f64 * q[1]; }
        for l in 0..=self.most {
            for m in -l..=l { v += (l * 10 + m) as f64 * q[0]; }
            for m in -l..=self.most { v += (l * 10 + m) as f64 * q[1]; }
            for m in -self.most..=self.most {
                if l * l + m * m == 0 { continue; }
                v += self.weights[0].powi(l - m) / (l * l + m * m) as f64 * q[2];
            }
        }
        v
    }

    ranges_in_iterators {
        (0..=self.most).map(|l| self.level(l) * q[1] + (l as f64).cos() * q[0]).sum::<f64>()
            + (-self.most..=self.most).filter(|&l| l != 0).map(|l| q[2] / (l * l) as f64).sum::<f64>()
            + (-self.most..=LEVELS).rev().map(|l| self.level(l) * q[3]).sum::<f64>()
            + (0..self.count).map(|i| self.weights[i] * q[i]).sum::<f64>()
    }

    ranges_from_lists {
        let mut v = 0.0;
        for i in 0..4 {
            for k in self.starts[i]..self.starts[i + 1] { v += self.weights[k] * q[self.kind[k]] + q[i]; }
            for k in 0..self.lengths[i] { v += self.level(k as i32) * q[i] + k as f64 * q[0]; }
            for k in 0..=self.lengths[i] { v += outside((k + 1).into()) * q[i]; }
            for k in -self.lengths[i]..self.lengths[i] { v += k as f64 * q[i]; }
        }
        for (i, &order) in self.order.iter().enumerate() { for l in 0..order { v += outside(l) * q[i]; } }
        v
    }

    types_that_only_use_tells {
        let mut v = 0.0;
        for l in 0..4 { v += (self.order[l] * 2 + 1) as f64 * q[l] + (l * self.count) as f64 * q[0]; }
        for l in 0..4 { v += (self.most * l + 1) as f64 * q[0] + self.level(l) * q[1] + outside(l) * q[2]; }
        for l in 0..4 { if l < self.most { v += q[0]; } if 2 * l >= self.most { v += q[1]; } }
        for l in 0..4 { if l < self.count && l + 1 != self.count { v += q[l]; } }
        for l in 0..self.count { if l == self.count - 1 { v += q[0]; } else { v += self.place(l) * q[1]; } }
        for l in 0..self.most { if l == self.most - 1 { v += q[2]; } else { v += l as f64 * q[3]; } }
        for ll in 0..4 {
            for mm in 0..4 {
                let l = ll as i32;
                let m = mm as i32 - self.most as i32;
                if l * l + m * m == 0 { continue; }
                v += q[0] / (l * l + m * m) as f64 + q[ll] * m as f64;
            }
        }
        v
    }

    guards_at_the_upper_end {
        let mut v = 0.0;
        for i in 0..4 { if i != 3 { v += q[i + 1]; } }
        for i in 0..4 { if i == q.len() - 1 { v += 2.0 * q[0]; } else { v += 3.0 * q[i + 1] - q[i]; } }
        for i in 0..4 { v += self.weights[i] * if i == 3 { q[0] } else { q[i + 1] }; }
        for i in 0..4 { if i == 3 { continue; } v += self.weights[i] * q[i + 1]; }
        for i in 0..4 { if i > 2 { continue; } v += 4.0 * q[i + 1]; }
        for i in 0..4 { match i { 3 => { v += q[0]; } _ => { v += 5.0 * q[i + 1]; } } }
        for i in 0..4 { match i { 2 | 3 => {} _ => { v += 6.0 * q[i + 2]; } } }
        for i in 0..4 { if i % 2 == 0 { v += 7.0 * q[i + 1]; } }
        for i in 0..4 { for j in 0..4 { if i + j < 4 { v += q[i + j]; } if j > i { v += q[i + 1]; } } }
        for i in 0..4 { let next = if i == 3 { 0 } else { i + 1 }; v += self.weights[i] * q[next]; }
        for i in 0..4 { let far = if i < 2 { i + 2 } else { i - 2 }; v += self.weights[i] * q[far]; }
        for i in 0..4 { if i != 3 && i != 2 { v += 8.0 * q[i + 2]; } }
        v + (0..4).filter(|&i| i != 3).map(|i| self.weights[i] * q[i + 1]).sum::<f64>()
            + (0..4).filter(|i| *i < 3).map(|i| q[i + 1] - q[i]).sum::<f64>()
    }
}
