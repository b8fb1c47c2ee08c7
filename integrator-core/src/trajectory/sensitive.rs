//! What the end of a trajectory depends on: its derivatives by parameters of the system, beside those by the start.

use crate::{
    error::Error,
    state::{
        coords::Coords,
        phase::{Phase, StartOf},
        precision::Precision,
    },
    system::{Shaped, parameter_derivatives::ParameterDerivatives},
    trajectory::{
        method::Differentiable,
        tangent::{Beginning, Tangent},
    },
};
use alloc::vec::Vec;
use core::ops::Range;

/// A Hamiltonian whose steps have derivatives with respect to parameters.
///
/// `#[hamiltonian(sensitive(name, ...))]` implements this trait for the parameters that it names.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no parameters with derivatives",
    label = "the annotation has no `sensitive`",
    note = "name fields of `{Self}` that are numbers, as in `#[hamiltonian(sensitive(mass, length))]`"
)]
pub trait Sensitive: ParameterDerivatives {
    /// Starts a run from `start` with step `h` together with the derivatives of its state.
    ///
    /// The [vectors](Tangent::vectors) of the result are the images of `vectors`, which may be empty, followed by the
    /// derivatives with respect to each parameter, in the order of [`ParameterDerivatives::SENSITIVE`]. They are exact derivatives of
    /// the steps taken; the start does not depend on the parameters.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator {
    ///     stiffness: f64,
    /// }
    ///
    /// #[hamiltonian(sensitive(stiffness), compose = Yoshida4)]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { self.stiffness * q[0] * q[0] / 2.0 }
    /// }
    ///
    /// let oscillator = Oscillator { stiffness: 1.0 };
    /// let mut tangent = oscillator.sensitivities(Yoshida4, Phase::new([1.0], [0.0]), [], 0.01)?;
    /// tangent.advance(100)?;
    /// // q = cos(t √k), whose derivative by k is -sin(t) t / 2 at k = 1.
    /// assert!((tangent.vectors()[0].q[0] + 1.0_f64.sin() / 2.0).abs() < 1e-8);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Hamiltonian::tangent`](crate::Hamiltonian::tangent).
    fn sensitivities<K: Precision, X: Differentiable<Self>>(
        &self,
        method: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        vectors: impl IntoIterator<Item = Phase<Shaped<Self, K>>>,
        h: f64,
    ) -> Result<Tangent<Shaped<Self, K>>, Error> {
        let start = start.into_phase();
        let vectors: Vec<_> = vectors.into_iter().collect();
        let (length, first) = (start.q.length(), vectors.len());
        let beginning = Beginning { start, vectors, parameters: Self::SENSITIVE.len(), h, at: None };
        let slopes = |vectors| slopes_of(self, length, first, vectors);
        Tangent::along::<Self, X, K, true>(self, method, beginning, slopes)
    }
}

/// The derivatives of prepared constants that go with some vectors, of which the `first` ones lead along starts. These, and
/// those that fill up a register after the last, leave parameters as they are.
pub(crate) fn slopes_of<H: ParameterDerivatives>(
    system: &H,
    length: usize,
    first: usize,
    vectors: Range<usize>,
) -> Vec<H::Parameters<f64>> {
    let none = H::SENSITIVE.len();
    vectors.map(|vector| system.parameter_slopes(length, vector.checked_sub(first).unwrap_or(none))).collect()
}
