//! Points of phase space.

use crate::state::{compensated::Compensated, coords::Coords, fixed::Fixed};

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

    /// The point of a grid next to positions `q` and momenta `p`, from which a run can be undone: `n` steps by `h` and
    /// then `n` by `-h` return the very same bits, for every symmetric composition and a Hamiltonian that does not read
    /// the time.
    ///
    /// `grid` is the spacing of the values that every coordinate is rounded to after each update, in the unit of the
    /// coordinate; it has to be a power of two, such as `1.0 / (1_u64 << 40) as f64`. Coordinates have to stay below
    /// 2^51 times the spacing. [`run`](crate::Hamiltonian::run) refuses another spacing, a start beyond the range, and
    /// compositions that are not symmetric; a run that leaves the range stops at its last good state.
    pub fn reversible(q: C, p: C, grid: f64) -> Phase<C::With<Fixed<f64>>> {
        let leaf = |value| Fixed::new(value, grid);
        Phase { q: q.map(leaf), p: p.map(leaf) }
    }
}
