//! The roots of multistep methods in the complex plane.

use crate::{
    multistep::GROWING,
    numbers::plain,
    roots::{Complex, points, turned},
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, INK},
};
use std::f64::consts::TAU;

/// One panel for each method, with the unit circle.
pub(super) fn roots(study: &Study) -> Option<Panels> {
    let multistep = study.models.multistep.as_ref()?;
    let claim = "On an oscillator each step multiplies a solution by a root of the characteristic polynomial. One root, in colour, follows \
                 exp(ihω) along the unit circle, for hω up to 1.5. The others, in grey, are parasitic: they do not belong to the motion, \
                 start from zero, and ruin the solution once they leave the circle.";
    let panels = Panels::new(format!("Parasitic roots: {}", study.system), claim)
        .measured(format!(
            "Adams–Bashforth 4 in steps of hω = {GROWING}: its growth per step is its largest root, to {}",
            plain((multistep.growth - 1.0).abs())
        ))
        .columns(4)
        .panel(320, 320);
    let circle: Vec<Complex> = (0..=120).map(|part| turned(TAU * f64::from(part) / 120.0)).collect();
    Some(multistep.roots.iter().fold(panels, |panels, roots| {
        let leaves = match roots.leaves {
            Some(x) => format!("a root leaves the circle at hω = {}", plain(x)),
            None => "no root leaves the circle up to hω = 1.5".to_owned(),
        };
        let chart = Chart::new(roots.name)
            .claim(leaves)
            .along(Axis::linear("Re ζ").between(-1.6, 1.6))
            .up(Axis::linear("Im ζ").between(-1.6, 1.6))
            .with_equal_units()
            .line("", points(&circle))
            .coloured(INK)
            .wide(0.75)
            .series(Mark::Dots, "", points(&roots.parasitic))
            .coloured(GREY)
            .wide(0.4)
            .series(Mark::Dots, "", points(&roots.principal))
            .coloured(crate::colour(roots.name).unwrap_or(INK))
            .wide(0.8);
        panels.chart(chart)
    }))
}
