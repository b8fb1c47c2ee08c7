//! Motions in flight together: the loops over those whose lanes are members of an ensemble.
//!
//! A flow is a chain of operations that wait for each other. So a few small motions go through each stage together: while
//! one waits, the others compute, and all of them stay in registers.

use crate::{
    composition::Composition,
    hamiltonian::{Flows, Hamiltonian, QuadraticKinetic, Shaped},
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, precision::Precision},
    system::motion::Motion,
    trajectory::moves::{Advance, End},
};
use core::{array, marker::PhantomData};

/// How many motions go together at most. By measurement, more than six wait no less.
const MOST: usize = 6;

/// How many registers a group's state may take where there are 32, so that the rest is left to compute in. One too many,
/// and the state goes through memory at every stage: by measurement on AVX-512, members with compensated coordinates of
/// Hénon–Heiles, three motions together and six, take 0.30 and 0.68 ns per step. Sixteen registers hold no group
/// worth the name; there, as many motions as may hide how long memory takes.
const FOR_STATE: usize = 24;

/// What is done to motions whose lanes are members, compiled for one system, composition and vector.
pub struct GroupMoves<M> {
    /// How many members a motion has.
    pub(crate) lanes: usize,
    /// How many motions go together.
    pub(crate) together: usize,
    pub(crate) advance: fn(&mut [M], Clock, u64),
    /// Completes the step under way.
    pub(crate) complete: fn(&mut [M], Clock),
    /// Makes of a completed step the state that is shown, where that differs.
    pub(crate) show: Option<fn(&mut [M], Clock)>,
    /// Whether all numbers are finite.
    pub(crate) finite: fn(&[M]) -> bool,
}

impl<M> Clone for GroupMoves<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for GroupMoves<M> {}

/// The moves of a system under a composition, in lanes, where so many registers hold a number of all lanes each.
pub(crate) fn group_moves<H, X, L, K, const REGISTERS: usize>() -> GroupMoves<H::Motion<L, K>>
where
    H: Hamiltonian,
    X: Composition<H>,
    L: Real,
    K: Precision,
{
    GroupMoves {
        lanes: L::LANES,
        together: AdvanceAll::<H, X, L, K, REGISTERS>::TOGETHER,
        advance: advance::<H, X, L, K, REGISTERS>,
        complete: end::<H, X, L, K, false>,
        show: if const { X::PROCESSOR.after.rows.is_empty() } { None } else { Some(end::<H, X, L, K, true>) },
        finite: finite::<H, L, K>,
    }
}

fn advance<H: Hamiltonian, X: Composition<H>, L: Real, K: Precision, const REGISTERS: usize>(
    motions: &mut [H::Motion<L, K>],
    clock: Clock,
    steps: u64,
) {
    L::enter(AdvanceAll::<H, X, L, K, REGISTERS> { motions, clock, steps, marker: PhantomData });
}

fn end<H: Hamiltonian, X: Composition<H>, L: Real, K: Precision, const SHOWN: bool>(
    motions: &mut [H::Motion<L, K>],
    clock: Clock,
) {
    L::enter(EndAll::<H, X, L, K, SHOWN> { motions, clock, marker: PhantomData });
}

fn finite<H: Hamiltonian, L: Real, K: Precision>(motions: &[H::Motion<L, K>]) -> bool {
    L::enter(Finite::<H, L, K>(motions))
}

/// Several motions, stage by stage.
///
/// Unoptimised, a flow in vectors that was inlined at every stage would take megabytes of stack.
struct Together<'m, H: Hamiltonian, L: Real, K: Precision, const N: usize>(&'m mut [H::Motion<L, K>; N]);

