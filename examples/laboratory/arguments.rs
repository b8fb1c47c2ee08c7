//! What the laboratory is asked for on the command line.

use crate::systems::SYSTEMS;
use clap::{Arg, Command, builder::PossibleValuesParser};

/// Returns the command: a system and a folder. For a misspelt system, clap suggests the nearest name.
pub(crate) fn command() -> Command {
    let names = PossibleValuesParser::new(SYSTEMS.map(|system| system.name));
    Command::new("laboratory")
        .about("Compares the claims of a course in numerical integration with numbers and pictures, on one page")
        .arg(Arg::new("SYSTEM").help("System to integrate").default_value(SYSTEMS[0].name).value_parser(names))
        .arg(Arg::new("DIR").long("out").help("Folder of the page").default_value("target/laboratory"))
}
