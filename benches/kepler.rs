//! Benchmarks a stage along Kepler orbits, generated and hand-written: `cargo bench -p integrator-bench --bench kepler`.
//!
//! The system is the outer planets orbiting a fixed star, with a weak spring as the second part, by `Verlet`. A step is one
//! solution of Kepler's equation for five planets and little else. The last line, `ratio_kepler=`, is the generated time
//! divided by that of the hand-written stepper, the median of interleaved rounds. The target is 1.1.

use integrator_bench::{
    by_hand::orbits,
    plan::Plan,
    race::{Racer, race},
    starts::Problems,
    table::Table,
};
use integrator_core::prelude::*;

/// Steps per round, and number of rounds.
const STEPS: u64 = 20_000;
const ROUNDS: usize = 61;

fn main() {
    let (planets, start) = Problems::default().planets();
    let h = 150.0;
    let plan = Plan::of::<Verlet>(h);
    let generated = || {
        let mut run = planets.run(start, h).expect("a start");
        run.advance(STEPS).expect("finite states");
        run.state()
    };
    let by_hand = || orbits::planets(&planets, start, &plan, STEPS);
    let (found, expected) = (generated(), by_hand());
    for (found, expected) in found.q.as_flattened().iter().zip(expected.q.as_flattened()) {
        assert!((found - expected).abs() < 1e-8, "both follow the same orbits: {found} {expected}");
    }
    let times = race(ROUNDS, STEPS as f64, vec![Racer::new("generated", generated), Racer::new("by hand", by_hand)]);
    let mut table = Table::new("kepler", &["scene", "unit", "generated", "by hand", "ratio"]);
    table.row(["five planets", "ns/stage"], &[times.median(0), times.median(1), times.ratio_to_best()]);
    table.write().expect("a table");
    println!("ratio_kepler={:.3}", times.ratio_to_best());
}
