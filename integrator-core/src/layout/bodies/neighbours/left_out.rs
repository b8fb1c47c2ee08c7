//! Pairs that lists leave out wherever the bodies are, such as those of a molecule: their condition is evaluated once per list, and not
//! in every step.

#[cfg(test)]
mod tests;

use super::{
    lists::{Head, Lists, Portion},
    sums::{Steps, bodies_at, own_slots},
};
use crate::{
    layout::bodies::{load_store::WIDTH, pair_sums::ManyBody},
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
    threads::{Job, at_once},
};
use alloc::{boxed::Box, vec::Vec};
use core::marker::PhantomData;

/// Leaves pairs out of new lists.
pub(super) fn leave_out<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize>(
    lists: &mut Lists,
    points: &[[R; 4]],
    bodies: usize,
    (parameters, time): (&H::Parameters<R>, f64),
    threads: usize,
) {
    let Some(portions) = &mut lists.portions else { return };
    let share = portions.len().div_ceil(threads.max(1)).max(1);
    let mut jobs = Vec::<Job<'_>>::with_capacity(portions.len().div_ceil(share));
    for portions in portions.chunks_mut(share) {
        jobs.push(Box::new(move || {
            for portion in portions {
                R::enter(LeaveOut { points, portion, bodies, parameters, time, system: PhantomData::<fn(H)> });
            }
        }));
    }
    at_once(jobs);
}

/// Leaves pairs out of the lists of some rows.
struct LeaveOut<'l, H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> {
    points: &'l [[R; 4]],
    portion: &'l mut Portion,
    bodies: usize,
    parameters: &'l H::Parameters<R>,
    time: f64,
    system: PhantomData<fn(H)>,
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> Kernel for LeaveOut<'_, H, R, D, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { points, portion: Portion { rows, heads, steps }, bodies, parameters, time, .. } = self;
        for (row, head) in rows.clone().zip(heads) {
            let own = own_slots(row, bodies);
            let body = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &own, false);
            let most = Steps::<R::Row<WIDTH>>::of::<R>(&head.counts).most;
            let steps = &mut steps[head.first..][..most];
            let (mut counts, mut before) = ([0; WIDTH], [0; WIDTH]);
            for step in 0..most {
                let slots = steps[step];
                let other = bodies_at::<H, R, R::Row<WIDTH>, D, S>(points, &slots, false);
                let included =
                    H::included::<R, R::Row<WIDTH>>(parameters, body.q, other.q, body.constants, other.constants, time);
                let mut numbers = [R::of(0.0); WIDTH];
                Real::select(included, <R::Row<WIDTH> as Real>::of(1.0), Real::of(0.0)).write(&mut numbers);
                for lane in 0..WIDTH {
                    let is_listed = |counts: &[u32; WIDTH]| (step as u32) < counts[lane];
                    if numbers[lane].lane(0) > 0.0 && is_listed(&head.counts) {
                        steps[counts[lane] as usize][lane] = slots[lane];
                        counts[lane] += 1;
                        before[lane] += u32::from(is_listed(&head.before));
                    }
                }
            }
            // A lane that has no more neighbours repeats its last one, or itself.
            for lane in 0..WIDTH {
                let (listed, rest) = steps.split_at_mut(counts[lane] as usize);
                let last = listed.last().map_or(own[lane], |step| step[lane]);
                rest.iter_mut().for_each(|step| step[lane] = last);
            }
            *head = Head { counts, before, ..*head };
        }
    }
}
