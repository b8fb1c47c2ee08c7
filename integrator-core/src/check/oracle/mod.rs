//! Oracles that measurements are compared with: exact derivatives, and motions from other methods.

pub(crate) mod compensated_steps;
pub(crate) mod composed_reference;
pub(crate) mod edges;
pub(crate) mod exact;
pub(crate) mod reference;
pub(crate) mod series;
pub(crate) mod tangent;
