//! Loops, sequences and reductions.

pub(crate) mod adaptor;
pub(crate) mod fill;
pub(crate) mod join;
pub(crate) mod repeat;
pub(crate) mod scatter;
pub(crate) mod sequence;
pub(crate) mod total;
