//! The benchmarked systems: five small ones with references in `examples/data/problems.json`, and large ones.

pub mod jacobi;
pub mod molecule;

use integrator_core::prelude::*;

/// The gravitational constant, in astronomical units, solar masses and days.
pub const GRAVITY: f64 = 2.95912208286e-4;

/// A pendulum.
#[derive(Clone, Copy)]
pub struct Pendulum {
    /// Mass of the bob.
    pub mass: f64,
    /// Length of the rod.
    pub length: f64,
    /// Gravitational acceleration.
    pub gravity: f64,
}

#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * self.gravity * self.length * q[0].cos()
    }
}

/// A pendulum with a sine that has an error of up to 4 ulp.
#[derive(Clone, Copy)]
pub struct FastPendulum(pub Pendulum);

#[hamiltonian(functions = fast)]
impl FastPendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.0.mass * self.0.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.0.mass * self.0.gravity * self.0.length * q[0].cos()
    }
}

/// A star in a galactic potential (Hénon and Heiles 1964).
#[derive(Clone, Copy)]
pub struct HenonHeiles;

#[hamiltonian(taylor)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// The same system, split into oscillators and their coupling.
#[derive(Clone, Copy)]
pub struct CoupledOscillators;

#[hamiltonian(split = quadratic + rest)]
impl CoupledOscillators {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// Kepler's problem.
#[derive(Clone, Copy)]
pub struct Kepler;

#[hamiltonian(taylor)]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

/// The Sun with the inner planets, Jupiter, Saturn, Uranus, Neptune and Pluto.
#[derive(Clone, Copy)]
pub struct Solar {
    /// Masses in solar masses.
    pub masses: [f64; 6],
}

#[hamiltonian(taylor)]
impl Solar {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= GRAVITY * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

/// Planets attracted by a fixed star and by a spring.
#[derive(Clone, Copy)]
pub struct Planets {
    /// Masses in solar masses.
    pub masses: [f64; 5],
    /// Gravity times the mass of the star.
    pub pull: f64,
    /// Stiffness of the spring.
    pub spring: f64,
}

#[hamiltonian(split = kepler + spring)]
impl Planets {
    fn kepler(&self, q: [[f64; 3]; 5], p: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            let ([x, y, z], [u, v, w]) = (q[i], p[i]);
            energy += (u * u + v * v + w * w) / (2.0 * self.masses[i]);
            energy -= self.pull * self.masses[i] / (x * x + y * y + z * z).sqrt();
        }
        energy
    }
    fn spring(&self, q: [[f64; 3]; 5]) -> f64 {
        0.5 * self.spring * q.iter().map(|[x, y, z]| x * x + y * y + z * z).sum::<f64>()
    }
}

/// The chain of Fermi, Pasta, Ulam and Tsingou: 32 sites between walls.
#[derive(Clone, Copy)]
pub struct Chain32 {
    /// Nonlinear coefficient of the bonds.
    pub alpha: f64,
}

#[hamiltonian(taylor)]
impl Chain32 {
    fn kinetic(&self, p: [f64; 32]) -> f64 {
        let mut energy = 0.0;
        for i in 0..32 {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: [f64; 32]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[31]);
        for i in 0..31 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        0.5 * stretch * stretch + self.alpha * stretch.powi(3) / 3.0
    }
}

/// The same chain of any length.
#[derive(Clone, Copy)]
pub struct Fput {
    /// Nonlinear coefficient of the bonds.
    pub alpha: f64,
}

#[hamiltonian]
impl Fput {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[q.len() - 1]);
        for i in 0..q.len() - 1 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        0.5 * stretch * stretch + self.alpha * stretch.powi(3) / 3.0
    }
}

/// The Toda chain (1967), with solitons of any speed.
#[derive(Clone, Copy)]
pub struct Toda;

#[hamiltonian]
impl Toda {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = self.bond(q[0]) + self.bond(-q[q.len() - 1]);
        for i in 0..q.len() - 1 {
            energy += self.bond(q[i + 1] - q[i]);
        }
        energy
    }
    fn bond(&self, stretch: f64) -> f64 {
        stretch.exp() - stretch
    }
}

/// Coupled pendulums (Frenkel and Kontorova 1938; the sine-Gordon equation on a lattice).
#[derive(Clone, Copy)]
pub struct SineGordon {
    /// Stiffness of the coupling.
    pub stiffness: f64,
}

#[hamiltonian]
impl SineGordon {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.5 * self.stiffness * (q[0].powi(2) + q[q.len() - 1].powi(2));
        for i in 0..q.len() - 1 {
            energy += 0.5 * self.stiffness * (q[i + 1] - q[i]).powi(2);
        }
        for i in 0..q.len() {
            energy += 1.0 - q[i].cos();
        }
        energy
    }
}

