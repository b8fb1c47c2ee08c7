//! Draws one picture of each kind of `integrator-plot`, in one line each.
//!
//! - `gallery_energies.svg`: forward Euler gains energy, backward Euler and Runge–Kutta lose it; the energies of symplectic methods
//!   oscillate.
//! - `gallery_orbit.svg`: large steps make an ellipse precess.
//! - `gallery_phase.svg`: orbits of a double well, inside one well (blue) and over the barrier (orange).
//! - `gallery_section.svg`: islands of regular orbits in a chaotic sea.
//! - `gallery_map.png`: escape time of a star from a galaxy, dark where it escapes at once.

mod systems;

use integrator_core::{Method, prelude::*};
use integrator_plot as plot;
use integrator_reference::{BackwardEuler, ForwardEuler, RungeKutta4};
use std::{env, error::Error, path::PathBuf};
use systems::{DoubleWell, HenonHeiles, Kepler, Pendulum};

fn swing(method: impl Method<Pendulum>) -> Result<Vec<Sample<[f64; 1]>>, integrator_core::Error> {
    Pendulum.run_with(method, Phase::new([2.0], [0.0]), 0.2)?.samples(1).take(840).collect()
}

/// Orbits from the minima of a double well with several momenta. The barrier has height 1.
fn wells() -> Result<plot::Chart, integrator_core::Error> {
    let within = [0.5, 1.0, 1.35].into_iter().flat_map(|p| [(1.0, p), (-1.0, p)]);
    within.chain([(1.0, 1.5), (1.0, 2.0)]).try_fold(plot::phase::<[f64; 1]>(&[]), |chart, (q, p)| {
        let run = DoubleWell.run_with(Yoshida4, Phase::new([q], [p]), 0.02)?;
        let inside = run.energy() < 1.0;
        let samples = run.samples(1).take(400).collect::<Result<Vec<_>, _>>()?;
        let points = samples.iter().map(|sample| (sample.state.q[0], sample.state.p[0]));
        Ok(chart.line("", points).coloured(plot::colour::COLOURS[if inside { 6 } else { 3 }]).wide(1.5))
    })
}

/// Crossings `(y, p_y)` of x = 0 with growing x, of orbits with one energy.
fn section(energy: f64) -> Result<Vec<(f64, f64)>, integrator_core::Error> {
    let mut points = Vec::new();
    let along_y = (0..24).map(|i| (-0.4 + 0.045 * f64::from(i), 0.0));
    // Islands that orbits with p_y = 0 do not reach.
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

/// Time until a star is farther away than 3, at most 100. NaN where the energy allows no start.
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
        .title("Pendulum, step 0.2: relative energy error")
        .save(folder.join("gallery_energies.svg"))?;

    let run = Kepler.run_with(Verlet, Phase::new([1.6, 0.0], [0.0, 0.5]), 0.08)?;
    // Dense output between the steps draws a smooth line.
    let orbit = run.samples_at(0.02).take(3_600).collect::<Result<Vec<_>, _>>()?;
    plot::orbit(&orbit).title("Kepler orbit by Verlet, step 0.08").save(folder.join("gallery_orbit.svg"))?;
    wells()?.title("Orbits of a double well").save(folder.join("gallery_phase.svg"))?;

    let axes = |chart: plot::Chart| chart.along(plot::Axis::linear("y")).up(plot::Axis::linear("p_y"));
    let chart = plot::section_of(section(1.0 / 8.0)?).title("Poincaré section of the Hénon–Heiles system, E = 1/8");
    axes(chart).save(folder.join("gallery_section.svg"))?;

    let (columns, rows) = (300_u32, 260_u32);
    let at =
        |i: u32, count: u32, ends: [f64; 2]| ends[0] + (f64::from(i) + 0.5) / f64::from(count) * (ends[1] - ends[0]);
    let row = |j| (0..columns).map(move |i| stay(0.2, at(i, columns, [-0.6, 1.1]), at(j, rows, [-0.7, 0.7]))).collect();
    let rows = (0..rows).map(row).collect::<Result<Vec<Vec<f64>>, _>>()?;
    let chart = plot::map(-0.6..=1.1, -0.7..=0.7, "escape time, at most 100", rows);
    axes(chart.title("Escape from the Hénon–Heiles galaxy, E = 1/5")).save(folder.join("gallery_map.png"))?;
    println!("{}", folder.display());
    Ok(())
}
