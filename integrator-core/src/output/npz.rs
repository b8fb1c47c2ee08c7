//! Samples as arrays for NumPy.

use super::each::{OutputError, each, numbers, unequal};
use crate::{error::Error, state::coords::Coords, trajectory::samples::Sample};
use alloc::vec::Vec;
use npyz::{WriteOptions, WriterBuilder};
use std::io::{self, BufWriter, Seek, Write};
use zip::{ZipWriter, write::SimpleFileOptions};

/// Writes samples as an NPZ file for `np.load(path)` in Python, and returns the number of samples.
///
/// For `n` samples, the file contains these arrays in double precision:
///
/// - `t` and `energy`, of length `n`;
/// - each [conserved quantity](crate::Run::invariant) by its name, of length `n`;
/// - `q` and `p`, of shape `(n, number of coordinates)` or `(n, number of points, components)`.
///
/// All samples are kept in memory until the last one, because the arrays are stored one after the other.
///
/// # Errors
/// Those of [`each`]; also [`OutputError::Write`] if the numbers of coordinates of samples differ.
pub fn npz<C: Coords>(
    samples: impl IntoIterator<Item = Result<Sample<C>, Error>>,
    to: impl Write + Seek,
) -> Result<u64, OutputError> {
    let mut arrays = Arrays {
        shape: Vec::new(),
        t: Vec::new(),
        q: Vec::new(),
        p: Vec::new(),
        energy: Vec::new(),
        invariants: Vec::new(),
    };
    let outcome = each(samples, |sample| arrays.push(sample));
    let saved = arrays.write(to);
    let written = outcome?;
    saved.map_err(|error| OutputError::Write { written, error })?;
    Ok(written)
}

/// The samples, one after the other.
struct Arrays {
    /// The axes of `q` and of `p`.
    shape: Vec<u64>,
    t: Vec<f64>,
    q: Vec<f64>,
    p: Vec<f64>,
    energy: Vec<f64>,
    invariants: Vec<(&'static str, Vec<f64>)>,
}

impl Arrays {
    fn push<C: Coords>(&mut self, sample: &Sample<C>) -> io::Result<()> {
        let axes = shape(self.t.len() + 1, &sample.state.q);
        if !self.shape.is_empty() && self.shape[1..] != axes[1..] {
            return Err(unequal());
        }
        self.shape = axes;
        self.t.push(sample.time);
        self.q.extend(numbers(&sample.state.q));
        self.p.extend(numbers(&sample.state.p));
        self.energy.push(sample.energy());
        if self.invariants.is_empty() {
            self.invariants = sample.invariants().map(|(name, _)| (name, Vec::new())).collect();
        }
        for ((_, values), (_, value)) in self.invariants.iter_mut().zip(sample.invariants()) {
            values.push(value);
        }
        Ok(())
    }

    fn write(&self, to: impl Write + Seek) -> io::Result<()> {
        let mut archive = ZipWriter::new(BufWriter::new(to));
        let (count, nothing) = ([self.t.len() as u64], [0, 0]);
        let of_coordinates = if self.shape.is_empty() { &nothing[..] } else { &self.shape };
        let arrays = [
            ("t", &self.t, &count[..]),
            ("q", &self.q, of_coordinates),
            ("p", &self.p, of_coordinates),
            ("energy", &self.energy, &count),
        ];
        let invariants = self.invariants.iter().map(|(name, values)| (*name, values, &count[..]));
        for (name, numbers, shape) in arrays.into_iter().chain(invariants) {
            // An archive counts bytes with 32 bits if nothing else is announced; half of that leaves room for the head.
            let large = size_of_val(numbers.as_slice()) as u64 > u64::from(u32::MAX) / 2;
            let options = SimpleFileOptions::default().large_file(large);
            archive.start_file(npyz::npz::file_name_from_array_name(name), options)?;
            let mut array = WriteOptions::new().default_dtype().shape(shape).writer(&mut archive).begin_nd()?;
            array.extend(numbers.iter().copied())?;
            array.finish()?;
        }
        archive.finish()?.flush()
    }
}

/// Returns the shape of an array of `count` samples of these coordinates.
fn shape<C: Coords>(count: usize, coordinates: &C) -> Vec<u64> {
    let (components, rows) = (C::COMPONENTS, C::ROWS);
    let inner = match (components, rows) {
        (1, None) => vec![],
        (_, None) => vec![components],
        (_, Some(rows)) => vec![rows, components.checked_div(rows).unwrap_or(0)],
    };
    let axes = [count, coordinates.length()].into_iter().chain(inner);
    axes.map(|length| length as u64).collect()
}
