//! The trait of Hamiltonians that users name: a system with its annotated method, from which runs are started.

use crate::{
    composition::visitor::{Visitor, visit_general},
    error::Error,
    methods::taylor::RecurrencesVisitor,
    state::{
        phase::{Phase, StartOf},
        precision::Precision,
    },
    system::{Shaped, System},
    trajectory::{
        method::{Differentiable, Memoryless, Method},
        run::Run,
        tangent::Tangent,
    },
};
#[cfg(feature = "checkpoint")]
use crate::{state::coords::Coords, trajectory::checkpoint::CheckpointError};

/// A Hamiltonian that is split into parts with exact flows, such as `H = T(p) + V(q)`.
///
/// `#[hamiltonian]` implements this trait. Programs call [`run`](Self::run), [`run_with`](Self::run_with) and
/// [`tangent`](Self::tangent), and read [`EQUATIONS`](Self::EQUATIONS); all other items are for generated code and
/// executors.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a Hamiltonian",
    label = "has no generated stepper",
    note = "put `#[hamiltonian]` on an `impl {Self}` with the functions `kinetic` and `potential`"
)]
pub trait Hamiltonian: System {
    /// The composition of the annotation, or another method.
    type Compose: Memoryless<Self>;

    /// The energies and the equations of motion, one formula each, such as `dq[0]/dt = p[0]`.
    ///
    /// Empty if they have more than 1,024 bytes.
    ///
    /// ```
    /// # use integrator_core::prelude::*;
    /// # struct Oscillator;
    /// #[hamiltonian]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    /// assert_eq!(Oscillator::EQUATIONS, ["T = p[0]^2 / 2", "V = q[0]^2 / 2", "dq[0]/dt = p[0]", "dp[0]/dt = -q[0]"]);
    /// ```
    const EQUATIONS: &'static [&'static str] = &[];

    /// Calls `visitor` with each composition of the catalogue that can integrate this Hamiltonian.
    ///
    /// - Every splitting: compositions of general class.
    /// - Quadratic `T`: also compositions that require it.
    /// - More than two parts: [compositions without a processor](crate::visit_many_parts) only.
    fn visit_compositions(visitor: &mut impl Visitor<Self>) {
        visit_general(visitor);
    }

    /// Calls `visitor` if recurrences for the Taylor method were generated.
    ///
    /// The Taylor method is compiled only for systems on which this is called.
    fn visit_recurrences(_visitor: &mut impl RecurrencesVisitor<Self>) {}

    /// Starts a run from `start` with step `h` and the annotated composition.
    ///
    /// # Errors
    /// - `h` is zero or not finite.
    /// - The start is not finite, or its `q` and `p` differ in length.
    /// - The energy of the start is not finite. If `H` depends on time, the first `advance` returns this error.
    /// - The parameters give a motion that is not finite, for example a mass of zero.
    /// - The start is reversible (on a grid), and the composition is not symmetric or the start does not fit the grid.
    /// - [`Error::Misread`], in builds with debug assertions: generated energies differ from those of your functions.
    ///
    /// # Panics
    /// If your own functions panic: indices and integer arithmetic are checked as in plain Rust. For example, a list of
    /// the system that is shorter than the start causes an index out of bounds.
    fn run<K: Precision>(
        &self,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
    ) -> Result<Run<Shaped<Self, K>>, Error> {
        Run::start::<Self, Self::Compose, K>(self, Self::Compose::default(), start.into_phase(), h)
    }

    /// Starts a run from `start` with step `h` and any composition or other method that can integrate this Hamiltonian.
    ///
    /// # Errors
    /// As [`Hamiltonian::run`].
    fn run_with<K: Precision, X: Method<Self>>(
        &self,
        method: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
    ) -> Result<Run<Shaped<Self, K>>, Error> {
        Run::start::<Self, X, K>(self, method, start.into_phase(), h)
    }

    /// Starts a run from `start` with step `h` together with the deviation vectors `vectors`.
    ///
    /// The method is a composition or another [`Differentiable`] method. Each vector has the shape of the start; there
    /// are at most as many vectors as positions and momenta together.
    ///
    /// # Errors
    /// - Those of [`Hamiltonian::run`].
    /// - [`Error::VectorCount`]: no vectors, or too many.
    /// - [`Error::Vector`]: a vector is zero, not finite, or of another length than the start.
    /// - [`Error::NoTangent`]: the start is on a grid, or steps evolve two copies of the state.
    fn tangent<K: Precision, X: Differentiable<Self>>(
        &self,
        method: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        vectors: impl IntoIterator<Item = Phase<Shaped<Self, K>>>,
        h: f64,
    ) -> Result<Tangent<Shaped<Self, K>>, Error> {
        Tangent::start::<Self, X, K>(self, method, start.into_phase(), vectors.into_iter().collect(), h)
    }
}

#[cfg(feature = "checkpoint")]
impl<C: Coords> Run<C> {
    /// Resumes a run from a checkpoint, with the annotated composition of its system.
    ///
    /// # Errors
    /// - The bytes are not a checkpoint, are damaged, or have another format version.
    /// - The checkpoint is of another composition, another precision, or another system. Systems are compared by the names
    ///   of their types, the formulas of their energies and the values of their parameters.
    /// - The run cannot continue from the stored state.
    ///
    /// Parameters are compared bitwise. This includes parameters that only a `#[flow]` function, a function with a stated
    /// derivative, or a method that these call reads. If such a function reads a field that neither consists of numbers nor
    /// implements `Hash`, the impl needs `fn fingerprint(&self) -> u64`, which is compared instead.
    pub fn resume<H>(system: &H, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resume_with(system, H::Compose::default(), checkpoint)
    }

    /// Resumes a run from a checkpoint with changed parameters or formulas, and the annotated composition of its system.
    ///
    /// The run continues from the stored state, which is in the middle of a step. The current step is therefore taken partly
    /// with the old and partly with the new parameters.
    ///
    /// # Errors
    /// Those of [`Run::resume`], except for differences of parameters and formulas.
    pub fn resume_with_changed_parameters<H>(system: &H, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resume_with_changed_parameters_with(system, H::Compose::default(), checkpoint)
    }
}
