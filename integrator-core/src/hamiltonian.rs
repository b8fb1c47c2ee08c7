//! The trait of systems, which `#[hamiltonian]` implements, and the trait of flows, through which compositions see
//! them.

use crate::{
    composition::visitor::{Visitor, visit_general},
    error::Error,
    flow::doubled::{Moved, Read},
    layout::lattice::{
        sites::{MovedSites, Sites},
        time_tiling::{Flow, StencilRadii},
    },
    methods::taylor::RecurrencesVisitor,
    scalar::real::Real,
    state::{
        coords::Coords,
        phase::{Phase, StartOf},
        precision::Precision,
    },
    system::motion::{Motion, Prepared},
    trajectory::{
        method::{Differentiable, Memoryless, Method},
        run::Run,
        tangent::Tangent,
    },
};
use core::ops::Range;

/// The coordinates of `H` with leaf `K`.
pub type Shaped<H, K> = <<H as Hamiltonian>::Coords as Coords>::With<K>;

/// The slots of the positions or the momenta of `H`.
type SlotsOf<H, R, K> = <Shaped<H, K> as Coords>::Slots<R>;

/// What the field of `H` is read from.
pub type ReadBy<'m, H, R, K> = Read<'m, SlotsOf<H, R, K>, <H as Hamiltonian>::Parameters<R>>;

/// What the field of `H` moves.
pub type MovedBy<'m, H, R, K> = Moved<'m, SlotsOf<H, R, K>>;

/// A Hamiltonian that is split into parts, `H = T(p) + V(q)` or others, with their exact flows. Written by `#[hamiltonian]`; not by hand.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a Hamiltonian",
    label = "has no generated stepper",
    note = "put `#[hamiltonian]` on an `impl {Self}` with the functions `kinetic` and `potential`"
)]
pub trait Hamiltonian: Sized {
    /// The shape of `q` and of `p`, with `f64` leaves.
    type Coords: Coords<Leaf = f64, With<f64> = Self::Coords>;
    /// The annotated composition, or another method.
    type Compose: Memoryless<Self>;
    /// The prepared constants, which depend on parameters alone.
    type Parameters<R: Real>: Prepared<R, Single = Self::Parameters<f64>>;
    /// Prepared constants and state, in the layout that the generator chose.
    type Motion<R: Real, K: Precision>: Motion<Shaped<Self, K>, Self::Parameters<f64>>;

