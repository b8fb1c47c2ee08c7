//! Benchmarks steps with friction and noise: `cargo bench -p integrator-bench --bench friction`.
//!
//! The last lines are medians over interleaved rounds: the time of `Baoab` with noise divided by that of `Verlet` for the same
//! system without friction, with as many forces. `ratio_friction_members=` is for 1,024 pendulums in lanes and on threads, with
//! one random number for each step, `ratio_friction_argon=` for a liquid of 4,000 atoms, with three for each atom and step, and
//! `ratio_friction_chain=` for a chain of a million sites on one thread, with one for each site and step.

use integrator_bench::{
    problems::ArgonInBox,
    race::{Racer, race},
    starts::{Problems, liquid},
};
use integrator_core::prelude::*;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 31;
/// Numbers of members and steps of the ensemble.
const MEMBERS: u32 = 1_024;
const STEPS: u64 = 1_000;

/// A pendulum in a bath.
#[derive(Clone, Copy)]
struct WarmPendulum;

#[hamiltonian(split = kinetic + potential + friction)]
impl WarmPendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        0.1
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.5
    }
}

/// The atoms of [`ArgonInBox`] in a bath.
struct WarmArgon(ArgonInBox);

#[hamiltonian(split = kinetic + potential + friction)]
impl WarmArgon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let x = x - self.0.side * (x / self.0.side).round_ties_even();
                let y = y - self.0.side * (y / self.0.side).round_ties_even();
                let z = z - self.0.side * (z / self.0.side).round_ties_even();
                let square = x * x + y * y + z * z;
                if square < 6.25 {
                    let sixth = square.powi(-3);
                    energy += 4.0 * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.72
    }
}

/// Anharmonic springs between sites.
struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(2) / 2.0 + (q[i] - q[i - 1]).powi(4) / 4.0).sum()
    }
}

/// The same chain in a bath.
struct WarmChain;

#[hamiltonian(split = kinetic + potential + friction)]
impl WarmChain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(2) / 2.0 + (q[i] - q[i - 1]).powi(4) / 4.0).sum()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        0.1
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.5
    }
}

/// Measures an ensemble of pendulums with noise and without.
fn members() -> String {
    let pendulum = Problems::default().pendulum().system;
    let start = |number: u32| Phase::new([f64::from(number) / f64::from(MEMBERS)], [0.0]);
    let starts = || (0..MEMBERS).map(start);
    let mut without =
        Ensemble::new(Verlet, starts().map(|start| (pendulum, start)), 0.1).expect("starts").with_threads(1);
    let mut with =
        Ensemble::new(Baoab, starts().map(|start| (WarmPendulum, start)), 0.1).expect("starts").with_threads(1);
    let racers = vec![
        Racer::new("without", || without.advance(STEPS).expect("finite states")),
        Racer::new("with", || with.advance(STEPS).expect("finite states")),
    ];
    let times = race(ROUNDS, f64::from(MEMBERS) * STEPS as f64, racers);
    println!("members: {:.2}, with noise {:.2} ns a step", times.median(0), times.median(1));
    format!("ratio_friction_members={:.3}", times.ratio(1, 0))
}

/// Measures a liquid with noise and without.
fn argon() -> String {
    let (system, start) = liquid(10);
    let (atoms, steps, h) = (start.q.len() as f64, 50, 0.004);
    let mut without = system.run_with(Verlet, start.clone(), h).expect("a start").with_threads(1);
    let mut with = WarmArgon(system).run(start, h).expect("a start").with_threads(1);
    without.advance(100).expect("finite states");
    with.advance(100).expect("finite states");
    let racers = vec![
        Racer::new("without", || without.advance(steps).expect("finite states")),
        Racer::new("with", || with.advance(steps).expect("finite states")),
    ];
    let times = race(ROUNDS, atoms * steps as f64, racers);
    println!("argon: {:.1}, with noise {:.1} ns an atom and step", times.median(0), times.median(1));
    format!("ratio_friction_argon={:.3}", times.ratio(1, 0))
}

/// Measures a long chain with noise and without.
fn chain() -> String {
    let (sites, steps) = (1_000_000, 10);
    let start = || Phase::new(vec![0.0; sites], (0..sites).map(|i| (i % 7) as f64 / 7.0 - 0.4).collect::<Vec<_>>());
    let mut without = Chain.run_with(Verlet, start(), 0.1).expect("a start").with_threads(1);
    let mut with = WarmChain.run(start(), 0.1).expect("a start").with_threads(1);
    let racers = vec![
        Racer::new("without", || without.advance(steps).expect("finite states")),
        Racer::new("with", || with.advance(steps).expect("finite states")),
    ];
    let times = race(ROUNDS, sites as f64 * steps as f64, racers);
    println!("chain: {:.2}, with noise {:.2} ns a site and step", times.median(0), times.median(1));
    format!("ratio_friction_chain={:.3}", times.ratio(1, 0))
}

fn main() {
    let ratios = [members(), argon(), chain()];
    ratios.iter().for_each(|line| println!("{line}"));
}
