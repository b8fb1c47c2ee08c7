//! Many-body forces: the force between two bodies, which a system defines, and its sums over the pairs of one row or
//! two.
//!
//! Always true: pairs are summed in the order of rotations, which no hardware decides, so that every sum has the same
//! bits whatever a row is made of; the lanes after the last body change no sum.

use crate::{
    layout::lattice::stencil::Array,
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    state::{coords::Coords, precision::Slot},
    system::{System, motion::Prepared},
};

/// The prepared constants of each body. Written by `#[hamiltonian]`.
pub trait BodyConstants<const S: usize> {
    /// The constants of one body.
    fn body_constants(&self, body: usize) -> [f64; S];
    /// How many of this number of bodies act on each other: the first ones.
    #[inline]
    fn acting(&self, bodies: usize) -> usize {
        bodies
    }
    /// How many of this number of bodies move by the flow of `T`: the first ones.
    #[inline]
    fn moving(&self, bodies: usize) -> usize {
        bodies
    }
}

/// What functions of bodies read: a system, or a part of it with a sum over pairs of its own.
pub trait OfBodies {
    /// The shape of `q` and of `p`.
    type Coords: Coords<Leaf = f64>;
    /// The prepared constants.
    type Parameters<R: Real>: Prepared<R, Single = Self::Parameters<f64>>;
}

impl<H: System> OfBodies for H {
    type Coords = H::Coords;
    type Parameters<R: Real> = H::Parameters<R>;
}

/// A Hamiltonian, or a part of it, of bodies with `D` coordinates and `S` prepared constants each, whose potential is a sum over
/// pairs, and over bodies. Written by `#[hamiltonian]`.
pub trait ManyBody<const D: usize, const S: usize>: OfBodies {
    /// Whether action is reaction: the force on the second body is that on the first, with the opposite sign.
    const RECIPROCAL: bool;
    /// Whether forces are central: given by the radial factor that multiplies the displacement from the second body to
    /// the first.
    const CENTRAL: bool;
    /// The force of a pair: the radial factor where forces are central, else one component per coordinate.
    type Force<W: Copy>: Array<W>;