    /// The names of the parts, in the order of the letters A, B, C; none where H stays in one piece, which methods that
    /// take the whole of its field integrate and no composition.
    const PARTS: &'static [&'static str] = &["kinetic", "potential"];
    /// Whether all parts behind the first are one part of a composition, which their flows approximate in a symmetric
    /// step: those of `middle` for half the duration, that of `kick`, and those of `middle` backwards.
    const PAIRED: bool = false;
    /// Whether H = T(p) + V(q): a drift moves positions alone, by what momenta say, a kick momenta alone.
    const SEPARABLE: bool = true;
    /// How exact the derivatives of flows by duals are, in units of those of the chain rule: a flow that the user wrote has
    /// extrapolated differences instead, which lose one or two digits more.
    const TANGENT_ERROR: f64 = 1.0;
    /// Whether a motion is that of two coupled copies of the state, of which one is shown (Tao 2016): it is symplectic and
    /// runs back in the space of both, and not where one is seen alone.
    const COPIES: bool = false;
    /// Whether no part reads the time, so that the energy is conserved.
    const AUTONOMOUS: bool;
    /// Whether a flow changes its formula at times that the clock and parameters alone decide: a switch, a pulse. Steps
    /// are then taken one by one, each with the formulas of its middle, and their stages are not merged.
    const PIECEWISE_IN_TIME: bool = false;
    /// Whether a single run gains from vectors of 512 bits: its flows compute neighbours or bodies side by side. Code
    /// for numbers one by one can be slower there, and is then compiled for AVX2 at most.
    const WIDE: bool = false;
    /// Whether a choice among flows costs nothing beside any of them: one loop, which reads the table of the composition, is then
    /// compiled for all stages of all compositions.
    const LARGE_FLOWS: bool = false;
    /// A fingerprint of the generated flows and energies: another one, and a checkpoint belongs to another motion.
    const FINGERPRINT: u64 = 0;
    /// The names of the functions that the user says are conserved.
    const INVARIANTS: &'static [&'static str] = &[];
    /// The stencil radii of the flows of a lattice whose sites can be moved a segment at a time.
    const STENCIL_RADII: Option<StencilRadii> = None;

    /// Whether the coordinates of the motion can be made of the system and a start of so many numbers or points.
    ///
    /// # Errors
    /// [`Error::FewMasses`], [`Error::Mass`]
    fn admissible(&self, _length: usize) -> Result<(), Error> {
        Ok(())
    }
    /// Evaluates what depends on parameters alone, by the user's own expressions.
    ///
    /// `length` is how many numbers or points the positions of the start are.
    fn parameters(&self, length: usize) -> Self::Parameters<f64>;
    /// Sets the middle of the step under way, at which conditions on the time are read.
    fn begin_step<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>, _middle: f64) {}
    /// The exact flow of `T`, or of the first part, for a time `duration`; `time` is where an explicit time dependence is read.
    fn drift<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// The flows of the parts between the first and the last, in their order, or backwards; `time` is where an explicit
    /// time dependence is read.
    fn middle<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>, _duration: f64, _time: f64, _backwards: bool) {}
    /// The exact flow of `V`, or of the last part, for a time `duration`; `time` is where an explicit time dependence is read.
    fn kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// Moves coordinates by `duration` times the field of H, `∂H/∂p` and `-∂H/∂q`, at those that are read. Written where H
    /// is no `T + V` in the user's own coordinates; there the flows of `T` and of `V` tell the field.
    fn along_field<R: Real, K: Precision>(
        _motion: ReadBy<'_, Self, R, K>,
        _moved: MovedBy<'_, Self, R, K>,
        _duration: f64,
        _time: f64,
    ) {
    }
    /// `T`, or the energy of the first part.
    fn kinetic<R: Real, K: Precision>(motion: &Self::Motion<R, K>, time: f64) -> R;
    /// `V`, or the energy of all parts but the first.
    fn potential<R: Real, K: Precision>(motion: &Self::Motion<R, K>, time: f64) -> R;

    /// The energy by the user's own functions, as they are written: what the generated code is held against.
    fn stated(&self, q: &Self::Coords, p: &Self::Coords, time: f64) -> StatedEnergy;

    /// The value of an invariant, by its place in [`Hamiltonian::INVARIANTS`].
    fn invariant<R: Real, K: Precision>(_motion: &Self::Motion<R, K>, _number: usize) -> R {
        R::of(f64::NAN)
    }

    /// The same by the user's own function, as it is written.
    fn stated_invariant(&self, _number: usize, _q: &Self::Coords, _p: &Self::Coords) -> f64 {
        f64::NAN
    }

    /// The sites of a lattice, if it can be moved a segment at a time.
    fn sites<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>) -> Option<Sites<'_, R, K, Self::Parameters<R>>> {
        None
    }
    /// Applies a flow to some sites of a lattice.
    fn apply_to_sites<R: Real, K: Precision>(
        _lattice: MovedSites<'_, R, K, Self::Parameters<R>>,
        _flow: &Flow,
        _sites: Range<usize>,
    ) {
    }

    /// Shows `visitor` each composition of the catalogue that may integrate this Hamiltonian: those for every `T`, and
    /// where `T` is quadratic the others too; of more than two parts, [those without a
    /// processor](crate::visit_many_parts).
    fn visit_compositions(visitor: &mut impl Visitor<Self>) {
        visit_general(visitor);
    }

    /// Calls `visitor` where recurrences for the Taylor method were written. Nothing is compiled for it where this is
    /// not called.
    fn visit_recurrences(_visitor: &mut impl RecurrencesVisitor<Self>) {}

    /// A run from `start` with step `h` and the annotated composition.
    ///
    /// # Errors
    /// A step that is zero or not finite; a start that is not finite or whose `q` and `p` differ in length, or whose
    /// energy is not finite (where `H` reads the time, the first `advance` returns this error); parameters that make
    /// the motion from this start infinite or not a number, such as a mass of zero; a reversible start with a
    /// composition that is not symmetric, or with a grid that it does not fit. Where the runtime was built with debug
    /// assertions, also [`Error::Misread`], if the generated energies are not those of your functions.
    ///
    /// # Panics
    /// Where your own functions would: their indices and their integer arithmetic are checked in a run as they are in
    /// plain Rust. A list of the system that is too short for the start is an index out of bounds.
    fn run<K: Precision>(
        &self,
        start: impl StartOf<Shaped<Self, K>, Leaf = K>,
        h: f64,
    ) -> Result<Run<Shaped<Self, K>>, Error> {
        Run::start::<Self, Self::Compose, K>(self, Self::Compose::default(), start.into_phase(), h)
    }

    /// A run from `start` with step `h` and any composition, or another method, that may integrate this Hamiltonian.
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

    /// A run from `start` with step `h` and any composition, or another [`Differentiable`] method, beside it the derivative of
    /// its steps along `vectors`: at most as many as there are positions and momenta, each in the shape of the start.
    ///
    /// # Errors
    /// As [`Hamiltonian::run`]. [`Error::VectorCount`], [`Error::Vector`]: no or too many vectors, or one that is zero,
    /// not finite, or of another length. [`Error::NoTangent`]: a start on a grid, or steps of two copies of the state.
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

