//! Planets, satellites and moons.

use integrator_core::prelude::*;

/// A planet orbiting a star, in units with the period 2π (Goldstein, Classical Mechanics, section 3.7).
pub(crate) struct Kepler {
    pub(crate) strength: f64,
}

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -self.strength / x.hypot(y)
    }
    #[invariant]
    fn angular_momentum(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
}

/// A satellite of a flattened planet, with the second zonal harmonic J₂ (Brouwer, Astronomical Journal 64, 1959).
pub(crate) struct Satellite {
    pub(crate) flattening: f64,
}

#[hamiltonian]
impl Satellite {
    fn kinetic(&self, [px, py, pz]: [f64; 3]) -> f64 {
        (px * px + py * py + pz * pz) / 2.0
    }
    fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
        let r2 = x * x + y * y + z * z;
        -1.0 / r2.sqrt() * (1.0 - self.flattening * (3.0 * z * z / r2 - 1.0) / (2.0 * r2))
    }
    #[invariant]
    fn about_the_axis(&self, [x, y, _]: [f64; 3], [px, py, _]: [f64; 3]) -> f64 {
        x * py - y * px
    }
}

/// A particle near a black hole, with the pseudo-Newtonian potential of Paczyński and Wiita (Astronomy and Astrophysics 88,
/// 1980).
pub(crate) struct BlackHole {
    pub(crate) radius: f64,
}

#[hamiltonian]
impl BlackHole {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x.hypot(y) - self.radius)
    }
    #[invariant]
    fn angular_momentum(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
}

/// The rotation of an aspherical moon on an orbit of small eccentricity; time is the mean anomaly (Goldreich and Peale,
/// Astronomical Journal 71, 1966).
pub(crate) struct SpinOrbit {
    pub(crate) asphericity: f64,
    pub(crate) eccentricity: f64,
}

#[hamiltonian]
impl SpinOrbit {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1], t: f64) -> f64 {
        -self.asphericity / 4.0
            * ((2.0 * x - 2.0 * t).cos()
                + self.eccentricity * (3.5 * (2.0 * x - 3.0 * t).cos() - 0.5 * (2.0 * x - t).cos()))
    }
}

/// Three equal masses on the figure-eight orbit (Chenciner and Montgomery, Annals of Mathematics 152, 2000).
pub(crate) struct FigureEight;

#[hamiltonian]
impl FigureEight {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / 2.0).sum()
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                energy -= 1.0 / square.sqrt();
            }
        }
        energy
    }
    #[invariant]
    fn angular_momentum(&self, q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| q[i][0] * p[i][1] - q[i][1] * p[i][0]).sum()
    }
}
