//! Sums over the neighbours within a cutoff, where there are many bodies.
//!
//! Comes in: bodies in rows. Goes out: the same gradient and energy as of all pairs, in another order. Always true: what
//! acts on a body is added up in the order of the numbers of the bodies that act, and what does not act adds zero, which
//! changes no bit. So no bit depends on when lists were made, on how wide their skin is, or on threads.
//!
//! A list has the pairs within the cutoff and a skin around it. No pair outside of it acts as long as no body has moved by
//! more than half of the skin since the list was made, which is looked at before every sum.

mod candidates;
pub(crate) mod cells;
mod found;
mod left_out;
mod listed;
pub(crate) mod lists;
mod places;
mod skin;
mod sums;
#[cfg(test)]
mod tests;

use crate::{
    layout::bodies::{
        load_store::{WIDTH, values},
        pair_sums::{ManyBody, add},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
    state::{aligned::Aligned, precision::Slot},
    threads::{Job, at_once},
};
use alloc::{
    boxed::Box,
    sync::{Arc, Weak},
    vec,
    vec::Vec,
};
use cells::Sides;
use core::{marker::PhantomData, ops::Range};
use left_out::leave_out;
use listed::Listed;
pub(crate) use listed::rounding;
use lists::{Lists, PORTIONS};
use skin::{FIRST_SKIN, next_skin};
pub(crate) use sums::bodies_at;
use sums::{Energies, Forces};

/// The cutoffs of the members in the lanes of an `R`, one for each.
pub(crate) struct Cutoffs<const D: usize> {
    pub(crate) of_members: Vec<Cutoff<D>>,
}

/// A cutoff, and the box that it is in.
#[derive(Clone, Copy)]
pub(crate) struct Cutoff<const D: usize> {
    pub(crate) distance: f64,
    pub(crate) sides: Sides<D>,
}

impl<const D: usize> Cutoff<D> {
    /// Whether lists are shorter than all pairs: not where it covers the box.
    fn is_short(&self) -> bool {
        let open = |side: &f64| *side <= 0.0 || *side >= 2.0 * self.distance;
        self.distance.is_finite() && self.distance > 0.0 && self.sides.iter().any(open)
    }
}

impl<const D: usize> Cutoffs<D> {
    /// The cutoffs of a system. They depend on parameters alone, and so does the order of sums.
    pub(crate) fn of<H: ManyBody<D, S>, R: Real, const S: usize>(parameters: &H::Parameters<R>, time: f64) -> Self {
        let (square, sides) = (H::cutoff::<R, R>(parameters, time), H::sides::<R, R>(parameters, time));
        let mut of_members = Vec::with_capacity(R::MEMBERS);
        for member in 0..R::MEMBERS {
            let lane = member * (R::LANES / R::MEMBERS);
            // The nearest image is the same for either sign of a side.
            let sides = sides.map(|side| Real::abs(side.lane(lane)));
            of_members.push(Cutoff { distance: Real::sqrt(square.lane(lane)), sides });
        }
        Self { of_members }
    }

    /// Whether lists are used in any lane.
    pub(crate) fn any(&self) -> bool {
        self.of_members.iter().any(Cutoff::is_short)
    }

    /// Whether lists are used in all lanes.
    pub(crate) fn all(&self) -> bool {
        self.of_members.iter().all(Cutoff::is_short)
    }

    /// One in lanes where lists are used, zero in others.
    pub(crate) fn lanes<R: Real, W: Row<R>>(&self) -> W {
        let short = |lane: usize| self.of_members[lane % R::LANES * R::MEMBERS / R::LANES].is_short();
        W::parameter(&|lane| if short(lane) { 1.0 } else { 0.0 })
    }
}

/// The lists of a motion, and what sums need beside them. A copy borrows the lists for as long as the motion keeps them, so
/// that new ones take the place of the old ones in memory.
pub(crate) struct Neighbours<R: Real, const D: usize> {
    listed: Option<Arc<Listed<R::Row<WIDTH>, D>>>,
    borrowed: Weak<Listed<R::Row<WIDTH>, D>>,
    /// The number of sums taken over these lists.
    sums: u32,
    /// Coordinates and constants of the bodies in their slots, four numbers at a time, none of which is in two cache lines.
    points: Aligned<R>,
    /// The sums for the bodies in their slots.
    results: Vec<[[R; WIDTH]; D]>,
}

impl<R: Real, const D: usize> Clone for Neighbours<R, D> {
    fn clone(&self) -> Self {
        let mut copy = Self::none();
        copy.share(self);
        copy
    }
}

impl<R: Real, const D: usize> Neighbours<R, D> {
    /// The lists of a motion that has not needed neighbours yet.
    pub(crate) fn none() -> Self {
        let points = Aligned::filled(0, R::of(0.0));
        Self { listed: None, borrowed: Weak::new(), sums: 0, points, results: Vec::new() }
    }

    /// Borrows the lists of another motion.
    pub(crate) fn share(&mut self, from: &Self) {
        let Some(listed) = from.last() else { return };
        // What the other one has borrowed from here stays here.
        self.listed = self.listed.take().filter(|own| Arc::ptr_eq(own, &listed));
        (self.borrowed, self.sums) = (Arc::downgrade(&listed), from.sums);
    }

    /// The lists that were used last, if they are still there.
    fn last(&self) -> Option<Arc<Listed<R::Row<WIDTH>, D>>> {
        self.borrowed.upgrade().or_else(|| self.listed.clone())
    }

    /// Adds a multiple of the gradient of the energy of all pairs, by the coordinates of each body, to momenta; in lanes where
    /// lists are not used, that of the gradients that are given.
    pub(crate) fn kick<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        &mut self,
        sum: Sum<'_, H, R, L, D, S>,
        cutoffs: &Cutoffs<D>,
        others: Option<&[[R::Row<WIDTH>; D]]>,
        factor: R::Row<WIDTH>,
        p: &mut [[L; D]],
    ) {
        R::enter(Kick { neighbours: self, sum, cutoffs, others, factor, p });
    }

    /// Makes new lists, unless the last ones still have all pairs that act.
    #[inline(always)]
    fn renew<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        &mut self,
        sum: &Sum<'_, H, R, L, D, S>,
        cutoffs: &Cutoffs<D>,
    ) -> Arc<Listed<R::Row<WIDTH>, D>> {
        let Sum { q, constants, bodies, parameters, time, threads } = *sum;
        let last = self.last();
        // No closure, which might be compiled outside of the variant for the instruction set.
        if let Some(listed) = &last
            && listed.holds(q)
        {
            self.sums += 1;
            return listed.clone();
        }
        let mut distance: f64 = 0.0;
        for cutoff in &cutoffs.of_members {
            distance = distance.max(if cutoff.distance.is_finite() { cutoff.distance } else { 0.0 });
        }
        let skin = last.map_or(FIRST_SKIN * distance, |listed| next_skin(distance, listed.skin, self.sums, D));
        let old = self.listed.take().and_then(Arc::into_inner).and_then(|listed| Arc::into_inner(listed.lists));
        let mut listed = Listed::new::<R, L>(q, bodies, cutoffs, skin, threads, old);
        if const { H::LEAVES_OUT.is_some() && sums::leave_out::<R>() }
            && let Some(lists) = Arc::get_mut(&mut listed.lists)
        {
            self.fill::<H, L, S>(q, constants, &lists.slot_of);
            let (points, _) = self.points.as_chunks();
            leave_out::<H, R, D, S>(lists, points, bodies, (parameters, time), threads);
        }
        let listed = Arc::new(listed);
        (self.listed, self.borrowed, self.sums) = (Some(listed.clone()), Weak::new(), 1);
        listed
    }

    /// Puts coordinates and constants into slots.
    #[inline(always)]
    fn fill<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        &mut self,
        q: &[[L; D]],
        constants: &[[R::Row<WIDTH>; S]],
        slots: &[u32],
    ) {
        let count = const { numbers::<H, D, S>() };
        let quads = quads(count);
        let length = slots.len() * quads * 4;
        if self.points.len() != length {
            self.points = Aligned::filled(length, R::of(0.0));
        }
        let (points, _) = self.points.as_chunks_mut();
        for (row, slots) in slots.chunks(WIDTH).enumerate() {
            for quad in 0..quads {
                let mut numbers = [[R::of(0.0); WIDTH]; 4];
                for (number, at) in numbers.iter_mut().zip(quad * 4..count) {
                    let values = if at < D { q[row][at].value() } else { constants[row][constant::<H, D, S>(at)] };
                    values.write(number);
                }
                for (lane, slot) in slots.iter().enumerate() {
                    points[*slot as usize * quads + quad] = numbers.each_ref().map(|number| number[lane]);
                }
            }
        }
    }

    /// Puts all bodies into slots, of lists where these are used in all lanes.
    #[inline(always)]
    pub(crate) fn placed<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        &mut self,
        sum: &Sum<'_, H, R, L, D, S>,
        cutoffs: Option<&Cutoffs<D>>,
    ) -> Placed<'_, R, D> {
        // A constant, so that nothing is compiled for lists where there is no cutoff.
        let lists = match cutoffs {
            Some(cutoffs) if const { H::LISTED_FROM < usize::MAX } && cutoffs.all() => {
                self.renew(sum, cutoffs).lists.clone()
            }
            _ => Arc::new(Lists::none(sum.bodies)),
        };
        self.fill::<H, L, S>(sum.q, sum.constants, &lists.slot_of);
        let Self { points, results, .. } = self;
        results.clear();
        results.resize(sum.q.len(), [[R::of(0.0); WIDTH]; D]);
        Placed { lists, points: points.as_chunks().0, results }
    }

    /// The densities of all bodies; in lanes where lists are not used, those that are given.
    pub(crate) fn densities<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        &mut self,
        sum: Sum<'_, H, R, L, D, S>,
        cutoffs: &Cutoffs<D>,
        densities: &mut [[R::Row<WIDTH>; D]],
    ) {
        R::enter(Densities { neighbours: self, sum, cutoffs, densities });
    }

    /// Sums the forces on all bodies over their neighbours, or else their densities, in the slots of the lists.
    #[inline(always)]
    fn sum_up<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize, const DENSITIES: bool>(
        &mut self,
        sum: &Sum<'_, H, R, L, D, S>,
        cutoffs: &Cutoffs<D>,
    ) -> Arc<Listed<R::Row<WIDTH>, D>> {
        let Sum { q, constants, bodies, parameters, time, threads } = *sum;
        let listed = self.renew(sum, cutoffs);
        let lists = &*listed.lists;
        self.fill::<H, L, S>(q, constants, &lists.slot_of);
        let Neighbours { points, results, .. } = self;
        results.resize(q.len(), [[R::of(0.0); WIDTH]; D]);
        let (points, _) = points.as_chunks();
        in_portions(lists, results, threads, &|number, rows, results| {
            let portion = lists.portions.as_ref().map(|portions| &portions[number]);
            let system = PhantomData::<fn(H)>;
            R::enter(Forces::<H, R, D, S, DENSITIES> {
                points,
                portion,
                rows,
                bodies,
                parameters,
                time,
                results,
                system,
            });
        });
        listed
    }

    /// The energy of all pairs and of all bodies alone.
    pub(crate) fn energy<H: ManyBody<D, S>, L: Slot<R::Row<WIDTH>>, const S: usize>(
        self,
        sum: Sum<'_, H, R, L, D, S>,
        cutoffs: &Cutoffs<D>,
    ) -> R {
        R::enter(Energy { neighbours: self, sum, cutoffs })
    }
}

