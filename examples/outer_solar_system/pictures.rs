//! Pictures of the orbits of the planets and of energy errors.

use crate::system::{Bodies, OuterSolarSystem};
use integrator_core::prelude::*;
use integrator_plot::{Axis, Chart, write};
use std::{error::Error, path::Path};

/// Planets and their periods in days.
const PLANETS: [(&str, f64); 5] =
    [("Jupiter", 4_333.0), ("Saturn", 10_759.0), ("Uranus", 30_689.0), ("Neptune", 60_182.0), ("Pluto", 90_560.0)];

/// Length of a year in days.
const YEAR: f64 = 365.25;

/// Draws the orbits of the planets relative to the Sun, in the equatorial plane of the table.
pub(crate) fn orbits(system: &OuterSolarSystem, start: Phase<Bodies>, folder: &Path) -> Result<(), Box<dyn Error>> {
    let step = 40.0;
    let samples =
        system.run_with(BlanesMoanSrkn11, start, step)?.samples(1).take((1.02 * PLANETS[4].1 / step) as usize);
    let path: Vec<Bodies> = samples.map(|sample| sample.map(|sample| sample.state.q)).collect::<Result<_, _>>()?;
    let chart = Chart::new("The outer solar system")
        .claim("One revolution of each planet; Pluto is closer to the Sun than Neptune for part of its orbit")
        .along(Axis::linear("x in AU"))
        .up(Axis::linear("y in AU"))
        .with_equal_units()
        .sized(1000, 900);
    let chart = PLANETS.iter().zip(1..).fold(chart, |chart, ((name, days), planet)| {
        // About a hundred points per orbit, or all of them if there are fewer.
        let samples = (days / step) as usize + 1;
        let stride = (samples / 100).max(1);
        let points = path.iter().take(samples + stride).step_by(stride);
        chart.line(*name, points.map(|q| (q[planet][0] - q[0][0], q[planet][1] - q[0][1])))
    });
    write(&folder.join("outer_solar_system_orbits"), &chart.dots("Sun", [(0.0, 0.0)]))
}

/// Days per force evaluation, and the time span in days.
const DAYS_PER_FORCE: f64 = 5.0;
const SPAN: f64 = 1000.0 * YEAR;

/// Returns the largest energy error in each decade.
fn errors<X: Composition<OuterSolarSystem>>(
    system: &OuterSolarSystem,
    composition: X,
    start: Phase<Bodies>,
) -> Result<Vec<(f64, f64)>, integrator_core::Error> {
    let h = DAYS_PER_FORCE * X::FORCE_EVALUATIONS as f64;
    let run = system.run_with(composition, start, h)?;
    let energy = run.energy();
    let mut decades: Vec<(f64, f64)> = Vec::new();
    for sample in run.samples(1).skip(1).take((SPAN / h) as usize) {
        let sample = sample?;
        let decade = (sample.time / (10.0 * YEAR)).floor();
        let error = ((sample.energy() - energy) / energy).abs();
        match decades.last_mut() {
            Some((year, worst)) if *year == 10.0 * decade => *worst = worst.max(error),
            _ => decades.push((10.0 * decade, error)),
        }
    }
    Ok(decades)
}

/// Name and curve of a composition.
type Curve = (String, Vec<(f64, f64)>);

/// Draws the energy errors of compositions of several orders at equal numbers of forces.
pub(crate) fn energies(
    system: &OuterSolarSystem,
    start: Phase<Bodies>,
    folder: &Path,
) -> Result<Vec<Curve>, Box<dyn Error>> {
    let mut curves = Vec::new();
    macro_rules! follow {
        ($($composition:ident)*) => {$(
            let name = format!("{}, order {}", $composition::NAME, $composition::ORDER);
            curves.push((name, errors(system, $composition, start)?));
        )*};
    }
    follow! { Verlet Yoshida4 BlanesMoanSrkn6 BlanesMoanSrkn11 KahanLi8 Teloy8C }
    let chart = Chart::new("Energy error of the outer solar system")
        .claim(format!("Largest error in each decade; every composition evaluates one force per {DAYS_PER_FORCE} days"))
        .along(Axis::linear("time in years"))
        .up(Axis::logarithmic("relative energy error"));
    let chart = curves.iter().fold(chart, |chart, (name, curve)| chart.line(name.as_str(), curve.iter().copied()));
    write(&folder.join("outer_solar_system_energy"), &chart)?;
    Ok(curves)
}
