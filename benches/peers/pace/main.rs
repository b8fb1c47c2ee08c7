//! Benchmarks the CPU time to a position error on eccentric orbits, compared with other crates: `cargo bench -p
//! integrator-peers --features peers --bench pace`.
//!
//! Two bodies are integrated over 1000 periods at eccentricities of 0.6 and 0.9, as in the bench `pace` of this library alone.
//! Errors are distances from the closed form at the end, in units of the semi-major axis. A row is a method with its
//! milliseconds of CPU time to errors of 1e-2, 1e-4, 1e-6, 1e-8 and 1e-10, empty where it does not reach the error within 300
//! ms. `ratio_pace_logarithmic_over_best_peer_0.6=` and similar lines are ratios of times to 1e-4.

use integrator_bench::{
    precision::{Curve, Kind, best},
    table::Table,
};
use integrator_core::{Method, prelude::*, taylor::Taylor};
use integrator_peers::{
    curves::curves,
    fields::{Case, Kepler},
};
use std::{error::Error, f64::consts::TAU, hint::black_box};

/// Errors at which times are reported.
const ERRORS: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
/// Force evaluations of the other crates' runs with the longest steps.
const EVALUATIONS: u64 = 1 << 15;

struct TwoBodies;

#[hamiltonian(taylor)]
impl TwoBodies {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// Starts at the pericentre; the orbit ends there as well.
fn orbit(e: f64) -> Case<Kepler, 2> {
    let q = [1.0 - e, 0.0];
    Case { field: Kepler, q, v: [0.0, ((1.0 + e) / (1.0 - e)).sqrt()], span: 1_000.0 * TAU, reference: q.to_vec() }
}

/// Measures a method of this library; `method` returns the method and its step at each level.
fn ours<X: Method<TwoBodies>>(case: &Case<Kepler, 2>, name: &str, method: impl Fn(i32) -> (X, f64)) -> Curve {
    let end = |level: u32| {
        let (method, h) = method(level as i32);
        let mut run = TwoBodies.run_with::<f64, X>(method, Phase::new(case.q, case.v), h).ok()?;
        run.advance_to(case.span).ok()?;
        Some(run.state())
    };
    let errors = |level| {
        let Phase { q, p } = end(level)?;
        Some([case.energy_error(&q, &p), case.global_error(&q)])
    };
    Curve::measure(name.to_owned(), true, 0..30, errors, |level| {
        black_box(end(level));
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("pace_peers", &["orbit", "method", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10"]);
    for (name, e) in [("0.6", 0.6), ("0.9", 0.9)] {
        let case = orbit(e);
        let step = |longest: f64, level: i32| longest * 0.5_f64.powf(f64::from(level) / 2.0);
        let logarithmic = ours(&case, "Logarithmic(SofroniouSpaletta10)", |level| {
            (Logarithmic(SofroniouSpaletta10), step(3.2, level))
        });
        let paced = ours(&case, "Paced(SofroniouSpaletta8)", |level| (Paced(SofroniouSpaletta8), step(1.6, level)));
        let taylor = ours(&case, "Taylor 20", |level| {
            let method = Taylor::tolerance(10.0_f64.powf(-3.0 - f64::from(level) / 2.0)).with_order(20);
            (method, case.span / 100.0)
        });
        let peers = curves::<_, 2, 4>(&case, EVALUATIONS);
        // Errors of a case are relative to the norm of the final position, which is `1 - e`.
        let time_to = |curve: &Curve, error: f64| curve.time_to(Kind::Global, error / (1.0 - e));
        for curve in [&logarithmic, &paced, &taylor].into_iter().chain(&peers) {
            let times = ERRORS.map(|error| time_to(curve, error).unwrap_or(f64::NAN));
            table.row([name, &curve.method], &times);
        }
        let peer = best(&peers, Kind::Global, 1e-4 / (1.0 - e));
        if let Some((time, (peer, method))) = time_to(&logarithmic, 1e-4).zip(peer) {
            println!("ratio_pace_logarithmic_over_best_peer_{name}={:.3} ({method})", time / peer);
        }
    }
    table.write()?;
    Ok(())
}
