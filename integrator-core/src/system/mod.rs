//! What is known of a system: its state in a layout, its energies, its constants, its lists and outside functions.

pub(crate) mod elements;
pub(crate) mod energy;
pub(crate) mod external;
pub(crate) mod motion;
pub(crate) mod not_finite;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod prepared;
#[cfg(any(debug_assertions, feature = "check"))]
pub(crate) mod stated;
