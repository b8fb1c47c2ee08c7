//! The loop over the stages of a composition with friction.

use super::{
    applied::{Applied, OneByOne, Tiled},
    apply::{Draw, Kept, add_heat, thermalise_one, values},
    motion::{DampedOf, FrictionConstants, prepare, prepare_stage},
    scheme::{FrictionScheme, Letter},
};
use crate::{
    layout::lattice::time_tiling::TimeTiling,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, precision::Precision},
    system::{
        Shaped, System,
        dissipation::{Dissipation, WithFriction},
        motion::Motion,
    },
    trajectory::step_functions::{Executor, StepFunctions, all_finite},
};
use alloc::vec::Vec;
use core::{marker::PhantomData, ops::Range};

/// The step functions of a composition with friction.
pub fn steps_with_friction<X: FrictionScheme, H: WithFriction, R: Real, K: Precision, E: Executor>()
-> StepFunctions<DampedOf<H, R, K>> {
    StepFunctions {
        lanes: R::LANES,
        together: 1,
        advance: advance::<X, H, R, K, E>,
        complete: |motion, clock, _| complete::<X, H, R, K>(motion, clock),
        show: None,
        finite: all_finite::<Shaped<H, K>, FrictionConstants<H::Parameters<f64>>, _>,
        dense: Some(dense::<X, H, R, K>),
        energy: None,
        #[cfg(feature = "check")]
        squares: None,
    }
}

/// The stages of a composition: a constant where flows are small, and a value where they are large, so that flows are compiled
/// once and not for each stage.
trait Table: Copy {
    fn letters(self) -> &'static [Letter];
}

struct Constant<X>(PhantomData<X>);

impl<X> Clone for Constant<X> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<X> Copy for Constant<X> {}

impl<X: FrictionScheme> Table for Constant<X> {
    #[inline(always)]
    fn letters(self) -> &'static [Letter] {
        X::LETTERS
    }
}

impl Table for &'static [Letter] {
    #[inline(always)]
    fn letters(self) -> &'static [Letter] {
        self
    }
}

/// Whether the last flow of a step and the first of the next one are one flow. Random numbers belong to one step, and pieces
/// of H by time and inner steps end with it.
fn merges<H: System>(letters: &[Letter]) -> bool {
    match (letters.first(), letters.last()) {
        _ if letters.len() < 2 || H::PIECEWISE_IN_TIME => false,
        (Some(Letter::T(_)), Some(Letter::T(_))) => true,
        (Some(Letter::V(_)), Some(Letter::V(_))) => H::NESTED.is_empty(),
        _ => false,
    }
}

/// Whether the system has one coordinate.
const fn is_alone<H: System>() -> bool {
    matches!((H::Coords::LENGTH, H::Coords::COMPONENTS), (Some(1), 0 | 1))
}

/// Takes this number of steps.
fn advance<X: FrictionScheme, H: WithFriction, R: Real, K: Precision, E: Executor>(
    motions: &mut [DampedOf<H, R, K>],
    clock: Clock,
    steps: u64,
    threads: Option<usize>,
) {
    for motion in motions {
        prepare::<H, R, K>(motion, X::LETTERS, clock.h, clock.at(clock.steps));
        if const { E::TILES && TimeTiling::<H, R, K>::ENABLED } && motion.is_long() {
            let flows = Tiled { collected: Vec::new(), threads };
            Steps(Walk::<_, H, R, K, _>::new(motion, X::LETTERS, clock, flows), steps).call();
        } else if const { H::LARGE_FLOWS } {
            R::enter(Steps(Walk::<_, H, R, K, _>::new(motion, X::LETTERS, clock, OneByOne), steps));
        } else {
            let table = Constant::<X>(PhantomData);
            R::enter(Steps(Walk::<_, H, R, K, _>::new(motion, table, clock, OneByOne), steps));
        }
    }
}

/// Completes the current step.
fn complete<X: FrictionScheme, H: WithFriction, R: Real, K: Precision>(motion: &mut DampedOf<H, R, K>, clock: Clock) {
    if merges::<H>(X::LETTERS) && clock.steps > 0 {
        let clock = Clock { steps: clock.steps - 1, ..clock };
        walk_in_step::<H, R, K>(motion, X::LETTERS, clock, clock.at(clock.steps), X::LETTERS.len() - 1);
    }
}

/// Takes a motion a while into the step that begins at the other one and at the clock, with the random numbers of this step.
fn dense<X: FrictionScheme, H: WithFriction, R: Real, K: Precision>(
    to: &mut DampedOf<H, R, K>,
    begin: &DampedOf<H, R, K>,
    clock: Clock,
    duration: f64,
) {
    to.motion.copy_state(&begin.motion);
    complete::<X, H, R, K>(to, clock);
    walk_in_step::<H, R, K>(to, X::LETTERS, Clock { h: duration, ..clock }, clock.at(clock.steps), 0);
}

/// Takes the stages from this one on of the step that begins at `time`, and that the clock counts.
fn walk_in_step<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    letters: &'static [Letter],
    clock: Clock,
    time: f64,
    first: usize,
) {
    prepare::<H, R, K>(motion, letters, clock.h, time);
    R::enter(InStep(Walk::<_, H, R, K, _>::new(motion, letters, clock, OneByOne), time, first));
}

