//! Values of expressions, and the integers, conditions and patterns among them.

pub(crate) mod guard;
pub(crate) mod integer;
pub(crate) mod joint;
pub(crate) mod pattern;
pub(crate) mod range;
pub(crate) mod value;
pub(crate) mod whole;
