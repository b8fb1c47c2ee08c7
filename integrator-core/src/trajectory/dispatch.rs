//! The choice among the multiversioned variants of single trajectories: the instruction set of this machine.

use crate::{
    composition::flow_counts::PartFlows,
    scalar::{dual::Dual, instruction_set::InstructionSet, real::Real},
    state::{point::Point, precision::Precision},
    system::{Shaped, System},
    trajectory::{
        engine::Engine,
        method::{Facts, Method},
        motions::{Constants, Group, Motions},
        step_functions::{BesideVectors, Executor, InTiles},
    },
};
use alloc::{boxed::Box, sync::Arc, vec, vec::Vec};

/// The data of a trajectory besides its state, in the lanes after those of the state.
pub(crate) trait Carried {
    /// The scalar for a state in `R` and what it carries.
    type In<R: Real>: Real;
    /// The order in which motions go through the stages of a composition.
    type Executor: Executor;
    /// Whether the additional lanes have prepared constants of their own.
    const CARRIES_CONSTANTS: bool = false;
    /// Whether steps are compiled for the baseline, where the instruction set is chosen at run time.
    const ON_BASELINE: bool = true;
}

/// No data beside the state.
pub(crate) struct Nothing;

/// A number of deviation vectors; with `SENSITIVE`, some of them are derivatives by parameters.
pub(crate) struct Deviations<const N: usize, const SENSITIVE: bool = false>;

impl Carried for Nothing {
    type In<R: Real> = R;
    type Executor = InTiles;
}

impl<const N: usize, const SENSITIVE: bool> Carried for Deviations<N, SENSITIVE> {
    type In<R: Real> = Dual<R, N, false, SENSITIVE>;
    type Executor = BesideVectors;
    const CARRIES_CONSTANTS: bool = SENSITIVE;
    // Several vectors together are much code, and the baseline of x86 has few users: it takes them one by one.
    const ON_BASELINE: bool = N == 1 || !cfg!(all(target_arch = "x86_64", feature = "std"));
}

/// An empty list of motions of single trajectories, for the instruction set of this machine.
pub(crate) fn single<H: System, X: Method<H>, K: Precision, V: Carried>(
    constants: Constants<X::Constants>,
) -> Box<dyn Motions> {
    // A constant, so that nothing is compiled for the other instruction sets.
    if const { X::CLONED } {
        match InstructionSet::chosen() {
            InstructionSet::Baseline if V::ON_BASELINE => motions::<H, X, V::In<K::Plain>, K, V::Executor>(constants),
            InstructionSet::Avx512 if X::WIDE => motions::<H, X, V::In<K::Avx512>, K, V::Executor>(constants),
            InstructionSet::Baseline | InstructionSet::Fused | InstructionSet::Avx512 => {
                motions::<H, X, V::In<K::Fused>, K, V::Executor>(constants)
            }
        }
    } else {
        motions::<H, X, V::In<K::Plain>, K, V::Executor>(constants)
    }
}

/// Whether [`single`] has steps for the instruction set of this machine.
pub(crate) fn is_compiled<H: System, X: Method<H>, V: Carried>() -> bool {
    !X::CLONED || V::ON_BASELINE || InstructionSet::chosen() != InstructionSet::Baseline
}

/// An empty list of motions for the constants of a run, and for the derivatives of constants that it carries.
type MotionsOf<P> = dyn Fn(Arc<P>, Vec<P>) -> Box<dyn Motions>;

/// A method for a system, and for what its runs carry: what a run needs of both, whatever the type of the method. All else of
/// a run is compiled once per system.
pub(crate) struct Bound<P> {
    pub(crate) facts: Facts,
    pub(crate) forces: Option<usize>,
    pub(crate) flows: Option<PartFlows>,
    carries_constants: bool,
    motions: Box<MotionsOf<P>>,
}

/// Binds a method to a system and to what a trajectory carries.
pub(crate) fn bound<H: System, X: Method<H>, K: Precision, V: Carried>(method: X) -> Bound<H::Parameters<f64>> {
    Bound {
        facts: method.facts(),
        forces: method.forces(),
        flows: method.flows(),
        carries_constants: const { V::CARRIES_CONSTANTS },
        motions: Box::new(move |parameters, slopes| {
            let mut constants = vec![method.constants(parameters)];
            if const { V::CARRIES_CONSTANTS } {
                for slopes in slopes {
                    constants.push(method.constants(Arc::new(slopes)));
                }
            }
            single::<H, X, K, V>(Arc::new(constants))
        }),
    }
}

impl<P> Bound<P> {
    /// The engine of a trajectory, for the instruction set of this machine, from the points in its lanes: the start, and what
    /// it carries. `slopes` are the derivatives of the constants, where a trajectory carries derivatives along parameters.
    pub(crate) fn engine(&self, parameters: Arc<P>, slopes: Vec<P>, lanes: Vec<&dyn Point>) -> Engine {
        let motions = (self.motions)(parameters, slopes);
        if self.carries_constants {
            Engine::single_with_constants(&*motions, lanes)
        } else {
            Engine::single(&*motions, lanes)
        }
    }
}

/// An empty list of motions whose steps are computed in `R`.
pub(crate) fn motions<H: System, X: Method<H>, R: Real, K: Precision, E: Executor>(
    constants: Constants<X::Constants>,
) -> Box<dyn Motions> {
    Group::<X::Motion<R, K>, _, Shaped<H, K>>::empty(X::step_functions::<R, K, E>(), constants, 0)
}
