//! The layout of many bodies that act on each other in pairs: rows of eight, one row per coordinate.

use crate::{
    coords::Coords,
    hamiltonian::{Motion, Plain, Prepared},
    many_body::{Bodies, ManyBody, PerBody, add, between, within},
    phase::Phase,
    real::Real,
    row::{Row, inward, of_bodies, of_place, outward, prepared, values},
    slot::{Keep, Slot},
};
use alloc::vec::Vec;
use core::ops::Range;

/// How many bodies a tile has, whatever the hardware: the order of sums depends on it.
const WIDTH: usize = 8;

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
    /// Where forces are summed.
    gradient: Vec<[R::Row<WIDTH>; D]>,
    /// How many bodies there are.
    bodies: usize,
    /// Prepared constants.
    pub parameters: P,
}

/// The bodies of each tile.
fn tiles(bodies: usize) -> impl Iterator<Item = Range<usize>> {
    (0..bodies).step_by(WIDTH).map(move |first| first..bodies.min(first + WIDTH))
}

impl<C, R, K, P, const D: usize, const S: usize> Motion<C, P::Single> for Tiles<R, K, P, D, S>
where
    C: Coords<Leaf = K>,
    R: Real,
    K: Keep,
    P: Prepared<R>,
    P::Single: PerBody<S>,
{
    fn load<'a>(of_lane: impl Fn(usize) -> (&'a P::Single, &'a Phase<C>)) -> Self
    where
        P::Single: 'a,
    {
        let bodies = of_lane(0).1.q.length();
        let q = tiles(bodies).map(|tile| inward::<R, K, WIDTH, D>(tile, |lane, k| of_lane(lane).1.q.flat()[k]));
        let p = tiles(bodies).map(|tile| inward::<R, K, WIDTH, D>(tile, |lane, k| of_lane(lane).1.p.flat()[k]));
        let of = tiles(bodies).map(|tile| prepared::<R, WIDTH, S>(tile, |lane, body| of_lane(lane).0.per_body(body)));
        Self {
            q: q.collect(),
            p: p.collect(),
            of: of.collect(),
            gradient: tiles(bodies).map(|_| [Real::of(0.0); D]).collect(),
            bodies,
            parameters: P::gather(|lane| of_lane(lane).0),
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
        for (p, gradient) in self.p.iter_mut().zip(&self.gradient) {
            for (p, gradient) in p.iter_mut().zip(gradient) {
                p.fma(step, *gradient);
            }
        }
    }
    /// Sums what acts on each body: tile by tile from within it and alone, then from the tiles behind it; where action is
    /// not reaction, from all others.
    #[inline(always)]
    fn sum_forces<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, time: f64) {
        let tile = |tile: usize| Bodies { q: values(&self.q[tile]), of: self.of[tile] };
        let (last, rest) = (self.q.len().saturating_sub(1), self.bodies % WIDTH);
        let present = (rest > 0).then(|| Real::parameter(|lane| if lane / R::LANES < rest { 1.0 } else { 0.0 }));
        let present = |tile: usize| if tile == last { present } else { None };
        for first in 0..self.q.len() {
            let bodies = tile(first);
            let sum = within::<H, R, R::Row<WIDTH>, WIDTH, D, S>(&self.parameters, bodies, present(first), time);
            // No zero with a sign, so that no bit tells whether a zero is added to it.
            self.gradient[first] = add(sum, [Real::of(0.0); D]);
        }
        for first in 0..self.q.len() {
            let bodies = tile(first);
            let others = if H::RECIPROCAL { first + 1..self.q.len() } else { 0..self.q.len() };
            let mut sum = self.gradient[first];
            for second in others.filter(|second| *second != first) {
                between::<H, R, R::Row<WIDTH>, WIDTH, D, S>(
                    &self.parameters,
                    bodies,
                    tile(second),
                    present(second),
                    time,
                    [&mut sum, &mut self.gradient[second]],
                );
            }
            self.gradient[first] = sum;
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
            gradient: self.gradient.clone(),
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
        let row = |tile: Range<usize>, d| of_bodies::<R, WIDTH>(tile, |body| p[body * D + d]);
        self.p = tiles(self.bodies).map(|tile| core::array::from_fn(|d| row(tile.clone(), d))).collect();
    }
}
