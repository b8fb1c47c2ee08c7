//! Potentials with terms beside their pairs, with bodies in order, and with any image in a box: many bodies move as the
//! formulas say.

use integrator_core::{System, prelude::*};
use std::{any::type_name, collections::HashSet};

/// Enough bodies for lists of neighbours, and no multiple of the lanes.
const BODIES: usize = 397;
const SIDE: f64 = 9.0;

#[derive(Clone, PartialEq)]
pub(super) enum Kind {
    Water,
    Salt,
}

/// Bodies with charges, weights, bonds and angles in a box.
#[derive(Clone)]
pub(super) struct Parameters {
    pub(super) side: f64,
    pub(super) inverse: f64,
    pub(super) half: f64,
    pub(super) cutoff: f64,
    pub(super) shorter: f64,
    pub(super) offset: f64,
    pub(super) charges: Vec<f64>,
    pub(super) weights: Vec<f64>,
    pub(super) molecules: Vec<usize>,
    pub(super) kinds: Vec<Kind>,
    pub(super) partners: Vec<usize>,
    /// Without the last body, which is never the lesser one of a pair.
    pub(super) following: Vec<usize>,
    pub(super) strengths: Vec<f64>,
    /// Without the first body, which is never the greater one of a pair.
    pub(super) preceding: Vec<usize>,
    /// Strengths and reaches of pairs of types; the types are those of molecules modulo three.
    pub(super) strengths_of_types: Vec<[f64; 3]>,
    pub(super) reaches_of_types: Vec<Vec<f64>>,
    pub(super) types: Vec<usize>,
    /// Types in ascending order.
    pub(super) layers: Vec<usize>,
    pub(super) bonds: Vec<[usize; 2]>,
    /// Bodies that come before a body and have no force on it, but for the first body, and pairs of bodies.
    pub(super) excluded: Vec<Vec<u32>>,
    pub(super) bonded: HashSet<(usize, usize)>,
    /// Differences of the numbers of two bodies, and types of two bodies.
    pub(super) skipped: Vec<usize>,
    pub(super) allowed: Vec<(usize, usize)>,
    pub(super) angles: Vec<(usize, usize, usize)>,
}

impl Parameters {
    pub(super) fn new() -> Self {
        let along = |factor: f64| (0..BODIES).map(|i| 1.0 + 0.5 * (factor * i as f64).sin()).collect();
        Self {
            side: SIDE,
            inverse: 1.0 / SIDE,
            half: 0.5 * SIDE,
            cutoff: 2.5,
            shorter: 1.5,
            offset: 7.0,
            charges: along(1.3),
            weights: along(2.1),
            molecules: (0..BODIES).map(|i| i * 7 % BODIES / 3).collect(),
            kinds: (0..BODIES).map(|i| if i % 3 == 0 { Kind::Salt } else { Kind::Water }).collect(),
            partners: (0..BODIES).map(|i| (i + BODIES - 1) % BODIES).collect(),
            following: (1..BODIES).collect(),
            strengths: (1..BODIES).map(|i| 0.001 * i as f64).collect(),
            preceding: (1..BODIES).map(|i| (i * 5) % i).collect(),
            strengths_of_types: vec![[1.0, 0.5, 0.2], [0.7, 0.9, 1.3], [0.1, 0.4, 2.0]],
            // The lower triangle.
            reaches_of_types: vec![vec![2.0], vec![1.1, 1.7], vec![0.9, 1.5, 2.2]],
            types: (0..BODIES).map(|i| i * 5 % 7 % 3).collect(),
            layers: (0..BODIES).map(|i| i / 150).collect(),
            bonds: (1..BODIES).filter(|i| i % 5 > 0).map(|i| [i - 1, i]).collect(),
            excluded: (1..BODIES as u32).map(|i| vec![i - 1, i * 3 % 7, i / 2]).collect(),
            bonded: (2..BODIES).flat_map(|i| [(i - 2, i), (i, i - 1), (i * 11 % i, i)]).collect(),
            skipped: vec![1, 3],
            allowed: vec![(0, 1), (2, 2), (2, 0)],
            angles: (2..BODIES).filter(|i| i % 5 > 1).map(|i| (i - 2, i - 1, i)).collect(),
        }
    }

