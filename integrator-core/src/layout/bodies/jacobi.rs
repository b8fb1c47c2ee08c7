//! The motion of bodies in Jacobi coordinates, for H = Kepler parts + interaction (Wisdom and Holman 1991).
//!
//! The first part moves the centre of mass on a line and every other body on its Kepler orbit about the centre of mass of
//! those before it; the second is `V` without these attractions. Always true: states are the user's own, inertial
//! coordinates; the map is applied where they are loaded and stored, with twice the digits where `R` is a plain number, so
//! that what is shown is rounded once. Until the first flow, the state that was loaded is shown itself.

use crate::{
    error::Unsolved,
    flow::kepler::{faults::Faults, moved, universal::Body},
    layout::bodies::{
        given::Given,
        jacobi_map::{
            Digits, JacobiConstants, Map, Part, body_at, digits_to_inertial, digits_to_jacobi, parts, to_inertial,
            to_jacobi,
        },
        load_store::{body_and_lane, values},
        rows::{Coordinates, Rows, bodies_of_row, points, set_points},
    },
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::motion::Motion,
};
use alloc::{sync::Arc, vec::Vec};
use core::ops::Range;

/// Bodies in rows, in Jacobi coordinates.
#[derive(Clone)]
pub struct Jacobi<L: Rows<D>, const D: usize> {
    /// The Jacobi coordinates and their momenta.
    pub(crate) bodies: L,
    /// The inertial coordinates of the bodies, from when they were last needed.
    pub inertial: L::AtRest,
    weights: Arc<[Weights<L::Row>]>,
    /// The number of the body that leads, which is the first one of rows.
    leading: usize,
    /// The user's states, until the first flow.
    given: Given<L::Leaf>,
    /// The faults of the Kepler flow.
    unsolved: Faults,
}

/// The constants that the map and the Kepler parts read, of the bodies of a row.
#[derive(Clone, Copy)]
struct Weights<W> {
    /// The share of each body in the masses up to it.
    share: W,
    /// The inverse of its reduced mass.
    inverse_mass: W,
    /// The strength of its attraction to those before it.
    attraction: W,
    /// One for the first body of all, zero for others.
    first: W,
    /// One where the row has a body one, two or four lanes ahead.
    later: [W; 3],
    /// One where the row has a body one, two or four lanes back.
    earlier: [W; 3],
}

/// The distances, in lanes, over which sums over a row reach in each of their steps.
const REACH: [usize; 3] = [1, 2, 4];

/// One number for each of [`REACH`].
#[inline(always)]
fn reached<W>(number: impl Fn(usize) -> W) -> [W; 3] {
    [number(REACH[0]), number(REACH[1]), number(REACH[2])]
}

impl<W: Real> Weights<W> {
    /// The constants of a row of `width` bodies out of `bodies`, of one member per lane. Lanes without a body stay
    /// where they are.
    fn of<L: Rows<D, Row = W>, const D: usize>(row: usize, members: &[Vec<Part>]) -> Self {
        let width = L::WIDTH;
        let bodies = bodies_of_row(row, width, members[0].len());
        let of_lane = |number: &dyn Fn(usize, usize) -> f64| {
            W::parameter(&|lane| {
                let (body, member) = body_and_lane::<L::Scalar>(&(row * width..(row + 1) * width), lane);
                if bodies.contains(&body) { number(body, member) } else { 0.0 }
            })
        };
        let is = |holds: bool| if holds { 1.0 } else { 0.0 };
        let place = |body: usize| body % width;
        Self {
            share: of_lane(&|body, member| members[member][body].share),
            inverse_mass: of_lane(&|body, member| members[member][body].inverse_mass),
            attraction: of_lane(&|body, member| members[member][body].attraction),
            first: of_lane(&|body, _| is(body == 0)),
            later: reached(|by| of_lane(&|body, _| is(place(body) + by < width))),
            earlier: reached(|by| of_lane(&|body, _| is(place(body) >= by))),
        }
    }
}

