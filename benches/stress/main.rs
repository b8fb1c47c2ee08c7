//! Runs long and hard cases and invalid input: `cargo bench -p integrator-bench --bench stress`.
//!
//! The full bench takes about two hours on two cores. The environment variable `STRESS_DIVISOR=1000` shortens all runs by this
//! factor; exponents become less certain. Tables and a picture of the growth of rounding errors go to `target/bench`.
//!
//! The last lines are `brouwer_exponent_<problem>=` (growth of the energy error with the number of steps; 0.4 to 0.6 is
//! expected), `brouwer_bias_<problem>=` (mean error in units of its standard error; within ±4), and numbers of failures, which
//! have to be zero. `docs/reliability.md` lists every promise.

mod brouwer;
mod chaos;
mod encounters;
mod hostile;
mod interruption;
mod limits;
mod reversal;

use brouwer::Growth;
use integrator_bench::{
    plot::{self, Growing},
    problems::{HenonHeiles, Pendulum},
    starts::Problems,
    table::{Table, folder},
};
use integrator_core::prelude::*;
use std::{
    env,
    error::Error as Failure,
    panic::{AssertUnwindSafe, catch_unwind},
    process::Command,
};

/// Steps of the pendulum and of a star in a galaxy; `PLANETARY`: those of a Kepler part and of the outer solar system.
const LONG: u64 = 1_000_000_000;
const PLANETARY: u64 = 100_000_000;

/// A Kepler part, and another part with no effect.
struct Revolving {
    rest: f64,
}

#[hamiltonian(split = kepler + rest, compose = Euler)]
impl Revolving {
    fn kepler(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt()
    }
    fn rest(&self, q: [f64; 2]) -> f64 {
        self.rest * q[0]
    }
}

/// Number of trajectories for the growth of errors: with two threads, one vector of `f32` or two of `f64` per thread.
const MEMBERS: usize = 32;

fn main() -> Result<(), Box<dyn Failure>> {
    if chaos::answer() || interruption::answer() {
        return Ok(());
    }
    let divisor = env::var("STRESS_DIVISOR").ok().and_then(|divisor| divisor.parse().ok()).unwrap_or(1_u64).max(1);
    let size = |full: u64, least: u64| (full / divisor).max(least);
    let again = || Ok(Command::new(env::current_exe()?));
    let mut report = Report::default();

    report.part("limits", |lines| limits_table(size(100_000, 2_000), lines));
    report.part("encounters", |lines| encounters_table(size(10_000_000, 100_000), lines));
    report.part("reversal", |lines| reversal_table(size(1_000_000, 1_000), lines));
    report.part("chaos", |lines| {
        let steps = size(10_000_000, 10_000);
        lines.push(format!("members_differing={}", chaos::members_differing(steps / 100)?));
        lines.push(format!("instruction_sets_differing={}", chaos::sets_differing(steps, again)?));
        Ok(())
    });
    report.part("brouwer", |lines| brouwer_table(size(LONG, 100_000), size(PLANETARY, 100_000), lines));
    report.part("interruption", |lines| {
        lines.push(format!("kill_resume_failures={}", interruption::failures(size(1_000, 20), again)?));
        lines.push(format!("bitflip_accepted={}", interruption::damaged_accepted(7)?));
        Ok(())
    });
    report.panics += hostile::panics(size(100_000, 1_000));
    report.print();
    Ok(())
}

/// Final lines and failures.
#[derive(Default)]
struct Report {
    lines: Vec<String>,
    panics: u64,
}

impl Report {
    /// Runs one part of the bench and collects its last lines. Panics are counted, and the other parts continue.
    fn part(&mut self, name: &str, run: impl FnOnce(&mut Vec<String>) -> Result<(), Box<dyn Failure>>) {
        println!("\n{name}");
        match catch_unwind(AssertUnwindSafe(|| run(&mut self.lines))) {
            Ok(Ok(())) => {}
            Ok(Err(error)) => self.lines.push(format!("{name}_failed={error}")),
            Err(_) => self.panics += 1,
        }
    }

    fn print(&self) {
        println!();
        for line in &self.lines {
            println!("{line}");
        }
        println!("panics={}", self.panics);
    }
}

