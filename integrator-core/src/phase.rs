//! A point of phase space.

use crate::{coords::Coords, slot::Compensated};

/// Positions and momenta, in the shape that the Hamiltonian's functions take them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase<C> {
    /// Positions.
    pub q: C,
    /// Momenta (not velocities).
    pub p: C,
}

impl<C: Coords> Phase<C> {
    /// The point with positions `q` and momenta `p`. Its leaf type decides the precision of a run from it.
    pub fn new(q: C, p: C) -> Self {
        Self { q, p }
    }
}

impl<C: Coords<Leaf = f64>> Phase<C> {
    /// The point with positions `q` and momenta `p`, from which a run carries the rounding error of every update.
    pub fn compensated(q: C, p: C) -> Phase<C::With<Compensated<f64>>> {
        let leaf = |value| Compensated { value, carried: 0.0 };
        Phase { q: q.map(leaf), p: p.map(leaf) }
    }
}
