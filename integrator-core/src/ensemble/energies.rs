//! The energies of the members of an ensemble and what they conserve: one function for all, each with its prepared constants.

use crate::{
    state::{
        coords::Coords,
        point::{Point, shaped},
        precision::Precision,
    },
    system::{
        System,
        energy::{EnergyOf, InvariantsOf, Parts, energy},
    },
};
use alloc::{sync::Arc, vec::Vec};

/// The energy functions of the members of an ensemble, by their numbers.
pub(crate) trait EnergiesOfMembers: Send + Sync {
    fn parts(&self, member: usize, state: &dyn Point, time: f64) -> Parts;

    /// The names of the invariants.
    fn invariants(&self) -> &'static [&'static str];

    /// The invariant of this number.
    fn invariant(&self, member: usize, number: usize, state: &dyn Point) -> f64;
}

/// The energy functions of systems with these prepared constants.
pub(crate) fn energies_of_members<H: System, K: Precision>(
    parameters: Vec<Arc<H::Parameters<f64>>>,
) -> Arc<dyn EnergiesOfMembers> {
    Arc::new(MemberFunctions { parameters, energy: energy::<H, K>, invariants: InvariantsOf::of::<H, K>() })
}

/// The energy functions, with one function pointer for all members.
struct MemberFunctions<P, C> {
    parameters: Vec<Arc<P>>,
    energy: EnergyOf<P, C>,
    invariants: InvariantsOf<P, C>,
}

impl<P: Send + Sync, C: Coords> EnergiesOfMembers for MemberFunctions<P, C> {
    fn parts(&self, member: usize, state: &dyn Point, time: f64) -> Parts {
        (self.energy)(&self.parameters[member], shaped(state), time, None)
    }

    fn invariants(&self) -> &'static [&'static str] {
        self.invariants.names
    }

    fn invariant(&self, member: usize, number: usize, state: &dyn Point) -> f64 {
        (self.invariants.value)(&self.parameters[member], shaped(state), number)
    }
}
