//! Systems: flows and energies that the macro generates, the state in its layout, prepared constants, lists and functions
//! of the user.

pub(crate) mod by_value;
pub(crate) mod classes;
pub(crate) mod counts;
pub(crate) mod device_text;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod dissipation;
pub(crate) mod elements;
pub(crate) mod energy;
pub(crate) mod entries;
pub(crate) mod equal_values;
pub(crate) mod external;
pub(crate) mod extremes;
pub(crate) mod flow_layout;
pub(crate) mod flows;
pub(crate) mod inner_steps;
pub(crate) mod integers;
pub(crate) mod least_length;
pub(crate) mod motion;
pub(crate) mod not_finite;
pub(crate) mod pair_set;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod parameter_derivatives;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod prepared;
pub(crate) mod read_by_methods;
pub(crate) mod shared_table;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod sites;
#[cfg(any(debug_assertions, feature = "check"))]
pub(crate) mod user_energies;

use crate::{
    error::Error,
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    system::{
        dissipation::Dissipation,
        inner_steps::InnerSteps,
        motion::{Motion, Moved, Prepared, Read},
        sites::{Flow, MovedSites, Sites, StencilRadii},
    },
};
use core::ops::Range;

/// The coordinates of `H` with leaf `K`.
pub type Shaped<H, K> = <<H as System>::Coords as Coords>::With<K>;

/// The slots of the positions or the momenta of `H`.
type SlotsOf<H, R, K> = <Shaped<H, K> as Coords>::Slots<R>;

/// The slots and constants from which the vector field of `H` is evaluated.
pub type ReadBy<'m, H, R, K> = Read<'m, SlotsOf<H, R, K>, <H as System>::Parameters<R>>;

/// The slots that the vector field of `H` changes.
pub type MovedBy<'m, H, R, K> = Moved<'m, SlotsOf<H, R, K>>;

/// The exact flows, energies and constants of a Hamiltonian, in the layout that the macro chose.
///
/// `#[hamiltonian]` implements this trait beside [`Hamiltonian`](crate::Hamiltonian), which users name in bounds.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a Hamiltonian",
    label = "has no generated stepper",
    note = "put `#[hamiltonian]` on an `impl {Self}` with the functions `kinetic` and `potential`"
)]
pub trait System: Sized {
    /// The shape of `q` and of `p`, with the scalar type `f64`.
    type Coords: Coords<Leaf = f64, With<f64> = Self::Coords>;
    /// The prepared constants, which depend on parameters alone.
    type Parameters<R: Real>: Prepared<R, Single = Self::Parameters<f64>>;
    /// The prepared constants and the state, in the layout that the macro chose.
    type Motion<R: Real, K: Precision>: Motion<Shaped<Self, K>, Self::Parameters<f64>>;

