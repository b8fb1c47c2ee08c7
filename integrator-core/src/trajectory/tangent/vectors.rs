//! Deviation vectors as lists of numbers: how far from one they are, multiples of them, and those along coordinates.

#[cfg(feature = "check")]
use crate::scalar::exact::power_of_two;
use crate::{
    scalar::exact::exponent,
    state::{coords::Coords, phase::Phase, precision::Precision},
};
#[cfg(feature = "check")]
use alloc::vec::Vec;

/// The numbers of a point, positions first.
pub(crate) fn numbers<C: Coords>(point: &Phase<C>) -> impl Iterator<Item = f64> + Clone {
    point.q.flat().iter().chain(point.p.flat()).map(|leaf| leaf.to_f64())
}

/// The sums of the squares of its positions and of its momenta.
#[cfg(feature = "check")]
#[inline(always)]
pub(crate) fn squares<C: Coords>(vector: &Phase<C>) -> [f64; 2] {
    [vector.q.flat(), vector.p.flat()].map(|half| {
        let mut sum = 0.0;
        for leaf in half {
            let number = leaf.to_f64();
            sum += number * number;
        }
        sum
    })
}

/// Whether a vector with this sum of squares may be far from one: where it is not, no component is.
#[cfg(feature = "check")]
pub(crate) fn may_be_far<C: Coords>(vector: &Phase<C>, square: f64) -> bool {
    let far = power_of_two(far_from_one::<C::Leaf>());
    let numbers = vector.q.flat().len() + vector.p.flat().len();
    // The exponent of the largest component is between -far and far, if its square is from (2/far)² on and below far². The
    // sum has at most as many such squares as there are numbers; twice that for its roundings.
    let least = 2.0 / far * (2.0 / far) * 2.0 * numbers as f64;
    !(least..far * far).contains(&square)
}

/// The power of two just below the largest component, where that is far from one; nought elsewhere.
pub(crate) fn far_exponent<C: Coords>(vector: &Phase<C>) -> i32 {
    let largest = numbers(vector).fold(0.0, |largest: f64, number| largest.max(number.abs()));
    let exponent = exponent(largest);
    if largest == 0.0 || exponent.abs() < far_from_one::<C::Leaf>() { 0 } else { exponent }
}

/// The exponent of vectors that are far from one: so far from the ends of the numbers that the squares of components
/// stay finite, and that growing by e^11 in each of 64 steps leads nowhere near them; in `f32` by e.
fn far_from_one<K: Precision>() -> i32 {
    if K::EPSILON < f64::from(f32::EPSILON) { 256 } else { 32 }
}

/// A vector times a number.
pub(crate) fn scaled<C: Coords>(vector: &Phase<C>, factor: f64) -> Phase<C> {
    let mut scaled = vector.clone();
    for leaf in scaled.q.flat_mut().iter_mut().chain(scaled.p.flat_mut()) {
        *leaf = C::Leaf::from_parts(leaf.parts().map(|part| part * factor));
    }
    scaled
}

/// The unit vectors in the shape of a point, positions first.
#[cfg(feature = "check")]
pub(crate) fn unit_vectors<C: Coords>(like: &Phase<C>) -> Vec<Phase<C>> {
    let unit = |number: usize| {
        let mut unit = like.clone();
        for (place, leaf) in unit.q.flat_mut().iter_mut().chain(unit.p.flat_mut()).enumerate() {
            *leaf = C::Leaf::from_parts([f64::from(u8::from(place == number)), 0.0]);
        }
        unit
    };
    (0..2 * like.q.flat().len()).map(unit).collect()
}

#[cfg(all(test, feature = "check"))]
mod tests {
    use super::*;

    #[test]
    fn numbers_far_from_one_are_detected_by_their_squares() {
        for exponent in -300..=300 {
            for mantissa in [1.0, 1.5, 2.0_f64.next_down()] {
                let number = mantissa * power_of_two(exponent);
                for vector in [Phase::new([number, 0.0], [0.0, 0.0]), Phase::new([number, -number], [number; 2])] {
                    let may_be = may_be_far(&vector, squares(&vector).iter().sum());
                    assert!(may_be || far_exponent(&vector) == 0, "{number:e}");
                    // Otherwise, each sample would read all vectors.
                    assert!(!may_be || exponent.abs() > 250, "{number:e}");
                }
            }
        }
    }
}
