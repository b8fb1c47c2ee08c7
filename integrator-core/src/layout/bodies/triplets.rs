//! Sums over triplets: a body and two others within a cutoff of it.
//!
//! Comes in: bodies in slots, with lists of neighbours or without. Goes out: the gradient and the energy of all triplets. Always true:
//! bodies in the middle and both others come in the order of their numbers, and each triplet is added by itself. So no bit depends on
//! lists, on threads, or on which triplets share a vector. Others beyond the cutoff add zero.
//!
//! All of it is done by one thread. Bodies without lists search their neighbours among all others.

use crate::{
    layout::bodies::{
        load_store::WIDTH,
        neighbours::{Cutoffs, Neighbours, Placed, Sum, add_multiple, bodies_at, lists::Lists, rounding},
        pair_sums::{ManyBody, triplet_energies, triplet_forces},
    },
    scalar::{
        real::{Kernel, Mask, Real},
        simd::row::Row,
    },
    state::precision::Slot,
};
use alloc::vec::Vec;

#[cfg(test)]
mod tests;

/// The triplets that are found before any is computed.
const AT_ONCE: usize = 256;

/// Three slots: that of the body in the middle, and those of both others.
type Triplet = [u32; 3];

/// Adds a multiple of the gradient of the energy of all triplets to momenta, in the variant for the instruction set.
pub(crate) struct KickByTriplets<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    pub(crate) sum: Sum<'s, H, R, L, D, S>,
    pub(crate) neighbours: &'s mut Neighbours<R, D>,
    pub(crate) cutoffs: Option<&'s Cutoffs<D>>,
    pub(crate) factor: R::Row<WIDTH>,
    pub(crate) p: &'s mut [[L; D]],
}

impl<H, R, L, const D: usize, const S: usize> Kernel for KickByTriplets<'_, H, R, L, D, S>
where
    H: ManyBody<D, S>,
    R: Real,
    L: Slot<R::Row<WIDTH>>,
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { sum, neighbours, cutoffs, factor, p } = self;
        let mut placed = neighbours.placed(&sum, cutoffs);
        sum_up::<H, R, L, D, S, false>(&sum, &mut placed);
        add_multiple(placed.results, &placed.lists.slot_of, factor, p);
    }
}

/// The energy of all triplets, likewise.
pub(crate) struct EnergyOfTriplets<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    pub(crate) sum: &'s Sum<'s, H, R, L, D, S>,
    pub(crate) neighbours: &'s mut Neighbours<R, D>,
    pub(crate) cutoffs: Option<&'s Cutoffs<D>>,
}

impl<H, R, L, const D: usize, const S: usize> Kernel for EnergyOfTriplets<'_, H, R, L, D, S>
where
    H: ManyBody<D, S>,
    R: Real,
    L: Slot<R::Row<WIDTH>>,
{
    type Out = R;

    #[inline(always)]
    fn call(self) -> R {
        let Self { sum, neighbours, cutoffs } = self;
        sum_up::<H, R, L, D, S, true>(sum, &mut neighbours.placed(sum, cutoffs))
    }
}

/// The energy of all triplets, or else zero, and their gradient in the slots.
#[inline(always)]
fn sum_up<H, R, L, const D: usize, const S: usize, const ENERGY: bool>(
    sum: &Sum<'_, H, R, L, D, S>,
    placed: &mut Placed<'_, R, D>,
) -> R
where
    H: ManyBody<D, S>,
    R: Real,
{
    let Placed { lists, points, results } = placed;
    let Sum { bodies, parameters, time, .. } = *sum;
    let near = Near::<R, D>::new::<H, S>(points, bodies, parameters, time);
    let (mut found, mut others) = (Vec::<Triplet>::with_capacity(2 * AT_ONCE), Vec::new());
    let (mut next, mut own, mut first, mut total) = (0, 0, 0, R::of(0.0));
    loop {
        while found.len() < AT_ONCE {
            if let Some((second, rest)) = others.get(first..).and_then(<[u32]>::split_first) {
                for third in rest {
                    found.push([own, *second, *third]);
                }
                first += 1;
            } else if next < bodies {
                (own, first) = (lists.slot_of[next], 0);
                near.find::<H, S>(points, lists, own, bodies, &mut others);
                next += 1;
            } else {
                break;
            }
        }
        // The last ones may be fewer than lanes.
        let is_last = found.len() < AT_ONCE;
        let whole = if is_last { found.len() } else { found.len() / WIDTH * WIDTH };
        for triplets in found[..whole].chunks(WIDTH) {
            let mut slots = [[0; WIDTH]; 3];
            for lane in 0..WIDTH {
                let triplet = triplets[lane.min(triplets.len() - 1)];
                for (slots, slot) in slots.iter_mut().zip(triplet) {
                    slots[lane] = slot;
                }
            }
            let [i, j, k] = &slots;
            let rows = [
                bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, i, false),
                bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, j, false),
                bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, k, false),
            ];
            if ENERGY {
                let mut energies = [R::of(0.0); WIDTH];
                triplet_energies::<H, R, R::Row<WIDTH>, D, S>(parameters, rows, time).write(&mut energies);
                for energy in &energies[..triplets.len()] {
                    total += *energy;
                }
            } else {
                let forces = triplet_forces::<H, R, R::Row<WIDTH>, D, S>(parameters, rows, time);
                add_forces::<R, D>(&forces, triplets, results);
            }
        }
        if is_last {
            return total;
        }
        found.drain(..whole);
    }
}