    /// Bodies near the sites of a lattice, at rest.
    pub(super) fn start() -> Phase<Vec<[f64; 3]>> {
        let spread = |i: usize, d: usize| 0.2 * ((7 * i + 3 * d) as f64).sin();
        let site = |i: usize| [i % 8, i / 8 % 8, i / 64].map(|site| site as f64 * SIDE / 8.0);
        let q = (0..BODIES)
            .map(|i| {
                let site = site(i);
                [0, 1, 2].map(|d| site[d] + spread(i, d))
            })
            .collect();
        Phase::new(q, vec![[0.0; 3]; BODIES])
    }
}

/// What sums of as many terms as there are pairs differ by in another order.
pub(super) const ROUNDING: f64 = (BODIES * BODIES) as f64 * f64::EPSILON;

pub(super) fn narrow(start: &Phase<Vec<[f64; 3]>>) -> Phase<Vec<[f32; 3]>> {
    let of = |part: &[[f64; 3]]| part.iter().map(|point| point.map(|x| x as f32)).collect();
    Phase::new(of(&start.q), of(&start.p))
}

/// Checks that momenta are equal up to a part of the largest one.
pub(super) fn are_near(found: &[[f64; 3]], expected: &[[f64; 3]], part: f64) {
    let largest = expected.iter().flatten().fold(0.0, |most: f64, p| most.max(p.abs()));
    assert!(largest > 0.01, "{largest}");
    for (p, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((p - expected).abs() <= part * largest, "{p} for {expected}");
    }
}

/// A system with this potential twice: with bodies in lanes, and with a kinetic energy that couples bodies, which has them as
/// written. The test compares momenta after a kick, and energies.
macro_rules! potential {
    ($name:ident, $self:ident, $q:ident, $v:ident $(, time = $time:ident)?; $($body:tt)*) => {
        mod $name {
            use super::*;

            pub(super) struct InLanes(pub(super) Parameters);
            struct AsWritten(Parameters);

            #[hamiltonian]
            impl InLanes {
                fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                    p.iter().flatten().map(|p| 0.5 * p * p).sum()
                }
                fn potential(&$self, $q: &[[f64; 3]] $(, $time: f64)?) -> f64 {
                    let mut $v = 0.0;
                    $($body)*
                    $v
                }
            }

            #[hamiltonian]
            impl AsWritten {
                fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                    p[0][0] * p[1][0] + p.iter().flatten().map(|p| 0.5 * p * p).sum::<f64>()
                }
                fn potential(&$self, $q: &[[f64; 3]] $(, $time: f64)?) -> f64 {
                    let mut $v = 0.0;
                    $($body)*
                    $v
                }
            }

            #[test]
            fn moves_as_written() -> Result<(), Error> {
                let (lanes, written) = (InLanes(Parameters::new()), AsWritten(Parameters::new()));
                let start = Parameters::start();
                let mut by_lanes = lanes.run_with(Euler, start.clone(), 0.5)?;
                let mut by_formulas = written.run_with(Euler, start.clone(), 0.5)?;
                assert!(type_name::<<InLanes as System>::Motion<f64, f64>>().contains("ManyRows"));
                assert!(type_name::<<AsWritten as System>::Motion<f64, f64>>().contains("Plain"));
                let [energy, expected] = [by_lanes.energy(), by_formulas.energy()];
                assert!((energy - expected).abs() <= ROUNDING * expected.abs(), "{energy} for {expected}");
                by_lanes.advance(1)?;
                by_formulas.advance(1)?;
                are_near(&by_lanes.state().p, &by_formulas.state().p, ROUNDING);
                // In single precision, and as a member of an ensemble.
                let mut single = lanes.run_with(Euler, narrow(&start), 0.5)?;
                single.advance(1)?;
                let wide: Vec<_> = single.state().p.iter().map(|p| p.map(f64::from)).collect();
                are_near(&wide, &by_formulas.state().p, ROUNDING * f64::from(f32::EPSILON) / f64::EPSILON);
                let members = [start.clone(), start].map(|start| (InLanes(Parameters::new()), start));
                let mut ensemble = Ensemble::new(Euler, members, 0.5)?;
                ensemble.advance(1)?;
                assert_eq!(ensemble.state(1), Some(by_lanes.state()));
                Ok(())
            }
        }
    };
}

potential!(bonds, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = x - self.0.side * (x / self.0.side).round();
                r2 += image * image;
            }
            if r2 < self.0.cutoff * self.0.cutoff {
                v += self.0.charges[i] * self.0.charges[j] / (1.0 + r2).powi(3);
            }
        }
    }
    for &[a, b] in &self.0.bonds {
        let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[a][d] - q[b][d];
                let image = x - self.0.side * (x / self.0.side).round();
                r2 += image * image;
            }
        v += 15.0 * (r2.sqrt() - 1.0).powi(2);
    }
);

