//! How atoms are arranged and how far they go, and the course of energy and temperature.

use integrator_plot::{Axis, Chart, Panels, colour};

/// The liquid that was left alone, at one time.
pub(crate) struct Look {
    pub(crate) time: f64,
    /// The mean of the square of how far atoms have gone.
    pub(crate) square: f64,
    /// By how much the energy of an atom differs from that at the beginning, as a temperature.
    pub(crate) change: f64,
    pub(crate) temperature: f64,
}

/// `g(r)`, its first peak as `(place, height)`, the coefficient of diffusion, and the looks.
pub(crate) fn picture(
    distribution: &[(f64, f64)],
    (place, height): (f64, f64),
    diffusion: f64,
    looks: &[Look],
) -> Panels {
    let chart = |title: &str, up: &str| Chart::new(title).along(Axis::linear("time in ps")).up(Axis::linear(up));
    let points = |value: fn(&Look) -> f64| looks.iter().map(move |look| (look.time, value(look)));
    let course = |title: &str, up: &str, value: fn(&Look) -> f64| chart(title, up).line("", points(value));
    let pairs = Chart::new("Radial distribution function")
        .along(Axis::linear("distance in Å"))
        .up(Axis::linear("g"))
        .line("", distribution.iter().copied());
    let last = looks.last().map_or((0.0, 0.0), |look| (look.time, look.square));
    let line = [0.0, last.0].map(|time| (time, last.1 + 6.0 * diffusion * (time - last.0)));
    let far = chart("Mean square displacement and 6 D t", "Å²").line("6 D t", line).dashed().coloured(colour::GREY);
    Panels::new(
        "Liquid argon",
        "Shells of neighbours without gaps between them, and atoms that do not stay where they are",
    )
    .measured(format!("first peak {height:.2} at {place:.2} Å, diffusion {:.2}·10⁻⁵ cm²/s", diffusion * 10.0))
    .columns(2)
    .panel(520, 400)
    .chart(pairs)
    .chart(far.dots("atoms", points(|look| look.square)).coloured(colour::INK))
    .chart(course("Energy", "change for each atom in K", |look| look.change))
    .chart(course("Temperature", "K", |look| look.temperature))
}
