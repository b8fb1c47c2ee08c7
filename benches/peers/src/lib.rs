//! Other crates on the problems of the benches, each used as its documentation says: `curves` are their runs, `fields` what they
//! integrate. Nothing without the feature `peers`.

#[cfg(feature = "peers")]
pub mod curves;
#[cfg(feature = "peers")]
pub mod fields;
