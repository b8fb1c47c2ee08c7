//! Motions in flight together: the loops over those whose lanes are members of an ensemble.
//!
//! A flow is a chain of operations that wait for each other. So a few small motions go through each stage together: while
//! one waits, the others compute, and all of them stay in registers.

use crate::{
    composition::Composition,
    engine::{Advance, Clock, Close},
    hamiltonian::{Flows, Hamiltonian, Motion, QuadraticKinetic, Single},
    real::{Kernel, Real},
    slot::Keep,
};
use std::marker::PhantomData;

/// How many small motions go together, by measurement: two vectors of 512 bits take 0.29 ns per member and step of
/// Hénon–Heiles, four 0.16, six 0.13, eight 0.15, and six and eight are alike for Kepler.
pub(crate) const TOGETHER: usize = 6;

/// How many numbers a small motion has at most: six of four coordinates fill the registers, and beyond some more the
/// operations of one motion have enough of each other to fill the waiting.
const SMALL: usize = 16;

/// What is done to motions whose lanes are members, compiled for one system, composition and vector.
pub(crate) struct GroupMoves<M> {
    /// How many members a motion has.
    pub(crate) lanes: usize,
    pub(crate) advance: fn(&mut [M], Clock, u64),
    pub(crate) close: fn(&mut [M], Clock),
    /// Whether all numbers are finite.
    pub(crate) finite: fn(&[M]) -> bool,
}

impl<M> Clone for GroupMoves<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for GroupMoves<M> {}

/// The moves of a system under a composition, in lanes.
pub(crate) fn group_moves<H: Hamiltonian, X: Composition<H>, L: Real, K: Keep>() -> GroupMoves<H::Motion<L, K>> {
    GroupMoves {
        lanes: L::LANES,
        advance: |motions, clock, steps| {
            L::enter(AdvanceAll::<H, X, L, K> { motions, clock, steps, marker: PhantomData });
        },
        close: |motions, clock| L::enter(CloseAll::<H, X, L, K> { motions, clock, marker: PhantomData }),
        finite: |motions| L::enter(Finite::<H, L, K>(motions)),
    }
}

/// Several motions, stage by stage.
struct Together<'m, H: Hamiltonian, L: Real, K: Keep>(&'m mut [H::Motion<L, K>; TOGETHER]);

impl<H: Hamiltonian, L: Real, K: Keep> Flows<H> for Together<'_, H, L, K> {
    #[inline(always)]
    fn drift(&mut self, duration: f64, time: f64) {
        for motion in self.0.iter_mut() {
            H::drift::<L, K>(motion, duration, time);
        }
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, time: f64) {
        for motion in self.0.iter_mut() {
            H::kick::<L, K>(motion, duration, time);
        }
    }
    #[inline(always)]
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
struct AdvanceAll<'m, H: Hamiltonian, X, L: Real, K: Keep> {
    motions: &'m mut [H::Motion<L, K>],
    clock: Clock,
    steps: u64,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X, L: Real, K: Keep> AdvanceAll<'_, H, X, L, K> {
    /// Whether motions go together: a motion that owns memory is of a size known at run time, hence not small.
    const IN_GROUPS: bool = {
        let numbers = size_of::<H::Motion<L, K>>() / size_of::<L>();
        numbers <= SMALL && !std::mem::needs_drop::<H::Motion<L, K>>()
    };
}

impl<H: Hamiltonian, X: Composition<H>, L: Real, K: Keep> Kernel for AdvanceAll<'_, H, X, L, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { mut motions, clock, steps, .. } = self;
        if Self::IN_GROUPS {
            let (groups, rest) = motions.as_chunks_mut::<TOGETHER>();
            for group in groups {
                Advance::<_, H, X>::new(Together::<H, L, K>(group), clock, steps).call();
            }
            motions = rest;
        }
        for motion in motions {
            Advance::<_, H, X>::new(Single::<H, L, K>(motion), clock, steps).call();
        }
    }
}

/// The end of the step under way.
struct CloseAll<'m, H: Hamiltonian, X, L: Real, K: Keep> {
    motions: &'m mut [H::Motion<L, K>],
    clock: Clock,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X: Composition<H>, L: Real, K: Keep> Kernel for CloseAll<'_, H, X, L, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        for motion in self.motions {
            Close::<_, H, X>::new(Single::<H, L, K>(motion), self.clock).call();
        }
    }
}

struct Finite<'m, H: Hamiltonian, L: Real, K: Keep>(&'m [H::Motion<L, K>]);

impl<H: Hamiltonian, L: Real, K: Keep> Kernel for Finite<'_, H, L, K> {
    type Out = bool;

    #[inline(always)]
    fn call(self) -> bool {
        self.0.iter().all(H::Motion::<L, K>::finite)
    }
}