/// Maps a state with twice the digits.
fn map_state<C: Coords>(state: &mut Phase<C>, map: &dyn Fn(&mut Digits)) {
    let mut digits = [digits(state.q.flat()), digits(state.p.flat())];
    map(&mut digits);
    for (leaves, digits) in [state.q.flat_mut(), state.p.flat_mut()].into_iter().zip(&digits) {
        for (leaf, digits) in leaves.iter_mut().zip(digits) {
            *leaf = C::Leaf::from_parts(*digits);
        }
    }
}

fn digits<K: Precision>(leaves: &[K]) -> Vec<[f64; 2]> {
    let mut digits = Vec::with_capacity(leaves.len());
    for leaf in leaves {
        digits.push(leaf.parts());
    }
    digits
}

/// Sorts what belongs to bodies into the order of rows, where the leading body is first.
fn in_order_of_rows<T: Copy>(of_bodies: &mut [T], leading: usize) {
    let Some(&first) = of_bodies.get(leading) else { return };
    for place in (0..leading).rev() {
        of_bodies[place + 1] = of_bodies[place];
    }
    of_bodies[0] = first;
}

/// Undoes [`in_order_of_rows`].
fn in_users_order<T: Copy>(of_bodies: &mut [T], leading: usize) {
    let (true, Some(&first)) = (leading < of_bodies.len(), of_bodies.first()) else { return };
    for place in 0..leading {
        of_bodies[place] = of_bodies[place + 1];
    }
    of_bodies[leading] = first;
}

/// The states of members as they are loaded: in Jacobi coordinates where these are mapped with twice the digits, and else with
/// their bodies in the order of rows.
fn own_states<C: Coords, Q: JacobiConstants, const D: usize>(
    constants: &[&Q],
    states: &[&Phase<C>],
    mapped: bool,
) -> Vec<Phase<C>> {
    let mut own = Vec::with_capacity(states.len());
    for (constants, state) in constants.iter().zip(states) {
        let (mut state, leading) = ((*state).clone(), constants.leading_body());
        if mapped {
            let parts = parts(*constants, state.q.length());
            map_state(&mut state, &|digits| digits_to_jacobi(&parts, leading, D, digits));
        } else {
            for leaves in [&mut state.q, &mut state.p] {
                in_order_of_rows(leaves.flat_mut().as_chunks_mut::<D>().0, leading);
            }
        }
        own.push(state);
    }
    own
}

fn parts_of_members<Q: JacobiConstants>(constants: &[&Q], bodies: usize) -> Vec<Vec<Part>> {
    let mut members = Vec::with_capacity(constants.len());
    for constants in constants {
        members.push(parts(*constants, bodies));
    }
    members
}

fn references<T>(of: &[T]) -> Vec<&T> {
    let mut references = Vec::with_capacity(of.len());
    for one in of {
        references.push(one);
    }
    references
}

/// A state of this many numbers, all zero.
fn zeros<C: Coords>(numbers: usize) -> Option<Phase<C>> {
    let zeros = alloc::vec![C::Leaf::default(); numbers];
    Some(Phase { q: C::from_flat(zeros.clone())?, p: C::from_flat(zeros)? })
}

/// The way of the bodies of a row, and one in the lanes of those whose orbits could not be solved, if there are any. Where a row
/// is this number of numbers, the bodies go one by one: code for all of them together would be that many times longer.
#[inline(always)]
fn way<L: Rows<D>, const D: usize>(body: &Body<L::Row, D>, duration: f64) -> ([[L::Row; D]; 2], Option<L::Row>) {
    if const { <L::Row as Row<L::Scalar>>::PARTS == 0 } {
        let moved = moved::<L::Scalar, L::Row, D>(*body, L::Row::of(duration));
        let failed = || <L::Row as Real>::select(moved.failed, L::Row::of(1.0), L::Row::of(0.0));
        let failed = moved.failed.any().then(failed);
        return ([moved.q, moved.p], failed);
    }
    let zero = L::Row::of(0.0);
    let (mut way, mut failed, mut has_failed) = ([[zero; D]; 2], zero, false);
    for part in 0..<L::Row as Row<L::Scalar>>::PARTS {
        let of = |row: &L::Row| -> L::Scalar { row.part(part) };
        let (mut q, mut p) = ([of(&body.q[0]); D], [of(&body.p[0]); D]);
        for d in 1..D {
            (q[d], p[d]) = (of(&body.q[d]), of(&body.p[d]));
        }
        let body = Body { q, p, inverse_mass: of(&body.inverse_mass), strength: of(&body.strength) };
        let moved = moved::<L::Scalar, L::Scalar, D>(body, L::Scalar::of(duration));
        for (rows, numbers) in way.iter_mut().zip([moved.q, moved.p]) {
            for (row, number) in rows.iter_mut().zip(numbers) {
                row.set_part(part, number);
            }
        }
        has_failed |= moved.failed.any();
        let one = L::Scalar::of(1.0);
        failed.set_part(part, <L::Scalar as Real>::select(moved.failed, one, L::Scalar::of(0.0)));
    }
    (way, has_failed.then_some(failed))
}