impl<H: Hamiltonian, L: Real, K: Precision, const N: usize> Flows<H> for Together<'_, H, L, K, N> {
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        for motion in self.0.iter_mut() {
            H::begin_step::<L, K>(motion, middle);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drift(&mut self, duration: f64, time: f64) {
        for motion in self.0.iter_mut() {
            H::drift::<L, K>(motion, duration, time);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn kick(&mut self, duration: f64, time: f64) {
        for motion in self.0.iter_mut() {
            H::kick::<L, K>(motion, duration, time);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        for motion in self.0.iter_mut() {
            H::gradient_kick::<L, K>(motion, duration, gradient, time);
        }
    }
}

/// The n-step loop over all motions, one group after the other.
struct AdvanceAll<'m, H: Hamiltonian, X, L: Real, K: Precision, const REGISTERS: usize> {
    motions: &'m mut [H::Motion<L, K>],
    clock: Clock,
    steps: u64,
    marker: PhantomData<X>,
}

impl<H, X, L, K, const REGISTERS: usize> AdvanceAll<'_, H, X, L, K, REGISTERS>
where
    H: Hamiltonian,
    X: Composition<H>,
    L: Real,
    K: Precision,
{
    const TOGETHER: usize = {
        let numbers = 2 * size_of::<<Shaped<H, K> as Coords>::Slots<L>>() / size_of::<L>();
        let fitting = match FOR_STATE.checked_div(numbers) {
            Some(fitting) => fitting,
            None => MOST,
        };
        // A motion that owns memory is of a size known at run time, hence not small.
        if core::mem::needs_drop::<H::Motion<L, K>>() || fitting < 2 {
            1
        } else if REGISTERS < 32 || fitting > MOST {
            MOST
        } else {
            fitting
        }
    };

    /// Advances groups of `N` and returns the motions that fill none.
    #[inline(always)]
    fn groups<const N: usize>(motions: &mut [H::Motion<L, K>], clock: Clock, steps: u64) -> &mut [H::Motion<L, K>] {
        let (groups, rest) = motions.as_chunks_mut::<N>();
        for group in groups {
            Advance::<_, H, X>::new(Together::<H, L, K, N>(group), clock, steps).call();
        }
        rest
    }
}

impl<H, X, L, K, const REGISTERS: usize> Kernel for AdvanceAll<'_, H, X, L, K, REGISTERS>
where
    H: Hamiltonian,
    X: Composition<H>,
    L: Real,
    K: Precision,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { motions, clock, steps, .. } = self;
        // Of these, code is made for one.
        let rest = match Self::TOGETHER {
            2 => Self::groups::<2>(motions, clock, steps),
            3 => Self::groups::<3>(motions, clock, steps),
            4 => Self::groups::<4>(motions, clock, steps),
            MOST => Self::groups::<MOST>(motions, clock, steps),
            _ => motions,
        };
        for motion in rest {
            Advance::<_, H, X>::new(Together::<H, L, K, 1>(array::from_mut(motion)), clock, steps).call();
        }
    }
}

/// The end of the step under way: its last stages, or what undoes the processor behind them.
struct EndAll<'m, H: Hamiltonian, X, L: Real, K: Precision, const SHOWN: bool> {
    motions: &'m mut [H::Motion<L, K>],
    clock: Clock,
    marker: PhantomData<X>,
}

impl<H, X, L, K, const SHOWN: bool> Kernel for EndAll<'_, H, X, L, K, SHOWN>
where
    H: Hamiltonian,
    X: Composition<H>,
    L: Real,
    K: Precision,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        for motion in self.motions {
            End::<_, H, X, SHOWN>::new(Together::<H, L, K, 1>(array::from_mut(motion)), self.clock).call();
        }
    }
}

struct Finite<'m, H: Hamiltonian, L: Real, K: Precision>(&'m [H::Motion<L, K>]);

impl<H: Hamiltonian, L: Real, K: Precision> Kernel for Finite<'_, H, L, K> {
    type Out = bool;

    #[inline(always)]
    fn call(self) -> bool {
        for motion in self.0 {
            if !motion.finite() {
                return false;
            }
        }
        true
    }
}