potential!(angles_and_a_chain, self, q, v;
    v += self.0.offset;
    for i in 0..q.len() {
        v += 0.1 * self.0.weights[i] * q[i][2].powi(2);
        for j in i + 1..q.len() {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff {
                v += (self.0.cutoff - r2).powi(3);
            }
        }
    }
    for (a, b, c) in self.0.angles.iter().copied() {
        v += (0..3).map(|d| (q[a][d] - 2.0 * q[b][d] + q[c][d]).powi(2)).sum::<f64>();
    }
    for i in 0..q.len() - 1 {
        v += 0.3 * (q[i + 1][0] - q[i][0]).cos();
    }
);

potential!(no_cutoff, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            v -= (self.0.charges[i] * self.0.weights[j] + 0.1 * self.0.weights[i] * self.0.charges[j]) / (0.1 + r2).sqrt();
        }
    }
    for &[a, b] in &self.0.bonds {
        v += (q[a][0] - q[b][0]).powi(4);
    }
);

potential!(excluded_neighbours, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = x - self.0.side * (x * self.0.inverse).round();
                r2 += image * image;
            }
            if i - j > 1 && r2 < self.0.cutoff.powi(2) {
                v += 1.0 / (0.5 + r2).powi(2);
            } else if i == j + 1 {
                v += 0.5 * r2;
            }
        }
    }
);

potential!(branches, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = if x > self.0.half {
                    x - self.0.side
                } else if x < -self.0.half {
                    x + self.0.side
                } else {
                    x
                };
                r2 += image * image;
            }
            if r2 < self.0.shorter {
                v += self.0.charges[i] * r2;
            } else if r2 < self.0.cutoff {
                v += self.0.charges[j] * r2 * r2;
            }
        }
    }
);

potential!(remainder, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = (x + self.0.half).rem_euclid(self.0.side) - self.0.half;
                r2 += image * image;
            }
            v += (1.0 - r2 / self.0.cutoff).max(0.0).powi(2);
        }
    }
);

potential!(the_shorter_way, self, q, v;
    for i in 0..q.len() {
        if self.0.weights[i] > 1.0 {
            for j in 0..i {
                let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = x.abs().min(self.0.side - x.abs());
                r2 += image * image;
            }
                if r2 < self.0.cutoff {
                    v += self.0.offset * r2;
                }
            }
        }
    }
    v += q[0][0] * q[3][1];
);

// Bodies are in several boxes: only some of these images are the nearest ones far away.
potential!(nearest_images, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let side = 0.25 * self.0.side;
            let mut squares = [0.0; 4];
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let branches = if x > 0.5 * side { x - side } else if x < -0.5 * side { x + side } else { x };
                squares[0] += ((x + 0.5 * side).rem_euclid(side) - 0.5 * side).powi(2);
                squares[1] += ((x % side + 1.5 * side) % side - 0.5 * side).powi(2);
                squares[2] += x.abs().min(side - x.abs()).powi(2);
                squares[3] += branches * branches;
            }
            if squares[0] < 1.0 {
                v += (1.0 - squares[0]).powi(2);
            }
            if squares[1] < 0.9 {
                v += squares[1];
            }
            if squares[2] < 0.8 {
                v += (0.8 - squares[2]).powi(2);
            }
            if squares[3] < 0.7 {
                v += squares[3] * squares[3];
            }
        }
    }
);

potential!(types, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if self.0.molecules[i] != self.0.molecules[j] && r2 < self.0.cutoff {
                v += 1.0 / (1.0 + r2);
            }
            if self.0.kinds[i] == self.0.kinds[j] && r2 < self.0.shorter {
                v += (self.0.shorter - r2).powi(2);
            }
            if self.0.kinds[i] == Kind::Salt && r2 < self.0.shorter {
                v += r2;
            }
            if self.0.partners[i] == j && r2 < self.0.cutoff {
                v += 0.5 * r2 * r2;
            }
        }
    }
);

potential!(lists_without_the_last_body, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff {
                v += self.0.strengths[j] / (1.0 + r2);
                if self.0.following[j] == i {
                    v += r2 * r2;
                }
            }
        }
    }
);

potential!(lists_without_the_first_body, self, q, v;
    for i in 1..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff {
                v += self.0.strengths[i - 1] * (i - 1) as f64 / (1.0 + r2);
                if self.0.preceding[i - 1] == j {
                    v += r2 * r2;
                }
                if self.0.following[j] == i - 1 {
                    v += r2;
                }
            }
        }
    }
);