impl<L: Rows<D>, const D: usize> Jacobi<L, D> {
    /// Whether the map is applied to lanes one by one, and with more digits.
    const PLAIN: bool = L::Scalar::LANEWISE;

    /// The motion of bodies whose coordinates are those of Jacobi already.
    fn new<Q: JacobiConstants>(constants: &[&Q], bodies: L) -> Self {
        let count = bodies.bodies();
        let members = parts_of_members(constants, count);
        let mut weights = Vec::with_capacity(bodies.rows()[0].len());
        for row in 0..bodies.rows()[0].len() {
            weights.push(Weights::of::<L, D>(row, &members));
        }
        let weights = weights.into();
        // Members in lanes are alike in all integers.
        let leading = constants[0].leading_body();
        Self {
            inertial: bodies.at_rest(),
            bodies,
            weights,
            leading,
            given: Given::default(),
            unsolved: Faults::default(),
        }
    }

    /// The shares of all bodies in the member that a lane belongs to. Its other lanes hold derivatives, and those of
    /// constants are zero.
    fn shares(&self, lane: usize) -> Vec<f64> {
        let lane = lane - lane % (L::Scalar::LANES / L::Scalar::MEMBERS.max(1));
        let mut shares = Vec::with_capacity(self.bodies.bodies());
        for body in 0..self.bodies.bodies() {
            shares.push(self.weights[body / L::WIDTH].share.lane(body % L::WIDTH * L::Scalar::LANES + lane));
        }
        shares
    }

    /// The points of all bodies in inertial coordinates and in the user's order, mapped in the scalar of flows.
    fn inertial_points(&self) -> [Vec<[L::Scalar; D]>; 2] {
        let mut mapped = self.mapped(to_inertial);
        for points in &mut mapped {
            in_users_order(points, self.leading);
        }
        mapped
    }

    /// The points of all bodies, mapped in the scalar of flows.
    fn mapped(&self, map: Map<L::Scalar, D>) -> [Vec<[L::Scalar; D]>; 2] {
        let [q, p] = self.bodies.rows();
        let [mut q, mut p] = [points(&self.bodies, q), points(&self.bodies, p)];
        map(&self.shares(0), &mut q, &mut p);
        [q, p]
    }
}

