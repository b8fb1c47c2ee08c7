//! Counts instructions per step and compares them with `benches/instruction_counts.csv`: `cargo bench -p integrator-bench --bench
//! instructions`.
//!
//! The program runs itself under callgrind with two numbers of steps; the difference is the cost of the steps alone. Callgrind
//! of Valgrind 3.19 does not support AVX-512, so it counts the code for AVX2. A count more than two per cent above the stored
//! one is an error; `.ci/bless counts` stores new counts. Without Valgrind, the program prints that nothing is counted.

use integrator_bench::{
    counts::{Counts, compare, read, total, write},
    problems::{Fput, Kepler, Pendulum},
    starts::{Problem, Problems, cluster, waves},
};
use integrator_core::{Coords, prelude::*};
use std::{
    env,
    error::Error,
    fs,
    hint::black_box,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
};

/// Steps per block. A run does its checks between blocks, so whole blocks make the two numbers differ by steps alone.
const BLOCK: u64 = 1024;

/// Names of the counted problems; they use `Verlet` unless the name contains a composition.
const PROBLEMS: [&str; 11] = [
    "pendulum",
    "henon",
    "kepler",
    "solar",
    "fput",
    "fput_kahanli8",
    "fput_1e3",
    "nbody_32",
    "rotors_32",
    "pendulum_x64",
    "kepler_x64",
];

/// Rotors of which each turns every other one: a sine for each pair.
struct Rotors;

#[hamiltonian]
impl Rotors {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                sum -= (q[i] - q[j]).cos();
            }
        }
        sum
    }
}

fn advance<H: Hamiltonian, X: Composition<H>>(system: &H, start: Phase<H::Coords>, _: X, h: f64, steps: u64)
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut run = system.run_with::<f64, X>(X::default(), start, h).expect("a start");
    run.advance(steps).expect("finite states");
    black_box(run.state());
}

fn verlet<H: Hamiltonian>(problem: Problem<H>, h: f64, steps: u64)
where
    H::Coords: Coords<Leaf = f64>,
{
    advance(&problem.system, problem.start, Verlet, h, steps);
}

/// Takes the steps to be counted.
fn take(problem: &str, steps: u64) {
    let problems = Problems::default();
    let angles = (0..64).map(|i| f64::from(i) / 32.0);
    match problem {
        "pendulum" => verlet(problems.pendulum(), 0.01, steps),
        "henon" => verlet(problems.henon_heiles(), 0.01, steps),
        "kepler" => verlet(problems.kepler(), 0.001, steps),
        "solar" => verlet(problems.solar(), 10.0, steps),
        "fput" => verlet(problems.chain(), 0.05, steps),
        "fput_kahanli8" => {
            let Problem { system, start, .. } = problems.chain();
            advance(&system, start, KahanLi8, 0.05, steps);
        }
        "fput_1e3" => advance(&Fput { alpha: 0.25 }, waves(1000), Verlet, 0.05, steps),
        "nbody_32" => {
            let (system, start) = cluster(32);
            advance(&system, start, Verlet, 1e-3, steps);
        }
        "rotors_32" => advance(&Rotors, waves(32), Verlet, 0.01, steps),
        "pendulum_x64" => {
            let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 };
            let members = angles.map(|q| (pendulum, Phase::new([q], [0.0])));
            swarm(Ensemble::new(Verlet, members, 0.01), steps);
        }
        "kepler_x64" => {
            let members = angles.map(|x| (Kepler, Phase::new([0.6 + 0.1 * x, 0.0], [0.0, 1.2])));
            swarm(Ensemble::new(Verlet, members, 0.01), steps);
        }
        other => panic!("no problem is called {other}"),
    }
}

fn swarm<C: Coords>(ensemble: Result<Ensemble<C>, integrator_core::Error>, steps: u64) {
    let mut ensemble = ensemble.expect("members").with_threads(1);
    ensemble.advance(steps).expect("finite states");
    black_box(ensemble.state(0));
}

/// Returns the instructions that this program executes for the given number of steps.
fn instructions(problem: &str, steps: u64) -> Result<u64, Box<dyn Error>> {
    let file = env::temp_dir().join(format!("integrator-{}-{problem}-{steps}.callgrind", std::process::id()));
    let output = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind"])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(env::current_exe()?)
        .args(["take", problem, &steps.to_string()])
        .env("INTEGRATOR_ISA", "avx2")
        .output()?;
    if !output.status.success() {
        return Err(format!("{problem}: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    let text = fs::read_to_string(&file)?;
    fs::remove_file(&file)?;
    total(&text).ok_or_else(|| format!("{problem}: callgrind wrote no total").into())
}

fn count() -> Result<Counts, Box<dyn Error>> {
    let per_step = |problem: &str| -> Result<_, Box<dyn Error>> {
        let [few, many] = [instructions(problem, BLOCK)?, instructions(problem, 3 * BLOCK)?];
        Ok((problem.to_owned(), (many - few) as f64 / (2 * BLOCK) as f64))
    };
    PROBLEMS.into_iter().map(per_step).collect()
}

/// Returns whether all counts agree with the stored ones.
fn check(kept: &Path) -> Result<bool, Box<dyn Error>> {
    let counted = count()?;
    if env::var_os("BLESS").is_some() {
        fs::write(kept, write(&counted))?;
    }
    let differences = compare(&read(&fs::read_to_string(kept)?)?, &counted);
    println!("{:<24} {:>12} {:>12} {:>12}   instructions per step", "", "kept", "counted", "");
    for difference in &differences {
        println!("{difference}");
    }
    Ok(differences.iter().all(|difference| difference.holds()))
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [command, problem, steps] = &arguments[..]
        && command == "take"
    {
        take(problem, steps.parse()?);
        return Ok(ExitCode::SUCCESS);
    }
    if !cfg!(target_arch = "x86_64") || Command::new("valgrind").arg("--version").output().is_err() {
        println!("SKIPPED: instructions are counted on x86-64 with Valgrind, and one of the two is missing");
        return Ok(ExitCode::SUCCESS);
    }
    let kept = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/instruction_counts.csv"));
    let holds = check(&kept)?;
    if !holds {
        println!("Some steps take over 2 % more instructions. If that is meant: `.ci/bless counts`");
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
