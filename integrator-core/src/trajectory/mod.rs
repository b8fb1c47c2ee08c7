//! One run.

pub(crate) mod admissible;
pub(crate) mod by_table;
#[cfg(feature = "checkpoint")]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod checkpoint;
pub(crate) mod crossings;
pub(crate) mod dispatch;
#[cfg(all(feature = "checkpoint", feature = "std"))]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod elsewhere;
pub(crate) mod engine;
pub(crate) mod gradient;
pub(crate) mod heat;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod in_lanes;
pub(crate) mod interleaved;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod method;
#[cfg_attr(not(feature = "std"), allow(dead_code, reason = "there are no ensembles, whose members change lanes"))]
pub(crate) mod motions;
pub(crate) mod on_crossing;
pub(crate) mod panics;
pub(crate) mod physical_time;
#[cfg(feature = "std")]
pub(crate) mod progress;
pub(crate) mod run;
pub(crate) mod samples;
pub(crate) mod sensitive;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod step_functions;
pub(crate) mod step_loop;
pub(crate) mod tangent;
pub(crate) mod watch;

#[cfg(all(test, feature = "check"))]
mod tests;
