//! Scalars and vectors that steps are computed in, and their elementary functions.

#[cfg(any(debug_assertions, feature = "check"))]
pub(crate) mod bounded;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod double_double;
pub(crate) mod dual;
#[cfg_attr(feature = "std", allow(dead_code, unreachable_pub, reason = "users need it where there is no std"))]
pub(crate) mod elementary;
pub(crate) mod exact;
pub(crate) mod fma;
pub(crate) mod functions;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod implicit;
pub(crate) mod instruction_set;
pub(crate) mod interval;
pub(crate) mod noise;
pub(crate) mod real;
pub(crate) mod simd;
#[cfg(feature = "check")]
pub(crate) mod tolerance;
#[cfg(feature = "check")]
pub(crate) mod watched;
