//! The motion of the Taylor method: a piecewise polynomial, with an origin and a step for each lane.
//!
//! Always true: a lane's polynomials follow from its own state alone, and begin where its own step ends. Where one lane
//! needs a new polynomial all lanes are expanded, the others to the bits that they had.

use super::{
    Recurrences, Taylor,
    half::{Half, LaneNorms},
    limit::limit,
    segment::{Progress, Segment, digits},
    series::HIGHEST,
    states::To,
    step_size::{step_of_falling_terms, step_size, step_within_radius, too_short},
    table::{FEW, Layout, SmallTable, are_always_few},
    time::Time,
};
use crate::{
    error::Unsolved,
    scalar::{
        exact::exponent,
        real::{Kernel, Real},
        simd::block::WIDEST,
    },
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::{
        Shaped, System,
        counts::{Counts, OwnSteps},
        motion::{Motion, Prepared},
    },
    trajectory::step_functions::StepFunctions,
};
use alloc::{sync::Arc, vec::Vec};

/// The constants of a run.
pub struct Constants<P> {
    pub(super) parameters: Arc<P>,
    pub(super) method: Taylor,
    pub(super) interleaved: bool,
    /// Whether the formula of the Hamiltonian changes at edges.
    pub(super) has_edges: bool,
}

/// The polynomials of the members and the members' progress on them.
pub struct Expansion<R: Real, C: Coords, P: Prepared<R>, T> {
    pub(super) method: Taylor,
    parameters: P,
    /// The parameters of each member, where they are needed to find edges.
    pub(super) of_members: Vec<Arc<P::Single>>,
    pub(super) layout: Layout,
    pub(super) q: Half<R, C>,
    pub(super) p: Half<R, C>,
    tape: T,
    /// The derivatives of positions and momenta in front of the edge at which the last step ended, and their size, where the
    /// motion has deviation vectors.
    pub(super) rates: Vec<[f64; 2]>,
    /// The segments of the members, of which there may be fewer.
    pub(super) segments: [Segment; WIDEST],
}

impl<R: Real, C: Coords, P: Prepared<R>, T: Default> Clone for Expansion<R, C, P, T> {
    /// A tape is written before it is read, and most copies are read once: their tapes are empty.
    fn clone(&self) -> Self {
        let Self { method, layout, .. } = *self;
        Self {
            method,
            parameters: self.parameters.clone(),
            of_members: self.of_members.clone(),
            layout,
            q: self.q.clone(),
            p: self.p.clone(),
            tape: T::default(),
            rates: self.rates.clone(),
            segments: self.segments.clone(),
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
        let (mut parameters, mut of_members) = (Vec::with_capacity(constants.len()), Vec::new());
        for constants in constants {
            parameters.push(&*constants.parameters);
            if constants.has_edges {
                of_members.push(constants.parameters.clone());
            }
        }
        Self {
            method: constants[0].method,
            parameters: P::gather(&parameters),
            of_members,
            layout,
            q: Half::at(layout, &|lane, coordinate| states[lane].q.flat()[coordinate]),
            p: Half::at(layout, &|lane, coordinate| states[lane].p.flat()[coordinate]),
            tape: T::default(),
            rates: Vec::new(),
            segments: Default::default(),
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
        let half = |lane, half: fn(&Self) -> &Half<R, C>| {
            let (_, motion, lane) = of_lane(lane);
            (half(motion), lane)
        };
        let (mut parameters, mut of_members) = (Vec::with_capacity(R::LANES), Vec::new());
        for lane in 0..R::LANES {
            let constants = of_lane(lane).0;
            parameters.push(&*constants.parameters);
            if constants.has_edges {
                of_members.push(constants.parameters.clone());
            }
        }
        let mut segments: [Segment; WIDEST] = Default::default();
        for (lane, segment) in segments.iter_mut().enumerate().take(R::LANES) {
            let (_, motion, lane) = of_lane(lane);
            // The expansion at the same origin gives the same polynomial.
            *segment = Segment { step: None, free: 0.0, is_linear: false, ..motion.segments[lane].clone() };
        }
        Some(Self {
            method: constants.method,
            parameters: P::gather(&parameters),
            of_members,
            layout,
            q: Half::gathered(layout, |lane| half(lane, |motion| &motion.q)),
            p: Half::gathered(layout, |lane| half(lane, |motion| &motion.p)),
            tape: T::default(),
            rates: Vec::new(),
            segments,
        })
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        for (half, to) in [(&self.q, to.q.flat_mut()), (&self.p, to.p.flat_mut())] {
            for (coordinate, leaf) in to.iter_mut().enumerate() {
                *leaf = half.leaf(lane, self.layout.index_of(coordinate));
            }
        }
    }
    fn copy_state(&mut self, from: &Self) {
        // The tape is written before it is read.
        self.q.copy(&from.q);
        self.p.copy(&from.p);
        self.rates.clone_from(&from.rates);
        self.segments[..R::MEMBERS].clone_from_slice(&from.segments[..R::MEMBERS]);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.segments[lane].unsolved.as_ref()
    }
    fn counts(&self) -> Option<Counts> {
        let Segment { step, steps, .. } = &self.segments[0];
        let polynomials = steps.taken + u64::from(step.is_some());
        let steps = OwnSteps { under_way: step.map(f64::abs), ..*steps };
        Some(Counts { evaluations: polynomials.saturating_mul(self.method.order as u64), own_steps: Some(steps) })
    }
    fn finite(&self) -> bool {
        self.segments[..R::MEMBERS].iter().all(|segment| segment.unsolved.is_none())
            && self.q.finite()
            && self.p.finite()
    }
}

/// The expansion of a system's motion.
pub(super) type Of<H, R, K> = Expansion<R, Shaped<H, K>, <H as System>::Parameters<R>, <H as Recurrences>::Tape<R>>;

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
        advance_to::<H, R, K>(expansion, clock, Time::of(clock.steps + steps, clock.h));
    }
}

