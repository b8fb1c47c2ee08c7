//! Picture of the paths of the three bodies.

use crate::bodies::{Compensation, MASSES, run};
use integrator_plot::{Axis, Chart, write};
use std::{error::Error, path::Path};

pub(crate) fn paths(file: &Path) -> Result<(), Box<dyn Error>> {
    let samples = run(0.05)?.samples_at(0.005).take(14_001);
    let path: Vec<Compensation> =
        samples.map(|sample| sample.map(|sample| sample.state.q)).collect::<Result<_, _>>()?;
    let chart = Chart::new("The Pythagorean problem until t = 70")
        .claim("After many encounters the lightest body is ejected, and the other two form a binary")
        .along(Axis::linear("x"))
        .up(Axis::linear("y"))
        .with_equal_units()
        .sized(900, 1100);
    let chart = MASSES.iter().enumerate().fold(chart, |chart, (body, mass)| {
        chart.line(format!("mass {mass}"), path.iter().map(move |q| (q[body][0].value, q[body][1].value)))
    });
    write(file, &chart)
}
