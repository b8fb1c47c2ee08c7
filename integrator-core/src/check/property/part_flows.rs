//! The flows of parts without type parameters, for the checks of flows.
//!
//! Always true: they move a state of the system in its own layout, by the flows that a run calls.

use crate::{
    check::{
        flow::{Flow, moved},
        property::energies::{Differentiable, Energies},
    },
    hamiltonian::Hamiltonian,
    scalar::{dual::Dual, real::Real},
    state::{
        flat::{Flat, flat, shaped},
        phase::Phase,
    },
    system::motion::Motion,
};

/// The flows of a system, one after the other, whatever the shape of its coordinates.
pub(crate) trait Flows: Differentiable {
    /// The names of the parts.
    fn parts(&self) -> &'static [&'static str];

    /// Whether flows move two copies of the state.
    fn copies(&self) -> bool;

    /// Returns the error of tangents, in units of that of the chain rule.
    fn tangent_error(&self) -> f64;

    /// Whether loading and storing a state mixes its coordinates.
    fn mixes(&self) -> bool;

    /// Returns the image of a point under some flows, each for a duration, and the image of a tangent at the point.
    fn carried(&self, flows: &[(Flow, f64)], point: &Flat, tangent: Option<&Flat>, time: f64) -> (Flat, Flat);
}

impl<H: Hamiltonian> Flows for Energies<'_, H> {
    fn parts(&self) -> &'static [&'static str] {
        H::PARTS
    }

    fn copies(&self) -> bool {
        H::COPIES
    }

    fn tangent_error(&self) -> f64 {
        H::TANGENT_ERROR
    }

    fn mixes(&self) -> bool {
        H::Motion::<f64, f64>::MIXES
    }

    fn carried(&self, flows: &[(Flow, f64)], point: &Flat, tangent: Option<&Flat>, time: f64) -> (Flat, Flat) {
        // T and V have no separate flows to test, and nothing is compiled for them.
        if const { H::SEPARABLE } {
            return (point.clone(), point.clone());
        }
        let mut lanes = [point, tangent.unwrap_or(point)].map(|numbers| shaped(self.shape, numbers));
        match tangent {
            None => carry::<H, f64>(&self.parameters, flows, &mut lanes, time),
            Some(_) => carry::<H, Dual>(&self.parameters, flows, &mut lanes, time),
        }
        let [point, tangent] = lanes.map(|point| flat(&point));
        (point, tangent)
    }
}

/// Moves a point by some flows, with a tangent in the second lane if the scalar has one.
fn carry<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    flows: &[(Flow, f64)],
    lanes: &mut [Phase<H::Coords>; 2],
    time: f64,
) {
    let motion = moved::<H, R>(parameters, flows, [&lanes[0], &lanes[1]], time);
    for (lane, point) in lanes.iter_mut().enumerate().take(R::LANES) {
        motion.store(lane, point);
    }
}
