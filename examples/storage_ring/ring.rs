//! A storage ring of FODO cells with a sextupole in each: the elements are the parts of H, and a cell is their composition.
//!
//! Each part is the energy of an element times its length, so that its flow for a duration of one is the map of the
//! element, and a step of `Euler` with h = 1 is the map of a cell: the elements one after the other. No element is
//! approximated.

use integrator_core::prelude::*;

/// A FODO cell. Lengths are in metres, momenta in units of the reference momentum.
pub(crate) struct Cell {
    /// Length of each quadrupole.
    pub(crate) quadrupole: f64,
    /// Gradient of the quadrupoles divided by the rigidity, 1/m².
    pub(crate) gradient: f64,
    /// Length of each drift.
    pub(crate) drift: f64,
    /// Integrated strength of the sextupole, 1/m².
    pub(crate) sextupole: f64,
}

#[hamiltonian(split = focusing + first_drift + defocusing + second_drift + sextupole, compose = Euler)]
impl Cell {
    fn focusing(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * self.quadrupole * (px * px + py * py + self.gradient * (x * x - y * y))
    }
    fn first_drift(&self, p: [f64; 2]) -> f64 {
        0.5 * self.drift * (p[0] * p[0] + p[1] * p[1])
    }
    fn defocusing(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * self.quadrupole * (px * px + py * py - self.gradient * (x * x - y * y))
    }
    fn second_drift(&self, p: [f64; 2]) -> f64 {
        0.5 * self.drift * (p[0] * p[0] + p[1] * p[1])
    }
    fn sextupole(&self, q: [f64; 2]) -> f64 {
        self.sextupole / 6.0 * (q[0].powi(3) - 3.0 * q[0] * q[1] * q[1])
    }
}

impl Cell {
    /// Returns the phase advance of a cell in x and y for small amplitudes, by the matrices of its elements.
    pub(crate) fn phase_advances(&self) -> [f64; 2] {
        let (k, l) = (self.gradient.sqrt(), self.quadrupole);
        let (sine, cosine) = (k * l).sin_cos();
        let focusing = [[cosine, sine / k], [-k * sine, cosine]];
        let defocusing = [[(k * l).cosh(), (k * l).sinh() / k], [k * (k * l).sinh(), (k * l).cosh()]];
        let drift = [[1.0, self.drift], [0.0, 1.0]];
        let advance = |first, second| {
            let cell = [drift, second, drift].into_iter().fold(first, |map, element| product(element, map));
            (0.5 * (cell[0][0] + cell[1][1])).acos()
        };
        [advance(focusing, defocusing), advance(defocusing, focusing)]
    }

    /// Returns the number of cells after which a particle leaves a pipe of this radius, at most `limit`.
    ///
    /// # Errors
    /// The initial state is not finite.
    pub(crate) fn survives(&self, start: Phase<[f64; 2]>, cells: u64, pipe: f64) -> Result<u64, Error> {
        let mut run = self.run(start, 1.0)?;
        for cell in 0..cells {
            let stays = run.advance(1).is_ok() && run.state().q.iter().all(|x| x.abs() < pipe);
            if !stays {
                return Ok(cell);
            }
        }
        Ok(cells)
    }
}

/// Returns the phase advance of a small oscillation, from the trace of the map of a cell by two initial states.
///
/// # Errors
/// The state becomes infinite or NaN.
pub(crate) fn tracked_advance(cell: &Cell, axis: usize) -> Result<f64, Error> {
    let size = 1e-9;
    let image = |position: f64, momentum: f64| {
        let (mut q, mut p) = ([0.0; 2], [0.0; 2]);
        (q[axis], p[axis]) = (position, momentum);
        let mut run = cell.run(Phase::new(q, p), 1.0)?;
        run.advance(1)?;
        Ok::<_, Error>([run.state().q[axis], run.state().p[axis]])
    };
    let trace = (image(size, 0.0)?[0] + image(0.0, size)?[1]) / size;
    Ok((0.5 * trace).acos())
}

fn product(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}
