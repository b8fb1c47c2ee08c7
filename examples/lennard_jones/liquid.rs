//! Argon atoms in a box without walls, and how they are arranged.

use integrator_core::prelude::*;

#[path = "../support/normal.rs"]
mod normal;
use normal::normal;

/// Atoms that feel the nearest image of one another, up to a distance. Units are those of Lennard-Jones.
#[derive(Clone, Copy)]
pub(crate) struct Argon {
    /// The side of the box.
    pub(crate) side: f64,
    /// Half the side at most.
    pub(crate) cutoff: f64,
}

#[hamiltonian(compose = VelocityVerlet)]
impl Argon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    /// `4 (r⁻¹² - r⁻⁶)` less its value and slope, over `r²`, at the cutoff, so that neither energy nor force jumps there.
    pub(crate) fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square =
                    self.across(q[i][0] - q[j][0]) + self.across(q[i][1] - q[j][1]) + self.across(q[i][2] - q[j][2]);
                if square < self.cutoff.powi(2) {
                    let sixth = square.powi(-3);
                    energy +=
                        4.0 * (sixth * sixth - sixth) - self.value() - self.slope() * (square - self.cutoff.powi(2));
                }
            }
        }
        energy
    }
    /// The square of a distance along an axis, to the nearest image.
    fn across(&self, difference: f64) -> f64 {
        (difference - self.side * (difference / self.side).round()).powi(2)
    }
    fn value(&self) -> f64 {
        4.0 * (self.cutoff.powi(-12) - self.cutoff.powi(-6))
    }
    fn slope(&self) -> f64 {
        4.0 * (3.0 * self.cutoff.powi(-8) - 6.0 * self.cutoff.powi(-14))
    }
}

/// A liquid under way.
pub(crate) struct Liquid {
    pub(crate) argon: Argon,
    run: Run<Vec<[f64; 3]>>,
}

impl Liquid {
    /// Four atoms in each of `cells` cubed cells of a crystal, with normally distributed momenta and a total of zero.
    pub(crate) fn crystal(
        cells: usize,
        density: f64,
        temperature: f64,
        h: f64,
        random: &mut fastrand::Rng,
    ) -> Result<Self, Error> {
        let cell = (4.0 / density).cbrt();
        let corners = [[0.25, 0.25, 0.25], [0.75, 0.75, 0.25], [0.75, 0.25, 0.75], [0.25, 0.75, 0.75]];
        let mut q = Vec::new();
        for (x, y, z) in (0..cells.pow(3)).map(|n| (n % cells, n / cells % cells, n / cells.pow(2))) {
            q.extend(corners.map(|[a, b, c]| [x as f64 + a, y as f64 + b, z as f64 + c].map(|place| cell * place)));
        }
        let mut p: Vec<[f64; 3]> = q.iter().map(|_| [(); 3].map(|()| normal(random))).collect();
        let mean = [0, 1, 2].map(|axis| p.iter().map(|p| p[axis]).sum::<f64>() / p.len() as f64);
        p.iter_mut().for_each(|p| *p = [0, 1, 2].map(|axis| p[axis] - mean[axis]));
        let side = cell * cells as f64;
        let argon = Argon { side, cutoff: 2.5_f64.min(side / 2.0) };
        let mut liquid = Self { argon, run: argon.run(Phase::new(q, p), h)? };
        liquid.heat_to(temperature)?;
        Ok(liquid)
    }

    pub(crate) fn state(&self) -> Phase<Vec<[f64; 3]>> {
        self.run.state()
    }

    /// `2 T / (3 N - 3)`: a total momentum of zero leaves three degrees of freedom less.
    pub(crate) fn temperature(&self) -> f64 {
        2.0 * self.run.kinetic() / (3 * self.state().p.len() - 3) as f64
    }

    /// Makes all atoms faster or slower.
    pub(crate) fn heat_to(&mut self, temperature: f64) -> Result<(), Error> {
        let factor = (temperature / self.temperature()).sqrt();
        self.run.map_state(|state| state.p.iter_mut().for_each(|p| *p = p.map(|p| factor * p)))
    }

    pub(crate) fn energy(&self) -> f64 {
        self.run.energy()
    }

    /// Takes steps; then those who left the box come back in on the other side, which changes nothing but their numbers.
    pub(crate) fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.run.advance(steps)?;
        let side = self.argon.side;
        self.run.map_state(|state| state.q.iter_mut().for_each(|q| *q = q.map(|x| x.rem_euclid(side))))
    }
}

/// How many pairs are at which distance: the radial distribution function.
pub(crate) struct Distances {
    width: f64,
    counts: Vec<u64>,
    looks: u64,
}

impl Distances {
    /// Distances up to half the box, in so many classes.
    pub(crate) fn new(argon: &Argon, classes: usize) -> Self {
        Self { width: argon.side / 2.0 / classes as f64, counts: vec![0; classes], looks: 0 }
    }

    pub(crate) fn look(&mut self, liquid: &Liquid) {
        self.looks += 1;
        let Phase { q, .. } = liquid.state();
        for i in 0..q.len() {
            for j in 0..i {
                let square: f64 = (0..3).map(|axis| liquid.argon.across(q[i][axis] - q[j][axis])).sum();
                if let Some(count) = self.counts.get_mut((square.sqrt() / self.width) as usize) {
                    *count += 1;
                }
            }
        }
    }

    /// `g(r)` in the middle of each class: pairs per pairs of a gas of that density.
    pub(crate) fn distribution(&self, liquid: &Liquid) -> Vec<(f64, f64)> {
        let atoms = liquid.state().q.len() as f64;
        let density = 0.5 * atoms * atoms / liquid.argon.side.powi(3) * self.looks as f64;
        let shell = |class: usize| {
            let radius = |edge: usize| (edge as f64 * self.width).powi(3);
            4.0 / 3.0 * std::f64::consts::PI * (radius(class + 1) - radius(class))
        };
        let class = |(class, count): (usize, &u64)| {
            ((class as f64 + 0.5) * self.width, *count as f64 / (density * shell(class)))
        };
        self.counts.iter().enumerate().map(class).collect()
    }
}

/// Where a distribution is greatest and how great, by a parabola through three classes.
pub(crate) fn peak(distribution: &[(f64, f64)]) -> Option<(f64, f64)> {
    let highest = distribution.windows(3).max_by(|a, b| a[1].1.total_cmp(&b[1].1))?;
    let [(left, a), (middle, b), (_, c)] = [highest[0], highest[1], highest[2]];
    let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
    Some((middle + shift * (middle - left), b - 0.25 * (a - c) * shift))
}
