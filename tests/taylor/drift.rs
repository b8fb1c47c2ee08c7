//! How the energy drifts, over as long as a test may take; `cargo bench -p integrator-bench --bench taylor_drift` takes 10^5
//! periods.

use crate::runs::{FINE, Kepler, Pendulum, pericentre};
use integrator_core::{Coords, Run, prelude::*, taylor::Taylor};

/// Steps of the runs, of 7/8 each: some 140 periods.
const STEPS: u64 = 1_000;

/// The root of the mean squared change of energies.
fn drift<C: Coords>(runs: impl Iterator<Item = Run<C>>) -> f64 {
    let squares: Vec<f64> = runs
        .map(|mut run| {
            let energy = run.energy();
            run.advance(STEPS).expect("finite states");
            (run.energy() - energy).powi(2)
        })
        .collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

#[test]
fn energies_walk_at_random() {
    let members = || (0..8).map(f64::from);
    let method = Taylor::tolerance(FINE);
    let pendula = members().map(|i| Phase::new([1.0 + 0.125 * i], [0.0]));
    let ellipses = members().map(|i| pericentre(0.0625 * i));
    let of_pendula = drift(pendula.map(|start| Pendulum.run_with(method, start, 0.875).expect("a start")));
    let of_ellipses = drift(ellipses.map(|start| Kepler.run_with(method, start, 0.875).expect("a start")));
    // Steps of the method number a thousand on a pendulum and three on an ellipse, each of which rounds energies of
    // size one by a few units of 1e-16: the roots of these numbers make 1e-14 of them, the numbers themselves 3e-13.
    for (name, drift) in [("pendulum", of_pendula), ("ellipse", of_ellipses)] {
        assert!(drift < 3e-14, "{name}: {drift:e}");
    }
}
