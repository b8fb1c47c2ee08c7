//! The methods: a time transformation with a composition.

use super::{
    Rated, TimeTransformed,
    flows::{Ln, OfRate, TimedOf, ToPower, Transformation, Transformed},
    motion::Constants,
};
use crate::{
    composition::{Class, Composition, Scheme},
    error::Error,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, precision::Precision},
    system::{System, motion::Motion},
    trajectory::{
        method::{Described, Differentiable, Facts, Method, Resumable},
        step_functions::{Executor, StepFunctions, all_finite},
        step_loop::{Advance, End},
    },
};
use alloc::sync::Arc;

/// Step-size control by the logarithmic Hamiltonian, `dt = ds/(-V)`.
///
/// The composition integrates `ln(T + B) - ln(-V)` with `B = -H` at the start, in equal steps of a fictitious time `s`
/// (Mikkola and Tanikawa 1999, Celest. Mech. Dyn. Astron. 74, 287; Preto and Tremaine 1999, Astron. J. 118, 2532).
///
/// - Steps are short where the attraction is strong.
/// - Steps are symplectic in the space of `(q, t)` and `(p, B)`.
/// - For two bodies with a `1/r` potential, the state stays on the exact orbit up to rounding, for every step size. Errors
///   are in the time only. This holds for compositions of symmetric steps, such as
///   [`SofroniouSpaletta8`](crate::SofroniouSpaletta8); others keep their order only.
/// - `V < 0` is required on the whole orbit, which every kick and drift checks. Subtract a constant in `potential` if
///   needed; this does not change the motion.
/// - The composition must be of general class.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Comet;
///
/// #[hamiltonian]
/// impl Comet {
///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
/// }
///
/// // At its closest to the star on an orbit with an eccentricity of 0.99, whose period is 2π.
/// let start = Phase::new([0.01, 0.0], [0.0, 199_f64.sqrt()]);
/// let mut run = Comet.run_with(Logarithmic(SofroniouSpaletta8), start, 0.2)?;
/// let energy = run.energy();
/// run.advance_to(100.0 * std::f64::consts::TAU)?;
/// assert!((run.energy() / energy - 1.0).abs() < 1e-9);
/// assert!(run.state().q[0] > 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Logarithmic<X>(pub X);

/// Step-size control by a power of the potential, `dt = ds g (-V)^(g-1)`.
///
/// Like [`Logarithmic`], for the Hamiltonian `f(T + B) - f(-V)` with `f(x) = x^g` and `B = -H` at the start. The smaller
/// `g`, the shorter steps become where the attraction is strong; with `g = 1` all steps are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<X>(pub f64, pub X);

/// Returns the facts of all methods that transform energies. Steps by `-h` undo those by `h` at the same `B`, which the
/// state does not contain: a run back from it has another `B`, so that symmetry is not claimed.
pub(in crate::methods) fn transformed(name: &'static str, of_method: Facts) -> Facts {
    let Facts { name: over, order, forces, roundings, table, .. } = of_method;
    Facts { name, order, symplectic: true, forces, roundings, over: Some(over), table, ..Facts::UNCLAIMED }
}

impl<X: Scheme> Described for Logarithmic<X> {
    fn facts(self) -> Facts {
        transformed("Logarithmic", self.0.facts())
    }
}

impl<X: Scheme> Described for Power<X> {
    fn facts(self) -> Facts {
        transformed("Power", self.1.facts())
    }
    fn admissible(self) -> Result<(), Error> {
        match self.0.is_finite() && self.0 != 0.0 {
            true => Ok(()),
            false => Err(Error::Exponent { exponent: self.0 }),
        }
    }
}

/// Step-size control by a function of your own, `dt = ds/Ω(q)`.
///
/// The function `fn rate(&self, q: ...) -> f64` next to `kinetic` and `potential` is `Ω`: the larger it is, the shorter the
/// steps (Mikkola and Aarseth 2002, Celest. Mech. Dyn. Astron. 84, 343).
///
/// An auxiliary variable `W` follows `Ω` along the orbit, so that both flows are exact and every composition of general
/// class keeps its order. Steps are reversible in the space extended by `W`, but **not symplectic**. [`Logarithmic`] is
/// symplectic, but requires `V < 0`. If `T` is not quadratic in the momenta, the change of `W` in a kick is an integral by
/// Gauss quadrature with an error of order 10.
///
/// For H that is not `T(p) + V(q)`, `Paced(GaussLegendre::<8>)` integrates `(H + B)/Ω` with `B = -H` at the start. Its steps are
/// symplectic in the space of `(q, t)` and `(p, B)`, and have the order of the implicit method.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Comet;
///
/// #[hamiltonian]
/// impl Comet {
///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
///     fn rate(&self, q: [f64; 2]) -> f64 { q[0].hypot(q[1]).powf(-1.5) }
/// }
///
/// let start = Phase::new([0.1, 0.0], [0.0, 19_f64.sqrt()]);
/// let mut run = Comet.run_with(Paced(KahanLi8), start, 0.05)?;
/// let energy = run.energy();
/// run.advance_to(100.0)?;
/// assert!((run.energy() - energy).abs() < 1e-8);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Paced<X>(pub X);

