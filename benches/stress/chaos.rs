//! Bitwise identical results on a chaotic orbit, which amplifies the smallest difference.

use integrator_bench::problems::HenonHeiles;
use integrator_core::{InstructionSet, prelude::*};
use std::{env, io, process::Command};

/// Environment variable that makes a process print the bits of the orbit and exit.
const STEPS: &str = "STRESS_CHAOS_STEPS";

/// Prefix of the bits in the output of such a process.
const MARK: &str = "bits of a chaotic orbit: ";

const H: f64 = 0.05;

/// Chaotic orbits with energies up to 0.16, below the escape energy of 1/6; close members diverge.
fn start(member: usize) -> Phase<[f64; 2]> {
    Phase::new([0.0, -0.15], [0.5 + 1e-9 * member as f64, 0.2])
}

fn bits(state: Phase<[f64; 2]>) -> [u64; 4] {
    let ([x, y], [px, py]) = (state.q, state.p);
    [x, y, px, py].map(f64::to_bits)
}

fn alone(member: usize, steps: u64) -> Result<[u64; 4], Error> {
    let mut run = HenonHeiles.run_with(KahanLi8, start(member), H)?;
    run.advance(steps)?;
    Ok(bits(run.state()))
}

/// Counts members that differ from their single runs, over thread counts and lane assignments.
pub(crate) fn members_differing(steps: u64) -> Result<usize, Error> {
    const MEMBERS: usize = 37;
    let alone: Vec<[u64; 4]> = (0..MEMBERS).map(|member| alone(member, steps)).collect::<Result<_, _>>()?;
    let mut differing = 0;
    for threads in [1, 2, 3, 7] {
        for members in [1, 5, 16, MEMBERS] {
            let starts = (0..members).map(|member| (HenonHeiles, start(member)));
            let mut swarm = Ensemble::new(KahanLi8, starts, H)?.with_threads(threads);
            swarm.advance(steps / 3)?;
            swarm.advance(steps - steps / 3)?;
            let states = swarm.states().map(bits);
            differing += states.zip(&alone).filter(|(member, alone)| member != *alone).count();
        }
    }
    Ok(differing)
}

/// Prints the bits of the orbit if the environment variable requests them.
pub(crate) fn answer() -> bool {
    let Some(steps) = env::var(STEPS).ok().and_then(|steps| steps.parse().ok()) else { return false };
    if let Ok(bits) = alone(0, steps) {
        println!("{MARK}{bits:x?}");
    }
    true
}

/// Runs the same orbit on each instruction set, in processes that `command` starts and that call [`answer`]. Returns
/// the number of sets that give different results in two runs, plus the number of differences between sets other than
/// the baseline.
pub(crate) fn sets_differing(steps: u64, command: impl Fn() -> io::Result<Command>) -> io::Result<usize> {
    let on = |set: InstructionSet| -> io::Result<String> {
        let output = command()?.env("INTEGRATOR_ISA", set.to_string()).env(STEPS, steps.to_string()).output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        let line = text.split_once(MARK).map(|(_, rest)| rest.lines().next().unwrap_or_default().to_owned());
        line.ok_or_else(|| io::Error::other(format!("no bits in {text}")))
    };
    let mut differing = 0;
    let mut with_fma = Vec::new();
    for set in InstructionSet::available() {
        let found = on(*set)?;
        differing += usize::from(found != on(*set)?);
        if *set > InstructionSet::Baseline {
            with_fma.push(found);
        }
    }
    Ok(differing + with_fma.windows(2).filter(|pair| pair[0] != pair[1]).count())
}
