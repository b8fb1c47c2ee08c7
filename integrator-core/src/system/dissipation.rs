//! Friction: whether a system has it, and the rates and temperatures that the macro generates.

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System, motion::Plain},
};

/// What the annotated functions of a system add to its Hamiltonian flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dissipation {
    /// Nothing: the motion is Hamiltonian.
    None,
    /// Friction without noise.
    Friction,
    /// Friction with noise of a temperature.
    Heat,
}

/// A system with friction. Written by `#[hamiltonian]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no friction",
    label = "this composition has the letter `O`, which applies friction",
    note = "add `#[friction] fn friction(&self, i: usize) -> f64` next to `kinetic` and `potential`",
    note = "compositions without `O`, such as `Verlet`, integrate systems without friction"
)]
pub trait WithFriction: System {
    /// Whether a rate or a temperature depends on time.
    const READS_TIME: bool = false;
    /// The type that the momenta of a motion are computed in.
    type Wide<R: Real>: Real;

    /// Returns the momenta of a motion.
    fn momenta<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>) -> &mut [K::Slot<Self::Wide<R>>];
    /// Returns the number of the coordinate that a part of a slot is, in the order of `Coords::flat`.
    fn coordinate<R: Real>(slot: usize, part: usize) -> usize;
    /// Returns the rate and the temperature of a coordinate, by its first index, by the user's own functions.
    fn stated_rates(&self, index: usize, time: f64) -> [f64; 2];
    /// Adds the rate of each coordinate to its momentum.
    fn add_rates<R: Real, K: Precision>(motion: &mut PlainOf<Self, R, K>, time: f64);
    /// Adds the temperature of each coordinate to its momentum.
    fn add_temperatures<R: Real, K: Precision>(_motion: &mut PlainOf<Self, R, K>, _time: f64) {}
    /// Adds the velocity of each coordinate to its position.
    fn add_velocities<R: Real, K: Precision>(_motion: &mut PlainOf<Self, R, K>, _time: f64) {}
}

/// The plain motion of a system, whatever layout its steps have.
type PlainOf<H, R, K> = Plain<R, Shaped<H, K>, <H as System>::Parameters<R>>;

/// The momenta of a motion as a list of slots. A slot may have several parts, such as the bodies of a row.
pub trait Momenta<R: Real, K: Precision> {
    /// The type that a slot is computed in.
    type Wide: Real;

    /// Returns all momenta.
    fn momenta(&mut self) -> &mut [K::Slot<Self::Wide>];
    /// Returns the number of the coordinate that a part of a slot is, in the order of `Coords::flat`.
    fn coordinate(slot: usize, _part: usize) -> usize {
        slot
    }
}
