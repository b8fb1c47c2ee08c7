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
pub(crate) mod lists;
mod skin;
mod sums;
#[cfg(test)]
mod tests;

use crate::{
    layout::{
        bodies::{
            load_store::element,
            many_rows::WIDTH,
            pair_sums::{ManyBody, add},
        },
        threads::{Job, at_once},
    },
    scalar::{
        real::{Kernel, Mask, Real},
        simd::row::Row,
    },
};
use alloc::{boxed::Box, sync::Arc, vec, vec::Vec};
use cells::Sides;
use core::{marker::PhantomData, ops::Range};
use lists::{Lists, PORTIONS};
use skin::{FIRST_SKIN, next_skin};
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
    /// Those of a system. They depend on parameters alone, and so does the order of sums.
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

/// Lists of neighbours, and where bodies were when these were made.
struct Listed<W, const D: usize> {
    lists: Arc<Lists>,
    reference: Vec<[W; D]>,
    /// The square of half of the skin.
    slack: f64,
    skin: f64,
}

/// The lists of a motion, and what sums need beside them. A copy shares the lists.
pub(crate) struct Neighbours<R: Real, const D: usize> {
    listed: Option<Arc<Listed<R::Row<WIDTH>, D>>>,
    /// How many sums were taken over these lists.
    sums: u32,
    /// Coordinates and constants of the bodies in their slots, four numbers at a time.
    points: Vec<[R; 4]>,
    /// What is added up for the bodies in their slots.
    results: Vec<[[R; WIDTH]; D]>,
}

impl<R: Real, const D: usize> Clone for Neighbours<R, D> {
    fn clone(&self) -> Self {
        Self { listed: self.listed.clone(), sums: self.sums, ..Self::none() }
    }
}

impl<R: Real, const D: usize> Neighbours<R, D> {
    /// Those of a motion whose neighbours were never asked for.
    pub(crate) fn none() -> Self {
        Self { listed: None, sums: 0, points: Vec::new(), results: Vec::new() }
    }

    /// Takes over the lists of another motion.
    pub(crate) fn share(&mut self, from: &Self) {
        (self.listed, self.sums) = (from.listed.clone(), from.sums);
    }

    /// The gradient of the energy of all pairs by the coordinates of each body.
    pub(crate) fn sum_forces<H: ManyBody<D, S>, const S: usize>(
        &mut self,
        sum: Sum<'_, H, R, D, S>,
        cutoffs: &Cutoffs<D>,
        gradient: &mut [[R::Row<WIDTH>; D]],
    ) {
        R::enter(SumForces { neighbours: self, sum, cutoffs, gradient });
    }

    /// Makes new lists, unless the old ones still have all pairs that act.
    #[inline(always)]
    fn renew(&mut self, q: &[[R::Row<WIDTH>; D]], bodies: usize, cutoffs: &Cutoffs<D>, threads: usize) {
        if self.listed.as_ref().is_some_and(|listed| listed.holds(q)) {
            self.sums += 1;
            return;
        }
        let mut distance: f64 = 0.0;
        for cutoff in &cutoffs.of_members {
            distance = distance.max(if cutoff.distance.is_finite() { cutoff.distance } else { 0.0 });
        }
        let skin = match &self.listed {
            None => FIRST_SKIN * distance,
            Some(listed) => next_skin(distance, listed.skin, self.sums, D),
        };
        let old = self.listed.take().and_then(Arc::into_inner).and_then(|listed| Arc::into_inner(listed.lists));
        self.listed = Some(Arc::new(Listed::new::<R>(q, bodies, cutoffs, skin, threads, old)));
        self.sums = 1;
    }