potential!(a_list_behind_a_condition_on_the_index, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff && j > 0 {
                v += self.0.strengths[j - 1] / (1.0 + r2);
            }
        }
    }
);

potential!(driven_bonds, self, q, v, time = time;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff {
                v += (1.0 + time) * self.0.charges[i] * self.0.charges[j] / (1.0 + r2);
            }
        }
    }
    for &[a, b] in &self.0.bonds {
        v += (2.0 + time).sin() * (q[a][0] - q[b][0]).powi(2);
    }
);

potential!(tables_by_type, self, q, v;
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            let (a, b) = (self.0.types[i], self.0.types[j]);
            let reach = if a < b { self.0.reaches_of_types[b][a] } else { self.0.reaches_of_types[a][b] };
            if r2 < self.0.cutoff {
                v += self.0.strengths_of_types[self.0.types[i]][self.0.types[j]] / (1.0 + r2 / reach);
                if self.0.types[i] == 1 && self.0.types[j] == 2 || self.0.types[i] + self.0.types[j] == 0 {
                    v += r2;
                }
            }
        }
    }
);

potential!(sets_of_pairs, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < self.0.cutoff {
                if !self.0.excluded[i - 1].contains(&(j as u32)) {
                    v += self.0.charges[i] / (1.0 + r2);
                }
                if self.0.bonded.contains(&(j, i)) {
                    v += 0.5 * r2;
                }
            }
        }
        for j in i + 1..q.len() {
            let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if !self.0.skipped.contains(&(j - i)) && self.0.allowed.contains(&(self.0.types[i], self.0.types[j])) && r2 < 1.5 {
                v += (1.5 - r2).powi(2);
            }
            if self.0.types[i] == self.0.types[j] || self.0.bonded.contains(&(j, i)) {
                continue;
            }
            if r2 < 1.2 {
                v += (1.2 - r2).powi(2);
            }
        }
    }
);

// Strengths and preceding bodies are lists without the body that has no partner.
potential!(cutoffs_of_pairs, self, q, v;
    for i in 0..q.len() {
        for j in 0..i {
            let mut r2 = 0.0;
            for d in 0..3 {
                let x = q[i][d] - q[j][d];
                let image = x - self.0.side * (x * self.0.inverse).round();
                r2 += image * image;
            }
            let reach = 0.6 * (self.0.charges[i] + self.0.weights[j]) + 0.2 * self.0.strengths[j];
            v += (1.0 - r2.sqrt() / reach).max(0.0).powi(2);
            let (a, b) = (self.0.types[i], self.0.types[j]);
            let cutoff = self.0.strengths_of_types[a][b];
            if r2 < cutoff * cutoff {
                v += (cutoff * cutoff - r2).powi(2);
            }
        }
    }
);

/// Bodies whose forces have a common factor, and a table by type.
struct Scaled {
    strength: f64,
    types: Vec<usize>,
    table: Vec<[f64; 2]>,
}

const SCALED: usize = 40;

#[hamiltonian(sensitive(strength))]
impl Scaled {
    fn kinetic(&self, p: &[[f64; 3]; SCALED]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]; SCALED]) -> f64 {
        let mut v = 0.0;
        for i in 0..SCALED {
            for j in 0..i {
                let r2 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                v += self.strength * self.table[self.types[i]][self.types[j]] / (1.0 + r2);
            }
        }
        v
    }
}

/// The momentum after a step from rest is a multiple of the factor.
#[test]
fn a_derivative_by_a_parameter_reads_tables_by_type() -> Result<(), Error> {
    let types = (0..SCALED).map(|i| i % 3 / 2).collect();
    let system = Scaled { strength: 0.7, types, table: vec![[1.0, 0.5], [2.0, 0.3]] };
    let q = std::array::from_fn(|i| [0, 1, 2].map(|d| (1.3 * i as f64 + 0.4 * d as f64).sin()));
    let mut tangent = system.sensitivities(Euler, Phase::new(q, [[0.0; 3]; SCALED]), [], 0.5)?;
    tangent.advance(1)?;
    let (state, vector) = (tangent.state(), &tangent.vectors()[0]);
    let found: Vec<_> = vector.p.iter().map(|p| p.map(|p| 0.7 * p)).collect();
    are_near(&found, &state.p, ROUNDING);
    Ok(())
}
