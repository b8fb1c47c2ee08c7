//! Picture of the wave on its way around the ring, and of its distance from the closed form.

use crate::ring::Soliton;
use integrator_core::prelude::*;
use integrator_plot::{Axis, Chart, Mark, Marker, Panels, colour};

/// Draws samples `(time, state)` of the first period, and distances `(periods, [of momenta, of positions])` after each
/// period.
pub(crate) fn picture(soliton: &Soliton, samples: &[(f64, Phase<Vec<f64>>)], distances: &[(f64, [f64; 2])]) -> Panels {
    let wave = |higher: usize, state: &Phase<Vec<f64>>| {
        let sites: Vec<_> = state.p.iter().enumerate().map(|(site, p)| (site as f64, p + higher as f64)).collect();
        sites
    };
    let mut waves = Chart::new("One period around the ring")
        .claim("Lines: computed, later times above. Dots: closed form")
        .along(Axis::linear("site"))
        .up(Axis::linear("momentum, each time shifted by 1"));
    for (number, (_, state)) in samples.iter().enumerate() {
        waves = waves.line("", wave(number, state)).coloured(colour::COLOURS[6]);
    }
    let closed_form = samples.iter().enumerate().flat_map(|(number, (time, _))| wave(number, &soliton.state(*time)));
    let of = |which: usize| distances.iter().map(move |(periods, distance)| (*periods, distance[which]));
    let growth = Chart::new("Distance from the closed form")
        .claim("Black discs: momenta, relative to the height of the wave. Blue squares: positions")
        .along(Axis::logarithmic("periods"))
        .up(Axis::logarithmic("distance"))
        .series(Mark::Dotted, "", of(0))
        .series(Mark::Dotted, "", of(1))
        .marked(Marker::Square);
    let measured = distances.last().map(|(periods, [momenta, _])| {
        format!("after {periods:.0} periods the momenta deviate by {momenta:.1e} of the height")
    });
    Panels::new("A soliton on the Toda lattice", "It keeps its shape and its speed")
        .measured(measured.unwrap_or_default())
        .columns(2)
        .panel(620, 640)
        .chart(waves.dots("", closed_form).coloured(colour::COLOURS[3]))
        .chart(growth)
}
