//! A picture of each kind that `integrator-plot` draws of runs, in one line each.
//!
//! Look at `gallery_energies`: the energy of forward Euler leaves the picture upwards and that of backward Euler downwards,
//! Runge and Kutta's method loses a little in every swing, and those of the symplectic methods stay where they are. In
//! `gallery_orbit` an ellipse turns, because steps are long; in `gallery_phase` blue motions stay in their wells, and orange ones
//! go over the hill; in `gallery_section` there are islands in a sea; `gallery_map` is how long a star stays in a galaxy from
//! which it can escape, black where it does so at once.

mod systems;

use integrator_core::{
    Method,
    prelude::*,
    reference::{BackwardEuler, ForwardEuler, RungeKutta4},
};
use integrator_plot as plot;
use std::{env, error::Error, path::PathBuf};
use systems::{DoubleWell, HenonHeiles, Kepler, Pendulum};

fn swing(method: impl Method<Pendulum>) -> Result<Vec<Sample<[f64; 1]>>, integrator_core::Error> {
    Pendulum.run_with(method, Phase::new([2.0], [0.0]), 0.2)?.samples(1).take(840).collect()
}

/// From the bottoms of two wells, with different momenta. The hill between them is 1 high.
fn wells() -> Result<plot::Chart, integrator_core::Error> {
    let within = [0.5, 1.0, 1.35].into_iter().flat_map(|p| [(1.0, p), (-1.0, p)]);
    within.chain([(1.0, 1.5), (1.0, 2.0)]).try_fold(plot::phase::<[f64; 1]>(&[]), |chart, (q, p)| {
        let run = DoubleWell.run_with(Yoshida4, Phase::new([q], [p]), 0.02)?;
        let colour = plot::colour::COLOURS[if run.energy() < 1.0 { 6 } else { 3 }];
        let samples = run.samples(1).take(400).collect::<Result<Vec<_>, _>>()?;
        let points = samples.iter().map(|sample| (sample.state.q[0], sample.state.p[0]));
        Ok(chart.line("", points).coloured(colour).wide(1.5))
    })
}

/// Where orbits of a star of some energy pass x = 0 to the right.
fn section(energy: f64) -> Result<Vec<(f64, f64)>, integrator_core::Error> {
    let mut points = Vec::new();
    let along_y = (0..24).map(|i| (-0.4 + 0.045 * f64::from(i), 0.0));
    // Islands that no star without a momentum along y meets.
    let beside = [0.20, 0.22, 0.24, 0.26, 0.28].into_iter().flat_map(|py| [(0.0, py), (0.0, -py)]);
    for (y, py) in along_y.chain(beside) {
        let Some(start) = HenonHeiles.start(energy, y, py) else { continue };
        let run = HenonHeiles.run_with(BlanesMoanSrkn6, start, 0.2)?;
        for point in run.crossings(20_000, Direction::Rising, |state, _| state.q[0]) {
            let state = point?.state;
            points.push((state.q[1], state.p[1]));
        }
    }
    Ok(points)
}

/// How long a star stays within a distance of 3; not a number where there is no start.
fn stay(energy: f64, y: f64, py: f64) -> Result<f64, integrator_core::Error> {
    let Some(start) = HenonHeiles.start(energy, y, py) else { return Ok(f64::NAN) };
    let mut run = HenonHeiles.run_with(BlanesMoanSrkn6, start, 0.25)?;
    while run.time() < 100.0 {
        run.advance(2)?;
        let [x, y] = run.state().q;
        if x * x + y * y > 9.0 {
            break;
        }
    }
    Ok(run.time())
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().skip_while(|argument| argument != "--out").nth(1);
    let folder = PathBuf::from(folder.as_deref().unwrap_or("target/pictures"));
    let runs = [
        ("forward Euler", swing(ForwardEuler)?),
        ("backward Euler", swing(BackwardEuler)?),
        ("Runge–Kutta 4", swing(RungeKutta4)?),
        ("Verlet", swing(Verlet)?),
        ("Yoshida 4", swing(Yoshida4)?),
        ("Blanes–Moan 6", swing(BlanesMoan6)?),
    ];
    plot::energies(runs.iter().map(|(name, samples)| (*name, samples)))
        .title("The energy of a pendulum in steps of 0.2")
        .save(folder.join("gallery_energies.svg"))?;

    let run = Kepler.run_with(Verlet, Phase::new([1.6, 0.0], [0.0, 0.5]), 0.08)?;
    // Between the steps as well: the line is round however long these are.
    let orbit = run.samples_at(0.02).take(3_600).collect::<Result<Vec<_>, _>>()?;
    plot::orbit(&orbit).title("An ellipse by Verlet").save(folder.join("gallery_orbit.svg"))?;
    wells()?.title("A double well").save(folder.join("gallery_phase.svg"))?;

    let axes = |chart: plot::Chart| chart.along(plot::Axis::linear("y")).up(plot::Axis::linear("ẏ"));
    let chart = plot::section_of(section(1.0 / 8.0)?).title("Hénon and Heiles at an energy of 1/8");
    axes(chart).save(folder.join("gallery_section.svg"))?;

    let (columns, rows) = (300_u32, 260_u32);
    let at =
        |i: u32, count: u32, ends: [f64; 2]| ends[0] + (f64::from(i) + 0.5) / f64::from(count) * (ends[1] - ends[0]);
    let row = |j| (0..columns).map(move |i| stay(0.2, at(i, columns, [-0.6, 1.1]), at(j, rows, [-0.7, 0.7]))).collect();
    let rows = (0..rows).map(row).collect::<Result<Vec<Vec<f64>>, _>>()?;
    let chart = plot::map(-0.6..=1.1, -0.7..=0.7, "time until it escapes, at most 100", rows);
    axes(chart.title("Stars of energy 1/5")).save(folder.join("gallery_map.png"))?;
    println!("{}", folder.display());
    Ok(())
}
