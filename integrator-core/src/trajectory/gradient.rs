//! The gradient of a function of a run, by one deviation vector that is carried back.
//!
//! The derivative M of a symplectic step satisfies Mᵀ = J M⁻¹ J⁻¹. The derivatives of a function with respect to the end
//! of a step therefore become those with respect to its beginning by a step of `-h`: turned by J⁻¹ they are a deviation
//! vector at the end, which the step multiplies by M⁻¹, and J turns the result back.

use crate::{
    error::{Error, VectorFault},
    hamiltonian::Hamiltonian,
    scalar::exact::power_of_two,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::Shaped,
    trajectory::{
        method::Differentiable,
        run::Run,
        samples::Sample,
        sensitive::slopes_of,
        tangent::{BETWEEN_SCALES, Beginning, Tangent, numbers, refused, scaled},
    },
};
use alloc::{vec, vec::Vec};

/// The largest [`Gradient::return_error`]: the derivatives have about this relative error.
const LARGEST_RETURN_ERROR: f64 = 1e-3;

/// The value of a function of a run and its derivatives, returned by [`Hamiltonian::gradient`].
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

/// A function of the states of a run: its value and its derivatives with respect to the state.
pub(crate) type Loss<'l, C> = dyn FnMut(&Sample<C>) -> (f64, Phase<<C as Coords>::With<f64>>) + 'l;

/// What the way back stands at after some steps: the state, and what replaces the state beside the vector.
type Stand<'s, C, T> = dyn FnMut(&Tangent<T>, u64) -> Result<(Phase<C>, Option<Phase<T>>), Error> + 's;

/// Computes the sum of a function over some states of a run, and its gradient.
///
/// # Errors
/// Those of [`Hamiltonian::gradient_of_samples`].
pub(crate) fn gradient<H, X, K>(
    system: &H,
    method: X,
    start: Phase<Shaped<H, K>>,
    h: f64,
    reads: Reads,
    loss: &mut Loss<'_, Shaped<H, K>>,
) -> Result<Gradient<H::Coords>, Error>
where
    H: Hamiltonian,
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
    let vector = turned(&derivatives);
    let (start, parameters) = if const { K::REVERSIBLE } {
        // The states of the run itself, at which each block of steps of the vector begins.
        let mut back = Run::start::<H, X, K>(system, method, end.clone(), -h)?.at_time(time);
        let mut stand = |_: &Tangent<_>, steps| {
            back.advance(steps)?;
            let state = back.state();
            let off_grid = state.to_f64();
            Ok((state, Some(off_grid)))
        };
        let tangent = tangent::<H, X, f64>(system, method, end.to_f64(), vector, -h)?.at_time(time);
        WayBack { tangent, in_blocks: true, parameters: no_slopes::<H>() }
            .through(&run, &mut way, reads, loss, &mut stand)
    } else {
        let vector = in_precision(&end, &vector);
        let tangent = tangent::<H, X, K>(system, method, end, vector, -h)?.at_time(time);
        let parameters = no_slopes::<H>();
        let mut stand = |tangent: &Tangent<_>, _| Ok((tangent.state(), None));
        let in_blocks = !parameters.is_empty();
        WayBack { tangent, in_blocks, parameters }.through(&run, &mut way, reads, loss, &mut stand)
    }?;
    way.gradient(value, start, parameters)
}

/// Why steps of a method by `-h` have no deviation vectors that are gradients of steps by `h`.
pub(crate) fn refusal<H: Hamiltonian, X: Differentiable<H>>(method: X) -> Option<&'static str> {
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

/// One derivative for each parameter, before the way back.
fn no_slopes<H: Hamiltonian>() -> Vec<f64> {
    vec![0.0; H::SENSITIVE.len()]
}

