//! Flexible water (SPC/Fw: Wu, Tepper and Voth 2006), with the Coulomb force shifted to zero at the cutoff.

use crate::{
    Outcome, Scene,
    atoms::{Start, velocities},
    follow,
};
use integrator_core::prelude::*;

/// Constants in kcal/mol, Å, fs and elementary charges.
const CUTOFF: f64 = 9.0;
const DEPTH: f64 = 0.155_425_3;
const RADIUS: f64 = 3.165_492;
const COULOMB: f64 = 332.063_71;
const STIFFNESS: f64 = 529.581;
const LENGTH: f64 = 1.012;
const BENDING: f64 = 37.95;
const ANGLE: f64 = 113.24;

/// The unit g/mol in kcal/mol fs²/Å².
const UNIT: f64 = 2_390.057_361_376_673;

/// Molecules along an edge of the box.
const CELLS: usize = 16;

struct Water {
    side: f64,
    masses: Vec<f64>,
    charges: Vec<f64>,
    bonds: Vec<[usize; 2]>,
    angles: Vec<[usize; 3]>,
}

#[hamiltonian]
impl Water {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.masses[i]);
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                if i / 3 != j / 3 {
                    let mut square = 0.0;
                    for d in 0..3 {
                        let x = q[i][d] - q[j][d];
                        square += (x - self.side * (x / self.side).round()).powi(2);
                    }
                    if square < CUTOFF * CUTOFF {
                        let r = square.sqrt();
                        energy +=
                            COULOMB * self.charges[i] * self.charges[j] * (1.0 / r - 2.0 / CUTOFF + r / CUTOFF.powi(2));
                        if i % 3 == 0 && j % 3 == 0 {
                            let sixth = (RADIUS * RADIUS / square).powi(3);
                            energy += 4.0 * DEPTH * (sixth * sixth - sixth);
                        }
                    }
                }
            }
        }
        for &[a, b] in &self.bonds {
            let mut square = 0.0;
            for d in 0..3 {
                square += (q[a][d] - q[b][d]).powi(2);
            }
            energy += STIFFNESS * (square.sqrt() - LENGTH).powi(2);
        }
        for &[a, b, c] in &self.angles {
            let (mut product, mut first, mut second) = (0.0, 0.0, 0.0);
            for d in 0..3 {
                let (x, y) = (q[a][d] - q[b][d], q[c][d] - q[b][d]);
                product += x * y;
                first += x * x;
                second += y * y;
            }
            let angle = (product / (first * second).sqrt()).acos();
            energy += BENDING * (angle - ANGLE.to_radians()).powi(2);
        }
        energy
    }
}

pub(crate) fn scene() -> Scene {
    let spacing = 3.107;
    let half = ANGLE.to_radians() / 2.0;
    let (x, y) = (LENGTH * half.cos(), LENGTH * half.sin());
    let shapes = [
        [[0.0; 3], [x, y, 0.0], [x, -y, 0.0]],
        [[0.0; 3], [0.0, x, y], [0.0, x, -y]],
        [[0.0; 3], [-y, 0.0, -x], [y, 0.0, -x]],
    ];
    let atom = |n: usize| {
        let molecule = n / 3;
        let cell = [molecule % CELLS, molecule / CELLS % CELLS, molecule / CELLS / CELLS];
        let shape = shapes[(cell[0] + 2 * cell[1] + cell[2] * cell[2]) % 3][n % 3];
        [0, 1, 2].map(|d| (cell[d] as f64 + 0.5) * spacing + shape[d])
    };
    let count = 3 * CELLS.pow(3);
    let charges: Vec<f64> = vec![-0.82, 0.41];
    // LAMMPS subtracts the energy of each charge with itself.
    let own: f64 = (0..count).map(|i| charges[usize::from(i % 3 > 0)].powi(2)).sum();
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        let of = |numbers: &[f64], factor: f64| start.kinds.iter().map(|kind| factor * numbers[*kind]).collect();
        let system = Water {
            side: start.sides[0],
            masses: of(&start.masses, UNIT),
            charges: of(&start.charges, 1.0),
            bonds: start.bonds.clone(),
            angles: start.angles.clone(),
        };
        follow(system.run_with(VelocityVerlet, start.phase(UNIT), duration)?, steps)
    };
    Scene {
        name: "water",
        start: Start {
            sides: [CELLS as f64 * spacing; 3],
            positions: (0..count).map(atom).collect(),
            velocities: velocities(count, 0.005),
            kinds: (0..count).map(|i| usize::from(i % 3 > 0)).collect(),
            masses: vec![15.9994, 1.008],
            charges,
            molecule: 3,
            bonds: (0..count).step_by(3).flat_map(|i| [[i, i + 1], [i, i + 2]]).collect(),
            angles: (0..count).step_by(3).map(|i| [i + 1, i, i + 2]).collect(),
        },
        styles: format!(
            "units real\natom_style full\nspecial_bonds lj/coul 0.0 0.0 0.0\nread_data data\n\
             bond_style harmonic\nbond_coeff 1 {STIFFNESS} {LENGTH}\nangle_style harmonic\n\
             angle_coeff 1 {BENDING} {ANGLE}\npair_style lj/cut/coul/dsf 0.0 {CUTOFF} {CUTOFF}\n\
             pair_coeff 1 1 {DEPTH} {RADIUS}\npair_coeff 1 2 0.0 1.0\npair_coeff 2 2 0.0 1.0\nneighbor 2.0 bin\n\
             neigh_modify exclude molecule/intra all"
        ),
        files: Vec::new(),
        steps: 100,
        duration: 0.5,
        constant: -own * COULOMB / CUTOFF,
        tolerance: 1e-6,
        ours,
    }
}
