//! Motions: the state that flows move, with prepared constants, in a layout.

use crate::{
    error::{NotFinite, Unsolved},
    scalar::real::Real,
    state::{
        coords::{Coords, all_finite},
        digest::Digest,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::{counts::Counts, dissipation::Momenta},
    threads,
};
use alloc::{sync::Arc, vec::Vec};
use core::{
    any::Any,
    mem::{needs_drop, take},
};

/// Prepared constants, one per lane.
pub trait Prepared<R: Real>: Clone + Send + Sync + 'static {
    /// The constants of one member.
    type Single: Clone + Send + Sync + 'static;

    /// Whether two members may share lanes: integers and the lengths of tables are the same in all lanes.
    fn alike(_a: &Self::Single, _b: &Self::Single) -> bool {
        true
    }
    /// The constants that are not finite, of a table the first one.
    fn not_finite(_single: &Self::Single) -> Vec<NotFinite> {
        Vec::new()
    }
    /// Sets the time at which conditions are read: the middle of the current step.
    fn begin_step(&mut self, _middle: f64) {}
    /// Adds the constants to a fingerprint.
    fn digest(_single: &Self::Single, _digest: &mut Digest) {}
    /// Gathers the constants of one member per lane.
    fn gather(members: &[&Self::Single]) -> Self;
}

/// The steps for which a motion is moved out of memory, so that its coordinates stay in registers. Otherwise a flow
/// that sometimes calls a function would load and store them every time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InRegisters {
    Never,
    /// The steps whose stages begin with a kick.
    Kicked,
    Always,
}

/// The seed of a motion's random numbers, and the members whose numbers its lanes draw, one for each lane.
#[derive(Clone, Debug)]
pub struct Noise {
    pub(crate) seed: u64,
    pub(crate) members: Vec<u32>,
    /// The energy that each lane has absorbed as heat since this began to be measured; nothing while it is not.
    pub(crate) heat: Option<Vec<f64>>,
}

/// Data that a motion has found beside its state, such as which bodies are near each other. No result depends on it.
pub(crate) type Found = Arc<dyn Any + Send + Sync>;

/// State and prepared constants in the layout that the generator chose.
pub trait Motion<C: Coords, P>: Clone + Send + Sync + 'static {
    /// Whether the time is part of the state.
    const TIMED: bool = false;
    /// Whether loading and storing mixes coordinates, so that each has roundings of the size of the largest one.
    const MIXES: bool = false;
    /// The steps for which the motion is moved out of memory.
    const IN_REGISTERS: InRegisters = InRegisters::Never;

    /// Moves it out for a while, after which it is put back.
    fn take(&mut self) -> Self {
        self.clone()
    }
    /// One member per lane, each with its constants and its state.
    fn load(constants: &[&P], states: &[&Phase<C>]) -> Self;
    /// The same motion at other states, with its constants as they are; `None` if it has to be loaded.
    fn reloaded(&self, _states: &[&Phase<C>]) -> Option<Self> {
        None
    }
    /// Loads states in the coordinates of the motion itself, where these are not the user's own.
    fn load_own(constants: &[&P], states: &[&Phase<C>]) -> Self {
        Self::load(constants, states)
    }
    /// One member per lane, each from a lane of another motion, and it continues as it would have there;
    /// `None` if a motion that is loaded from the states continues in the same way.
    fn gathered<'a>(_of_lane: &dyn Fn(usize) -> (&'a P, &'a Self, usize)) -> Option<Self>
    where
        P: 'a,
    {
        None
    }
    /// Takes over what states do not contain, for each lane from a lane of another motion.
    fn take_over<'a>(&mut self, _of_lane: &dyn Fn(usize) -> (usize, &'a Self))
    where
        Self: Sized + 'a,
    {
    }
    /// Writes the state of one lane: that which was loaded, to the last bit, until the first flow.
    fn store(&self, lane: usize, to: &mut Phase<C>);
    /// Writes the state of one lane in the coordinates of the motion itself, from which it resumes bitwise.
    fn store_own(&self, lane: usize, to: &mut Phase<C>) {
        self.store(lane, to);
    }
    /// Copies the coordinates of another motion with the same constants, in place.
    fn copy_state(&mut self, from: &Self);
    /// Copies the coordinates of another motion with the same constants, in place, on this number of threads or on all.
    fn copy_state_on(&mut self, from: &Self, _threads: Option<usize>) {
        self.copy_state(from);
    }
    /// Returns data that another motion with the same constants would need time to find.
    fn found(&self) -> Option<Found> {
        None
    }
    /// Continues with the data that another motion with the same constants has found.
    fn use_found(&mut self, _found: &Found) {}
    /// Sets the number of threads, or all that the machine has, where a layout distributes its work.
    fn share_among(&mut self, _threads: Option<usize>) {}
    /// Returns the fault of a lane whose steps could not be solved, after which it stands still and is not finite.
    fn unsolved(&self, _lane: usize) -> Option<&Unsolved> {
        None
    }
    /// The time since the motion was loaded, and its rounding error, where it is part of the state.
    fn elapsed(&self, _lane: usize) -> Option<[f64; 2]> {
        None
    }
    /// Returns the data of a single trajectory beside its state, where the time is part of it.
    #[cfg(feature = "checkpoint")]
    fn beside(&self) -> Option<Beside> {
        None
    }
    /// Continues with the data that a single trajectory had beside its state.
    #[cfg(feature = "checkpoint")]
    fn put_beside(&mut self, _beside: &Beside) {}
    /// Returns what the random numbers of the steps depend on, if they draw any.
    fn noise(&mut self) -> Option<&mut Noise> {
        None
    }
    /// Returns the counters of a single trajectory, if its steps count anything.
    fn counts(&self) -> Option<Counts> {
        None
    }
    /// Whether every coordinate of every lane is finite.
    fn finite(&self) -> bool;
    /// Whether every coordinate of every lane is finite, by this number of threads or by all.
    fn finite_on(&self, _threads: Option<usize>) -> bool {
        self.finite()
    }
}

