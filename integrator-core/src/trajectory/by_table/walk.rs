//! The loop over the flows of a table.

use crate::{
    composition::{Lead, Stage, Stages, corrected_durations::Corrections},
    layout::lattice::time_tiling::TimeTiling,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, precision::Precision},
    system::{
        System,
        flows::{Flows, Single},
        motion::{InRegisters, Motion},
    },
    trajectory::{
        by_table::{
            Kicks,
            letters::{Flow, Letter, Table},
        },
        step_functions::Executor,
    },
};
use alloc::vec::Vec;
use core::{marker::PhantomData, ops::Range};

/// A portion of the flows of a composition: steps, the end of the current step, or the end of the processor.
#[derive(Clone, Copy)]
pub(super) enum Portion {
    /// A number of steps.
    Steps(u64),
    /// The end of the current step.
    Closing,
    /// The inverse of the processor, after the step.
    Undoing,
}

/// Takes a motion a portion further.
pub(super) fn walk<H, G, R, K, E>(
    motion: &mut H::Motion<R, K>,
    table: Table,
    clock: Clock,
    portion: Portion,
    threads: Option<usize>,
) where
    H: System,
    G: Kicks<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    if const { E::TILES && TimeTiling::<H, R, K>::ENABLED } {
        let mut flows = TimeTiling::<H, R, K>::new(motion, threads);
        Walk::<_, H, G>::new(&mut flows, table, clock, portion).call();
        flows.finish();
    } else {
        R::enter(WalkOne::<H, G, R, K>(Walk::new(Single(motion), table, clock, portion)));
    }
}

/// The loop over flows of one motion, moved out of memory where that is worth it for any step.
struct WalkOne<'m, H: System, G, R: Real, K: Precision>(Walk<Single<'m, H, R, K>, H, G>);

impl<H: System, G: Kicks<H>, R: Real, K: Precision> Kernel for WalkOne<'_, H, G, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Walk { flows: Single(motion), table, clock, portion, .. } = self.0;
        if const { matches!(<H::Motion<R, K> as Motion<_, _>>::IN_REGISTERS, InRegisters::Always) } {
            let mut own = motion.take();
            Walk::<_, H, G>::new(Single::<H, R, K>(&mut own), table, clock, portion).call();
            *motion = own;
        } else {
            Walk::<_, H, G>::new(Single::<H, R, K>(motion), table, clock, portion).call();
        }
    }
}

/// The loop over flows.
struct Walk<F, H, G> {
    flows: F,
    table: Table,
    clock: Clock,
    portion: Portion,
    marker: PhantomData<(fn(H), G)>,
}

impl<F, H, G> Walk<F, H, G> {
    fn new(flows: F, table: Table, clock: Clock, portion: Portion) -> Self {
        Self { flows, table, clock, portion, marker: PhantomData }
    }
}

/// Flows in their order.
struct Pass<'l> {
    letters: &'l [Letter],
    /// The number of the step that they belong to.
    step: u64,
    /// Whether the durations of the flows are corrected.
    corrected: bool,
}

/// The flows of a portion; lists that it does not read are empty.
#[derive(Default)]
struct Lists {
    opening: Vec<Letter>,
    cycle: Vec<Letter>,
    closing: Vec<Letter>,
    undoing: Vec<Letter>,
}

/// The number of passes of a step that is taken by itself: the end of the last step, what undoes the processor,
/// and all up to the step's own end.
const WHOLE_STEP: u64 = 3;

impl<F: Flows<H>, H: System, G: Kicks<H>> Kernel for Walk<F, H, G> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let corrections = if F::COMPENSATED { self.corrections() } else { Corrections::NONE };
        let (passes, lists) = (self.passes(), self.lists());
        // One loop, so that each flow is compiled once for all of these.
        for number in 0..passes {
            let Some(Pass { letters, step, corrected }) = self.pass(number, &lists) else { continue };
            let (h, time) = (self.clock.h, self.clock.at(step));
            if const { H::PIECEWISE_IN_TIME } {
                self.flows.begin_step(time + h / 2.0);
            }
            if F::COMPENSATED {
                let corrections = if corrected { corrections } else { Corrections::NONE };
                Self::apply(&mut corrections.on(&mut self.flows, step), letters, h, time);
            } else {
                Self::apply(&mut self.flows, letters, h, time);
            }
        }
        if const { Self::IN_PAIRS }
            && let Portion::Steps(steps) = self.portion
        {
            self.cycles(self.clock.steps + passes..self.clock.steps + steps, corrections);
        }
    }
}

impl<F: Flows<H>, H: System, G: Kicks<H>> Walk<F, H, G> {
    /// Whether cycles go in drifts and kicks by turns, which keeps small states in registers.
    const IN_PAIRS: bool = !H::PIECEWISE_IN_TIME && !H::LARGE_FLOWS && H::PARTS.len() == 2;

