//! Bonds, angles and clusters.

use integrator_core::prelude::*;

/// A bond that can break: the Morse potential (Morse, Physical Review 34, 1929).
pub(crate) struct Morse {
    pub(crate) depth: f64,
    pub(crate) width: f64,
}

#[hamiltonian]
impl Morse {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.depth * (1.0 - (-self.width * x).exp()).powi(2)
    }
}

/// The two bonds of water: Morse oscillators coupled by their momenta (Child and Halonen, Advances in Chemical Physics 57,
/// 1984).
pub(crate) struct Stretches {
    pub(crate) coupling: f64,
}

#[hamiltonian]
impl Stretches {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0 + self.coupling * px * py
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (1.0 - (-x).exp()).powi(2) + (1.0 - (-y).exp()).powi(2)
    }
}

/// The torsion of butane, in kJ/mol (Ryckaert and Bellemans, Chemical Physics Letters 30, 1975).
pub(crate) struct Butane {
    pub(crate) inertia: f64,
}

#[hamiltonian]
impl Butane {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / (2.0 * self.inertia)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let c = x.cos();
        9.28 + c * (12.16 - c * (13.12 + c * (3.06 - c * (26.24 - 31.5 * c))))
    }
}

/// Three argon atoms in Lennard-Jones units (Lennard-Jones, Proceedings of the Royal Society A 106, 1924).
pub(crate) struct Trimer;

#[hamiltonian]
impl Trimer {
    fn kinetic(&self, p: [[f64; 3]; 3]) -> f64 {
        (0..3).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / 2.0).sum()
    }
    fn potential(&self, q: [[f64; 3]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let inverse = 1.0 / (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>().powi(3);
                energy += 4.0 * (inverse * inverse - inverse);
            }
        }
        energy
    }
}
