//! Phase portraits: closed curves, spirals out, spirals in.

use super::Drawing;
use crate::{measured::Measured, study::Study};
use integrator_plot::{Axis, Chart, Panels, colour::COLOURS};

/// How much further the axes reach than the exact orbit, on either side, in units of the orbit.
const ROOM: f64 = 0.35;

/// One portrait per method.
pub(super) fn portraits(study: &Study) -> Drawing {
    let title = format!("Phase portraits: {}", study.system);
    let claim = match study.freedom {
        1 => {
            "Symplectic methods stay on closed curves however coarse the step. Others spiral out and gain energy, or spiral \
             in and lose it."
        }
        _ => {
            "Symplectic methods stay where the exact orbit goes however coarse the step. Others leave it outwards and gain \
             energy, or inwards and lose it."
        }
    };
    let measured = format!("step {}, {} periods", study.step, periods(study));
    let panels = Panels::new(title, claim).measured(measured).columns(4).panel(310, 350);
    Drawing::Panels(study.methods.iter().fold(panels, |panels, measured| panels.chart(portrait(study, measured))))
}

fn periods(study: &Study) -> f64 {
    let last = |measured: &Measured| measured.energies.last().map_or(0.0, |(periods, _)| *periods);
    study.methods.iter().map(last).fold(0.0, f64::max).round()
}

fn portrait(study: &Study, measured: &Measured) -> Chart {
    let axis = |i: usize| {
        let [least, most] = study.extents[i];
        let room = ROOM * (most - least);
        Axis::linear(&study.view[i]).between(least - room, most + room)
    };
    let (shape, colour) = match measured.energy_change() {
        _ if measured.keeps_bracket() => ("symplectic", COLOURS[5]),
        change if change > 0.0 => ("gains energy", COLOURS[3]),
        _ => ("loses energy", COLOURS[6]),
    };
    let claim = match study.autonomous {
        true if measured.keeps_bracket() => format!("{shape}, |ΔE/E| ≤ {:.1e}", measured.largest_energy_change()),
        true => format!("{shape}, ΔE/E = {:+.1e}", measured.energy_change()),
        false => shape.to_owned(),
    };
    Chart::new(measured.name)
        .claim(claim)
        .along(axis(0))
        .up(axis(1))
        .line("", measured.portrait.iter().copied())
        .coloured(colour)
}
