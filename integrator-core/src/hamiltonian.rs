//! The trait of Hamiltonians that users name: a system with its annotated method, from which runs are started.

use crate::{
    composition::visitor::{Visitor, visit_general},
    error::Error,
    methods::taylor::RecurrencesVisitor,
    state::{
        phase::{Phase, StartOf},
        precision::Precision,
    },
    system::{Shaped, parameter_derivatives::ParameterDerivatives},
    trajectory::{
        gradient::{Gradient, Reads, gradient},
        method::{Differentiable, Memoryless, Method},
        run::Run,
        samples::Sample,
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
pub trait Hamiltonian: ParameterDerivatives {
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

    /// Computes a function of the end of a run, and its derivatives with respect to the start and to the parameters in
    /// `sensitive(...)`.
    ///
    /// `loss` returns its value at the end, and its derivatives with respect to the positions and momenta there. The derivatives
    /// are carried back along the run as one deviation vector: `steps` steps of `h`, then `steps` steps of `-h`. The time does
    /// not grow with the number of coordinates, and no states are stored. The result is the exact gradient of the steps taken,
    /// up to rounding; [`Gradient::return_error`] tells how far rounding led the way back away from the run.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Pendulum { length: f64 }
    ///
    /// #[hamiltonian(sensitive(length), compose = KahanLi8)]
    /// impl Pendulum {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / (2.0 * self.length * self.length) }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
    /// }
    ///
    /// // The square of the distance of the end from a measured angle.
    /// let loss = |end: &Phase<[f64; 1]>| {
    ///     let miss = end.q[0] - 0.2;
    ///     (miss * miss, Phase::new([2.0 * miss], [0.0]))
    /// };
    /// let start = Phase::new([1.0], [0.0]);
    /// let gradient = Pendulum { length: 1.0 }.gradient(KahanLi8, start, 0.01, 1_000, loss)?;
    ///
    /// let value = |length, angle| {
    ///     let mut run = Pendulum { length }.run(Phase::new([angle], [0.0]), 0.01)?;
    ///     run.advance(1_000)?;
    ///     Ok::<f64, Error>(loss(&run.state()).0)
    /// };
    /// assert_eq!(gradient.value, value(1.0, 1.0)?);
    /// let by_angle = (value(1.0, 1.0001)? - value(1.0, 0.9999)?) / 0.0002;
    /// let by_length = (value(1.0001, 1.0)? - value(0.9999, 1.0)?) / 0.0002;
    /// assert!((gradient.start.q[0] - by_angle).abs() < 1e-5 * by_angle.abs());
    /// assert!((gradient.parameters[0] - by_length).abs() < 1e-5 * by_length.abs());
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// The method is a symmetric composition or an implicit method. On a chaotic orbit, rounding errors of the way back grow as
    /// fast as deviations. From a [reversible](Phase::reversible) start, the way back has the states of the run, bit by bit, for
    /// any number of steps.
    ///
    /// # Errors
    /// - Those of [`Hamiltonian::run`] and [`Run::advance`], on both ways.
    /// - [`Error::NoGradient`]: steps by `-h` do not undo steps of this method, or these are not symplectic.
    /// - [`Error::Loss`]: the derivatives that `loss` returned are not finite, or have another length than the state.
    /// - [`Error::WayBack`]: the way back ended at a relative distance of more than 1e-3 from the start.
    fn gradient<K: Precision, X: Differentiable<Self>>(
        &self,
        method: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
        steps: u64,
        mut loss: impl FnMut(&Phase<Shaped<Self, K>>) -> (f64, Phase<Self::Coords>),
    ) -> Result<Gradient<Self::Coords>, Error> {
        let mut at_end = |sample: &Sample<Shaped<Self, K>>| loss(&sample.state);
        gradient::<Self, X, K>(self, method, start.into_phase(), h, Reads::End(steps), &mut at_end)
    }

    /// Computes the sum of a function over samples of a run, and its derivatives like [`gradient`](Self::gradient).
    ///
    /// The samples are the start and the states after every `interval` steps, up to `steps` steps. `loss` is called twice for
    /// each of them, and has to return the same: on the way there for its value, and on the way back for its derivatives, there
    /// from the last sample to the first.
    ///
    /// ```
    /// use integrator_core::{Sample, prelude::*};
    ///
    /// struct Oscillator { stiffness: f64 }
    ///
    /// #[hamiltonian(sensitive(stiffness))]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { self.stiffness * q[0] * q[0] / 2.0 }
    /// }
    ///
    /// // The distances from a series of measured positions.
    /// let measured = [1.0, 0.5, -0.4, -1.0];
    /// let loss = |sample: &Sample<[f64; 1]>| {
    ///     let miss = sample.state.q[0] - measured[sample.step as usize / 100];
    ///     (miss * miss, Phase::new([2.0 * miss], [0.0]))
    /// };
    /// let start = Phase::new([1.0], [0.0]);
    /// let gradient = Oscillator { stiffness: 1.0 }.gradient_of_samples(Verlet, start, 0.01, 100, 300, loss)?;
    /// assert!(gradient.parameters[0] < 0.0, "a stiffer spring fits better");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`gradient`](Self::gradient), and [`Error::SampleInterval`] if `interval` is 0.
    fn gradient_of_samples<K: Precision, X: Differentiable<Self>>(
        &self,
        method: X,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
        interval: u64,
        steps: u64,
        mut loss: impl FnMut(&Sample<Shaped<Self, K>>) -> (f64, Phase<Self::Coords>),
    ) -> Result<Gradient<Self::Coords>, Error> {
        gradient::<Self, X, K>(self, method, start.into_phase(), h, Reads::Every { interval, steps }, &mut loss)
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