/// Bodies in slots.
pub(crate) struct Placed<'n, R, const D: usize> {
    pub(crate) lists: Arc<Lists>,
    /// Their coordinates and constants, four numbers at a time.
    pub(crate) points: &'n [[R; 4]],
    /// Zeros for their sums.
    pub(crate) results: &'n mut [[[R; WIDTH]; D]],
}

/// The data of a motion that a sum over neighbours reads.
pub(crate) struct Sum<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    pub(crate) q: &'s [[L; D]],
    pub(crate) constants: &'s [[R::Row<WIDTH>; S]],
    pub(crate) bodies: usize,
    pub(crate) parameters: &'s H::Parameters<R>,
    pub(crate) time: f64,
    pub(crate) threads: usize,
}

/// A kick by the forces of neighbours, in the variant for the instruction set.
struct Kick<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    neighbours: &'s mut Neighbours<R, D>,
    sum: Sum<'s, H, R, L, D, S>,
    cutoffs: &'s Cutoffs<D>,
    others: Option<&'s [[R::Row<WIDTH>; D]]>,
    factor: R::Row<WIDTH>,
    p: &'s mut [[L; D]],
}

impl<H, R, L, const D: usize, const S: usize> Kernel for Kick<'_, H, R, L, D, S>
where
    H: ManyBody<D, S>,
    R: Real,
    L: Slot<R::Row<WIDTH>>,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { neighbours, sum, cutoffs, others, factor, p } = self;
        let listed = neighbours.sum_up::<H, L, S, false>(&sum, cutoffs);
        let (Sum { q, constants, bodies, parameters, time, .. }, results) = (sum, &neighbours.results);
        let short = Real::less(Real::of(0.0), cutoffs.lanes::<R, R::Row<WIDTH>>());
        for row in 0..q.len() {
            let slots = &listed.lists.slot_of[row * WIDTH..bodies.min((row + 1) * WIDTH)];
            let own = H::one_body::<R, R::Row<WIDTH>>(parameters, values(&q[row]), constants[row], time);
            let sum = gathered::<R, R::Row<WIDTH>, D>(results, slots);
            let mut gradient = own.map_or(sum, |own| add(own, sum));
            for d in 0..D {
                if let Some(others) = others {
                    gradient[d] = Real::select(short, gradient[d], others[row][d]);
                }
                p[row][d].fma(factor, gradient[d]);
            }
        }
    }
}

