//! Bad input at run time is refused, by a typed error that says what is wrong: on every instruction set that the machine
//! has.

mod any;
mod constructors;
mod energies;
#[path = "../../../support/instruction_sets.rs"]
mod instruction_sets;
mod parameters;
