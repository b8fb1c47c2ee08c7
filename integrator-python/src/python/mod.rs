//! The classes that Python sees. They are compiled once, whatever the number of systems in a module.

pub(crate) mod ensemble;
pub(crate) mod kind;
pub(crate) mod run;
pub(crate) mod system;
