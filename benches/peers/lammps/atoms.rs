//! Atoms at the sites of a lattice, as starts of this library and as data files of LAMMPS.

use integrator_core::prelude::Phase;
use std::fmt::Write;

/// Positions and velocities in a periodic box, and what bonds and angles connect.
#[derive(Default)]
pub(crate) struct Start {
    pub(crate) sides: [f64; 3],
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) velocities: Vec<[f64; 3]>,
    /// The kind of each atom, from zero, and the mass and the charge of each kind.
    pub(crate) kinds: Vec<usize>,
    pub(crate) masses: Vec<f64>,
    pub(crate) charges: Vec<f64>,
    /// The number of atoms of a molecule, if they are some.
    pub(crate) molecule: usize,
    pub(crate) bonds: Vec<[usize; 2]>,
    pub(crate) angles: Vec<[usize; 3]>,
}

/// The sites of a cubic lattice with some sites in each cell, and the side of the box.
pub(crate) fn lattice(cells: usize, side: f64, in_cell: &[[f64; 3]]) -> (Vec<[f64; 3]>, f64) {
    let cell = |n: usize| [n % cells, n / cells % cells, n / cells / cells].map(|at| at as f64);
    let site = |n: usize| {
        let (cell, place) = (cell(n / in_cell.len()), in_cell[n % in_cell.len()]);
        [0, 1, 2].map(|d| (cell[d] + place[d]) * side)
    };
    ((0..cells.pow(3) * in_cell.len()).map(site).collect(), cells as f64 * side)
}

/// The sites of a face-centred cubic cell.
pub(crate) const FACE_CENTRED: [[f64; 3]; 4] = [[0.0; 3], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]];

/// Velocities of a speed in scattered directions, without a mean.
pub(crate) fn velocities(count: usize, speed: f64) -> Vec<[f64; 3]> {
    let scattered = |i: usize, d: usize| ((i * 37 + d * 11) as f64 * 12.9898).sin() * 43758.5453;
    let mut velocities: Vec<[f64; 3]> =
        (0..count).map(|i| [0, 1, 2].map(|d| 2.0 * speed * (scattered(i, d).rem_euclid(1.0) - 0.5))).collect();
    let mean = [0, 1, 2].map(|d| velocities.iter().map(|v| v[d]).sum::<f64>() / count as f64);
    velocities.iter_mut().for_each(|v| (0..3).for_each(|d| v[d] -= mean[d]));
    velocities
}

impl Start {
    /// The state, with momenta in units in which a mass is multiplied by a factor.
    pub(crate) fn phase(&self, factor: f64) -> Phase<Vec<[f64; 3]>> {
        let momentum = |(v, kind): (&[f64; 3], &usize)| v.map(|v| factor * self.masses[*kind] * v);
        Phase::new(self.positions.clone(), self.velocities.iter().zip(&self.kinds).map(momentum).collect())
    }

    /// The data file of LAMMPS.
    pub(crate) fn data(&self) -> String {
        let Self { sides, positions, velocities, kinds, masses, charges, molecule, bonds, angles } = self;
        let mut text = format!("a lattice\n\n{} atoms\n{} atom types\n", positions.len(), masses.len());
        for (count, name) in [(bonds.len(), "bond"), (angles.len(), "angle")] {
            if count > 0 {
                write!(text, "{count} {name}s\n1 {name} types\n").ok();
            }
        }
        for (side, axis) in sides.iter().zip(["x", "y", "z"]) {
            writeln!(text, "0 {side:.17e} {axis}lo {axis}hi").ok();
        }
        section(&mut text, "Masses", masses);
        let atom = |(i, (kind, [x, y, z])): (usize, (&usize, &[f64; 3]))| {
            let molecule = i.checked_div(*molecule).map(|molecule| format!("{} ", molecule + 1)).unwrap_or_default();
            let charge = charges.get(*kind).map(|charge| format!("{charge} ")).unwrap_or_default();
            format!("{molecule}{} {charge}{x:.17e} {y:.17e} {z:.17e}", kind + 1)
        };
        section(&mut text, "Atoms", kinds.iter().zip(positions).enumerate().map(atom));
        section(&mut text, "Velocities", velocities.iter().map(|[x, y, z]| format!("{x:.17e} {y:.17e} {z:.17e}")));
        if !bonds.is_empty() {
            section(&mut text, "Bonds", bonds.iter().map(|[a, b]| format!("1 {} {}", a + 1, b + 1)));
        }
        if !angles.is_empty() {
            section(&mut text, "Angles", angles.iter().map(|[a, b, c]| format!("1 {} {} {}", a + 1, b + 1, c + 1)));
        }
        text
    }
}

/// A section of a data file, whose lines are numbered.
fn section(text: &mut String, name: &str, lines: impl IntoIterator<Item: std::fmt::Display>) {
    write!(text, "\n{name}\n\n").ok();
    for (number, line) in (1..).zip(lines) {
        writeln!(text, "{number} {line}").ok();
    }
}
