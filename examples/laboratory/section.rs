//! The Poincaré section of Hénon and Heiles, at two energies.

use crate::systems::HenonHeiles;
use integrator_core::prelude::*;
use std::error::Error;

/// An energy, with the points at which orbits pass x = 0 to the right.
pub(crate) struct Section {
    pub(crate) energy: f64,
    /// For each orbit `(y, py)`.
    pub(crate) orbits: Vec<Vec<(f64, f64)>>,
    /// The largest distance of a point from x = 0.
    pub(crate) off: f64,
    /// The largest relative change of the energy.
    pub(crate) energy_change: f64,
}

/// Energies: at the first all orbits lie on curves, at the second most of them do not.
pub(crate) const ENERGIES: [f64; 2] = [1.0 / 12.0, 1.0 / 8.0];

/// Starts on the axis `py = 0` and on `y = 0`.
const STARTS: [(f64, f64); 12] = [
    (-0.25, 0.0),
    (-0.15, 0.0),
    (-0.05, 0.0),
    (0.05, 0.0),
    (0.15, 0.0),
    (0.25, 0.0),
    (0.35, 0.0),
    (0.42, 0.0),
    (0.0, 0.1),
    (0.0, 0.2),
    (0.0, 0.3),
    (0.0, 0.38),
];

/// Follows each orbit through so many crossings.
pub(crate) fn section(energy: f64, crossings: usize) -> Result<Section, Box<dyn Error>> {
    let mut section = Section { energy, orbits: Vec::new(), off: 0.0, energy_change: 0.0 };
    for (y, py) in STARTS {
        let px_squared = 2.0 * (energy - HenonHeiles.potential([0.0, y])) - py * py;
        if px_squared <= 0.0 {
            continue;
        }
        let start = Phase::new([0.0, y], [px_squared.sqrt(), py]);
        let run = HenonHeiles.run_with(BlanesMoanSrkn6, start, 0.1)?;
        let mut orbit = Vec::with_capacity(crossings);
        for sample in run.crossings(u64::MAX, Direction::Rising, |state, _| state.q[0]).take(crossings) {
            let sample = sample?;
            orbit.push((sample.state.q[1], sample.state.p[1]));
            section.off = section.off.max(sample.state.q[0].abs());
            section.energy_change = section.energy_change.max(((sample.energy() - energy) / energy).abs());
        }
        section.orbits.push(orbit);
    }
    Ok(section)
}
