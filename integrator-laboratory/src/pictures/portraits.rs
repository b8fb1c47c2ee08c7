//! Phase portraits: closed curves, spirals out, spirals in.

use crate::{
    measured::Measured,
    numbers::{plain, signed},
    study::Study,
};
use integrator_plot::{Axis, Chart, Mark, Panels, colour::GREY};

/// How much further the axes reach than the exact orbit, on either side, in units of the orbit.
const ROOM: f64 = 0.4;
/// From so many steps to a period, the points of an orbit are joined.
const JOINED: u32 = 40;

/// One portrait per method.
pub(super) fn portraits(study: &Study) -> Panels {
    let claim = "Each method in steps in which one sees what it does. Symplectic ones stay about the exact orbit, in grey, in \
                 steps as long as a twentieth of a period. Of the others, those that gain energy leave it outwards, and those \
                 that lose energy inwards, each in the shortest steps that show it: the higher the order, the longer these are.";
    let panels = Panels::new(format!("Portraits: {}", study.system), claim).columns(4).panel(320, 360);
    study.methods.iter().fold(panels, |panels, measured| panels.chart(portrait(study, measured)))
}

fn portrait(study: &Study, measured: &Measured) -> Chart {
    let portrait = &measured.portrait;
    let axis = |name: &str, of: fn(&(f64, f64)) -> f64| {
        let (least, most) = study
            .orbit
            .iter()
            .map(of)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        let room = ROOM * (most - least);
        Axis::linear(name).between(least - room, most + room)
    };
    let steps = format!("{} steps to a period, {} periods", portrait.count, plain(portrait.periods.round()));
    let claim = match (study.autonomous, measured.symplectic) {
        (false, true) => "symplectic".to_owned(),
        (false, false) => "not symplectic".to_owned(),
        (true, true) => format!("symplectic: |ΔE/E| up to {}", plain(portrait.largest[0].max(portrait.largest[1]))),
        (true, false) if portrait.change > 0.0 => format!("gains energy: ΔE/E = {}", signed(portrait.change)),
        (true, false) => format!("loses energy: ΔE/E = {}", signed(portrait.change)),
    };
    let (mark, width) = if portrait.count >= JOINED { (Mark::Line, 1.25) } else { (Mark::Dots, 0.6) };
    Chart::new(measured.name())
        .claim(steps)
        .measured(claim)
        .along(axis(&study.view[0], |point| point.0))
        .up(axis(&study.view[1], |point| point.1))
        .with_equal_units()
        .line("", study.orbit.iter().copied())
        .coloured(GREY)
        .wide(1.0)
        .series(mark, "", portrait.points.iter().copied())
        .coloured(measured.row.colour)
        .wide(width)
}
