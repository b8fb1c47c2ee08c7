//! Benchmarks a force evaluation inside every composition, relative to `Verlet`: `cargo bench -p integrator-bench --bench
//! compositions`.
//!
//! A run loops over a static table of stages, so a step of 35 stages should cost 35 times a step of `Verlet`. The last lines,
//! `ratio_<problem>_<composition>=`, are nanoseconds per force evaluation divided by those of `Verlet` in the same round,
//! medians of interleaved rounds. The target is 1.03. Measured: 0.85 to 1.01 on the pendulum and at most 1.01 on Hénon–Heiles,
//! Kepler and the outer solar system. On FPUT-32 a longer table costs 1.05 if a kick comes first and 1.08 to 1.12 if a drift
//! does.
//!
//! A gradient of the squared force does not count as an evaluation here. Hence the ratios of compositions in which every kick
//! has one (`Chin4B`) show its cost. A kick with gradient takes the time of 1.3 forces on the pendulum, 1.6 on Kepler, 2 on
//! Hénon–Heiles, 3.6 on FPUT-32 and 4.9 on the outer solar system.
//!
//! A table costs little to compile. A program that runs the outer solar system by ten compositions takes 2.1 s of CPU time in
//! release mode without libraries, and 0.6 s by one; the target is 4 s.

use integrator_bench::{
    race::{Racer, race},
    starts::{Problem, Problems},
};
use integrator_core::{Coords, Visitor, prelude::*};

/// Force evaluations per computation; divisible by the number of kicks of nearly every composition.
const EVALUATIONS: u64 = 2 * 2 * 2 * 3 * 3 * 5 * 7 * 11;

/// Step scale so small that every composition stays on the orbit.
const SHORTENING: f64 = 1e-6;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 41;

struct Ratios<'p, H: Hamiltonian> {
    problem: &'p Problem<H>,
    lines: Vec<String>,
}

impl<H: Hamiltonian> Visitor<H> for Ratios<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    fn visit<X: Composition<H>>(&mut self, _: X) {
        let racers = vec![self.evaluated::<X>(X::NAME), self.evaluated::<Verlet>("Verlet")];
        let times = race(ROUNDS, EVALUATIONS as f64, racers);
        println!("{:<10} {:<24} {:>8.2} {:>8.2}", self.problem.name, X::NAME, times.median(0), times.median(1));
        self.lines.push(format!("ratio_{}_{}={:.3}", self.problem.name, X::NAME, times.ratio(0, 1)));
    }
}

impl<H: Hamiltonian> Ratios<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    /// Takes enough steps for the given number of force evaluations. Every round continues from the previous one.
    fn evaluated<X: Composition<H>>(&self, name: &'static str) -> Racer<'static> {
        let Problem { system, start, span, .. } = self.problem;
        let run = system.run_with::<f64, X>(X::default(), start.clone(), span * SHORTENING);
        let mut run = run.expect("a start");
        Racer::new(name, move || run.advance(EVALUATIONS / X::FORCE_EVALUATIONS as u64).expect("finite states"))
    }
}

/// Compares all compositions that the problem supports, and prints nanoseconds per force evaluation.
fn measure<H: Hamiltonian>(problem: &Problem<H>) -> Vec<String>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut ratios = Ratios { problem, lines: Vec::new() };
    H::visit_compositions(&mut ratios);
    ratios.lines
}

fn main() {
    println!("{:<35} {:>8} {:>8}   ns per force evaluation", "", "", "Verlet");
    let problems = Problems::default();
    let lines = [
        measure(&problems.pendulum()),
        measure(&problems.henon_heiles()),
        measure(&problems.kepler()),
        measure(&problems.solar()),
        measure(&problems.chain()),
    ];
    lines.concat().iter().for_each(|line| println!("{line}"));
}