/// Adds the gradients of triplets to the sums of their bodies, one after the other.
#[inline(always)]
fn add_forces<R: Real, const D: usize>(
    forces: &[[R::Row<WIDTH>; D]; 2],
    triplets: &[Triplet],
    results: &mut [[[R; WIDTH]; D]],
) {
    let mut numbers = [[[R::of(0.0); WIDTH]; D]; 2];
    for (numbers, force) in numbers.as_flattened_mut().iter_mut().zip(forces.as_flattened()) {
        force.write(numbers);
    }
    let [second, third] = &numbers;
    for (lane, triplet) in triplets.iter().enumerate() {
        let [own, j, k] = triplet.map(|slot| (slot as usize / WIDTH, slot as usize % WIDTH));
        for d in 0..D {
            let (of_second, of_third) = (second[d][lane], third[d][lane]);
            results[j.0][d][j.1] += of_second;
            results[k.0][d][k.1] += of_third;
            results[own.0][d][own.1] -= of_second + of_third;
        }
    }
}

/// Who is near a body.
struct Near<R: Real, const D: usize> {
    /// The square of the cutoff, and of what distances round to beyond it.
    limit: R::Row<WIDTH>,
    /// The sides of the box, and one divided by each; zero along an axis without an end.
    sides: [[R::Row<WIDTH>; 2]; D],
}

impl<R: Real, const D: usize> Near<R, D> {
    #[inline(always)]
    fn new<H: ManyBody<D, S>, const S: usize>(
        points: &[[R; 4]],
        bodies: usize,
        parameters: &H::Parameters<R>,
        time: f64,
    ) -> Self {
        let one = |number: f64| <R::Row<WIDTH> as Real>::of(number);
        let mut farthest = R::of(0.0);
        let stride = points.len() / bodies.max(1);
        for point in points.chunks(stride.max(1)) {
            for x in &point.as_flattened()[..D] {
                let size = x.abs();
                // What is not finite is near nothing.
                let is_larger = farthest.less(size);
                let larger = R::select(is_larger, size, farthest);
                farthest = R::select(size.less(R::of(f64::INFINITY)), larger, farthest);
            }
        }
        let mut most: f64 = 0.0;
        for member in 0..R::MEMBERS {
            most = most.max(farthest.lane(member * (R::LANES / R::MEMBERS)));
        }
        let radius = H::triplet_cutoff::<R, R::Row<WIDTH>>(parameters, time).sqrt();
        // The rounding of a distance grows in proportion to the radius.
        let radius = radius * one(1.0 + rounding::<R>(1.0, 0.0)) + one(rounding::<R>(0.0, most));
        let (limit, everywhere, zero) = (radius * radius, one(f64::INFINITY), one(0.0));
        // If the cutoff is no number, all triplets are computed, and so show what the formulas make of it.
        let limit = Real::select(limit.less(everywhere), limit, everywhere);
        let mut sides = [[zero; 2]; D];
        for (sides, side) in sides.iter_mut().zip(H::triplet_sides::<R, R::Row<WIDTH>>(parameters, time)) {
            let side = side.abs();
            let is_closed = zero.less(side).and(side.less(everywhere));
            *sides = [side, one(1.0) / side].map(|number| Real::select(is_closed, number, zero));
        }
        Self { limit, sides }
    }

    /// Finds the slots of the bodies near the one in a slot, in the order of their numbers.
    #[inline(always)]
    fn find<H: ManyBody<D, S>, const S: usize>(
        &self,
        points: &[[R; 4]],
        lists: &Lists,
        own: u32,
        bodies: usize,
        near: &mut Vec<u32>,
    ) {
        near.clear();
        let listed = lists.of_slot(own as usize);
        let count = listed.map_or(bodies, <[_]>::len);
        let center = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &[own; WIDTH], false).q;
        for begin in (0..count).step_by(WIDTH) {
            let mut slots = [0; WIDTH];
            for (lane, slot) in slots.iter_mut().enumerate() {
                let at = (begin + lane).min(count - 1);
                *slot = listed.map_or(at as u32, |steps| steps[at][own as usize % WIDTH]);
            }
            let others = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &slots, false).q;
            let mut square = <R::Row<WIDTH> as Real>::of(0.0);
            for d in 0..D {
                let (along, [side, inverse]) = (others[d] - center[d], self.sides[d]);
                let along = along - side * (along * inverse).round_ties_even();
                square = along.fma(along, square);
            }
            let is_near: R::Row<WIDTH> = Real::select(square.less(self.limit), Real::of(1.0), Real::of(0.0));
            let mut numbers = [R::of(0.0); WIDTH];
            is_near.write(&mut numbers);
            for lane in 0..WIDTH.min(count - begin) {
                let in_any = (0..R::MEMBERS).any(|member| numbers[lane].lane(member * (R::LANES / R::MEMBERS)) > 0.0);
                if in_any && slots[lane] != own {
                    near.push(slots[lane]);
                }
            }
        }
    }
}