/// The densities of bodies by their neighbours, in the variant for the instruction set.
struct Densities<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    neighbours: &'s mut Neighbours<R, D>,
    sum: Sum<'s, H, R, L, D, S>,
    cutoffs: &'s Cutoffs<D>,
    densities: &'s mut [[R::Row<WIDTH>; D]],
}

impl<H, R, L, const D: usize, const S: usize> Kernel for Densities<'_, H, R, L, D, S>
where
    H: ManyBody<D, S>,
    R: Real,
    L: Slot<R::Row<WIDTH>>,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { neighbours, sum, cutoffs, densities } = self;
        let listed = neighbours.sum_up::<H, L, S, true>(&sum, cutoffs);
        let short = Real::less(Real::of(0.0), cutoffs.lanes::<R, R::Row<WIDTH>>());
        for (row, densities) in densities.iter_mut().enumerate() {
            let slots = &listed.lists.slot_of[row * WIDTH..sum.bodies.min((row + 1) * WIDTH)];
            let listed = gathered::<R, R::Row<WIDTH>, D>(&neighbours.results, slots);
            for d in 0..D {
                densities[d] = Real::select(short, listed[d], densities[d]);
            }
        }
    }
}

/// How many numbers of a body lists read: its coordinates, and its constants but for its number.
const fn numbers<H: ManyBody<D, S>, const D: usize, const S: usize>() -> usize {
    if H::NUMBER.is_some() { D + S - 1 } else { D + S }
}