/// A run with one vector, and with the derivatives with respect to parameters if there are some.
fn tangent<H, X, K>(
    system: &H,
    method: X,
    start: Phase<Shaped<H, K>>,
    vector: Phase<Shaped<H, K>>,
    h: f64,
) -> Result<Tangent<Shaped<H, K>>, Error>
where
    H: Hamiltonian,
    X: Differentiable<H>,
    K: Precision,
{
    refused::<H, K>(&start)?;
    let (length, vectors, parameters) = (start.q.length(), vec![vector], H::SENSITIVE.len());
    let beginning = Beginning { start, vectors, parameters, h, at: None };
    // A constant, so that one of both is compiled.
    if const { H::SENSITIVE.is_empty() } {
        Tangent::begin::<H, X, K, false>(system, method, beginning, |_| Vec::new())
    } else {
        let slopes = |vectors| slopes_of(system, length, 1, vectors);
        Tangent::begin::<H, X, K, true>(system, method, beginning, slopes)
    }
}

/// Takes all steps; the sum of the values, and the derivatives of the last one.
fn forward<C: Coords>(
    run: &mut Run<C>,
    way: &mut Way<C>,
    reads: Reads,
    loss: &mut Loss<'_, C>,
) -> Result<(f64, Phase<C::With<f64>>), Error> {
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

/// The beginning of a run, the state that was seen last, and the sizes of positions and momenta on the way.
pub(crate) struct Way<C> {
    begin: Phase<C>,
    pub(crate) last: Phase<C>,
    sizes: [f64; 2],
}

impl<C: Coords> Way<C> {
    pub(crate) fn from(begin: Phase<C>) -> Self {
        Self { last: begin.clone(), sizes: sizes(&begin), begin }
    }

    pub(crate) fn see(&mut self, state: Phase<C>) {
        for (largest, size) in self.sizes.iter_mut().zip(sizes(&state)) {
            *largest = largest.max(size);
        }
        self.last = state;
    }

    /// The gradient of a function with a value and derivatives, if the way back ended at the last state.
    ///
    /// # Errors
    /// [`Error::NoGradient`], [`Error::WayBack`]
    pub(crate) fn gradient(
        &self,
        value: f64,
        start: Phase<C::With<f64>>,
        parameters: Vec<f64>,
    ) -> Result<Gradient<C::With<f64>>, Error> {
        if !numbers(&start).chain(parameters.iter().copied()).all(f64::is_finite) {
            return Err(Error::NoGradient { reason: "it exceeds the range of its precision\nhelp: take fewer steps" });
        }
        match self.return_error() {
            error if error > LARGEST_RETURN_ERROR => Err(Error::WayBack { error }),
            return_error => Ok(Gradient { value, start, parameters, return_error }),
        }
    }

    /// The distance between the beginning and the last state: [`Gradient::return_error`].
    fn return_error(&self) -> f64 {
        let differences = [(&self.begin.q, &self.last.q), (&self.begin.p, &self.last.p)].map(|(begin, last)| {
            let pairs = begin.flat().iter().zip(last.flat());
            pairs.fold(0.0_f64, |largest, (a, b)| largest.max((a.to_f64() - b.to_f64()).abs()))
        });
        let relative = |half: usize| if differences[half] == 0.0 { 0.0 } else { differences[half] / self.sizes[half] };
        relative(0).max(relative(1))
    }
}

/// The largest position and the largest momentum.
fn sizes<C: Coords>(state: &Phase<C>) -> [f64; 2] {
    [&state.q, &state.p].map(|half| half.flat().iter().fold(0.0, |largest: f64, leaf| largest.max(leaf.to_f64().abs())))
}

/// The value of the function and its derivatives for the state after this number of steps.
fn read<C: Coords>(
    run: &Run<C>,
    step: u64,
    state: Phase<C>,
    loss: &mut Loss<'_, C>,
) -> Result<(f64, Phase<C::With<f64>>), Error> {
    let sample = Sample::new(run, run.clock.at(step), step, state);
    let (value, derivatives) = loss(&sample);
    check(&sample.state, &derivatives, step)?;
    Ok((value, derivatives))
}

/// Checks that these are derivatives with respect to a state, after this number of steps.
///
/// # Errors
/// [`Error::Loss`]
pub(crate) fn check<C: Coords>(state: &Phase<C>, derivatives: &Phase<C::With<f64>>, step: u64) -> Result<(), Error> {
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

/// The way back with a vector, in the shape `T`.
struct WayBack<T: Coords> {
    tangent: Tangent<T>,
    /// Whether the state or the derivatives with respect to parameters begin anew after each block of steps.
    in_blocks: bool,
    /// The derivatives of the function with respect to parameters.
    parameters: Vec<f64>,
}

impl<T: Coords> WayBack<T> {
    /// Goes back from the end of a run to its beginning. Returns the derivatives with respect to that and to parameters.
    fn through<C: Coords<With<f64> = T::With<f64>>>(
        mut self,
        run: &Run<C>,
        way: &mut Way<C>,
        reads: Reads,
        loss: &mut Loss<'_, C>,
        stand: &mut Stand<'_, C, T>,
    ) -> Result<(Phase<T::With<f64>>, Vec<f64>), Error> {
        let mut step = reads.last();
        while step > 0 {
            let (read_at, is_read) = reads.before(step);
            let next = if self.in_blocks { read_at.max(step.saturating_sub(BETWEEN_SCALES)) } else { read_at };
            self.tangent.advance(step - next)?;
            let (state, replaced) = stand(&self.tangent, step - next)?;
            step = next;
            way.see(state);
            let added = match is_read && step == read_at {
                true => Some(turned(&read(run, step, way.last.clone(), loss)?.1)),
                false => None,
            };
            self.add_slopes();
            if self.in_blocks || added.is_some() {
                self.begin_block(replaced.as_ref(), added);
            }
        }
        let start = turned_back(scaled(&self.tangent.vector(0), power(&self.tangent)).to_f64());
        Ok((start, self.parameters))
    }

    /// Adds the derivatives with respect to parameters of the steps since the block began.
    ///
    /// If a step by `-h` leads to Φ(z, θ), the end of the step by `h` from Φ changes with θ by -M ∂Φ/∂θ, and the function by the
    /// scalar product of this with its derivatives there: that of -∂Φ/∂θ with those at Φ.
    fn add_slopes(&mut self) {
        if self.parameters.is_empty() {
            return;
        }
        let factor = power(&self.tangent);
        let vectors = self.tangent.vectors();
        let [vector, slopes @ ..] = &vectors[..] else { return };
        for (sum, slope) in self.parameters.iter_mut().zip(slopes) {
            *sum += factor * (product(&vector.q, &slope.p) - product(&vector.p, &slope.q));
        }
    }

    /// Begins a block from another state if there is one, with an addition to the vector, and with derivatives with respect to
    /// parameters that are zero.
    fn begin_block(&mut self, state: Option<&Phase<T>>, added: Option<Phase<T::With<f64>>>) {
        let factor = power(&self.tangent);
        self.tangent.reopen(state, &mut |vectors| {
            let [vector, slopes @ ..] = vectors else { return };
            if let Some(added) = &added {
                let added = added.q.flat().iter().chain(added.p.flat());
                let leaves = vector.q.flat_mut().iter_mut().chain(vector.p.flat_mut());
                for (leaf, added) in leaves.zip(added) {
                    let [value, carried] = leaf.parts();
                    *leaf = T::Leaf::from_parts([value + added / factor, carried]);
                }
            }
            for slope in slopes {
                *slope = scaled(slope, 0.0);
            }
        });
    }
}

/// The power of two that the vector has to be multiplied by.
fn power<T: Coords>(tangent: &Tangent<T>) -> f64 {
    // Beyond these the vector overflows, or is lost to underflow.
    let exponent = tangent.exponents().first().map_or(0, |exponent| (*exponent).clamp(-1022, 1023));
    power_of_two(exponent as i32)
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
pub(crate) fn in_precision<C: Coords>(like: &Phase<C>, vector: &Phase<C::With<f64>>) -> Phase<C> {
    let mut shaped = like.clone();
    let leaves = shaped.q.flat_mut().iter_mut().chain(shaped.p.flat_mut());
    for (leaf, number) in leaves.zip(numbers(vector)) {
        *leaf = C::Leaf::from_parts([number, 0.0]);
    }
    shaped
}

/// The scalar product of two halves of vectors.
fn product<C: Coords>(a: &C, b: &C) -> f64 {
    a.flat().iter().zip(b.flat()).map(|(a, b)| a.to_f64() * b.to_f64()).sum()
}
