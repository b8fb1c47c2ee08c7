//! Tables of numbers with named columns, as comma-separated text.
//!
//! Comes in: a text whose first line that is not a comment (`#`) names the columns. Goes out: numbers by column and row. A name may
//! have a unit after an underscore, as `x_au` has, which is not read.

use crate::{mistake::Mistake, source::Source};
use csv::{ReaderBuilder, StringRecord, Trim};

/// A table.
pub(crate) struct Table<'s> {
    source: &'s Source,
    names: StringRecord,
    rows: Vec<StringRecord>,
}

impl<'s> Table<'s> {
    /// Reads all rows of a text.
    pub(crate) fn read(source: &'s Source) -> Result<Self, Mistake> {
        let mut reader = ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(source.text.as_bytes());
        let wrong = |error: csv::Error| match error.position().map(csv::Position::line) {
            Some(line) => Mistake::in_line(source, line as usize, &error.to_string()),
            None => Mistake::plain(format!("{}: {error}", source.name)),
        };
        let names = reader.headers().map_err(wrong)?.clone();
        let rows = reader.records().collect::<Result<Vec<_>, _>>().map_err(wrong)?;
        match rows.is_empty() {
            true => Err(Mistake::plain(format!(
                "{} has no rows\nhelp: the first line names the columns, and each other line is a body or a sample",
                source.name
            ))),
            false => Ok(Self { source, names, rows }),
        }
    }

    pub(crate) fn length(&self) -> usize {
        self.rows.len()
    }

    /// The column of this name, with or without a unit.
    pub(crate) fn column(&self, name: &str) -> Option<usize> {
        let is_named =
            |found: &str| found.strip_prefix(name).is_some_and(|unit| unit.is_empty() || unit.starts_with('_'));
        self.names.iter().position(|found| found == name).or_else(|| self.names.iter().position(is_named))
    }

    /// The bodies of samples: `0` of a column `q0_0`, and `_Sun` of `q_Sun_0`.
    pub(crate) fn bodies(&self) -> Vec<&str> {
        let body = |name: &'_ str| {
            let rest = name.strip_prefix('q')?;
            rest.strip_suffix("_0").or_else(|| rest.split_once("_0_").map(|(body, _)| body)).map(str::len)
        };
        self.names.iter().filter_map(|name| Some(&name[1..=body(name)?])).collect()
    }

    /// Whether a field is empty.
    pub(crate) fn is_empty(&self, row: usize, column: usize) -> bool {
        self.text(row, column).is_empty()
    }

    /// A field.
    pub(crate) fn text(&self, row: usize, column: usize) -> &str {
        self.rows[row].get(column).unwrap_or_default()
    }

    /// The number in a field.
    pub(crate) fn number(&self, row: usize, column: usize) -> Result<f64, Mistake> {
        let text = self.text(row, column);
        text.parse().map_err(|_| {
            let name = self.names.get(column).unwrap_or_default();
            self.wrong(row, &format!("`{name}` has to be a number, but it is `{text}`"))
        })
    }

    /// A mistake in a row.
    pub(crate) fn wrong(&self, row: usize, message: &str) -> Mistake {
        let line = self.rows[row].position().map_or(0, csv::Position::line);
        Mistake::in_line(self.source, line as usize, message)
    }

    /// A mistake in the line of names.
    pub(crate) fn wrong_names(&self, message: &str) -> Mistake {
        let line = self.names.position().map_or(0, csv::Position::line);
        Mistake::in_line(self.source, line as usize, message)
    }
}