/// Dense output: advances the motion by a fraction of the step that begins with `begin` at the clock.
fn within<H: Recurrences, R: Real, K: Precision>(
    expansion: &mut Of<H, R, K>,
    begin: &Of<H, R, K>,
    clock: Clock,
    duration: f64,
) {
    let end = Time::of(clock.steps, clock.h).after(duration);
    // A time before the present polynomial's origin belongs to an earlier one.
    if end.since(expansion.segments[0].origin) * clock.h <= 0.0 {
        expansion.copy_state(begin);
    }
    advance_to::<H, R, K>(expansion, clock, end);
}

/// Advances the motion to `end`: compiled once for steps and for dense output.
#[inline(never)]
fn advance_to<H: Recurrences, R: Real, K: Precision>(expansion: &mut Of<H, R, K>, clock: Clock, end: Time) {
    R::enter(AdvanceTo::<H, R, K> { expansion, clock, end });
}

impl<R: Real, C: Coords, P: Prepared<R>, T> Expansion<R, C, P, T> {
    /// Evaluates the polynomials of both halves, by one text.
    #[inline(always)]
    fn evaluate(&mut self, layout: Layout, t: R, to: To<R>) {
        let order = self.method.order();
        for half in [&mut self.q, &mut self.p] {
            half.evaluate(layout, order, t, to);
        }
    }
}

/// The kernel that advances all lanes to a time: a lane that arrives waits for the others.
struct AdvanceTo<'e, H: Recurrences, R: Real, K: Precision> {
    expansion: &'e mut Of<H, R, K>,
    clock: Clock,
    end: Time,
}

impl<H: Recurrences, R: Real, K: Precision> Kernel for AdvanceTo<'_, H, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { expansion, clock: Clock { t0, h, .. }, end } = self;
        let layout = layout::<H>(expansion.layout);
        loop {
            // A copy beside the segments: a load would wait for what has just been stored there.
            let mut steps = [0.0; WIDEST];
            if expansion.segments[..R::MEMBERS].iter().any(Segment::is_unexpanded) {
                let mut tries = [0; WIDEST];
                loop {
                    expand::<H, R, K>(expansion, layout, [t0, h]);
                    if choose_steps::<H, R, K>(expansion, layout, h, &mut tries, &mut steps) {
                        break;
                    }
                }
                if const { H::HAS_EDGES } {
                    expansion.cut_linear(layout);
                    expansion.compare_rates(layout, [t0, h]);
                }
            } else {
                for (step, segment) in steps.iter_mut().zip(&expansion.segments[..R::MEMBERS]) {
                    *step = segment.step.unwrap_or(0.0);
                }
            }
            if const { H::HAS_EDGES } {
                for (member, step) in steps.iter_mut().enumerate().take(R::MEMBERS) {
                    *step = limit::<H, R, K>(expansion, member, self.clock, end);
                }
            }
            // Each member's duration on its polynomial, and whether this ends at the next origin.
            let (mut units, mut t, mut restarts) = ([1.0; WIDEST], [0.0; WIDEST], [0.0; WIDEST]);
            let (mut restart, mut arrive) = (false, false);
            for lane in 0..R::MEMBERS {
                let unit = expansion.segments[lane].unit::<R>(h);
                match expansion.segments[lane].proceed(steps[lane], end, t0, H::HAS_EDGES) {
                    Progress::Arrives(duration) => (t[lane], arrive) = (duration / unit, true),
                    Progress::NextSegment(step) => (t[lane], restarts[lane], restart) = (step / unit, 1.0, true),
                    Progress::Stopped => {}
                }
                units[lane] = unit;
            }
            let to = if restart {
                To::Origin { lanes: R::parameter(&|lane| restarts[lane]) }
            } else if arrive {
                To::Current
            } else {
                return;
            };
            if const { H::HAS_EDGES } && restart {
                expansion.keep_rates(layout, t[0], units[0]);
            }
            let t = R::parameter(&|lane| t[lane]);
            expansion.evaluate(layout, t, to);
            if let To::Current = to {
                return;
            }
        }
    }
}

/// The most units of time that are tried for a polynomial.
const MOST_TRIES: u8 = 8;

