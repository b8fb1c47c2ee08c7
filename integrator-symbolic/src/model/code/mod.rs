//! What can be read off the tokens of a function alone.

pub(crate) mod assigned;
pub(crate) mod attributes;
pub(crate) mod escape;
pub(crate) mod flatten;
pub(crate) mod index_method;
pub(crate) mod reach;
pub(crate) mod sensitive_lists;
pub(crate) mod shape;
pub(crate) mod sign;
