//! Prepared constants as a search for one that is not finite sees them: numbers, and tables of numbers.

use crate::error::NotFinite;
use alloc::vec::Vec;

/// A prepared number, or a table of prepared numbers over the indices of loops.
pub trait Constants {
    /// The first number that is not finite, with its place in the table.
    ///
    /// Places are put together from the inside out: the index of the innermost table comes first.
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
            let (mut place, value) = inner.not_finite()?;
            place.push(index);
            Some((place, value))
        })
    }
}

impl<T: Constants, const N: usize> Constants for [T; N] {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        self.as_slice().not_finite()
    }
}

impl<T: Constants> Constants for Vec<T> {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        self.as_slice().not_finite()
    }
}

/// The first of some constants that is not finite, as the user would look for it.
pub fn not_finite(formula: &'static str, indices: &[&'static str], constants: &impl Constants) -> Option<NotFinite> {
    let (place, value) = constants.not_finite()?;
    Some(NotFinite { formula, indices: indices.iter().copied().zip(place.into_iter().rev()).collect(), value })
}

/// Those that were found.
pub fn all_found<const N: usize>(found: [Option<NotFinite>; N]) -> Vec<NotFinite> {
    found.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_one_is_named_with_its_place() {
        let table = [vec![1.0, 2.0], vec![3.0, f64::INFINITY, f64::NEG_INFINITY]];
        let found = not_finite("k[i][j]", &["i", "j"], &table).expect("one is infinite");
        assert_eq!(found.to_string(), "`k[i][j]` is inf for i = 1, j = 1");
        assert_eq!(not_finite("k[i][j]", &["i", "j"], &[vec![1.0], vec![]]), None);
        assert_eq!(not_finite("mass", &[], &-f64::MAX), None);
    }
}
