//! A motion that is a polynomial for a while.

use super::{
    Recurrences, Taylor,
    horizon::reach,
    moment::Moment,
    part::{Part, To},
    series::COEFFICIENTS,
    table::Layout,
};
use crate::{
    coords::Coords,
    engine::{Clock, Moves},
    error::Unsolved,
    hamiltonian::{Hamiltonian, Motion, Prepared, Shaped},
    phase::Phase,
    real::{Kernel, Real},
    slot::Keep,
};
use alloc::sync::Arc;

/// What stays the same in a run.
pub struct Constants<P> {
    pub(super) parameters: Arc<P>,
    pub(super) method: Taylor,
}

/// A polynomial, how far it reaches, and where on it the run is.
#[derive(Clone)]
pub struct Expansion<R: Real, C: Coords, P, T> {
    method: Taylor,
    parameters: P,
    /// How many numbers or points there are.
    length: usize,
    q: Part<R, C::Leaf>,
    p: Part<R, C::Leaf>,
    tape: T,
    /// When the polynomial begins, from the start of the clock.
    begin: Moment,
    /// How far it reaches, with the sign of the step; nothing before it is found.
    reach: Option<f64>,
    unsolved: Option<Unsolved>,
}

impl<R, C, P, Q, T> Motion<C, Constants<Q>> for Expansion<R, C, P, T>
where
    R: Real,
    C: Coords,
    P: Prepared<R, Single = Q>,
    Q: Send + Sync + 'static,
    T: Clone + Default + Send + Sync + 'static,
{
    fn load<'a>(of_lane: impl Fn(usize) -> (&'a Constants<Q>, &'a Phase<C>)) -> Self {
        let (constants, start) = of_lane(0);
        let length = start.q.length();
        let layout = Layout::of::<C>(length);
        Self {
            method: constants.method,
            parameters: P::gather(|lane| &*of_lane(lane).0.parameters),
            length,
            q: Part::at(layout, |lane, coordinate| of_lane(lane).1.q.flat()[coordinate]),
            p: Part::at(layout, |lane, coordinate| of_lane(lane).1.p.flat()[coordinate]),
            tape: T::default(),
            begin: Moment::default(),
            reach: None,
            unsolved: None,
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        let layout = Layout::of::<C>(self.length);
        for (part, to) in [(&self.q, to.q.flat_mut()), (&self.p, to.p.flat_mut())] {
            for (coordinate, leaf) in to.iter_mut().enumerate() {
                *leaf = part.leaf(lane, layout.place(coordinate));
            }
        }
    }
    fn copy_state(&mut self, from: &Self) {
        // The tape is written before it is read.
        self.q.copy(&from.q);
        self.p.copy(&from.p);
        self.begin = from.begin;
        self.reach = from.reach;
        self.unsolved.clone_from(&from.unsolved);
    }
    fn unsolved(&self) -> Option<&Unsolved> {
        self.unsolved.as_ref()
    }
    fn finite(&self) -> bool {
        self.unsolved.is_none() && self.q.finite() && self.p.finite()
    }
}

/// The expansion of a system's motion.
type Of<H, R, K> = Expansion<R, Shaped<H, K>, <H as Hamiltonian>::Parameters<R>, <H as Recurrences>::Tape<R>>;

/// The moves of the Taylor method.
pub(super) fn moves<H: Recurrences, R: Real, K: Keep>() -> Moves<Of<H, R, K>> {
    let advance = |expansion: &mut Of<H, R, K>, clock: Clock, steps, _| {
        follow::<H, R, K>(expansion, clock, Moment::of(clock.steps + steps, clock.h));
    };
    Moves::closed(advance).with_dense(|expansion, begin, clock, duration| {
        let end = Moment::of(clock.steps, clock.h).after(duration);
        // What lies before the polynomial at hand belongs to one before it.
        if end.since(expansion.begin) * clock.h <= 0.0 {
            expansion.copy_state(begin);
        }
        follow::<H, R, K>(expansion, clock, end);
    })
}

/// Follows the motion to `end`: compiled once for steps and for what lies within them.
#[inline(never)]
fn follow<H: Recurrences, R: Real, K: Keep>(expansion: &mut Of<H, R, K>, clock: Clock, end: Moment) {
    R::enter(Follow::<H, R, K> { expansion, clock, end });
}

/// Follows the motion to a moment.
struct Follow<'e, H: Recurrences, R: Real, K: Keep> {
    expansion: &'e mut Of<H, R, K>,
    clock: Clock,
    end: Moment,
}

impl<H: Recurrences, R: Real, K: Keep> Kernel for Follow<'_, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { expansion, clock: Clock { t0, h, .. }, end } = self;
        let order = expansion.method.order;
        let layout = Layout::of::<H::Coords>(expansion.length);
        while expansion.unsolved.is_none() {
            let ahead = end.since(expansion.begin);
            let reach = match expansion.reach {
                Some(reach) => reach,
                None => {
                    expand::<H, R, K>(expansion, t0);
                    let reach = horizon(expansion).copysign(h);
                    expansion.reach = Some(reach);
                    reach
                }
            };
            if ahead.abs() <= reach.abs() || ahead == 0.0 {
                expansion.q.follow(layout, order, R::of(ahead), To::Shown);
                expansion.p.follow(layout, order, R::of(ahead), To::Shown);
                return;
            }
            let (begin, time) = (expansion.begin.after(reach), t0 + expansion.begin.nearest());
            if t0 + begin.nearest() == time || !reach.is_finite() {
                expansion.unsolved = Some(Unsolved::Singular { time, reach });
                return;
            }
            expansion.q.follow(layout, order, R::of(reach), To::Begin);
            expansion.p.follow(layout, order, R::of(reach), To::Begin);
            expansion.begin = begin;
            expansion.reach = None;
        }
    }
}

/// How far the polynomial reaches.
#[inline(always)]
fn horizon<R: Real, C: Coords, P, T>(expansion: &Expansion<R, C, P, T>) -> f64 {
    let Taylor { order, tolerance } = expansion.method;
    let layout = Layout::of::<C>(expansion.length);
    let q = reach(order, tolerance, |m| expansion.q.size(layout, m));
    let p = reach(order, tolerance, |m| expansion.p.size(layout, m));
    // What is no number is not passed over.
    if q <= p { q } else { p }
}

/// Calls back with the orders, one after the other, so that each is compiled on its own: sums of known length, without
/// loops. That is faster where a state is a few numbers, and takes the compiler minutes where turns lie side by side.
macro_rules! for_each_order {
    ($callback:ident) => {
        $callback! { 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 }
    };
}

/// Finds the polynomial from its beginning.
#[inline(always)]
fn expand<H: Recurrences, R: Real, K: Keep>(expansion: &mut Of<H, R, K>, t0: f64) {
    let time = t0 + expansion.begin.nearest();
    let Expansion { method, parameters, length, q, p, tape, .. } = expansion;
    let last = method.order;
    let layout = Layout::of::<H::Coords>(*length);
    let length = H::Coords::LENGTH.unwrap_or(*length);
    let (mut q, mut p) = (q.begun(layout), p.begun(layout));
    macro_rules! orders {
        ($($k:literal)*) => {$(
            if $k < last {
                H::order(parameters, length, &mut q, &mut p, tape, $k, time);
            }
        )*};
    }
    if H::ROLLED {
        // The bound is known to hold; said here, it spares each sum the question.
        for k in 0..last.min(COEFFICIENTS - 1) {
            H::order(parameters, length, &mut q, &mut p, tape, k, time);
        }
    } else {
        for_each_order!(orders);
    }
}
