//! Measures the energy drift of Taylor runs: `cargo bench -p integrator-bench --bench taylor_drift`.
//!
//! Two dozen trajectories each of the pendulum, the Hénon–Heiles system and a Kepler orbit are integrated for 10^5 times 2π,
//! divided by the environment variable `DRIFT_DIVISOR`. Each kind of initial state and tolerance has a line with four numbers:
//! the root mean square of the energy changes relative to their mean size, the exponent of their growth with time, the mean
//! change in units of its standard error, and the mean change. An exponent of 0.5 and a mean of a few standard errors are a
//! random walk; an exponent of 1 and a mean of dozens are a bias.

use integrator_bench::problems::{HenonHeiles, Kepler, Pendulum};
use integrator_core::{
    Coords, Run,
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use std::{env, f64::consts::TAU};

/// Number of trajectories of each problem.
const MEMBERS: usize = 24;

/// Number of states over which an energy is averaged. The average removes the rounding of the energy evaluation.
const AVERAGED: usize = 32;

/// Number of energy samples; the time doubles from one to the next.
const LOOKS: u32 = 9;

/// Interval between states; a revolution takes about 2π.
const STEP: f64 = TAU / 7.0;

fn main() -> Result<(), Error> {
    let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 };
    let divisor = env::var("DRIFT_DIVISOR").ok().and_then(|divisor| divisor.parse().ok()).unwrap_or(1_u64).max(1);
    let steps = (700_000 / divisor).max(7_000);
    println!(
        "{:<12} {:<12} {:>9} {:>5}  rms at 2^-8 .. 1 of {steps} steps, exponent, bias, mean",
        "", "", "tolerance", "order"
    );
    for (tolerance, order) in [(1e-15, 18), (1e-16, 20), (1e-18, 22)] {
        let method = Taylor::tolerance(tolerance).with_order(order);
        let pendula = || (0..MEMBERS).map(|i| ([0.5 + 2.0 * share(i, 0)], [0.3 * share(i, 1)]));
        let stars =
            || (0..MEMBERS).map(|i| ([0.3 * share(i, 0), 0.3 * share(i, 1)], [0.2 * share(i, 2), 0.2 * share(i, 3)]));
        let ellipses = || {
            (0..MEMBERS).map(|i| {
                let eccentricity: f64 = 0.7 * share(i, 0);
                let velocity = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
                ([1.0 - eccentricity, 0.0], [0.0, velocity])
            })
        };
        both(&pendulum, "pendulum", method, tolerance, steps, pendula())?;
        both(&HenonHeiles, "henon_heiles", method, tolerance, steps, stars())?;
        both(&Kepler, "kepler", method, tolerance, steps, ellipses())?;
    }
    Ok(())
}

/// Returns a number between 0 and 1 for a member and one of its coordinates, from an evenly distributed sequence
/// (Weyl).
fn share(member: usize, coordinate: usize) -> f64 {
    let irrational = [0.618_033_988_749_895, 0.414_213_562_373_095, 0.732_050_807_568_877, 0.236_067_977_499_79];
    (0.5 + (member as f64 + 1.0) * irrational[coordinate]).fract()
}

/// Prints a line for plain and one for compensated initial states.
fn both<H: Hamiltonian + Recurrences>(
    system: &H,
    name: &str,
    method: Taylor,
    tolerance: f64,
    steps: u64,
    starts: impl Iterator<Item = (H::Coords, H::Coords)>,
) -> Result<(), Error> {
    let starts: Vec<_> = starts.collect();
    let plain = starts.iter().map(|(q, p)| system.run_with::<f64, _>(method, Phase::new(q.clone(), p.clone()), STEP));
    line(name, "plain", method, tolerance, steps, plain.collect::<Result<_, _>>()?)?;
    let carried = starts
        .into_iter()
        .map(|(q, p)| system.run_with::<Compensated<f64>, _>(method, Phase::<H::Coords>::compensated(q, p), STEP));
    line(name, "compensated", method, tolerance, steps, carried.collect::<Result<_, _>>()?)
}

fn line<C: Coords>(
    name: &str,
    start: &str,
    method: Taylor,
    tolerance: f64,
    steps: u64,
    mut runs: Vec<Run<C>>,
) -> Result<(), Error> {
    let begin = energies(&mut runs)?;
    // The energy of a single trajectory may be zero.
    let scale = begin.iter().map(|energy| energy.abs()).sum::<f64>() / begin.len() as f64;
    let mut looks = Vec::new();
    let mut changes = Vec::new();
    for halvings in (0..LOOKS).rev() {
        let end = steps >> halvings;
        for run in &mut runs {
            run.advance(end.saturating_sub(run.steps()))?;
        }
        let now = energies(&mut runs)?;
        changes = begin.iter().zip(&now).map(|(begin, now)| (now - begin) / scale).collect::<Vec<f64>>();
        let squares = changes.iter().map(|change| change * change).sum::<f64>();
        looks.push((end as f64, (squares / changes.len() as f64).sqrt()));
    }
    let count = changes.len() as f64;
    let mean = changes.iter().sum::<f64>() / count;
    let variance = changes.iter().map(|change| (change - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let sizes: Vec<String> = looks.iter().map(|(_, size)| format!("{size:.1e}")).collect();
    println!(
        "{name:<12} {start:<12} {tolerance:>9.0e} {:>5}  {}  exponent {:.2}  bias {:+.1}  mean {mean:+.1e}",
        method.order(),
        sizes.join(" "),
        exponent(&looks),
        mean / (variance / count).sqrt(),
    );
    Ok(())
}

/// Returns the energies, each averaged over the next states.
fn energies<C: Coords>(runs: &mut [Run<C>]) -> Result<Vec<f64>, Error> {
    runs.iter_mut()
        .map(|run| {
            let mut sum = 0.0;
            for _ in 0..AVERAGED {
                run.advance(1)?;
                sum += run.energy() / AVERAGED as f64;
            }
            Ok(sum)
        })
        .collect()
}

/// Returns the exponent of the power law through the points, by least squares of their logarithms.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = points.len() as f64;
    let (x, y) = (points.iter().map(|p| p.0).sum::<f64>() / count, points.iter().map(|p| p.1).sum::<f64>() / count);
    points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}