impl<X: Scheme> Described for Paced<X> {
    fn facts(self) -> Facts {
        Facts { symplectic: false, ..transformed("Paced", self.0.facts()) }
    }
}

macro_rules! time_transformation {
    ($method:ident of $system:ident, $transformation:ty, $exponent:expr, $transforms_energy:expr) => {
        #[diagnostic::do_not_recommend]
        impl<H: $system, X: Composition<H> + Scheme> Method<H> for $method<X> {
            /// A single run uses AVX-512, as members of ensembles do, because powers round differently with these
            /// instructions.
            const WIDE: bool = true;
            type Constants = Constants<H::Parameters<f64>>;
            type Motion<R: Real, K: Precision> = TimedOf<H, R, K>;

            fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
                let transforms_energy = $transforms_energy;
                Arc::new(Constants { parameters, exponent: $exponent(self), transforms_energy })
            }
            fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
                step_functions::<$transformation, X, H, R, K, E>()
            }
        }
    };
}

impl<H: TimeTransformed, X: Composition<H>> Differentiable<H> for Logarithmic<X> {}
impl<H: TimeTransformed, X: Composition<H>> Differentiable<H> for Power<X> {}
impl<H: Rated, X: Composition<H> + Scheme> Differentiable<H> for Paced<X> {}

impl<H: TimeTransformed, X: Composition<H>> Resumable<H> for Logarithmic<X> {}
impl<H: TimeTransformed, X: Composition<H>> Resumable<H> for Power<X> {}
impl<H: Rated, X: Composition<H> + Scheme> Resumable<H> for Paced<X> {}

time_transformation!(Logarithmic of TimeTransformed, Ln, |_: Self| 0.0, true);
time_transformation!(Power of TimeTransformed, ToPower, |power: Self| power.0, true);
time_transformation!(Paced of Rated, OfRate, |_: Self| 0.0, false);

fn step_functions<F, X, H, R, K, E>() -> StepFunctions<TimedOf<H, R, K>>
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
    E: Executor,
{
    const {
        assert!(
            matches!(X::CLASS, Class::General),
            "a time transformation makes T something that is not quadratic in p, for which this composition would lose its \
             order; those of general class, such as `SofroniouSpaletta8`, keep theirs"
        );
    }
    StepFunctions {
        lanes: R::LANES,
        together: 1,
        advance: advance::<F, X, H, R, K, E>,
        complete: |motion, clock, _| complete::<F, X, H, R, K>(motion, clock),
        show: if const { X::PROCESSOR.after.rows.is_empty() } {
            None
        } else {
            Some(|motion, clock| R::enter(End::<_, H, X, true>::new(Transformed::<F, X, H, R, K>::new(motion), clock)))
        },
        finite: all_finite,
        dense: Some(dense::<F, X, H, R, K, E>),
        energy: None,
        #[cfg(feature = "check")]
        squares: None,
    }
}

/// The n-step loop.
fn advance<F, X, H, R, K, E>(motions: &mut [TimedOf<H, R, K>], clock: Clock, steps: u64, _threads: Option<usize>)
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
    E: Executor,
{
    for motion in motions {
        let (flows, along_starts) = (Transformed::new(motion), E::ALONG_STARTS);
        R::enter(Steps::<F, X, H, R, K> { flows, along_starts, clock, steps });
    }
}

struct Steps<'m, F, X, H: System, R: Real, K: Precision> {
    flows: Transformed<'m, F, X, H, R, K>,
    along_starts: bool,
    clock: Clock,
    steps: u64,
}

impl<F, X, H, R, K> Kernel for Steps<'_, F, X, H, R, K>
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
{
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        self.flows.begin(self.along_starts);
        Advance::<_, H, X>::new(self.flows, self.clock, self.steps).call();
    }
}

/// Completes the current step, with the check of the drift after it: so a step that is shown was checked as a whole.
fn complete<F, X, H, R, K>(motion: &mut TimedOf<H, R, K>, clock: Clock)
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
{
    R::enter(End::<_, H, X, false>::new(Transformed::<F, X, H, R, K>::new(motion), clock));
    if motion.begun {
        let followed = F::followed::<R, K>(motion);
        motion.check_drift(followed);
    }
}

/// Takes a motion a while into the step that begins at the other one: by one shorter step.
fn dense<F, X, H, R, K, E>(to: &mut TimedOf<H, R, K>, begin: &TimedOf<H, R, K>, clock: Clock, duration: f64)
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
    E: Executor,
{
    to.copy_state(begin);
    let finish = |motion: &mut TimedOf<H, R, K>, clock: Clock| {
        complete::<F, X, H, R, K>(motion, clock);
        R::enter(End::<_, H, X, true>::new(Transformed::<F, X, H, R, K>::new(motion), clock));
    };
    finish(to, clock);
    let shorter = Clock { t0: 0.0, h: duration, steps: 0 };
    advance::<F, X, H, R, K, E>(core::slice::from_mut(to), shorter, 1, None);
    finish(to, Clock { steps: 1, ..shorter });
}
