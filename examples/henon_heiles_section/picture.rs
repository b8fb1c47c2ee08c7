//! Picture of the sections, with regular and chaotic orbits in two colours.

use crate::section::{Orbit, border};
use integrator_plot::{Axis, Chart, Panels, colour};

/// The orbits of one energy.
pub(crate) struct Section {
    /// Name of the energy.
    pub(crate) name: &'static str,
    pub(crate) energy: f64,
    pub(crate) orbits: Vec<Orbit>,
}

impl Section {
    /// Returns the regular share of the orbits.
    pub(crate) fn regular(&self) -> f64 {
        self.orbits.iter().filter(|orbit| orbit.regular).count() as f64 / self.orbits.len() as f64
    }

    fn chart(&self) -> Chart {
        let points = |regular: bool| {
            let orbits = self.orbits.iter().filter(move |orbit| orbit.regular == regular);
            orbits.flat_map(|orbit| orbit.points.iter().copied())
        };
        Chart::new(format!("Energy {}", self.name))
            .measured(format!("{:.0} % of the section is regular", 100.0 * self.regular()))
            .along(Axis::linear("y"))
            .up(Axis::linear("p_y"))
            .line("", border(self.energy))
            .coloured(colour::GREY)
            .cloud("", points(false))
            .coloured(colour::COLOURS[3])
            .cloud("", points(true))
            .coloured(colour::COLOURS[6])
    }
}

pub(crate) fn picture(sections: &[Section]) -> Panels {
    let panels = Panels::new(
        "Poincaré sections of the Hénon–Heiles system",
        "Blue: regular orbits, on curves. Orange: chaotic orbits, which fill areas.",
    );
    sections.iter().fold(panels.panel(520, 520), |panels, section| panels.chart(section.chart()))
}
