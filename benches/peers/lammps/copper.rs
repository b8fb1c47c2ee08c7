//! Copper by Sutton and Chen (1990), in place of the table of LAMMPS' benchmark `eam`, with as many neighbours.

use crate::{
    Outcome, Scene,
    atoms::{FACE_CENTRED, Start, lattice, velocities},
    follow,
};
use integrator_core::prelude::*;
use std::fmt::Write;

/// Constants in eV and Å.
const DEPTH: f64 = 1.2382e-2;
const CELL: f64 = 3.61;
const FACTOR: f64 = 39.432;
const CUTOFF: f64 = 4.95;

/// The mass of an atom in g/mol, and the unit g/mol in eV ps²/Å².
const MASS: f64 = 63.546;
const UNIT: f64 = 1.036_426_9e-4;

struct Copper {
    side: f64,
}

#[hamiltonian]
impl Copper {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / (2.0 * MASS * UNIT)).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            let mut density = 0.0;
            for j in 0..q.len() {
                if i != j {
                    let square = self.square(q[i], q[j]);
                    if square < CUTOFF * CUTOFF {
                        density += (CELL * CELL / square).powi(3);
                        energy += 0.5 * DEPTH * (CELL * CELL / square).powf(4.5);
                    }
                }
            }
            energy -= DEPTH * FACTOR * density.sqrt();
        }
        energy
    }
    fn square(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        let mut square = 0.0;
        for d in 0..3 {
            let x = a[d] - b[d];
            square += (x - self.side * (x / self.side).round()).powi(2);
        }
        square
    }
}

/// The functions as a table for LAMMPS, fine enough that its splines are exact to 1e-5.
fn table() -> String {
    let (count, step) = (2_000, CUTOFF / 1_999.0);
    let density_step = 200.0 / 1_999.0;
    let mut text = format!(
        "Sutton and Chen\n\n\n1 Cu\n{count} {density_step:e} {count} {step:e} {CUTOFF}\n29 {MASS} {CELL} fcc\n"
    );
    let mut lines = |of: &dyn Fn(f64) -> f64| {
        for n in 0..count {
            writeln!(text, "{:.16e}", of(f64::from(n))).ok();
        }
    };
    let radius = |n: f64| n.max(0.5) * step;
    lines(&|n| -DEPTH * FACTOR * (n * density_step).sqrt());
    lines(&|n| (CELL / radius(n)).powi(6).min(1e6));
    // The distance times the energy of a pair.
    lines(&|n| (radius(n) * DEPTH * (CELL / radius(n)).powi(9)).min(1e6));
    text
}

pub(crate) fn scene() -> Scene {
    let (positions, side) = lattice(20, CELL, &FACE_CENTRED);
    let (count, sides) = (positions.len(), [side; 3]);
    let (velocities, kinds) = (velocities(count, 7.8), vec![0; count]);
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        follow(Copper { side: start.sides[0] }.run_with(VelocityVerlet, start.phase(UNIT), duration)?, steps)
    };
    Scene {
        name: "eam",
        start: Start { sides, positions, velocities, kinds, masses: vec![MASS], ..Start::default() },
        styles: "units metal\natom_style atomic\nread_data data\npair_style eam/alloy\n\
                 pair_coeff * * table Cu\nneighbor 1.0 bin\nneigh_modify every 1 delay 5 check yes"
            .to_owned(),
        files: vec![("table", table())],
        steps: 100,
        duration: 0.005,
        constant: 0.0,
        tolerance: 1e-5,
        ours,
    }
}
