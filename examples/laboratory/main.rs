//! Compares the claims of a course in numerical integration with numbers, on one system: `laboratory [SYSTEM] [--out DIR]`.
//!
//! SYSTEM is one of pendulum, oscillator, `henon_heiles`, kepler, `double_well` and stiff. The program integrates it with all
//! methods and writes the page `DIR/SYSTEM.html`, with its pictures as SVG and PNG. DIR is `target/laboratory` by default. For
//! your own system, one call of the crate `integrator-laboratory` writes such a page.
//!
//! The page begins with phase portraits, then energies. The program prints each claim with its number. A claim that fails is
//! marked FAILED, and the program ends with an error.

mod arguments;
mod oscillator;
mod period;
mod section;
mod stiff;
mod systems;

use arguments::command;
use integrator_laboratory::Plan;
use std::{
    error::Error,
    io::{self, ErrorKind, Write},
    process::ExitCode,
};
use systems::SYSTEMS;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments = command().get_matches();
    let asked = |name: &str| arguments.get_one::<String>(name).map_or("", String::as_str);
    let system = SYSTEMS.iter().find(|system| system.name == asked("SYSTEM")).ok_or("no such system")?;
    let report = (system.report)(&Plan::WHOLE, asked("DIR").as_ref())?;
    // A closed pipe is not an error.
    match write!(io::stdout(), "{report}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.into()),
        _ if report.holds() => Ok(ExitCode::SUCCESS),
        _ => Ok(ExitCode::FAILURE),
    }
}