/// Chooses the steps of the new polynomials, and stores those of all lanes in `steps`. Returns false if some have to be
/// expanded again, in a unit of time nearer to their step.
#[inline(always)]
fn choose_steps<H: Recurrences, R: Real, K: Precision>(
    expansion: &mut Of<H, R, K>,
    layout: Layout,
    h: f64,
    tries: &mut [u8; WIDEST],
    steps: &mut [f64; WIDEST],
) -> bool {
    let Expansion { method: Taylor { order, tolerance }, q, p, segments, .. } = expansion;
    let (order, tolerance) = (*order, *tolerance);
    let halves = [&*q, &*p];
    let groups = Half::<R, Shaped<H, K>>::groups(layout);
    let mut all_norms = [LaneNorms::zero(); 2 * FEW];
    for (group, norms) in all_norms[..2 * groups].iter_mut().enumerate() {
        *norms = halves[group / groups].norms(layout, group % groups, order);
    }
    let mut fits = true;
    for lane in 0..R::MEMBERS {
        let segment = &mut segments[lane];
        if segment.step.is_none() {
            let mut norms = [[0.0; 4]; 2 * FEW];
            for (norms, all) in norms.iter_mut().zip(&all_norms[..2 * groups]) {
                *norms = all.lane(lane);
            }
            let norm = |group: usize, m: usize| halves[group / groups].norm(layout, group % groups, m).lane(lane);
            let mut step = step_size(order, tolerance, &norms[..2 * groups], norm);
            step = step.min(step_of_falling_terms(order, step, &norms[..2 * groups], norm));
            if const { H::HAS_EDGES } {
                step = step.min(step_within_radius(order, tolerance, step, 2 * groups, norm));
            }
            let unit = segment.unit::<R>(h);
            let [near, _] = digits::<R>();
            match too_short(step, near, order, 2 * groups, norm) {
                Some(by) if tries[lane] < MOST_TRIES => {
                    segment.exponent = Some(exponent(unit).saturating_add(by));
                    tries[lane] += 1;
                    fits = false;
                }
                // A later call may have another `h`, and the coefficients keep their unit.
                _ => {
                    segment.exponent = Some(exponent(unit));
                    segment.step = Some((step.number() * unit).copysign(h));
                    if const { H::HAS_EDGES } && step.number() == 0.0 {
                        segment.along_derivative::<K>(h, unit, groups, norm);
                    }
                }
            }
        }
        steps[lane] = segment.step.unwrap_or(0.0);
    }
    fits
}

/// The layout, with the numbers that code knows.
#[inline(always)]
fn layout<H: Recurrences>(layout: Layout) -> Layout {
    Layout::of::<H::Coords>(layout.length(), H::INTERLEAVED)
}

/// Calls back with the orders, one after the other, so that each is compiled on its own: sums of known length, without
/// loops. That is faster where a state is a few numbers, and takes the compiler minutes where iterations share vectors.
macro_rules! for_each_order {
    ($callback:ident) => {
        $callback! { 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 }
    };
}

macro_rules! count {
    ($($k:literal)*) => { [$($k),*].len() };
}
const _: () = assert!(for_each_order!(count) == HIGHEST, "the highest order comes from the one below");

/// Expands the polynomials at their origins.
#[inline(always)]
fn expand<H: Recurrences, R: Real, K: Precision>(expansion: &mut Of<H, R, K>, layout: Layout, [t0, h]: [f64; 2]) {
    let time = R::parameter(&|lane| t0 + expansion.segments[lane].origin.nearest());
    let unit = R::parameter(&|lane| expansion.segments[lane].unit::<R>(h));
    let Expansion { method, parameters, q, p, tape, .. } = expansion;
    let (last, length) = (method.order, layout.length());
    let (mut q, mut p) = (q.coefficients(layout, unit), p.coefficients(layout, unit));
    // With derivatives an order is so much code that one copy has to do for all of them. Its sums have the same bits. The
    // baseline of x86 is for processors without fused multiply-add, of before 2013: half of the code would be for these.
    if const {
        let of_few_processors = cfg!(all(target_arch = "x86_64", feature = "std")) && !R::BEYOND_BASELINE;
        H::ROLLED || R::LANES != R::MEMBERS || of_few_processors
    } {
        for k in (0..last).step_by(H::ORDERS_PER_CALL) {
            H::order(parameters, length, &mut q, &mut p, tape, k, time);
        }
    } else if const { R::LANES == 1 && are_always_few::<H::Coords>() } {
        // A local tape and table, which the compiler holds in registers: the next order reads its operands there and
        // not from memory.
        let tape = &mut H::Tape::<R>::default();
        let [mut table_q, mut table_p] = [SmallTable::new(); 2];
        let [mut local_q, mut local_p] = [table_q.of(layout, unit), table_p.of(layout, unit)];
        local_q[0].copy_from_slice(&q[0]);
        local_p[0].copy_from_slice(&p[0]);
        macro_rules! orders {
            ($($k:literal)*) => {$(
                if $k < last {
                    H::order(parameters, length, &mut local_q, &mut local_p, tape, $k, time);
                    q[$k + 1].copy_from_slice(&local_q[$k + 1]);
                    p[$k + 1].copy_from_slice(&local_p[$k + 1]);
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
