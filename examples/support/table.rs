//! Tables of numbers as text, with a line of names above them and remarks behind `#`.

use std::num::ParseFloatError;

/// Returns the fields of each row.
pub(crate) fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

/// Parses `N` numbers beginning with a field. Missing fields are zero.
pub(crate) fn numbers<const N: usize>(row: &[&str], first: usize) -> Result<[f64; N], ParseFloatError> {
    let mut numbers = [0.0; N];
    for (number, field) in numbers.iter_mut().zip(&row[first.min(row.len())..]) {
        *number = field.trim().parse()?;
    }
    Ok(numbers)
}
