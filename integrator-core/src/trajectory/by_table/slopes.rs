//! Steps of a composition with one deviation vector, and the derivatives of its flows' energies with respect to parameters.
//!
//! Along the flow of `T(p)` or `V(q)` for a duration `d`, the derivative of the energy along the vector `v` stays the same. The end
//! of the flow changes with a parameter by `d J ∇∂E/∂θ`, and a function of the state, whose derivatives turned by J⁻¹ are `v`, by
//! `d` times the derivative of `∂E/∂θ` along `v`.

use crate::{
    composition::{Processor, Stages, corrected_durations::Between},
    scalar::{
        dual::Dual,
        instruction_set::InstructionSet,
        real::{Kernel, Real},
    },
    state::{clock::Clock, phase::Phase, precision::Precision},
    system::{Shaped, motion::Motion, parameter_derivatives::ParameterDerivatives},
    trajectory::by_table::letters::{Flow, Letter, Table},
};
use alloc::{vec, vec::Vec};

/// Whether a system has the derivatives that [`steps`] adds up, in a precision.
pub(crate) const fn has_slopes<H: ParameterDerivatives, K: Precision>() -> bool {
    H::ENERGIES_HAVE_SLOPES && !H::PIECEWISE_IN_TIME && K::PLAIN
}

/// States, each followed by its vector, after some steps; and for each state the sums over flows of the duration times the
/// derivative of ∂E/∂θ along the vector, for each parameter θ.
pub(crate) struct Steps<C> {
    pub(crate) points: Vec<Phase<C>>,
    pub(crate) slopes: Vec<f64>,
    pub(crate) is_finite: bool,
}

/// A function that takes steps from a clock that begins there, by a composition without force gradients: with the constants of a
/// system for each state and for its vector, and these points.
pub(crate) type StepsOf<P, C> = fn((Stages, Processor), &[&P], &[&Phase<C>], Clock, u64) -> Steps<C>;

/// The function for one state and its vector.
pub(crate) fn single<H: ParameterDerivatives, K: Precision>() -> StepsOf<H::Parameters<f64>, Shaped<H, K>> {
    match InstructionSet::chosen() {
        InstructionSet::Baseline => steps::<H, Dual<K::Plain>, K>,
        InstructionSet::Avx512 if H::WIDE => steps::<H, Dual<K::Avx512>, K>,
        InstructionSet::Fused | InstructionSet::Avx512 => steps::<H, Dual<K::Fused>, K>,
    }
}

/// Takes steps in a number with one derivative, whose lanes are the points.
pub(crate) fn steps<H: ParameterDerivatives, R: Real, K: Precision>(
    (stages, processor): (Stages, Processor),
    parameters: &[&H::Parameters<f64>],
    points: &[&Phase<Shaped<H, K>>],
    clock: Clock,
    steps: u64,
) -> Steps<Shaped<H, K>> {
    let table = Table { stages, processor, between: const { Between::of::<H>() } };
    let mut motion = H::Motion::<R, K>::load(parameters, points);
    if const { R::MEMBERS == 1 } {
        motion.share_among(None);
    }
    let mut slopes = vec![R::of(0.0); H::SENSITIVE.len()];
    let lists = [table.opening(), table.cycle(), table.closing(), table.undoing()];
    R::enter(Take::<H, R, K> { motion: &mut motion, slopes: &mut slopes, lists: &lists, clock, steps });
    let (mut ends, mut of_members) = (Vec::with_capacity(points.len()), Vec::new());
    for (lane, point) in points.iter().enumerate() {
        let mut end = (*point).clone();
        motion.store(lane, &mut end);
        ends.push(end);
    }
    for member in 0..points.len() / 2 {
        for slope in &slopes {
            of_members.push(slope.lane(2 * member + 1));
        }
    }
    let is_finite = motion.finite() && (0..points.len()).all(|lane| motion.unsolved(lane).is_none());
    Steps { points: ends, slopes: of_members, is_finite }
}

/// A number of steps from a closed state to another.
struct Take<'m, H: ParameterDerivatives, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    slopes: &'m mut [R],
    /// The flows of the first step, of a later one, of the end of the last one, and of what undoes the processor.
    lists: &'m [Vec<Letter>; 4],
    clock: Clock,
    steps: u64,
}

impl<H: ParameterDerivatives, R: Real, K: Precision> Kernel for Take<'_, H, R, K> {
    type Out = ();

    /// One loop, so that each flow is compiled once.
    #[inline(always)]
    fn call(self) {
        let Self { motion, slopes, lists: [opening, cycle, closing, undoing], clock: Clock { t0, h, .. }, steps } =
            self;
        let Some(last) = steps.checked_sub(1) else { return };
        for pass in 0..steps + 2 {
            let letters = match pass {
                0 => opening,
                _ if pass < steps => cycle,
                _ if pass == steps => closing,
                _ => undoing,
            };
            let begin = t0 + pass.min(last) as f64 * h;
            for letter in letters {
                let (duration, time) = (h * letter.duration, begin + h * letter.time);
                match letter.flow {
                    Flow::Drift => {
                        H::add_slopes_of_kinetic::<R, K>(motion, duration, time, slopes);
                        H::drift::<R, K>(motion, duration, time);
                    }
                    Flow::Kick => {
                        H::add_slopes_of_potential::<R, K>(motion, duration, time, slopes);
                        H::kick::<R, K>(motion, duration, time);
                    }
                    // Compositions with these kicks take another way back, and there is no third part.
                    Flow::GradientKick | Flow::Middle { .. } => {}
                }
            }
        }
    }
}