    /// The flow of `T` on one body. A part of H that is a function of positions alone has none.
    #[inline(always)]
    fn drift_body<R: Real, W: Row<R>, L: Slot<W>>(
        parameters: &Self::Parameters<R>,
        q: &mut [L; D],
        p: [W; D],
        constants: [W; S],
        step: W,
        time: f64,
    ) {
        let _ = (parameters, q, p, constants, step, time);
    }
    /// The force of a pair as the gradient of its energy by the coordinates of the first body, or as the radial factor.
    /// The energy stays the same if the two are exchanged.
    fn pair<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        time: f64,
    ) -> Self::Force<W>;
    /// Whether any two bodies in the same lane of two rows interact, as within a cutoff; if not, the gradient is zero,
    /// and not computed.
    #[inline(always)]
    fn interacts<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        time: f64,
    ) -> bool {
        let _ = (parameters, q_i, q_j, constants_i, constants_j, time);
        true
    }
    /// The gradient of a body's one-body energy, if it has any.
    #[inline(always)]
    fn one_body<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q: [W; D],
        constants: [W; S],
        time: f64,
    ) -> Option<[W; D]> {
        let _ = (parameters, q, constants, time);
        None
    }

    /// The constants of a body that are not prepared: sums over its partners, such as the electron density at an atom, on which an
    /// energy of the body depends. Before forces are summed, their weights take their places.
    const DENSITIES: &'static [usize] = &[];

    /// What the second body of a pair adds to the densities of the first, in their order; zero after the last.
    #[inline(always)]
    fn densities<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        time: f64,
    ) -> [W; D] {
        let _ = (parameters, q_i, q_j, constants_i, constants_j, time);
        [W::of(0.0); D]
    }
    /// The derivatives of the energy of a body by its densities, which are among its constants; zero after the last.
    #[inline(always)]
    fn weights<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, constants: [W; S], time: f64) -> [W; D] {
        let _ = (parameters, constants, time);
        [W::of(0.0); D]
    }

    /// Whether the potential has terms of a body and two others within a cutoff of it.
    const TRIPLETS: bool = false;

    /// The gradient of the energy of the body `i` and two others, by the coordinates of each of these: it depends on the
    /// displacements from `i` to both.
    #[allow(clippy::too_many_arguments, reason = "two for each of three bodies")]
    #[inline(always)]
    fn triplet<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        q_k: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        constants_k: [W; S],
        time: f64,
    ) -> [[W; D]; 2] {
        let _ = (parameters, q_i, q_j, q_k, constants_i, constants_j, constants_k, time);
        [[W::of(0.0); D]; 2]
    }
    /// The energy of such a triplet.
    #[allow(clippy::too_many_arguments, reason = "two for each of three bodies")]
    #[inline(always)]
    fn triplet_energy<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        q_k: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        constants_k: [W; S],
        time: f64,
    ) -> W {
        let _ = (parameters, q_i, q_j, q_k, constants_i, constants_j, constants_k, time);
        W::of(0.0)
    }
    /// The square of the distance from `i` beyond which another body is in no triplet, the same for all.
    #[inline(always)]
    fn triplet_cutoff<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, time: f64) -> W {
        let _ = (parameters, time);
        W::of(f64::INFINITY)
    }
    /// The sides of the periodic box of these distances, as [`Self::sides`].
    #[inline(always)]
    fn triplet_sides<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, time: f64) -> [W; D] {
        let _ = (parameters, time);
        [W::of(0.0); D]
    }

    /// Whether the potential has terms that are neither of pairs nor of bodies alone.
    const OTHER_TERMS: bool = false;

    /// Sets the momenta to the gradient of these terms by the positions.
    #[inline(always)]
    fn other_terms<R: Real>(motion: Unpacked<'_, R, Self::Coords, Self::Parameters<R>>, time: f64) {
        let _ = (motion, time);
    }

    /// Whether there may be bodies that do not act or do not move: [`BodyConstants::acting`], [`BodyConstants::moving`].
    const SOME_STAY: bool = false;

    /// The number of bodies from which on the neighbours within a cutoff are listed. A system without a cutoff has none, and
    /// only such a pair function is used below.
    const LISTED_FROM: usize = usize::MAX;

    /// The constant of a body that is its number, where pairs do nothing but compare it with that of the other body. Lists are in
    /// the order of these numbers, and do not read them.
    const NUMBER: Option<usize> = None;

    /// The number of constants that only [`Self::included`] reads, the last ones; `None` if lists leave no pair out.
    const LEAVES_OUT: Option<usize> = None;

    /// The pairs that have a force and an energy, whatever their coordinates. Lists leave the others out, and `pair` and `energy`
    /// do not read this condition.
    #[inline(always)]
    fn included<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        time: f64,
    ) -> W::Mask {
        let _ = (parameters, q_i, q_j, constants_i, constants_j, time);
        Mask::of(true)
    }

    /// The square of the distance beyond which a pair has neither a force nor an energy, the same for all pairs.
    #[inline(always)]
    fn cutoff<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, time: f64) -> W {
        let _ = (parameters, time);
        W::of(f64::INFINITY)
    }
    /// The sides of the periodic box in which distances are those of the nearest images; zero along an axis without an end.
    #[inline(always)]
    fn sides<R: Real, W: Row<R>>(parameters: &Self::Parameters<R>, time: f64) -> [W; D] {
        let _ = (parameters, time);
        [W::of(0.0); D]
    }
    /// The energy of a pair.
    #[inline(always)]
    fn energy<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q_i: [W; D],
        q_j: [W; D],
        constants_i: [W; S],
        constants_j: [W; S],
        time: f64,
    ) -> W {
        let _ = (parameters, q_i, q_j, constants_i, constants_j, time);
        W::of(0.0)
    }
    /// The energy of a body alone, if it has any.
    #[inline(always)]
    fn energy_alone<R: Real, W: Row<R>>(
        parameters: &Self::Parameters<R>,
        q: [W; D],
        constants: [W; S],
        time: f64,
    ) -> Option<W> {
        let _ = (parameters, q, constants, time);
        None
    }
}

/// Bodies in the user's own shape, for the terms of a potential that are not those of pairs.
pub struct Unpacked<'m, R: Real, C: Coords, P> {
    /// Positions.
    pub q: &'m C::Slots<R>,
    /// What receives the gradient.
    pub p: &'m mut C::Slots<R>,
    /// Prepared constants.
    pub parameters: &'m P,
}

/// A row of bodies: their positions and prepared constants.
#[derive(Clone, Copy)]
pub struct Bodies<W, const D: usize, const S: usize> {
    /// Positions.
    pub q: [W; D],
    /// Prepared constants.
    pub constants: [W; S],
}

