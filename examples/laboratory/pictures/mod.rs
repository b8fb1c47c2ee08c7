//! The pictures of the page, one row each.

mod areas;
mod brackets;
mod energies;
mod errors;
mod periods;
mod portraits;
mod section;
mod style;

use crate::{notes::Notes, study::Study};
use integrator_plot::{Chart, Outcome, Panels, write};
use std::path::Path;

/// A picture of either kind.
pub(crate) enum Drawing {
    Chart(Chart),
    Panels(Panels),
}

/// A picture with the name of its files; none where there is nothing to show.
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) draw: fn(&Study, &Notes) -> Option<Drawing>,
}

/// One row for each picture, in the order of the page.
pub(crate) const PICTURES: [Picture; 9] = [
    Picture { name: "portraits", draw: |study, _| Some(portraits::portraits(study)) },
    Picture { name: "energy", draw: |study, _| study.autonomous.then(|| energies::low_orders(study)) },
    Picture { name: "energy_error", draw: |study, _| study.autonomous.then(|| energies::all(study)) },
    Picture { name: "errors", draw: |study, _| Some(errors::against_step(study)) },
    Picture { name: "work_precision", draw: |study, _| Some(errors::against_work(study)) },
    Picture { name: "areas", draw: |study, _| Some(areas::areas(study)) },
    Picture { name: "brackets", draw: |study, _| Some(brackets::brackets(study)) },
    Picture { name: "period", draw: |_, notes| Some(periods::periods(notes)) },
    Picture { name: "section", draw: |_, notes| Some(section::section(notes)) },
];

impl Drawing {
    /// Writes the picture as SVG and as PNG.
    pub(crate) fn write(&self, file: &Path) -> Outcome {
        match self {
            Self::Chart(chart) => write(file, chart),
            Self::Panels(panels) => write(file, panels),
        }
    }
}
