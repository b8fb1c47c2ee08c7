//! A stiff equation: the motion, and the regions of stability.

use crate::{
    gear::{GEAR, LONG, ORDERS, SHORT, STIFFNESS},
    numbers::plain,
    roots::points,
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{COLOURS, GREY, INK},
};

/// The transient and the slow curve: explicit steps, which explode, and Gear's.
pub(super) fn motion(study: &Study) -> Panels {
    let claim = format!(
        "y′ = −{STIFFNESS} (y − cos t) from y = 0: a fast transient, then a slow curve near cos t, in grey. Forward Euler has to take steps below \
         2/{STIFFNESS} = {} for a transient that has decayed. Backward differences (Gear) take steps for the slow curve.",
        plain(2.0 / STIFFNESS)
    );
    let gear = &study.models.gear;
    let euler = crate::colour("forward Euler").unwrap_or(INK);
    let [backward, many] = ["backward Euler", "backward differences"].map(|name| crate::colour(name).unwrap_or(INK));
    let chart = |title: &str| {
        Chart::new(title)
            .along(Axis::linear("t"))
            .up(Axis::linear("y").between(-0.5, 2.5))
            .line("", gear.exact.iter().copied())
            .coloured(GREY)
            .wide(2.5)
    };
    let step = |over: f64| format!("steps of {over}/{STIFFNESS}");
    let explicit = chart("Forward Euler")
        .claim(format!("solid: {}; dashed: {}", step(SHORT), step(LONG)))
        .line(step(SHORT), gear.explicit[0].iter().copied())
        .coloured(euler)
        .wide(1.25)
        .line(step(LONG), gear.explicit[1].iter().copied())
        .coloured(crate::colour("explicit midpoint").unwrap_or(INK))
        .dashed()
        .wide(1.25);
    let implicit = chart("Backward differences")
        .claim(format!("blue: order 1, which is backward Euler; red: order 4; both in {}", step(GEAR)))
        .series(Mark::Dotted, "BDF 1", gear.implicit[0].iter().copied())
        .coloured(backward)
        .wide(1.25)
        .series(Mark::Dotted, "BDF 4", gear.implicit[1].iter().copied())
        .coloured(many)
        .wide(1.25);
    Panels::new(format!("A stiff equation: {}", study.system), claim)
        .measured(format!(
            "error of forward Euler in {} at the end: {}; largest error of BDF 1 to 6 in {} on the slow curve: {}",
            step(LONG),
            plain(gear.explodes),
            step(GEAR),
            plain(gear.stays)
        ))
        .columns(2)
        .panel(560, 400)
        .chart(explicit)
        .chart(implicit)
}

/// The borders of the regions of stability, outside of which the formulas are stable.
pub(super) fn regions(study: &Study) -> Chart {
    let gear = &study.models.gear;
    let angles: Vec<String> =
        gear.angles.iter().zip(1..).map(|(angle, order)| format!("BDF {order}: {angle:.2}°")).collect();
    let chart = Chart::new(format!("Regions of stability: {}", study.system))
        .claim(format!(
            "BDF 1 to {ORDERS} damp the solution of y′ = λy for every hλ outside of their curve, and hence in the sector of the angle α around the \
             negative axis: they are A(α)-stable. From order 7 on, the formulas are stable for no step."
        ))
        .measured(format!("α of {}", angles.join(", ")))
        .along(Axis::linear("Re hλ").between(-8.0, 30.0))
        .up(Axis::linear("Im hλ").between(-14.0, 14.0))
        .with_equal_units();
    gear.borders.iter().zip(1..).fold(chart, |chart, (border, order)| {
        let points = points(border).step_by(20);
        chart.line(format!("BDF {order}"), points).coloured(COLOURS[order]).wide(1.5)
    })
}
