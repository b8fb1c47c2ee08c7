//! Integrates 2,000 beads in chains of ten: stiff bonds in inner steps, the Lennard-Jones forces of pairs in outer steps.
//!
//! The program prints the largest energy error over a time of 1 and the milliseconds on one core, for Verlet's method with several
//! steps, and for 2 to 10 inner steps. The column `ratio` is the time of Verlet's method for the same error, by its second order,
//! divided by the time of the run. `polymer_melt.png` shows errors against times for eight inner steps.
//!
//! Inner steps gain where bonds are faster than collisions. Harmonic bonds of stiffness 10⁵ have frequencies of 447 to 625, and
//! beads that collide have about 40. The bonds of Kremer and Grest (1990), FENE with `k = 30`, have about 42 together with the
//! Lennard-Jones force. They are as fast as collisions, and inner steps gain nothing there.
//!
//! Outer steps are limited by half the shortest period, 0.005 here. Eight inner steps of 0.0005 stay below it; ten reach it.

mod melt;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use integrator_core::prelude::*;
use integrator_plot::write;
use melt::{Cost, Melt, NestedMelt, cost, melt};
use picture::{Curve, picture};
use std::error::Error;
use support::{Watch, folder};

/// Time over which errors are measured.
const TIME: f64 = 1.0;
/// Each run is timed this many times; the shortest time counts.
const ROUNDS: u64 = 2;
/// Innermost step of the rows of the table with different numbers of inner steps.
const INNERMOST: f64 = 5e-4;

/// A run of the table: number of inner steps, 1 for Verlet's method, and the outer step.
struct Row {
    inner_steps: u32,
    h: f64,
    cost: Cost,
}

fn main() -> Result<(), Box<dyn Error>> {
    let (chains, start) = melt()?;
    let (plain, nested) = (Melt(chains.clone()), NestedMelt(chains));
    let alone = [1e-3, INNERMOST, 2.5e-4, 1.25e-4].map(|h| (1, h));
    let eight = [2.5e-4, 1.25e-4].map(|inner| (8, 8.0 * inner));
    let with_inner_steps = [2, 4, 8, 10].map(|inner_steps| (inner_steps, f64::from(inner_steps) * INNERMOST));
    let begin = Cost { error: 0.0, seconds: f64::INFINITY };
    let runs = alone.into_iter().chain(with_inner_steps).chain(eight);
    let mut rows: Vec<Row> = runs.map(|(inner_steps, h)| Row { inner_steps, h, cost: begin }).collect();
    let total = rows.len() as u64;
    let watch = Watch::new(ROUNDS * total, "runs");
    for round in 0..ROUNDS {
        for (number, row) in (1..).zip(&mut rows) {
            let found = match row.inner_steps {
                1 => cost(&plain, Verlet, &start, row.h, TIME)?,
                steps => cost(&nested, Verlet.nested(steps), &start, row.h, TIME)?,
            };
            row.cost = Cost { seconds: found.seconds.min(row.cost.seconds), ..found };
            if !watch.done(round * total + number) {
                return Err("stopped before all runs were timed".into());
            }
        }
    }
    drop(watch);
    let verlet = rows[1].cost;
    let ratio = |row: &Row| verlet.seconds_for(row.cost.error) / row.cost.seconds;
    println!("inner steps   outer step   innermost   energy error   milliseconds   ratio");
    for row in &rows {
        let Row { inner_steps, h, cost: Cost { error, seconds } } = row;
        let innermost = h / f64::from(*inner_steps);
        println!("{inner_steps:11} {h:12.1e} {innermost:11.1e} {error:14.2} {:14.0} {:7.2}", 1e3 * seconds, ratio(row));
    }
    let curve = |steps: u32| -> Curve {
        let mut rows: Vec<_> = rows.iter().filter(|row| row.inner_steps == steps).collect();
        rows.sort_by(|a, b| a.h.total_cmp(&b.h));
        rows.iter().map(|row| (1e3 * row.cost.seconds, row.cost.error)).collect()
    };
    let at_eight = rows.iter().find(|row| row.inner_steps == 8).ok_or("no row of eight inner steps")?;
    let file = folder().join("polymer_melt");
    write(&file, &picture(curve(1), curve(8), ratio(at_eight)))?;
    println!("the picture is {}", file.with_extension("png").display());
    Ok(())
}
