//! The layout of many bodies that act on each other in pairs: rows of eight, one row per eight bodies and coordinate.

use crate::{
    layout::bodies::{
        densities::densities,
        load_store::{WIDTH, active_in_last, load_constants, pack, row_of, unpack, values, zeros},
        neighbours::{Cutoffs, Neighbours, Sum},
        other_terms::OtherTerms,
        pair_sums::{
            Bodies, BodyConstants, ManyBody, add, add_active, inter_energies, inter_row, intra_energies, intra_row,
        },
        triplets::{EnergyOfTriplets, KickByTriplets},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::{
        dissipation::Momenta,
        motion::{Found, Motion, Plain, Prepared},
    },
    threads::{self, Job, all_threads, at_once},
};
use alloc::{boxed::Box, vec::Vec};
use core::{marker::PhantomData, ops::Range};

/// The smallest numbers of rows for a number of chunks in which pairs are summed. Fewer rows are done before another
/// thread has started, and for many rows the sums of chunks take little time to add up. The order of sums depends on
/// the chunks, and not on the number of threads.
const CHUNKS: [(usize, usize); 2] = [(512, 32), (64, 8)];

/// Any number of bodies with `D` coordinates and `S` prepared constants each. The last row may have fewer bodies than
/// lanes; those after them never act on anything.
pub struct ManyRows<R: Real, K: Precision, P, const D: usize, const S: usize> {
    /// Positions.
    pub q: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// Momenta.
    pub p: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// The prepared constants of each body.
    constants: Vec<[R::Row<WIDTH>; S]>,
    /// The sums of forces, chunk after chunk, once pairs were summed; in the end the first chunk has the total.
    gradients: Vec<[R::Row<WIDTH>; D]>,
    /// The lists of neighbours, where a cutoff makes these short.
    pub(crate) neighbours: Neighbours<R, D>,
    /// The number of threads that may share the work.
    threads: usize,
    /// The number of bodies.
    pub(crate) bodies: usize,
    /// The number of bodies that act on each other, and of those that move by the flow of `T`: the first ones.
    acting: usize,
    moving: usize,
    /// Prepared constants.
    pub parameters: P,
}

/// Returns the last row of bodies that move, if other bodies in it do not.
#[inline(always)]
fn shared_row<T: Copy>(rows: &[T], moving: usize, bodies: usize) -> Option<T> {
    (moving < bodies && !moving.is_multiple_of(WIDTH)).then(|| rows[moving / WIDTH])
}

/// Restores the bodies of that row that do not move.
#[inline(always)]
fn put_back<R: Real, L: Slot<R::Row<WIDTH>>, const D: usize>(
    rows: &mut [[L; D]],
    moving: usize,
    before: Option<[L; D]>,
) {
    let Some(before) = before else { return };
    let (row, moved) = (&mut rows[moving / WIDTH], moving % WIDTH);
    let stays: R::Row<WIDTH> = Real::parameter(&|lane| if lane / R::LANES < moved { 0.0 } else { 1.0 });
    for d in 0..D {
        row[d] = Slot::select(Real::less(Real::of(0.0), stays), before[d], row[d]);
    }
}

/// The indices of the bodies of a row, out of this number of bodies.
pub(crate) fn bodies_of_row(row: usize, bodies: usize) -> Range<usize> {
    row * WIDTH..bodies.min((row + 1) * WIDTH)
}

/// The number of chunks in which the pairs of this number of bodies are summed.
fn chunks(bodies: usize) -> usize {
    CHUNKS.iter().find(|(rows, _)| bodies >= rows * WIDTH).map_or(1, |(_, chunks)| *chunks)
}

/// A copy of rows.
fn copied<T: Copy>(rows: &[T]) -> Vec<T> {
    let mut copied = Vec::with_capacity(rows.len());
    for row in rows {
        copied.push(*row);
    }
    copied
}

/// The values of slots, row by row.
fn values_of_rows<W: Real, L: Slot<W>, const D: usize>(slots: &[[L; D]]) -> Vec<[W; D]> {
    let mut values_of_rows = Vec::with_capacity(slots.len());
    for slots in slots {
        values_of_rows.push(values(slots));
    }
    values_of_rows
}

/// Whether this number of lanes of rows is finite. Lanes after the last body drift without a force, and may become
/// infinite when no body does.
fn finite<W: Real, L: Slot<W>, const D: usize>(rows: &[[L; D]], mut lanes: usize) -> bool {
    for row in rows {
        let here = lanes.min(W::LANES);
        lanes -= here;
        for slot in row {
            let row = slot.value();
            if !row.finite() && (0..here).any(|lane| !row.lane(lane).is_finite()) {
                return false;
            }
        }
    }
    true
}

impl<R: Real, K: Precision, P: Clone, const D: usize, const S: usize> Clone for ManyRows<R, K, P, D, S> {
    fn clone(&self) -> Self {
        Self {
            q: copied(&self.q),
            p: copied(&self.p),
            constants: copied(&self.constants),
            gradients: Vec::new(),
            neighbours: self.neighbours.clone(),
            threads: self.threads,
            bodies: self.bodies,
            acting: self.acting,
            moving: self.moving,
            parameters: self.parameters.clone(),
        }
    }
}

impl<C, R, K, P, const D: usize, const S: usize> Motion<C, P::Single> for ManyRows<R, K, P, D, S>
where
    C: Coords<Leaf = K>,
    R: Real,
    K: Precision,
    P: Prepared<R>,
    P::Single: BodyConstants<S>,
{
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        let bodies = states[0].q.flat().len() / D;
        let (acting, moving) = (constants[0].acting(bodies), constants[0].moving(bodies));
        let rows = bodies.div_ceil(WIDTH);
        let (mut q, mut p) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
        let mut rows_of_constants = Vec::with_capacity(rows);
        for row in 0..rows {
            let bodies = bodies_of_row(row, bodies);
            q.push(pack::<R, C, WIDTH, D>(&bodies, states, |state| &state.q));
            p.push(pack::<R, C, WIDTH, D>(&bodies, states, |state| &state.p));
            rows_of_constants.push(load_constants::<R, P::Single, WIDTH, S>(&bodies, constants));
        }
        let (constants, parameters) = (rows_of_constants, P::gather(constants));
        let (gradients, neighbours) = (Vec::new(), Neighbours::none());
        Self { q, p, constants, gradients, neighbours, threads: 1, bodies, acting, moving, parameters }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        for row in 0..self.q.len() {
            let bodies = bodies_of_row(row, self.bodies);
            unpack::<R, K, WIDTH, D>(&bodies, &self.q[row], lane, to.q.flat_mut());
            unpack::<R, K, WIDTH, D>(&bodies, &self.p[row], lane, to.p.flat_mut());
        }
    }
    fn copy_state(&mut self, from: &Self) {
        Motion::<C, P::Single>::copy_state_on(self, from, Some(1));
    }
    fn copy_state_on(&mut self, from: &Self, threads: Option<usize>) {
        threads::copy(&from.q, &mut self.q, threads);
        threads::copy(&from.p, &mut self.p, threads);
        self.neighbours.share(&from.neighbours);
    }
    fn found(&self) -> Option<Found> {
        self.neighbours.found(self.acting)
    }
    fn use_found(&mut self, found: &Found) {
        self.neighbours.use_found(found, self.acting);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.use_threads(threads);
    }
    fn finite(&self) -> bool {
        let lanes = self.bodies * R::LANES;
        finite::<R::Row<WIDTH>, _, D>(&self.q, lanes) && finite::<R::Row<WIDTH>, _, D>(&self.p, lanes)
    }
}

