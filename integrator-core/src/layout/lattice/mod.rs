//! Flows of lattices: a site and its neighbours.

pub(crate) mod gather;
pub(crate) mod neighbours;
pub(crate) mod plane;
pub(crate) mod sites;
pub(crate) mod tiled;
