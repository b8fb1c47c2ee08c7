//! Compares inner steps with runs of the inner system alone, and with Verlet's method:
//! `cargo bench -p integrator-bench --bench inner_steps`.
//!
//! Inner loops: nanoseconds per inner step of runs with 64 inner steps, and per step of runs of the parts in the parentheses
//! alone. `ratio_inner_<system>=` is the first time divided by the second; the target is 1.03.
//!
//! A polymer melt: 2,000 beads in chains of ten that act on each other by Lennard-Jones forces, with harmonic bonds about ten times
//! as fast as collisions. For each step of Verlet's method and each number of inner steps: the largest error of the energy over the
//! same time, and milliseconds, at the same innermost step. `ratio_melt_<steps>=` is the time that Verlet's method takes for the error of the run with inner
//! steps, by the second power of the step, divided by the time of this run; the target is 2.5.

use integrator_bench::{
    race::{Racer, race},
    table::Table,
};
use integrator_core::prelude::*;
use std::{error::Error, time::Instant};

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

/// Beads in a box with nearest images, in chains.
#[derive(Clone)]
struct Beads {
    side: f64,
    /// The length of a bond at rest, and the bonds.
    length: f64,
    bonds: Vec<[usize; 2]>,
}

/// The energies of beads, as one potential or in parts.
macro_rules! melt {
    ($name:ident ($($arguments:tt)*): $($parts:tt)*) => {
        struct $name(Beads);

        #[hamiltonian($($arguments)*)]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])).sum()
            }
            fn pairs(&self, q: &[[f64; 3]]) -> f64 {
                let mut energy = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let mut square = 0.0;
                        for d in 0..3 {
                            let x = q[i][d] - q[j][d];
                            square += (x - self.0.side * (x / self.0.side).round()).powi(2);
                        }
                        if square < 6.25 {
                            let s = 1.0 / square.powi(3);
                            energy += 4.0 * (s * s - s) + 0.016_316_891_136;
                        }
                    }
                }
                energy
            }
            fn bonds(&self, q: &[[f64; 3]]) -> f64 {
                self.0
                    .bonds
                    .iter()
                    .map(|bond| {
                        let mut square = 0.0;
                        for d in 0..3 {
                            square += (q[bond[0]][d] - q[bond[1]][d]).powi(2);
                        }
                        5e4 * (square.sqrt() - self.0.length).powi(2)
                    })
                    .sum()
            }
            $($parts)*
        }
    };
}

melt!(Melt():
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        self.pairs(q) + self.bonds(q)
    }
);
melt!(NestedMelt(split = pairs + 8 * (bonds + kinetic)):);

/// Chains along a path through a cubic lattice, at random velocities.
fn beads() -> (Beads, Phase<Vec<[f64; 3]>>) {
    let (cells, side) = (13, 13.3);
    let length = side / cells as f64;
    let back_and_forth = |index: usize, along: usize| if along.is_multiple_of(2) { index } else { cells - 1 - index };
    let place = |number: usize| {
        let (row, layer) = (number / cells, number / (cells * cells));
        let [x, y] = [back_and_forth(number % cells, row), back_and_forth(row % cells, layer)];
        [x, y, layer].map(|index| index as f64 * length)
    };
    let q: Vec<_> = (0..2000).map(place).collect();
    let velocity = |number: usize| (1e4 * (number as f64).sin()).fract() * 2.0;
    let p = (0..q.len()).map(|bead| [0, 1, 2].map(|d| velocity(3 * bead + d))).collect();
    let bonds = (1..q.len()).filter(|bead| bead % 10 > 0).map(|bead| [bead - 1, bead]).collect();
    (Beads { side, length, bonds }, Phase::new(q, p))
}

/// The largest error of the energy over a time of one, and the seconds that it took.
fn errors<H: Hamiltonian<Coords = Vec<[f64; 3]>>>(
    system: &H,
    method: impl integrator_core::Method<H>,
    start: &Phase<Vec<[f64; 3]>>,
    h: f64,
) -> Result<[f64; 2], integrator_core::Error> {
    let mut run = system.run_with(method, start.clone(), h)?.with_threads(1);
    let (energy, portion) = (run.energy(), (0.02 / h).round() as u64);
    let (mut error, mut seconds) = (0.0_f64, 0.0);
    for _ in 0..50 {
        let begin = Instant::now();
        run.advance(portion)?;
        seconds += begin.elapsed().as_secs_f64();
        error = error.max((run.energy() - energy).abs());
    }
    Ok([error, seconds])
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("inner_loops", &["system", "run", "ns", "ratio"]);
    let mut lines = vec![
        inner_loop(&mut table, "springs", &Springs, &Spring, Phase::new([0.3, 0.2], [0.1, -0.2])),
        inner_loop(&mut table, "moon", &PerturbedMoon, &Moon, Phase::new([1.0, 0.0], [0.0, 1.1])),
    ];
    println!();
    let (beads, start) = beads();
    let (plain, nested) = (Melt(beads.clone()), NestedMelt(beads));
    // Collisions bring the lattice into disorder first.
    let mut settled = plain.run(start, 2.5e-4)?;
    settled.advance(8000)?;
    let start = settled.state();
    let mut table = Table::new("melt", &["method", "inner steps", "innermost", "error", "ms"]);
    let mut row = |method: &str, steps: u32, h: f64, [error, seconds]: [f64; 2]| {
        table.row([method, &steps.to_string()], &[h, error, seconds * 1e3]);
    };
    let h = 5e-4;
    let verlet = errors(&plain, Verlet, &start, h)?;
    row("Verlet", 1, h, verlet);
    row("Verlet", 1, h / 2.0, errors(&plain, Verlet, &start, h / 2.0)?);
    for steps in [2, 4, 8, 10] {
        let found = errors(&nested, Verlet.nested(steps), &start, h * f64::from(steps))?;
        row("inner steps", steps, h, found);
        let at_equal_error = verlet[1] * (verlet[0] / found[0]).sqrt();
        lines.push(format!("ratio_melt_{steps}={:.3}", at_equal_error / found[1]));
    }
    println!();
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