impl<C, Q, L, const D: usize> Motion<C, Q> for Jacobi<L, D>
where
    C: Coords<Leaf = L::Leaf>,
    Q: JacobiConstants,
    L: Motion<C, Q> + Rows<D>,
{
    const MIXES: bool = true;

    fn load(constants: &[&Q], states: &[&Phase<C>]) -> Self {
        let own = own_states::<C, Q, D>(constants, states, Self::PLAIN);
        let mut motion = Self::load_own(constants, &references(&own));
        motion.given = Given::of(states);
        if const { !Self::PLAIN } {
            let points = motion.mapped(to_jacobi);
            for (rows, points) in motion.bodies.rows_mut().into_iter().zip(&points) {
                set_points::<L, D>(rows, points);
            }
        }
        motion
    }
    fn load_own(constants: &[&Q], states: &[&Phase<C>]) -> Self {
        Self::new(constants, L::load(constants, states))
    }
    fn gathered<'a>(of_lane: &dyn Fn(usize) -> (&'a Q, &'a Self, usize)) -> Option<Self>
    where
        Q: 'a,
    {
        let (mut given, mut constants, mut states) = (Vec::new(), Vec::new(), Vec::new());
        for lane in 0..L::Scalar::LANES {
            let (own, motion, lane) = of_lane(lane);
            let mut state = zeros::<C>(motion.bodies.bodies() * D)?;
            motion.store_own(lane, &mut state);
            given.push((&motion.given, lane));
            constants.push(own);
            states.push(state);
        }
        let mut motion = Self::load_own(&constants, &references(&states));
        motion.given = Given::gathered(&given);
        Some(motion)
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        if self.given.show(lane, to) {
            return;
        }
        if const { Self::PLAIN } {
            self.store_own(lane, to);
            let (shares, leading) = (self.shares(lane), self.leading);
            return map_state(to, &|digits| digits_to_inertial(&shares, leading, D, digits));
        }
        let [q, p] = self.inertial_points();
        for (leaves, points) in [(&mut to.q, &q), (&mut to.p, &p)] {
            for (leaf, number) in leaves.flat_mut().iter_mut().zip(points.as_flattened()) {
                let mut slot = <L::Leaf as Precision>::Slot::<L::Scalar>::zero();
                slot.add(*number);
                *leaf = L::Leaf::unpack(slot, lane);
            }
        }
    }
    fn store_own(&self, lane: usize, to: &mut Phase<C>) {
        self.bodies.store(lane, to);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.bodies.copy_state(&from.bodies);
        self.given.copy(&from.given);
        self.unsolved.copy(&from.unsolved);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.bodies.share_among(threads);
        self.inertial = self.bodies.at_rest();
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.unsolved.of_lane(lane)
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        self.bodies.finite()
    }
}

/// The sums over the bodies of a row from each one on.
#[inline(always)]
fn sums_from<L: Rows<D>, const D: usize>(mut sum: L::Row, weights: &Weights<L::Row>) -> L::Row {
    // Unrolled, so that the rotations are known when this is compiled.
    macro_rules! add {
        ($($step:literal)*) => {$(
            if REACH[$step] < L::WIDTH {
                sum = weights.later[$step].fma(L::rotate(sum, REACH[$step]), sum);
            }
        )*};
    }
    add!(0 1 2);
    sum
}

/// The sums over the bodies of a row up to each one.
#[inline(always)]
fn sums_up_to<L: Rows<D>, const D: usize>(mut sum: L::Row, weights: &Weights<L::Row>) -> L::Row {
    macro_rules! add {
        ($($step:literal)*) => {$(
            if REACH[$step] < L::WIDTH {
                sum = weights.earlier[$step].fma(L::rotate(sum, L::WIDTH - REACH[$step]), sum);
            }
        )*};
    }
    add!(0 1 2);
    sum
}

/// The squares of distances, and a number that is not zero for the first body, which no Kepler part has.
#[inline(always)]
fn squares<W: Real, const D: usize>(q: [W; D], weights: &Weights<W>) -> W {
    let mut sum = weights.first;
    for q in q {
        sum = q.fma(q, sum);
    }
    sum
}

/// Maps Jacobi positions, or directions, to inertial ones.
#[inline(always)]
fn map_positions<L: Rows<D>, const D: usize>(
    weights: &[Weights<L::Row>],
    from: &[Coordinates<L, D>],
    to: &mut [Coordinates<L::AtRest, D>],
) {
    let Some(first) = from.first() else { return };
    let (mut later, mut centre) = ([L::Row::of(0.0); D], values(first));
    for centre in &mut centre {
        *centre = L::Row::permute(*centre, &[0; 8]);
    }
    for row in (0..from.len()).rev() {
        let (q, weights): ([L::Row; D], _) = (values(&from[row]), &weights[row]);
        for d in 0..D {
            let sum = sums_from::<L, D>(weights.share * q[d], weights) + later[d];
            // The coordinates of the first body are those of the centre.
            let own = (-weights.first).fma(q[d], q[d]);
            to[row][d] = centre[d] + (own - sum);
            later[d] = sum.permute(&[0; 8]);
        }
    }
}

