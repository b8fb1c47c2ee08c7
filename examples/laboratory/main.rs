//! The laboratory: every claim about numerical integration that can be seen in a picture, on one system.
//!
//! `laboratory [SYSTEM] [--out DIR]`, where SYSTEM is one of pendulum, oscillator, `henon_heiles`, kepler, `double_well` and stiff.
//! It measures the system with all methods and writes one page with all pictures, `DIR/SYSTEM.html`, and the pictures beside
//! it as SVG and PNG; DIR is `target/laboratory` if it is not given. For a system of your own, take the crate
//! `integrator-laboratory`: one call writes its page.
//!
//! Look at the page: portraits first, then energies. Printed at last: each claim with its number. A claim that does not hold
//! is marked FAILED and makes the program end with an error.

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
    // Whoever reads may have seen enough.
    match write!(io::stdout(), "{report}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.into()),
        _ if report.holds() => Ok(ExitCode::SUCCESS),
        _ => Ok(ExitCode::FAILURE),
    }
}