/// The constant that is the number with this index, after the coordinates.
#[inline(always)]
fn constant<H: ManyBody<D, S>, const D: usize, const S: usize>(at: usize) -> usize {
    let place = at - D;
    match H::NUMBER {
        Some(number) if number <= place => place + 1,
        _ => place,
    }
}

/// The number of quadruples for this number of numbers.
const fn quads(numbers: usize) -> usize {
    numbers.div_ceil(4)
}

/// The work of a thread on a portion: its number, its rows, and the slice for its results.
type OfPortion<'p, T> = &'p (dyn Fn(usize, Range<usize>, &mut [T]) + Sync);

/// Takes the rows of all portions, on this number of threads.
fn in_portions<T: Send>(lists: &Lists, results: &mut [T], threads: usize, of: OfPortion<'_, T>) {
    let rows = results.len();
    let each = match &lists.portions {
        Some(portions) => portions.first().map_or(rows, |portion| portion.rows.len()),
        None => rows.div_ceil(PORTIONS),
    };
    let (each, count) = (each.max(1), rows.div_ceil(each.max(1)));
    let share = count.div_ceil(threads.max(1)).max(1);
    let mut jobs = Vec::<Job<'_>>::with_capacity(count.div_ceil(share));
    for (thread, results) in results.chunks_mut(share * each).enumerate() {
        jobs.push(Box::new(move || {
            for (portion, results) in results.chunks_mut(each).enumerate() {
                let number = thread * share + portion;
                of(number, number * each..number * each + results.len(), results);
            }
        }));
    }
    at_once(jobs);
}