/// The quantities of a trajectory beside positions and momenta, where the time is part of its state.
#[cfg(feature = "checkpoint")]
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Beside {
    /// The time since the motion was loaded, in the middle of a step, and its rounding error.
    pub(crate) time: [f64; 2],
    /// The momentum conjugate to the time, once steps were taken.
    pub(crate) conjugate: Option<f64>,
    /// The exponent of the transformation, where it has one.
    pub(crate) exponent: f64,
}

/// A number of each lane, from a lane of another motion.
pub(crate) fn from_lanes<'a, R: Real, M: 'a>(of_lane: &dyn Fn(usize) -> (usize, &'a M), read: &dyn Fn(&M) -> R) -> R {
    R::state(&|lane| {
        let (lane, from) = of_lane(lane);
        read(from).lane(lane)
    })
}

/// The coordinates that a flow reads.
pub struct Read<'m, S, P> {
    /// Positions.
    pub q: &'m S,
    /// Momenta.
    pub p: &'m S,
    /// Prepared constants.
    pub parameters: &'m P,
}

/// The coordinates that it moves.
pub struct Moved<'m, S> {
    /// Positions.
    pub q: &'m mut S,
    /// Momenta.
    pub p: &'m mut S,
}

/// The plain layout: the user's own shape.
#[derive(Clone)]
pub struct Plain<R: Real, C: Coords, P> {
    /// Positions.
    pub q: C::Slots<R>,
    /// Momenta.
    pub p: C::Slots<R>,
    /// Prepared constants.
    pub parameters: P,
}

/// Coordinates that are moved on the spot, in slices of one length.
pub struct InPlace<'m, T, P> {
    /// Positions.
    pub q: &'m mut [T],
    /// Momenta.
    pub p: &'m mut [T],
    /// Prepared constants.
    pub parameters: &'m P,
}

/// The coordinates of a motion as slices. The compiler knows that their lengths are the same.
#[inline(always)]
pub fn in_place<'m, T, P>(q: &'m mut [T], p: &'m mut [T], parameters: &'m P) -> InPlace<'m, T, P> {
    let count = q.len().min(p.len());
    InPlace { q: &mut q[..count], p: &mut p[..count], parameters }
}