    /// The names of the parts, in the order of the letters A, B, C.
    ///
    /// Empty if `H` is not split. Compositions cannot integrate such an `H`; methods that use the whole vector field can.
    const PARTS: &'static [&'static str] = &["kinetic", "potential"];
    /// Whether parts 2..n form one composite part, advanced by a symmetric inner step.
    ///
    /// The inner step applies `middle` for half the duration, `kick`, and `middle` backwards.
    const PAIRED: bool = false;
    /// The parts that take inner steps, the outermost first. Each is the last part of the level around it.
    const NESTED: &'static [InnerSteps] = &[];
    /// Whether `H = T(p) + V(q)`, so that a drift changes positions only and a kick momenta only.
    const SEPARABLE: bool = true;
    /// Whether [`System::along_field`] is there: for all H that are not `T(p) + V(q)`, and for small ones that are.
    const HAS_FIELD: bool = !Self::SEPARABLE;
    /// The error of flow derivatives relative to exact dual-number derivatives, which have 1.
    ///
    /// A flow that the user wrote is differentiated by extrapolated differences, which lose one or two digits.
    const TANGENT_ERROR: f64 = 1.0;
    /// Whether steps evolve two coupled copies of the state, of which one is returned (Tao 2016).
    ///
    /// Such steps are symplectic and reversible in the doubled phase space, not in that of one copy.
    const COPIES: bool = false;
    /// Whether no part depends on time, so that the energy is conserved.
    const AUTONOMOUS: bool;
    /// Friction beside the flows of the parts, which compositions with the letter `O` apply.
    const DISSIPATION: Dissipation = Dissipation::None;
    /// Whether a flow changes its formula at given times, such as a switch or a pulse.
    ///
    /// Each step then uses the formulas at its midpoint, and stages are not merged across steps.
    const PIECEWISE_IN_TIME: bool = false;
    /// Whether a single run benefits from 512-bit vectors, because its flows process sites or bodies in SIMD lanes.
    ///
    /// Scalar code can be slower in AVX-512 and is compiled for AVX2 at most.
    const WIDE: bool = false;
    /// Whether energies process terms in SIMD lanes, and are computed in the instruction set of the steps.
    ///
    /// Other energies are scalar code, the same on every machine.
    const ENERGIES_IN_LANES: bool = false;
    /// Whether flows are so expensive that a dispatch per stage costs nothing in comparison.
    ///
    /// One loop that reads the table of the composition is then compiled for all compositions.
    const LARGE_FLOWS: bool = false;
    /// The names of the layouts of the flows, in the order of [`PARTS`](System::PARTS); empty if all are plain code.
    const LAYOUT: &'static [&'static str] = &[];
    /// A fingerprint of the generated flows and energies, by which a checkpoint is matched to its system.
    const FINGERPRINT: u64 = 0;
    /// The names of the functions that are annotated as conserved.
    const INVARIANTS: &'static [&'static str] = &[];
    /// The stencil radii of the flows of a lattice, if its sites can be updated in segments.
    const STENCIL_RADII: Option<StencilRadii> = None;
    /// Whether the coordinates of a plane are flat, so that the parameters determine how many sites a row has.
    const FLAT_ROWS: bool = false;

    /// Checks that the system can be integrated from a start with `length` numbers or points.
    ///
    /// # Errors
    /// [`Error::FewCoordinates`] if `length` is too small; [`Error::FewMasses`] or [`Error::Mass`] if masses are missing or
    /// unusable in the coordinates of the system.
    fn admissible(&self, _length: usize) -> Result<(), Error> {
        Ok(())
    }
    /// Returns whether a run from a start with `length` numbers or points has enough bodies for neighbour lists.
    fn is_listed(&self, _length: usize) -> bool {
        false
    }
    /// Evaluates the constants that depend on parameters only, by the user's own expressions.
    ///
    /// `length` is the number of numbers or points in the positions of the start.
    fn parameters(&self, length: usize) -> Self::Parameters<f64>;
    /// Sets the number of inner steps of the outermost part that takes such steps; without effect if there is none.
    fn set_inner_steps(_parameters: &mut Self::Parameters<f64>, _steps: usize) {}
    /// Sets the midpoint time at which time-dependent conditions are evaluated in the current step.
    fn begin_step<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>, _middle: f64) {}
    /// Applies the exact flow of `T`, or of the first part, for `duration`; an explicit time dependence is evaluated at `time`.
    fn drift<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// Applies the flows of the parts between the first and the last, in their order or backwards.
    fn middle<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>, _duration: f64, _time: f64, _backwards: bool) {}
    /// Applies the flow of `V`, or of the last part, for `duration`; an explicit time dependence is evaluated at `time`.
    ///
    /// The flow is exact, unless the last part takes inner steps.
    fn kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// Applies the exact flow of the last name in [`PARTS`](System::PARTS), whether it takes inner steps or not.
    #[inline(always)]
    fn last<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64) {
        Self::kick::<R, K>(motion, duration, time);
    }
    /// Applies the flow of `V`, or of the last part, to several motions: one after the other, or stage by stage if the last part
    /// takes inner steps.
    #[inline(always)]
    fn kick_together<R: Real, K: Precision, const N: usize>(
        motions: &mut [Self::Motion<R, K>; N],
        duration: f64,
        time: f64,
    ) {
        for motion in motions {
            Self::kick::<R, K>(motion, duration, time);
        }
    }
    /// Adds `duration` times the vector field `(∂H/∂p, -∂H/∂q)`, evaluated at `motion`, to the coordinates in `moved`.
    ///
    /// Empty without [`System::HAS_FIELD`]: the flows of `T` and `V` give the field.
    #[inline(always)]
    fn along_field<R: Real, K: Precision>(
        motion: ReadBy<'_, Self, R, K>,
        moved: MovedBy<'_, Self, R, K>,
        duration: f64,
        time: f64,
    ) {
        let (Read { q, p, parameters }, Moved { q: positions, p: momenta }) = (motion, moved);
        let moved = Moved { q: &mut *positions, p: &mut *momenta };
        Self::along_velocity::<R, K>(Read { q, p, parameters }, moved, duration, time);
        let moved = Moved { q: positions, p: momenta };
        Self::along_force::<R, K>(Read { q, p, parameters }, moved, duration, time);
    }
    /// Adds `duration` times `∂H/∂p` to the positions in `moved`, for `H = T(p) + V(q)` with [`System::HAS_FIELD`].
    #[inline(always)]
    fn along_velocity<R: Real, K: Precision>(
        _motion: ReadBy<'_, Self, R, K>,
        _moved: MovedBy<'_, Self, R, K>,
        _duration: f64,
        _time: f64,
    ) {
    }
    /// Adds `-duration` times `∂H/∂q` to the momenta in `moved`, for `H = T(p) + V(q)` with [`System::HAS_FIELD`].
    #[inline(always)]
    fn along_force<R: Real, K: Precision>(
        _motion: ReadBy<'_, Self, R, K>,
        _moved: MovedBy<'_, Self, R, K>,
        _duration: f64,
        _time: f64,
    ) {
    }
    /// Returns `T`, or the energy of the first part.
    fn kinetic<R: Real, K: Precision>(motion: &Self::Motion<R, K>, time: f64) -> R;
    /// Returns `V`, or the energy of all parts except the first.
    fn potential<R: Real, K: Precision>(motion: &Self::Motion<R, K>, time: f64) -> R;

    /// Returns the energy by the user's own functions, with which the generated code is compared.
    fn stated(&self, q: &Self::Coords, p: &Self::Coords, time: f64) -> StatedEnergy;

    /// Returns the value of an invariant, by its index in [`System::INVARIANTS`].
    fn invariant<R: Real, K: Precision>(_motion: &Self::Motion<R, K>, _number: usize) -> R {
        R::of(f64::NAN)
    }

    /// Returns the value of an invariant by the user's own function, with which the generated code is compared.
    fn stated_invariant(&self, _number: usize, _q: &Self::Coords, _p: &Self::Coords) -> f64 {
        f64::NAN
    }

    /// Returns the number of coordinates in a layer of a lattice; `None` if flat coordinates are no rows.
    #[inline(always)]
    fn columns<R: Real>(_parameters: &Self::Parameters<R>, _length: usize) -> Option<usize> {
        Some(<Self::Coords as Coords>::COMPONENTS)
    }
    /// Returns the sites of a lattice, if they can be updated in segments.
    fn sites<R: Real, K: Precision>(_motion: &mut Self::Motion<R, K>) -> Option<Sites<'_, R, K, Self::Parameters<R>>> {
        None
    }
    /// Applies a flow to a range of sites of a lattice.
    fn apply_to_sites<R: Real, K: Precision>(
        _lattice: MovedSites<'_, R, K, Self::Parameters<R>>,
        _flow: &Flow,
        _sites: Range<usize>,
    ) {
    }
}

