//! Systems that have recurrences, seen by code that is generic over all systems.

use super::recurrences::Recurrences;
use crate::hamiltonian::Hamiltonian;

/// What is done with `H` where it has recurrences for the Taylor method: shown to [`Hamiltonian::visit_recurrences`],
/// code that is generic over all systems can use that method for those that have it.
pub trait RecurrencesVisitor<H: Hamiltonian> {
    /// Called once if there are recurrences.
    fn visit(&mut self)
    where
        H: Recurrences;
}
