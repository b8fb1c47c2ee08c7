//! The gradient of a function of a run, by one deviation vector that is carried back.
//!
//! The derivative M of a symplectic step satisfies Mᵀ = J M⁻¹ J⁻¹. The derivatives of a function with respect to the end
//! of a step therefore become those with respect to its beginning by a step of `-h`: turned by J⁻¹ they are a deviation
//! vector at the end, which the step multiplies by M⁻¹, and J turns the result back.

mod by_slopes;
mod by_tangent;
mod way;

use crate::{
    error::{Error, VectorFault},
    scalar::exact::power_of_two,
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::{Shaped, parameter_derivatives::ParameterDerivatives},
    trajectory::{
        by_table::slopes::has_slopes,
        method::Differentiable,
        run::Run,
        samples::Sample,
        tangent::{BETWEEN_SCALES, numbers, refused, scaled},
    },
};
use alloc::{boxed::Box, vec, vec::Vec};
use by_slopes::BySlopes;
use by_tangent::ByTangent;
pub(crate) use way::Way;

/// The value of a function of a run and its derivatives, returned by [`Hamiltonian::gradient`](crate::Hamiltonian::gradient).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Gradient<C: Coords> {
    /// The value of the function.
    pub value: f64,
    /// The derivatives with respect to the initial positions (`q`) and momenta (`p`).
    pub start: Phase<C>,
    /// The derivatives with respect to the parameters in `sensitive(...)`, in the order of the annotation; empty without
    /// them.
    pub parameters: Vec<f64>,
    /// The distance between the initial state and the state at which the way back ended.
    ///
    /// It is the largest difference of a position relative to the largest position on the run, or that of a momentum. The
    /// derivatives have about this relative error. It is the rounding error of both ways, multiplied by the growth of deviations
    /// on a chaotic orbit; 0 for [reversible](Phase::reversible) starts.
    pub return_error: f64,
}

/// The steps after which a function reads the state: the last one alone, or the first and each multiple of a number.
#[derive(Clone, Copy)]
pub(crate) enum Reads {
    End(u64),
    Every { interval: u64, steps: u64 },
}

impl Reads {
    /// The number of steps up to the last read.
    fn last(self) -> u64 {
        match self {
            Self::End(steps) => steps,
            Self::Every { interval, steps } => steps - steps % interval,
        }
    }

    /// The number of steps up to the read before this one, or to the start; and whether there is a read.
    fn before(self, step: u64) -> (u64, bool) {
        match self {
            Self::End(_) => (0, false),
            Self::Every { interval, .. } => (step.saturating_sub(interval), true),
        }
    }
}

/// Derivatives with respect to a state.
pub(crate) type Derivatives<C> = Phase<<C as Coords>::With<f64>>;

/// A function of the states of a run: its value and its derivatives with respect to the state.
pub(crate) type Loss<'l, C> = dyn FnMut(&Sample<C>) -> (f64, Derivatives<C>) + 'l;

/// From the state beside the vector after some steps back: the state of the run, and what replaces that beside the vector.
type Stand<'s, C, T> = dyn FnMut(&Phase<T>, u64) -> Result<(Phase<C>, Option<Phase<T>>), Error> + 's;

/// Computes the sum of a function over some states of a run, and its gradient.
///
/// # Errors
/// Those of [`Hamiltonian::gradient_of_samples`](crate::Hamiltonian::gradient_of_samples).
pub(crate) fn gradient<H, X, K>(
    system: &H,
    method: X,
    start: Phase<Shaped<H, K>>,
    h: f64,
    reads: Reads,
    loss: &mut Loss<'_, Shaped<H, K>>,
) -> Result<Gradient<H::Coords>, Error>
where
    H: ParameterDerivatives,
    X: Differentiable<H>,
    K: Precision,
{
    if let Some(reason) = refusal::<H, X>(method) {
        return Err(Error::NoGradient { reason });
    }
    let mut way = Way::from(start.clone());
    let mut run = Run::start::<H, X, K>(system, method, start, h)?;
    let (value, derivatives) = forward(&mut run, &mut way, reads, loss)?;
    let (end, time) = (run.state(), run.time());
    let (vector, clock) = (turned(&derivatives), Clock { t0: time, h: -h, steps: 0 });
    let (start, parameters) = if const { K::REVERSIBLE } {
        // The states of the run itself, at which each block of steps of the vector begins.
        let mut back = Run::start::<H, X, K>(system, method, end.clone(), -h)?.at_time(time);
        let mut stand = |_: &Phase<_>, steps| {
            back.advance(steps)?;
            let state = back.state();
            let off_grid = state.to_f64();
            Ok((state, Some(off_grid)))
        };
        let mut carrier = carrier::<H, X, f64>(system, method, end.to_f64(), vector, clock)?;
        back_through(&mut *carrier, true, &run, &mut way, (reads, loss), &mut stand)
    } else {
        let vector = in_precision(&end, &vector);
        let mut carrier = carrier::<H, X, K>(system, method, end, vector, clock)?;
        let in_blocks = carrier.has_blocks();
        let mut stand = |state: &Phase<_>, _| Ok((state.clone(), None));
        back_through(&mut *carrier, in_blocks, &run, &mut way, (reads, loss), &mut stand)
    }?;
    way.gradient(value, start, parameters)
}

