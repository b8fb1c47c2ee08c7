//! Benchmarks a random molecule of bonds, angles and dihedrals in lists: `cargo bench -p integrator-bench --bench molecule`.
//!
//! The generated stepper, which recognises the lists, is compared with a hand-written one for the same instructions. That one
//! gathers the atoms of a vector of terms, computes their forces in lanes, and scatters them. Times are per step, divided by
//! the number of bonds. The last line, `ratio_molecule_to_hand=`, is the median of the ratios of interleaved rounds; the target
//! is 1.1. `docs/performance.md` has the results.

use integrator_bench::{
    by_hand,
    plan::Plan,
    problems::molecule::molecule,
    race::{Racer, race},
    table::Table,
};
use integrator_core::prelude::*;
use std::error::Error;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 31;
const STEP: f64 = 0.005;
const STEPS: u64 = 50;

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("molecule", &["molecule", "unit", "generated", "by hand", "ratio"]);
    let mut lines = Vec::new();
    for (name, count) in [("terms_1000", 1000), ("terms_10000", 10_000), ("terms_100000", 100_000)] {
        let (system, start) = molecule(count);
        let plan = Plan::of::<Verlet>(STEP);
        let mut by_hand = by_hand::molecule::Molecule::new(&system, &start.q, &start.p);
        let mut run = system.run_with(Verlet, start, STEP)?.with_threads(1);
        run.advance(STEPS)?;
        let there = by_hand.advance(&plan, STEPS);
        assert!((run.state().q[0][0] - there).abs() < 1e-9, "both go the same way");
        let racers = vec![
            Racer::new("generated", || run.advance(STEPS).expect("finite states")),
            Racer::new("by hand", || by_hand.advance(&plan, STEPS)),
        ];
        let times = race(ROUNDS, (STEPS * count as u64) as f64, racers);
        table.row([name, "ns/bond/step"], &[times.median(0), times.median(1), times.ratio(0, 1)]);
        lines.push(format!("ratio_molecule_{name}={:.3}", times.ratio(0, 1)));
    }
    table.write()?;
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
