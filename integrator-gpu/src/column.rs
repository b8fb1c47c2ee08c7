//! One member in the memory of the device.

use integrator_core::{
    __private::{Coords, Precision},
    Phase,
};

/// Writes the numbers of one member to a state.
pub(crate) fn read_column<C: Coords>(columns: &[f64], members: usize, member: usize, to: &mut Phase<C>) {
    let count = to.q.flat().len();
    let number = |part: usize, half: usize, coordinate: usize| {
        columns[((2 * part + half) * count + coordinate) * members + member]
    };
    let leaf = |half: usize, coordinate: usize| {
        let mut parts = [0.0; 2];
        for (part, value) in parts.iter_mut().enumerate().take(C::Leaf::PARTS) {
            *value = number(part, half, coordinate);
        }
        C::Leaf::from_parts(parts)
    };
    to.q.flat_mut().iter_mut().enumerate().for_each(|(coordinate, to)| *to = leaf(0, coordinate));
    to.p.flat_mut().iter_mut().enumerate().for_each(|(coordinate, to)| *to = leaf(1, coordinate));
}
