//! The layout of many bodies that act on each other in pairs: rows of eight, one row per coordinate.

use crate::{
    layout::{
        bodies::{
            load_store::{of_bodies, of_place, pack, prepared, unpack, values},
            many_body::{Bodies, ManyBody, PerBody, add, between, within},
        },
        threads::{Job, all_threads, at_once},
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
    system::motion::{Motion, Plain, Prepared},
};
use alloc::{boxed::Box, vec::Vec};
use core::{marker::PhantomData, ops::Range};

/// How many bodies a tile has, whatever the hardware: the order of sums depends on it.
const WIDTH: usize = 8;

/// From how many tiles on the pairs are summed in shares, and in how many: a thousand bodies are done before another
/// thread has started. The order of sums depends on these, and not on the number of threads.
const MANY: usize = 256;
const SHARES: usize = 8;

/// Any number of bodies with `D` coordinates and `S` prepared constants each. The last tile may have fewer bodies than
/// places; what is behind them never acts on anything.
pub struct Tiles<R: Real, K: Precision, P, const D: usize, const S: usize> {
    /// Positions.
    pub q: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// Momenta.
    pub p: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// What is prepared of each body.
    of: Vec<[R::Row<WIDTH>; S]>,
    /// Where forces are summed, share after share; in the end all of them are in the first.
    gradients: Vec<[R::Row<WIDTH>; D]>,
    /// How many threads may take shares.
    threads: usize,
    /// How many bodies there are.
    bodies: usize,
    /// Prepared constants.
    pub parameters: P,
}

/// The bodies of a tile, of so many in all.
fn in_tile(tile: usize, bodies: usize) -> Range<usize> {
    tile * WIDTH..bodies.min((tile + 1) * WIDTH)
}

/// In how many shares the pairs of so many bodies are summed.
const fn shares(bodies: usize) -> usize {
    if bodies < MANY * WIDTH { 1 } else { SHARES }
}

/// The same rows once more.
fn copied<T: Copy>(rows: &[T]) -> Vec<T> {
    let mut copied = Vec::with_capacity(rows.len());
    for row in rows {
        copied.push(*row);
    }
    copied
}

/// Rows of zeros.
fn zeros<W: Real, const D: usize>(tiles: usize) -> Vec<[W; D]> {
    let mut zeros = Vec::with_capacity(tiles);
    for _ in 0..tiles {
        zeros.push([W::of(0.0); D]);
    }
    zeros
}

/// What slots hold, row by row.
fn held<W: Real, L: Slot<W>, const D: usize>(slots: &[[L; D]]) -> Vec<[W; D]> {
    let mut held = Vec::with_capacity(slots.len());
    for slots in slots {
        held.push(values(slots));
    }
    held
}

/// Whether so many lanes of rows are finite. Places behind the last body drift on without a force, and may leave the finite
/// numbers when no body does.
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

impl<R: Real, K: Precision, P: Clone, const D: usize, const S: usize> Clone for Tiles<R, K, P, D, S> {
    fn clone(&self) -> Self {
        Self {
            q: copied(&self.q),
            p: copied(&self.p),
            of: copied(&self.of),
            gradients: copied(&self.gradients),
            threads: self.threads,
            bodies: self.bodies,
            parameters: self.parameters.clone(),
        }
    }
}

impl<C, R, K, P, const D: usize, const S: usize> Motion<C, P::Single> for Tiles<R, K, P, D, S>
where
    C: Coords<Leaf = K>,
    R: Real,
    K: Precision,
    P: Prepared<R>,
    P::Single: PerBody<S>,
{
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        let bodies = states[0].q.length();
        let tiles = bodies.div_ceil(WIDTH);
        let (mut q, mut p) = (Vec::with_capacity(tiles), Vec::with_capacity(tiles));
        let mut of = Vec::with_capacity(tiles);
        for tile in 0..tiles {
            let bodies = in_tile(tile, bodies);
            q.push(pack::<R, C, WIDTH, D>(&bodies, states, |state| &state.q));
            p.push(pack::<R, C, WIDTH, D>(&bodies, states, |state| &state.p));
            of.push(prepared::<R, P::Single, WIDTH, S>(&bodies, constants));
        }
        let (gradients, parameters) = (zeros(shares(bodies) * tiles), P::gather(constants));
        Self { q, p, of, gradients, threads: 1, bodies, parameters }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        for tile in 0..self.q.len() {
            let bodies = in_tile(tile, self.bodies);
            unpack::<R, K, WIDTH, D>(&bodies, &self.q[tile], lane, to.q.flat_mut());
            unpack::<R, K, WIDTH, D>(&bodies, &self.p[tile], lane, to.p.flat_mut());
        }
    }
    fn copy_state(&mut self, from: &Self) {
        self.q.copy_from_slice(&from.q);
        self.p.copy_from_slice(&from.p);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.threads = threads.unwrap_or_else(all_threads).clamp(1, SHARES);
    }
    fn finite(&self) -> bool {
        let lanes = self.bodies * R::LANES;
        finite::<R::Row<WIDTH>, _, D>(&self.q, lanes) && finite::<R::Row<WIDTH>, _, D>(&self.p, lanes)
    }
}

