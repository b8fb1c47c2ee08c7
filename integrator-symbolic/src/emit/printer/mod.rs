//! Rust code for values, indices, conditions and lines of a program; `cuda` prints C++ for devices.

pub(super) mod block;
pub(super) mod condition;
pub(super) mod cuda;
pub(super) mod expression;
pub(super) mod fields;
pub(super) mod frame;
pub(super) mod function;
pub(super) mod index;
pub(super) mod interleaved;
pub(super) mod lanes;
pub(super) mod lists;
mod phases;
mod products;
pub(super) mod sites;