impl<R: Real, K: Precision, P, const D: usize, const S: usize> Momenta<R, K> for ManyRows<R, K, P, D, S> {
    type Wide = R::Row<WIDTH>;

    #[inline(always)]
    fn momenta(&mut self) -> &mut [K::Slot<R::Row<WIDTH>>] {
        self.p.as_flattened_mut()
    }
    fn coordinate(slot: usize, body: usize) -> usize {
        (slot / D * WIDTH + body) * D + slot % D
    }
}

impl<R: Real, P, const D: usize, const S: usize> ManyRows<R, f64, P, D, S> {
    /// Bodies with these constants, the first ones of them acting on each other, at the origin and at rest.
    pub(crate) fn at_origin(parameters: P, constants: Vec<[R::Row<WIDTH>; S]>, bodies: usize, acting: usize) -> Self {
        let [q, p] = [(); 2].map(|()| zeros(constants.len()));
        let (gradients, neighbours) = (Vec::new(), Neighbours::none());
        Self { q, p, constants, gradients, neighbours, threads: 1, bodies, acting, moving: bodies, parameters }
    }
}

impl<R: Real, K: Precision, P: Prepared<R>, const D: usize, const S: usize> ManyRows<R, K, P, D, S> {
    /// Lets this number of threads share the pairs, or all that the machine has.
    pub(crate) fn use_threads(&mut self, threads: Option<usize>) {
        self.threads = threads.unwrap_or_else(all_threads).max(1);
    }
    /// The flow of `T`. As that of `V`, inlined for certain only where code is optimised: elsewhere every stage of a
    /// composition would have a copy with stack slots of its own.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn drift<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let step = Real::of(duration);
        let Self { q, p, constants, parameters, moving, bodies, .. } = self;
        // Lanes after the last body may drift, but not bodies that stay.
        let before = if const { H::SOME_STAY } { shared_row(q, *moving, *bodies) } else { None };
        for row in 0..moving.div_ceil(WIDTH) {
            H::drift_body::<R, R::Row<WIDTH>, _>(parameters, &mut q[row], values(&p[row]), constants[row], step, time);
        }
        if const { H::SOME_STAY } {
            put_back::<R, _, D>(q, *moving, before);
        }
    }
    /// The flow of `V`.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn kick<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let step = Real::of(-duration);
        let before = if const { H::SOME_STAY } { shared_row(&self.p, self.acting, self.bodies) } else { None };
        if const { !H::DENSITIES.is_empty() } {
            self.weigh::<H>(time);
        }
        if let Some(cutoffs) = self.cutoffs::<H>(time) {
            self.kick_by_neighbours::<H>(&cutoffs, step, time);
        } else {
            self.sum_over_pairs::<H>(time);
            let Self { p, gradients, acting, .. } = self;
            for row in 0..acting.div_ceil(WIDTH) {
                let (p, gradient) = (&mut p[row], &gradients[row]);
                for d in 0..D {
                    p[d].fma(step, gradient[d]);
                }
            }
        }
        if const { H::TRIPLETS } {
            let cutoffs = self.cutoffs::<H>(time);
            let Self { q, p, constants, neighbours, threads, acting, parameters, .. } = self;
            let rows = acting.div_ceil(WIDTH);
            let (q, constants, bodies, threads) = (&q[..rows], &constants[..rows], *acting, *threads);
            let sum = Sum::<H, R, _, D, S> { q, constants, bodies, parameters, time, threads };
            let (cutoffs, p) = (cutoffs.as_ref(), &mut p[..rows]);
            R::enter(KickByTriplets { sum, neighbours, cutoffs, factor: step, p });
        }
        if const { H::SOME_STAY } {
            put_back::<R, _, D>(&mut self.p, self.acting, before);
        }
        if const { H::OTHER_TERMS } {
            let Self { q, p, bodies, parameters, .. } = self;
            R::enter(OtherTerms::<H, R, K, D, S> { q, p, bodies: *bodies, parameters, step, time });
        }
    }
    /// The cutoffs, where these make lists of neighbours short in any lane.
    #[inline(always)]
    fn cutoffs<H: ManyBody<D, S, Parameters<R> = P>>(&self, time: f64) -> Option<Cutoffs<D>> {
        // A constant, so that nothing is compiled for lists where there is no cutoff.
        if const { H::LISTED_FROM == usize::MAX } {
            return None;
        }
        if H::LISTED_FROM > self.acting {
            return None;
        }
        Some(Cutoffs::of::<H, R, S>(&self.parameters, time)).filter(Cutoffs::any)
    }
    /// Replaces the densities of all bodies by the derivatives of their energies.
    #[inline(always)]
    fn weigh<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, time: f64) {
        let cutoffs = self.cutoffs::<H>(time);
        let Self { q, constants, neighbours, threads, acting, parameters, .. } = self;
        let rows = acting.div_ceil(WIDTH);
        let (q, bodies, threads) = (&q[..rows], *acting, *threads);
        let sum = Sum::<H, R, _, D, S> { q, constants: &constants[..rows], bodies, parameters, time, threads };
        let densities = densities(sum, neighbours, cutoffs.as_ref());
        for (constants, densities) in constants.iter_mut().zip(&densities) {
            set_densities::<H, _, D, S>(constants, densities);
            let weights = H::weights::<R, R::Row<WIDTH>>(parameters, *constants, time);
            set_densities::<H, _, D, S>(constants, &weights);
        }
    }
    /// The flow of `V` by neighbours; by all pairs in the lanes of members whose cutoff covers the box.
    #[cfg_attr(debug_assertions, inline)]
    fn kick_by_neighbours<H>(&mut self, cutoffs: &Cutoffs<D>, step: R::Row<WIDTH>, time: f64)
    where
        H: ManyBody<D, S, Parameters<R> = P>,
    {
        let covered = !cutoffs.all();
        if covered {
            self.sum_over_pairs::<H>(time);
        }
        let Self { q, p, constants, gradients, neighbours, threads, acting, parameters, .. } = self;
        let rows = acting.div_ceil(WIDTH);
        let (q, constants, p) = (&q[..rows], &constants[..rows], &mut p[..rows]);
        let sum = Sum::<H, R, _, D, S> { q, constants, bodies: *acting, parameters, time, threads: *threads };
        neighbours.kick(sum, cutoffs, covered.then_some(&gradients[..]), step, p);
    }
    /// The kinetic energy, if it is a quadratic form: half the sum of the products of momenta and velocities.
    pub fn kinetic<H: ManyBody<D, S, Parameters<R> = P>>(&self, time: f64) -> R {
        let rows = self.moving.div_ceil(WIDTH);
        let (p, constants) = (&self.p[..rows], &self.constants[..rows]);
        let Self { moving, parameters, .. } = self;
        R::enter(KineticEnergy::<H, R, K, D, S> {
            p,
            constants,
            bodies: *moving,
            parameters,
            time,
            system: PhantomData,
        })
    }
    /// The energy of all pairs, and of all bodies alone.
    pub fn potential<H: ManyBody<D, S, Parameters<R> = P>>(&self, time: f64) -> R {
        let rows = self.acting.div_ceil(WIDTH);
        let (q, constants) = (&self.q[..rows], &self.constants[..rows]);
        let Self { acting, parameters, threads, .. } = self;
        let (bodies, threads) = (*acting, *threads);
        let sum = |constants| Sum::<H, R, _, D, S> { q, constants, bodies, parameters, time, threads };
        let mut neighbours = self.neighbours.clone();
        let with_densities = if const { H::DENSITIES.is_empty() } {
            Vec::new()
        } else {
            self.with_densities::<H>(sum(constants), &mut neighbours)
        };
        let constants = if const { H::DENSITIES.is_empty() } { constants } else { &with_densities };
        let sum = sum(constants);
        let mut total = R::of(0.0);
        if const { H::TRIPLETS } {
            let (neighbours, cutoffs) = (&mut neighbours, self.cutoffs::<H>(time));
            total = R::enter(EnergyOfTriplets { sum: &sum, neighbours, cutoffs: cutoffs.as_ref() });
        }
        // A constant, so that nothing is compiled for lists where there is no cutoff.
        if const { H::LISTED_FROM < usize::MAX }
            && let Some(cutoffs) = self.cutoffs::<H>(time).filter(Cutoffs::all)
        {
            let of_pairs = neighbours.energy(sum, &cutoffs);
            return if const { H::TRIPLETS } { of_pairs + total } else { of_pairs };
        }
        let count = chunks(bodies);
        // Of the type of the gradients, so that `in_chunks` is compiled once.
        let mut sums = zeros::<R::Row<WIDTH>, D>(count);
        in_chunks(&mut sums, count, threads, &|number, sums| {
            sums[0][0] = R::enter(EnergyChunk { sum: &sum, number, count });
        });
        for sum in sums {
            total += over_lanes(sum[0]);
        }
        total
    }
    /// The constants of all bodies, with their densities.
    fn with_densities<H: ManyBody<D, S, Parameters<R> = P>>(
        &self,
        sum: Sum<'_, H, R, K::Slot<R::Row<WIDTH>>, D, S>,
        neighbours: &mut Neighbours<R, D>,
    ) -> Vec<[R::Row<WIDTH>; S]> {
        let (mut constants, cutoffs) = (copied(sum.constants), self.cutoffs::<H>(sum.time));
        let densities = densities(sum, neighbours, cutoffs.as_ref());
        for (constants, densities) in constants.iter_mut().zip(&densities) {
            set_densities::<H, _, D, S>(constants, densities);
        }
        constants
    }
    /// Sums the forces of all pairs, chunk by chunk, and all chunks in their order.
    #[inline(always)]
    fn sum_over_pairs<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, time: f64) {
        let Self { q, constants, gradients, threads, acting, parameters, .. } = self;
        let (rows, bodies, count, system) = (acting.div_ceil(WIDTH), *acting, chunks(*acting), PhantomData);
        let (q, constants) = (&q[..rows], &constants[..rows]);
        gradients.resize(count * rows, [Real::of(0.0); D]);
        let sum = |number: usize, gradient: &mut [[R::Row<WIDTH>; D]]| {
            R::enter(PairChunk::<H, R, K, D, S> {
                q,
                constants,
                bodies,
                parameters,
                time,
                number,
                count,
                gradient,
                system,
            });
        };
        in_chunks(gradients, count, *threads, &sum);
        if count == 1 {
            return;
        }
        let (all, others) = gradients.split_at_mut(rows);
        for other in others.chunks_exact(rows) {
            for row in 0..rows {
                all[row] = add(all[row], other[row]);
            }
        }
    }
    /// The prepared constants of all bodies.
    #[cfg(test)]
    pub(crate) fn constants(&self) -> &[[R::Row<WIDTH>; S]] {
        &self.constants
    }
    /// The motion in the user's own shape, with slots that hold numbers and nothing else.
    pub fn plain<C: Coords<Leaf = f64>>(&self) -> Plain<R, C, P> {
        let flat = |slots: &[[K::Slot<R::Row<WIDTH>>; D]]| {
            C::slots_from(self.bodies * D, |k| {
                let body = k / D;
                slots[body / WIDTH][k % D].value().part(body % WIDTH)
            })
        };
        Plain { q: flat(&self.q), p: flat(&self.p), parameters: self.parameters.clone() }
    }
    /// Returns a motion with these positions and without momenta, with slots that hold numbers and nothing else.
    pub fn at_rest(&self) -> ManyRows<R, f64, P, D, S> {
        ManyRows {
            q: values_of_rows(&self.q),
            p: zeros(self.q.len()),
            constants: copied(&self.constants),
            gradients: Vec::new(),
            neighbours: self.neighbours.clone(),
            threads: self.threads,
            bodies: self.bodies,
            acting: self.acting,
            moving: self.moving,
            parameters: self.parameters.clone(),
        }
    }
    /// Adds a multiple of another motion's momenta.
    pub fn push(&mut self, factor: R, other: &ManyRows<R, f64, P, D, S>) {
        let factor = Row::splat(factor);
        for (slot, number) in self.p.as_flattened_mut().iter_mut().zip(other.p.as_flattened()) {
            slot.fma(factor, *number);
        }
    }
}

