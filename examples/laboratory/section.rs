//! The Poincaré section of Hénon and Heiles, at two energies.

use crate::systems::HenonHeiles;
use integrator_core::prelude::*;
use integrator_laboratory::{Verdict, plain};
use integrator_plot::{Axis, Chart, Panels};
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

/// At both energies.
pub(crate) fn all(crossings: usize) -> Result<Vec<Section>, Box<dyn Error>> {
    ENERGIES.iter().map(|energy| section(*energy, crossings)).collect()
}

/// What is claimed of the sections.
pub(crate) fn claim(sections: &[Section]) -> Verdict {
    let says = "Crossings lie on the section: the largest |x| of one";
    // Time and position of a crossing are rounded a few times.
    Verdict::new(
        "crossings_lie_on_the_section",
        says,
        [0.0, 1e-13],
        sections.iter().map(|section| section.off).reduce(f64::max),
    )
}

/// One panel per energy.
pub(crate) fn picture(sections: &[Section]) -> Panels {
    let claim = "Where orbits pass x = 0 to the right. At the lower energy they stay on curves; at the higher one a \
                 single orbit fills a region.";
    let panels = Panels::new("Poincaré section of Hénon and Heiles", claim).columns(2).panel(620, 620);
    sections.iter().fold(panels, |panels, section| panels.chart(panel(section)))
}

fn panel(section: &Section) -> Chart {
    let count: usize = section.orbits.iter().map(Vec::len).sum();
    let chart = Chart::new(format!("E = {:.4}", section.energy))
        .claim(format!("{count} crossings, energy error {}", plain(section.energy_change)))
        .along(Axis::linear("y"))
        .up(Axis::linear("py"));
    section.orbits.iter().fold(chart, |chart, orbit| chart.cloud("", orbit.iter().copied()))
}
