//! Methods that are no compositions.

#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod friction;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod implicit;
mod inner_steps;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod pace;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub mod taylor;
