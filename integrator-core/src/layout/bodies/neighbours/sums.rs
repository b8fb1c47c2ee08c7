//! Sums over lists: eight bodies at a time, each with its own neighbours.

use super::{lists::Portion, quads};
use crate::{
    layout::bodies::{
        many_rows::WIDTH,
        pair_sums::{Bodies, ManyBody, components, displacement, pair_energies, pair_forces},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
};
use core::{marker::PhantomData, ops::Range};

/// The forces on the bodies of some rows.
pub(crate) struct Forces<'s, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> {
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
    pub(crate) results: &'s mut [[[R; WIDTH]; 1]],
    pub(crate) system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> Kernel for Forces<'_, H, R, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { points, portion, rows, bodies, parameters, time, results, .. } = self;
        for (number, row) in rows.enumerate() {
            let own = own_slots(row, bodies);
            let body = bodies_at::<R, R::Row<WIDTH>, D, S>(points, &own);
            let mut sum = [Real::of(0.0); D];
            match portion {
                Some(portion) => {
                    let head = &portion.heads[number];
                    let range = Steps::of(&head.counts);
                    let steps = &portion.steps[head.first..head.first + range.most];
                    let (common, rest) = steps.split_at(range.common);
                    for at in common {
                        let others = bodies_at::<R, R::Row<WIDTH>, D, S>(points, at);
                        add_forces::<H, R, D, S>(&mut sum, parameters, [body, others], None, time);
                    }
                    for (step, at) in rest.iter().enumerate() {
                        let acting = range.acting::<R>(range.common + step);
                        let others = bodies_at::<R, R::Row<WIDTH>, D, S>(points, at);
                        add_forces::<H, R, D, S>(&mut sum, parameters, [body, others], Some(acting), time);
                    }
                }
                None => {
                    for other in 0..bodies {
                        let others = bodies_at::<R, R::Row<WIDTH>, D, S>(points, &[other as u32; WIDTH]);
                        let acting = (other / WIDTH == row).then(|| others_than::<R>(other % WIDTH));
                        add_forces::<H, R, D, S>(&mut sum, parameters, [body, others], acting, time);
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
            let body = bodies_at::<R, R::Row<WIDTH>, D, S>(points, &own);
            let mut sum = <R::Row<WIDTH> as Real>::of(0.0);
            let mut add = |at: &[u32; WIDTH], acting: R::Row<WIDTH>| {
                let others = bodies_at::<R, R::Row<WIDTH>, D, S>(points, at);
                let energy = pair_energies::<H, R, R::Row<WIDTH>, D, S>(parameters, [body, others], time);
                let none = Real::of(0.0);
                sum += Real::select(Real::less(none, acting), energy, none);
            };
            match portion {
                Some(portion) => {
                    let head = &portion.heads[number];
                    let range = Steps::of(&head.before);
                    for (step, at) in portion.steps[head.first..head.first + range.most].iter().enumerate() {
                        add(at, range.acting::<R>(step));
                    }
                }
                None => {
                    for other in 0..bodies.min((row + 1) * WIDTH) {
                        add(&[other as u32; WIDTH], behind::<R>(other, row));
                    }
                }
            }
            sum.write(&mut results[number][0]);
        }
    }
}

/// The slots of a row; lanes behind the last body repeat it.
#[inline(always)]
fn own_slots(row: usize, bodies: usize) -> [u32; WIDTH] {
    let mut slots = [0; WIDTH];
    for (lane, slot) in slots.iter_mut().enumerate() {
        *slot = (row * WIDTH + lane).min(bodies - 1) as u32;
    }
    slots
}

/// The bodies in some slots.
#[inline(always)]
fn bodies_at<R: Real, W: Row<R>, const D: usize, const S: usize>(
    points: &[[R; 4]],
    slots: &[u32; WIDTH],
) -> Bodies<W, D, S> {
    let zero = W::of(0.0);
    let mut bodies = Bodies { q: [zero; D], constants: [zero; S] };
    let quads = const { quads(D + S) };
    for quad in 0..quads {
        let numbers = W::transposed(points, slots, quads, quad);
        for (at, number) in numbers.into_iter().enumerate() {
            let place = quad * 4 + at;
            if place < D {
                bodies.q[place] = number;
            } else if place < D + S {
                bodies.constants[place - D] = number;
            }
        }
    }
    bodies
}

/// Adds the forces of other bodies on those of a row, in the lanes that are one in `acting`.
#[inline(always)]
fn add_forces<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize>(
    sum: &mut [R::Row<WIDTH>; D],
    parameters: &H::Parameters<R>,
    rows: [Bodies<R::Row<WIDTH>, D, S>; 2],
    acting: Option<R::Row<WIDTH>>,
    time: f64,
) {
    let mut force = pair_forces::<H, R, R::Row<WIDTH>, D, S>(parameters, rows, time);
    if let Some(acting) = acting {
        let none = Real::of(0.0);
        for force in force.as_mut() {
            *force = Real::select(Real::less(none, acting), *force, none);
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

/// How many steps of a row all lanes take part in, how many any, and how many each.
struct Steps<'h> {
    common: usize,
    most: usize,
    of_lane: &'h [u32; WIDTH],
}

impl<'h> Steps<'h> {
    #[inline(always)]
    fn of(of_lane: &'h [u32; WIDTH]) -> Self {
        let (mut common, mut most) = (u32::MAX, 0);
        for count in of_lane {
            (common, most) = (common.min(*count), most.max(*count));
        }
        Self { common: common as usize, most: most as usize, of_lane }
    }

    /// One in the lanes that take part in a step, zero in others.
    #[inline(always)]
    fn acting<R: Real>(&self, step: usize) -> R::Row<WIDTH> {
        let mut acting = [R::of(0.0); WIDTH];
        for (lane, count) in self.of_lane.iter().enumerate() {
            if step < *count as usize {
                acting[lane] = R::of(1.0);
            }
        }
        Row::read(&acting)
    }
}

/// One in all lanes but one, where it is zero.
#[inline(always)]
fn others_than<R: Real>(own: usize) -> R::Row<WIDTH> {
    let mut acting = [R::of(1.0); WIDTH];
    acting[own] = R::of(0.0);
    Row::read(&acting)
}

/// One in the lanes of a row behind a body, zero in others.
#[inline(always)]
fn behind<R: Real>(body: usize, row: usize) -> R::Row<WIDTH> {
    let mut acting = [R::of(0.0); WIDTH];
    for (lane, number) in acting.iter_mut().enumerate() {
        if body < row * WIDTH + lane {
            *number = R::of(1.0);
        }
    }
    Row::read(&acting)
}
