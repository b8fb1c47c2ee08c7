//! Stars in the mean field of a galaxy or cluster.

use integrator_core::prelude::*;

/// The Hénon–Heiles potential, of the third integral (Hénon and Heiles, Astronomical Journal 69, 1964).
pub(crate) struct HenonHeiles {
    pub(crate) coupling: f64,
}

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + self.coupling * (x * x * y - y.powi(3) / 3.0)
    }
}

/// A flattened galaxy with a flat rotation curve (Binney and Tremaine, Galactic Dynamics, section 3.3.1).
pub(crate) struct Logarithmic {
    pub(crate) core: f64,
    pub(crate) flattening: f64,
}

#[hamiltonian]
impl Logarithmic {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (self.core.powi(2) + x * x + (y / self.flattening).powi(2)).ln() / 2.0
    }
}

/// A galactic disk (Miyamoto and Nagai, Publications of the Astronomical Society of Japan 27, 1975).
pub(crate) struct Disk {
    pub(crate) length: f64,
    pub(crate) height: f64,
}

#[hamiltonian]
impl Disk {
    fn kinetic(&self, [px, py, pz]: [f64; 3]) -> f64 {
        (px * px + py * py + pz * pz) / 2.0
    }
    fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
        let height = self.length + z.hypot(self.height);
        -1.0 / (x * x + y * y + height * height).sqrt()
    }
    #[invariant]
    fn about_the_axis(&self, [x, y, _]: [f64; 3], [px, py, _]: [f64; 3]) -> f64 {
        x * py - y * px
    }
}

/// The isochrone cluster, in which the radial period depends on the energy alone (Hénon, Annales d'Astrophysique 22, 1959).
pub(crate) struct Isochrone {
    pub(crate) length: f64,
}

#[hamiltonian]
impl Isochrone {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (self.length + (self.length.powi(2) + x * x + y * y).sqrt())
    }
    #[invariant]
    fn angular_momentum(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
}
