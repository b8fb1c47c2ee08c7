//! Any composition by one loop: its table is a value that the loop reads, and not a constant that it was compiled for.
//!
//! In: the stages of a composition that may integrate a system. Out: a method with the same steps to the last bit. Always
//! true: each flow of the system stands in the loop once, so that a program that goes through the whole catalogue compiles
//! as much as for one composition.

use crate::{
    composition::{Lead, Processor, Scheme, Stage, Stages, corrected_durations::Corrections},
    error::Unsolved,
    hamiltonian::{Flows, Hamiltonian, QuadraticKinetic, Single},
    layout::lattice::time_tiling::TimeTiling,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::motion::Motion,
    trajectory::{
        method::{Described, Facts, Method},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::{sync::Arc, vec::Vec};
use core::marker::PhantomData;

/// A composition as a method with its table as a value; `G` says whether it has kicks with force gradients.
pub(crate) struct ByTable<G> {
    facts: Facts,
    stages: Stages,
    processor: Processor,
    gradients: PhantomData<G>,
}

/// Kicks of the potential alone.
pub(crate) struct Plain;

/// Kicks with force gradients beside them.
pub(crate) struct WithGradients;

impl<G> ByTable<G> {
    /// This composition. It has to be one for the system that it is run with.
    pub(crate) fn of<X: Scheme>(composition: X) -> Self {
        Self { facts: composition.facts(), stages: X::STAGES, processor: X::PROCESSOR, gradients: PhantomData }
    }
}

impl<G> Clone for ByTable<G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G> Copy for ByTable<G> {}

impl<G: Send + Sync + 'static> Described for ByTable<G> {
    fn facts(self) -> Facts {
        self.facts
    }
}

/// How kicks of a table are applied.
pub(crate) trait Kicks<H: Hamiltonian>: Send + Sync + 'static {
    /// The flow of `duration·V + gradient·|∇V|²`.
    fn gradient_kick(flows: &mut impl Flows<H>, duration: f64, gradient: f64, time: f64);
}

impl<H: Hamiltonian> Kicks<H> for Plain {
    #[inline(always)]
    fn gradient_kick(_: &mut impl Flows<H>, _: f64, _: f64, _: f64) {}
}

impl<H: QuadraticKinetic> Kicks<H> for WithGradients {
    #[inline(always)]
    fn gradient_kick(flows: &mut impl Flows<H>, duration: f64, gradient: f64, time: f64) {
        flows.gradient_kick(duration, gradient, time);
    }
}

impl<H: Hamiltonian, G: Kicks<H>> Method<H> for ByTable<G> {
    type Constants = Constants<H::Parameters<f64>>;
    type Motion<R: Real, K: Precision> = Tabled<H::Motion<R, K>>;

    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
        let letters = Arc::new(Letters::new(self.stages, self.processor, H::PARTS.len()));
        Arc::new(Constants { parameters, letters })
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
        StepFunctions {
            lanes: R::LANES,
            together: 1,
            advance: |motions, clock, steps, threads| {
                for motion in motions {
                    walk::<H, G, R, K, E>(motion, clock, Portion::Steps(steps), threads);
                }
            },
            complete: |motion, clock| walk::<H, G, R, K, E>(motion, clock, Portion::Closing, Some(1)),
            show: Some(|motion, clock| walk::<H, G, R, K, E>(motion, clock, Portion::Undoing, Some(1))),
            finite: |motions| motions.iter().all(|motion| finite::<H, R, K>(&motion.motion)),
            dense: None,
        }
    }
}

fn finite<H: Hamiltonian, R: Real, K: Precision>(motion: &H::Motion<R, K>) -> bool {
    motion.finite()
}

