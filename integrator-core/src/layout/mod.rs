//! Layouts of states for flows with structure: lattices, lists and many bodies, and the threads that work on them.

pub(crate) mod bodies;
pub(crate) mod lattice;
pub(crate) mod lists;
pub(crate) mod threads;
