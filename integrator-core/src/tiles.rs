//! The layout of many bodies that act on each other in pairs: rows of eight, one row per coordinate.

use crate::{
    coords::Coords,
    many_body::{Bodies, ManyBody, PerBody, add, between, within},
    motion::{Motion, Plain, Prepared},
    phase::Phase,
    real::{Kernel, Real},
    row::{Row, inward, of_bodies, of_place, outward, prepared, values},
    slot::{Keep, Slot},
    threads::{all_threads, at_once},
};
use alloc::{vec, vec::Vec};
use core::{marker::PhantomData, ops::Range};

/// How many bodies a tile has, whatever the hardware: the order of sums depends on it.
const WIDTH: usize = 8;

/// From how many tiles on the pairs are summed in shares, and in how many: a thousand bodies are done before another
/// thread has started. The order of sums depends on these, and not on the number of threads.
const MANY: usize = 256;
const SHARES: usize = 8;

/// Any number of bodies with `D` coordinates and `S` prepared constants each. The last tile may have fewer bodies than
/// places; what is behind them never acts on anything.
#[derive(Clone)]
pub struct Tiles<R: Real, K: Keep, P, const D: usize, const S: usize> {
    /// Positions.
    pub q: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// Momenta.
    pub p: Vec<[K::Slot<R::Row<WIDTH>>; D]>,
    /// What is prepared of each body.
    of: Vec<[R::Row<WIDTH>; S]>,
    /// Where forces are summed, by shares; in the end all of them are in the first.
    gradients: Vec<Vec<[R::Row<WIDTH>; D]>>,
    /// How many threads may take shares.
    threads: usize,
    /// How many bodies there are.
    bodies: usize,
    /// Prepared constants.
    pub parameters: P,
}

/// The bodies of each tile.
fn tiles(bodies: usize) -> impl Iterator<Item = Range<usize>> {
    (0..bodies).step_by(WIDTH).map(move |first| first..bodies.min(first + WIDTH))
}

/// One element for each tile.
fn by_tile<T>(bodies: usize, element: &dyn Fn(Range<usize>) -> T) -> Vec<T> {
    let mut elements = Vec::with_capacity(bodies.div_ceil(WIDTH));
    for tile in tiles(bodies) {
        elements.push(element(tile));
    }
    elements
}

