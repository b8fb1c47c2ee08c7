//! Tests of compositions as loops over the flows of an executor.

#[cfg(feature = "check")]
mod many_parts;
mod pairs;
mod time;