/// Maps inertial momenta to those of Jacobi coordinates, where `put` has them.
#[inline(always)]
fn map_momenta<L: Rows<D>, const D: usize>(
    weights: &[Weights<L::Row>],
    bodies: usize,
    from: &[Coordinates<L::AtRest, D>],
    to: &mut [Coordinates<L, D>],
) {
    let mut total = [L::Row::of(0.0); D];
    for row in 0..from.len() {
        let (p, weights, count) = (&from[row], &weights[row], bodies_of_row(row, L::WIDTH, bodies).len());
        for d in 0..D {
            let sum = sums_up_to::<L, D>(p[d], weights) + total[d];
            let own = (-weights.first).fma(p[d], p[d]);
            to[row][d].add((-weights.share).fma(sum, own));
            total[d] = sum.permute(&[count as u64 - 1; 8]);
        }
    }
    if let (Some(first), Some(weights)) = (to.first_mut(), weights.first()) {
        for d in 0..D {
            first[d].fma(weights.first, total[d]);
        }
    }
}

/// The distance of the body in a lane of a row.
fn distance<W: Real, const D: usize>(q: &[W; D], lane: usize) -> f64 {
    let mut square = 0.0;
    for q in q {
        square += q.lane(lane) * q.lane(lane);
    }
    Real::sqrt(square)
}

/// Notes which bodies of a row could not be moved, and from where, before they are NaN. `distance` is that of a lane of the row, if
/// the body in it failed.
#[cold]
#[inline(never)]
fn note(
    unsolved: &mut Faults,
    leading: usize,
    places: Range<usize>,
    lanes: usize,
    distance: &dyn Fn(usize) -> Option<f64>,
    duration: f64,
) {
    for (number, place) in places.enumerate() {
        unsolved.note(lanes, &|lane| {
            let distance = distance(number * lanes + lane)?;
            Some(Unsolved::Kepler { body: body_at(leading, place), distance, duration })
        });
    }
}

impl<L: Rows<D>, const D: usize> Jacobi<L, D> {
    /// Sets the time at which conditions are read: the middle of the current step.
    #[inline(always)]
    pub fn begin_step(&mut self, middle: f64) {
        self.bodies.begin_step(middle);
        self.inertial.begin_step(middle);
    }

    /// The flow of the Kepler parts.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn drift(&mut self, duration: f64) {
        self.given.forget();
        let count = self.bodies.bodies();
        let [q, p] = self.bodies.rows_mut();
        for row in 0..q.len() {
            let Weights { inverse_mass, attraction: strength, .. } = self.weights[row];
            let body = Body { q: values(&q[row]), p: values(&p[row]), inverse_mass, strength };
            let ([of_q, of_p], failed) = way::<L, D>(&body, duration);
            if let Some(failed) = failed {
                let bodies = bodies_of_row(row, L::WIDTH, count);
                // Copies, so that the body itself stays in registers.
                let q = body.q;
                let distance = move |lane: usize| (failed.lane(lane) == 1.0).then(|| distance(&q, lane));
                note(&mut self.unsolved, self.leading, bodies, L::Scalar::LANES, &distance, duration);
            }
            for d in 0..D {
                q[row][d].add(of_q[d]);
                p[row][d].add(of_p[d]);
            }
        }
    }

    /// Maps positions to those of [`Jacobi::inertial`], whose momenta become zero: what the kick of `V` begins with.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn open_kick(&mut self) {
        let ([q, _], [to, rest]) = (self.bodies.rows(), self.inertial.rows_mut());
        map_positions::<L, D>(&self.weights, q, to);
        for row in rest {
            *row = [L::Row::of(0.0); D];
        }
    }

    /// The flow of the interaction for a time, after the kick of `V` gave [`Jacobi::inertial`] its momenta.
    #[cfg_attr(debug_assertions, inline)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn close_kick(&mut self, duration: f64) {
        self.given.forget();
        let (count, step) = (self.bodies.bodies(), L::Row::of(duration));
        let ([q, p], [_, kick]) = (self.bodies.rows_mut(), self.inertial.rows());
        map_momenta::<L, D>(&self.weights, count, kick, p);
        for row in 0..q.len() {
            let (q, weights): ([L::Row; D], _) = (values(&q[row]), &self.weights[row]);
            let back = (weights.attraction * step).div_pow_3_2(squares(q, weights));
            for d in 0..D {
                p[row][d].fma(back, q[d]);
            }
        }
    }

    /// The bodies in inertial coordinates, in the user's order.
    pub fn to_inertial(&self) -> L::AtRest {
        let mut bodies = self.bodies.at_rest();
        for (rows, points) in bodies.rows_mut().into_iter().zip(&self.inertial_points()) {
            set_points::<L::AtRest, D>(rows, points);
        }
        bodies
    }

    /// The sum of all attractions `k / |Q|`, which the Kepler parts have and the interaction has not.
    pub fn attraction(&self) -> L::Scalar {
        let mut sum = L::Scalar::of(0.0);
        for (row, (slots, weights)) in self.bodies.rows()[0].iter().zip(&*self.weights).enumerate() {
            let attractions = weights.attraction / squares(values(slots), weights).sqrt();
            for lane in 0..bodies_of_row(row, L::WIDTH, self.bodies.bodies()).len() {
                sum += attractions.part(lane);
            }
        }
        sum
    }

    /// Returns a motion with these positions and without momenta, with slots that hold numbers and nothing else.
    #[inline(always)]
    pub fn at_rest(&self) -> Jacobi<L::AtRest, D> {
        let (bodies, weights) = (self.bodies.at_rest(), self.weights.clone());
        let (inertial, leading) = (bodies.at_rest(), self.leading);
        Jacobi { inertial, bodies, weights, leading, given: Given::default(), unsolved: Faults::default() }
    }

    /// Adds a multiple of another motion's momenta.
    #[inline(always)]
    pub fn push(&mut self, factor: L::Scalar, other: &Jacobi<L::AtRest, D>) {
        self.given.forget();
        let ([_, p], [_, momenta]) = (self.bodies.rows_mut(), other.bodies.rows());
        let factor = L::Row::splat(factor);
        for row in 0..p.len() {
            for d in 0..D {
                p[row][d].fma(factor, momenta[row][d]);
            }
        }
    }
}

