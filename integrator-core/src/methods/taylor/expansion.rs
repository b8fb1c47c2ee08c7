//! A motion that is a polynomial for a while.
//!
//! Always true: a lane's polynomials are found from what is in the lane alone, and begin where this asks for it. Where
//! one lane needs a polynomial all of them are computed, those of the others to the bits that they had.

use super::{
    Recurrences, Taylor,
    horizon::reach,
    leg::{Leg, Way},
    moment::Moment,
    part::Part,
    series::HIGHEST,
    states::To,
    table::{Layout, Rows, are_always_few},
};
use crate::{
    error::Unsolved,
    hamiltonian::{Hamiltonian, Shaped},
    scalar::{
        real::{Kernel, Real},
        simd::block::WIDEST,
    },
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::motion::{Motion, Prepared},
    trajectory::step_functions::StepFunctions,
};
use alloc::{sync::Arc, vec::Vec};

/// What stays the same in a run.
pub struct Constants<P> {
    pub(super) parameters: Arc<P>,
    pub(super) method: Taylor,
    pub(super) interleaved: bool,
}

/// The polynomials of the members, and where on them these are.
pub struct Expansion<R: Real, C: Coords, P, T> {
    method: Taylor,
    parameters: P,
    layout: Layout,
    q: Part<R, C>,
    p: Part<R, C>,
    tape: T,
    /// Those of the members, of which there may be fewer.
    legs: [Leg; WIDEST],
}

impl<R: Real, C: Coords, P: Clone, T: Default> Clone for Expansion<R, C, P, T> {
    /// A tape is written before it is read, and most copies are looked at once: theirs are empty.
    fn clone(&self) -> Self {
        let Self { method, layout, .. } = *self;
        Self {
            method,
            parameters: self.parameters.clone(),
            layout,
            q: self.q.clone(),
            p: self.p.clone(),
            tape: T::default(),
            legs: self.legs.clone(),
        }
    }
}

impl<R, C, P, Q, T> Motion<C, Constants<Q>> for Expansion<R, C, P, T>
where
    R: Real,
    C: Coords,
    P: Prepared<R, Single = Q>,
    Q: Send + Sync + 'static,
    T: Default + Send + Sync + 'static,
{
    fn load(constants: &[&Constants<Q>], states: &[&Phase<C>]) -> Self {
        let layout = Layout::of::<C>(states[0].q.length(), constants[0].interleaved);
        let mut parameters = Vec::with_capacity(constants.len());
        for constants in constants {
            parameters.push(&*constants.parameters);
        }
        Self {
            method: constants[0].method,
            parameters: P::gather(&parameters),
            layout,
            q: Part::at(layout, &|lane, coordinate| states[lane].q.flat()[coordinate]),
            p: Part::at(layout, &|lane, coordinate| states[lane].p.flat()[coordinate]),
            tape: T::default(),
            legs: Default::default(),
        }
    }
    fn gathered<'a>(of_lane: &dyn Fn(usize) -> (&'a Constants<Q>, &'a Self, usize)) -> Option<Self>
    where
        Constants<Q>: 'a,
    {
        let (constants, from @ &Self { layout, .. }, _) = of_lane(0);
        if const { R::LANES == 1 } {
            return Some(from.clone());
        }
        let part = |lane, part: fn(&Self) -> &Part<R, C>| {
            let (_, motion, lane) = of_lane(lane);
            (part(motion), lane)
        };
        let mut parameters = Vec::with_capacity(R::LANES);
        for lane in 0..R::LANES {
            parameters.push(&*of_lane(lane).0.parameters);
        }
        let mut legs: [Leg; WIDEST] = Default::default();
        for (lane, leg) in legs.iter_mut().enumerate().take(R::LANES) {
            let (_, motion, lane) = of_lane(lane);
            // From the same beginning, the same polynomial is found again.
            *leg = Leg { reach: None, ..motion.legs[lane].clone() };
        }
        Some(Self {
            method: constants.method,
            parameters: P::gather(&parameters),
            layout,
            q: Part::gathered(layout, |lane| part(lane, |motion| &motion.q)),
            p: Part::gathered(layout, |lane| part(lane, |motion| &motion.p)),
            tape: T::default(),
            legs,
        })
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        for (part, to) in [(&self.q, to.q.flat_mut()), (&self.p, to.p.flat_mut())] {
            for (coordinate, leaf) in to.iter_mut().enumerate() {
                *leaf = part.leaf(lane, self.layout.place_of(coordinate));
            }
        }
    }
    fn copy_state(&mut self, from: &Self) {
        // The tape is written before it is read.
        self.q.copy(&from.q);
        self.p.copy(&from.p);
        self.legs[..R::MEMBERS].clone_from_slice(&from.legs[..R::MEMBERS]);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.legs[lane].unsolved.as_ref()
    }
    fn finite(&self) -> bool {
        self.legs[..R::MEMBERS].iter().all(|leg| leg.unsolved.is_none()) && self.q.finite() && self.p.finite()
    }
}