/// Why steps of a method by `-h` have no deviation vectors that are gradients of steps by `h`.
pub(crate) fn refusal<H: ParameterDerivatives, X: Differentiable<H>>(method: X) -> Option<&'static str> {
    let facts = method.claims();
    if const { H::COPIES } {
        Some("`split = symmetric` evolves two copies of the state\nhelp: use `split = none` with `GaussLegendre4`")
    } else if !X::FROM_STATES {
        Some(
            "steps of this method depend on more than positions and momenta\nhelp: use a composition or an implicit \
             method with equal steps, such as `KahanLi8` or `GaussLegendre4`",
        )
    } else if !facts.symmetric || !facts.symplectic {
        Some(
            "steps by -h do not undo steps of this method\nhelp: use a symmetric composition, such as `Verlet` or \
             `KahanLi8`",
        )
    } else {
        None
    }
}

/// What carries a deviation vector back, with the derivatives with respect to parameters.
trait Carrier<C: Coords> {
    /// Takes this number of steps back.
    ///
    /// # Errors
    /// Those of a run.
    fn back(&mut self, steps: u64) -> Result<(), Error>;
    /// The number of parameters.
    fn parameters(&self) -> usize;
    /// Whether derivatives with respect to parameters begin at zero in each block of steps.
    fn has_blocks(&self) -> bool;
    /// The state.
    fn state(&self) -> Phase<C>;
    /// The vector, and the power of two that it has to be multiplied by.
    fn vector(&self) -> (Phase<C>, f64);
    /// Adds the derivatives with respect to parameters since the block began.
    fn add_slopes(&mut self, slopes: &mut [f64]);
    /// Begins a block from another state if there is one, and from another vector that is to be multiplied by the same power.
    fn begin_block(&mut self, state: Option<&Phase<C>>, vector: Phase<C>);
}

/// The carrier from the end of a run.
fn carrier<H, X, K>(
    system: &H,
    method: X,
    end: Phase<Shaped<H, K>>,
    vector: Phase<Shaped<H, K>>,
    clock: Clock,
) -> Result<Box<dyn Carrier<Shaped<H, K>>>, Error>
where
    H: ParameterDerivatives,
    X: Differentiable<H>,
    K: Precision,
{
    refused::<H, K>(&end)?;
    // A constant, so that one of both is compiled.
    if const { X::IS_PLAIN_TABLE && has_slopes::<H, K>() } {
        let reason = "the method has no table of stages\nhelp: use a composition, such as `KahanLi8`";
        let table = method.facts().table.ok_or(Error::NoGradient { reason })?;
        Ok(Box::new(BySlopes::new::<H, K>(system, table, end, vector, clock)))
    } else {
        Ok(Box::new(ByTangent::new::<H, X, K>(system, method, end, vector, clock)?))
    }
}

/// Takes all steps; the sum of the values, and the derivatives of the last one.
fn forward<C: Coords>(
    run: &mut Run<C>,
    way: &mut Way<C>,
    reads: Reads,
    loss: &mut Loss<'_, C>,
) -> Result<(f64, Derivatives<C>), Error> {
    let (first, interval) = match reads {
        Reads::End(steps) => (steps, 0),
        Reads::Every { interval: 0, .. } => return Err(Error::SampleInterval),
        Reads::Every { interval, .. } => (0, interval),
    };
    // Half the way is seen, since the end may be where all momenta are zero.
    run.advance(first / 2)?;
    way.see(run.state());
    run.advance(first - first / 2)?;
    let mut sum = 0.0;
    loop {
        way.see(run.state());
        let (value, derivatives) = read(run, run.steps(), run.state(), loss)?;
        sum += value;
        if run.steps() == reads.last() {
            return Ok((sum, derivatives));
        }
        run.advance(interval)?;
    }
}

