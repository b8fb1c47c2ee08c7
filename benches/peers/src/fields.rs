//! The five problems for other crates: hand-written accelerations and energies of flat arrays.

use integrator_bench::{
    problems::GRAVITY,
    starts::{Problem, Problems},
};
use integrator_core::{Coords, Hamiltonian, Phase};

/// A system of `D` positions and velocities.
pub trait Field<const D: usize> {
    /// Returns the accelerations.
    fn acceleration(&self, q: &[f64; D]) -> [f64; D];
    /// Returns the sum of kinetic and potential energy.
    fn energy(&self, q: &[f64; D], v: &[f64; D]) -> f64;
}

/// A field with an initial state and a known final state.
pub struct Case<F, const D: usize> {
    /// The field.
    pub field: F,
    /// Initial positions.
    pub q: [f64; D],
    /// Initial velocities.
    pub v: [f64; D],
    /// Duration of the run.
    pub span: f64,
    /// Final positions.
    pub reference: Vec<f64>,
}

impl<F: Field<D>, const D: usize> Case<F, D> {
    fn new<H: Hamiltonian>(field: F, problem: &Problem<H>, masses: impl Fn(usize) -> f64) -> Self
    where
        H::Coords: Coords<Leaf = f64>,
    {
        let Phase { q, p } = &problem.start;
        let velocities: Vec<f64> = p.flat().iter().enumerate().map(|(i, p)| p / masses(i)).collect();
        Self {
            field,
            q: q.flat().try_into().expect("as many coordinates"),
            v: velocities.as_slice().try_into().expect("as many velocities"),
            span: problem.span,
            reference: problem.reference[..D].to_vec(),
        }
    }

    /// Returns the energy error relative to the initial energy.
    pub fn energy_error(&self, q: &[f64; D], v: &[f64; D]) -> f64 {
        let start = self.field.energy(&self.q, &self.v);
        (self.field.energy(q, v) / start - 1.0).abs()
    }

    /// Returns the distance of positions from the final ones, relative to the norm of the latter.
    pub fn global_error(&self, q: &[f64; D]) -> f64 {
        distance(q, &self.reference)
    }
}

/// Returns the distance from the reference, relative to its norm.
pub fn distance(q: &[f64], reference: &[f64]) -> f64 {
    let norm = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>().sqrt();
    norm(&mut q.iter().zip(reference).map(|(q, reference)| q - reference)) / norm(&mut reference.iter().copied())
}

/// A pendulum.
pub struct Pendulum;
/// A star in a galaxy.
pub struct HenonHeiles;
/// A body orbiting a star.
pub struct Kepler;
/// The Sun and five planets; the field contains their masses.
pub struct Solar([f64; 6]);
/// A chain of springs; the field contains the nonlinear coefficient.
pub struct Chain(f64);

impl Field<1> for Pendulum {
    #[inline]
    fn acceleration(&self, q: &[f64; 1]) -> [f64; 1] {
        [-q[0].sin()]
    }
    fn energy(&self, q: &[f64; 1], v: &[f64; 1]) -> f64 {
        0.5 * v[0] * v[0] - q[0].cos()
    }
}

impl Field<2> for HenonHeiles {
    #[inline]
    fn acceleration(&self, &[x, y]: &[f64; 2]) -> [f64; 2] {
        [-x * (1.0 + 2.0 * y), y * y - y - x * x]
    }
    fn energy(&self, &[x, y]: &[f64; 2], &[u, v]: &[f64; 2]) -> f64 {
        0.5 * (u * u + v * v + x * x + y * y) + x * x * y - y * y * y / 3.0
    }
}

impl Field<2> for Kepler {
    #[inline]
    fn acceleration(&self, &[x, y]: &[f64; 2]) -> [f64; 2] {
        let square = x * x + y * y;
        let pull = 1.0 / (square * square.sqrt());
        [-x * pull, -y * pull]
    }
    fn energy(&self, &[x, y]: &[f64; 2], &[u, v]: &[f64; 2]) -> f64 {
        0.5 * (u * u + v * v) - 1.0 / (x * x + y * y).sqrt()
    }
}

impl Solar {
    /// Returns the difference of two positions, and its square.
    #[inline]
    fn apart(q: &[f64; 18], i: usize, j: usize) -> ([f64; 3], f64) {
        let apart = [0, 1, 2].map(|axis| q[3 * i + axis] - q[3 * j + axis]);
        (apart, apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2])
    }
}

impl Field<18> for Solar {
    #[inline]
    fn acceleration(&self, q: &[f64; 18]) -> [f64; 18] {
        let mut acceleration = [0.0; 18];
        for i in 0..6 {
            for j in 0..i {
                let (apart, square) = Self::apart(q, i, j);
                let pull = GRAVITY / (square * square.sqrt());
                for (axis, apart) in apart.into_iter().enumerate() {
                    acceleration[3 * i + axis] -= self.0[j] * pull * apart;
                    acceleration[3 * j + axis] += self.0[i] * pull * apart;
                }
            }
        }
        acceleration
    }
    fn energy(&self, q: &[f64; 18], v: &[f64; 18]) -> f64 {
        let squares = v.chunks(3).map(|v| v.iter().map(|v| v * v).sum::<f64>());
        let kinetic: f64 = squares.zip(self.0).map(|(square, mass)| 0.5 * mass * square).sum();
        let pairs = (0..6).flat_map(|i| (0..i).map(move |j| (i, j)));
        pairs.fold(kinetic, |sum, (i, j)| sum - GRAVITY * self.0[i] * self.0[j] / Self::apart(q, i, j).1.sqrt())
    }
}

impl Field<32> for Chain {
    #[inline]
    fn acceleration(&self, q: &[f64; 32]) -> [f64; 32] {
        let bond = |stretch: f64| stretch + self.0 * stretch * stretch;
        let mut left = bond(q[0]);
        std::array::from_fn(|i| {
            let right = bond(q.get(i + 1).unwrap_or(&0.0) - q[i]);
            let force = right - left;
            left = right;
            force
        })
    }
    fn energy(&self, q: &[f64; 32], v: &[f64; 32]) -> f64 {
        let bond = |stretch: f64| 0.5 * stretch * stretch + self.0 * stretch.powi(3) / 3.0;
        let bonds: f64 = q.windows(2).map(|ends| bond(ends[1] - ends[0])).sum();
        v.iter().map(|v| 0.5 * v * v).sum::<f64>() + bond(q[0]) + bonds + bond(-q[31])
    }
}

/// A pendulum with a large amplitude.
pub fn pendulum(problems: &Problems) -> Case<Pendulum, 1> {
    Case::new(Pendulum, &problems.pendulum(), |_| 1.0)
}
/// A star on a regular orbit.
pub fn henon_heiles(problems: &Problems) -> Case<HenonHeiles, 2> {
    Case::new(HenonHeiles, &problems.henon_heiles(), |_| 1.0)
}
/// A body on an orbit of eccentricity 0.6.
pub fn kepler(problems: &Problems) -> Case<Kepler, 2> {
    Case::new(Kepler, &problems.kepler(), |_| 1.0)
}
/// The outer solar system.
pub fn solar(problems: &Problems) -> Case<Solar, 18> {
    let problem = problems.solar();
    let masses = problem.system.masses;
    Case::new(Solar(masses), &problem, |i| masses[i / 3])
}
/// A chain of 32 sites.
pub fn chain(problems: &Problems) -> Case<Chain, 32> {
    let problem = problems.chain();
    Case::new(Chain(problem.system.alpha), &problem, |_| 1.0)
}