/// One flow of a step.
#[derive(Clone, Copy)]
struct Letter {
    flow: Flow,
    /// How long it lasts, as a fraction of the step.
    duration: f64,
    /// The coefficient of the gradient of the squared force.
    gradient: f64,
    /// When it reads the time, as a fraction of the step.
    time: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Flow {
    Drift,
    Kick,
    GradientKick,
    /// Those of the parts between the first and the last, in their order or backwards.
    Middle {
        backwards: bool,
    },
}

/// A composition as flows one after the other.
struct Letters {
    stages: Stages,
    processor: Processor,
    opening: Vec<Letter>,
    cycle: Vec<Letter>,
    closing: Vec<Letter>,
    undoing: Vec<Letter>,
}

impl Letters {
    /// The flows that [`Composition`](crate::Composition) takes, for this many parts.
    fn new(stages: Stages, processor: Processor, parts: usize) -> Self {
        let moving = |lead, rows: &[Stage]| -> Vec<Letter> {
            rows.iter().flat_map(|row| both(lead, row)).filter(|letter| !letter.stands_still()).collect()
        };
        let steps = |first: &Stage| -> Vec<Letter> {
            let steps = [first].into_iter().chain(&stages.cycle[1..]);
            steps.flat_map(|stage| all(stages.lead, stage, parts)).collect()
        };
        let mut opening = moving(processor.before.lead, processor.before.rows);
        opening.extend(steps(&stages.opening));
        Self {
            stages,
            processor,
            opening,
            cycle: steps(&stages.cycle[0]),
            closing: moving(stages.lead, &[stages.closing]),
            undoing: moving(processor.after.lead, processor.after.rows),
        }
    }
}

impl Letter {
    fn stands_still(&self) -> bool {
        self.duration == 0.0 && self.gradient == 0.0
    }
}

/// The drift and the kick of a stage.
fn both(lead: Lead, stage: &Stage) -> [Letter; 2] {
    let Stage { drift, kick, gradient, drift_time, kick_time, .. } = *stage;
    let flow = if gradient == 0.0 { Flow::Kick } else { Flow::GradientKick };
    let drift = Letter { flow: Flow::Drift, duration: drift, gradient: 0.0, time: drift_time };
    let kick = Letter { flow, duration: kick, gradient, time: kick_time };
    match lead {
        Lead::Drift => [drift, kick],
        Lead::Kick => [kick, drift],
    }
}

/// All flows of a stage, for this many parts.
fn all(lead: Lead, stage: &Stage, parts: usize) -> impl Iterator<Item = Letter> {
    let [within, behind] = stage.middle;
    let middle = move |duration, backwards| {
        let moves = parts > 2 && duration != 0.0;
        moves.then_some(Letter { flow: Flow::Middle { backwards }, duration, gradient: 0.0, time: 0.0 })
    };
    let [first, last] = both(lead, stage);
    let kick_first = lead == Lead::Kick;
    [Some(first), middle(within, kick_first), Some(last), middle(behind, !kick_first)].into_iter().flatten()
}

/// The constants of a system with the flows of a composition.
pub(crate) struct Constants<P> {
    parameters: Arc<P>,
    letters: Arc<Letters>,
}

/// A motion of the system with the flows of a composition.
#[derive(Clone)]
pub(crate) struct Tabled<M> {
    motion: M,
    letters: Arc<Letters>,
}

impl<M> Tabled<M> {
    fn new<P>(constants: &[&Constants<P>], load: impl FnOnce(&[&P]) -> M) -> Self {
        let parameters: Vec<&P> = constants.iter().map(|constants| &*constants.parameters).collect();
        Self { motion: load(&parameters), letters: constants[0].letters.clone() }
    }
}

impl<C: Coords, P: Send + Sync + 'static, M: Motion<C, P>> Motion<C, Constants<P>> for Tabled<M> {
    const MIXES: bool = M::MIXES;

    fn load(constants: &[&Constants<P>], states: &[&Phase<C>]) -> Self {
        Self::new(constants, |parameters| M::load(parameters, states))
    }
    fn load_own(constants: &[&Constants<P>], states: &[&Phase<C>]) -> Self {
        Self::new(constants, |parameters| M::load_own(parameters, states))
    }
    fn gathered<'a>(of_lane: &dyn Fn(usize) -> (&'a Constants<P>, &'a Self, usize)) -> Option<Self>
    where
        P: 'a,
    {
        let motion = M::gathered(&|lane| {
            let (constants, tabled, lane) = of_lane(lane);
            (&*constants.parameters, &tabled.motion, lane)
        })?;
        Some(Self { motion, letters: of_lane(0).0.letters.clone() })
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store(lane, to);
    }
    fn store_own(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store_own(lane, to);
    }
    fn copy_state(&mut self, from: &Self) {
        self.motion.copy_state(&from.motion);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.motion.share_among(threads);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.motion.unsolved(lane)
    }
    fn evaluations(&self) -> Option<u64> {
        self.motion.evaluations()
    }
    fn finite(&self) -> bool {
        self.motion.finite()
    }
}

