//! Samples one by one, counted, up to the end or the first error.

use crate::{
    error::{Error, debug_as_display},
    state::{coords::Coords, precision::Precision},
    trajectory::samples::Sample,
};
use std::io;

debug_as_display!(OutputError);

/// The reason why not all samples were written.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The run failed. The samples before are written.
    #[error("the run ended after {written} samples, which are written: {error}")]
    Run {
        /// The number of samples written.
        written: u64,
        /// The error of the run.
        error: Error,
    },
    /// A sample could not be written.
    #[error("writing ended after {written} samples: {error}")]
    Write {
        /// The number of samples that the writer accepted; buffered samples can be lost.
        written: u64,
        /// The error of the writer.
        error: io::Error,
    },
}

/// Calls `callback` with each sample, and returns the number of samples.
///
/// # Errors
/// The first error ends the loop.
///
/// - [`OutputError::Run`]: the run failed.
/// - [`OutputError::Write`]: `callback` returned an error.
pub fn each<C: Coords>(
    samples: impl IntoIterator<Item = Result<Sample<C>, Error>>,
    mut callback: impl FnMut(&Sample<C>) -> io::Result<()>,
) -> Result<u64, OutputError> {
    let mut written = 0;
    for sample in samples {
        let sample = sample.map_err(|error| OutputError::Run { written, error })?;
        callback(&sample).map_err(|error| OutputError::Write { written, error })?;
        written += 1;
    }
    Ok(written)
}

/// Coordinates as doubles, points one after the other.
pub(super) fn numbers<C: Coords>(coordinates: &C) -> impl Iterator<Item = f64> {
    coordinates.flat().iter().map(|leaf| leaf.to_f64())
}

/// The error of a sample with another number of coordinates than those before it.
pub(super) fn unequal() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "samples differ in the number of their coordinates")
}