impl<L: Rows<D, Leaf = f64, AtRest = L>, const D: usize> Jacobi<L, D> {
    /// Makes velocities of the momenta.
    #[inline(always)]
    pub fn divide_by_masses(&mut self) {
        for (row, weights) in self.bodies.rows_mut()[1].iter_mut().zip(&*self.weights) {
            for p in row {
                *p = weights.inverse_mass * *p;
            }
        }
    }

    /// Maps positions and, as directions, momenta to those of [`Jacobi::inertial`]: what the product with the Hessian of
    /// `V` begins with.
    #[inline(always)]
    pub fn open_hessian(&mut self) {
        let ([q, p], [positions, directions]) = (self.bodies.rows(), self.inertial.rows_mut());
        map_positions::<L, D>(&self.weights, q, positions);
        map_positions::<L, D>(&self.weights, p, directions);
        self.reorder_inertial(in_users_order);
    }

    /// Puts the bodies of [`Jacobi::inertial`] in another order, which the product with the Hessian reads.
    fn reorder_inertial(&mut self, order: fn(&mut [[L::Scalar; D]], usize)) {
        if self.leading > 0 {
            let [q, p] = self.inertial.rows();
            let mut moved = [points(&self.inertial, q), points(&self.inertial, p)];
            for (rows, points) in self.inertial.rows_mut().into_iter().zip(&mut moved) {
                order(points, self.leading);
                set_points::<L, D>(rows, points);
            }
        }
    }

    /// Replaces the momenta by the product of the interaction's Hessian with them, after that of `V` was put where
    /// [`Jacobi::inertial`] has its momenta.
    #[inline(always)]
    pub fn close_hessian(&mut self) {
        self.reorder_inertial(in_order_of_rows);
        let (count, [q, p]) = (self.bodies.bodies(), self.bodies.rows_mut());
        for row in 0..q.len() {
            let (q, weights) = (q[row], &self.weights[row]);
            let (square, mut along) = (squares(q, weights), L::Row::of(0.0));
            for d in 0..D {
                along = q[d].fma(p[row][d], along);
            }
            let attraction = weights.attraction.div_pow_3_2(square);
            let along = L::Row::of(3.0) * along / square;
            for d in 0..D {
                p[row][d] = attraction * along.fma(q[d], -p[row][d]);
            }
        }
        map_momenta::<L, D>(&self.weights, count, self.inertial.rows()[1], p);
    }
}
