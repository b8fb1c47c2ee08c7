//! Orbits in a flattened galaxy, for each flattening of a list and each start of a table.

use integrator_core::{output, prelude::*};
use serde::Deserialize;
use std::{error::Error as AnyError, fs, fs::File, ops::ControlFlow, path::Path};

/// The logarithmic potential (Binney and Tremaine, Galactic Dynamics, section 3.3.1).
pub(crate) struct Galaxy {
    core: f64,
    flattening: f64,
}

#[hamiltonian(compose = BlanesMoanSrkn6)]
impl Galaxy {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (self.core.powi(2) + x * x + (y / self.flattening).powi(2)).ln()
    }
}

/// Parameters in the file `study.toml`.
#[derive(Deserialize)]
pub(crate) struct Study {
    pub(crate) flattening: Vec<f64>,
    core: f64,
    step: f64,
    pieces: u64,
    samples: u64,
    interval: u64,
}

/// Final state of an orbit, and its relative energy error.
#[derive(Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) flattening: f64,
    pub(crate) start: usize,
    pub(crate) error: f64,
    pub(crate) end: Phase<[f64; 2]>,
}

/// Runs the remaining pieces of a study. `told` is called for each piece and may stop the study. Another call resumes it:
/// files are complete or absent, and an unfinished piece is repeated with bitwise identical results.
pub(crate) fn sweep(
    from: &Path,
    to: &Path,
    mut told: impl FnMut(&str) -> ControlFlow<()>,
) -> Result<Option<Vec<Outcome>>, Box<dyn AnyError>> {
    let study: Study = toml::from_str(&fs::read_to_string(from.join("study.toml"))?)?;
    // The columns x, y, px, py.
    let starts =
        csv::Reader::from_path(from.join("starts.csv"))?.into_deserialize().collect::<Result<Vec<[f64; 4]>, _>>()?;
    fs::create_dir_all(to)?;
    let mut outcomes = Vec::new();
    for &flattening in &study.flattening {
        for (start, &[x, y, px, py]) in starts.iter().enumerate() {
            let galaxy = Galaxy { core: study.core, flattening };
            let name = format!("orbit_{flattening}_{start}");
            let begin = galaxy.run(Phase::new([x, y], [px, py]), study.step)?;
            let energy = begin.energy();
            let saved = to.join(format!("{name}.run"));
            let mut run = if saved.exists() { Run::resume(&galaxy, &fs::read(&saved)?)? } else { begin };
            let steps = study.samples * study.interval;
            for piece in run.steps() / steps..study.pieces {
                run = write(run, &study, &to.join(format!("{name}_{piece}.npz")))?;
                run.checkpoint_to(&saved)?;
                if told(&format!("{name}: {} of {}", piece + 1, study.pieces)).is_break() {
                    return Ok(None);
                }
            }
            outcomes.push(Outcome { flattening, start, error: run.energy() / energy - 1.0, end: run.state() });
        }
    }
    Ok(Some(outcomes))
}

/// Writes the samples of a piece. Later pieces omit their first sample, the last one of the previous piece.
fn write(run: Run<[f64; 2]>, study: &Study, path: &Path) -> Result<Run<[f64; 2]>, Box<dyn AnyError>> {
    let skipped = usize::from(run.steps() > 0);
    let mut samples = run.samples(study.interval);
    let partial = path.with_extension("partial");
    output::npz(samples.by_ref().take(study.samples as usize + 1).skip(skipped), File::create(&partial)?)?;
    fs::rename(partial, path)?;
    Ok(samples.into_run())
}
