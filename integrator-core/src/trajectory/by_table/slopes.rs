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

/// A state and a vector after some steps, and the sum over their flows of the duration times the derivative of ∂E/∂θ along the
/// vector, for each parameter θ.
pub(crate) struct Steps<C> {
    pub(crate) state: Phase<C>,
    pub(crate) vector: Phase<C>,
    pub(crate) slopes: Vec<f64>,
    pub(crate) is_finite: bool,
}

/// A function that takes steps by a composition: with the constants of a system, from a state and a vector.
pub(crate) type StepsOf<P, C> = fn((Stages, Processor), &P, [&Phase<C>; 2], Clock, u64) -> Steps<C>;

/// Takes steps from a clock that begins there, by a composition without force gradients.
pub(crate) fn steps<H: ParameterDerivatives, K: Precision>(
    (stages, processor): (Stages, Processor),
    parameters: &H::Parameters<f64>,
    points: [&Phase<Shaped<H, K>>; 2],
    clock: Clock,
    steps: u64,
) -> Steps<Shaped<H, K>> {
    let table = Table { stages, processor, between: const { Between::of::<H>() } };
    let taken = match InstructionSet::chosen() {
        InstructionSet::Baseline => steps_in::<H, Dual<K::Plain>, K>,
        InstructionSet::Avx512 if H::WIDE => steps_in::<H, Dual<K::Avx512>, K>,
        InstructionSet::Fused | InstructionSet::Avx512 => steps_in::<H, Dual<K::Fused>, K>,
    };
    taken(table, parameters, points, clock, steps)
}

/// The same in a number with one derivative, with the point in lane 0 and the vector in lane 1.
fn steps_in<H: ParameterDerivatives, R: Real, K: Precision>(
    table: Table,
    parameters: &H::Parameters<f64>,
    [state, vector]: [&Phase<Shaped<H, K>>; 2],
    clock: Clock,
    steps: u64,
) -> Steps<Shaped<H, K>> {
    let mut motion = H::Motion::<R, K>::load(&[parameters; 2], &[state, vector]);
    motion.share_among(None);
    let mut slopes = vec![R::of(0.0); H::SENSITIVE.len()];
    let lists = [table.opening(), table.cycle(), table.closing(), table.undoing()];
    R::enter(Take::<H, R, K> { motion: &mut motion, slopes: &mut slopes, lists: &lists, clock, steps });
    let (mut at_end, mut image) = (state.clone(), vector.clone());
    motion.store(0, &mut at_end);
    motion.store(1, &mut image);
    let is_finite = motion.finite() && motion.unsolved(0).is_none();
    Steps { state: at_end, vector: image, slopes: slopes.iter().map(|slope| slope.lane(1)).collect(), is_finite }
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
