//! Exact flows of parts of H that are more than a shear: what is solved once per run or in each step.

#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod doubled;
pub(crate) mod exponential;
pub(crate) mod kepler;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod quadratic;
