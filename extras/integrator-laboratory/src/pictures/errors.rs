//! Errors against the step, and against the work.

use super::style::{of_adaptive, series};
use crate::{
    errors::{PERIODS, Rung},
    measured::Measured,
    numbers::plain,
    study::Study,
};
use integrator_plot::{Axis, Chart, Mark};

/// Errors against the step, with the order that is measured.
pub(super) fn against_step(study: &Study) -> Chart {
    let chart = Chart::new(format!("Error against step: {}", study.system))
        .claim(
            format!("The distance from the reference after {PERIODS} periods. The slope is the order of the method, fitted where the error is above rounding."),
        )
        .measured("the number after each name is the measured order")
        .along(Axis::logarithmic("step"));
    let name = |measured: &Measured| match measured.slope {
        Some(slope) => format!("{}: {}", measured.name(), plain(slope)),
        None => measured.name().to_owned(),
    };
    curves(chart, study, name, |rung| rung.step)
}

/// Errors against evaluations of the vector field.
pub(super) fn against_work(study: &Study) -> Chart {
    let chart = Chart::new(format!("Work and precision: {}", study.system))
        .claim(format!("Lower left is better: a smaller error after {PERIODS} periods with fewer force evaluations."))
        .measured(format!("evaluations to an error of 10⁻⁸: {}", cheapest(study)))
        .along(Axis::logarithmic("force evaluations"));
    let chart = curves(chart, study, |measured| measured.name().to_owned(), |rung| rung.evaluations as f64);
    study.adaptive.iter().fold(chart, |chart, adaptive| {
        let points = adaptive.errors.iter().map(|rung| (rung.evaluations as f64, rung.error));
        of_adaptive(chart, Mark::Dotted, adaptive, points)
    })
}

fn curves(chart: Chart, study: &Study, name: impl Fn(&Measured) -> String, along: fn(&Rung) -> f64) -> Chart {
    let up = Axis::logarithmic("distance from the reference").between(1e-16, 3.0);
    study.methods.iter().fold(chart.up(up).sized(1150, 760), |chart, measured| {
        let points = measured.errors.iter().map(|rung| (along(rung), rung.error));
        series(chart, Mark::Dotted, (&measured.row, measured.symplectic), name(measured), points)
    })
}

/// The three methods that need the fewest evaluations for an error of 1e-8.
fn cheapest(study: &Study) -> String {
    let fixed = study.methods.iter().map(|measured| (measured.name(), &measured.errors));
    let all = fixed.chain(study.adaptive.iter().map(|adaptive| (adaptive.row.name, &adaptive.errors)));
    let needs = all.filter_map(|(name, errors)| {
        let rung = errors.iter().find(|rung| rung.error < 1e-8)?;
        Some((rung.evaluations, name))
    });
    let mut needs: Vec<_> = needs.collect();
    needs.sort_unstable();
    needs.iter().take(3).map(|(evaluations, name)| format!("{name} {evaluations}")).collect::<Vec<_>>().join(", ")
}
