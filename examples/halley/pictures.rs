//! Pictures of the orbit of the comet and of its elements over time.

use crate::comet::{BEGIN, Bodies, COMET, REVOLUTION, Solar, osculating, run};
use integrator_core::{orbit::OrbitError, prelude::*};
use integrator_plot::{Axis, Chart, write};
use std::{error::Error, path::Path};

/// Length of a year in days.
const YEAR: f64 = 365.25;

/// Returns the year of a Julian day.
fn year(day: f64) -> f64 {
    2000.0 + (day - 2_451_545.0) / YEAR
}

/// Draws one revolution relative to the Sun, at equal intervals of time.
pub(crate) fn orbit(system: &Solar, start: Phase<Bodies>, folder: &Path) -> Result<(), Box<dyn Error>> {
    let samples = run(system, start, 1.0)?.samples_at(REVOLUTION / 760.0).take(761);
    let path: Vec<Bodies> = samples.map(|sample| sample.map(|sample| sample.state.q)).collect::<Result<_, _>>()?;
    let of = |body: usize| path.iter().map(move |q| (q[body][0] - q[0][0], q[body][1] - q[0][1]));
    let chart = Chart::new("Halley's comet")
        .claim("One dot every 0.1 years: decades at the aphelion, months at the perihelion")
        .along(Axis::linear("x in AU"))
        .up(Axis::linear("y in AU"))
        .with_equal_units()
        .sized(1000, 800)
        .dots("Halley", of(COMET))
        .line("Jupiter", of(1).take(119))
        .line("Saturn", of(2).take(296))
        .line("Uranus", of(3))
        .dots("Sun", [(0.0, 0.0)]);
    write(&folder.join("halley_orbit"), &chart)
}

/// Draws the semi-major axis over several revolutions, back in time.
pub(crate) fn elements(system: &Solar, start: Phase<Bodies>, folder: &Path) -> Result<(), Box<dyn Error>> {
    let samples = run(system, start, -1.0)?.samples_at(-YEAR).take(12 * 76);
    let states: Vec<_> = samples.collect::<Result<_, _>>()?;
    let axis = states.iter().map(|sample| Ok((year(sample.time), osculating(system, &sample.state)?.axis())));
    let axis: Vec<(f64, f64)> = axis.collect::<Result<_, OrbitError>>()?;
    let chart = Chart::new("The semi-major axis of Halley's comet")
        .claim(format!("Backwards from {:.0}: Jupiter changes it at each perihelion passage", year(BEGIN)))
        .along(Axis::linear("year"))
        .up(Axis::linear("semi-major axis in AU"))
        .sized(1000, 500)
        .line("around the Sun", axis);
    write(&folder.join("halley_elements"), &chart)
}
