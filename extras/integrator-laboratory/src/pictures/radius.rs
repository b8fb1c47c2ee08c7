//! Taylor's steps against the radius of convergence.

use crate::{
    models::ECCENTRICITY,
    numbers::plain,
    radius::{TOLERANCE, of_convergence},
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, INK},
};
use std::f64::consts::TAU;

/// The steps along an ellipse, and their lengths beside the radius.
pub(super) fn radius(study: &Study) -> Option<Panels> {
    let radius = study.models.radius.as_ref()?;
    let ink = crate::colour("Taylor").unwrap_or(INK);
    let claim = format!(
        "Taylor’s method adds up the series z(t + h) = Σ hᵏ z⁽ᵏ⁾(t) / k!. On an ellipse of eccentricity {ECCENTRICITY} the motion is singular at complex \
         times iτ from each perihelion, and the series about t converges up to √(t² + τ²). Each step is about the same share of this radius."
    );
    let [least, most] = radius.shares();
    let lengths = radius.steps.iter().map(|step| (step.time, step.length));
    let curve = (0..=400).map(|part| TAU * f64::from(part) / 400.0);
    let against_time = Chart::new("Radius and step")
        .claim("line: the radius of convergence; dots: steps")
        .along(Axis::linear("time from perihelion"))
        .up(Axis::logarithmic("time unit"))
        .line("radius", curve.clone().map(|time| (time, of_convergence(time))))
        .coloured(GREY)
        .series(Mark::Dots, "step", lengths)
        .coloured(ink)
        .wide(1.2);
    let places = radius.steps.iter().map(|step| step.place);
    let orbit = curve.map(|anomaly| {
        let (sine, cosine) = anomaly.sin_cos();
        (cosine - ECCENTRICITY, (1.0 - ECCENTRICITY * ECCENTRICITY).sqrt() * sine)
    });
    let along = Chart::new("Steps along the ellipse")
        .claim(format!("{} steps in a period, tolerance {}", radius.steps.len(), plain(TOLERANCE)))
        .along(Axis::linear("x / a"))
        .up(Axis::linear("y / a"))
        .with_equal_units()
        .line("", orbit)
        .coloured(GREY)
        .wide(0.75)
        .series(Mark::Dots, "", places)
        .coloured(ink)
        .wide(1.0)
        .series(Mark::Dots, "", [(0.0, 0.0)])
        .coloured(INK);
    let panels = Panels::new(format!("Taylor series: {}", study.system), claim).measured(format!(
        "a step is between {} and {} of the radius",
        plain(least),
        plain(most)
    ));
    Some(panels.columns(2).panel(560, 400).chart(along).chart(against_time))
}
