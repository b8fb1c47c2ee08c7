//! Flows of bodies that act on each other in pairs.

mod densities;
mod given;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod jacobi;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod jacobi_map;
pub(crate) mod load_store;
pub(crate) mod many_rows;
pub(crate) mod neighbours;
pub(crate) mod one_row;
mod other_terms;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod pair_sums;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod part;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod rows;
mod triplets;
