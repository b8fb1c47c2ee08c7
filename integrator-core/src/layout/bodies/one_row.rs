//! The layout of a few bodies that act on each other in pairs: one row per coordinate.

use crate::{
    layout::bodies::{
        load_store::{load_constants, pack, row_of, unpack, values},
        pair_sums::{Bodies, BodyConstants, ManyBody, intra_row},
    },
    scalar::{real::Real, simd::row::Row},
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::{
        dissipation::Momenta,
        motion::{Motion, Plain, Prepared},
    },
};

/// `N` bodies with `D` coordinates and `S` prepared constants each, eight at most.
pub struct OneRow<R: Real, K: Precision, P, const N: usize, const D: usize, const S: usize> {
    /// Positions.
    pub q: [K::Slot<R::Row<N>>; D],
    /// Momenta.
    pub p: [K::Slot<R::Row<N>>; D],
    /// The prepared constants of each body.
    constants: [R::Row<N>; S],
    /// Prepared constants.
    pub parameters: P,
}

/// Copies the arrays as wholes: the derived implementation clones each number, which is more code.
impl<R: Real, K: Precision, P: Clone, const N: usize, const D: usize, const S: usize> Clone
    for OneRow<R, K, P, N, D, S>
{
    fn clone(&self) -> Self {
        Self { q: self.q, p: self.p, constants: self.constants, parameters: self.parameters.clone() }
    }
}

impl<C, R, K, P, const N: usize, const D: usize, const S: usize> Motion<C, P::Single> for OneRow<R, K, P, N, D, S>
where
    C: Coords<Leaf = K>,
    R: Real,
    K: Precision,
    P: Prepared<R>,
    P::Single: BodyConstants<S>,
{
    #[inline(always)]
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        Self {
            q: pack::<R, C, N, D>(&(0..N), states, |state| &state.q),
            p: pack::<R, C, N, D>(&(0..N), states, |state| &state.p),
            constants: load_constants::<R, P::Single, N, S>(&(0..N), constants),
            parameters: P::gather(constants),
        }
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        unpack::<R, K, N, D>(&(0..N), &self.q, lane, to.q.flat_mut());
        unpack::<R, K, N, D>(&(0..N), &self.p, lane, to.p.flat_mut());
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        (self.q, self.p) = (from.q, from.p);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        let mut finite = true;
        for slot in self.q.iter().chain(&self.p) {
            finite = finite && slot.value().finite();
        }
        finite
    }
}

impl<R: Real, K: Precision, P, const N: usize, const D: usize, const S: usize> Momenta<R, K>
    for OneRow<R, K, P, N, D, S>
{
    type Wide = R::Row<N>;

    #[inline(always)]
    fn momenta(&mut self) -> &mut [K::Slot<R::Row<N>>] {
        &mut self.p
    }
    fn coordinate(slot: usize, body: usize) -> usize {
        body * D + slot
    }
}

impl<R: Real, K: Precision, P: Prepared<R>, const N: usize, const D: usize, const S: usize> OneRow<R, K, P, N, D, S> {
    /// The flow of `T`. As that of `V`, inlined for certain only where code is optimised: elsewhere every stage of a
    /// composition would have a copy with stack slots of its own.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn drift<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let p = values(&self.p);
        H::drift_body::<R, R::Row<N>, _>(&self.parameters, &mut self.q, p, self.constants, Real::of(duration), time);
    }
    /// The flow of `V`.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn kick<H: ManyBody<D, S, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let bodies = Bodies { q: values(&self.q), constants: self.constants };
        let gradient = intra_row::<H, R, R::Row<N>, N, D, S>(&self.parameters, bodies, None, time);
        let (step, p) = (Real::of(-duration), &mut self.p);
        for d in 0..D {
            p[d].fma(step, gradient[d]);
        }
    }
    /// The motion in the user's own shape, with slots that hold numbers and nothing else.
    pub fn plain<C: Coords<Leaf = f64>>(&self) -> Plain<R, C, P> {
        let flat = |slots: &[K::Slot<R::Row<N>>; D]| C::slots_from(N * D, |k| slots[k % D].value().part(k / D));
        Plain { q: flat(&self.q), p: flat(&self.p), parameters: self.parameters.clone() }
    }
    /// Returns a motion with these positions and without momenta, with slots that hold numbers and nothing else.
    #[inline(always)]
    pub fn at_rest(&self) -> OneRow<R, f64, P, N, D, S> {
        let (q, p) = (values(&self.q), [Real::of(0.0); D]);
        OneRow { q, p, constants: self.constants, parameters: self.parameters.clone() }
    }
    /// Adds a multiple of another motion's momenta.
    #[inline(always)]
    pub fn push(&mut self, factor: R, other: &OneRow<R, f64, P, N, D, S>) {
        let factor = Row::splat(factor);
        for d in 0..D {
            self.p[d].fma(factor, other.p[d]);
        }
    }
}

impl<R: Real, P, const N: usize, const D: usize, const S: usize> OneRow<R, f64, P, N, D, S> {
    /// Sets the momenta from those in the user's own shape.
    pub fn set_momenta<C: Coords<Leaf = f64>>(&mut self, plain: &Plain<R, C, P>) {
        let p = C::slots(&plain.p);
        for (d, row) in self.p.iter_mut().enumerate() {
            *row = row_of::<R, N>(&(0..N), &|body| p[body * D + d]);
        }
    }
}
