//! Sums over lists: eight bodies at a time, each with its own neighbours.

use super::{constant, lists::Portion, numbers, quads};
use crate::{
    layout::bodies::{
        load_store::WIDTH,
        pair_sums::{Bodies, ManyBody, components, displacement, pair_densities, pair_energies, pair_forces},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
};
use core::{marker::PhantomData, ops::Range};

/// Lists are prefetched this number of slots ahead: 2 KiB, which are read in some hundreds of nanoseconds.
const AHEAD: usize = 512;

/// The forces on the bodies of some rows, or else their densities.
pub(crate) struct Forces<'s, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize, const DENSITIES: bool> {
    pub(crate) points: &'s [[R; 4]],
    pub(crate) portion: Option<&'s Portion>,
    pub(crate) rows: Range<usize>,
    pub(crate) bodies: usize,
    pub(crate) parameters: &'s H::Parameters<R>,
    pub(crate) time: f64,
    pub(crate) results: &'s mut [[[R; WIDTH]; D]],
    pub(crate) system: PhantomData<fn(H)>,
}

/// The energies of the bodies of some rows with those of lower numbers.
pub(crate) struct Energies<'s, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> {
    pub(crate) points: &'s [[R; 4]],
    pub(crate) portion: Option<&'s Portion>,
    pub(crate) rows: Range<usize>,
    pub(crate) bodies: usize,
    pub(crate) parameters: &'s H::Parameters<R>,
    pub(crate) time: f64,
    pub(crate) results: &'s mut [[[R; WIDTH]; D]],
    pub(crate) system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize, const DENSITIES: bool> Kernel
    for Forces<'_, H, R, D, S, DENSITIES>
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { points, portion, rows, bodies, parameters, time, results, .. } = self;
        for (number, row) in rows.enumerate() {
            let own = own_slots(row, bodies);
            let body = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &own, false);
            let mut sum = [Real::of(0.0); D];
            match portion {
                Some(portion) => {
                    let are_included = leave_out::<R>();
                    let head = &portion.heads[number];
                    let range = Steps::<R::Row<WIDTH>>::of::<R>(&head.counts);
                    let before = Steps::<R::Row<WIDTH>>::of::<R>(&head.before);
                    let (common, rest) = portion.steps[head.first..][..range.most].split_at(range.common);
                    for (step, slots) in common.iter().enumerate() {
                        R::Row::<WIDTH>::fetch_once(slots.as_ptr().wrapping_add(AHEAD));
                        let mut others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, slots, are_included);
                        put_in_order::<H, R, D, S>(&mut others, || before.acting(step));
                        add_forces::<H, R, D, S, DENSITIES>(
                            &mut sum,
                            parameters,
                            [body, others],
                            are_included,
                            None,
                            time,
                        );
                    }
                    for (step, slots) in (range.common..).zip(rest) {
                        let acting = range.acting(step);
                        let mut others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, slots, are_included);
                        put_in_order::<H, R, D, S>(&mut others, || before.acting(step));
                        add_forces::<H, R, D, S, DENSITIES>(
                            &mut sum,
                            parameters,
                            [body, others],
                            are_included,
                            Some(acting),
                            time,
                        );
                    }
                }
                None => {
                    for other in 0..bodies {
                        let mut others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &[other as u32; WIDTH], false);
                        put_in_order::<H, R, D, S>(&mut others, || behind::<R>(other, row));
                        let acting = (other / WIDTH == row).then(|| others_than::<R>(other % WIDTH));
                        add_forces::<H, R, D, S, DENSITIES>(&mut sum, parameters, [body, others], false, acting, time);
                    }
                }
            }
            for d in 0..D {
                sum[d].write(&mut results[number][d]);
            }
        }
    }
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> Kernel for Energies<'_, H, R, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { points, portion, rows, bodies, parameters, time, results, .. } = self;
        for (number, row) in rows.enumerate() {
            let own = own_slots(row, bodies);
            let body = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &own, false);
            let mut sum = <R::Row<WIDTH> as Real>::of(0.0);
            match portion {
                Some(portion) => {
                    let are_included = leave_out::<R>();
                    let head = &portion.heads[number];
                    let range = Steps::<R::Row<WIDTH>>::of::<R>(&head.before);
                    for (step, slots) in portion.steps[head.first..][..range.most].iter().enumerate() {
                        let others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, slots, are_included);
                        add_energies::<H, R, D, S>(
                            &mut sum,
                            parameters,
                            [body, others],
                            are_included,
                            range.acting(step),
                            time,
                        );
                    }
                }
                None => {
                    for other in 0..bodies.min((row + 1) * WIDTH) {
                        let others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &[other as u32; WIDTH], false);
                        add_energies::<H, R, D, S>(
                            &mut sum,
                            parameters,
                            [body, others],
                            false,
                            behind::<R>(other, row),
                            time,
                        );
                    }
                }
            }
            sum.write(&mut results[number][0]);
        }
    }
}

/// Whether lists leave out the pairs that the system does: several members share lists, and may leave out other pairs each.
pub(super) const fn leave_out<R: Real>() -> bool {
    R::MEMBERS == 1
}

/// The mask of some lanes of a row.
type Lanes<R> = <<R as Real>::Row<WIDTH> as Real>::Mask;

/// The slots of a row; lanes after the last body repeat it.
#[inline(always)]
pub(super) fn own_slots(row: usize, bodies: usize) -> [u32; WIDTH] {
    let mut slots = [0; WIDTH];
    for (lane, slot) in slots.iter_mut().enumerate() {
        *slot = (row * WIDTH + lane).min(bodies - 1) as u32;
    }
    slots
}

