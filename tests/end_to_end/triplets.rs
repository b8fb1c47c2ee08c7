//! Sums over a body and two others within a cutoff: many bodies move as the formulas say.

use super::beside_pairs::{Parameters, ROUNDING, are_near, narrow};
use integrator_core::{System, prelude::*};
use std::any::type_name;

potential!(silicon_in_a_box, self, q, v;
    let image = |x: f64| x - self.0.side * (x / self.0.side).round();
    let reach = 1.9;
    for i in 0..q.len() {
        for j in 0..i {
            let r2 = (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>();
            if r2 < reach * reach {
                v += (0.6 / (r2 * r2) - 1.0) * (1.0 / (r2.sqrt() - reach)).exp();
            }
        }
    }
    for i in 0..q.len() {
        for j in 0..q.len() {
            if j == i {
                continue;
            }
            let u = [0, 1, 2].map(|d| image(q[j][d] - q[i][d]));
            let r_j = (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt();
            if r_j >= reach {
                continue;
            }
            for k in j + 1..q.len() {
                if k == i {
                    continue;
                }
                let w = [0, 1, 2].map(|d| image(q[k][d] - q[i][d]));
                let r_k = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).sqrt();
                if r_k < reach {
                    let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (r_j * r_k);
                    v += self.0.weights[i] * (cosine + 1.0 / 3.0).powi(2) * (0.4 / (r_j - reach) + 0.4 / (r_k - reach)).exp();
                }
            }
        }
    }
);

potential!(triplets_by_type_without_pairs, self, q, v;
    let square = |i: usize, j: usize| (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
    for i in 0..q.len() {
        for j in 0..q.len() {
            for k in 0..j {
                if j != i && k != i && square(i, j) < self.0.cutoff {
                    let (a, b) = (square(i, j), square(i, k));
                    if b < self.0.cutoff {
                        let strength = self.0.strengths_of_types[self.0.types[i]][self.0.types[j]]
                            + self.0.strengths_of_types[self.0.types[i]][self.0.types[k]];
                        let between: f64 = (0..3).map(|d| (q[j][d] - q[i][d]) * (q[k][d] - q[i][d])).sum();
                        v += strength * (self.0.cutoff - a).powi(2) * (self.0.cutoff - b).powi(2) * between * self.0.charges[k];
                    }
                }
            }
        }
    }
);

potential!(triplets_that_come_twice, self, q, v;
    let image = |x: f64| x - self.0.side * (x / self.0.side).round();
    let n = q.len();
    let leg = |i: usize, j: usize| [0, 1, 2].map(|d| image(q[j][d] - q[i][d]));
    let length = |u: [f64; 3]| (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt();
    let term = |i: usize, j: usize, k: usize| {
        let (u, w) = (leg(i, j), leg(i, k));
        let (a, b) = (length(u), length(w));
        if b < self.0.shorter {
            let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (a * b);
            let strength = 0.5 * self.0.weights[j] * self.0.weights[k];
            strength * cosine * (self.0.shorter - a).powi(2) * (self.0.shorter - b).powi(2)
        } else {
            0.0
        }
    };
    for i in 0..n {
        v += (0..n)
            .filter(|&j| j != i && length(leg(i, j)) < self.0.shorter)
            .map(|j| (0..n).filter(|&k| k != i && k != j).map(|k| term(i, j, k)).sum::<f64>())
            .sum::<f64>();
    }
    for i in 0..n {
        v += 0.1 * self.0.charges[i] * q[i][0].powi(2);
        for j in i + 1..n {
            let r = length(leg(i, j));
            if r < self.0.cutoff {
                v += (self.0.cutoff - r).powi(2);
            }
        }
    }
);

potential!(each_three_bodies_once, self, q, v;
    let square = |i: usize, j: usize| (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
    let bound = self.0.shorter * self.0.shorter;
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            let a = square(i, j);
            v += 0.01 / (1.0 + a);
            if a < bound {
                for k in j + 1..q.len() {
                    let (b, c) = (square(i, k), square(j, k));
                    if b < bound && c < bound {
                        v += self.0.charges[j] * ((bound - a) * (bound - b) * (bound - c)).powi(2) / (1.0 + a * b * c);
                    }
                }
            }
        }
    }
    for &[a, b] in &self.0.bonds {
        v += (q[a][0] - q[b][0]).powi(4);
    }
);

potential!(triplets_beside_densities, self, q, v, time = t;
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
        for j in 0..i {
            if square(i, j) < self.0.shorter {
                // Two conditions on indices: the triplet is in the order of its numbers, and its first two are no neighbours of a chain.
                for k in 0..j {
                    if i != j + 1 && square(i, k) < self.0.shorter {
                        let overlap = (self.0.shorter - square(i, j)) * (self.0.shorter - square(i, k));
                        v += (1.0 + (t + 0.5).sin()) * self.0.strengths_of_types[self.0.types[j]][self.0.types[k]] * overlap.powi(2);
                    }
                }
            }
        }
    }
);

/// Silicon in reduced units (Stillinger and Weber 1985), in a box of this side.
#[derive(Clone)]
struct Silicon {
    side: f64,
    cutoff: f64,
    lambda: f64,
    gamma: f64,
}

#[hamiltonian]
impl Silicon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let image = |x: f64| x - self.side * (x / self.side).round();
        let leg = |i: usize, j: usize| [0, 1, 2].map(|d| image(q[j][d] - q[i][d]));
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if j == i {
                    continue;
                }
                let u = leg(i, j);
                let r_j = (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt();
                if r_j < self.cutoff {
                    v += 0.5 * 7.049556277 * (0.6022245584 / r_j.powi(4) - 1.0) * (1.0 / (r_j - self.cutoff)).exp();
                    for k in j + 1..q.len() {
                        if k == i {
                            continue;
                        }
                        let w = leg(i, k);
                        let r_k = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).sqrt();
                        if r_k < self.cutoff {
                            let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (r_j * r_k);
                            let damping = self.gamma / (r_j - self.cutoff) + self.gamma / (r_k - self.cutoff);
                            v += self.lambda * (cosine + 1.0 / 3.0).powi(2) * damping.exp();
                        }
                    }
                }
            }
        }
        v
    }
}