    /// Puts coordinates and constants into slots.
    #[inline(always)]
    fn fill<const S: usize>(&mut self, q: &[[R::Row<WIDTH>; D]], constants: &[[R::Row<WIDTH>; S]], slots: &[u32]) {
        let quads = quads(D + S);
        self.points.resize(slots.len() * quads, [R::of(0.0); 4]);
        let mut numbers = [R::of(0.0); WIDTH];
        for (row, slots) in slots.chunks(WIDTH).enumerate() {
            for number in 0..D + S {
                let values = if number < D { q[row][number] } else { constants[row][number - D] };
                values.write(&mut numbers);
                for (slot, value) in slots.iter().zip(numbers) {
                    self.points[*slot as usize * quads + number / 4][number % 4] = value;
                }
            }
        }
    }

    /// The energy of all pairs and of all bodies alone.
    pub(crate) fn energy<H: ManyBody<D, S>, const S: usize>(
        mut self,
        Sum { q, constants, bodies, parameters, time, threads }: Sum<'_, H, R, D, S>,
        cutoffs: &Cutoffs<D>,
    ) -> R {
        let mut total = R::of(0.0);
        self.renew(q, bodies, cutoffs, threads);
        let Some(listed) = self.listed.clone() else { return total };
        let lists = &*listed.lists;
        self.fill(q, constants, &lists.slot_of);
        let points = &self.points[..];
        let mut results = vec![[[R::of(0.0); WIDTH]]; q.len()];
        in_portions(lists, &mut results, threads, &|number, rows, results| {
            let portion = lists.portions.as_ref().map(|portions| &portions[number]);
            let system = PhantomData::<fn(H)>;
            R::enter(Energies { points, portion, rows, bodies, parameters, time, results, system });
        });
        for row in 0..q.len() {
            let slots = &lists.slot_of[row * WIDTH..bodies.min((row + 1) * WIDTH)];
            let own = H::energy_alone::<R, R::Row<WIDTH>>(parameters, q[row], constants[row], time);
            let [sum] = gathered::<R, R::Row<WIDTH>, 1>(&results, slots);
            let sum = own.map_or(sum, |own| own + sum);
            for lane in 0..slots.len() {
                total += element(sum, lane);
            }
        }
        total
    }
}

/// What a sum over neighbours reads of a motion.
pub(crate) struct Sum<'s, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> {
    pub(crate) q: &'s [[R::Row<WIDTH>; D]],
    pub(crate) constants: &'s [[R::Row<WIDTH>; S]],
    pub(crate) bodies: usize,
    pub(crate) parameters: &'s H::Parameters<R>,
    pub(crate) time: f64,
    pub(crate) threads: usize,
}

/// The gradient of the energy of all pairs by the coordinates of each body, in the variant for the instruction set.
struct SumForces<'s, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> {
    neighbours: &'s mut Neighbours<R, D>,
    sum: Sum<'s, H, R, D, S>,
    cutoffs: &'s Cutoffs<D>,
    gradient: &'s mut [[R::Row<WIDTH>; D]],
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> Kernel for SumForces<'_, H, R, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { neighbours, sum: Sum { q, constants, bodies, parameters, time, threads }, cutoffs, gradient } = self;
        neighbours.renew(q, bodies, cutoffs, threads);
        let Some(listed) = neighbours.listed.clone() else { return };
        let lists = &*listed.lists;
        neighbours.fill(q, constants, &lists.slot_of);
        let Neighbours { points, results, .. } = neighbours;
        results.resize(q.len(), [[R::of(0.0); WIDTH]; D]);
        let points = &points[..];
        in_portions(lists, results, threads, &|number, rows, results| {
            let portion = lists.portions.as_ref().map(|portions| &portions[number]);
            let system = PhantomData::<fn(H)>;
            R::enter(Forces { points, portion, rows, bodies, parameters, time, results, system });
        });
        for row in 0..q.len() {
            let slots = &lists.slot_of[row * WIDTH..bodies.min((row + 1) * WIDTH)];
            let own = H::one_body::<R, R::Row<WIDTH>>(parameters, q[row], constants[row], time);
            let sum = gathered::<R, R::Row<WIDTH>, D>(results, slots);
            gradient[row] = match own {
                Some(own) => add(own, sum),
                None => sum,
            };
        }
    }
}