/// Adds a multiple of the results of bodies in slots to their momenta.
#[inline(always)]
pub(crate) fn add_multiple<R: Real, L: Slot<R::Row<WIDTH>>, const D: usize>(
    results: &[[[R; WIDTH]; D]],
    slot_of: &[u32],
    factor: R::Row<WIDTH>,
    p: &mut [[L; D]],
) {
    for (p, slots) in p.iter_mut().zip(slot_of.chunks(WIDTH)) {
        let sum = gathered::<R, R::Row<WIDTH>, D>(results, slots);
        for d in 0..D {
            p[d].fma(factor, sum[d]);
        }
    }
}

/// A row of results of the bodies in these slots; lanes after the last of them repeat it.
#[inline(always)]
fn gathered<R: Real, W: Row<R>, const N: usize>(results: &[[[R; WIDTH]; N]], slots: &[u32]) -> [W; N] {
    let mut numbers = [[R::of(0.0); WIDTH]; N];
    let mut slot = slots[0];
    for lane in 0..WIDTH {
        slot = slots.get(lane).copied().unwrap_or(slot);
        let (row, at) = (slot as usize / WIDTH, slot as usize % WIDTH);
        for (numbers, results) in numbers.iter_mut().zip(&results[row]) {
            numbers[lane] = results[at];
        }
    }
    let mut rows = [W::of(0.0); N];
    for (row, numbers) in rows.iter_mut().zip(&numbers) {
        *row = W::read(numbers);
    }
    rows
}

/// The energy of neighbours, in the variant for the instruction set.
struct Energy<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    neighbours: Neighbours<R, D>,
    sum: Sum<'s, H, R, L, D, S>,
    cutoffs: &'s Cutoffs<D>,
}

impl<H, R, L, const D: usize, const S: usize> Kernel for Energy<'_, H, R, L, D, S>
where
    H: ManyBody<D, S>,
    R: Real,
    L: Slot<R::Row<WIDTH>>,
{
    type Out = R;

    #[inline(always)]
    fn call(self) -> R {
        let Self { mut neighbours, sum, cutoffs } = self;
        let listed = neighbours.renew(&sum, cutoffs);
        let Sum { q, constants, bodies, parameters, time, threads } = sum;
        let lists = &*listed.lists;
        neighbours.fill::<H, L, S>(q, constants, &lists.slot_of);
        let (points, _) = neighbours.points.as_chunks();
        // Of the type of the forces, so that what sums them is compiled once.
        let mut results = vec![[[R::of(0.0); WIDTH]; D]; q.len()];
        in_portions(lists, &mut results, threads, &|number, rows, results| {
            let portion = lists.portions.as_ref().map(|portions| &portions[number]);
            let system = PhantomData::<fn(H)>;
            R::enter(Energies { points, portion, rows, bodies, parameters, time, results, system });
        });
        let mut total = R::of(0.0);
        for row in 0..q.len() {
            let slots = &lists.slot_of[row * WIDTH..bodies.min((row + 1) * WIDTH)];
            let own = H::energy_alone::<R, R::Row<WIDTH>>(parameters, values(&q[row]), constants[row], time);
            let sum = gathered::<R, R::Row<WIDTH>, D>(&results, slots)[0];
            let sum = own.map_or(sum, |own| own + sum);
            for lane in 0..slots.len() {
                total += sum.part(lane);
            }
        }
        total
    }
}