impl<W: Real, const D: usize, const S: usize> Bodies<W, D, S> {
    #[inline(always)]
    pub(crate) fn rotate<R: Real, const N: usize>(self, by: usize) -> Self
    where
        W: Row<R>,
    {
        Self { q: rotate::<R, W, N, D>(self.q, by), constants: rotate::<R, W, N, S>(self.constants, by) }
    }
    /// The bodies of one part, where rows are made of parts.
    #[inline(always)]
    fn part<R: Real>(&self, part: usize) -> Bodies<R, D, S>
    where
        W: Row<R>,
    {
        let zero = R::of(0.0);
        let mut one = Bodies { q: [zero; D], constants: [zero; S] };
        for (one, all) in one.q.iter_mut().zip(&self.q).chain(one.constants.iter_mut().zip(&self.constants)) {
            *one = all.part(part);
        }
        one
    }
}

// Plain loops: what they call belongs to a multiversioned variant, and a closure might be compiled outside of it.

#[inline(always)]
fn rotate<R: Real, W: Row<R>, const N: usize, const D: usize>(mut rows: [W; D], by: usize) -> [W; D] {
    for row in &mut rows {
        *row = row.rotate::<N>(by);
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

/// The forces between each body and the one in the same lane of another row. `are_included` means that no pair is left out.
#[inline(always)]
pub(crate) fn pair_forces<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: [Bodies<W, D, S>; 2],
    are_included: bool,
    time: f64,
) -> H::Force<W>
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        return included_forces::<H, R, W, D, S>(parameters, bodies, are_included, time);
    }
    let mut forces = H::Force::<W>::filled(W::of(0.0));
    for part in 0..W::PARTS {
        let bodies = of_part::<R, W, D, S>(&bodies, part);
        let force = included_forces::<H, R, R, D, S>(parameters, bodies, are_included, time);
        for (forces, force) in forces.as_mut().iter_mut().zip(force.as_ref()) {
            forces.set_part(part, *force);
        }
    }
    forces
}

/// The forces of a row that is no parts, zero of pairs that are left out.
#[inline(always)]
fn included_forces<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: [Bodies<W, D, S>; 2],
    are_included: bool,
    time: f64,
) -> H::Force<W>
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let [i, j] = bodies;
    let mut forces = H::pair::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time);
    if const { H::LEAVES_OUT.is_some() } && !are_included {
        let included = H::included::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time);
        for force in forces.as_mut() {
            *force = W::select(included, *force, W::of(0.0));
        }
    }
    forces
}

/// The energy of each body with the one in the same lane of another row. `are_included` means that no pair is left out.
#[inline(always)]
pub(crate) fn pair_energies<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: [Bodies<W, D, S>; 2],
    are_included: bool,
    time: f64,
) -> W
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        return included_energies::<H, R, W, D, S>(parameters, bodies, are_included, time);
    }
    let mut energies = W::of(0.0);
    for part in 0..W::PARTS {
        let bodies = of_part::<R, W, D, S>(&bodies, part);
        energies.set_part(part, included_energies::<H, R, R, D, S>(parameters, bodies, are_included, time));
    }
    energies
}

/// The energies of a row that is no parts, zero of pairs that are left out.
#[inline(always)]
fn included_energies<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: [Bodies<W, D, S>; 2],
    are_included: bool,
    time: f64,
) -> W
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let [i, j] = bodies;
    let energies = H::energy::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time);
    if const { H::LEAVES_OUT.is_none() } || are_included {
        return energies;
    }
    let included = H::included::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time);
    W::select(included, energies, W::of(0.0))
}

/// The bodies of one part of two rows.
#[inline(always)]
fn of_part<R: Real, W: Row<R>, const D: usize, const S: usize>(
    [i, j]: &[Bodies<W, D, S>; 2],
    part: usize,
) -> [Bodies<R, D, S>; 2] {
    [i.part::<R>(part), j.part::<R>(part)]
}

/// What each body of a row gets for its densities from the one in the same lane of another row.
#[inline(always)]
pub(crate) fn pair_densities<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: [Bodies<W, D, S>; 2],
    time: f64,
) -> [W; D]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        let [i, j] = bodies;
        return H::densities::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time);
    }
    let mut densities = [W::of(0.0); D];
    for part in 0..W::PARTS {
        let [i, j] = of_part::<R, W, D, S>(&bodies, part);
        let of_part = H::densities::<R, R>(parameters, i.q, j.q, i.constants, j.constants, time);
        for (densities, of_part) in densities.iter_mut().zip(of_part) {
            densities.set_part(part, of_part);
        }
    }
    densities
}