/// The expansion of a system's motion.
pub(super) type Of<H, R, K> =
    Expansion<R, Shaped<H, K>, <H as Hamiltonian>::Parameters<R>, <H as Recurrences>::Tape<R>>;

/// The step functions of the Taylor method.
pub(super) fn step_functions<H: Recurrences, R: Real, K: Precision>() -> StepFunctions<Of<H, R, K>> {
    StepFunctions::of_whole_steps(R::LANES, advance::<H, R, K>, Some(within::<H, R, K>))
}

fn advance<H: Recurrences, R: Real, K: Precision>(
    expansions: &mut [Of<H, R, K>],
    clock: Clock,
    steps: u64,
    _threads: Option<usize>,
) {
    for expansion in expansions {
        advance_by::<H, R, K>(expansion, clock, steps);
    }
}

/// Dense output: follows the motion a while into the step that begins with `begin` at the clock.
fn within<H: Recurrences, R: Real, K: Precision>(
    expansion: &mut Of<H, R, K>,
    begin: &Of<H, R, K>,
    clock: Clock,
    duration: f64,
) {
    let end = Moment::of(clock.steps, clock.h).after(duration);
    // What lies before the polynomial at hand belongs to one before it.
    if end.since(expansion.legs[0].begin) * clock.h <= 0.0 {
        expansion.copy_state(begin);
    }
    expansion.begin_step::<H>(clock);
    follow::<H, R, K>(expansion, clock, end);
}

/// Follows the motion over so many steps. No polynomial leads from one piece in time to another: each step begins with
/// new ones where there are pieces.
fn advance_by<H: Recurrences, R: Real, K: Precision>(expansion: &mut Of<H, R, K>, clock: Clock, steps: u64) {
    if const { !H::PIECEWISE_IN_TIME } {
        return follow::<H, R, K>(expansion, clock, Moment::of(clock.steps + steps, clock.h));
    }
    for step in clock.steps..clock.steps + steps {
        let clock = Clock { steps: step, ..clock };
        expansion.begin_step::<H>(clock);
        follow::<H, R, K>(expansion, clock, Moment::of(step + 1, clock.h));
    }
}

/// Follows the motion to `end`: compiled once for steps and for what lies within them.
#[inline(never)]
fn follow<H: Recurrences, R: Real, K: Precision>(expansion: &mut Of<H, R, K>, clock: Clock, end: Moment) {
    R::enter(Follow::<H, R, K> { expansion, clock, end });
}

impl<R: Real, C: Coords, P: Prepared<R>, T> Expansion<R, C, P, T> {
    /// Conditions on the time are read in the middle of the step that begins at the clock.
    fn begin_step<H: Hamiltonian>(&mut self, clock: Clock) {
        if const { H::PIECEWISE_IN_TIME } {
            self.parameters.begin_step(clock.at(clock.steps) + clock.h / 2.0);
        }
    }

    /// Follows the polynomials of both parts for a while, by one text.
    #[inline(always)]
    fn follow(&mut self, layout: Layout, t: R, to: To<R>) {
        let order = self.method.order();
        for part in [&mut self.q, &mut self.p] {
            part.follow(layout, order, t, to);
        }
    }

    /// Ends the polynomials of these lanes a while after their beginnings: the next ones begin there.
    #[inline(always)]
    fn end(&mut self, layout: Layout, t: R, lanes: &[f64; WIDEST], end: Moment) {
        self.follow(layout, t, To::Begin { moves: R::parameter(&|lane| lanes[lane]) });
        for (leg, _) in self.legs.iter_mut().zip(lanes).filter(|(_, ends)| **ends > 0.0) {
            *leg = Leg { begin: end, ..Leg::default() };
        }
    }
}

/// Follows the motion to a moment: whoever arrives waits for the others.
struct Follow<'e, H: Recurrences, R: Real, K: Precision> {
    expansion: &'e mut Of<H, R, K>,
    clock: Clock,
    end: Moment,
}