fn limits_table(steps: u64, lines: &mut Vec<String>) -> Result<(), Box<dyn Failure>> {
    let angles: Vec<f64> = (1..=25).map(|tenths| f64::from(tenths) / 10.0).collect();
    let trials = limits::trials(&angles, steps);
    let mut table = Table::new("stress_limits", &["composition", "outcome", "h·ω", "limit"]);
    for trial in &trials {
        table.row([trial.composition, &format!("{:?}", trial.outcome)], &[trial.angle, trial.limit]);
    }
    table.write()?;
    lines.push(format!("stability_wrong={}", trials.iter().filter(|trial| trial.is_wrong()).count()));
    Ok(())
}

fn encounters_table(steps: u64, lines: &mut Vec<String>) -> Result<(), Box<dyn Failure>> {
    let resolved = encounters::resolved(steps);
    let unresolved = encounters::unresolved(steps, &[0.01, 1e-3, 1.0 / 1024.0], &[0.05, 0.01, 2e-3]);
    let mut table = Table::new("stress_encounters", &["orbit", "outcome"]);
    for encounter in resolved.iter().chain(&unresolved) {
        table.row([&encounter.name, &encounter.outcome.to_string()], &[]);
    }
    table.write()?;
    let lost = resolved.iter().filter(|encounter| !encounter.is_right()).count();
    let silent = unresolved.iter().filter(|encounter| encounter.is_silently_wrong()).count();
    lines.push(format!("resolved_orbits_lost={lost}"));
    lines.push(format!("silently_wrong={silent}"));
    Ok(())
}

fn reversal_table(steps: u64, lines: &mut Vec<String>) -> Result<(), Box<dyn Failure>> {
    let returns = reversal::returns(steps)?;
    let mut table = Table::new("stress_reversal", &["composition", "", "bits lost", "in f64"]);
    for found in &returns {
        table.row([found.composition, ""], &[f64::from(found.bits_lost), found.distance]);
    }
    table.write()?;
    lines.push(format!("reversible_bits_lost={}", returns.iter().map(|found| found.bits_lost).sum::<u32>()));
    Ok(())
}

/// Steps so short that the error of the composition is below the rounding of the energy.
fn brouwer_table(long: u64, planetary: u64, lines: &mut Vec<String>) -> Result<(), Box<dyn Failure>> {
    let pendula = (0..MEMBERS).map(|member| {
        let start = Phase::compensated([1.0 + 0.02 * member as f64], [0.1]);
        (Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 }, start)
    });
    let stars = (0..MEMBERS).map(|member| {
        let offset = 0.005 * member as f64;
        (HenonHeiles, Phase::compensated([0.0, 0.1 + offset], [0.3, 0.05]))
    });
    let planets = Problems::default().solar();
    let systems = (0..MEMBERS).map(|member| {
        // Slightly different velocities, except for the Sun.
        let mut p = planets.start.p;
        for momentum in &mut p[1..] {
            *momentum = momentum.map(|p| p * (1.0 + 1e-4 * member as f64));
        }
        (planets.system, Phase::compensated(planets.start.q, p))
    });
    let bodies = (0..MEMBERS).map(|member| {
        // Starts at the pericentre, with eccentricities up to 0.3.
        let start = Phase { q: [1.0, 0.0], p: [0.0, (1.0 + 0.01 * member as f64).sqrt()] };
        (Revolving { rest: 0.0 }, start)
    });
    let growths = [
        ("kepler_part", brouwer::growth(Ensemble::new(Euler, bodies, 1.0)?, planetary)?),
        ("pendulum", brouwer::growth(Ensemble::new(SofroniouSpaletta10, pendula, 0.1)?, long)?),
        ("henon", brouwer::growth(Ensemble::new(SofroniouSpaletta10, stars, 0.1)?, long)?),
        ("solar", brouwer::growth(Ensemble::new(SofroniouSpaletta10, systems, 50.0)?, planetary)?),
    ];
    let curves = growths.iter().map(|(problem, growth)| Growing {
        name: format!("{}: {:.2}", plot::named(problem), growth.exponent),
        points: growth.looks.iter().map(|(steps, change)| (*steps as f64, *change)).collect(),
    });
    let title = "Rounding errors of the energy grow like a random walk";
    plot::growth(&folder().join("stress_brouwer"), title, &curves.collect::<Vec<_>>())?;
    let mut table = Table::new("stress_brouwer", &["problem", "", "steps", "energy error"]);
    for (problem, Growth { looks, exponent, bias }) in growths {
        for (steps, change) in looks {
            table.row([problem, ""], &[steps as f64, change]);
        }
        lines.push(format!("brouwer_exponent_{problem}={exponent:.3}"));
        lines.push(format!("brouwer_bias_{problem}={bias:.2}"));
    }
    Ok(table.write()?)
}