impl Silicon {
    /// A crystal of this number of cells along each axis, whose atoms are displaced by up to a twentieth of their distances.
    fn crystal(cells: usize) -> (Self, Phase<Vec<[f64; 3]>>) {
        let cell = (8.0_f64 / 0.46).cbrt();
        let system = Self { side: cell * cells as f64, cutoff: 1.8, lambda: 21.0, gamma: 1.2 };
        let corners = [[0.0, 0.0, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.0]];
        let mut q = Vec::new();
        for number in 0..cells.pow(3) {
            let origin = [number % cells, number / cells % cells, number / cells.pow(2)];
            for (corner, shift) in corners.iter().flat_map(|corner| [0.0, 0.25].map(|shift| (corner, shift))) {
                let atom = q.len();
                let displaced = |d: usize| 0.05 * ((7 * atom + 3 * d) as f64).sin();
                q.push([0, 1, 2].map(|d| (origin[d] as f64 + corner[d] + shift) * cell + displaced(d)));
            }
        }
        let p = (0..q.len()).map(|atom| [0, 1, 2].map(|d| 0.2 * ((5 * atom + 11 * d) as f64).cos())).collect();
        (system, Phase::new(q, p))
    }

    /// The energy, atom by atom.
    fn energy_of(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for (i, center) in q.iter().enumerate() {
            let mut near: Vec<([f64; 3], f64)> = Vec::new();
            for (j, other) in q.iter().enumerate() {
                let leg = [0, 1, 2]
                    .map(|d| (other[d] - center[d]) - self.side * ((other[d] - center[d]) / self.side).round());
                let length = leg.iter().map(|x| x * x).sum::<f64>().sqrt();
                if i != j && length < self.cutoff {
                    energy += 0.5
                        * 7.049556277
                        * (0.6022245584 / length.powi(4) - 1.0)
                        * (1.0 / (length - self.cutoff)).exp();
                    for (known, distance) in &near {
                        let cosine = (0..3).map(|d| known[d] * leg[d]).sum::<f64>() / (distance * length);
                        let damping = self.gamma / (distance - self.cutoff) + self.gamma / (length - self.cutoff);
                        energy += self.lambda * (cosine + 1.0 / 3.0).powi(2) * damping.exp();
                    }
                    near.push((leg, length));
                }
            }
        }
        energy
    }
}

