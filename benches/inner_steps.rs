//! Compares inner steps with runs of the inner system alone, and with Verlet's method:
//! `cargo bench -p integrator-bench --bench inner_steps`.
//!
//! Inner loops: nanoseconds per inner step of runs with 64 inner steps, and per step of runs of the parts in the parentheses
//! alone. `ratio_inner_<system>=` is the first time divided by the second; the target is 1.03.
//!
//! The polymer melt of the example of that name: 2,000 beads in chains of ten, with harmonic bonds about ten times as fast as
//! collisions. For each step of Verlet's method and each number of inner steps: the largest error of the energy over the same time,
//! and milliseconds, at the same innermost step. `ratio_melt_<steps>=` is the time that Verlet's method takes for the error of the
//! run with inner steps, by the second power of the step, divided by the time of this run; the target is 2.5.

#[path = "../examples/polymer_melt/melt.rs"]
mod melt;

use integrator_bench::{
    race::{Racer, race},
    table::Table,
};
use integrator_core::prelude::*;
use melt::{Cost, Melt, NestedMelt, cost, melt};
use std::error::Error;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 21;

/// The inner steps of a round.
const COUNT: u64 = 1 << 18;

/// A stiff spring in an anharmonic well.
struct Springs;

#[hamiltonian(split = well + 64 * (spring + kinetic))]
impl Springs {
    fn well(&self, q: [f64; 2]) -> f64 {
        0.1 * q[0].powi(4) + q[0] * q[1] * q[1]
    }
    fn spring(&self, q: [f64; 2]) -> f64 {
        5.0 * q[0] * q[0] + 10.0 * q[1] * q[1] + q[0] * q[1] * q[1]
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// Its spring alone.
struct Spring;

#[hamiltonian(split = spring + kinetic)]
impl Spring {
    fn spring(&self, q: [f64; 2]) -> f64 {
        5.0 * q[0] * q[0] + 10.0 * q[1] * q[1] + q[0] * q[1] * q[1]
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// A moon with a weak perturbation.
struct PerturbedMoon;

#[hamiltonian(split = tide + 64 * (planet + kinetic))]
impl PerturbedMoon {
    fn tide(&self, q: [f64; 2]) -> f64 {
        1e-3 * (q[0] * q[0] - 2.0 * q[1] * q[1])
    }
    fn planet(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// The moon without it.
struct Moon;

#[hamiltonian(split = planet + kinetic)]
impl Moon {
    fn planet(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// The ratio of inner steps to the steps of the inner system.
fn inner_loop<N, A>(table: &mut Table, name: &'static str, nested: &N, alone: &A, start: Phase<[f64; 2]>) -> String
where
    N: Hamiltonian<Coords = [f64; 2]>,
    A: Hamiltonian<Coords = [f64; 2]>,
{
    let h = 1e-3;
    let mut with = nested.run(start, 64.0 * h).expect("a good start");
    let mut without = alone.run(start, h).expect("a good start");
    let racers = vec![
        Racer::new("inner steps", move || with.advance(COUNT / 64).expect("finite states")),
        Racer::new("inner system alone", move || without.advance(COUNT).expect("finite states")),
    ];
    let times = race(ROUNDS, COUNT as f64, racers);
    for (racer, words) in times.names().iter().enumerate() {
        table.row([name, words], &[times.median(racer), times.ratio(racer, 1)]);
    }
    format!("ratio_inner_{name}={:.3}", times.ratio(0, 1))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("inner_loops", &["system", "run", "ns", "ratio"]);
    let mut lines = vec![
        inner_loop(&mut table, "springs", &Springs, &Spring, Phase::new([0.3, 0.2], [0.1, -0.2])),
        inner_loop(&mut table, "moon", &PerturbedMoon, &Moon, Phase::new([1.0, 0.0], [0.0, 1.1])),
    ];
    println!();
    let (chains, start) = melt()?;
    let (plain, nested) = (Melt(chains.clone()), NestedMelt(chains));
    let mut table = Table::new("melt", &["method", "inner steps", "innermost", "error", "ms"]);
    let mut row = |method: &str, steps: u32, h: f64, Cost { error, seconds }: Cost| {
        table.row([method, &steps.to_string()], &[h, error, seconds * 1e3]);
    };
    let (h, time) = (5e-4, 1.0);
    let verlet = cost(&plain, Verlet, &start, h, time)?;
    row("Verlet", 1, h, verlet);
    row("Verlet", 1, h / 2.0, cost(&plain, Verlet, &start, h / 2.0, time)?);
    for steps in [2, 4, 8, 10] {
        let found = cost(&nested, Verlet.nested(steps), &start, h * f64::from(steps), time)?;
        row("inner steps", steps, h, found);
        lines.push(format!("ratio_melt_{steps}={:.3}", verlet.seconds_for(found.error) / found.seconds));
    }
    println!();
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
