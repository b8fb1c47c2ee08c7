//! The derivatives of a system with respect to its parameters.

use crate::{scalar::real::Real, state::precision::Precision, system::System};

/// The derivatives of a system with respect to the parameters in `sensitive(...)`: none by default.
///
/// `#[hamiltonian]` implements this trait beside [`Hamiltonian`](crate::Hamiltonian), which users name in bounds.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a Hamiltonian",
    label = "has no generated stepper",
    note = "put `#[hamiltonian]` on an `impl {Self}` with the functions `kinetic` and `potential`"
)]
pub trait ParameterDerivatives: System {
    /// The names of the parameters in `sensitive(...)`, in the order of the annotation.
    const SENSITIVE: &'static [&'static str] = &[];

    /// Returns the derivatives of the prepared constants with respect to a parameter in `sensitive(...)`; zeros if there is no
    /// such parameter.
    fn parameter_slopes(&self, length: usize, _parameter: usize) -> Self::Parameters<f64> {
        // Nobody asks for the derivatives of a system without such parameters.
        self.parameters(length)
    }

    /// Whether [`add_slopes_of_kinetic`](Self::add_slopes_of_kinetic) and
    /// [`add_slopes_of_potential`](Self::add_slopes_of_potential) were generated: for `H = T(p) + V(q)` with `sensitive(...)`.
    const ENERGIES_HAVE_SLOPES: bool = false;

    /// Adds `duration` times the derivatives of `T` with respect to the parameters in `sensitive(...)`.
    #[inline(always)]
    fn add_slopes_of_kinetic<R: Real, K: Precision>(
        _motion: &Self::Motion<R, K>,
        _duration: f64,
        _time: f64,
        _slopes: &mut [R],
    ) {
    }

    /// Adds `duration` times the derivatives of `V` with respect to the parameters in `sensitive(...)`.
    #[inline(always)]
    fn add_slopes_of_potential<R: Real, K: Precision>(
        _motion: &Self::Motion<R, K>,
        _duration: f64,
        _time: f64,
        _slopes: &mut [R],
    ) {
    }
}
