//! Statements, branches and what leaves them.

pub(crate) mod arm;
pub(crate) mod branch;
pub(crate) mod early_return;
mod ring;
pub(crate) mod sides;
pub(crate) mod statement;
