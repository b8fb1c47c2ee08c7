//! Hamiltonians that are not smooth everywhere: encounters, switches in time, cutoffs, boxes.

use integrator_core::prelude::*;

/// A comet that nearly hits its star, for `Logarithmic(Yoshida4)`, whose steps shrink there (Mikkola and
/// Tanikawa, Celestial Mechanics and Dynamical Astronomy 74, 1999).
pub(crate) struct Comet;

#[hamiltonian]
impl Comet {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / x.hypot(y)
    }
    #[invariant]
    fn angular_momentum(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
}

/// A force that is switched on and off; conditions on time use the middle of a step (Landau and
/// Lifshitz, Mechanics, § 22).
pub(crate) struct Pulse {
    pub(crate) strength: f64,
    pub(crate) on: f64,
    pub(crate) off: f64,
}

#[hamiltonian]
impl Pulse {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1], t: f64) -> f64 {
        let force = if t > self.on && t < self.off { self.strength } else { 0.0 };
        x * x / 2.0 + x.powi(4) / 4.0 - force * x
    }
}

/// Soft repulsive bodies with a cutoff at which the force and two of its derivatives vanish (Groot and
/// Warren, Journal of Chemical Physics 107, 1997, with a smoother force).
pub(crate) struct Soft {
    pub(crate) cutoff: f64,
}

#[hamiltonian]
impl Soft {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|[px, py]| (px * px + py * py) / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                if square < self.cutoff.powi(2) {
                    energy += (1.0 - square / self.cutoff.powi(2)).powi(4);
                }
            }
        }
        energy
    }
}

/// The same in a periodic box, with nearest images (Allen and Tildesley, Computer Simulation of Liquids, section 1.6).
pub(crate) struct Periodic {
    pub(crate) side: f64,
    pub(crate) cutoff: f64,
}

#[hamiltonian]
impl Periodic {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|[px, py]| (px * px + py * py) / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let mut square = 0.0;
                for k in 0..2 {
                    let x = q[i][k] - q[j][k];
                    square += (x - self.side * (x / self.side).round()).powi(2);
                }
                if square < self.cutoff.powi(2) {
                    energy += (1.0 - square / self.cutoff.powi(2)).powi(4);
                }
            }
        }
        energy
    }
}
