//! LAMMPS' benchmark `chain`: a melt of 320 polymers of 100 beads (Kremer and Grest 1990), without its thermostat.

use crate::{
    Outcome, Scene,
    atoms::{Start, velocities},
    follow,
};
use integrator_core::prelude::*;

/// Beads of a polymer.
const BEADS: usize = 100;

/// The constant of the bonds and their greatest length.
const STIFFNESS: f64 = 30.0;
const LONGEST: f64 = 1.5;

struct Melt {
    sides: [f64; 3],
    bonds: Vec<[usize; 2]>,
}

#[hamiltonian]
impl Melt {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let mut square = 0.0;
                for d in 0..3 {
                    let x = q[i][d] - q[j][d];
                    square += (x - self.sides[d] * (x / self.sides[d]).round()).powi(2);
                }
                if square < 2.0_f64.cbrt() {
                    energy += self.repulsion(square);
                }
            }
        }
        for &[a, b] in &self.bonds {
            let mut square = 0.0;
            for d in 0..3 {
                square += (q[a][d] - q[b][d]).powi(2);
            }
            energy -= 0.5 * STIFFNESS * LONGEST.powi(2) * (1.0 - square / LONGEST.powi(2)).ln();
        }
        energy
    }
    fn repulsion(&self, square: f64) -> f64 {
        let sixth = square.powi(-3);
        4.0 * (sixth * sixth - sixth) + 1.0
    }
}

/// A path through all sites of a lattice, cut into polymers.
pub(crate) fn scene() -> Scene {
    let (sizes, spacing) = ([40_usize, 40, 20], (1.0_f64 / 0.8442).cbrt());
    let along = |n: usize, size: usize, turns: usize| if turns.is_multiple_of(2) { n } else { size - 1 - n };
    let site = |n: usize| {
        let (x, row) = (n % sizes[0], n / sizes[0]);
        let (y, plane) = (row % sizes[1], row / sizes[1]);
        [along(x, sizes[0], row), along(y, sizes[1], plane), plane].map(|at| at as f64 * spacing)
    };
    let count: usize = sizes.iter().product();
    let bonds: Vec<_> = (1..count).filter(|i| i % BEADS > 0).map(|i| [i - 1, i]).collect();
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        follow(
            Melt { sides: start.sides, bonds: start.bonds.clone() }.run_with(
                VelocityVerlet,
                start.phase(1.0),
                duration,
            )?,
            steps,
        )
    };
    Scene {
        name: "chain",
        start: Start {
            sides: sizes.map(|size| size as f64 * spacing),
            positions: (0..count).map(site).collect(),
            velocities: velocities(count, 1.7),
            kinds: vec![0; count],
            masses: vec![1.0],
            molecule: BEADS,
            bonds,
            ..Start::default()
        },
        // The attraction within a bond is that of all pairs, as in `special_bonds fene`.
        styles: "units lj\natom_style bond\nspecial_bonds lj/coul 1.0 1.0 1.0\nread_data data\n\
                 bond_style fene\nbond_coeff 1 30.0 1.5 0.0 1.0\npair_style lj/cut 1.122462048309373\n\
                 pair_modify shift yes\npair_coeff 1 1 1.0 1.0 1.122462048309373\nneighbor 0.4 bin\n\
                 neigh_modify delay 5 every 1"
            .to_owned(),
        files: Vec::new(),
        steps: 200,
        duration: 0.004,
        constant: 0.0,
        tolerance: 1e-6,
        ours,
    }
}