impl<R: Real, P, const D: usize, const S: usize> ManyRows<R, f64, P, D, S> {
    /// Sets the momenta from those in the user's own shape.
    pub fn set_momenta<C: Coords<Leaf = f64>>(&mut self, plain: &Plain<R, C, P>) {
        let p = C::slots(&plain.p);
        for (row, rows) in self.p.iter_mut().enumerate() {
            let bodies = bodies_of_row(row, self.bodies);
            for (d, row) in rows.iter_mut().enumerate() {
                *row = row_of::<R, WIDTH>(&bodies, &|body| p[body * D + d]);
            }
        }
    }
}

/// Puts densities, or their weights, among the constants of bodies.
#[inline(always)]
fn set_densities<H: ManyBody<D, S>, W: Copy, const D: usize, const S: usize>(
    constants: &mut [W; S],
    densities: &[W; D],
) {
    for (place, density) in H::DENSITIES.iter().zip(densities) {
        constants[*place] = *density;
    }
}

/// Computes `count` chunks of results on this number of threads.
fn in_chunks<T: Send>(results: &mut [T], count: usize, threads: usize, compute: &(dyn Fn(usize, &mut [T]) + Sync)) {
    if count == 1 {
        return compute(0, results);
    }
    let (each, length) = (count.div_ceil(threads.min(count)), results.len() / count);
    let (mut jobs, mut next) = (Vec::<Job<'_>>::with_capacity(count), 0);
    for results in results.chunks_mut(each * length) {
        let first = next;
        next += each;
        jobs.push(Box::new(move || {
            for (number, results) in (first..).zip(results.chunks_exact_mut(length)) {
                compute(number, results);
            }
        }));
    }
    at_once(jobs);
}

/// The sum of the energies of the bodies of a row, one after the other.
fn over_lanes<R: Real, W: Row<R>>(row: W) -> R {
    let mut total = R::of(0.0);
    for lane in 0..WIDTH {
        total += row.part(lane);
    }
    total
}

/// A chunk of the pairs: those of every `count`th row with itself and with the later rows; where action is not
/// reaction, with all others.
struct PairChunk<'s, H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> {
    q: &'s [[K::Slot<R::Row<WIDTH>>; D]],
    constants: &'s [[R::Row<WIDTH>; S]],
    pub(crate) bodies: usize,
    parameters: &'s H::Parameters<R>,
    time: f64,
    number: usize,
    count: usize,
    gradient: &'s mut [[R::Row<WIDTH>; D]],
    system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> Kernel for PairChunk<'_, H, R, K, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { q, constants, bodies, parameters, time, number, count, gradient, .. } = self;
        let row = |row: usize| Bodies { q: values(&q[row]), constants: constants[row] };
        let last = active_in_last::<R>(bodies);
        let active = |row: usize| last.filter(|_| row + 1 == q.len());
        // Sums begin as a positive zero, so that no bit depends on whether a zero is added to them.
        gradient.fill([Real::of(0.0); D]);
        let mut first = number;
        while first < q.len() {
            let bodies = row(first);
            let own = intra_row::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, active(first), time);
            let mut sum = add(gradient[first], own);
            let mut second = if H::RECIPROCAL { first + 1 } else { 0 };
            while second < q.len() {
                if second != first {
                    let (others, active, sums) = (row(second), active(second), [&mut sum, &mut gradient[second]]);
                    inter_row::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, others, active, time, sums);
                }
                second += 1;
            }
            gradient[first] = sum;
            first += count;
        }
    }
}