/// The value of the function and its derivatives for the state after this number of steps.
fn read<C: Coords>(
    run: &Run<C>,
    step: u64,
    state: Phase<C>,
    loss: &mut Loss<'_, C>,
) -> Result<(f64, Derivatives<C>), Error> {
    let sample = Sample::new(run, run.clock.at(step), step, state);
    let (value, derivatives) = loss(&sample);
    check(&sample.state, &derivatives, step)?;
    Ok((value, derivatives))
}

/// Checks that these are derivatives with respect to a state, after this number of steps.
///
/// # Errors
/// [`Error::Loss`]
pub(crate) fn check<C: Coords>(state: &Phase<C>, derivatives: &Derivatives<C>, step: u64) -> Result<(), Error> {
    let positions = state.q.flat().len();
    let lengths = [derivatives.q.flat().len(), derivatives.p.flat().len()];
    let fault = if lengths != [positions; 2] {
        VectorFault::Length { lengths, positions }
    } else if !numbers(derivatives).all(f64::is_finite) {
        VectorFault::NotFinite
    } else {
        return Ok(());
    };
    Err(Error::Loss { step, fault })
}

/// Goes back from the end of a run to its beginning. Returns the derivatives with respect to that and to parameters.
fn back_through<C: Coords, T: Coords<With<f64> = C::With<f64>>>(
    carrier: &mut dyn Carrier<T>,
    in_blocks: bool,
    run: &Run<C>,
    way: &mut Way<C>,
    (reads, loss): (Reads, &mut Loss<'_, C>),
    stand: &mut Stand<'_, C, T>,
) -> Result<(Derivatives<C>, Vec<f64>), Error> {
    let (mut step, mut slopes) = (reads.last(), vec![0.0; carrier.parameters()]);
    while step > 0 {
        let (read_at, is_read) = reads.before(step);
        let next = if in_blocks { read_at.max(step.saturating_sub(BETWEEN_SCALES)) } else { read_at };
        carrier.back(step - next)?;
        let (state, replaced) = stand(&carrier.state(), step - next)?;
        step = next;
        way.see(state);
        let added = match is_read && step == read_at {
            true => Some(turned(&read(run, step, way.last.clone(), loss)?.1)),
            false => None,
        };
        // Samples without measurements change nothing.
        let added = added.filter(|added| numbers(added).any(|number| number != 0.0));
        carrier.add_slopes(&mut slopes);
        if in_blocks || added.is_some() {
            let (mut vector, power) = carrier.vector();
            if let Some(added) = &added {
                let leaves = vector.q.flat_mut().iter_mut().chain(vector.p.flat_mut());
                for (leaf, number) in leaves.zip(numbers(added)) {
                    let [value, carried] = leaf.parts();
                    *leaf = T::Leaf::from_parts([value + number / power, carried]);
                }
            }
            carrier.begin_block(replaced.as_ref(), vector);
        }
    }
    let (vector, power) = carrier.vector();
    Ok((turned_back(scaled(&vector, power).to_f64()), slopes))
}

/// The power of two that a vector has to be multiplied by which was divided by it.
fn power(exponent: i64) -> f64 {
    // Beyond these the vector overflows, or is lost to underflow.
    power_of_two(exponent.clamp(-1022, 1023) as i32)
}

/// Derivatives with respect to a state, turned to a deviation vector: J⁻¹ (λq, λp) = (-λp, λq).
pub(crate) fn turned<C: Coords<Leaf = f64>>(derivatives: &Phase<C>) -> Phase<C> {
    let mut vector = Phase { q: derivatives.p.clone(), p: derivatives.q.clone() };
    for number in vector.q.flat_mut() {
        *number = -*number;
    }
    vector
}

/// A deviation vector, turned back to derivatives: J (δq, δp) = (δp, -δq).
pub(crate) fn turned_back<C: Coords<Leaf = f64>>(vector: Phase<C>) -> Phase<C> {
    let mut derivatives = Phase { q: vector.p, p: vector.q };
    for number in derivatives.p.flat_mut() {
        *number = -*number;
    }
    derivatives
}

/// A vector in the precision and shape of a state.
pub(crate) fn in_precision<C: Coords>(like: &Phase<C>, vector: &Derivatives<C>) -> Phase<C> {
    let mut shaped = like.clone();
    let leaves = shaped.q.flat_mut().iter_mut().chain(shaped.p.flat_mut());
    for (leaf, number) in leaves.zip(numbers(vector)) {
        *leaf = C::Leaf::from_parts([number, 0.0]);
    }
    shaped
}
