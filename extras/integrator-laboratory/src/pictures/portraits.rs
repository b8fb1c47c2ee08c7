//! Phase portraits: closed curves, spirals out, spirals in.

use crate::{
    measured::Measured,
    numbers::{plain, signed},
    problem::{broken, steps_per_period},
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, WHITE},
};

/// The distance by which the axes extend beyond the exact orbit, on either side, in units of the orbit.
const ROOM: f64 = 0.4;
/// From this number of steps to a period, the points of an orbit are joined.
const JOINED: u32 = 40;
/// The shades of an orbit that gains or loses, from its beginning to its end: how much of white is mixed in.
const SHADES: [f64; 5] = [0.75, 0.55, 0.35, 0.15, 0.0];

/// One portrait per method.
pub(super) fn portraits(study: &Study) -> Panels {
    let claim = "The exact orbit is grey. Symplectic methods keep its size in steps of a twentieth of a period, although they may turn it. Other \
                 methods gain energy and move outwards, or lose energy and move inwards; colours darken with time. Their steps are \
                 the shortest that show this: longer for higher orders.";
    let panels = Panels::new(format!("Phase portraits: {}", study.system), claim).columns(4).panel(320, 320);
    study.methods.iter().fold(panels, |panels, measured| panels.chart(portrait(study, measured)))
}

/// Returns the range of an axis.
fn seen(orbit: &[(f64, f64)], of: fn(&(f64, f64)) -> f64) -> [f64; 2] {
    let numbers = || orbit.iter().map(of);
    let (least, most) = (numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max));
    let room = ROOM * (most - least);
    [least - room, most + room]
}

fn portrait(study: &Study, measured: &Measured) -> Chart {
    let portrait = &measured.portrait;
    let [x, y] = [seen(&study.orbit, |point| point.0), seen(&study.orbit, |point| point.1)];
    let inside = |point: &(f64, f64)| (x[0]..x[1]).contains(&point.0) && (y[0]..y[1]).contains(&point.1);
    let steps = format!(
        "{} steps per period, {} periods",
        plain(f64::from(study.cycles) * steps_per_period(portrait.count)),
        plain((10.0 * portrait.periods).round() / 10.0)
    );
    let claim = match (study.resolved, measured.symplectic) {
        (false, true) => "symplectic".to_owned(),
        (false, false) => "not symplectic".to_owned(),
        (true, true) => format!("symplectic: |ΔE| up to {} K", plain(portrait.largest[0].max(portrait.largest[1]))),
        (true, false) if portrait.change > 0.0 => format!("gains energy: ΔE = {} K", signed(portrait.change)),
        (true, false) => format!("loses energy: ΔE = {} K", signed(portrait.change)),
    };
    let left = portrait.points.iter().position(|point| !inside(point)).map(|first| {
        let periods = portrait.periods * first as f64 / portrait.points.len() as f64;
        format!("; leaves the frame after {} periods", plain((10.0 * periods).round() / 10.0))
    });
    let claim = format!("{claim}{}", left.unwrap_or_default());
    let (mark, width) = if portrait.count >= JOINED { (Mark::Line, 1.25) } else { (Mark::Dots, 0.6) };
    let chart = Chart::new(measured.name())
        .claim(steps)
        .measured(claim)
        .along(Axis::linear(&study.view[0]).between(x[0], x[1]))
        .up(Axis::linear(&study.view[1]).between(y[0], y[1]))
        .with_equal_units()
        .line("", broken(&study.orbit, study.is_angle))
        .coloured(GREY)
        .wide(1.0);
    let shades = if measured.symplectic { &SHADES[4..] } else { &SHADES };
    // After the last point that is seen there is nothing to tell apart.
    let count = portrait.points.iter().rposition(inside).map_or(0, |last| portrait.points.len().min(last + 2));
    let points = &portrait.points[..count];
    shades.iter().enumerate().fold(chart, |chart, (index, shade)| {
        let part = |index: usize| index * points.len() / shades.len();
        // With the first point of the next part, so that lines are joined.
        let shown = &points[part(index)..points.len().min(part(index + 1) + 1)];
        chart
            .series(mark, "", broken(shown, study.is_angle))
            .coloured(measured.row.colour.towards(WHITE, *shade))
            .wide(width)
    })
}
