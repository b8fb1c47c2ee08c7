//! Benchmarks the CPU time to a position error by splittings of the same Hamiltonian: `cargo bench -p integrator-bench --bench
//! splitting`.
//!
//! The systems are:
//!
//! - the outer solar system of `examples/data/problems.json`, by `T + V` and by Kepler parts and interaction in Jacobi
//!   coordinates;
//! - the Hénon–Heiles system, at the energy of that file and near the minimum, by `T + V` and by `quadratic + rest`;
//! - two oscillators with a coupling of 1e-2 and of 1e-4, by the same two splittings.
//!
//! `T + V` uses the compositions that are best at some error. The others use all compositions for a small second part, and some
//! of the former. Compensated states reach errors that plain states do not.
//!
//! The error is that of the positions at the end, relative to their norm. The reference is 113-bit arithmetic if the file has
//! one, else compensated steps of order 10 by `T + V`. Steps shrink by half an octave; times between are interpolated on
//! logarithmic scales. All runs are interleaved, and the median of the rounds counts. A row is a composition with its
//! milliseconds to errors of 1e-4, 1e-6, 1e-8, 1e-10 and 1e-12, empty where it does not reach the error.
//!
//! The last lines, `ratio_solar_1e-4=`, are the best row of the other splitting divided by the best row of `T + V`. Targets on
//! the outer solar system are 0.35, 0.35, 0.6 and 0.5 from 1e-4 to 1e-10.
//!
//! All compositions of a system share one loop (`check::candidates`), because a run compiled for each of them would take ten
//! seconds. Steps take as long as those of runs within 4 per cent, and 13 for `Verlet`, whose steps have one stage.

use integrator_bench::{
    problems::{CoupledOscillators, HenonHeiles, jacobi::Jacobi},
    race::{Racer, median, race},
    starts::{Problem, Problems},
    table::Table,
};
use integrator_core::{Coords, check::candidates_with, prelude::*};
use std::collections::BTreeMap;

/// Errors at which times are reported.
const ERRORS: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Minimum and maximum number of force evaluations per run, as powers of two.
const EVALUATIONS: [u32; 2] = [7, 19];
const FEWEST: u64 = 128;

/// The splitting that the others are compared with.
const SEPARABLE: &str = "T + V";

/// Number of times a run is timed; the median counts.
const ROUNDS: usize = 7;

/// Compositions for a small second part.
const NEAR_INTEGRABLE: [&str; 26] = [
    "Verlet",
    "Saba2",
    "Saba3",
    "Saba4",
    "Sbab2",
    "Sbab3",
    "Sbab4",
    "Sabac2",
    "Sabac3",
    "Sabac4",
    "Sbabc2",
    "Sbabc3",
    "Sbabc4",
    "Aba84",
    "Aba104",
    "Aba864",
    "Aba1064",
    "Abah844",
    "Abah864",
    "Abah1064",
    "BlanesCasasRos764",
    "WisdomHolmanTouma3",
    "WisdomHolmanTouma5",
    "WisdomHolmanTouma7",
    "WisdomHolmanTouma11",
    "WisdomHolmanTouma17",
];

/// Compositions for any parts, or for a first part that is quadratic in p.
const OTHERS: [&str; 7] = [
    "BlanesMoanSrkn6",
    "BlanesMoanSrkn11",
    "BlanesMoanSrkn14",
    "Teloy6B",
    "Teloy8C",
    "KahanLi8",
    "SofroniouSpaletta10",
];

/// Two oscillators with a weak coupling.
#[derive(Clone, Copy)]
struct Oscillators {
    coupling: f64,
}

#[hamiltonian]
impl Oscillators {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[0] + 2.0 * q[1] * q[1]) / 2.0 + self.coupling * q[0] * q[0] * q[1] * q[1]
    }
}

/// The same system with both oscillators as one part.
#[derive(Clone, Copy)]
struct Perturbed {
    coupling: f64,
}

#[hamiltonian(split = quadratic + rest)]
impl Perturbed {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        let oscillators = (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + 2.0 * q[1] * q[1]) / 2.0;
        oscillators + self.coupling * q[0] * q[0] * q[1] * q[1]
    }
}

/// A composition applied to a splitting.
struct Row<'p> {
    splitting: &'static str,
    composition: String,
    /// Force evaluations per step.
    each: u64,
    /// Returns the final error for a number of steps; infinite if the run fails.
    run: Box<dyn Fn(u64) -> f64 + 'p>,
    /// Errors found so far, each with its number of steps.
    path: Vec<(f64, u64)>,
    /// Milliseconds of each round, by number of steps.
    times: BTreeMap<u64, Vec<f64>>,
}

