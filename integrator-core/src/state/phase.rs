//! Points of phase space.

use crate::state::{compensated::Compensated, coords::Coords, fixed::Fixed, precision::Precision};

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

    /// The point in plain `f64`, whatever its leaf type is: what a compensated coordinate carries is added to it, and
    /// rounded. So generic code reads numbers, by [`Coords::flat`].
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
        let number = |leaf: C::Leaf| leaf.parts().iter().sum::<f64>();
        Phase { q: self.q.map(number), p: self.p.map(number) }
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

/// What a run with the coordinates `C` starts from: a [`Phase`] of them.
///
/// The precision of the run follows from the start alone, so that generic code has to name none:
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
    message = "the coordinates of this system are `{C}`, and this start is a `{Self}`",
    label = "not a start of this system",
    note = "a start is a `Phase<{C}>`: `Phase::new(q, p)` with positions and momenta in the shape that the system's functions take"
)]
pub trait StartOf<C> {
    /// The type of one coordinate.
    type Leaf: Precision;
    /// The point.
    fn into_phase(self) -> Phase<C>;
}

impl<C: Coords> StartOf<C> for Phase<C> {
    type Leaf = C::Leaf;
    fn into_phase(self) -> Self {
        self
    }
}
