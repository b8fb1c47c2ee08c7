//! Phase portraits of an ensemble of pendulums, coloured by the kind of motion.

use crate::swarm::{SEPARATRIX, State, energy, wrapped};
use integrator_plot::{Axis, Chart, Panels, colour};
use std::f64::consts::PI;

/// Phase portrait at one time: oscillating and rotating pendulums by their initial energy, and the separatrix.
pub(crate) fn chart(time: f64, starts: &[State], states: &[State]) -> Chart {
    let of_kind = |over: bool| {
        let kind = starts.iter().zip(states).filter(move |(start, _)| (energy(start) > SEPARATRIX) == over);
        kind.map(|(_, state)| (wrapped(state.q[0]), state.p[0]))
    };
    let branch = |side: f64| {
        (-100..=100).map(move |i| PI * f64::from(i) / 100.0).map(move |q| (q, side * 2.0 * (q / 2.0).cos()))
    };
    Chart::new(format!("t = {time}"))
        .along(Axis::linear("angle in rad").between(-PI, PI))
        .up(Axis::linear("momentum").between(-2.6, 2.6))
        .line("", branch(1.0))
        .coloured(colour::GREY)
        .line("", branch(-1.0))
        .coloured(colour::GREY)
        .cloud("", of_kind(false))
        .coloured(colour::COLOURS[6])
        .cloud("", of_kind(true))
        .coloured(colour::COLOURS[3])
}

pub(crate) fn picture(charts: Vec<Chart>, measured: &str) -> Panels {
    let panels = Panels::new(
        "An ensemble of a million pendulums",
        "Blue pendulums oscillate, orange ones rotate; the grey curve is the separatrix",
    );
    charts.into_iter().fold(panels.measured(measured).panel(460, 420), Panels::chart)
}