impl<R: Real, C: Coords, P: Prepared<R>> Motion<C, P::Single> for Plain<R, C, P> {
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        Self {
            q: C::pack(states, |state| &state.q),
            p: C::pack(states, |state| &state.p),
            parameters: P::gather(constants),
        }
    }
    fn reloaded(&self, states: &[&Phase<C>]) -> Option<Self> {
        let (q, p) = (C::pack(states, |state| &state.q), C::pack(states, |state| &state.p));
        Some(Self { q, p, parameters: self.parameters.clone() })
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        to.q.unpack(&self.q, lane);
        to.p.unpack(&self.p, lane);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.q.clone_from(&from.q);
        self.p.clone_from(&from.p);
    }
    fn copy_state_on(&mut self, from: &Self, threads: Option<usize>) {
        if const { C::LENGTH.is_some() } {
            return self.copy_state(from);
        }
        threads::copy(C::slots(&from.q), C::slots_mut(&mut self.q), threads);
        threads::copy(C::slots(&from.p), C::slots_mut(&mut self.p), threads);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        C::finite(&self.q) && C::finite(&self.p)
    }
    fn finite_on(&self, threads: Option<usize>) -> bool {
        if const { C::LENGTH.is_some() } {
            return self.finite();
        }
        [&self.q, &self.p].into_iter().all(|half| threads::all(C::slots(half), threads, all_finite))
    }
}

impl<R: Real, C: Coords, P> Momenta<R, C::Leaf> for Plain<R, C, P> {
    type Wide = R;

    #[inline(always)]
    fn momenta(&mut self) -> &mut [<C::Leaf as Precision>::Slot<R>] {
        C::slots_mut(&mut self.p)
    }
}

impl<R: Real, C: Coords, P: Clone> Plain<R, C, P> {
    /// Returns a motion with these positions and without momenta, with slots that hold numbers and nothing else.
    #[inline(always)]
    pub fn at_rest(&self) -> Plain<R, C::With<f64>, P> {
        let zero = R::of(0.0);
        Plain {
            q: C::numbers(&self.q, |slot| slot.value()),
            p: C::numbers(&self.q, |_| zero),
            parameters: self.parameters.clone(),
        }
    }
    /// Returns a motion with these momenta at the origin, with slots that hold numbers and nothing else.
    #[inline(always)]
    pub fn at_origin(&self) -> Plain<R, C::With<f64>, P> {
        let zero = R::of(0.0);
        Plain {
            q: C::numbers(&self.q, |_| zero),
            p: C::numbers(&self.p, |slot| slot.value()),
            parameters: self.parameters.clone(),
        }
    }
    /// The scalar product of the positions and another motion's momenta.
    #[inline(always)]
    pub fn positions_times(&self, other: &Self) -> R {
        let mut sum = R::of(0.0);
        for (q, p) in C::slots(&self.q).iter().zip(C::slots(&other.p)) {
            sum = q.value().fma(p.value(), sum);
        }
        sum
    }
    /// Adds a multiple of another motion's momenta.
    #[inline(always)]
    pub fn push(&mut self, factor: R, other: &Plain<R, C::With<f64>, P>) {
        for (slot, number) in C::slots_mut(&mut self.p).iter_mut().zip(C::With::<f64>::slots(&other.p)) {
            slot.fma(factor, *number);
        }
    }
}

/// The plain layout of a system with solved flows: the user's own shape, and what the solvers of these flows keep.
#[derive(Clone)]
pub struct Solving<R: Real, C: Coords, P, S> {
    /// Positions.
    pub q: C::Slots<R>,
    /// Momenta.
    pub p: C::Slots<R>,
    /// Prepared constants.
    pub parameters: P,
    /// Matrices known so far, equations that could not be solved: what is no part of the state.
    pub solvers: S,
}

/// The largest motion in bytes that is moved out of memory for its steps: all registers of a processor with vectors of 512
/// bits, which hold no more of it.
const REGISTERS: usize = 2048;

