//! Systems that have recurrences, seen by code that is generic over all systems.

use super::recurrences::Recurrences;
use crate::system::System;

/// A visitor of systems that have recurrences for the Taylor method. Code that is generic over all systems shows it to
/// [`Hamiltonian::visit_recurrences`](crate::Hamiltonian::visit_recurrences), and can then use the Taylor method for those systems.
pub trait RecurrencesVisitor<H: System> {
    /// Called once if there are recurrences.
    fn visit(&mut self)
    where
        H: Recurrences;
}
