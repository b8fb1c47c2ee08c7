//! The leapfrog as Verlet, shifted by half a step.

use crate::{numbers::plain, study::Study};
use integrator_plot::{
    Axis, Chart, Mark, Marker, Panels,
    colour::{GREY, INK},
};

/// Both sequences on one orbit, and the times to which their numbers belong.
pub(super) fn shifted(study: &Study) -> Panels {
    let (q, p) = (&study.symbols[0], &study.symbols[study.freedom]);
    let claim = format!(
        "The leapfrog has {q} at half steps and {p} at whole ones: {q}ₙ₊½ = {q}ₙ₋½ + h T′({p}ₙ), then {p}ₙ₊₁ = {p}ₙ − h V′({q}ₙ₊½). The shift {q}ₙ = \
         {q}ₙ₊½ − ½ h T′({p}ₙ) makes it Verlet. Both are the same method, read at other times."
    );
    let shifted = &study.shifted;
    let [blue, brown] = ["Verlet", "leapfrog"].map(|name| crate::colour(name).unwrap_or(INK));
    let axis = |symbol: &str| Axis::linear(format!("{symbol} / orbit"));
    let plane = |points: &[[f64; 3]]| points.iter().map(|[_, q, p]| (*q, *p)).collect::<Vec<_>>();
    let orbit = Chart::new("Both sequences")
        .claim("discs: Verlet; squares: leapfrog; grey: the orbit")
        .along(axis(q))
        .up(axis(p))
        .with_equal_units()
        .line("", plane(&shifted.exact))
        .coloured(GREY)
        .wide(1.0)
        .series(Mark::Dots, "Verlet", plane(&shifted.whole))
        .coloured(blue)
        .series(Mark::Dots, "leapfrog", plane(&shifted.half))
        .coloured(brown)
        .marked(Marker::Square);
    let of = |points: &[[f64; 3]], index: usize, later: f64| {
        points.iter().map(|point| (point[0] + later, point[index])).collect::<Vec<_>>()
    };
    let times = Chart::new("Interleaved times")
        .claim(format!("squares: {q} at half steps; discs: {p} at whole steps; grey: both along the orbit"))
        .along(Axis::linear("time / step").between(-0.2, f64::from(TIMES) + 0.2))
        .up(Axis::linear(format!("{q} and {p} / orbit")))
        .line("", of(&shifted.exact, 1, 0.0))
        .coloured(GREY)
        .wide(1.0)
        .line("", of(&shifted.exact, 2, 0.0))
        .coloured(GREY)
        .wide(1.0)
        .series(Mark::Dots, format!("{q} of the leapfrog"), of(&shifted.half, 1, 0.5))
        .coloured(brown)
        .marked(Marker::Square)
        .series(Mark::Dots, format!("{p} of both"), of(&shifted.whole, 2, 0.0))
        .coloured(blue);
    Panels::new(format!("The leapfrog is Verlet, shifted: {}", study.system), claim)
        .measured(format!(
            "step {}; largest distance in steps of {}: {}",
            plain(shifted.step),
            plain(study.step),
            plain(shifted.apart)
        ))
        .columns(2)
        .panel(560, 400)
        .chart(orbit)
        .chart(times)
}

/// The steps of the axis of times.
const TIMES: u32 = 8;
