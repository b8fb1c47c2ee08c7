//! The extended phase space of a Hamiltonian that does not separate: two copies of the state, which a coupling keeps
//! together (Tao 2016, Phys. Rev. E 94, 043303).
//!
//! In: `H(q, p)` as the flows of `H(q, y)` and of `H(x, p)`, each of which moves what it does not read. Out: a motion of
//! `(q, p, x, y)` with the flow of the coupling `ω (|q − x|² + |p − y|²)/2`, a rotation of both differences by the angle
//! `2 ω t`. Always true: both copies begin at the state that is loaded, and `(q, p)` is the one that is shown.

use crate::{
    scalar::real::Real,
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::motion::{Motion, Moved, Prepared, Read},
};
use alloc::vec::Vec;

/// Two copies of the state, with prepared constants.
#[derive(Clone)]
pub struct Doubled<R: Real, C: Coords, P> {
    /// Positions.
    pub q: C::Slots<R>,
    /// Momenta.
    pub p: C::Slots<R>,
    /// The copy of the positions.
    pub x: C::Slots<R>,
    /// The copy of the momenta.
    pub y: C::Slots<R>,
    /// Prepared constants.
    pub parameters: P,
}

/// The coordinates that a flow reads, and those that it moves.
type Apart<'m, S, P> = (Read<'m, S, P>, Moved<'m, S>);

impl<R: Real, C: Coords, P> Doubled<R, C, P> {
    /// Returns the coordinates that the flow of `H(q, y)` reads, and those that it moves.
    #[inline(always)]
    pub fn first(&mut self) -> Apart<'_, C::Slots<R>, P> {
        let Self { q, p, x, y, parameters } = self;
        (Read { q, p: y, parameters }, Moved { q: x, p })
    }

    /// Returns the coordinates that the flow of `H(x, p)` reads, and those that it moves.
    #[inline(always)]
    pub fn second(&mut self) -> Apart<'_, C::Slots<R>, P> {
        let Self { q, p, x, y, parameters } = self;
        (Read { q: x, p, parameters }, Moved { q, p: y })
    }

    /// The flow of the coupling: the sums of both copies stay, and their differences rotate.
    #[inline(always)]
    pub fn rotate(&mut self, coupling: R, duration: f64) {
        let (sine, cosine) = (coupling * R::of(duration)).sin_cos();
        // Of the double angle: sin 2a / 2, and (cos 2a - 1) / 2 without cancellation.
        let (turned, shortened) = (sine * cosine, -(sine * sine));
        let [q, p, x, y] = [&mut self.q, &mut self.p, &mut self.x, &mut self.y].map(C::slots_mut);
        for (((q, p), x), y) in q.iter_mut().zip(p).zip(x).zip(y) {
            let (position, momentum) = (q.value() - x.value(), p.value() - y.value());
            let moved = shortened.fma(position, turned * momentum);
            let kicked = shortened.fma(momentum, -(turned * position));
            q.add(moved);
            x.add(-moved);
            p.add(kicked);
            y.add(-kicked);
        }
    }
}

impl<R: Real, C: Coords, P: Prepared<R>> Motion<C, P::Single> for Doubled<R, C, P> {
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        let (q, p) = (C::pack(states, |state| &state.q), C::pack(states, |state| &state.p));
        Self { x: q.clone(), y: p.clone(), q, p, parameters: P::gather(constants) }
    }
    fn gathered<'a>(of_lane: &dyn Fn(usize) -> (&'a P::Single, &'a Self, usize)) -> Option<Self>
    where
        P::Single: 'a,
    {
        let half = |half: fn(&Self) -> &C::Slots<R>| {
            let slots = |lane: usize| {
                let (_, motion, lane) = of_lane(lane);
                (C::slots(half(motion)), lane)
            };
            let leaf = |coordinate: usize| {
                move |(slots, lane): (&[<C::Leaf as Precision>::Slot<R>], usize)| {
                    C::Leaf::unpack(slots[coordinate], lane)
                }
            };
            C::slots_from(slots(0).0.len(), |coordinate| C::Leaf::pack(&|lane| leaf(coordinate)(slots(lane))))
        };
        let constants: Vec<_> = (0..R::LANES).map(|lane| of_lane(lane).0).collect();
        Some(Self {
            q: half(|motion| &motion.q),
            p: half(|motion| &motion.p),
            x: half(|motion| &motion.x),
            y: half(|motion| &motion.y),
            parameters: P::gather(&constants),
        })
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        to.q.unpack(&self.q, lane);
        to.p.unpack(&self.p, lane);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.q.clone_from(&from.q);
        self.p.clone_from(&from.p);
        self.x.clone_from(&from.x);
        self.y.clone_from(&from.y);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        [&self.q, &self.p, &self.x, &self.y].into_iter().all(C::finite)
    }
}
