//! How each method is drawn in all charts: symplectic ones by whole lines, the others dashed.

use crate::{measured::Measured, study::Study};
use integrator_plot::{
    Chart, Colour,
    colour::{COLOURS, GREY},
};

/// The colour and the line of a method.
#[derive(Clone, Copy)]
pub(super) struct Style {
    colour: Colour,
    dashed: bool,
}

impl Style {
    /// Draws the last series of a chart this way.
    pub(super) fn apply(self, chart: Chart) -> Chart {
        let chart = chart.coloured(self.colour);
        if self.dashed { chart.dashed() } else { chart }
    }
}

/// The styles of methods beyond those of a study: further ones that are not symplectic.
pub(super) fn others(study: &Study) -> impl Iterator<Item = Style> {
    let taken = study.methods.iter().filter(|measured| !measured.keeps_bracket()).count();
    (taken..).map(|place| Style { colour: COLOURS.get(place).copied().unwrap_or(GREY), dashed: true })
}

/// All methods with their styles. Colours are dealt out among the symplectic ones, and once more among the others.
pub(super) fn styled(study: &Study) -> impl Iterator<Item = (&Measured, Style)> {
    let mut places = [0; 2];
    study.methods.iter().map(move |measured| {
        let dashed = !measured.keeps_bracket();
        let place = &mut places[usize::from(dashed)];
        let colour = COLOURS[*place % COLOURS.len()];
        *place += 1;
        (measured, Style { colour, dashed })
    })
}
