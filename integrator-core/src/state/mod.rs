//! States: coordinates, their precision, and points of phase space.

pub(crate) mod aligned;
pub(crate) mod clock;
pub(crate) mod compensated;
pub(crate) mod coords;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod digest;
pub(crate) mod fixed;
pub(crate) mod flat;
pub(crate) mod phase;
pub(crate) mod planes;
pub(crate) mod point;
pub(crate) mod precision;
