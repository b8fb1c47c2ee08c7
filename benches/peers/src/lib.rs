//! Other crates on the problems of the benches: `curves` has their runs, `fields` the systems. Empty without the feature
//! `peers`.

#[cfg(feature = "peers")]
pub mod curves;
#[cfg(feature = "peers")]
pub mod fields;