/// What is done with a motion.
#[derive(Clone, Copy)]
enum Portion {
    /// So many steps.
    Steps(u64),
    /// The end of the step under way.
    Closing,
    /// What undoes the processor behind it.
    Undoing,
}

/// Takes a motion a portion further.
fn walk<H, G, R, K, E>(tabled: &mut Tabled<H::Motion<R, K>>, clock: Clock, portion: Portion, threads: Option<usize>)
where
    H: Hamiltonian,
    G: Kicks<H>,
    R: Real,
    K: Precision,
    E: Executor,
{
    let letters = &*tabled.letters;
    if const { E::TILES && TimeTiling::<H, R, K>::ENABLED } {
        let mut flows = TimeTiling::<H, R, K>::new(&mut tabled.motion, threads);
        Walk::<_, H, G>::new(&mut flows, letters, clock, portion).call();
        flows.finish();
    } else {
        R::enter(Walk::<_, H, G>::new(Single::<H, R, K>(&mut tabled.motion), letters, clock, portion));
    }
}

/// The loop over flows.
struct Walk<'l, F, H, G> {
    flows: F,
    letters: &'l Letters,
    clock: Clock,
    portion: Portion,
    marker: PhantomData<(fn(H), G)>,
}

impl<'l, F, H, G> Walk<'l, F, H, G> {
    fn new(flows: F, letters: &'l Letters, clock: Clock, portion: Portion) -> Self {
        Self { flows, letters, clock, portion, marker: PhantomData }
    }
}

/// Flows in their order.
struct Pass<'l> {
    letters: &'l [Letter],
    /// The number of the step that they belong to.
    step: u64,
    /// Whether their durations are corrected.
    corrected: bool,
}

/// What a step consists of where pieces of H meet in time: the end of the last one, what undoes the processor, and all up
/// to its own end.
const WHOLE_STEP: u64 = 3;

impl<F: Flows<H>, H: Hamiltonian, G: Kicks<H>> Kernel for Walk<'_, F, H, G> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let corrections = if F::COMPENSATED { self.corrections() } else { Corrections::NONE };
        // One loop over all passes, so that each flow is compiled once.
        for number in 0..self.passes() {
            let Some(Pass { letters, step, corrected }) = self.pass(number) else { continue };
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
    }
}

impl<'l, F: Flows<H>, H: Hamiltonian, G: Kicks<H>> Walk<'l, F, H, G> {
    /// How many passes make the portion.
    fn passes(&self) -> u64 {
        match self.portion {
            Portion::Steps(steps) if H::PIECEWISE_IN_TIME => WHOLE_STEP * steps,
            Portion::Steps(steps) => steps,
            Portion::Closing | Portion::Undoing => 1,
        }
    }

    /// The pass of this number; `None` for the end of a step before the first one.
    #[inline]
    fn pass(&self, number: u64) -> Option<Pass<'l>> {
        let (letters, begin) = (self.letters, self.clock.steps);
        let ending = |letters, step: u64| Some(Pass { letters, step: step.checked_sub(1)?, corrected: false });
        match self.portion {
            Portion::Closing => ending(&letters.closing, begin),
            Portion::Undoing => ending(&letters.undoing, begin),
            Portion::Steps(_) if H::PIECEWISE_IN_TIME => {
                let step = begin + number / WHOLE_STEP;
                match number % WHOLE_STEP {
                    0 => ending(&letters.closing, step),
                    1 => ending(&letters.undoing, step),
                    _ => Some(Pass { letters: &letters.opening, step, corrected: true }),
                }
            }
            Portion::Steps(_) => match begin + number {
                0 => Some(Pass { letters: &letters.opening, step: 0, corrected: false }),
                step => Some(Pass { letters: &letters.cycle, step, corrected: true }),
            },
        }
    }

    fn corrections(&self) -> Corrections {
        let Letters { stages, processor, .. } = self.letters;
        if H::PIECEWISE_IN_TIME {
            Corrections::of_whole_steps(stages, processor, self.clock.h, H::PARTS.len())
        } else {
            Corrections::new(stages, self.clock.h, H::PARTS.len())
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
                Flow::Middle { backwards } => flows.middle(duration, backwards),
            }
        }
    }
}

#[cfg(test)]
mod tests;