/// The loop over stages.
struct Walk<'m, T, H: WithFriction, R: Real, K: Precision, A> {
    motion: &'m mut DampedOf<H, R, K>,
    table: T,
    clock: Clock,
    kept: Kept<H::Wide<R>>,
    flows: A,
}

impl<'m, T, H: WithFriction, R: Real, K: Precision, A> Walk<'m, T, H, R, K, A> {
    fn new(motion: &'m mut DampedOf<H, R, K>, table: T, clock: Clock, flows: A) -> Self {
        Self { motion, table, clock, kept: None, flows }
    }
}

/// A number of steps.
struct Steps<W>(W, u64);

/// A step that begins at a time, from a stage on.
struct InStep<W>(W, f64, usize);

impl<T: Table, H: WithFriction, R: Real, K: Precision, A: Applied<H, R, K>> Kernel for Steps<Walk<'_, T, H, R, K, A>> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self(mut walk, steps) = self;
        let (clock, letters) = (walk.clock, walk.table.letters());
        let merges = merges::<H>(letters);
        let own = if merges { letters.len() - 1 } else { letters.len() };
        let mut step = clock.steps;
        while step < clock.steps + steps {
            let end_of_last = if merges && step > 0 { letters.last() } else { None };
            walk.stages(0..own, end_of_last, clock.at(step), step);
            step += 1;
        }
        walk.flows.finish(&mut walk.motion.motion);
    }
}

impl<H: WithFriction, R: Real, K: Precision> Kernel for InStep<Walk<'_, &'static [Letter], H, R, K, OneByOne>> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self(mut walk, time, first) = self;
        let (step, count) = (walk.clock.steps, walk.table.len());
        walk.stages(first..count, None, time, step);
    }
}

impl<T: Table, H: WithFriction, R: Real, K: Precision, A: Applied<H, R, K>> Walk<'_, T, H, R, K, A> {
    /// A range of the stages of a step that begins at `time`; the first of them is one flow with `before`.
    #[inline(always)]
    fn stages(&mut self, range: Range<usize>, before: Option<&Letter>, time: f64, step: u64) {
        let h = self.clock.h;
        if const { H::PIECEWISE_IN_TIME } {
            self.flows.finish(&mut self.motion.motion);
            H::begin_step::<R, K>(&mut self.motion.motion, time + h / 2.0);
        }
        // The sums of the drifts and of the kicks before a stage.
        let (mut drifts, mut kicks, mut friction) = (0.0, 0.0, 0);
        for (index, letter) in self.table.letters().iter().enumerate() {
            if index >= range.end {
                break;
            }
            let is_in_range = index >= range.start;
            let merged = before.filter(|_| index == 0);
            let motion = &mut self.motion.motion;
            match letter {
                Letter::T(share) => {
                    if is_in_range {
                        let more = if let Some(Letter::T(more)) = merged { *more } else { 0.0 };
                        self.flows.drift(motion, h * (share + more), time + h * kicks);
                    }
                    drifts += share;
                }
                Letter::V(share) => {
                    if is_in_range {
                        let more = if let Some(Letter::V(more)) = merged { *more } else { 0.0 };
                        let reached = if const { H::NESTED.is_empty() } { drifts } else { kicks };
                        self.flows.kick(motion, h * (share + more), time + h * reached);
                    }
                    kicks += share;
                }
                Letter::O(_) => {
                    if is_in_range {
                        let reached = if const { H::NESTED.is_empty() } { drifts } else { kicks };
                        self.friction(friction, time + h * reached, step);
                    }
                    friction += 1;
                }
            }
        }
    }

    /// A stage of friction.
    #[inline(always)]
    fn friction(&mut self, stage: usize, time: f64, step: u64) {
        let motion = &mut *self.motion;
        self.flows.finish(&mut motion.motion);
        if const { H::READS_TIME } {
            prepare_stage::<H, R, K>(motion, stage, time);
        }
        let Some(factors) = motion.factors.get(stage) else { return };
        let momenta = H::momenta::<R, K>(&mut motion.motion);
        if const { matches!(H::DISSIPATION, Dissipation::Heat) } {
            let key = key(motion.noise.seed, self.clock.t0);
            let stages = motion.factors.len() as u64;
            let number =
                if const { is_alone::<H>() } { step * stages + stage as u64 } else { step << 8 | stage as u64 };
            let draw = Draw { key, number, members: &motion.noise.members };
            let before = if motion.noise.heat.is_some() { values(momenta) } else { Vec::new() };
            if const { is_alone::<H>() } {
                thermalise_one::<R, _, _>(momenta, factors, draw, &mut self.kept);
            } else {
                self.flows.friction(momenta, factors, Some(draw));
            }
            if let Some(heat) = &mut motion.noise.heat {
                add_heat(heat, &before, momenta, &motion.inverse_masses);
            }
        } else {
            self.flows.friction(momenta, factors, None);
        }
    }
}

/// The key of the random numbers of a run. Steps are counted from where the state was last changed from outside, so that the
/// time there is a part of it.
#[inline(always)]
fn key(seed: u64, t0: f64) -> [u32; 2] {
    // The multiplier of MurmurHash3's finaliser: another time changes half of the bits.
    let mixed = (t0.to_bits() ^ t0.to_bits() >> 33).wrapping_mul(0xff51_afd7_ed55_8ccd);
    let key = seed ^ mixed ^ mixed >> 33;
    [key as u32, (key >> 32) as u32]
}
