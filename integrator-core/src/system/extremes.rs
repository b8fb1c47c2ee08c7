//! The least and the greatest value over all bodies or classes of bodies.

use super::classes::ByClass;
use core::ops::Range;

/// Returns the least value of these bodies; negative infinity if one is NaN, which has no bounds, and if there are none.
pub fn least(bodies: Range<usize>, value: &dyn Fn(usize) -> f64) -> f64 {
    -greatest(bodies, &|body| -value(body))
}

/// Returns the greatest value of these bodies; infinity if one is NaN, which has no bounds, and if there are none.
pub fn greatest(bodies: Range<usize>, value: &dyn Fn(usize) -> f64) -> f64 {
    let bounded = |value: f64| if value.is_nan() { f64::INFINITY } else { value };
    bodies.map(value).map(bounded).reduce(f64::max).unwrap_or(f64::INFINITY)
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
    fn values_that_are_no_numbers_have_no_bounds() {
        let values = [2.0, f64::NAN, -3.0, 1.0];
        let of = |bodies: Range<usize>| [least(bodies.clone(), &|at| values[at]), greatest(bodies, &|at| values[at])];
        let unbounded = [f64::NEG_INFINITY, f64::INFINITY];
        assert_eq!([of(0..4), of(1..2), of(4..4)], [unbounded; 3]);
        assert_eq!([of(2..4), of(3..4)], [[-3.0, 1.0], [1.0, 1.0]]);
        let table = ByClass::new([0..4, 0..4], [&|a, b| a == b; 2], &|i, j| (i < j).then_some((i + j) as f64 - 2.0));
        assert_eq!([table.least(), table.greatest()], [-1.0, 3.0]);
    }
}
