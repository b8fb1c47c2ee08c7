//! The laboratory: every claim about numerical integration that can be seen in a picture, on one system.
//!
//! `laboratory [SYSTEM] [--out DIR]`, where SYSTEM is one of pendulum, oscillator, henon_heiles, kepler and double_well; own
//! ones are added in `systems.rs`. It integrates the system with all methods and writes pictures, as SVG and PNG, and one
//! page with all of them, `DIR/SYSTEM.html`; DIR is `target/laboratory` if it is not given.
//!
//! Look at the page: phase portraits first, then energies. Printed at last: each claim with its number. A claim that does
//! not hold is marked FAILED and makes the program end with an error.

mod blob;
mod claims;
mod errors;
mod measured;
mod methods;
mod notes;
mod oscillator;
mod page;
mod period;
mod pictures;
mod plan;
mod problem;
mod section;
mod shifted;
mod study;
mod systems;
mod write;

use claims::verdicts;
use notes::notes;
use plan::Plan;
use std::{error::Error, path::PathBuf, process::ExitCode};
use systems::{SYSTEMS, System};
use write::write;

/// What is asked for.
fn arguments() -> Result<(&'static System, PathBuf), Box<dyn Error>> {
    let (mut system, mut folder) = (&SYSTEMS[0], PathBuf::from("target/laboratory"));
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--out" {
            folder = arguments.next().ok_or("--out needs a folder")?.into();
            continue;
        }
        let names = || SYSTEMS.iter().map(|system| system.name).collect::<Vec<_>>().join(", ");
        let known = SYSTEMS.iter().find(|system| system.name == argument);
        system = known.ok_or_else(|| format!("no system is called {argument}: there are {}", names()))?;
    }
    Ok((system, folder))
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (system, folder) = arguments()?;
    let (study, notes) = (system.study(&Plan::WHOLE)?, notes(&Plan::WHOLE)?);
    let verdicts = verdicts(&study, &notes);
    let page = write(&folder.join(system.name), &study, &notes, &verdicts)?;
    println!("{}", page.display());
    for verdict in &verdicts {
        println!("claim_{}={} value={:.3e}", verdict.name, verdict.word(), verdict.value);
    }
    Ok(if verdicts.iter().all(|verdict| verdict.holds) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
