//! The Poincaré section of Hénon and Heiles.

use super::Drawing;
use crate::{notes::Notes, section::Section};
use integrator_plot::{Axis, Chart, Panels};

/// One panel per energy.
pub(super) fn section(notes: &Notes) -> Drawing {
    let claim = "Where orbits pass x = 0 to the right. At the lower energy they stay on curves; at the higher one a \
                 single orbit fills a region.";
    let off = notes.sections.iter().map(|section| section.off).fold(0.0, f64::max);
    let panels = Panels::new("Poincaré section of Hénon and Heiles", claim)
        .measured(format!("largest |x| of a crossing {off:.1e}"))
        .columns(2)
        .panel(600, 600);
    Drawing::Panels(notes.sections.iter().fold(panels, |panels, section| panels.chart(panel(section))))
}

fn panel(section: &Section) -> Chart {
    let count: usize = section.orbits.iter().map(Vec::len).sum();
    let chart = Chart::new(format!("E = {:.4}", section.energy))
        .claim(format!("{count} crossings, energy error {:.1e}", section.energy_change))
        .along(Axis::linear("y"))
        .up(Axis::linear("py"));
    section.orbits.iter().fold(chart, |chart, orbit| chart.cloud("", orbit.iter().copied()))
}
