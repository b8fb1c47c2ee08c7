//! Flows and energies of lattices: a site and its neighbours.

pub(crate) mod carried;
pub(crate) mod energy;
pub(crate) mod plane;
mod segment;
pub(crate) mod sites;
pub(crate) mod stencil;
pub(crate) mod time_tiling;
pub(crate) mod volume;
pub(crate) mod window;
