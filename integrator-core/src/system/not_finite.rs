//! The search for prepared constants that are not finite, in numbers and in tables of numbers.

use crate::error::NotFinite;
use alloc::vec::Vec;

/// A prepared number, or a table of prepared numbers over the indices of loops.
pub trait Constants {
    /// The first number that is not finite, with its indices in the table, that of the innermost table first.
    fn not_finite(&self) -> Option<(Vec<usize>, f64)>;
}

impl Constants for f64 {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        if self.is_finite() { None } else { Some((Vec::new(), *self)) }
    }
}

impl<T: Constants> Constants for [T] {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        self.iter().enumerate().find_map(|(index, inner)| {
            let (mut indices, value) = inner.not_finite()?;
            indices.push(index);
            Some((indices, value))
        })
    }
}

impl<T: Constants, const N: usize> Constants for [T; N] {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        self.as_slice().not_finite()
    }
}

/// The first of some constants that is not finite, with the user's names of the indices.
pub fn not_finite(formula: &'static str, indices: &[&'static str], constants: &impl Constants) -> Option<NotFinite> {
    let (values, value) = constants.not_finite()?;
    Some(named(formula, indices, values, value))
}

fn named(formula: &'static str, indices: &[&'static str], values: Vec<usize>, value: f64) -> NotFinite {
    NotFinite { formula, indices: indices.iter().copied().zip(values.into_iter().rev()).collect(), value }
}

/// Takes all that were found.
pub fn all_found(found: &mut [Option<NotFinite>]) -> Vec<NotFinite> {
    found.iter_mut().filter_map(Option::take).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::shared_table::SharedTable;

    #[test]
    fn the_first_one_is_named_with_its_indices() {
        let list = SharedTable::<f64>::from;
        let table = [list(vec![1.0, 2.0]), list(vec![3.0, f64::INFINITY, f64::NEG_INFINITY])];
        let found = not_finite("k[i][j]", &["i", "j"], &table).expect("one is infinite");
        assert_eq!(found.to_string(), "`k[i][j]` is inf for i = 1, j = 1");
        assert_eq!(not_finite("k[i][j]", &["i", "j"], &[list(vec![1.0]), list(vec![])]), None);
        assert_eq!(not_finite("mass", &[], &-f64::MAX), None);
    }
}
