//! The functions of the impl that are H, and the parts, parameters and invariants of the system.

mod commuting;
pub(crate) mod constant;
pub(crate) mod doubled;
pub(crate) mod external;
pub(crate) mod friction;
pub(crate) mod invariant;
pub(crate) mod own_flow;
pub(crate) mod parts;
pub(crate) mod passed_over;
pub(crate) mod sensitive;
pub(crate) mod series;
pub(crate) mod sorted_parts;
pub(crate) mod unsplit;
