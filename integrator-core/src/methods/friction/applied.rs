//! How the stages of a step are applied: one by one, or those of a long lattice in tiles and on threads.

use super::{
    apply::{Draw, damp, thermalise},
    factors::Row,
};
use crate::{
    layout::lattice::time_tiling::TimeTiling,
    scalar::real::{Kernel, Real},
    state::precision::{Precision, Slot},
    system::{
        dissipation::WithFriction,
        flows::{Flows, Single},
        sites::Flow,
    },
    threads::{Job, at_once, each},
};
use alloc::{boxed::Box, vec::Vec};
use core::marker::PhantomData;

/// The flows of `T` and `V`, and friction.
pub(super) trait Applied<H: WithFriction, R: Real, K: Precision> {
    fn drift(&mut self, motion: &mut H::Motion<R, K>, duration: f64, time: f64);
    fn kick(&mut self, motion: &mut H::Motion<R, K>, duration: f64, time: f64);
    /// Applies flows that were only collected so far.
    fn finish(&mut self, motion: &mut H::Motion<R, K>);
    /// Friction of all momenta, with noise if there is a draw.
    fn friction(&mut self, momenta: &mut [K::Slot<H::Wide<R>>], rows: &[Row<H::Wide<R>>], draw: Option<Draw<'_>>);
}

/// Each stage at once.
pub(super) struct OneByOne;

impl<H: WithFriction, R: Real, K: Precision> Applied<H, R, K> for OneByOne {
    #[inline(always)]
    fn drift(&mut self, motion: &mut H::Motion<R, K>, duration: f64, time: f64) {
        Single::<H, R, K>(motion).drift(duration, time);
    }
    #[inline(always)]
    fn kick(&mut self, motion: &mut H::Motion<R, K>, duration: f64, time: f64) {
        Single::<H, R, K>(motion).kick(duration, time);
    }
    #[inline(always)]
    fn finish(&mut self, _motion: &mut H::Motion<R, K>) {}
    #[inline(always)]
    fn friction(&mut self, momenta: &mut [K::Slot<H::Wide<R>>], rows: &[Row<H::Wide<R>>], draw: Option<Draw<'_>>) {
        match draw {
            Some(draw) => thermalise::<R, _, _>(momenta, rows, draw, 0),
            None => damp(momenta, rows),
        }
    }
}

/// Between two stages of friction, flows of a long lattice in tiles; and friction on threads.
pub(super) struct Tiled {
    pub(super) collected: Vec<Flow>,
    pub(super) threads: Option<usize>,
}

impl<H: WithFriction, R: Real, K: Precision> Applied<H, R, K> for Tiled {
    fn drift(&mut self, _motion: &mut H::Motion<R, K>, duration: f64, time: f64) {
        self.collected.push(Flow { drifts: true, duration, time });
    }
    fn kick(&mut self, _motion: &mut H::Motion<R, K>, duration: f64, time: f64) {
        self.collected.push(Flow { drifts: false, duration, time });
    }
    fn finish(&mut self, motion: &mut H::Motion<R, K>) {
        TimeTiling::<H, R, K>::apply(motion, &self.collected, self.threads);
        self.collected.clear();
    }
    fn friction(&mut self, momenta: &mut [K::Slot<H::Wide<R>>], rows: &[Row<H::Wide<R>>], draw: Option<Draw<'_>>) {
        // The two numbers of a draw belong to an even slot and the next one.
        let each = each(momenta, self.threads).next_multiple_of(2);
        let (mut jobs, mut begin) = (Vec::<Job<'_>>::new(), 0);
        for momenta in momenta.chunks_mut(each) {
            let rows = if rows.len() == 1 { rows } else { &rows[begin..begin + momenta.len()] };
            let share = Share::<R, H::Wide<R>, K::Slot<H::Wide<R>>> { momenta, rows, draw, begin, lanes: PhantomData };
            jobs.push(Box::new(move || R::enter(share)));
            begin += each;
        }
        at_once(jobs);
    }
}

/// Friction of some of the momenta, from a slot on.
struct Share<'m, R, W, S> {
    momenta: &'m mut [S],
    rows: &'m [Row<W>],
    draw: Option<Draw<'m>>,
    begin: usize,
    lanes: PhantomData<R>,
}

impl<R: Real, W: Real, S: Slot<W>> Kernel for Share<'_, R, W, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        match self.draw {
            Some(draw) => thermalise::<R, _, _>(self.momenta, self.rows, draw, self.begin),
            None => damp(self.momenta, self.rows),
        }
    }
}
