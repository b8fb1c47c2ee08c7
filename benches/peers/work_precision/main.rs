//! Benchmarks CPU time against error, compared with other crates: `cargo bench -p integrator-bench --bench work_precision`.
//!
//! Each method integrates each of the five problems with decreasing steps or tolerances. A run gives its CPU time, the largest
//! relative energy error of 256 samples, and the distance of the end from the reference. Times to an error are interpolated
//! between runs. The last lines:
//!
//! - `time_ms_<problem>_<kind>_<error>=` is the time of the best method of this library.
//! - `ratio_to_best_peer_...=` is this time divided by that of the best peer. The target is 0.5 at energy errors of 1e-6 and
//!   1e-8.
//! - `ratio_taylor_to_best_composition_...=` is the time of Taylor's method divided by that of the best composition.
//!
//! Pictures go to `target/bench`.

mod ours;

use integrator_bench::{
    plot,
    precision::{Curve, Kind, best},
    starts::{Problem, Problems},
    table::{Table, folder},
};
use integrator_core::{Coords, Hamiltonian, QuadraticKinetic, taylor::Recurrences};
use integrator_peers::{
    curves,
    fields::{self, Case, Field},
};
use ours::TAYLOR;
use std::error::Error;

const ERRORS: [(f64, &str); 5] = [(1e-4, "1e-4"), (1e-6, "1e-6"), (1e-8, "1e-8"), (1e-10, "1e-10"), (1e-12, "1e-12")];
const KINDS: [(Kind, &str); 2] = [(Kind::Energy, "energy"), (Kind::Global, "global")];

struct Report {
    runs: Table,
    choices: Vec<String>,
    lines: Vec<String>,
}

impl Report {
    fn problem<H: Hamiltonian + QuadraticKinetic + Recurrences, F: Field<D>, const D: usize, const N: usize>(
        &mut self,
        title: &str,
        problem: &Problem<H>,
        case: &Case<F, D>,
        evaluations: u64,
    ) -> Result<(), Box<dyn Error>>
    where
        H::Coords: Coords<Leaf = f64>,
    {
        let mut curves = ours::curves(problem, evaluations);
        curves.extend(curves::curves::<F, D, N>(case, evaluations));
        for curve in &curves {
            for point in &curve.points {
                self.runs.row([problem.name, &curve.method], &[point.milliseconds, point.energy, point.global]);
            }
        }
        for (kind, name) in KINDS {
            for (error, text) in ERRORS {
                self.compare(&format!("{}_{name}_{text}", problem.name), &curves, kind, error);
            }
            let file = folder().join(format!("work_precision_{}_{name}", problem.name));
            plot::work_precision(&file, title, &curves, kind)?;
        }
        Ok(())
    }

    fn compare(&mut self, what: &str, curves: &[Curve], kind: Kind, error: f64) {
        let (ours, peers): (Vec<&Curve>, Vec<&Curve>) = curves.iter().partition(|curve| curve.ours);
        let (taylor, compositions): (Vec<&Curve>, Vec<&Curve>) =
            ours.iter().partition(|curve| curve.method.starts_with(TAYLOR));
        if let Some(((taylor, _), (composition, _))) = best(taylor, kind, error).zip(best(compositions, kind, error)) {
            self.lines.push(format!("ratio_taylor_to_best_composition_{what}={:.3}", taylor / composition));
        }
        let Some((time, method)) = best(ours, kind, error) else { return };
        self.lines.push(format!("time_ms_{what}={time:.4}"));
        let Some((peer, other)) = best(peers, kind, error) else {
            self.choices.push(format!("{what:<24} {time:>10.4} ms  {method}; no peer arrives"));
            return;
        };
        self.choices.push(format!("{what:<24} {time:>10.4} ms  {method}; {peer:.4} ms by {other}"));
        self.lines.push(format!("ratio_to_best_peer_{what}={:.3}", time / peer));
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let table = Table::new("work_precision", &["problem", "method", "ms", "energy", "global"]);
    let mut report = Report { runs: table, choices: Vec::new(), lines: Vec::new() };
    let problems = Problems::default();
    let title = "Pendulum, 120 large oscillations";
    report.problem::<_, _, 1, 2>(title, &problems.pendulum(), &fields::pendulum(&problems), 1 << 10)?;
    let title = "Hénon–Heiles, E = 0.13, t = 999";
    report.problem::<_, _, 2, 4>(title, &problems.henon_heiles(), &fields::henon_heiles(&problems), 1 << 10)?;
    let title = "Kepler, e = 0.6, 1000 periods";
    report.problem::<_, _, 2, 4>(title, &problems.kepler(), &fields::kepler(&problems), 1 << 16)?;
    let title = "Outer solar system, 2738 years";
    report.problem::<_, _, 18, 36>(title, &problems.solar(), &fields::solar(&problems), 1 << 10)?;
    let title = "FPUT chain of 32 sites, t = 9999";
    report.problem::<_, _, 32, 64>(title, &problems.chain(), &fields::chain(&problems), 1 << 14)?;
    report.runs.write()?;
    println!("\nThe fastest to each error, and the fastest of the peers:");
    report.choices.iter().for_each(|line| println!("{line}"));
    report.lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