/// An initial state, and a function that converts its scalar type to `f64`.
type Begin<C, K> = (Phase<C>, fn(K) -> f64);

/// Returns the rows of a splitting for these compositions.
fn rows<'p, H, C>(
    splitting: &'static str,
    problem: &'p Problem<H>,
    (start, value): Begin<C, C::Leaf>,
    compositions: &[&[&str]],
) -> Vec<Row<'p>>
where
    H: Hamiltonian<Coords: Coords<With<C::Leaf> = C>>,
    C: Coords,
{
    let Problem { system, span, reference, .. } = problem;
    let length = start.q.flat().len();
    let mut found = candidates_with::<H, C::Leaf>(system);
    let carried = if size_of::<C::Leaf>() > size_of::<f64>() { ", compensated" } else { "" };
    let mut row = |name: &&str| {
        let place = found.iter().position(|candidate| candidate.facts().name == *name);
        let candidate = found.swap_remove(place.expect("one of the catalogue that this system admits"));
        let (start, exact) = (start.clone(), &reference[..length]);
        Row {
            splitting,
            composition: format!("{name}{carried}"),
            each: candidate.facts().forces.expect("a composition") as u64,
            run: Box::new(move |steps| {
                let Ok(mut run) = candidate.run(start.clone(), span / steps as f64) else { return f64::INFINITY };
                if run.advance(steps).is_err() {
                    return f64::INFINITY;
                }
                let state = run.state();
                let square = |sum: f64, number: f64| sum + number * number;
                let off = state.q.flat().iter().zip(exact).map(|(leaf, exact)| value(*leaf) - exact);
                (off.fold(0.0, square) / exact.iter().copied().fold(0.0, square)).sqrt()
            }),
            path: Vec::new(),
            times: BTreeMap::new(),
        }
    };
    compositions.iter().flat_map(|names| names.iter()).map(&mut row).collect()
}

impl Row<'_> {
    /// Finds the errors, and selects the runs to be timed.
    fn search(&mut self) {
        for half in 2 * EVALUATIONS[0]..2 * EVALUATIONS[1] {
            // Powers of two and 1.5 times powers of two.
            let evaluations = (2 + u64::from(half % 2)) << (half / 2 - 1);
            let steps = evaluations / self.each;
            if steps < FEWEST {
                continue;
            }
            let error = (self.run)(steps);
            let rises = self.path.last().is_some_and(|(last, _)| *last < 1e-9 && error > *last);
            self.path.push((error, steps));
            if error < ERRORS[ERRORS.len() - 1] || rises {
                break;
            }
        }
        for target in ERRORS {
            for (_, steps) in self.around(target).into_iter().flatten() {
                self.times.insert(steps, Vec::new());
            }
        }
    }

    /// Finds the first run after which all errors are below the target, and the run before it, each as error and steps.
    fn around(&self, target: f64) -> Option<[(f64, u64); 2]> {
        let first = self.path.iter().rposition(|(error, _)| *error > target).map_or(0, |last| last + 1);
        let found = *self.path.get(first)?;
        let before = first.checked_sub(1).map(|before| self.path[before]);
        Some([before.filter(|(error, _)| error.is_finite()).unwrap_or(found), found])
    }

    /// Times each selected run once more.
    fn time(&mut self) {
        for (steps, times) in &mut self.times {
            // Per million units, nanoseconds become milliseconds.
            times.push(race(1, 1e6, vec![Racer::new("", || (self.run)(*steps))]).median(0));
        }
    }

    /// Returns the milliseconds to an error.
    fn time_to(&self, target: f64) -> f64 {
        let Some([(before, longer), (error, steps)]) = self.around(target) else { return f64::NAN };
        let [longer, shorter] = [longer, steps].map(|steps| median(self.times[&steps].clone()));
        let share = if before == error { 1.0 } else { (target / before).ln() / (error / before).ln() };
        longer.powf(1.0 - share) * shorter.powf(share)
    }
}

