//! Argon atoms in a periodic box. Lengths are in ångström, times in picoseconds, masses in atomic units.

use integrator_core::prelude::*;

#[path = "../support/normal.rs"]
mod normal;
use normal::normal;

/// Boltzmann constant in these units, per kelvin.
pub(crate) const BOLTZMANN: f64 = 0.831_446_261_815_324;
/// Well depth, diameter, mass and density of Rahman (1964), for the liquid at 94.4 K.
const DEPTH: f64 = 120.0 * BOLTZMANN;
const DIAMETER: f64 = 3.4;
const MASS: f64 = 39.95;
pub(crate) const DENSITY: f64 = 864.0 / (34.78 * 34.78 * 34.78);
/// Step of 0.01 ps, a 125th of the period of a pair, which has `ω² = 57.1 ε / (m σ²)` per atom.
pub(crate) const STEP: f64 = 0.01;

/// Atoms that interact with the nearest image of each other, up to a cutoff.
#[derive(Clone, Copy)]
pub(crate) struct Argon {
    /// Side of the box.
    pub(crate) side: f64,
    /// Cutoff, at most half the side.
    pub(crate) cutoff: f64,
}

#[hamiltonian(compose = VelocityVerlet)]
impl Argon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * MASS);
        }
        energy
    }
    /// Returns the sum of `4 ε ((σ/r)¹² - (σ/r)⁶)`, minus its value and its slope in `r²` at the cutoff, so that energy and
    /// force are continuous.
    pub(crate) fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square =
                    self.across(q[i][0] - q[j][0]) + self.across(q[i][1] - q[j][1]) + self.across(q[i][2] - q[j][2]);
                if square < self.cutoff.powi(2) {
                    let sixth = DIAMETER.powi(6) * square.powi(-3);
                    energy += 4.0 * DEPTH * (sixth * sixth - sixth)
                        - self.value()
                        - self.slope() * (square - self.cutoff.powi(2));
                }
            }
        }
        energy
    }
    /// Returns the squared distance along an axis to the nearest image.
    fn across(&self, difference: f64) -> f64 {
        (difference - self.side * (difference / self.side).round()).powi(2)
    }
    fn value(&self) -> f64 {
        let sixth = (DIAMETER / self.cutoff).powi(6);
        4.0 * DEPTH * (sixth * sixth - sixth)
    }
    fn slope(&self) -> f64 {
        let sixth = (DIAMETER / self.cutoff).powi(6);
        4.0 * DEPTH * (3.0 * sixth - 6.0 * sixth * sixth) / self.cutoff.powi(2)
    }
}

/// A liquid and its state.
pub(crate) struct Liquid {
    pub(crate) argon: Argon,
    run: Run<Vec<[f64; 3]>>,
}

impl Liquid {
    /// Creates a crystal of `cells`³ cells of four atoms, with normally distributed momenta of total zero.
    pub(crate) fn crystal(cells: usize, temperature: f64, random: &mut fastrand::Rng) -> Result<Self, Error> {
        let cell = (4.0 / DENSITY).cbrt();
        let corners = [[0.25, 0.25, 0.25], [0.75, 0.75, 0.25], [0.75, 0.25, 0.75], [0.25, 0.75, 0.75]];
        let mut q = Vec::new();
        for (x, y, z) in (0..cells.pow(3)).map(|n| (n % cells, n / cells % cells, n / cells.pow(2))) {
            q.extend(corners.map(|[a, b, c]| [x as f64 + a, y as f64 + b, z as f64 + c].map(|place| cell * place)));
        }
        let mut p: Vec<[f64; 3]> = q.iter().map(|_| [(); 3].map(|()| normal(random))).collect();
        let mean = [0, 1, 2].map(|axis| p.iter().map(|p| p[axis]).sum::<f64>() / p.len() as f64);
        p.iter_mut().for_each(|p| *p = [0, 1, 2].map(|axis| p[axis] - mean[axis]));
        let side = cell * cells as f64;
        let argon = Argon { side, cutoff: (2.5 * DIAMETER).min(side / 2.0) };
        let mut liquid = Self { argon, run: argon.run(Phase::new(q, p), STEP)? };
        liquid.heat_to(temperature)?;
        Ok(liquid)
    }

    pub(crate) fn state(&self) -> Phase<Vec<[f64; 3]>> {
        self.run.state()
    }

    /// Returns the temperature in kelvin, `2 T / (3 N - 3) k`. The total momentum of zero removes three degrees of freedom.
    pub(crate) fn temperature(&self) -> f64 {
        let Phase { p, .. } = self.state();
        2.0 * self.argon.kinetic(&p) / ((3 * p.len() - 3) as f64 * BOLTZMANN)
    }

    /// Rescales all momenta to a temperature.
    pub(crate) fn heat_to(&mut self, temperature: f64) -> Result<(), Error> {
        let factor = (temperature / self.temperature()).sqrt();
        self.run.map_state(|state| state.p.iter_mut().for_each(|p| *p = p.map(|p| factor * p)))
    }

    /// Returns the energy per atom in kelvin.
    pub(crate) fn energy(&self) -> f64 {
        self.run.energy() / (self.state().p.len() as f64 * BOLTZMANN)
    }

    pub(crate) fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.run.advance(steps)
    }
}
