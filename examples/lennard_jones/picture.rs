//! The radial distribution function, and the course of the energy.

use integrator_plot::{Axis, Chart, Panels};

/// The liquid that was left alone, at one time.
pub(crate) struct Look {
    pub(crate) time: f64,
    /// By how much the energy per atom differs from that at the beginning.
    pub(crate) change: f64,
    pub(crate) temperature: f64,
}

/// `g(r)`, its first peak as `(place, height)`, and the looks.
pub(crate) fn picture(distribution: &[(f64, f64)], (place, height): (f64, f64), looks: &[Look]) -> Panels {
    let course = |title: &str, up: &str, value: fn(&Look) -> f64| {
        let chart = Chart::new(title).along(Axis::linear("time")).up(Axis::linear(up));
        chart.line("", looks.iter().map(move |look| (look.time, value(look))))
    };
    let pairs = Chart::new("Radial distribution function")
        .along(Axis::linear("distance in diameters"))
        .up(Axis::linear("g"))
        .line("", distribution.iter().copied());
    Panels::new("Liquid argon", "A crystal that has melted: shells of neighbours without gaps")
        .measured(format!("first peak {height:.2} at {place:.3} diameters"))
        .panel(520, 460)
        .chart(pairs)
        .chart(course("Energy", "change of the energy per atom", |look| look.change))
        .chart(course("Temperature", "temperature", |look| look.temperature))
}
