//! Layouts of states for flows with structure: lattices, lists and many bodies.

pub(crate) mod bodies;
pub(crate) mod lattice;
pub(crate) mod lists;
pub(crate) mod loops;
pub(crate) mod products;
