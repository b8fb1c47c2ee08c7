//! The loop over steps of several small motions, interleaved.
//!
//! A flow is a chain of operations that wait for each other. So a few small motions, whose lanes are members of an
//! ensemble, go through each stage together: while one waits, the others compute, and all of them stay in registers.

use crate::{
    composition::Composition,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, precision::Precision},
    system::{Shaped, System, flows::Together},
    trajectory::{
        step_functions::Executor,
        step_loop::{Advance, AdvanceOne},
    },
};
use core::{array, marker::PhantomData};

/// The number of motions in a group: by measurement on AVX2 and AVX-512, more than four wait less only where chains are long or
/// states small. Powers of two, so that groups divide the members of most ensembles.
const SOME: usize = 4;
const MANY: usize = 8;

/// The number of registers that a group's state may take out of 32, so that the rest is left to compute in. One too
/// many, and the state goes through memory at every stage: by measurement on AVX-512, members with compensated
/// coordinates of Hénon–Heiles, three motions together and six, take 0.30 and 0.68 ns per step. A root takes so long that eight
/// motions in memory are faster than four in registers: with Kepler's, 0.42 and 0.54 ns. Sixteen registers hold no group worth the
/// name; there, as many motions as may hide how long memory takes.
const FOR_STATE: usize = 24;

/// The n-step loop over all motions, one group after the other.
pub(crate) struct AdvanceAll<'m, H: System, X, R: Real, K: Precision, E> {
    motions: &'m mut [H::Motion<R, K>],
    clock: Clock,
    steps: u64,
    marker: PhantomData<(X, E)>,
}

impl<'m, H, X, R, K, E> AdvanceAll<'m, H, X, R, K, E>
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    /// The number of motions in a group.
    pub(crate) const TOGETHER: usize = {
        // A number with its derivatives fills as many registers.
        let registers = R::LANES / R::MEMBERS;
        let numbers = 2 * size_of::<<Shaped<H, K> as Coords>::Slots<R>>() / size_of::<R>() * registers;
        let fitting = match FOR_STATE.checked_div(numbers) {
            Some(fitting) => fitting,
            None => MANY,
        };
        // Outside of lattices and many bodies, flows that divide by roots.
        let is_long = H::WIDE && numbers <= 4;
        // A motion that owns memory is of a size known at run time, hence not small.
        if E::REGISTERS == 0 || core::mem::needs_drop::<H::Motion<R, K>>() || fitting < 2 {
            1
        } else if is_long || numbers <= 2 {
            MANY
        } else if E::REGISTERS < 32 || fitting > SOME {
            SOME
        } else {
            fitting
        }
    };

    pub(crate) fn new(motions: &'m mut [H::Motion<R, K>], clock: Clock, steps: u64) -> Self {
        Self { motions, clock, steps, marker: PhantomData }
    }

    /// Advances groups of `N` and returns the motions that fill none. Two or more are filled up by copies where
    /// registers hold all: a group takes less time than two motions alone.
    #[inline(always)]
    fn groups<const N: usize>(motions: &mut [H::Motion<R, K>], clock: Clock, steps: u64) -> &mut [H::Motion<R, K>] {
        let (groups, rest) = motions.as_chunks_mut::<N>();
        let is_filled = E::REGISTERS >= 32 && rest.len() > 1;
        let mut filled = is_filled.then(|| array::from_fn(|number| rest[number.min(rest.len() - 1)].clone()));
        for group in groups.iter_mut().chain(&mut filled) {
            Advance::<_, H, X>::new(Together::<H, R, K, N>(group), clock, steps).call();
        }
        let Some(filled) = filled else { return rest };
        for (motion, moved) in rest.iter_mut().zip(filled) {
            *motion = moved;
        }
        &mut []
    }
}

impl<H, X, R, K, E> Kernel for AdvanceAll<'_, H, X, R, K, E>
where
    H: System,
    X: Composition<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { motions, clock, steps, .. } = self;
        // Of these, code is made for one.
        let rest = match Self::TOGETHER {
            2 => Self::groups::<2>(motions, clock, steps),
            3 => Self::groups::<3>(motions, clock, steps),
            SOME => Self::groups::<SOME>(motions, clock, steps),
            MANY => Self::groups::<MANY>(motions, clock, steps),
            _ => motions,
        };
        for motion in rest {
            AdvanceOne::<H, X, R, K>::new(motion, clock, steps).call();
        }
    }
}