/// A Hamiltonian with `T = ½ pᵀ M⁻¹ p` and a constant `M`. Written by `#[hamiltonian]`, which decides it symbolically.
#[diagnostic::on_unimplemented(
    message = "H of `{Self}` is not ½ pᵀ M⁻¹ p + V(q) with a constant M",
    label = "this composition needs H = ½ pᵀ M⁻¹ p + V(q)",
    note = "its order conditions were shortened for such an H; on another one it would lose its order",
    note = "compositions of general class, such as `Yoshida4` and `KahanLi8`, integrate every splitting"
)]
pub trait QuadraticKinetic: Hamiltonian {
    /// Replaces the momenta by the Hessian of `V` times the momenta.
    fn hessian<R: Real>(motion: &mut Self::Motion<R, f64>, time: f64);
    /// The exact flow of `duration·V + gradient·|∇V|²`, with the norm that `M⁻¹` defines.
    fn gradient_kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, gradient: f64, time: f64);
}

/// The flows that a composition calls: the executor decides which motions they are applied to.
pub trait Flows<H: Hamiltonian> {
    /// Whether coordinates carry the rounding errors of updates, so that durations have to add up as well.
    const COMPENSATED: bool;

    /// Sets the middle of the step under way: [`Hamiltonian::begin_step`].
    fn begin_step(&mut self, _middle: f64) {}
    /// The flow of `T`.
    fn drift(&mut self, duration: f64, time: f64);
    /// The flow of `V`.
    fn kick(&mut self, duration: f64, time: f64);
    /// The flows of the parts between the first and the last: [`Hamiltonian::middle`].
    fn middle(&mut self, duration: f64, time: f64, backwards: bool);
    /// The flow of `duration·V + gradient·|∇V|²`.
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic;
}

/// One motion.
pub(crate) struct Single<'m, H: Hamiltonian, R: Real, K: Precision>(pub(crate) &'m mut H::Motion<R, K>);

impl<H: Hamiltonian, R: Real, K: Precision> Flows<H> for Single<'_, H, R, K> {
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        H::begin_step::<R, K>(self.0, middle);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drift(&mut self, duration: f64, time: f64) {
        H::drift::<R, K>(self.0, duration, time);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn kick(&mut self, duration: f64, time: f64) {
        H::kick::<R, K>(self.0, duration, time);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn middle(&mut self, duration: f64, time: f64, backwards: bool) {
        H::middle::<R, K>(self.0, duration, time, backwards);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        H::gradient_kick::<R, K>(self.0, duration, gradient, time);
    }
}

/// The energy of a state by the user's own functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StatedEnergy {
    /// By `kinetic` and `potential`, or by the functions of parts with names.
    Separate {
        /// `T`, or the energy of the first part.
        kinetic: f64,
        /// `V`, or the energy of all other parts together.
        potential: f64,
    },
    /// By `hamiltonian`.
    Whole(f64),
}