/// The gradient of the energies of the triplets in the lanes of three rows, by the coordinates of the second and of the third.
#[inline(always)]
pub(crate) fn triplet_forces<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    [i, j, k]: [Bodies<W, D, S>; 3],
    time: f64,
) -> [[W; D]; 2]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        return H::triplet::<R, W>(parameters, i.q, j.q, k.q, i.constants, j.constants, k.constants, time);
    }
    let mut forces = [[W::of(0.0); D]; 2];
    for part in 0..W::PARTS {
        let [i, j, k] = [i.part::<R>(part), j.part::<R>(part), k.part::<R>(part)];
        let of_part = H::triplet::<R, R>(parameters, i.q, j.q, k.q, i.constants, j.constants, k.constants, time);
        for (forces, of_part) in forces.as_flattened_mut().iter_mut().zip(of_part.as_flattened()) {
            forces.set_part(part, *of_part);
        }
    }
    forces
}

/// The energies of these triplets.
#[inline(always)]
pub(crate) fn triplet_energies<H, R, W, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    [i, j, k]: [Bodies<W, D, S>; 3],
    time: f64,
) -> W
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    if const { W::PARTS == 0 } {
        return H::triplet_energy::<R, W>(parameters, i.q, j.q, k.q, i.constants, j.constants, k.constants, time);
    }
    let mut energies = W::of(0.0);
    for part in 0..W::PARTS {
        let [i, j, k] = [i.part::<R>(part), j.part::<R>(part), k.part::<R>(part)];
        let of_part = H::triplet_energy::<R, R>(parameters, i.q, j.q, k.q, i.constants, j.constants, k.constants, time);
        energies.set_part(part, of_part);
    }
    energies
}

/// The displacement from the second of two rows to the first.
#[inline(always)]
pub(crate) fn displacement<W: Real, const D: usize, const S: usize>([i, j]: [Bodies<W, D, S>; 2]) -> [W; D] {
    sub(i.q, j.q)
}

/// The components of the force between two rows.
#[inline(always)]
pub(crate) fn components<H: ManyBody<D, S>, W: Real, const D: usize, const S: usize>(
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

/// The mask of the lanes of a row that hold bodies: one there, zero elsewhere. Nothing where all do.
pub(crate) type ActiveMask<W> = Option<W>;

/// The force in active lanes, zero in others.
#[inline(always)]
pub(crate) fn masked<W: Real, const D: usize>(mut force: [W; D], active: ActiveMask<W>) -> [W; D] {
    if let Some(active) = active {
        let zero = W::of(0.0);
        for force in &mut force {
            *force = W::select(zero.less(active), *force, zero);
        }
    }
    force
}

/// The forces within a row: on each of its `N` bodies from the others, and the one-body force, as the gradient of the
/// energy.
///
/// Rotation `s` pairs each body with the one `s` lanes ahead. Where action is reaction, the rotations by up to
/// half the row suffice; of an even number of bodies, the rotation by half the row meets every pair twice, once from
/// either side.
#[inline(always)]
pub(crate) fn intra_row<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    active: ActiveMask<W>,
    time: f64,
) -> [W; D]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let mut sum = H::one_body::<R, W>(parameters, bodies.q, bodies.constants, time);
    // Unrolled, so that the rotations are known when this is compiled.
    macro_rules! rotations {
        ($($by:tt)*) => {$(
            if 2 * $by <= N || $by < N && !H::RECIPROCAL {
                sum = add_to(sum, rotation_forces::<H, R, W, N, D, S>(parameters, bodies, active, time, $by));
            }
        )*};
    }
    if W::UNROLLED {
        rotations!(1 2 3 4 5 6 7);
    } else {
        for by in 1..N {
            rotations!(by);
        }
    }
    sum.unwrap_or([W::of(0.0); D])
}

/// A sum with one addend more.
#[inline(always)]
fn add_to<W: Real, const D: usize>(sum: Option<[W; D]>, addend: [W; D]) -> Option<[W; D]> {
    Some(match sum {
        Some(sum) => add(sum, addend),
        None => addend,
    })
}

/// The forces on each body of a row in one rotation.
///
/// Only inlined for certain where code is optimised: elsewhere every copy of it would have a stack slot of its own.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
fn rotation_forces<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    active: ActiveMask<W>,
    time: f64,
    by: usize,
) -> [W; D]
where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let bodies = [bodies, bodies.rotate::<R, N>(by)];
    let force = pair_forces::<H, R, W, D, S>(parameters, bodies, false, time);
    let mut force = masked(components::<H, W, D, S>(force, bodies), active);
    if let Some(active) = active {
        force = masked(force, Some(active.rotate::<N>(by)));
    }
    if 2 * by != N && H::RECIPROCAL {
        force = sub(force, rotate::<R, W, N, D>(force, N - by));
    }
    force
}

