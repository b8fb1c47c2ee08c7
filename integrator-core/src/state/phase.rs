//! Points of phase space.

use crate::state::{compensated::Compensated, coords::Coords, fixed::Fixed, precision::Precision};
use core::{fmt, ops::Neg};

/// A point of phase space: positions and momenta, in the shape of the arguments of the Hamiltonian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase<C> {
    /// Positions.
    pub q: C,
    /// Momenta (not velocities).
    pub p: C,
}

impl<C: Coords> Phase<C> {
    /// Creates a point from positions `q` and momenta `p`.
    ///
    /// The scalar type, `f64` or `f32`, is the precision of a run from this point.
    pub fn new(q: C, p: C) -> Self {
        Self { q, p }
    }

    /// Converts the point to `f64`, for generic code that reads numbers with [`Coords::flat`].
    ///
    /// The correction of a compensated coordinate is added to its value and rounded.
    ///
    /// ```
    /// use integrator_core::{Coords, prelude::*};
    ///
    /// fn largest<C: Coords>(run: &Run<C>) -> f64 {
    ///     run.state().to_f64().q.flat().iter().fold(0.0, |largest: f64, q| largest.max(q.abs()))
    /// }
    /// # struct Rotor;
    /// # #[hamiltonian]
    /// # impl Rotor {
    /// #     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    /// #     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// # }
    /// assert_eq!(largest(&Rotor.run(Phase::compensated([-0.5], [0.0]), 0.1)?), 0.5);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn to_f64(&self) -> Phase<C::With<f64>> {
        // The second part of a coordinate on a grid is the spacing.
        let number = |leaf: C::Leaf| if C::Leaf::REVERSIBLE { leaf.to_f64() } else { leaf.parts().iter().sum() };
        Phase { q: self.q.map(number), p: self.p.map(number) }
    }

    /// Returns the point with the opposite momenta, from which an autonomous system runs back if `T(-p) = T(p)`.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Well;
    ///
    /// #[hamiltonian]
    /// impl Well {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(4) }
    /// }
    ///
    /// let start = Phase::reversible([1.0], [0.25], 1.0 / (1_u64 << 40) as f64);
    /// let mut run = Well.run(start, 0.1)?;
    /// run.advance(100)?;
    /// let mut back = Well.run(run.state().reversed(), 0.1)?;
    /// back.advance(100)?;
    /// assert_eq!(back.state().reversed(), start);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn reversed(&self) -> Self
    where
        C::Leaf: Neg<Output = C::Leaf>,
    {
        let mut reversed = self.clone();
        for leaf in reversed.p.flat_mut() {
            *leaf = -*leaf;
        }
        reversed
    }
}

impl<C: Coords<Leaf = f64>> Phase<C> {
    /// Creates a point for compensated runs, which carry the rounding error of every update of a coordinate.
    pub fn compensated(q: C, p: C) -> Phase<C::With<Compensated<f64>>> {
        let leaf = |value| Compensated { value, carried: 0.0 };
        Phase { q: q.map(leaf), p: p.map(leaf) }
    }

    /// Creates a point on a grid for bitwise reversible runs: the grid point nearest to `q` and `p`.
    ///
    /// `n` steps by `h` and then `n` steps by `-h` return to the bitwise identical point. This requires a symmetric
    /// composition and a Hamiltonian that does not depend on time.
    ///
    /// `grid` is the spacing to which every coordinate is rounded after each update, in the unit of the coordinate. It is a
    /// power of two, such as `1.0 / (1_u64 << 40) as f64`. Coordinates have to stay below 2^51 times the spacing.
    ///
    /// [`run`](crate::Hamiltonian::run) returns an error for another spacing, a start outside this range, and a composition
    /// that is not symmetric. A run that leaves the range stops at its last state within it.
    pub fn reversible(q: C, p: C, grid: f64) -> Phase<C::With<Fixed<f64>>> {
        let leaf = |value| Fixed::new(value, grid);
        Phase { q: q.map(leaf), p: p.map(leaf) }
    }
}

/// A point as it is shown in the `Debug` output of a run: of many coordinates, the first ones.
pub(crate) struct Abridged<'p, C>(pub(crate) &'p Phase<C>);

impl<C: Coords> fmt::Debug for Abridged<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// The most coordinates that are all shown, and how many of more.
        const ALL: usize = 24;
        const FIRST: usize = 3;

        struct First<'l, K>(&'l [K]);

        impl<K: fmt::Debug> fmt::Debug for First<'_, K> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_list().entries(&self.0[..FIRST]).finish_non_exhaustive()
            }
        }

        let Phase { q, p } = self.0;
        let (q, p) = (q.flat(), p.flat());
        if q.len() <= ALL {
            return self.0.fmt(f);
        }
        f.debug_struct("Phase").field("coordinates", &q.len()).field("q", &First(q)).field("p", &First(p)).finish()
    }
}

/// The start of a run with coordinates `C`: a [`Phase`].
///
/// The precision of the run follows from the start, so that generic code does not name it:
///
/// ```
/// use integrator_core::{Method, prelude::*};
///
/// /// The change of the energy over a time.
/// fn change<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: Phase<H::Coords>, h: f64) -> Result<f64, Error> {
///     let mut run = system.run_with(method, start, h)?;
///     let before = run.energy();
///     run.advance((10.0 / h) as u64)?;
///     Ok(run.energy() - before)
/// }
/// # struct Rotor;
/// # #[hamiltonian]
/// # impl Rotor {
/// #     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
/// #     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// # }
/// assert!(change(&Rotor, Yoshida4, Phase::new([1.0], [0.0]), 0.1)?.abs() < 1e-3);
/// # Ok::<(), Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "this system has the coordinates `{C}`, and this initial state is a `{Self}`",
    label = "not an initial state of this system",
    note = "write a `Phase<{C}>`, `Phase::new(q, p)`, with positions and momenta in the shape of the arguments of the \
            system's functions"
)]
pub trait StartOf<C> {
    /// The scalar type.
    type Leaf: Precision;
    /// Returns the point.
    fn into_phase(self) -> Phase<C>;
}

impl<C: Coords> StartOf<C> for Phase<C> {
    type Leaf = C::Leaf;
    fn into_phase(self) -> Self {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_precision_are_converted() {
        let (value, rest) = (0.75, 1.0 / (1_u64 << 40) as f64);
        let expected = Phase::new([value], [-value]);
        assert_eq!(expected.to_f64(), expected);
        assert_eq!(Phase::new([0.75_f32], [-0.75]).to_f64(), expected);
        assert_eq!(Phase::reversible([value], [-value], rest).to_f64(), expected);
        let carries = |value, carried| [Compensated { value, carried }];
        let compensated = Phase::new(carries(value, rest), carries(-value, -rest));
        assert_eq!(compensated.to_f64(), Phase::new([value + rest], [-value - rest]));
    }

    #[test]
    fn many_coordinates_are_abridged() {
        let few = Phase::new([1.0, 2.0], [0.5; 2]);
        assert_eq!(format!("{:?}", Abridged(&few)), format!("{few:?}"));
        let many = Phase::new(vec![[0.5; 3]; 1000], vec![[1.0; 3]; 1000]);
        let shown = "Phase { coordinates: 3000, q: [0.5, 0.5, 0.5, ..], p: [1.0, 1.0, 1.0, ..] }";
        assert_eq!(format!("{:?}", Abridged(&many)), shown);
    }
}
