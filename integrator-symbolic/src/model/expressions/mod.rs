//! Expressions: operators, calls and elementary functions.

pub(crate) mod bits;
pub(crate) mod call;
pub(crate) mod closure;
pub(crate) mod cure;
pub(crate) mod elementary;
pub(crate) mod expression;
pub(crate) mod operator;
pub(crate) mod types;
