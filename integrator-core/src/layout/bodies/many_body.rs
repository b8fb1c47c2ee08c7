//! Bodies that act on each other in pairs: what a system says of one pair, and the sums over all pairs of a row or two.
//!
//! Always true: pairs are taken in the order of rotations, which no hardware decides, so that every sum has the same bits
//! whatever a row is made of; what stands behind the last body changes no sum.

use crate::{
    hamiltonian::Hamiltonian,
    layout::lattice::stencil::Array,
    scalar::{real::Real, simd::row::Row},
    state::precision::Slot,
};

/// What is prepared of each body.
pub trait PerBody<const S: usize> {
    /// What is prepared of a body.
    fn per_body(&self, body: usize) -> [f64; S];
}

/// A Hamiltonian of bodies with `D` coordinates and `S` prepared constants each, whose potential is a sum over pairs,
/// and over bodies. Written by `#[hamiltonian]`.
pub trait ManyBody<const D: usize, const S: usize>: Hamiltonian {
    /// Whether action is reaction: the force on the second body is that on the first, with another sign.
    const RECIPROCAL: bool;
    /// Whether forces are told as what the displacement from the second body to the first is to be multiplied by.
    const CENTRAL: bool;
    /// One number where forces are central, else one per coordinate.
    type Force<W: Copy>: Array<W>;

    /// The flow of `T` on one body.
    fn drift_of<R: Real, W: Row<R>, L: Slot<W>>(
        parameters: &Self::Parameters<R>,
        q: &mut [L; D],
        p: [W; D],
        of: [W; S],
        step: W,
        time: f64,
    );
    /// The gradient of the energy of a pair by the coordinates of the first body, or what the displacement is to be
    /// multiplied by. The energy stays the same if the two are exchanged.
    fn pair<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        of_i: [W; S],
        of_j: [W; S],
        time: f64,
    ) -> Self::Force<W>;
    /// Whether any two bodies in the same place of two rows act on each other; if not, the gradient is zero, and not
    /// computed.
    #[inline(always)]
    fn acts<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        of_i: [W; S],
        of_j: [W; S],
        time: f64,
    ) -> bool {
        let _ = (parameters, q_i, q_j, of_i, of_j, time);
        true
    }
    /// The gradient of the energy that a body has alone, if it has any.
    #[inline(always)]
    fn alone<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, q: [W; D], of: [W; S], time: f64) -> Option<[W; D]> {
        let _ = (parameters, q, of, time);
        None
    }
}

/// Bodies side by side: their positions and prepared constants.
#[derive(Clone, Copy)]
pub struct Bodies<W, const D: usize, const S: usize> {
    /// Positions.
    pub q: [W; D],
    /// What is prepared of each.
    pub of: [W; S],
}

impl<W: Real, const D: usize, const S: usize> Bodies<W, D, S> {
    #[inline(always)]
    fn rotated<R: Real, const N: usize>(self, by: usize) -> Self
    where
        W: Row<R>,
    {
        Self { q: rotated::<R, W, N, D>(self.q, by), of: rotated::<R, W, N, S>(self.of, by) }
    }
    /// One of the bodies of rows that are made of parts.
    #[inline(always)]
    fn part<R: Real>(&self, part: usize) -> Bodies<R, D, S>
    where
        W: Row<R>,
    {
        let zero = R::of(0.0);
        let mut one = Bodies { q: [zero; D], of: [zero; S] };
        for (one, all) in one.q.iter_mut().zip(&self.q).chain(one.of.iter_mut().zip(&self.of)) {
            *one = all.parts()[part];
        }
        one
    }
}

// Plain loops: what they call belongs to a clone, and a closure might be compiled outside of it.

#[inline(always)]
fn rotated<R: Real, W: Row<R>, const N: usize, const D: usize>(mut rows: [W; D], by: usize) -> [W; D] {
    for row in &mut rows {
        *row = row.rotated::<N>(by);
    }
    rows
}

#[inline(always)]
pub(crate) fn add<W: Real, const D: usize>(mut a: [W; D], b: [W; D]) -> [W; D] {
    for d in 0..D {
        a[d] += b[d];
    }
    a
}

#[inline(always)]
fn sub<W: Real, const D: usize>(mut a: [W; D], b: [W; D]) -> [W; D] {
    for d in 0..D {
        a[d] -= b[d];
    }
    a
}

/// What the system says of each body and the one in the same place of another row.
#[inline(always)]
fn pairs<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    [i, j]: [Bodies<W, D, S>; 2],
    time: f64,
) -> H::Force<W>
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        return H::pair::<R, W>(parameters, i.q, j.q, i.of, j.of, time);
    }
    let mut forces = H::Force::<W>::filled(W::of(0.0));
    for part in 0..W::PARTS {
        let (i, j) = (i.part::<R>(part), j.part::<R>(part));
        let force = H::pair::<R, R>(parameters, i.q, j.q, i.of, j.of, time);
        for (forces, force) in forces.as_mut().iter_mut().zip(force.as_ref()) {
            forces.parts_mut()[part] = *force;
        }
    }
    forces
}

/// From the second of two rows to the first.
#[inline(always)]
fn displacement<W: Real, const D: usize, const S: usize>([i, j]: [Bodies<W, D, S>; 2]) -> [W; D] {
    sub(i.q, j.q)
}

