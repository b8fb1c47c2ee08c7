//! Generated code in hostile surroundings: whatever the user's crate calls its own things, the stepper means the right
//! ones, and no lint of the user's crate is raised in it.
#![deny(missing_docs, warnings, unused, nonstandard_style, future_incompatible)]

// The same crate under another name, as a dependency that is renamed in Cargo.toml.
pub extern crate integrator_core as renamed;

/// A module that hides the crate `core` from paths that do not begin with `::`.
pub mod core {}
/// And one that hides `std`.
pub mod std {}

pub mod attributes;
pub mod const_generics;
pub mod locals;
pub mod macros;
pub mod names;
pub mod no_parameters;
pub mod no_prelude;
pub mod other_names;
pub mod renamed_dependency;