impl<W: Real, const D: usize> Listed<W, D> {
    /// Lists the pairs within the cutoff and a skin around it, in the memory of old lists.
    #[inline(always)]
    fn new<R: Real>(
        q: &[[W; D]],
        bodies: usize,
        cutoffs: &Cutoffs<D>,
        skin: f64,
        threads: usize,
        old: Option<Lists>,
    ) -> Self
    where
        W: Row<R>,
    {
        let (mut members, mut places) = (Vec::new(), Vec::new());
        for (member, cutoff) in cutoffs.of_members.iter().enumerate() {
            let mut points = vec![[0.0; D]; q.len() * WIDTH];
            for (row, points) in q.iter().zip(points.chunks_mut(WIDTH)) {
                for (axis, row) in row.iter().enumerate() {
                    for (body, point) in points.iter_mut().enumerate() {
                        point[axis] = row.lane(body * R::LANES + member * (R::LANES / R::MEMBERS));
                    }
                }
            }
            points.truncate(bodies);
            let mut farthest: f64 = 0.0;
            for x in points.as_flattened() {
                farthest = farthest.max(if x.is_finite() { Real::abs(*x) } else { 0.0 });
            }
            places.push(points);
            // Where lists are not used in this lane, none are made for it.
            let distance = if cutoff.is_short() { cutoff.distance } else { 0.0 };
            members.push((cutoff.sides, distance + skin + rounding::<R>(distance + skin, farthest)));
        }
        let at = |member: usize, body: usize| places[member][body];
        let lists = Arc::new(Lists::new(bodies, &members, &at, threads, old));
        // Half of the skin less what the comparison itself rounds.
        let slack = 0.25 * skin * skin * (1.0 - 16.0 * epsilon::<R>());
        Self { lists, reference: q.to_vec(), slack, skin }
    }

    /// Whether no body has moved by more than half of the skin. What is not a number has not moved: its run ends anyway.
    #[inline(always)]
    fn holds(&self, q: &[[W; D]]) -> bool {
        let slack = W::of(self.slack);
        let mut moved = W::Mask::of(false);
        for (now, then) in q.iter().zip(&self.reference) {
            let mut square = W::of(0.0);
            for (now, then) in now.iter().zip(then) {
                let by = *now - *then;
                square = by.fma(by, square);
            }
            moved = moved.or(slack.less(square));
        }
        !moved.any()
    }
}

/// The spacing of numbers just above one in what is computed in.
fn epsilon<R: Real>() -> f64 {
    let single = R::of(1.0 + f64::EPSILON).lane(0) == 1.0;
    if single { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

/// How much farther two bodies may be from each other than the system computes: a displacement is off by the rounding of a
/// difference, of its division by the side, and of the multiple of the side, each half a spacing at `2 farthest`; three
/// axes and the sum of their squares make this eight spacings at most.
fn rounding<R: Real>(distance: f64, farthest: f64) -> f64 {
    16.0 * epsilon::<R>() * (farthest + distance)
}

/// The number of quadruples for so many numbers.
const fn quads(numbers: usize) -> usize {
    numbers.div_ceil(4)
}

/// What a thread does with a portion: its number, its rows, and where results go.
type OfPortion<'p, T> = &'p (dyn Fn(usize, Range<usize>, &mut [T]) + Sync);

/// Takes the rows of all portions, on so many threads.
fn in_portions<T: Send>(lists: &Lists, results: &mut [T], threads: usize, of: OfPortion<'_, T>) {
    let rows = results.len();
    let each = match &lists.portions {
        Some(portions) => portions.first().map_or(rows, |portion| portion.rows.len()),
        None => rows.div_ceil(PORTIONS),
    };
    let (each, count) = (each.max(1), rows.div_ceil(each.max(1)));
    let share = count.div_ceil(threads.max(1)).max(1);
    let mut jobs = Vec::<Job<'_>>::with_capacity(threads);
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

/// A row of results of the bodies in these slots; lanes behind the last of them repeat it.
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
