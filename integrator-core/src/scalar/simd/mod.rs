//! SIMD vectors.

pub(crate) mod block;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod lanes;
pub(crate) mod pair;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod row;
#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[allow(unsafe_code, reason = "instructions that the target may lack, used where they were detected")]
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod x86;