    /// Cycles in a loop without a branch.
    #[inline(always)]
    fn cycles(&mut self, steps: Range<u64>, corrections: Corrections) {
        let (h, Stages { lead, cycle, .. }) = (self.clock.h, self.table.stages);
        match lead {
            Lead::Drift => {
                for step in steps {
                    let time = self.clock.at(step);
                    if F::COMPENSATED {
                        Self::drifts_and_kicks(&mut corrections.on(&mut self.flows, step), cycle, h, time);
                    } else {
                        Self::drifts_and_kicks(&mut self.flows, cycle, h, time);
                    }
                }
            }
            Lead::Kick => {
                for step in steps {
                    let time = self.clock.at(step);
                    if F::COMPENSATED {
                        Self::kicks_and_drifts(&mut corrections.on(&mut self.flows, step), cycle, h, time);
                    } else {
                        Self::kicks_and_drifts(&mut self.flows, cycle, h, time);
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn drifts_and_kicks(flows: &mut impl Flows<H>, cycle: &[Stage], h: f64, time: f64) {
        for stage in cycle {
            flows.drift(h * stage.drift, time + h * stage.drift_time);
            Self::kick(flows, stage, h, time);
        }
    }

    #[inline(always)]
    fn kicks_and_drifts(flows: &mut impl Flows<H>, cycle: &[Stage], h: f64, time: f64) {
        for stage in cycle {
            Self::kick(flows, stage, h, time);
            flows.drift(h * stage.drift, time + h * stage.drift_time);
        }
    }

    #[inline(always)]
    fn kick(flows: &mut impl Flows<H>, stage: &Stage, h: f64, time: f64) {
        if G::GRADIENTS && stage.gradient != 0.0 {
            G::gradient_kick(flows, h * stage.kick, h * h * h * stage.gradient, time + h * stage.kick_time);
        } else {
            flows.kick(h * stage.kick, time + h * stage.kick_time);
        }
    }

    fn are_whole(&self) -> bool {
        self.table.stages.are_whole::<H>()
    }

    /// Returns the number of passes that make the portion, beside cycles that go in pairs.
    fn passes(&self) -> u64 {
        match self.portion {
            Portion::Steps(steps) if self.are_whole() => WHOLE_STEP * steps,
            // All but the first step of a run are cycles.
            Portion::Steps(steps) if Self::IN_PAIRS => {
                if self.clock.steps == 0 {
                    steps.min(1)
                } else {
                    0
                }
            }
            Portion::Steps(steps) => steps,
            Portion::Closing | Portion::Undoing => 1,
        }
    }

    /// The lists that passes read.
    fn lists(&self) -> Lists {
        let (table, none) = (&self.table, Lists::default());
        match self.portion {
            Portion::Closing => Lists { closing: table.closing(), ..none },
            Portion::Undoing => Lists { undoing: table.undoing(), ..none },
            Portion::Steps(_) if self.are_whole() => {
                Lists { opening: table.opening(), closing: table.closing(), undoing: table.undoing(), ..none }
            }
            Portion::Steps(_) => {
                let opening = if self.clock.steps == 0 { table.opening() } else { Vec::new() };
                Lists { opening, cycle: if Self::IN_PAIRS { Vec::new() } else { table.cycle() }, ..none }
            }
        }
    }

    /// The pass of this number; `None` for the end of a step before the first one.
    #[inline]
    fn pass<'l>(&self, number: u64, lists: &'l Lists) -> Option<Pass<'l>> {
        let begin = self.clock.steps;
        let ending =
            |letters: &'l [Letter], step: u64| Some(Pass { letters, step: step.checked_sub(1)?, corrected: false });
        match self.portion {
            Portion::Closing => ending(&lists.closing, begin),
            Portion::Undoing => ending(&lists.undoing, begin),
            Portion::Steps(_) if self.are_whole() => {
                let step = begin + number / WHOLE_STEP;
                match number % WHOLE_STEP {
                    0 => ending(&lists.closing, step),
                    1 => ending(&lists.undoing, step),
                    _ => Some(Pass { letters: &lists.opening, step, corrected: true }),
                }
            }
            Portion::Steps(_) => match begin + number {
                0 => Some(Pass { letters: &lists.opening, step: 0, corrected: false }),
                step => Some(Pass { letters: &lists.cycle, step, corrected: true }),
            },
        }
    }

    fn corrections(&self) -> Corrections {
        let Table { stages, processor, between } = &self.table;
        if self.are_whole() {
            Corrections::of_whole_steps(stages, processor, self.clock.h, *between)
        } else {
            Corrections::new(stages, self.clock.h, *between)
        }
    }

    #[inline(always)]
    fn apply(flows: &mut impl Flows<H>, letters: &[Letter], h: f64, begin: f64) {
        for letter in letters {
            let (duration, time) = (h * letter.duration, begin + h * letter.time);
            match letter.flow {
                Flow::Drift => flows.drift(duration, time),
                Flow::Kick => flows.kick(duration, time),
                Flow::GradientKick => G::gradient_kick(flows, duration, h * h * h * letter.gradient, time),
                Flow::Middle { backwards } => flows.middle(duration, time, backwards),
            }
        }
    }
}
