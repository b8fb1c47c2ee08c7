//! Chains, each a ring of eight sites.

use integrator_core::prelude::*;

/// Springs with a linear and a quadratic force (Fermi, Pasta, Ulam and Tsingou, Los Alamos report LA-1940, 1955).
pub(crate) struct Fput {
    pub(crate) cubic: f64,
}

#[hamiltonian]
impl Fput {
    fn kinetic(&self, p: [f64; 8]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 8]) -> f64 {
        let mut energy = 0.0;
        for i in 0..8 {
            let bond = q[(i + 1) % 8] - q[i];
            energy += bond * bond / 2.0 + self.cubic * bond.powi(3) / 3.0;
        }
        energy
    }
    #[invariant]
    fn momentum(&self, _q: [f64; 8], p: [f64; 8]) -> f64 {
        p.iter().sum()
    }
}

/// The Toda lattice, which has exact solitons (Toda, Journal of the Physical Society of Japan 22, 1967).
pub(crate) struct Toda;

#[hamiltonian]
impl Toda {
    fn kinetic(&self, p: [f64; 8]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 8]) -> f64 {
        let mut energy = 0.0;
        for i in 0..8 {
            let bond = q[(i + 1) % 8] - q[i];
            energy += bond.exp() - bond;
        }
        energy
    }
    #[invariant]
    fn momentum(&self, _q: [f64; 8], p: [f64; 8]) -> f64 {
        p.iter().sum()
    }
}

/// Atoms in a periodic substrate potential (Frenkel and Kontorova, Physikalische Zeitschrift der Sowjetunion 13, 1938).
pub(crate) struct FrenkelKontorova {
    pub(crate) ground: f64,
}

#[hamiltonian]
impl FrenkelKontorova {
    fn kinetic(&self, p: [f64; 8]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 8]) -> f64 {
        let mut energy = 0.0;
        for i in 0..8 {
            let bond = q[(i + 1) % 8] - q[i];
            energy += bond * bond / 2.0 + self.ground * (1.0 - q[i].cos());
        }
        energy
    }
}

/// The field φ⁴ on a lattice (Aubry, Journal of Chemical Physics 62, 1975).
pub(crate) struct PhiFour;

#[hamiltonian]
impl PhiFour {
    fn kinetic(&self, p: [f64; 8]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 8]) -> f64 {
        let mut energy = 0.0;
        for i in 0..8 {
            let bond = q[(i + 1) % 8] - q[i];
            energy += bond * bond / 2.0 + (q[i] * q[i] - 1.0).powi(2) / 4.0;
        }
        energy
    }
}

/// Coupled rotors (Livi, Pettini, Ruffo and Vulpiani, Journal of Statistical Physics 48, 1987).
pub(crate) struct Rotors {
    pub(crate) coupling: f64,
}

#[hamiltonian]
impl Rotors {
    fn kinetic(&self, p: [f64; 8]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 8]) -> f64 {
        let mut energy = 0.0;
        for i in 0..8 {
            let bond = q[(i + 1) % 8] - q[i];
            energy += self.coupling * (1.0 - bond.cos());
        }
        energy
    }
    #[invariant]
    fn momentum(&self, _q: [f64; 8], p: [f64; 8]) -> f64 {
        p.iter().sum()
    }
}