/// Adds the forces between the bodies of two rows to the `sums` of both.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn inter_row<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    others: Bodies<W, D, S>,
    active: ActiveMask<W>,
    time: f64,
    sums: [&mut [W; D]; 2],
) where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    let [sum, other] = sums;
    let mut row_pair = RowPair { others, active, sum: *sum, reaction: *other };
    // All rotations, so that at the end every body is back in its lane.
    if active.is_some() || !W::UNROLLED {
        for _ in 0..N {
            row_pair.add_and_rotate::<H, R, N>(parameters, bodies, time);
        }
    } else {
        // Unrolled, so that every rotation has a branch of its own for the branch predictor.
        macro_rules! rotations {
            ($($rotation:literal)*) => {$(
                if $rotation < N {
                    row_pair.add_and_rotate::<H, R, N>(parameters, bodies, time);
                }
            )*};
        }
        rotations!(0 1 2 3 4 5 6 7);
    }
    *sum = row_pair.sum;
    if H::RECIPROCAL {
        *other = row_pair.reaction;
    }
}

/// Two rows and the forces between them: the row that is rotated, and the sums of both.
struct RowPair<W, const D: usize, const S: usize> {
    others: Bodies<W, D, S>,
    /// The active lanes of the others.
    active: ActiveMask<W>,
    sum: [W; D],
    reaction: [W; D],
}

impl<W: Real, const D: usize, const S: usize> RowPair<W, D, S> {
    /// Adds the forces between bodies in the same lane, and rotates the others by one lane.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add_and_rotate<H, R, const N: usize>(
        &mut self,
        parameters: &H::Parameters<R>,
        bodies: Bodies<W, D, S>,
        time: f64,
    ) where
        H: ManyBody<D, S>,
        R: Real,
        W: Row<R>,
    {
        let rows = [bodies, self.others];
        let [i, j] = &rows;
        if H::interacts::<R, W>(parameters, i.q, j.q, i.constants, j.constants, time) {
            let force = pair_forces::<H, R, W, D, S>(parameters, rows, false, time);
            if H::CENTRAL && self.active.is_none() {
                let (radial, separation) = (force.as_ref()[0], displacement(rows));
                let Self { sum, reaction, .. } = self;
                for d in 0..D {
                    sum[d] = radial.fma(separation[d], sum[d]);
                    reaction[d] = (-radial).fma(separation[d], reaction[d]);
                }
            } else {
                let force = masked(components::<H, W, D, S>(force, rows), self.active);
                self.sum = add(self.sum, force);
                self.reaction = sub(self.reaction, force);
            }
        }
        self.reaction = rotate::<R, W, N, D>(self.reaction, 1);
        self.others = self.others.rotate::<R, N>(1);
        if let Some(row) = self.active {
            self.active = Some(row.rotate::<N>(1));
        }
    }
}

/// Adds energies to those of a row, in active lanes.
#[inline(always)]
pub(crate) fn add_active<W: Real>(sum: &mut W, energies: W, active: ActiveMask<W>) {
    let [energies] = masked([energies], active);
    *sum += energies;
}

/// Adds the energies of the pairs within a row.
///
/// Rotation `s` pairs each body with the one `s` lanes ahead; of the rotation by half the row, half of the lanes have all pairs.
#[inline(always)]
pub(crate) fn intra_energies<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    active: ActiveMask<W>,
    time: f64,
    sum: &mut W,
) where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    for by in 1..=N / 2 {
        let energies = pair_energies::<H, R, W, D, S>(parameters, [bodies, bodies.rotate::<R, N>(by)], false, time);
        let [mut energies] = masked([energies], active);
        if let Some(active) = active {
            [energies] = masked([energies], Some(active.rotate::<N>(by)));
        }
        if 2 * by == N {
            let first = W::parameter(&|lane| if 2 * (lane / R::LANES) < N { 1.0 } else { 0.0 });
            [energies] = masked([energies], Some(first));
        }
        *sum += energies;
    }
}

/// Adds the energies of the pairs between the bodies of two rows.
#[inline(always)]
pub(crate) fn inter_energies<H, R, W, const N: usize, const D: usize, const S: usize>(
    parameters: &H::Parameters<R>,
    bodies: Bodies<W, D, S>,
    mut others: Bodies<W, D, S>,
    mut active: ActiveMask<W>,
    time: f64,
    sum: &mut W,
) where
    H: ManyBody<D, S>,
    R: Real,
    W: Row<R>,
{
    for _ in 0..N {
        // Bodies that do not interact may have an energy, which is then constant.
        add_active(sum, pair_energies::<H, R, W, D, S>(parameters, [bodies, others], false, time), active);
        others = others.rotate::<R, N>(1);
        if let Some(row) = active {
            active = Some(row.rotate::<N>(1));
        }
    }
}
