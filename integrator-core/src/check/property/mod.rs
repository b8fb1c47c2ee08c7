//! Measurements of a method and a system: one property per file.

pub(crate) mod agreement;
pub(crate) mod branches;
mod course;
pub(crate) mod drive;
pub(crate) mod energies;
pub(crate) mod energy;
pub(crate) mod flow_laws;
pub(crate) mod global_error;
pub(crate) mod gradient;
pub(crate) mod invariants;
pub(crate) mod jumps;
pub(crate) mod local_order;
pub(crate) mod monodromy;
pub(crate) mod order;
pub(crate) mod part_flows;
pub(crate) mod reversibility;
pub(crate) mod shadow;
mod slope;
pub(crate) mod smallness;
pub(crate) mod stability;
pub(crate) mod symplecticity;
