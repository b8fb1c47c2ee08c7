//! Ions in Paul's trap: a Hamiltonian that reads the clock, and Mathieu's equation.
//!
//! A constant voltage cannot hold an ion; one that alternates can, where its parameters `(a, q)` are in the right region.
//! Look at the picture, `paul_trap.png`: the region where both directions are stable, from the map of one period for each of
//! 1.2 million traps; an orbit inside of it, slow with a quick tremble; and one just outside, which grows. Printed: where the
//! region ends on the axis `a = 0`, which Mathieu's equation says is 0.9080463337, and how far the two orbits go.

#[path = "../support/mod.rs"]
mod support;
mod trap;

use integrator_core::prelude::*;
use integrator_plot::{Axis, Chart, Panels, colour, write};
use std::{error::Error, f64::consts::PI};
use support::{Watch, folder};
use trap::{PaulTrap, STEPS, edge, holds, traces};

const ROWS: u32 = 1000;
const COLUMNS: u32 = 1200;

/// An orbit over 60 periods of the voltage.
fn orbit(trap: PaulTrap) -> Result<Vec<(f64, f64)>, integrator_core::Error> {
    let run = trap.run(Phase::new([1.0, 1.0], [0.0, 0.0]), PI / STEPS as f64)?;
    run.samples(1).take(60 * STEPS as usize).map(|sample| sample.map(|s| (s.time / PI, s.state.q[0]))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let watch = Watch::new(u64::from(ROWS), "rows of traps");
    let (mut held, mut one_way) = (Vec::new(), Vec::new());
    for row in 0..ROWS {
        let a = 0.5 * (f64::from(row) + 0.5) / f64::from(ROWS) - 0.25;
        let traps = (0..COLUMNS).map(|column| PaulTrap { a, q: 1.2 * (f64::from(column) + 0.5) / f64::from(COLUMNS) });
        for (trap, traces) in traps.clone().zip(traces(traps)?) {
            if holds(traces) {
                held.push((trap.q, trap.a));
            } else if traces.iter().any(|trace| trace.abs() < 2.0) {
                one_way.push((trap.q, trap.a));
            }
        }
        if !watch.done(u64::from(row)) {
            break;
        }
    }
    drop(watch);

    let (inside, outside) = (PaulTrap { a: 0.0, q: 0.3 }, PaulTrap { a: 0.0, q: 0.91 });
    let (calm, wild) = (orbit(inside)?, orbit(outside)?);
    let greatest = |orbit: &[(f64, f64)]| orbit.iter().map(|(_, x)| x.abs()).fold(0.0, f64::max);
    let (near, far, edge) = (greatest(&calm), greatest(&wild), edge()?);
    let point = |trap: PaulTrap| [(trap.q, trap.a)];
    let region = Chart::new("Which traps hold ions")
        .claim("Blue: both directions are stable. Light: one is. Dots: the two traps beside")
        .along(Axis::linear("q, alternating voltage"))
        .up(Axis::linear("a, constant voltage"))
        .cloud("", one_way)
        .coloured(colour::COLOURS[1])
        .cloud("", held)
        .coloured(colour::COLOURS[6])
        .dots("", point(inside))
        .coloured(colour::COLOURS[2])
        .dots("", point(outside))
        .coloured(colour::COLOURS[3]);
    let over_time = |title: &str, orbit, which: usize| {
        let chart = Chart::new(title).along(Axis::linear("periods of the voltage")).up(Axis::linear("x"));
        chart.line("", orbit).coloured(colour::COLOURS[which])
    };
    let picture = Panels::new("Paul's trap", "An alternating voltage holds ions where Mathieu's equation is stable")
        .measured(format!("without a constant voltage, up to q = {edge:.8}"))
        .panel(520, 480)
        .chart(region)
        .chart(over_time("Inside: a = 0, q = 0.3", calm, 2))
        .chart(over_time("Outside: a = 0, q = 0.91", wild, 3));
    let file = folder().join("paul_trap");
    write(&file, &picture)?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("edge={edge}");
    println!("greatest_distance_inside={near}");
    println!("greatest_distance_outside={far:e}");
    Ok(())
}