/// Sites in double wells, joined by springs: the φ⁴ field on a lattice.
#[derive(Clone, Copy)]
pub struct Phi4 {
    /// Stiffness of the springs.
    pub stiffness: f64,
}

#[hamiltonian]
impl Phi4 {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.5 * self.stiffness * (q[0].powi(2) + q[q.len() - 1].powi(2));
        for i in 0..q.len() - 1 {
            energy += 0.5 * self.stiffness * (q[i + 1] - q[i]).powi(2);
        }
        for i in 0..q.len() {
            energy += 0.25 * (q[i] * q[i] - 1.0).powi(2);
        }
        energy
    }
}

/// The φ⁴ field on a square lattice with a given number of sites per row, periodic in both directions.
macro_rules! phi4_plane {
    ($name:ident, $width:literal, $about:literal) => {
        #[doc = $about]
        #[derive(Clone, Copy)]
        pub struct $name {
            /// Stiffness of the springs.
            pub stiffness: f64,
        }

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: &[[f64; $width]]) -> f64 {
                let mut energy = 0.0;
                for i in 0..p.len() {
                    for j in 0..$width {
                        energy += 0.5 * p[i][j] * p[i][j];
                    }
                }
                energy
            }
            fn potential(&self, q: &[[f64; $width]]) -> f64 {
                let n = q.len();
                let mut energy = 0.0;
                for i in 0..n {
                    for j in 0..$width {
                        let (right, below) = (q[i][(j + 1) % $width] - q[i][j], q[(i + 1) % n][j] - q[i][j]);
                        energy += 0.5 * self.stiffness * (right.powi(2) + below.powi(2));
                        energy += 0.25 * (q[i][j] * q[i][j] - 1.0).powi(2);
                    }
                }
                energy
            }
        }
    };
}
phi4_plane!(Phi4Plane, 256, "The φ⁴ field on a square lattice with 256 sites in a row, closed in both directions.");
phi4_plane!(
    Phi4WidePlane,
    4096,
    "The φ⁴ field on a square lattice with 4096 sites in a row, closed in both directions."
);

/// The φ⁴ field on a cubic lattice with 128 rows of 128 sites in a plane, periodic in all directions.
#[derive(Clone, Copy)]
pub struct Phi4Volume {
    /// Stiffness of the springs between neighbours.
    pub stiffness: f64,
}

#[hamiltonian]
impl Phi4Volume {
    fn kinetic(&self, p: &[[[f64; 128]; 128]]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; 128]; 128]]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for k in 0..n {
            for j in 0..128 {
                for i in 0..128 {
                    let x = q[k][j][i];
                    let (right, below) = (q[k][j][(i + 1) % 128] - x, q[k][(j + 1) % 128][i] - x);
                    let behind = q[(k + 1) % n][j][i] - x;
                    energy += 0.5 * self.stiffness * (right.powi(2) + below.powi(2) + behind.powi(2));
                    energy += 0.25 * (x * x - 1.0).powi(2);
                }
            }
        }
        energy
    }
}

/// A cluster of stars.
#[derive(Clone)]
pub struct Cluster {
    /// Masses of the stars.
    pub masses: Vec<f64>,
}

#[hamiltonian]
impl Cluster {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= GRAVITY * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

/// A drop of argon: atoms with a pair potential up to a cutoff.
#[derive(Clone, Copy)]
pub struct Argon {
    /// Cutoff in units of the atoms' diameter.
    pub cutoff: f64,
}

#[hamiltonian]
impl Argon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + (q[i][2] - q[j][2]).powi(2);
                if square < self.cutoff * self.cutoff {
                    let sixth = square.powi(-3);
                    energy += 4.0 * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
}

/// Argon in a periodic box, at any temperature.
#[derive(Clone, Copy)]
pub struct ArgonInBox {
    /// Side in units of the atoms' diameter.
    pub side: f64,
}

impl ArgonInBox {
    /// Cutoff of the potential in units of the atoms' diameter.
    pub const CUTOFF: f64 = 2.5;
}

#[hamiltonian]
impl ArgonInBox {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let x = x - self.side * (x / self.side).round_ties_even();
                let y = y - self.side * (y / self.side).round_ties_even();
                let z = z - self.side * (z / self.side).round_ties_even();
                let square = x * x + y * y + z * z;
                if square < 6.25 {
                    let sixth = square.powi(-3);
                    energy += 4.0 * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
}
