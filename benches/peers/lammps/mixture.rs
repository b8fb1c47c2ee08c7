//! Lennard-Jones atoms of one kind, LAMMPS' benchmark `lj`, and of two: Kob and Andersen (1995).

use crate::{
    Outcome, Scene,
    atoms::{FACE_CENTRED, Start, lattice, velocities},
    follow,
};
use integrator_core::prelude::*;

const CUTOFF: f64 = 2.5;

struct Melt {
    side: f64,
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
                    square += (x - self.side * (x / self.side).round()).powi(2);
                }
                if square < CUTOFF * CUTOFF {
                    let sixth = square.powi(-3);
                    energy += 4.0 * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
}

/// Kinds of atoms, with the depth and the radius of each pair of kinds.
struct Mixture {
    side: f64,
    kinds: Vec<usize>,
    depths: [[f64; 2]; 2],
    radii: [[f64; 2]; 2],
}

#[hamiltonian]
impl Mixture {
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
                    square += (x - self.side * (x / self.side).round()).powi(2);
                }
                let radius = self.radii[self.kinds[i]][self.kinds[j]];
                if square < (CUTOFF * radius).powi(2) {
                    let sixth = (radius * radius / square).powi(3);
                    energy += 4.0 * self.depths[self.kinds[i]][self.kinds[j]] * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
}

fn start(density: f64, speed: f64, masses: Vec<f64>, kind: impl Fn(usize) -> usize) -> Start {
    let (positions, side) = lattice(20, (4.0 / density).cbrt(), &FACE_CENTRED);
    let count = positions.len();
    let (velocities, kinds) = (velocities(count, speed), (0..count).map(kind).collect());
    Start { sides: [side; 3], positions, velocities, kinds, masses, ..Start::default() }
}

pub(crate) fn melt() -> Scene {
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        follow(Melt { side: start.sides[0] }.run_with(VelocityVerlet, start.phase(1.0), duration)?, steps)
    };
    Scene {
        name: "lj",
        start: start(0.8442, 2.1, vec![1.0], |_| 0),
        styles: "units lj\natom_style atomic\nread_data data\npair_style lj/cut 2.5\npair_coeff 1 1 1.0 1.0 2.5\n\
                 neighbor 0.3 bin\nneigh_modify delay 0 every 20 check no"
            .to_owned(),
        files: Vec::new(),
        steps: 100,
        duration: 0.005,
        constant: 0.0,
        tolerance: 1e-6,
        ours,
    }
}

pub(crate) fn kob_andersen() -> Scene {
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        let (depths, radii) = ([[1.0, 1.5], [1.5, 0.5]], [[1.0, 0.8], [0.8, 0.88]]);
        let system = Mixture { side: start.sides[0], kinds: start.kinds.clone(), depths, radii };
        follow(system.run_with(VelocityVerlet, start.phase(1.0), duration)?, steps)
    };
    Scene {
        name: "kob_andersen",
        start: start(1.2, 1.5, vec![1.0; 2], |i| usize::from(i * 7 % 5 == 4)),
        styles: "units lj\natom_style atomic\nread_data data\npair_style lj/cut 2.5\npair_coeff 1 1 1.0 1.0 2.5\n\
                 pair_coeff 1 2 1.5 0.8 2.0\npair_coeff 2 2 0.5 0.88 2.2\nneighbor 0.3 bin"
            .to_owned(),
        files: Vec::new(),
        steps: 100,
        duration: 0.003,
        constant: 0.0,
        tolerance: 1e-6,
        ours,
    }
}
