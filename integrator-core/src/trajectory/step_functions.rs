//! The step functions of a motion type, compiled for a system, a composition and a scalar.

use crate::{
    composition::Composition,
    layout::lattice::{carried::CarriedApart, time_tiling::TimeTiling},
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, precision::Precision},
    system::{
        System,
        energy::{EnergyOfMotion, of_motion},
        flows::Single,
        motion::Motion,
    },
    trajectory::{
        by_table,
        interleaved::AdvanceAll,
        step_loop::{Advance, AdvanceApart, AdvanceOne, End},
    },
};

#[cfg(feature = "check")]
use crate::{
    state::{
        phase::Phase,
        point::{Point, shaped_mut},
    },
    system::Shaped,
    trajectory::tangent::squares,
};

/// The function table of a motion type, which an engine calls a few times per block of steps.
///
/// These are functions and not a type parameter: so `Motions` know the motion's type alone, what is seldom called is compiled
/// once per motion, and a system that borrows its parameters can be run all the same.
pub struct StepFunctions<M> {
    /// The number of members of a motion.
    pub(crate) lanes: usize,
    /// The number of motions in a group, whose members go through each stage together.
    pub(crate) together: usize,
    /// Takes this number of steps, on this number of threads or on all.
    pub(crate) advance: fn(&mut [M], Clock, u64, Option<usize>),
    /// Completes the current step, on this number of threads or on all.
    pub(crate) complete: fn(&mut M, Clock, Option<usize>),
    /// Makes of a completed step the state that is shown, where that differs.
    pub(crate) show: Option<fn(&mut M, Clock)>,
    /// Whether all numbers are finite, by this number of threads or by all.
    pub(crate) finite: fn(&[M], Option<usize>) -> bool,
    /// Takes a motion a while into the step that begins at the other one and at the clock, where a method has dense
    /// output. It may stand anywhere in this step.
    pub(crate) dense: Option<fn(&mut M, &M, Clock, f64)>,
    /// The energy of a motion at the end of a step, if it is computed from the motion.
    pub(crate) energy: Option<EnergyOfMotion<M>>,
    /// Writes the sums of the squares of the vectors after the states of all lanes, where each state has one; the point
    /// is of the shape of a state, and is written to.
    #[cfg(feature = "check")]
    pub(crate) squares: Option<Squares<M>>,
}

/// From motions, a point to write to, and a list to write, one number for each state.
#[cfg(feature = "check")]
pub(crate) type Squares<M> = fn(&[M], &mut dyn Point, &mut [[f64; 2]]);

impl<M> Clone for StepFunctions<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for StepFunctions<M> {}

impl<M> StepFunctions<M> {
    /// Returns the step functions of a method whose motions stand at the end of a step whenever they are read.
    pub fn of_whole_steps<C: Coords, P>(
        lanes: usize,
        advance: fn(&mut [M], Clock, u64, Option<usize>),
        dense: Option<fn(&mut M, &M, Clock, f64)>,
    ) -> Self
    where
        M: Motion<C, P>,
    {
        let complete = |_: &mut M, _, _| {};
        Self {
            lanes,
            together: 1,
            advance,
            complete,
            show: None,
            finite: all_finite,
            dense,
            energy: None,
            #[cfg(feature = "check")]
            squares: None,
        }
    }

    /// Takes this number of steps with one motion.
    #[cfg(feature = "check")]
    pub(crate) fn advance_one(&self, motion: &mut M, clock: Clock, steps: u64) {
        (self.advance)(core::slice::from_mut(motion), clock, steps, Some(1));
    }

    /// One motion with the current step completed, up to the state that is shown: the end of the step of the kernel,
    /// where the inverse of the processor gives a state that is not finite.
    #[cfg(feature = "check")]
    pub(crate) fn shown<C: Coords, P>(&self, mut motion: M, clock: Clock) -> M
    where
        M: Motion<C, P>,
    {
        (self.complete)(&mut motion, clock, Some(1));
        let Some(show) = self.show else { return motion };
        let mut shown = motion.clone();
        show(&mut shown, clock);
        if shown.finite() { shown } else { motion }
    }
}

/// The order in which motions go through the stages of a composition.
pub trait Executor: 'static {
    /// Whether lattices too long for the cache are swept in tiles, which is more code.
    const TILES: bool = false;
    /// The number of registers for one number of all lanes, where small motions go through each stage together.
    const REGISTERS: usize = 0;
    /// Whether derivatives are taken along starts, each with its own constants of the motion, such as an energy;
    /// otherwise, those of the map of states, at the same constants.
    const ALONG_STARTS: bool = false;
}

/// One motion after the other, flow by flow: the least code.
#[cfg(feature = "check")]
pub struct FlowByFlow;

/// One motion after the other, a long lattice in tiles.
pub struct InTiles;

/// One motion after the other, flow by flow, beside deviation vectors.
pub struct BesideVectors;

/// Several small motions together, as fit into this number of registers.
#[cfg(feature = "std")]
pub struct Interleaved<const REGISTERS: usize>;

#[cfg(feature = "check")]
impl Executor for FlowByFlow {}

impl Executor for BesideVectors {
    const ALONG_STARTS: bool = true;
}

impl Executor for InTiles {
    const TILES: bool = true;
}

#[cfg(feature = "std")]
impl<const REGISTERS: usize> Executor for Interleaved<REGISTERS> {
    const REGISTERS: usize = REGISTERS;
}

