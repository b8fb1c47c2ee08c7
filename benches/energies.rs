//! Compares energies and changed states with steps: `cargo bench -p integrator-bench --bench energies`.
//!
//! Per layout: a step of `Verlet`, `Run::energy`, `Run::map_state`, which checks the energy of the changed state, and a new run.
//! Times are medians of interleaved rounds on one thread, in microseconds. The last lines are the ratios of the energy
//! (`ratio_energy_<layout>=`) and of the changed state (`ratio_changed_<layout>=`) to a step; the targets are 1.3 and 1.5.
//! For an ensemble they are those of all members.

use integrator_bench::{
    problems::{Phi4Plane, SineGordon},
    race::{Racer, race},
    starts::{cluster, liquid, rows_of_waves, waves},
    table::Table,
};
use integrator_core::{Coords, prelude::*};
use std::{cell::RefCell, error::Error, hint::black_box};

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 11;

struct Posterior {
    covariates: Vec<f64>,
    outcomes: Vec<f64>,
}

#[hamiltonian]
impl Posterior {
    fn kinetic(&self, p: [f64; 21]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, b: [f64; 21]) -> f64 {
        let mut energy = 0.0;
        for row in 0..self.outcomes.len() {
            let mut z = b[0];
            for k in 0..20 {
                z += self.covariates[row * 20 + k] * b[k + 1];
            }
            energy += z.exp().ln_1p() - self.outcomes[row] * z;
        }
        energy
    }
}

fn posterior() -> Posterior {
    Posterior {
        covariates: (0..20_000).map(|k| (0.7 * f64::from(k)).sin()).collect(),
        outcomes: (0..1_000).map(|row| f64::from(row % 2)).collect(),
    }
}

struct Report {
    table: Table,
    lines: Vec<String>,
}

impl Report {
    /// Adds the times of a layout.
    fn add(&mut self, layout: &str, count: u32, racers: Vec<Racer<'_>>) {
        let times = race(ROUNDS, f64::from(count) * 1e3, racers);
        for (racer, name) in times.names().iter().enumerate() {
            self.table.row([layout, name], &[times.median(racer), times.ratio(racer, 0)]);
        }
        self.lines.push(format!("ratio_energy_{layout}={:.3}", times.ratio(1, 0)));
        self.lines.push(format!("ratio_changed_{layout}={:.3}", times.ratio(2, 0)));
    }

    fn run<H: Hamiltonian<Coords = C>, C>(&mut self, layout: &str, system: &H, start: &Phase<C>, count: u32)
    where
        C: Coords<Leaf = f64, With<f64> = C>,
    {
        let new = || system.run(start.clone(), 0.001).expect("a good start").with_threads(1);
        let run = RefCell::new(new());
        run.borrow_mut().advance(3).expect("finite states");
        let step = || run.borrow_mut().advance(1).expect("finite states");
        let energy = || black_box(run.borrow().energy());
        let change = || run.borrow_mut().map_state(|state| *state = state.reversed()).expect("a finite state");
        let racers = vec![
            Racer::new("step", || (0..count).for_each(|_| step())),
            Racer::new("energy", || (0..count).map(|_| energy()).sum::<f64>()),
            Racer::new("changed state", || (0..count).for_each(|_| change())),
            Racer::new("new run", || (0..count).for_each(|_| drop(black_box(new())))),
        ];
        self.add(layout, count, racers);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let table = Table::new("energies", &["layout", "what", "us", "to a step"]);
    let mut report = Report { table, lines: Vec::new() };
    let ((stars, at_stars), (argon, at_argon)) = (cluster(216), liquid(13));
    report.run("pairs", &stars, &at_stars, 20);
    report.run("lists", &argon, &at_argon, 2);
    report.run("line", &SineGordon { stiffness: 1.0 }, &waves(4_000), 50);
    report.run("plane", &Phi4Plane { stiffness: 1.0 }, &rows_of_waves(64), 50);
    report.run("regression", &posterior(), &Phase::new([0.01; 21], [0.1; 21]), 20);
    let members = || (0..16).map(|member| (posterior(), Phase::new([0.01 * f64::from(member); 21], [0.1; 21])));
    let new = || Ensemble::new(Verlet, members(), 0.01).expect("good starts").with_threads(1);
    let swarm = RefCell::new(new());
    let racers = vec![
        Racer::new("step", || swarm.borrow_mut().advance(1).expect("finite states")),
        Racer::new("energy", || swarm.borrow().energies()),
        Racer::new("changed state", || {
            swarm.borrow_mut().map_states(|_, state| *state = state.reversed()).expect("finite");
        }),
        Racer::new("new run", || drop(black_box(new()))),
    ];
    report.add("members", 1, racers);
    report.table.write()?;
    report.lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
