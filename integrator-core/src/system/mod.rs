//! Systems: a state in its layout, energies, prepared constants, lists and functions of the user.

pub(crate) mod by_value;
pub(crate) mod counts;
pub(crate) mod device_text;
pub(crate) mod elements;
pub(crate) mod energy;
pub(crate) mod external;
pub(crate) mod integers;
pub(crate) mod motion;
pub(crate) mod not_finite;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod prepared;
pub(crate) mod read_by_methods;
#[cfg(any(debug_assertions, feature = "check"))]
pub(crate) mod user_energies;
