//! Pictures of the liquid: radial distribution, mean square displacement, energy and temperature.

use integrator_plot::{Axis, Chart, Panels, colour};

/// One sample of the liquid after equilibration.
pub(crate) struct Measurement {
    pub(crate) time: f64,
    /// Mean square displacement in Å².
    pub(crate) square: f64,
    /// Energy change per atom since the first sample, in K.
    pub(crate) change: f64,
    pub(crate) temperature: f64,
}

/// Four charts: `g(r)` with its first peak `(place, height)`, displacements with the diffusion coefficient, and the samples.
pub(crate) fn picture(
    distribution: &[(f64, f64)],
    (place, height): (f64, f64),
    diffusion: f64,
    measurements: &[Measurement],
) -> Panels {
    let chart = |title: &str, up: &str| Chart::new(title).along(Axis::linear("time in ps")).up(Axis::linear(up));
    let points = |value: fn(&Measurement) -> f64| {
        measurements.iter().map(move |measurement| (measurement.time, value(measurement)))
    };
    let course = |title: &str, up: &str, value: fn(&Measurement) -> f64| chart(title, up).line("", points(value));
    let pairs = Chart::new("Radial distribution function")
        .along(Axis::linear("distance r in Å"))
        .up(Axis::linear("g(r)"))
        .line("", distribution.iter().copied());
    let last = measurements.last().map_or((0.0, 0.0), |measurement| (measurement.time, measurement.square));
    let line = [0.0, last.0].map(|time| (time, last.1 + 6.0 * diffusion * (time - last.0)));
    let far = chart("Mean square displacement and 6 D t (dashed)", "displacement² in Å²")
        .line("6 D t", line)
        .dashed()
        .coloured(colour::GREY);
    Panels::new(
        "Liquid argon",
        "The peaks of g(r) are shells of neighbours; the displacement grows linearly with time, by diffusion",
    )
    .measured(format!("first peak {height:.2} at {place:.2} Å, diffusion {:.2}·10⁻⁵ cm²/s", diffusion * 10.0))
    .columns(2)
    .panel(520, 400)
    .chart(pairs)
    .chart(far.dots("atoms", points(|measurement| measurement.square)).coloured(colour::INK))
    .chart(course("Energy", "energy change per atom in K", |measurement| measurement.change))
    .chart(course("Temperature", "temperature in K", |measurement| measurement.temperature))
}