impl<H: Recurrences, R: Real, K: Precision> Kernel for Follow<'_, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { expansion, clock: Clock { t0, h, .. }, end } = self;
        let layout = layout::<H>(expansion.layout);
        loop {
            // Beside what legs keep: what has just been stored would be waited for.
            let mut reaches = [0.0; WIDEST];
            if expansion.legs[..R::MEMBERS].iter().any(Leg::is_unknown) {
                expand::<H, R, K>(expansion, layout, t0);
                horizons(expansion, layout, h, &mut reaches);
            } else {
                for (reach, leg) in reaches.iter_mut().zip(&expansion.legs[..R::MEMBERS]) {
                    *reach = leg.reach.unwrap_or(0.0);
                }
            }
            // How far each member goes on its polynomial, and whether to where the next one begins.
            let (mut t, mut moves) = ([0.0; WIDEST], [0.0; WIDEST]);
            let (mut over, mut within, mut arrives) = (false, false, [0.0; WIDEST]);
            for lane in 0..R::MEMBERS {
                match expansion.legs[lane].proceed(reaches[lane], end, t0) {
                    Way::Within(ahead) => (t[lane], arrives[lane], within) = (ahead, 1.0, true),
                    Way::Over(reach) => (t[lane], moves[lane], over) = (reach, 1.0, true),
                    Way::Ended => {}
                }
            }
            let to = if over {
                To::Begin { moves: R::parameter(&|lane| moves[lane]) }
            } else if within {
                To::Shown
            } else {
                return;
            };
            let t = R::parameter(&|lane| t[lane]);
            expansion.follow(layout, t, to);
            if let To::Shown = to {
                if const { H::PIECEWISE_IN_TIME } {
                    expansion.end(layout, t, &arrives, end);
                }
                return;
            }
        }
    }
}

/// Finds how far the new polynomials reach, and tells it of all of them.
#[inline(always)]
fn horizons<R: Real, C: Coords, P, T>(
    expansion: &mut Expansion<R, C, P, T>,
    layout: Layout,
    h: f64,
    reaches: &mut [f64; WIDEST],
) {
    let Expansion { method: Taylor { order, tolerance }, q, p, legs, .. } = expansion;
    let (order, tolerance) = (*order, *tolerance);
    let ends = [q.ends(layout, order), p.ends(layout, order)];
    let parts = [&*q, &*p];
    for lane in 0..R::MEMBERS {
        let leg = &mut legs[lane];
        let found = match leg.reach {
            Some(reach) => reach,
            None => {
                let ends = [ends[0].lane(lane), ends[1].lane(lane)];
                reach(order, tolerance, ends, move |part: usize, m| parts[part].size(layout, m).lane(lane)).copysign(h)
            }
        };
        leg.reach = Some(found);
        reaches[lane] = found;
    }
}

/// The layout, with the numbers that code knows.
#[inline(always)]
fn layout<H: Recurrences>(layout: Layout) -> Layout {
    Layout::of::<H::Coords>(layout.length(), H::INTERLEAVED)
}

/// Calls back with the orders, one after the other, so that each is compiled on its own: sums of known length, without
/// loops. That is faster where a state is a few numbers, and takes the compiler minutes where iterations lie side by
/// side.
macro_rules! for_each_order {
    ($callback:ident) => {
        $callback! { 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 }
    };
}

macro_rules! count {
    ($($k:literal)*) => { [$($k),*].len() };
}
const _: () = assert!(for_each_order!(count) == HIGHEST, "the highest order comes from the one below");

/// Finds the polynomials from their beginnings.
#[inline(always)]
fn expand<H: Recurrences, R: Real, K: Precision>(expansion: &mut Of<H, R, K>, layout: Layout, t0: f64) {
    let time = R::parameter(&|lane| t0 + expansion.legs[lane].begin.nearest());
    let Expansion { method, parameters, q, p, tape, .. } = expansion;
    let (last, length) = (method.order, layout.length());
    let (mut q, mut p) = (q.coefficients(layout), p.coefficients(layout));
    if H::ROLLED {
        for k in (0..last).step_by(H::AT_ONCE) {
            H::order(parameters, length, &mut q, &mut p, tape, k, time);
        }
    } else if const { R::LANES == 1 && are_always_few::<H::Coords>() } {
        // A tape and rows that nothing else sees, so that they are registers: what an order finds is read by the next
        // one where it is, and not where it was written to.
        let tape = &mut H::Tape::<R>::default();
        let [mut rows_q, mut rows_p] = [Rows::new(); 2];
        let [mut near_q, mut near_p] = [rows_q.of(layout), rows_p.of(layout)];
        near_q[0].copy_from_slice(&q[0]);
        near_p[0].copy_from_slice(&p[0]);
        macro_rules! orders {
            ($($k:literal)*) => {$(
                if $k < last {
                    H::order(parameters, length, &mut near_q, &mut near_p, tape, $k, time);
                    q[$k + 1].copy_from_slice(&near_q[$k + 1]);
                    p[$k + 1].copy_from_slice(&near_p[$k + 1]);
                }
            )*};
        }
        for_each_order!(orders);
    } else {
        macro_rules! orders {
            ($($k:literal)*) => {$(
                if $k < last {
                    H::order(parameters, length, &mut q, &mut p, tape, $k, time);
                }
            )*};
        }
        for_each_order!(orders);
    }
}