/// The energies of a chunk of the pairs, and of the bodies of its rows alone: in every lane, those of its body with others.
struct EnergyChunk<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    sum: &'s Sum<'s, H, R, L, D, S>,
    number: usize,
    count: usize,
}

impl<H: ManyBody<D, S>, R: Real, L: Slot<R::Row<WIDTH>>, const D: usize, const S: usize> Kernel
    for EnergyChunk<'_, H, R, L, D, S>
{
    type Out = R::Row<WIDTH>;
    const APART: bool = true;

    #[inline(always)]
    fn call(self) -> R::Row<WIDTH> {
        let Self { sum: &Sum { q, constants, bodies, parameters, time, .. }, number, count } = self;
        let row = |row: usize| Bodies { q: values(&q[row]), constants: constants[row] };
        let last = active_in_last::<R>(bodies);
        let active = |row: usize| last.filter(|_| row + 1 == q.len());
        let (mut sum, mut first) = (Real::of(0.0), number);
        while first < q.len() {
            let bodies = row(first);
            let alone = H::energy_alone::<R, R::Row<WIDTH>>(parameters, bodies.q, bodies.constants, time);
            if let Some(alone) = alone {
                add_active(&mut sum, alone, active(first));
            }
            intra_energies::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, active(first), time, &mut sum);
            for second in first + 1..q.len() {
                let (others, active) = (row(second), active(second));
                inter_energies::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, others, active, time, &mut sum);
            }
            first += count;
        }
        sum
    }
}

/// The kinetic energies of bodies.
struct KineticEnergy<'s, H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> {
    p: &'s [[K::Slot<R::Row<WIDTH>>; D]],
    constants: &'s [[R::Row<WIDTH>; S]],
    bodies: usize,
    parameters: &'s H::Parameters<R>,
    time: f64,
    system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> Kernel
    for KineticEnergy<'_, H, R, K, D, S>
{
    type Out = R;
    const APART: bool = true;

    #[inline(always)]
    fn call(self) -> R {
        let Self { p, constants, bodies, parameters, time, .. } = self;
        let last = active_in_last::<R>(bodies);
        let active = |row: usize| last.filter(|_| row + 1 == p.len());
        let mut sum = Real::of(0.0);
        for row in 0..p.len() {
            let (p, mut velocity) = (values(&p[row]), [<R::Row<WIDTH> as Real>::of(0.0); D]);
            H::drift_body::<R, R::Row<WIDTH>, _>(parameters, &mut velocity, p, constants[row], Real::of(1.0), time);
            let mut twice = Real::of(0.0);
            for d in 0..D {
                twice = p[d].fma(velocity[d], twice);
            }
            add_active(&mut sum, twice, active(row));
        }
        R::of(0.5) * over_lanes(sum)
    }
}
