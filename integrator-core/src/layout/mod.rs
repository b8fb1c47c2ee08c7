//! What flows are applied to.

pub(crate) mod bodies;
pub(crate) mod lattice;
pub(crate) mod threads;
