//! The Poincaré section of Hénon and Heiles, at two energies.

use crate::systems::HenonHeiles;
use integrator_core::prelude::*;
use integrator_laboratory::{Verdict, plain};
use integrator_plot::{Axis, Chart, Panels};
use std::error::Error;

/// Crossings of x = 0 with growing x, at one energy.
pub(crate) struct Section {
    pub(crate) energy: f64,
    /// Crossings `(y, p_y)` of each orbit.
    pub(crate) orbits: Vec<Vec<(f64, f64)>>,
    /// Largest distance of a crossing from x = 0.
    pub(crate) off: f64,
    /// Largest relative energy change.
    pub(crate) energy_change: f64,
}

/// Energies: all orbits lie on curves at the first, and most orbits are chaotic at the second.
pub(crate) const ENERGIES: [f64; 2] = [1.0 / 12.0, 1.0 / 8.0];

/// Returns initial states on the axes `p_y = 0` and `y = 0`.
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

/// Integrates each orbit through `count` crossings.
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

/// Returns the sections at both energies.
pub(crate) fn all(crossings: usize) -> Result<Vec<Section>, Box<dyn Error>> {
    ENERGIES.iter().map(|energy| section(*energy, crossings)).collect()
}

/// Returns the claim about the sections.
pub(crate) fn claim(sections: &[Section]) -> Verdict {
    let says = "Crossings lie on the section: the largest |x| of one";
    // A few rounding errors of the time and the position of a crossing.
    Verdict::new(
        "crossings_lie_on_the_section",
        says,
        [0.0, 1e-13],
        sections.iter().map(|section| section.off).reduce(f64::max),
    )
    .shown_in("section")
}

/// Draws one panel per energy.
pub(crate) fn picture(sections: &[Section]) -> Panels {
    let claim = "Crossings of x = 0 with growing x. At the lower energy orbits lie on curves; at the higher energy a \
                 single orbit fills a region.";
    let panels = Panels::new("Poincaré section of the Hénon–Heiles system", claim).columns(2).panel(620, 620);
    sections.iter().fold(panels, |panels, section| panels.chart(panel(section)))
}

fn panel(section: &Section) -> Chart {
    let count: usize = section.orbits.iter().map(Vec::len).sum();
    let chart = Chart::new(format!("E = {:.4}", section.energy))
        .claim(format!("{count} crossings, energy error {}", plain(section.energy_change)))
        .along(Axis::linear("y"))
        .up(Axis::linear("p_y"));
    section.orbits.iter().fold(chart, |chart, orbit| chart.cloud("", orbit.iter().copied()))
}
