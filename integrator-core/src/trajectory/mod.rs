//! One run.

pub(crate) mod admissible;
#[cfg(feature = "checkpoint")]
pub(crate) mod checkpoint;
pub(crate) mod chosen;
pub(crate) mod crossings;
pub(crate) mod engine;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod method;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod moves;
pub(crate) mod panics;
pub(crate) mod run;
pub(crate) mod samples;
pub(crate) mod watch;
