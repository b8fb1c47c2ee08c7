//! The size of the second part of `H` relative to the first.
//!
//! In: a system and states along an orbit. Out: how strongly the second part moves the coordinates that both parts
//! move, in units of the first part or of both together. Always true: the result is independent of the units of
//! coordinates, since each is measured in its own unit; a coordinate in which the first part happens to vanish has no
//! larger weight than any other.

use crate::{
    check::property::{
        agreement::Visited,
        energies::{Differentiable, Part, slopes},
    },
    scalar::tolerance::{length, ratio},
};

/// The size of a second part from which on the powers of it, for which generalised orders are claimed, do not fall.
pub(crate) const SMALL: f64 = 1.0;

/// The root mean square of the derivatives of the second part over that of the first or of H, whichever is smaller: a first part that
/// is far too strong is undone by the second one, and H is what is left. Each derivative is taken in units of those of both parts by
/// its coordinate. `None` where the parts share no coordinate, as `T(p)` and `V(q)`.
pub(crate) fn size_of_second_part(system: &dyn Differentiable, states: &[Visited]) -> Option<f64> {
    let along = |part: Part| -> Vec<Vec<f64>> {
        states.iter().map(|(state, time)| slopes(system, part, state, *time)).collect()
    };
    let [first, second] = Part::BOTH.map(along);
    let (mut of_first, mut of_second, mut of_both) = (Vec::new(), Vec::new(), Vec::new());
    for coordinate in 0..first.first()?.len() {
        let by_coordinate = || first.iter().zip(&second).map(|(one, other)| [one[coordinate], other[coordinate]]);
        let one = length(by_coordinate().map(|[one, _]| one));
        let other = length(by_coordinate().map(|[_, other]| other));
        // Numbers that are not finite stay, so that the result shows them.
        if one != 0.0 && other != 0.0 {
            let unit = one + other;
            of_first.push(one / unit);
            of_second.push(other / unit);
            of_both.push(length(by_coordinate().map(|[one, other]| one + other)) / unit);
        }
    }
    let unit = length(of_first).min(length(of_both));
    (!of_second.is_empty()).then(|| ratio(length(of_second), unit))
}