/// The memory of a solved flow beside the state, for all lanes of a motion. By default it is empty, for a motion that
/// the flow is not applied to.
pub trait Solver<P>: Clone + Default + Send + Sync + 'static {
    /// The steps for which a small motion gains from registers.
    const IN_REGISTERS: InRegisters = InRegisters::Always;

    /// Creates the memory of members with these constants, one per lane; `length` counts the numbers or points of `q`.
    fn of(constants: &[&P], length: usize) -> Self;
    /// Returns the memory of a motion at rest, from which a force is found. Flows of positions alone need theirs there.
    fn at_rest(&self) -> Self {
        Self::default()
    }
    /// Takes over what belongs to the state of another motion with the same constants.
    fn copy_state(&mut self, _from: &Self) {}
    /// Returns the fault of a lane in which the flow could not be solved.
    fn unsolved(&self, _lane: usize) -> Option<&Unsolved> {
        None
    }
    /// Sets the number of threads, or all that the machine has, if the flow distributes its work.
    fn share_among(&mut self, _threads: Option<usize>) {}
}

/// The solver of two flows is the pair of their solvers.
impl<P, A: Solver<P>, B: Solver<P>> Solver<P> for (A, B) {
    const IN_REGISTERS: InRegisters = match (A::IN_REGISTERS, B::IN_REGISTERS) {
        (InRegisters::Never, _) | (_, InRegisters::Never) => InRegisters::Never,
        (InRegisters::Always, InRegisters::Always) => InRegisters::Always,
        _ => InRegisters::Kicked,
    };

    fn of(constants: &[&P], length: usize) -> Self {
        (A::of(constants, length), B::of(constants, length))
    }
    fn at_rest(&self) -> Self {
        (self.0.at_rest(), self.1.at_rest())
    }
    fn copy_state(&mut self, from: &Self) {
        self.0.copy_state(&from.0);
        self.1.copy_state(&from.1);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.0.unsolved(lane).or_else(|| self.1.unsolved(lane))
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.0.share_among(threads);
        self.1.share_among(threads);
    }
}

impl<R: Real, C: Coords, P: Prepared<R>, S: Solver<P::Single>> Motion<C, P::Single> for Solving<R, C, P, S> {
    const IN_REGISTERS: InRegisters =
        match size_of::<Self>() > REGISTERS || needs_drop::<C::Slots<R>>() || needs_drop::<P>() {
            true => InRegisters::Never,
            false => S::IN_REGISTERS,
        };

    #[inline(always)]
    fn take(&mut self) -> Self {
        Self {
            q: self.q.clone(),
            p: self.p.clone(),
            parameters: self.parameters.clone(),
            solvers: take(&mut self.solvers),
        }
    }
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        Self {
            q: C::pack(states, |state| &state.q),
            p: C::pack(states, |state| &state.p),
            parameters: P::gather(constants),
            solvers: S::of(constants, states.first().map_or(0, |state| state.q.length())),
        }
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        to.q.unpack(&self.q, lane);
        to.p.unpack(&self.p, lane);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.q.clone_from(&from.q);
        self.p.clone_from(&from.p);
        self.solvers.copy_state(&from.solvers);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.solvers.unsolved(lane)
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.solvers.share_among(threads);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        C::finite(&self.q) && C::finite(&self.p)
    }
}

impl<R: Real, C: Coords, P, S> Momenta<R, C::Leaf> for Solving<R, C, P, S> {
    type Wide = R;

    #[inline(always)]
    fn momenta(&mut self) -> &mut [<C::Leaf as Precision>::Slot<R>] {
        C::slots_mut(&mut self.p)
    }
}

impl<R: Real, C: Coords, P: Prepared<R>, S: Solver<P::Single>> Solving<R, C, P, S> {
    /// Returns a motion with these positions and without momenta, with slots that hold numbers and nothing else.
    #[inline(always)]
    pub fn at_rest(&self) -> Solving<R, C::With<f64>, P, S> {
        let zero = R::of(0.0);
        Solving {
            q: C::numbers(&self.q, |slot| slot.value()),
            p: C::numbers(&self.p, |_| zero),
            parameters: self.parameters.clone(),
            solvers: self.solvers.at_rest(),
        }
    }
    /// Adds a multiple of another motion's momenta.
    #[inline(always)]
    pub fn push(&mut self, factor: R, other: &Solving<R, C::With<f64>, P, S>) {
        for (slot, number) in C::slots_mut(&mut self.p).iter_mut().zip(C::With::<f64>::slots(&other.p)) {
            slot.fma(factor, *number);
        }
    }
}
