//! The loop over the stages of a composition with friction.

use super::{
    apply::{Draw, damp, thermalise},
    motion::{DampedOf, FrictionConstants, prepare, prepare_stage},
    scheme::{FrictionScheme, Letter},
};
use crate::{
    scalar::real::{Kernel, Real},
    state::{clock::Clock, precision::Precision},
    system::{
        Shaped, System,
        dissipation::{Dissipation, WithFriction},
        flows::{Flows, Single},
        motion::Motion,
    },
    trajectory::step_functions::{StepFunctions, all_finite},
};
use core::{marker::PhantomData, ops::Range};

/// The step functions of a composition with friction.
pub fn steps_with_friction<X: FrictionScheme, H: WithFriction, R: Real, K: Precision>()
-> StepFunctions<DampedOf<H, R, K>> {
    StepFunctions {
        lanes: R::LANES,
        together: 1,
        advance: advance::<X, H, R, K>,
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

/// Takes this number of steps.
fn advance<X: FrictionScheme, H: WithFriction, R: Real, K: Precision>(
    motions: &mut [DampedOf<H, R, K>],
    clock: Clock,
    steps: u64,
    _threads: Option<usize>,
) {
    for motion in motions {
        if const { H::LARGE_FLOWS } {
            walk::<_, H, R, K>(motion, X::LETTERS, Portion { clock, part: Part::Steps(steps) });
        } else {
            walk::<_, H, R, K>(motion, Constant::<X>(PhantomData), Portion { clock, part: Part::Steps(steps) });
        }
    }
}

/// Completes the current step.
fn complete<X: FrictionScheme, H: WithFriction, R: Real, K: Precision>(motion: &mut DampedOf<H, R, K>, clock: Clock) {
    walk::<_, H, R, K>(motion, X::LETTERS, Portion { clock, part: Part::End });
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
    let part = Part::Whole(clock.at(clock.steps));
    walk::<_, H, R, K>(to, X::LETTERS, Portion { clock: Clock { h: duration, ..clock }, part });
}

/// A portion of the steps of a run.
#[derive(Clone, Copy)]
struct Portion {
    clock: Clock,
    part: Part,
}

#[derive(Clone, Copy)]
enum Part {
    /// This number of steps, without the end of the last one.
    Steps(u64),
    /// The end of the current step.
    End,
    /// One whole step, which begins at this time.
    Whole(f64),
}

fn walk<T: Table, H: WithFriction, R: Real, K: Precision>(motion: &mut DampedOf<H, R, K>, table: T, portion: Portion) {
    prepare::<H, R, K>(motion, table.letters(), portion.clock.h, portion.clock.at(portion.clock.steps));
    R::enter(Walk::<T, H, R, K> { motion, table, portion });
}

/// The loop over stages.
struct Walk<'m, T, H: WithFriction, R: Real, K: Precision> {
    motion: &'m mut DampedOf<H, R, K>,
    table: T,
    portion: Portion,
}

impl<T: Table, H: WithFriction, R: Real, K: Precision> Kernel for Walk<'_, T, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let Portion { clock, part } = self.portion;
        let letters = self.table.letters();
        let merges = merges::<H>(letters);
        let own = if merges { letters.len() - 1 } else { letters.len() };
        match part {
            Part::End => {
                if merges && clock.steps > 0 {
                    self.stages(own..letters.len(), None, clock.at(clock.steps - 1), clock.steps - 1);
                }
            }
            Part::Whole(time) => self.stages(0..letters.len(), None, time, clock.steps),
            Part::Steps(steps) => {
                for step in clock.steps..clock.steps + steps {
                    let end_of_last = letters.last().filter(|_| merges && step > 0);
                    self.stages(0..own, end_of_last, clock.at(step), step);
                }
            }
        }
    }
}

impl<T: Table, H: WithFriction, R: Real, K: Precision> Walk<'_, T, H, R, K> {
    /// A range of the stages of a step that begins at `time`; the first of them is one flow with `before`.
    #[inline(always)]
    fn stages(&mut self, range: Range<usize>, before: Option<&Letter>, time: f64, step: u64) {
        let h = self.portion.clock.h;
        if const { H::PIECEWISE_IN_TIME } {
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
            let mut flows = Single::<H, R, K>(&mut self.motion.motion);
            match letter {
                Letter::T(share) => {
                    if is_in_range {
                        let more = if let Some(Letter::T(more)) = merged { *more } else { 0.0 };
                        flows.drift(h * (share + more), time + h * kicks);
                    }
                    drifts += share;
                }
                Letter::V(share) => {
                    if is_in_range {
                        let more = if let Some(Letter::V(more)) = merged { *more } else { 0.0 };
                        let reached = if const { H::NESTED.is_empty() } { drifts } else { kicks };
                        flows.kick(h * (share + more), time + h * reached);
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
        if const { H::READS_TIME } {
            prepare_stage::<H, R, K>(motion, stage, time);
        }
        let Some(factors) = motion.factors.get(stage) else { return };
        let momenta = H::momenta::<R, K>(&mut motion.motion);
        if const { matches!(H::DISSIPATION, Dissipation::Heat) } {
            let step = step << 8 | stage as u64;
            let draw =
                Draw { key: key(motion.noise.seed, self.portion.clock.t0), step, members: &motion.noise.members };
            thermalise::<R, _, _>(momenta, &factors.rows, draw);
        } else {
            damp(momenta, &factors.rows);
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
