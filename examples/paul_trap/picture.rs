//! Picture of the stability region of a trap, and of two orbits.

use crate::trap::{PaulTrap, holds};
use integrator_plot::{Axis, Chart, Panels, colour};

/// Orbit of an ion in a trap: `x` against the time in periods of the voltage.
pub(crate) struct Orbit {
    pub(crate) name: &'static str,
    pub(crate) trap: PaulTrap,
    pub(crate) points: Vec<(f64, f64)>,
}

/// Draws the stability region from the traces of both directions, and two orbits. `edge` is where the region ends on the
/// axis `a = 0`.
pub(crate) fn picture(traps: &[(PaulTrap, [f64; 2])], orbits: &[Orbit; 2], edge: f64) -> Panels {
    let place = |trap: &PaulTrap| (trap.q, trap.a);
    let those = |chosen: fn([f64; 2]) -> bool| {
        traps.iter().filter(move |(_, traces)| chosen(*traces)).map(move |(trap, _)| place(trap))
    };
    let mut region = Chart::new("Stability of traps")
        .claim("Dark blue: stable in both directions. Light blue: in one. Dots: the two traps on the right")
        .along(Axis::linear("q (alternating voltage)"))
        .up(Axis::linear("a (constant voltage)"))
        .cloud("", those(|traces| !holds(traces) && traces.iter().any(|trace| trace.abs() < 2.0)))
        .coloured(colour::COLOURS[1])
        .cloud("", those(holds))
        .coloured(colour::COLOURS[6]);
    let colours = [colour::COLOURS[2], colour::COLOURS[3]];
    for (orbit, colour) in orbits.iter().zip(colours) {
        region = region.dots("", [place(&orbit.trap)]).coloured(colour);
    }
    let panels = Panels::new("Paul trap", "An alternating voltage confines ions where Mathieu's equation is stable")
        .measured(format!("stable for a = 0 up to q = {edge:.8}"))
        .panel(520, 480)
        .chart(region);
    orbits.iter().zip(colours).fold(panels, |panels, (orbit, colour)| {
        let PaulTrap { a, q } = orbit.trap;
        let chart = Chart::new(format!("{}: a = {a}, q = {q}", orbit.name))
            .along(Axis::linear("time in periods of the voltage"))
            .up(Axis::linear("x"))
            .line("", orbit.points.iter().copied())
            .coloured(colour);
        panels.chart(chart)
    })
}
