//! Layouts of states for flows with structure: lattices and many bodies, and the threads that work on them.

pub(crate) mod bodies;
pub(crate) mod lattice;
pub(crate) mod threads;
