//! Orbits forward and back.

use crate::{
    numbers::plain,
    problem::steps_per_period,
    reversal::{PERIODS, Reversal},
    study::Study,
};
use integrator_plot::{Axis, Chart, Marker, Panels, colour::GREY};

/// Two that do not come back, one of which is symplectic, and two that do.
const SHOWN: [&str; 4] = ["Runge–Kutta 4", "symplectic Euler", "Verlet", "implicit midpoint"];

/// One panel for each of these methods.
pub(super) fn reversal(study: &Study) -> Panels {
    let claim = format!(
        "{PERIODS} periods forward, in colour. Then the momenta are reversed, and as many steps lead back, in grey, drawn with the \
         original sign of the momenta. A reversible method returns to the start, the square. Symplecticity is neither sufficient nor \
         necessary for this."
    );
    let panels = Panels::new(format!("Reversibility: {}", study.system), claim).columns(4).panel(320, 360);
    SHOWN.iter().filter_map(|name| study.method(name)).fold(panels, |panels, measured| {
        let Reversal { count, there, back, apart } = &measured.reversal;
        let claim =
            apart.map_or("the run fails".to_owned(), |apart| format!("distance from the start: {}", plain(apart)));
        let begin = there.first().copied();
        let chart = Chart::new(measured.name())
            .claim(format!("{} steps per period", plain(f64::from(study.cycles) * steps_per_period(*count))))
            .measured(claim)
            .along(Axis::linear(&study.view[0]))
            .up(Axis::linear(&study.view[1]))
            .with_equal_units()
            .line("", there.iter().copied())
            .coloured(measured.row.colour)
            .wide(2.5)
            .line("", back.iter().copied())
            .coloured(GREY)
            .wide(1.25)
            .dots("", begin)
            .coloured(measured.row.colour)
            .marked(Marker::Square)
            .wide(4.0)
            .dots("", back.last().copied())
            .coloured(GREY)
            .wide(2.5);
        panels.chart(chart)
    })
}