impl<C, R, K, P, const D: usize, const S: usize> Motion<C, P::Single> for Tiles<R, K, P, D, S>
where
    C: Coords<Leaf = K>,
    R: Real,
    K: Keep,
    P: Prepared<R>,
    P::Single: PerBody<S>,
{
    fn load<'a>(of_lane: &dyn Fn(usize) -> (&'a P::Single, &'a Phase<C>)) -> Self
    where
        P::Single: 'a,
    {
        let bodies = of_lane(0).1.q.length();
        let shares = if bodies < MANY * WIDTH { 1 } else { SHARES };
        let slots = |leaf: &dyn Fn(usize, usize) -> K| by_tile(bodies, &|tile| inward::<R, K, WIDTH, D>(tile, leaf));
        Self {
            q: slots(&|lane, k| of_lane(lane).1.q.flat()[k]),
            p: slots(&|lane, k| of_lane(lane).1.p.flat()[k]),
            of: by_tile(bodies, &|tile| prepared::<R, WIDTH, S>(tile, &|lane, body| of_lane(lane).0.per_body(body))),
            gradients: vec![vec![[Real::of(0.0); D]; bodies.div_ceil(WIDTH)]; shares],
            threads: 1,
            bodies,
            parameters: P::gather(&|lane| of_lane(lane).0),
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        for (tile, (q, p)) in tiles(self.bodies).zip(self.q.iter().zip(&self.p)) {
            outward::<R, K, WIDTH, D>(tile.clone(), q, lane, to.q.flat_mut());
            outward::<R, K, WIDTH, D>(tile, p, lane, to.p.flat_mut());
        }
    }
    fn copy_state(&mut self, from: &Self) {
        self.q.clone_from(&from.q);
        self.p.clone_from(&from.p);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.threads = threads.unwrap_or_else(all_threads).clamp(1, SHARES);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        // Places behind the last body drift on without a force, and may leave the finite numbers when no body does.
        let finite = |slots: &[[K::Slot<R::Row<WIDTH>>; D]]| {
            tiles(self.bodies).zip(slots).all(|(tile, slots)| {
                let lanes = tile.len() * R::LANES;
                slots.iter().all(|slot| {
                    let row = slot.value();
                    row.finite() || (0..lanes).all(|lane| row.lane(lane).is_finite())
                })
            })
        };
        finite(&self.q) && finite(&self.p)
    }
}

impl<R: Real, K: Keep, P: Prepared<R>, const D: usize, const S: usize> Tiles<R, K, P, D, S> {
    /// The flow of `T`. As that of `V`, inlined for certain only where code is optimised: elsewhere every stage of a
    /// composition would have a copy with its own place on the stack.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn drift<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let step = Real::of(duration);
        for ((q, p), of) in self.q.iter_mut().zip(&self.p).zip(&self.of) {
            H::drift_of::<R, R::Row<WIDTH>, _>(&self.parameters, q, values(p), *of, step, time);
        }
    }
    /// The flow of `V`.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn kick<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        self.sum_forces::<H>(time);
        let step = Real::of(-duration);
        for (p, gradient) in self.p.iter_mut().zip(&self.gradients[0]) {
            for (p, gradient) in p.iter_mut().zip(gradient) {
                p.fma(step, *gradient);
            }
        }
    }
    /// Sums what acts on each body, share by share, and all shares in their order.
    #[inline(always)]
    fn sum_forces<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, time: f64) {
        let Self { q, of, gradients, threads, bodies, parameters, .. } = self;
        let count = gradients.len();
        let sum = |first: usize, gradients: &mut [Vec<[R::Row<WIDTH>; D]>]| {
            for (number, gradient) in (first..).zip(gradients) {
                R::enter(Share::<H, R, K, D, S> {
                    q,
                    of,
                    bodies: *bodies,
                    parameters,
                    time,
                    number,
                    count,
                    gradient,
                    system: PhantomData,
                });
            }
        };
        if (*threads).min(count) == 1 {
            sum(0, gradients);
        } else {
            let each = count.div_ceil(*threads);
            at_once(gradients.chunks_mut(each).enumerate().collect(), |(group, gradients)| {
                sum(group * each, gradients);
            });
        }
        if let Some((all, others)) = gradients.split_first_mut() {
            for other in others {
                all.iter_mut().zip(other).for_each(|(sum, other)| *sum = add(*sum, *other));
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
            q: self.q.iter().map(values).collect(),
            p: self.q.iter().map(|_| [Real::of(0.0); D]).collect(),
            of: self.of.clone(),
            gradients: self.gradients.clone(),
            threads: self.threads,
            bodies: self.bodies,
            parameters: self.parameters.clone(),
        }
    }
    /// Adds a multiple of the momenta of another motion.
    pub fn push(&mut self, factor: R, other: &Tiles<R, f64, P, D, S>) {
        let factor = Row::splat(factor);
        for (slot, number) in self.p.iter_mut().flatten().zip(other.p.iter().flatten()) {
            slot.fma(factor, *number);
        }
    }
}

impl<R: Real, P, const D: usize, const S: usize> Tiles<R, f64, P, D, S> {
    /// Takes over momenta in the user's own shape.
    pub fn set_momenta<C: Coords<Leaf = f64>>(&mut self, plain: &Plain<R, C, P>) {
        let p = C::slots(&plain.p);
        let row = |tile: Range<usize>, d| of_bodies::<R, WIDTH>(tile, &|body| p[body * D + d]);
        self.p = by_tile(self.bodies, &|tile| core::array::from_fn(|d| row(tile.clone(), d)));
    }
}

/// A share of the pairs: those of every `count`th tile with itself and with the tiles behind it; where action is not
/// reaction, with all others.
struct Share<'s, H: ManyBody<D, S>, R: Real, K: Keep, const D: usize, const S: usize> {
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

impl<H: ManyBody<D, S>, R: Real, K: Keep, const D: usize, const S: usize> Kernel for Share<'_, H, R, K, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { q, of, bodies, parameters, time, number, count, gradient, .. } = self;
        let tile = |tile: usize| Bodies { q: values(&q[tile]), of: of[tile] };
        let (last, rest) = (q.len().saturating_sub(1), bodies % WIDTH);
        let present = (rest > 0).then(|| Real::parameter(&|lane| if lane / R::LANES < rest { 1.0 } else { 0.0 }));
        let present = |tile: usize| if tile == last { present } else { None };
        // Sums begin as a zero without a sign, so that no bit tells whether a zero is added to them.
        gradient.fill([Real::of(0.0); D]);
        for first in (number..q.len()).step_by(count) {
            let bodies = tile(first);
            let own = within::<H, R, R::Row<WIDTH>, WIDTH, D, S>(parameters, bodies, present(first), time);
            let mut sum = add(gradient[first], own);
            let others = if H::RECIPROCAL { first + 1..q.len() } else { 0..q.len() };
            for second in others.filter(|second| *second != first) {
                let sums = [&mut sum, &mut gradient[second]];
                between::<H, R, R::Row<WIDTH>, WIDTH, D, S>(
                    parameters,
                    bodies,
                    tile(second),
                    present(second),
                    time,
                    sums,
                );
            }
            gradient[first] = sum;
        }
    }
}
