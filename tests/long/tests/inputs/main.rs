//! Bad input at run time gives a typed error that names the problem, on every instruction set of the machine.

mod any;
mod constructors;
mod energies;
#[path = "../../../support/instruction_sets.rs"]
mod instruction_sets;
mod parameters;
