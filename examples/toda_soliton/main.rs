//! A soliton on Toda's lattice: a wave that goes around a ring for ever and keeps its shape.
//!
//! Look at the picture, `toda_soliton.png`. On the left the momenta of all sites at several times in the first turn, one
//! above the other, with the closed form as dots; on the right the distance from the closed form over a hundred turns: it
//! grows like the time, since the step changes the speed by a little, and the shape stays. Positions grow by 2κ in every
//! turn and round ever more coarsely, which would hide this; hence the run carries its rounding errors along. Printed: the
//! speed, `sinh κ / κ`, and the distances after the first turn and at the end, in units of the height of the wave.

mod ring;
#[path = "../support/mod.rs"]
mod support;

use integrator_core::prelude::*;
use integrator_plot::{Axis, Chart, Mark, Panels, colour, write};
use ring::{Soliton, values};
use std::error::Error;
use support::{Watch, folder};

const SOLITON: Soliton = Soliton { sites: 64, kappa: 1.0 };
/// A turn takes so many steps, of 0.053 each.
const STEPS: u64 = 1020;
const TURNS: u64 = 100;
/// Looks in the first turn.
const LOOKS: u64 = 6;

fn main() -> Result<(), Box<dyn Error>> {
    let h = SOLITON.turn() / STEPS as f64;
    let start = SOLITON.state(0.0);
    let run = SOLITON.ring().run(Phase::compensated(start.q, start.p), h)?;
    let mut waves = Chart::new("One turn around the ring")
        .claim("Lines: computed, upwards in time. Dots: closed form")
        .along(Axis::linear("site"))
        .up(Axis::linear("momentum, each look 1 higher"));
    let mut closed_form = Vec::new();
    for sample in run.clone().samples(STEPS / LOOKS).take(LOOKS as usize + 1) {
        let Sample { time, step, state, .. } = sample?;
        let higher = (step * LOOKS / STEPS) as f64;
        let wave = |state: Phase<Vec<f64>>| state.p.into_iter().zip(0..).map(move |(p, n)| (f64::from(n), p + higher));
        waves = waves.line("", wave(values(&state))).coloured(colour::COLOURS[6]);
        closed_form.extend(wave(SOLITON.state(time)));
    }
    waves = waves.dots("", closed_form).coloured(colour::COLOURS[3]);

    let watch = Watch::new(STEPS * TURNS, "steps");
    let mut distances = Vec::new();
    for sample in run.samples(STEPS).skip(1).take(TURNS as usize) {
        let sample = sample?;
        distances.push((sample.step as f64 / STEPS as f64, SOLITON.distance(&values(&sample.state), sample.time)));
        if !watch.done(sample.step) {
            break;
        }
    }
    drop(watch);

    let [(_, first), .., (turns, last)] = distances[..] else { return Err("stopped in the first turn".into()) };
    let of = |which: usize| distances.iter().map(move |(turn, distance)| (*turn, distance[which]));
    let growth = Chart::new("Distance from the closed form")
        .claim("Black: momenta, relative to the height of the wave. Blue: positions")
        .along(Axis::logarithmic("turns"))
        .up(Axis::logarithmic("distance"))
        .series(Mark::Dotted, "", of(0))
        .series(Mark::Dotted, "", of(1));
    let picture = Panels::new("A soliton on Toda's lattice", "It keeps its shape and its speed")
        .measured(format!("after {turns:.0} turns the momenta are off by {:.1e} of the height", last[0]))
        .columns(2)
        .panel(620, 640)
        .chart(waves)
        .chart(growth);
    let file = folder().join("toda_soliton");
    write(&file, &picture)?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("speed={}", SOLITON.speed());
    println!("distance_after_one_turn={:e}", first[0]);
    println!("distance_after_{turns}_turns={:e}", last[0]);
    Ok(())
}