/// Measures a problem: the rows by `T + V` and those by another splitting.
fn measure(table: &mut Table, problem: &str, mut all: Vec<Row<'_>>) {
    all.iter_mut().for_each(Row::search);
    for _ in 0..ROUNDS {
        all.iter_mut().for_each(Row::time);
    }
    for row in &all {
        let name = format!("{problem}, {}", row.splitting);
        table.row([&name, &row.composition], &ERRORS.map(|target| row.time_to(target)));
    }
    let best = |separable: bool, target| {
        let rows = all.iter().filter(|row| (row.splitting == SEPARABLE) == separable);
        let times = rows.map(|row| (row.time_to(target), &row.composition));
        times.filter(|(time, _)| !time.is_nan()).min_by(|a, b| a.0.total_cmp(&b.0))
    };
    for target in ERRORS {
        if let (Some((ours, by)), Some((theirs, against))) = (best(false, target), best(true, target)) {
            let ratio = ours / theirs;
            println!("ratio_{problem}_{target:e}={ratio:.3} ({by}, {ours:.4} ms, over {against}, {theirs:.4} ms)");
        }
    }
}

fn plain<C>(start: Phase<C>) -> Begin<C, f64> {
    (start, |leaf| leaf)
}

fn compensated<const N: usize>(start: Phase<[f64; N]>) -> Begin<[Compensated<f64>; N], Compensated<f64>> {
    (Phase::compensated(start.q, start.p), |leaf| leaf.value)
}

/// The outer solar system.
fn solar(table: &mut Table) {
    let separable = Problems::default().solar();
    let Problem { start, span, ref reference, ref system, .. } = separable;
    let (system, reference) = (Jacobi { masses: system.masses }, reference.clone());
    let jacobi = Problem { name: "solar", system, start, span, reference };
    let carried = || -> Begin<_, Compensated<f64>> { (Phase::compensated(start.q, start.p), |leaf| leaf.value) };
    let mut all = rows("jacobi", &jacobi, plain(start), &[&NEAR_INTEGRABLE, &OTHERS]);
    all.extend(rows("jacobi", &jacobi, carried(), &[&["Aba1064", "Aba104", "BlanesCasasRos764"]]));
    all.extend(rows(SEPARABLE, &separable, plain(start), &[&OTHERS]));
    all.extend(rows(SEPARABLE, &separable, carried(), &[&["Teloy8C", "SofroniouSpaletta10"]]));
    measure(table, "solar", all);
}

/// Measures a system of two degrees of freedom.
fn plane<H, Q>(table: &mut Table, separable: &Problem<H>, quadratic: Q)
where
    H: Hamiltonian<Coords = [f64; 2]>,
    Q: Hamiltonian<Coords = [f64; 2]>,
{
    let Problem { name, start, span, ref reference, .. } = *separable;
    let solved = Problem { name, system: quadratic, start, span, reference: reference.clone() };
    let mut all = rows("quadratic", &solved, plain(start), &[&NEAR_INTEGRABLE, &OTHERS]);
    all.extend(rows("quadratic", &solved, compensated(start), &[&["Aba1064", "SofroniouSpaletta10"]]));
    all.extend(rows(SEPARABLE, separable, plain(start), &[&OTHERS]));
    all.extend(rows(SEPARABLE, separable, compensated(start), &[&["Teloy8C", "SofroniouSpaletta10"]]));
    measure(table, name, all);
}

/// A problem without stored reference; compensated steps of order 10 by `T + V` provide it.
fn followed<H: Hamiltonian<Coords = [f64; 2]>>(
    name: &'static str,
    system: H,
    start: Phase<[f64; 2]>,
    span: f64,
) -> Problem<H> {
    const STEPS: u64 = 1 << 15;
    let carried = compensated(start).0;
    let mut run = system.run_with(SofroniouSpaletta10, carried, span / STEPS as f64).expect("a start");
    run.advance(STEPS).expect("finite states");
    let reference = run.state().q.map(|leaf| leaf.value).to_vec();
    Problem { name, system, start, span, reference }
}

fn main() {
    let mut table = Table::new("splitting", &["splitting", "composition", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12"]);
    solar(&mut table);
    let henon = Problems::default().henon_heiles();
    plane(&mut table, &henon, CoupledOscillators);
    let near = Phase::new(henon.start.q.map(|q| q / 16.0), henon.start.p.map(|p| p / 16.0));
    plane(&mut table, &followed("henon_near_rest", HenonHeiles, near, henon.span), CoupledOscillators);
    let start = Phase::new([1.0, 0.5], [0.0, 0.8]);
    for (name, coupling) in [("perturbed_1e-2", 1e-2), ("perturbed_1e-4", 1e-4)] {
        let separable = followed(name, Oscillators { coupling }, start, 1000.0);
        plane(&mut table, &separable, Perturbed { coupling });
    }
    table.write().expect("a table");
}