/// In a box, and without one; 512 atoms have lists. Forces are compared with differences of energies over 2 `by`: the energy of an atom
/// and its neighbours changes by a sixth of its third derivative times the square of `by`, 1e-10 times some thousands, and the energies
/// of 512 atoms are rounded to 1e-13, which is 1e-8 of `by`.
#[test]
fn silicon_has_the_energy_and_the_forces_of_its_formulas() -> Result<(), Error> {
    for (cells, in_box) in [(2, true), (2, false), (3, true), (3, false), (4, true), (4, false)] {
        let (mut system, start) = Silicon::crystal(cells);
        if !in_box {
            system.side *= 1e3;
        }
        let mut run = system.run_with(Euler, start.clone(), 1.0)?;
        assert_eq!(run.layout().kick(), "triplets");
        assert_eq!(run.layout().is_listed(), cells == 4);
        let (atoms, by) = (start.q.len(), 1e-5);
        let kinetic: f64 = start.p.iter().flatten().map(|p| 0.5 * p * p).sum();
        let (energy, expected) = (run.energy() - kinetic, system.energy_of(&start.q));
        assert!((energy - expected).abs() <= ROUNDING * expected.abs(), "{energy} for {expected}");
        run.advance(1)?;
        let after = run.state().p;
        let mut total = [0.0; 3];
        for atom in 0..atoms {
            for d in 0..3 {
                total[d] += after[atom][d] - start.p[atom][d];
                if atom % 37 == 0 {
                    let of = |shift: f64| {
                        let mut q = start.q.clone();
                        q[atom][d] += shift;
                        system.energy_of(&q)
                    };
                    let (force, expected) = (after[atom][d] - start.p[atom][d], (of(-by) - of(by)) / (2.0 * by));
                    assert!((force - expected).abs() <= 1e-6, "{cells} {in_box} {atom} {d}: {force} for {expected}");
                }
            }
        }
        // Action is reaction, up to the rounding of as many forces of the order of one.
        assert!(total.iter().all(|total| total.abs() <= 100.0 * atoms as f64 * f64::EPSILON), "{total:?}");
    }
    Ok(())
}

/// The derivative of a step along a direction, as that of densities.
#[test]
fn deviation_vectors_follow_triplets() -> Result<(), Error> {
    let (system, start) = Silicon::crystal(4);
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
    let vector = Phase::new(direction.clone(), vec![[0.0; 3]; start.q.len()]);
    let mut tangent = system.tangent(Euler, start.clone(), [vector], 0.1)?;
    tangent.advance(1)?;
    are_near(&tangent.vectors()[0].p, &expected, 1e-6);
    Ok(())
}

/// On any number of threads, after the lists of neighbours were made anew, and in an ensemble.
#[test]
fn threads_change_no_bit_of_triplets() -> Result<(), Error> {
    let (system, start) = Silicon::crystal(4);
    let mut alone = system.run_with(Verlet, start.clone(), 0.02)?;
    let mut shared = system.run_with(Verlet, start.clone(), 0.02)?.with_threads(3);
    let mut cold = start.clone();
    cold.p.iter_mut().flatten().for_each(|p| *p *= 0.5);
    let members = [start, cold].map(|start| (system.clone(), start));
    let mut ensemble = Ensemble::new(Verlet, members, 0.02)?;
    let energy = alone.energy();
    for _ in 0..3 {
        alone.advance(40)?;
        shared.advance(40)?;
        ensemble.advance(40)?;
        assert_eq!(alone.state(), shared.state());
        assert_eq!(alone.energy().to_bits(), shared.energy().to_bits());
        assert_eq!(ensemble.state(0), Some(alone.state()));
    }
    // Verlet's error of the energy is of the order of the square of the step times the frequencies, here 6, per atom.
    assert!((alone.energy() - energy).abs() <= (0.02_f64 * 6.0).powi(2) * 512.0 * 0.1, "{} {energy}", alone.energy());
    Ok(())
}

/// A cutoff that is no number cuts nothing off: what the formulas make of it is seen.
#[test]
fn a_cutoff_that_is_no_number_has_the_energy_of_the_formulas() -> Result<(), Error> {
    let (mut system, start) = Silicon::crystal(2);
    system.cutoff = f64::NAN;
    let kinetic: f64 = start.p.iter().flatten().map(|p| 0.5 * p * p).sum();
    let found = system.run_with(Verlet, start.clone(), 0.02).map(|run| run.energy());
    // Both are sums of 192 squares, in different orders.
    let is_near = |energy: f64| (energy - kinetic).abs() <= 192.0 * f64::EPSILON * kinetic;
    assert!(matches!(found, Ok(energy) if is_near(energy)), "{found:?} for {kinetic}");
    Ok(())
}

/// None of these sums is among the terms that run as the formulas stand.
#[test]
fn every_spelling_has_the_layout_of_triplets() {
    let kicks = [
        <silicon_in_a_box::InLanes as System>::LAYOUT,
        <triplets_by_type_without_pairs::InLanes as System>::LAYOUT,
        <triplets_that_come_twice::InLanes as System>::LAYOUT,
        <each_three_bodies_once::InLanes as System>::LAYOUT,
        <triplets_beside_densities::InLanes as System>::LAYOUT,
        <Silicon as System>::LAYOUT,
    ];
    assert_eq!(kicks, [["pairs", "triplets"]; 6]);
}