impl<R: Real, K: Precision, P: Prepared<R>, const D: usize, const S: usize> Tiles<R, K, P, D, S> {
    /// The flow of `T`. As that of `V`, inlined for certain only where code is optimised: elsewhere every stage of a
    /// composition would have a copy with its own place on the stack.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn drift<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let step = Real::of(duration);
        let Self { q, p, of, parameters, .. } = self;
        for tile in 0..q.len() {
            H::drift_of::<R, R::Row<WIDTH>, _>(parameters, &mut q[tile], values(&p[tile]), of[tile], step, time);
        }
    }
    /// The flow of `V`.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn kick<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        self.sum_forces::<H>(time);
        let step = Real::of(-duration);
        let Self { p, gradients, .. } = self;
        for tile in 0..p.len() {
            let (p, gradient) = (&mut p[tile], &gradients[tile]);
            for d in 0..D {
                p[d].fma(step, gradient[d]);
            }
        }
    }
    /// Sums what acts on each body, share by share, and all shares in their order.
    #[inline(always)]
    fn sum_forces<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, time: f64) {
        let Self { q, of, gradients, threads, bodies, parameters, .. } = self;
        let (tiles, bodies, count, system) = (q.len(), *bodies, shares(*bodies), PhantomData);
        let sum = |number: usize, gradient: &mut [[R::Row<WIDTH>; D]]| {
            R::enter(Share::<H, R, K, D, S> { q, of, bodies, parameters, time, number, count, gradient, system });
        };
        if count == 1 {
            return sum(0, gradients);
        }
        let (each, sum) = (count.div_ceil(*threads), &sum);
        let (mut jobs, mut next) = (Vec::<Job<'_>>::with_capacity(count), 0);
        for gradients in gradients.chunks_mut(each * tiles) {
            let first = next;
            next += each;
            jobs.push(Box::new(move || {
                for (number, gradient) in (first..).zip(gradients.chunks_exact_mut(tiles)) {
                    sum(number, gradient);
                }
            }));
        }
        at_once(jobs);
        let (all, others) = gradients.split_at_mut(tiles);
        for other in others.chunks_exact(tiles) {
            for tile in 0..tiles {
                all[tile] = add(all[tile], other[tile]);
            }
        }
    }
    /// The motion in the user's own shape, with slots that hold numbers and nothing else.
    pub fn plain<C: Coords<Leaf = f64>>(&self) -> Plain<R, C, P> {
        let flat = |slots: &[[K::Slot<R::Row<WIDTH>>; D]]| {
            C::slots_from(self.bodies * D, |k| {
                let body = k / D;
                of_place(slots[body / WIDTH][k % D].value(), body % WIDTH)
            })
        };
        Plain { q: flat(&self.q), p: flat(&self.p), parameters: self.parameters.clone() }
    }
    /// The same positions and no momenta, with slots that hold numbers and nothing else.
    pub fn at_rest(&self) -> Tiles<R, f64, P, D, S> {
        Tiles {
            q: held(&self.q),
            p: zeros(self.q.len()),
            of: copied(&self.of),
            gradients: copied(&self.gradients),
            threads: self.threads,
            bodies: self.bodies,
            parameters: self.parameters.clone(),
        }
    }
    /// Adds a multiple of the momenta of another motion.
    pub fn push(&mut self, factor: R, other: &Tiles<R, f64, P, D, S>) {
        let factor = Row::splat(factor);
        for (slot, number) in self.p.as_flattened_mut().iter_mut().zip(other.p.as_flattened()) {
            slot.fma(factor, *number);
        }
    }
}

impl<R: Real, P, const D: usize, const S: usize> Tiles<R, f64, P, D, S> {
    /// Takes over momenta in the user's own shape.
    pub fn set_momenta<C: Coords<Leaf = f64>>(&mut self, plain: &Plain<R, C, P>) {
        let p = C::slots(&plain.p);
        for (tile, rows) in self.p.iter_mut().enumerate() {
            let bodies = in_tile(tile, self.bodies);
            for (d, row) in rows.iter_mut().enumerate() {
                *row = of_bodies::<R, WIDTH>(&bodies, &|body| p[body * D + d]);
            }
        }
    }
}

/// A share of the pairs: those of every `count`th tile with itself and with the tiles behind it; where action is not
/// reaction, with all others.
struct Share<'s, H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> {
    q: &'s [[K::Slot<R::Row<WIDTH>>; D]],
    of: &'s [[R::Row<WIDTH>; S]],
    bodies: usize,
    parameters: &'s H::Parameters<R>,
    time: f64,
    number: usize,
    count: usize,
    gradient: &'s mut [[R::Row<WIDTH>; D]],
    system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> Kernel for Share<'_, H, R, K, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { q, of, bodies, parameters, time, number, count, gradient, .. } = self;
        let tile = |tile: usize| Bodies { q: values(&q[tile]), of: of[tile] };
        let (last, rest) = (q.len().saturating_sub(1), bodies % WIDTH);
        let present = Real::parameter(&|lane| if lane / R::LANES < rest { 1.0 } else { 0.0 });
        let present = |tile: usize| {
            let partly = tile == last && rest > 0;
            partly.then_some(present)
        };
        // Sums begin as a zero without a sign, so that no bit tells whether a zero is added to them.
        gradient.fill([Real::of(0.0); D]);
        let mut first = number;
        while first < q.len() {
            let bodies = tile(first);
            let own = within::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, present(first), time);
            let mut sum = add(gradient[first], own);
            let mut second = if H::RECIPROCAL { first + 1 } else { 0 };
            while second < q.len() {
                if second != first {
                    let (others, present, sums) = (tile(second), present(second), [&mut sum, &mut gradient[second]]);
                    between::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, others, present, time, sums);
                }
                second += 1;
            }
            gradient[first] = sum;
            first += count;
        }
    }
}
