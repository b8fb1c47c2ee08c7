//! Methods that are no compositions.

#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod implicit;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod pace;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod taylor;
