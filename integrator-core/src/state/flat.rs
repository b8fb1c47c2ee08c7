//! Flat points of phase space, without the shape of their coordinates: code that is not hot is compiled for these,
//! once.

use crate::state::{coords::Coords, phase::Phase, precision::Precision};
use alloc::vec::Vec;

/// A point without its shape: all numbers of its positions, and all of its momenta.
pub(crate) type Flat = Phase<Vec<f64>>;

/// The values of a point without its shape.
pub(crate) fn flat<C: Coords>(point: &Phase<C>) -> Flat {
    Phase { q: values(point.q.flat()), p: values(point.p.flat()) }
}

fn values<K: Precision>(leaves: &[K]) -> Vec<f64> {
    let mut values = Vec::with_capacity(leaves.len());
    for leaf in leaves {
        values.push(leaf.to_f64());
    }
    values
}

/// The point with these numbers, in the shape of another one.
#[cfg(any(debug_assertions, feature = "check"))]
pub(crate) fn shaped<C: Coords<Leaf = f64>>(like: &Phase<C>, numbers: &Flat) -> Phase<C> {
    let mut point = like.clone();
    overwrite(point.q.flat_mut(), &numbers.q);
    overwrite(point.p.flat_mut(), &numbers.p);
    point
}

#[cfg(any(debug_assertions, feature = "check"))]
fn overwrite(numbers: &mut [f64], with: &[f64]) {
    for (number, with) in numbers.iter_mut().zip(with) {
        *number = *with;
    }
}