/// The components of the force between two rows.
#[inline(always)]
fn components<H: ManyBody<D, S>, W: Real, const D: usize, const S: usize>(
    force: H::Force<W>,
    bodies: [Bodies<W, D, S>; 2],
) -> [W; D] {
    let mut components = displacement(bodies);
    let force = force.as_ref();
    for d in 0..D {
        components[d] = if H::CENTRAL { force[0] * components[d] } else { force[d] };
    }
    components
}

/// Which places of a row hold bodies: one there, zero elsewhere. Nothing where all do.
pub(crate) type Present<W> = Option<W>;

/// The force where a body is there to exert or to feel it.
#[inline(always)]
fn acting<W: Real, const D: usize>(mut force: [W; D], present: Present<W>) -> [W; D] {
    if let Some(present) = present {
        let zero = W::of(0.0);
        for force in &mut force {
            *force = W::select(zero.less(present), *force, zero);
        }
    }
    force
}

/// What acts on each of the `N` bodies of a row from the others and alone, as the gradient of the energy.
///
/// In turn `s` each body is paired with the one `s` places further on. Where action is reaction, half a round will do; of
/// an even number of bodies, the turn by half a round meets every pair twice, once from either side.
#[inline(always)]
pub(crate) fn within<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    present: Present<W>,
    time: f64,
) -> [W; D]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let mut sum = H::alone::<R, W>(parameters, bodies.q, bodies.of, time);
    // Written out, so that the rotations are known when this is compiled.
    macro_rules! turns {
        ($($by:tt)*) => {$(
            if 2 * $by <= N || $by < N && !H::RECIPROCAL {
                sum = with(sum, turn::<H, R, W, N, D, S>(parameters, bodies, present, time, $by));
            }
        )*};
    }
    if W::WRITTEN_OUT {
        turns!(1 2 3 4 5 6 7);
    } else {
        for by in 1..N {
            turns!(by);
        }
    }
    sum.unwrap_or([W::of(0.0); D])
}

/// A sum and one addend more.
#[inline(always)]
fn with<W: Real, const D: usize>(sum: Option<[W; D]>, addend: [W; D]) -> Option<[W; D]> {
    Some(match sum {
        Some(sum) => add(sum, addend),
        None => addend,
    })
}

/// What acts on each body of a row in one turn.
///
/// Only inlined for certain where code is optimised: elsewhere every copy of it would have its own place on the stack.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    present: Present<W>,
    time: f64,
    by: usize,
) -> [W; D]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let bodies = [bodies, bodies.rotated::<R, N>(by)];
    let force = pairs::<H, R, W, D, S>(parameters, bodies, time);
    let mut force = acting(components::<H, W, D, S>(force, bodies), present);
    if let Some(present) = present {
        force = acting(force, Some(present.rotated::<N>(by)));
    }
    if 2 * by != N && H::RECIPROCAL {
        force = sub(force, rotated::<R, W, N, D>(force, N - by));
    }
    force
}

/// What acts on each body of a row from those of another row, added to `sums`, and the other way round.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn between<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    others: Bodies<W, D, S>,
    present: Present<W>,
    time: f64,
    sums: [&mut [W; D]; 2],
) where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let [sum, other] = sums;
    let mut meeting = Meeting { others, present, sum: *sum, reaction: *other };
    // A full round, so that at the end everybody is back in their place.
    if present.is_some() || !W::WRITTEN_OUT {
        for _ in 0..N {
            meeting.turn::<H, R, N>(parameters, bodies, time);
        }
    } else {
        // Written out, so that every turn has a branch of its own for the machine to foresee.
        macro_rules! turns {
            ($($turn:literal)*) => {$(
                if $turn < N {
                    meeting.turn::<H, R, N>(parameters, bodies, time);
                }
            )*};
        }
        turns!(0 1 2 3 4 5 6 7);
    }
    *sum = meeting.sum;
    if H::RECIPROCAL {
        *other = meeting.reaction;
    }
}

/// Two rows that meet: the one that turns, and what acts on both.
struct Meeting<W, const D: usize, const S: usize> {
    others: Bodies<W, D, S>,
    /// Which of the others are there.
    present: Present<W>,
    sum: [W; D],
    reaction: [W; D],
}

impl<W: Real, const D: usize, const S: usize> Meeting<W, D, S> {
    /// Adds what acts between bodies in the same place, and turns the others on by one place.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turn<H, R, const N: usize>(&mut self, parameters: &H::Parameters<R>, bodies: Bodies<W, D, S>, time: f64)
    where
        H: ManyBody<D, S>,
        R: Real,
        W: Row<R>,
    {
        let rows = [bodies, self.others];
        let [i, j] = &rows;
        if H::acts::<R, W>(parameters, i.q, j.q, i.of, j.of, time) {
            let force = pairs::<H, R, W, D, S>(parameters, rows, time);
            if H::CENTRAL && self.present.is_none() {
                let (pull, apart) = (force.as_ref()[0], displacement(rows));
                let Self { sum, reaction, .. } = self;
                for d in 0..D {
                    sum[d] = pull.fma(apart[d], sum[d]);
                    reaction[d] = (-pull).fma(apart[d], reaction[d]);
                }
            } else {
                let force = acting(components::<H, W, D, S>(force, rows), self.present);
                self.sum = add(self.sum, force);
                self.reaction = sub(self.reaction, force);
            }
        }
        self.reaction = rotated::<R, W, N, D>(self.reaction, 1);
        self.others = self.others.rotated::<R, N>(1);
        if let Some(row) = self.present {
            self.present = Some(row.rotated::<N>(1));
        }
    }
}
