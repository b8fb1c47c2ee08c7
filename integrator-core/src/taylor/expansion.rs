//! A motion that is a polynomial for a while.

use super::{
    Recurrences, Taylor,
    horizon::reach,
    moment::Moment,
    series::{COEFFICIENTS, Series},
};
use crate::{
    coords::Coords,
    engine::{Clock, Moves},
    error::Unsolved,
    hamiltonian::{Hamiltonian, Motion, Prepared, Shaped},
    phase::Phase,
    real::{Kernel, Real},
    slot::{Keep, Slot},
};
use alloc::{sync::Arc, vec::Vec};

/// What stays the same in a run.
pub struct Constants<P> {
    pub(super) parameters: Arc<P>,
    pub(super) method: Taylor,
}

/// The coordinates of one part, flat.
#[derive(Clone)]
struct Part<R, S> {
    /// Where the polynomial begins, with what that carries.
    begin: Vec<S>,
    /// The polynomial.
    series: Vec<Series<R>>,
    /// Where the run is.
    shown: Vec<S>,
}

impl<R: Real, S: Slot<R>> Part<R, S> {
    fn at(begin: Vec<S>) -> Self {
        let series = begin.iter().map(|_| [R::of(0.0); COEFFICIENTS]).collect();
        Self { shown: begin.clone(), begin, series }
    }

    /// The largest coefficient of an order among so many coordinates.
    #[inline(always)]
    fn size(&self, count: usize, order: usize) -> f64 {
        let mut most = 0.0;
        for series in &self.series[..count] {
            let size = series[order].lane(0).abs();
            // What is no number must not get lost among those that are.
            most = if size <= most { most } else { size };
        }
        most
    }

    /// The states after a while, from those at the beginning.
    #[inline(always)]
    fn after(&mut self, count: usize, order: usize, duration: f64, to: impl Fn(&mut Self) -> &mut Vec<S>) {
        let duration = R::of(duration);
        for i in 0..count {
            let series = &self.series[i];
            let mut sum = series[order];
            for k in (1..order).rev() {
                sum = sum.fma(duration, series[k]);
            }
            let mut slot = self.begin[i];
            slot.fma(duration, sum);
            to(self)[i] = slot;
        }
    }

    fn copy(&mut self, from: &Self) {
        self.begin.clone_from(&from.begin);
        self.series.clone_from(&from.series);
        self.shown.clone_from(&from.shown);
    }
}

/// A polynomial, how far it reaches, and where on it the run is.
#[derive(Clone)]
pub struct Expansion<R: Real, C: Coords, P, T> {
    method: Taylor,
    parameters: P,
    length: usize,
    q: Part<R, <C::Leaf as Keep>::Slot<R>>,
    p: Part<R, <C::Leaf as Keep>::Slot<R>>,
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
        Self {
            method: constants.method,
            parameters: P::gather(|lane| &*of_lane(lane).0.parameters),
            length: start.q.length(),
            q: Part::at(C::listed(|lane| &of_lane(lane).1.q)),
            p: Part::at(C::listed(|lane| &of_lane(lane).1.p)),
            tape: T::default(),
            begin: Moment::default(),
            reach: None,
            unsolved: None,
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        to.q.unlisted(&self.q.shown, lane);
        to.p.unlisted(&self.p.shown, lane);
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
        self.unsolved.is_none() && self.q.shown.iter().chain(&self.p.shown).all(|slot| slot.value().finite())
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
        let count = count::<H::Coords>(expansion.q.begin.len());
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
                expansion.q.after(count, order, ahead, |part| &mut part.shown);
                expansion.p.after(count, order, ahead, |part| &mut part.shown);
                return;
            }
            let (begin, time) = (expansion.begin.after(reach), t0 + expansion.begin.nearest());
            if t0 + begin.nearest() == time || !reach.is_finite() {
                expansion.unsolved = Some(Unsolved::Singular { time, reach });
                return;
            }
            expansion.q.after(count, order, reach, |part| &mut part.begin);
            expansion.p.after(count, order, reach, |part| &mut part.begin);
            expansion.begin = begin;
            expansion.reach = None;
        }
    }
}

/// How many coordinates there are: a number that code knows where the type tells it.
#[inline(always)]
fn count<C: Coords>(known: usize) -> usize {
    C::LENGTH.map_or(known, |length| length * C::COMPONENTS)
}

/// How far the polynomial reaches.
#[inline(always)]
fn horizon<R: Real, C: Coords, P, T>(expansion: &Expansion<R, C, P, T>) -> f64 {
    let Taylor { order, tolerance } = expansion.method;
    let count = count::<C>(expansion.q.begin.len());
    let q = reach(order, tolerance, |m| expansion.q.size(count, m));
    let p = reach(order, tolerance, |m| expansion.p.size(count, m));
    // What is no number is not passed over.
    if q <= p { q } else { p }
}

/// Calls back with the orders, one after the other, so that each is compiled on its own: sums of known length, without
/// loops.
macro_rules! for_each_order {
    ($callback:ident) => {
        $callback! { 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 }
    };
}

/// Finds the polynomial from its beginning.
#[inline(always)]
fn expand<H: Recurrences, R: Real, K: Keep>(expansion: &mut Of<H, R, K>, t0: f64) {
    let time = t0 + expansion.begin.nearest();
    let Expansion { method, parameters, length, q: of_q, p: of_p, tape, .. } = expansion;
    let last = method.order;
    let count = count::<H::Coords>(of_q.begin.len());
    let (q, p) = (&mut of_q.series[..count], &mut of_p.series[..count]);
    for i in 0..count {
        q[i][0] = of_q.begin[i].value();
        p[i][0] = of_p.begin[i].value();
    }
    macro_rules! orders {
        ($($k:literal)*) => {$(
            if $k < last {
                // Minus zero is what nothing has been added to.
                for i in 0..count {
                    (q[i][$k + 1], p[i][$k + 1]) = (R::of(-0.0), R::of(-0.0));
                }
                H::order(parameters, *length, q, p, tape, $k, time);
                let number = R::of(f64::from($k + 1));
                for i in 0..count {
                    q[i][$k + 1] = q[i][$k + 1] / number;
                    p[i][$k + 1] = p[i][$k + 1] / number;
                }
            }
        )*};
    }
    for_each_order!(orders);
}
