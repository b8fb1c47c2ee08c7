//! Steps of a composition with one deviation vector, and the derivatives of its flows' energies with respect to parameters.
//!
//! Along the flow of `T(p)` or `V(q)` for a duration `d`, the derivative of the energy along the vector `v` stays the same. The end
//! of the flow changes with a parameter by `d J ∇∂E/∂θ`, and a function of the state, whose derivatives turned by J⁻¹ are `v`, by
//! `d` times the derivative of `∂E/∂θ` along `v`.

use crate::{
    composition::{Processor, Stages, corrected_durations::Between},
    hamiltonian::Hamiltonian,
    scalar::{
        dual::Dual,
        instruction_set::InstructionSet,
        real::{Kernel, Real},
    },
    state::{clock::Clock, phase::Phase, precision::Precision},
    system::{QuadraticKinetic, Shaped, flows::Flows, motion::Motion},
    trajectory::by_table::{
        Plain,
        letters::Table,
        walk::{Portion, Walk},
    },
};
use alloc::{vec, vec::Vec};

/// Whether a system has the derivatives that [`steps`] adds up, in a precision.
pub(crate) const fn has_slopes<H: Hamiltonian, K: Precision>() -> bool {
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

/// Takes steps by a composition without force gradients.
pub(crate) fn steps<H: Hamiltonian, K: Precision>(
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
fn steps_in<H: Hamiltonian, R: Real, K: Precision>(
    table: Table,
    parameters: &H::Parameters<f64>,
    [state, vector]: [&Phase<Shaped<H, K>>; 2],
    clock: Clock,
    steps: u64,
) -> Steps<Shaped<H, K>> {
    let mut motion = H::Motion::<R, K>::load(&[parameters; 2], &[state, vector]);
    motion.share_among(None);
    let mut slopes = vec![R::of(0.0); H::SENSITIVE.len()];
    let end = Clock { steps: clock.steps + steps, ..clock };
    let undoing = (!table.processor.after.rows.is_empty()).then_some((Portion::Undoing, end));
    for (portion, clock) in [(Portion::Steps(steps), clock), (Portion::Closing, end)].into_iter().chain(undoing) {
        R::enter(Take::<H, R, K> { motion: &mut motion, slopes: &mut slopes, table, clock, portion });
    }
    let (mut at_end, mut image) = (state.clone(), vector.clone());
    motion.store(0, &mut at_end);
    motion.store(1, &mut image);
    let is_finite = motion.finite() && motion.unsolved(0).is_none();
    Steps { state: at_end, vector: image, slopes: slopes.iter().map(|slope| slope.lane(1)).collect(), is_finite }
}

/// A portion of the flows.
struct Take<'m, H: Hamiltonian, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    slopes: &'m mut [R],
    table: Table,
    clock: Clock,
    portion: Portion,
}

impl<H: Hamiltonian, R: Real, K: Precision> Kernel for Take<'_, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { motion, slopes, table, clock, portion } = self;
        Walk::<_, H, Plain>::new(Adding::<H, R, K> { motion, slopes }, table, clock, portion).call();
    }
}

/// The flows of one motion, which add the derivatives of their energies to a list.
struct Adding<'m, H: Hamiltonian, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    slopes: &'m mut [R],
}

impl<H: Hamiltonian, R: Real, K: Precision> Flows<H> for Adding<'_, H, R, K> {
    const COMPENSATED: bool = false;

    #[inline(always)]
    fn drift(&mut self, duration: f64, time: f64) {
        H::add_slopes_of_kinetic::<R, K>(self.motion, duration, time, self.slopes);
        H::drift::<R, K>(self.motion, duration, time);
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, time: f64) {
        H::add_slopes_of_potential::<R, K>(self.motion, duration, time, self.slopes);
        H::kick::<R, K>(self.motion, duration, time);
    }
    /// Does nothing, since there is no third part.
    #[inline(always)]
    fn middle(&mut self, _duration: f64, _time: f64, _backwards: bool) {}
    /// Does nothing: compositions with these kicks take another way back.
    #[inline(always)]
    fn gradient_kick(&mut self, _duration: f64, _gradient: f64, _time: f64)
    where
        H: QuadraticKinetic,
    {
    }
}
