//! A picture of each kind that `integrator-plot` draws of runs, in one line each.
//!
//! Look at `gallery_energies`: the energy of forward Euler leaves the picture upwards and that of backward Euler downwards,
//! Runge and Kutta's method loses a little in every swing, and those of the symplectic methods stay where they are. In
//! `gallery_orbit` an ellipse turns, because steps are long; in `gallery_section` there are islands in a sea; `gallery_map` is
//! how long a star stays in a galaxy from which it can escape, black where it does so at once.

mod systems;

use integrator_core::{
    Method,
    prelude::*,
    reference::{BackwardEuler, ForwardEuler, RungeKutta4},
};
use integrator_plot as plot;
use std::{env, error::Error, path::PathBuf};
use systems::{HenonHeiles, Kepler, Pendulum};

fn swing(method: impl Method<Pendulum>) -> Result<Vec<Sample<[f64; 1]>>, integrator_core::Error> {
    Pendulum.run_with(method, Phase::new([2.0], [0.0]), 0.2)?.samples(1).take(840).collect()
}

/// Where orbits of a star of some energy pass x = 0 to the right.
fn section(energy: f64) -> Result<Vec<(f64, f64)>, integrator_core::Error> {
    let mut points = Vec::new();
    for i in 0..24 {
        let y = -0.4 + 0.045 * f64::from(i);
        let Some(start) = HenonHeiles.start(energy, y, 0.0) else { continue };
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
    let orbit = run.samples(1).take(900).collect::<Result<Vec<_>, _>>()?;
    plot::orbit(&orbit).title("An ellipse by Verlet").save(folder.join("gallery_orbit.svg"))?;
    plot::phase(&swing(Verlet)?).title("A swing").save(folder.join("gallery_phase.svg"))?;

    let axes = |chart: plot::Chart| chart.along(plot::Axis::linear("y")).up(plot::Axis::linear("p_y"));
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
