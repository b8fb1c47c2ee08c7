//! Killed runs and damaged files.

use integrator_bench::problems::HenonHeiles;
use integrator_core::{CheckpointError, prelude::*};
use std::{
    env, fs, io,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::Duration,
};

/// Environment variable with the checkpoint file that a process resumes until it is killed.
const FILE: &str = "STRESS_RUN_TO_KILL";

type Orbit = Run<[f64; 2]>;

fn begin() -> Result<Orbit, Error> {
    HenonHeiles.run_with(Yoshida4, Phase::new([0.0, 0.1], [0.3, 0.05]), 0.05)
}

fn resumed(bytes: &[u8]) -> Result<Orbit, CheckpointError> {
    Run::resume_with(&HenonHeiles, Yoshida4, bytes)
}

/// Resumes a run until this process is killed, if the environment variable requests it.
pub(crate) fn answer() -> bool {
    let Some(path) = env::var_os(FILE).map(PathBuf::from) else { return false };
    let going = match fs::read(&path) {
        Ok(bytes) => resumed(&bytes).map_err(|error| error.to_string()),
        Err(_) => begin().map_err(|error| error.to_string()),
    };
    let Ok(mut run) = going else { return true };
    while run.advance(300).is_ok() && run.checkpoint_to(&path).is_ok() {}
    true
}

/// Kills a run `attempts` times, each time at another moment after its first write. Counts the checkpoints that cannot
/// be resumed or that lie behind an earlier one, and adds one if the final state is not bitwise identical to that of an
/// uninterrupted run. `command` starts a process that calls [`answer`].
pub(crate) fn failures(attempts: u64, command: impl Fn() -> io::Result<Command>) -> io::Result<u64> {
    let path = env::temp_dir().join(format!("stress-run-{}", std::process::id()));
    let steps = |path: &Path| fs::read(path).map_or(Ok(0), |bytes| resumed(&bytes).map(|run| run.steps()));
    let (mut failures, mut done) = (0, 0);
    for attempt in 0..attempts {
        let mut child = command()?.env(FILE, &path).stdout(Stdio::null()).spawn()?;
        loop {
            let now = steps(&path).unwrap_or(0);
            failures += u64::from(now < done);
            let more = now > done;
            done = now.max(done);
            if more {
                break;
            }
            if let Some(status) = child.try_wait()? {
                return Err(io::Error::other(format!("the run ended by itself: {status}")));
            }
        }
        std::thread::sleep(Duration::from_micros(7_919 * attempt % 5_003));
        child.kill()?;
        child.wait()?;
    }
    let bytes = fs::read(&path)?;
    let same = || -> Result<bool, Box<dyn std::error::Error>> {
        let (mut resumed, mut whole) = (resumed(&bytes)?, begin()?);
        resumed.advance(1_000)?;
        whole.advance(resumed.steps())?;
        Ok(whole.state() == resumed.state())
    };
    failures += u64::from(!same().unwrap_or(false));
    let _ = fs::remove_file(path.with_extension("partial"));
    fs::remove_file(&path)?;
    Ok(failures)
}

/// Counts the damaged copies of a checkpoint that are accepted: copies with one flipped bit, and copies with two
/// flipped bits at least `stride` bits apart.
pub(crate) fn damaged_accepted(stride: usize) -> Result<usize, Error> {
    let mut run = begin()?;
    run.advance(1_234)?;
    let whole = run.checkpoint();
    let flip = |bits: &[usize]| {
        let mut bytes = whole.clone();
        for bit in bits {
            bytes[bit / 8] ^= 1 << (bit % 8);
        }
        usize::from(resumed(&bytes).is_ok())
    };
    let bits = 8 * whole.len();
    let single: usize = (0..bits).map(|bit| flip(&[bit])).sum();
    let pairs = (0..bits).flat_map(|one| (one + 1..bits).step_by(stride).map(move |other| [one, other]));
    Ok(single + pairs.map(|pair| flip(&pair)).sum::<usize>())
}
