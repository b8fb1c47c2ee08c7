//! Samples as lines of text.

use super::each::{OutputError, each, numbers, unequal};
use crate::{
    error::Error,
    state::coords::{Coords, column_names},
    trajectory::samples::Sample,
};
use ::csv::ErrorKind;
use alloc::{
    format,
    string::{String, ToString},
    vec::Vec,
};
use core::mem::replace;
use std::io::{self, Write};

/// Writes samples as CSV and returns the number of samples.
///
/// The first line contains the names of the columns:
///
/// - the time `t`;
/// - the positions `q0`, `q1`, ..., where `q0_2` is the third component of the first point;
/// - the momenta `p0`, `p1`, ...;
/// - the `energy`;
/// - each [conserved quantity](crate::Run::invariant) by its name.
///
/// Each number is the shortest text that reads back bitwise identical.
///
/// [`csv_with_names`] writes names of bodies in place of their numbers.
///
/// # Errors
/// Those of [`each`]; also [`OutputError::Write`] if the numbers of coordinates of samples differ.
pub fn csv<C: Coords>(
    samples: impl IntoIterator<Item = Result<Sample<C>, Error>>,
    to: impl Write,
) -> Result<u64, OutputError> {
    csv_with_names(samples, [""; 0], to)
}

/// Writes samples as [`csv()`], with names of bodies, or of plain coordinates, in the names of the columns.
///
/// With the names `Sun` and `Jupiter`, columns are `q_Sun_0`, ..., `p_Jupiter_2`. Further bodies keep their numbers.
///
/// # Errors
/// As [`csv()`].
pub fn csv_with_names<C: Coords>(
    samples: impl IntoIterator<Item = Result<Sample<C>, Error>>,
    names: impl IntoIterator<Item = impl Into<String>>,
    to: impl Write,
) -> Result<u64, OutputError> {
    let names: Vec<String> = names.into_iter().map(Into::into).collect();
    let mut writer = ::csv::Writer::from_writer(to);
    let mut named = false;
    let outcome = each(samples, |sample| {
        if !replace(&mut named, true) {
            writer.write_record(header(sample, &names)).map_err(cause)?;
        }
        let row = [sample.time].into_iter().chain(numbers(&sample.state.q)).chain(numbers(&sample.state.p));
        // As `Debug` shows them, numbers are as short as possible, and with an exponent where that is shorter.
        let conserved = sample.invariants().map(|(_, value)| value);
        let row: Vec<String> =
            row.chain([sample.energy()]).chain(conserved).map(|number| format!("{number:?}")).collect();
        writer.write_record(row).map_err(cause)
    });
    let flushed = writer.flush();
    let written = outcome?;
    flushed.map_err(|error| OutputError::Write { written, error })?;
    Ok(written)
}

/// The error of the CSV writer: one of the writer below it, or that of a record with another length than the first one.
fn cause(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ErrorKind::Io(error) => error,
        _ => unequal(),
    }
}

/// The names of all columns.
fn header<C: Coords>(sample: &Sample<C>, names: &[String]) -> Vec<String> {
    let count = sample.state.q.flat().len();
    let each = |letter| column_names::<C>(letter, count).map(|column| named(column, names));
    let (first, last) = ("t".to_string(), "energy".to_string());
    let conserved = sample.invariants().map(|(name, _)| name.to_string());
    [first].into_iter().chain(each('q')).chain(each('p')).chain([last]).chain(conserved).collect()
}

/// A column such as `q0_2` with the name of its body, if there is one.
fn named(column: String, names: &[String]) -> String {
    let (letter, rest) = column.split_at(1);
    let (number, component) = rest.split_at(rest.find('_').unwrap_or(rest.len()));
    match number.parse().ok().and_then(|number: usize| names.get(number)) {
        Some(name) => format!("{letter}_{name}{component}"),
        None => column,
    }
}
