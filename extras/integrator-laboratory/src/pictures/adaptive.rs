//! Runge–Kutta with steps by an error estimate.

use crate::{
    adaptive::TOLERANCE,
    models::ECCENTRICITY,
    numbers::{plain, signed},
    problem::broken,
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, INK},
};

/// The steps along an eccentric orbit and against the force, an orbit of the system, and errors against the tolerance.
pub(super) fn adaptive(study: &Study) -> Option<Panels> {
    let (own, ellipse) = (study.steps.as_ref()?, study.models.ellipse.as_ref()?);
    let claim = format!(
        "Dormand and Prince's pair of orders 5 and 4 estimates the error of each step and keeps it at the tolerance. On an ellipse of \
         eccentricity {ECCENTRICITY} steps are short near the centre, where the force is large. Energy is not conserved."
    );
    let ink = crate::colour("Dormand–Prince 5").unwrap_or(INK);
    let along = Chart::new("Steps along an ellipse")
        .claim(format!("{} steps in two periods, tolerance {}", ellipse.places.len() - 1, plain(TOLERANCE)))
        .along(Axis::linear("x / a"))
        .up(Axis::linear("y / a"))
        .with_equal_units()
        .line("", ellipse.places.iter().copied())
        .coloured(GREY)
        .wide(0.75)
        .series(Mark::Dots, "", ellipse.places.iter().copied())
        .coloured(ink)
        .wide(0.8)
        .series(Mark::Dots, "", [(0.0, 0.0)])
        .coloured(INK);
    let lengths = Chart::new("Steps against the force")
        .claim(format!("exponent {}, and −3/4 by theory", plain(ellipse.exponent)))
        .along(Axis::logarithmic("force"))
        .up(Axis::logarithmic("step / time unit"))
        .series(Mark::Dots, "", ellipse.lengths.iter().copied())
        .coloured(ink)
        .wide(0.8);
    let portrait = Chart::new("Phase portrait")
        .claim(format!("tolerance {}", plain(own.tolerance)))
        .measured(if study.resolved { format!("ΔE = {} K", signed(own.change)) } else { String::new() })
        .along(Axis::linear(&study.view[0]))
        .up(Axis::linear(&study.view[1]))
        .with_equal_units()
        .line("", broken(&study.orbit, study.is_angle))
        .coloured(GREY)
        .wide(1.0)
        .series(Mark::Dots, "", own.portrait.iter().copied())
        .coloured(ink)
        .wide(0.6);
    let errors = Chart::new("Error against tolerance")
        .claim("after 2.25 periods; hover over a line for its name")
        .along(Axis::logarithmic("tolerance"))
        .up(Axis::logarithmic("distance from the reference"));
    let errors = study.adaptive.iter().fold(errors, |chart, adaptive| {
        let points = adaptive.errors.iter().map(|rung| (rung.step, rung.error));
        chart.series(Mark::Dotted, adaptive.row.name, points).coloured(adaptive.row.colour).wide(1.0)
    });
    let panels = Panels::new(format!("Adaptive Runge–Kutta: {}", study.system), claim).columns(4).panel(320, 340);
    Some([portrait, along, lengths, errors].into_iter().fold(panels, Panels::chart))
}
