//! The Taylor method: what the generated recurrences compute, and what runs make of it.
//!
//! The coefficients of the motion of many small systems, at least one for every elementary function, are held against those
//! that `reference.py` found with fifty digits without recurrences; runs are held against closed forms.

mod barriers;
mod branches;
mod crossings;
mod drift;
mod ends;
mod ensemble;
mod global_error;
#[path = "../support/instruction_sets.rs"]
mod instruction_sets;
mod lines;
mod long;
mod mixed;
#[path = "../support/motions.rs"]
mod motions;
mod powers;
mod recurrences;
mod reference;
mod roots;
mod rows;
mod runs;
mod splits;
mod units;