/// The step functions of a system under a composition.
pub(crate) fn of_composition<H, X, R, K, E>() -> StepFunctions<H::Motion<R, K>>
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    StepFunctions {
        lanes: R::LANES,
        together: AdvanceAll::<H, X, R, K, E>::TOGETHER,
        advance: if const { is_by_table::<H, X, R, K, E>() } {
            by_table::advance::<H, X, R, K, E>
        } else {
            advance::<H, X, R, K, E>
        },
        complete: ending::<H, X, R, K, E, false>(),
        show: if const { X::PROCESSOR.after.rows.is_empty() } {
            None
        } else {
            Some(|motion, clock| ending::<H, X, R, K, E, true>()(motion, clock, Some(1)))
        },
        finite: if const { E::REGISTERS == 0 } { all_finite } else { all_finite_in_lanes::<H, R, K> },
        dense: None,
        energy: const { of_motion::<H, R, K>() },
        #[cfg(feature = "check")]
        squares: if const { E::REGISTERS > 0 && R::LANES == 2 * R::MEMBERS } {
            Some(squares_in_lanes::<H, R, K>)
        } else {
            None
        },
    }
}

/// Whether the loop over stages reads the table of the composition, and is not compiled for it.
const fn is_by_table<H: System, X: Composition<H>, R: Real, K: Precision, E: Executor>() -> bool {
    let carried_apart = E::TILES && CarriedApart::<H, R, K>::ENABLED;
    H::LARGE_FLOWS && X::GRADIENT_EVALUATIONS == 0 && AdvanceAll::<H, X, R, K, E>::TOGETHER == 1 && !carried_apart
}

/// Returns the function that completes a step, or that undoes the processor after it.
fn ending<H, X, R, K, E, const SHOWN: bool>() -> fn(&mut H::Motion<R, K>, Clock, Option<usize>)
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    if const { is_by_table::<H, X, R, K, E>() } {
        by_table::end::<H, X, R, K, E, SHOWN>
    } else {
        end::<H, X, R, K, E, SHOWN>
    }
}

/// The n-step loop.
fn advance<H, X, R, K, E>(motions: &mut [H::Motion<R, K>], clock: Clock, steps: u64, threads: Option<usize>)
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    if const { E::REGISTERS > 0 } {
        return R::enter(AdvanceAll::<H, X, R, K, E>::new(motions, clock, steps));
    }
    for motion in motions {
        if const { E::TILES && TimeTiling::<H, R, K>::ENABLED } {
            let mut flows = TimeTiling::<H, R, K>::new(motion, threads);
            Advance::<_, H, X>::new(&mut flows, clock, steps).call();
            flows.finish();
        } else if const { E::TILES && CarriedApart::<H, R, K>::ENABLED } {
            R::enter(AdvanceApart::<H, X, R, K>::new(motion, clock, steps));
        } else {
            R::enter(AdvanceOne::<H, X, R, K>::new(motion, clock, steps));
        }
    }
}

/// The end of the current step: its last stages, or the inverse of the processor after them.
fn end<H, X, R, K, E, const SHOWN: bool>(motion: &mut H::Motion<R, K>, clock: Clock, threads: Option<usize>)
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    if const { E::TILES && TimeTiling::<H, R, K>::ENABLED } {
        let mut flows = TimeTiling::<H, R, K>::new(motion, threads);
        End::<_, H, X, SHOWN>::new(&mut flows, clock).call();
        flows.finish();
    } else {
        R::enter(End::<_, H, X, SHOWN>::new(Single::<H, R, K>(motion), clock));
    }
}

#[inline(always)]
pub(crate) fn all_finite<C: Coords, P, M: Motion<C, P>>(motions: &[M], threads: Option<usize>) -> bool {
    for motion in motions {
        if !motion.finite_on(threads) {
            return false;
        }
    }
    true
}

/// Whether all motions are finite, in the variant for the instruction set of lanes.
fn all_finite_in_lanes<H: System, R: Real, K: Precision>(motions: &[H::Motion<R, K>], _threads: Option<usize>) -> bool {
    R::enter(Finite::<H, R, K>(motions))
}

/// The squares of vectors in that variant, too: elsewhere a lane would be taken out of a register by a call.
#[cfg(feature = "check")]
fn squares_in_lanes<H: System, R: Real, K: Precision>(
    motions: &[H::Motion<R, K>],
    point: &mut dyn Point,
    squares: &mut [[f64; 2]],
) {
    R::enter(SquaresOf::<H, R, K> { motions, point: shaped_mut(point), squares });
}

#[cfg(feature = "check")]
struct SquaresOf<'m, H: System, R: Real, K: Precision> {
    motions: &'m [H::Motion<R, K>],
    point: &'m mut Phase<Shaped<H, K>>,
    squares: &'m mut [[f64; 2]],
}

#[cfg(feature = "check")]
impl<H: System, R: Real, K: Precision> Kernel for SquaresOf<'_, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        for (motion, of_motion) in self.motions.iter().zip(self.squares.chunks_mut(R::MEMBERS)) {
            for (member, sums) in of_motion.iter_mut().enumerate() {
                motion.store(2 * member + 1, self.point);
                *sums = squares(self.point);
            }
        }
    }
}

struct Finite<'m, H: System, R: Real, K: Precision>(&'m [H::Motion<R, K>]);

impl<H: System, R: Real, K: Precision> Kernel for Finite<'_, H, R, K> {
    type Out = bool;

    #[inline(always)]
    fn call(self) -> bool {
        // Not `all_finite`, which calls a function for other threads outside of this variant.
        for motion in self.0 {
            if !motion.finite() {
                return false;
            }
        }
        true
    }
}
