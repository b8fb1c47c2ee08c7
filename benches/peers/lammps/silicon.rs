//! Silicon by Stillinger and Weber (1985), in reduced units: pairs, and triplets with a cutoff on each leg.

use crate::{
    Outcome, Scene,
    atoms::{FACE_CENTRED, Start, lattice, velocities},
    follow,
};
use integrator_core::prelude::*;

/// The parameters of the potential, as the file of LAMMPS has them.
const CUTOFF: f64 = 1.8;
const LAMBDA: f64 = 21.0;
const GAMMA: f64 = 1.2;
const A: f64 = 7.049_556_277;
const B: f64 = 0.602_224_558_4;

struct Silicon {
    side: f64,
}

#[hamiltonian]
impl Silicon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if j == i {
                    continue;
                }
                let u = self.displacement(q[i], q[j]);
                let r = self.length(u);
                if r >= CUTOFF {
                    continue;
                }
                energy += 0.5 * A * (B / r.powi(4) - 1.0) * (1.0 / (r - CUTOFF)).exp();
                for k in j + 1..q.len() {
                    let w = self.displacement(q[i], q[k]);
                    let s = self.length(w);
                    if k != i && s < CUTOFF {
                        let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (r * s);
                        let damping = (GAMMA / (r - CUTOFF) + GAMMA / (s - CUTOFF)).exp();
                        energy += LAMBDA * (cosine + 1.0 / 3.0).powi(2) * damping;
                    }
                }
            }
        }
        energy
    }
    fn displacement(&self, from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|d| (to[d] - from[d]) - self.side * ((to[d] - from[d]) / self.side).round())
    }
    fn length(&self, [x, y, z]: [f64; 3]) -> f64 {
        (x * x + y * y + z * z).sqrt()
    }
}

pub(crate) fn scene() -> Scene {
    let mut in_cell = FACE_CENTRED.to_vec();
    in_cell.extend(FACE_CENTRED.map(|site| site.map(|x| x + 0.25)));
    // The density of the crystal is 0.46 atoms for each cubed unit of length.
    let (positions, side) = lattice(8, (8.0_f64 / 0.46).cbrt(), &in_cell);
    let (count, sides) = (positions.len(), [side; 3]);
    let (velocities, kinds) = (velocities(count, 0.4), vec![0; count]);
    let ours = |start: &Start, duration, steps| -> Result<Outcome, Error> {
        follow(Silicon { side: start.sides[0] }.run_with(VelocityVerlet, start.phase(1.0), duration)?, steps)
    };
    let table = format!("Si Si Si 1 1 {CUTOFF} {LAMBDA} {GAMMA} {:.17} {A} {B} 4 0 0\n", -1.0 / 3.0);
    Scene {
        name: "silicon",
        start: Start { sides, positions, velocities, kinds, masses: vec![1.0], ..Start::default() },
        styles: "units lj\natom_style atomic\nread_data data\npair_style sw\npair_coeff * * table Si\n\
                 neighbor 0.3 bin\nneigh_modify every 1 delay 5 check yes"
            .to_owned(),
        files: vec![("table", table)],
        steps: 100,
        duration: 0.005,
        constant: 0.0,
        tolerance: 1e-10,
        ours,
    }
}
