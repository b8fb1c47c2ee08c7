//! Tables of results, printed as text and written to `target/bench` as CSV.

use std::{fs, path::PathBuf};

/// A table with a head; rows are printed as they are added.
pub struct Table {
    name: &'static str,
    widths: Vec<usize>,
    rows: Vec<Vec<String>>,
}

/// Returns the directory of tables and plots.
pub fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/bench"))
}

impl Table {
    /// Creates a table and prints its head. The first two columns contain text, the others numbers.
    pub fn new(name: &'static str, head: &[&str]) -> Self {
        let widths = head.iter().enumerate().map(|(i, word)| word.len().max(if i < 2 { 24 } else { 10 })).collect();
        let mut table = Self { name, widths, rows: Vec::new() };
        table.push(head.iter().map(|&word| word.to_owned()).collect());
        table
    }

    /// Prints and stores a row.
    pub fn row(&mut self, words: [&str; 2], numbers: &[f64]) {
        let words = words.into_iter().map(str::to_owned);
        self.push(words.chain(numbers.iter().map(|number| shown(*number))).collect());
    }

    fn push(&mut self, row: Vec<String>) {
        let cells = row
            .iter()
            .zip(&self.widths)
            .enumerate()
            .map(|(i, (cell, width))| if i < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") });
        println!("{}", cells.collect::<Vec<_>>().join(" ").trim_end());
        self.rows.push(row);
    }

    /// Writes `target/bench/<name>.csv`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self) -> Result<(), csv::Error> {
        fs::create_dir_all(folder())?;
        let mut writer = csv::Writer::from_path(folder().join(self.name).with_extension("csv"))?;
        for row in &self.rows {
            writer.write_record(row)?;
        }
        Ok(writer.flush()?)
    }
}

/// Formats a number with four digits; NaN gives an empty string.
#[must_use]
pub fn shown(number: f64) -> String {
    match number {
        _ if number.is_nan() => String::new(),
        _ if number == 0.0 || (1e-3..1e6).contains(&number.abs()) => {
            let digits = 3 - (number.abs().log10().floor() as i32).clamp(-3, 3);
            format!("{number:.0$}", digits as usize)
        }
        _ => format!("{number:.3e}"),
    }
}
