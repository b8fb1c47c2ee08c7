//! Points of phase space as checks see them: in `f64`, and as one row of numbers.

use crate::{
    coords::Coords,
    hamiltonian::{Hamiltonian, Shaped},
    phase::Phase,
    slot::Keep,
};

/// The values of a point, whatever its leaves carry beside.
pub(crate) fn plain<H: Hamiltonian, K: Keep>(point: &Phase<Shaped<H, K>>) -> Phase<H::Coords> {
    Phase { q: point.q.map(|leaf| leaf.to_f64()), p: point.p.map(|leaf| leaf.to_f64()) }
}

/// The origin, in the shape of `point`.
pub(crate) fn origin<C: Coords<Leaf = f64>>(point: &Phase<C>) -> Phase<C> {
    let mut origin = point.clone();
    origin.q.flat_mut().fill(0.0);
    origin.p.flat_mut().fill(0.0);
    origin
}

/// One number of a point, positions counted first.
pub(crate) fn coordinate<C: Coords<Leaf = f64>>(point: &mut Phase<C>, index: usize) -> &mut f64 {
    let n = point.q.flat().len();
    if index < n { &mut point.q.flat_mut()[index] } else { &mut point.p.flat_mut()[index - n] }
}

/// All numbers of a point, positions first.
pub(crate) fn numbers<C: Coords<Leaf = f64>>(point: &Phase<C>) -> impl Iterator<Item = f64> {
    point.q.flat().iter().chain(point.p.flat()).copied()
}