/// A Hamiltonian with `T = ½ pᵀ M⁻¹ p` and a constant `M`.
///
/// `#[hamiltonian]` implements this trait if it can show symbolically that `T` has this form.
#[diagnostic::on_unimplemented(
    message = "H of `{Self}` is not ½ pᵀ M⁻¹ p + V(q) with a constant M",
    label = "this composition needs H = ½ pᵀ M⁻¹ p + V(q)",
    note = "its order conditions hold only for such an H",
    note = "compositions of general class, such as `Yoshida4` and `KahanLi8`, integrate every splitting"
)]
pub trait QuadraticKinetic: System {
    /// Replaces the momenta by the product of the Hessian of `V` and the momenta.
    fn hessian<R: Real>(motion: &mut Self::Motion<R, f64>, time: f64);
    /// Applies the exact flow of `duration·V + gradient·|∇V|²`, with the norm that `M⁻¹` defines.
    fn gradient_kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, gradient: f64, time: f64);
}

/// The energy of a state, computed by the user's own functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StatedEnergy {
    /// Computed by `kinetic` and `potential`, or by the functions of named parts.
    Separate {
        /// `T`, or the energy of the first part.
        kinetic: f64,
        /// `V`, or the energy of all other parts together.
        potential: f64,
    },
    /// Computed by `hamiltonian`.
    Whole(f64),
}
