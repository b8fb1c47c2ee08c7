//! The least and the greatest value over all bodies or classes of bodies.

use super::classes::ByClass;
use core::ops::Range;

/// Returns the least value of these bodies, without those that are not numbers; NaN if there is none.
pub fn least(bodies: Range<usize>, value: &dyn Fn(usize) -> f64) -> f64 {
    bodies.map(value).fold(f64::NAN, f64::min)
}

/// Returns the greatest value of these bodies, without those that are not numbers; NaN if there is none.
pub fn greatest(bodies: Range<usize>, value: &dyn Fn(usize) -> f64) -> f64 {
    bodies.map(value).fold(f64::NAN, f64::max)
}

impl ByClass<f64> {
    /// Returns the least entry; entries of classes without a pair count as zeros.
    pub fn least(&self) -> f64 {
        least(0..self.entries.len(), &|at| self.entries[at])
    }
    /// Returns the greatest entry; entries of classes without a pair count as zeros.
    pub fn greatest(&self) -> f64 {
        greatest(0..self.entries.len(), &|at| self.entries[at])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_leave_out_what_is_no_number() {
        let values = [2.0, f64::NAN, -3.0, 1.0];
        let of = |bodies: Range<usize>| [least(bodies.clone(), &|at| values[at]), greatest(bodies, &|at| values[at])];
        assert_eq!(of(0..4), [-3.0, 2.0]);
        assert_eq!(of(3..4), [1.0, 1.0]);
        assert!(of(1..2).into_iter().all(f64::is_nan));
        let table = ByClass::new([0..4, 0..4], [&|a, b| a == b; 2], &|i, j| (i < j).then_some((i + j) as f64 - 2.0));
        assert_eq!([table.least(), table.greatest()], [-1.0, 3.0]);
    }
}