/// The bodies in some slots; zero in place of what only the condition of included pairs reads, if all `are_included`.
#[inline(always)]
pub(crate) fn bodies_at<H: ManyBody<D, S>, R: Real, W: Row<R>, const D: usize, const S: usize>(
    points: &[[R; 4]],
    slots: &[u32; WIDTH],
    are_included: bool,
) -> Bodies<W, D, S> {
    let zero = W::of(0.0);
    let mut bodies = Bodies { q: [zero; D], constants: [zero; S] };
    let quads = const { quads(numbers::<H, D, S>()) };
    let count = match H::LEAVES_OUT {
        Some(own) if are_included => numbers::<H, D, S>() - own,
        _ => numbers::<H, D, S>(),
    };
    for quad in 0..count.div_ceil(4) {
        let numbers = W::transposed(points, slots, quads, quad);
        for (at, number) in numbers.into_iter().enumerate() {
            let place = quad * 4 + at;
            if place < D {
                bodies.q[place] = number;
            } else if place < count {
                bodies.constants[constant::<H, D, S>(place)] = number;
            }
        }
    }
    bodies
}

/// Says of other bodies whether they come before those of a row, whose number is zero here.
#[inline(always)]
fn put_in_order<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize>(
    others: &mut Bodies<R::Row<WIDTH>, D, S>,
    are_before: impl FnOnce() -> Lanes<R>,
) {
    if let Some(number) = const { H::NUMBER } {
        others.constants[number] = Real::select(are_before(), Real::of(-1.0), Real::of(1.0));
    }
}

/// Adds the forces of other bodies on those of a row, or their densities there, in the lanes of `acting`.
#[inline(always)]
fn add_forces<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize, const DENSITIES: bool>(
    sum: &mut [R::Row<WIDTH>; D],
    parameters: &H::Parameters<R>,
    rows: [Bodies<R::Row<WIDTH>, D, S>; 2],
    are_included: bool,
    acting: Option<Lanes<R>>,
    time: f64,
) {
    if DENSITIES {
        let densities = pair_densities::<H, R, R::Row<WIDTH>, D, S>(parameters, rows, time);
        for d in 0..H::DENSITIES.len() {
            sum[d] += match acting {
                Some(acting) => Real::select(acting, densities[d], Real::of(0.0)),
                None => densities[d],
            };
        }
        return;
    }
    let mut force = pair_forces::<H, R, R::Row<WIDTH>, D, S>(parameters, rows, are_included, time);
    if let Some(acting) = acting {
        let none = Real::of(0.0);
        for force in force.as_mut() {
            *force = Real::select(acting, *force, none);
        }
    }
    if H::CENTRAL {
        let (radial, separation) = (force.as_ref()[0], displacement(rows));
        for d in 0..D {
            sum[d] = radial.fma(separation[d], sum[d]);
        }
    } else {
        let force = components::<H, R::Row<WIDTH>, D, S>(force, rows);
        for d in 0..D {
            sum[d] += force[d];
        }
    }
}

/// Adds the energies of other bodies with those of a row, in the lanes of `acting`.
#[inline(always)]
fn add_energies<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize>(
    sum: &mut R::Row<WIDTH>,
    parameters: &H::Parameters<R>,
    [row, mut others]: [Bodies<R::Row<WIDTH>, D, S>; 2],
    are_included: bool,
    acting: Lanes<R>,
    time: f64,
) {
    put_in_order::<H, R, D, S>(&mut others, || acting);
    let energies = pair_energies::<H, R, R::Row<WIDTH>, D, S>(parameters, [row, others], are_included, time);
    *sum += Real::select(acting, energies, Real::of(0.0));
}

/// The numbers of steps of a row: of those with all lanes, of those with any lane, and of those with each lane.
pub(super) struct Steps<W> {
    common: usize,
    pub(super) most: usize,
    of_lane: W,
}

impl<W: Real> Steps<W> {
    #[inline(always)]
    pub(super) fn of<R: Real>(of_lane: &[u32; WIDTH]) -> Self
    where
        W: Row<R>,
    {
        let (mut common, mut most, mut numbers) = (u32::MAX, 0, [R::of(0.0); WIDTH]);
        for (number, count) in numbers.iter_mut().zip(of_lane) {
            (common, most) = (common.min(*count), most.max(*count));
            *number = R::of(f64::from(*count));
        }
        Self { common: common as usize, most: most as usize, of_lane: W::read(&numbers) }
    }

    /// The lanes that take part in a step.
    #[inline(always)]
    fn acting(&self, step: usize) -> W::Mask {
        W::of(step as f64).less(self.of_lane)
    }
}

/// All lanes but one.
#[inline(always)]
fn others_than<R: Real>(own: usize) -> Lanes<R> {
    let mut acting = [R::of(1.0); WIDTH];
    acting[own] = R::of(0.0);
    Real::less(Real::of(0.0), <R::Row<WIDTH> as Row<R>>::read(&acting))
}

/// The lanes of a row after a body.
#[inline(always)]
fn behind<R: Real>(body: usize, row: usize) -> Lanes<R> {
    let mut acting = [R::of(0.0); WIDTH];
    for (lane, number) in acting.iter_mut().enumerate() {
        if body < row * WIDTH + lane {
            *number = R::of(1.0);
        }
    }
    Real::less(Real::of(0.0), <R::Row<WIDTH> as Row<R>>::read(&acting))
}
