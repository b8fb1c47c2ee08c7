//! Numbers of inner steps among the splittings of a choice.

use super::{
    Split,
    candidate::{Candidate, candidates_with_inner_steps},
    splitting::{Energies, Erased, Measured, Splitting, of_system},
};
use crate::{
    check::{
        oracle::reference::Reference,
        start::Start,
        statistics::path::{Path, Scale},
    },
    composition::inner_steps::Nested,
    error::Error,
    hamiltonian::Hamiltonian,
    state::{coords::Coords, flat::Flat},
};

/// The numbers of inner steps that a choice tries.
pub(super) const TRIED: [u32; 6] = [1, 2, 4, 8, 16, 32];

/// A system with a number of inner steps, as a splitting for [`choose_among`](super::choose_among).
///
/// [`choose`](fn@super::choose) tries 1, 2, 4, 8, 16 and 32 inner steps by itself.
#[derive(Clone, Copy, Debug)]
pub struct NestedSteps<'s, H> {
    /// The system.
    pub system: &'s H,
    /// The number of inner steps: that of [`Scheme::nested`](crate::Scheme::nested).
    pub steps: u32,
}

impl<H: Hamiltonian + Nested<0>, C: Coords> Splitting<C> for NestedSteps<'_, H>
where
    H::Coords: Coords<With<C::Leaf> = C>,
{
    fn measured(&self) -> Erased<'_, C> {
        Erased(self)
    }
}

impl<H: Hamiltonian, C: Coords> Measured<C> for NestedSteps<'_, H>
where
    H::Coords: Coords<With<C::Leaf> = C>,
{
    fn name(&self) -> Split {
        Split { inner_steps: Some(self.steps), ..Measured::<C>::name(self.system) }
    }
    fn candidates(&self, _: &Start<C>, _: f64) -> Result<Vec<Candidate<'_, C>>, &'static str> {
        Ok(candidates_with_inner_steps::<H, C::Leaf>(self.system, Some(self.steps)))
    }
    of_system!(system);
}
