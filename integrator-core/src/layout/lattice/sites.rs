//! The sites of a lattice, all of them or a window: what a flow moves when it does not move everything at once.

use crate::{
    layout::lattice::{
        stencil::{Beside, Drift, Gather, Kick, Sweep},
        time_tiling::Flow,
    },
    scalar::real::{Kernel, Real},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::motion::Plain,
};
use core::{marker::PhantomData, ops::Range};

/// The state of neighbouring sites, with the prepared constants of the whole lattice.
pub struct Sites<'m, R: Real, K: Precision, P> {
    pub(crate) q: &'m mut [K::Slot<R>],
    pub(crate) p: &'m mut [K::Slot<R>],
    pub(crate) parameters: &'m P,
    /// The site that the slices begin with.
    pub(crate) first: usize,
    /// How many sites the lattice has.
    pub(crate) length: usize,
}

/// Flows of lattices of a known length below this are compiled into the loop over stages, others once for all loops.
pub(crate) const LONG: usize = 128;

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// Whether the lattice is short, and known to be so. Without optimization a function that everything is inlined into
    /// would need megabytes of stack.
    const SHORT: bool = match C::LENGTH {
        Some(length) => length < LONG && cfg!(not(debug_assertions)),
        None => false,
    };

    /// The flow of `T` of a lattice.
    #[inline(always)]
    pub fn drift<H: Gather<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let along = self.sites().drift::<H>(duration, time);
        let sites = 0..along.length;
        if Self::SHORT { along.over(sites) } else { R::enter(Over { along, sites }) }
    }

    /// The flow of `V` of a lattice.
    #[inline(always)]
    pub fn kick<H: Gather<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let along = self.sites().kick::<H>(duration, time);
        let sites = 0..along.length;
        if Self::SHORT { along.over(sites) } else { R::enter(Over { along, sites }) }
    }

    /// All sites.
    #[inline(always)]
    pub fn sites(&mut self) -> Sites<'_, R, C::Leaf, P> {
        let (q, p) = (C::slots_mut(&mut self.q), C::slots_mut(&mut self.p));
        Sites { length: q.len(), q, p, parameters: &self.parameters, first: 0 }
    }
}

impl<'m, R: Real, K: Precision, P> Sites<'m, R, K, P> {
    /// The same sites, for a while.
    pub(crate) fn whole(&mut self) -> Sites<'_, R, K, P> {
        Sites { q: self.q, p: self.p, ..*self }
    }

    /// The sites up to `site`, and those from there on.
    pub(crate) fn split_at(self, site: usize) -> (Self, Self) {
        let (q, q_after) = self.q.split_at_mut(site - self.first);
        let (p, p_after) = self.p.split_at_mut(site - self.first);
        (Self { q, p, ..self }, Self { q: q_after, p: p_after, first: site, ..self })
    }

    /// A flow moves the coordinates of `sites`.
    pub fn take<H>(&mut self, flow: &Flow, sites: Range<usize>)
    where
        H: Gather<Drift, Parameters<R> = P> + Gather<Kick, Parameters<R> = P>,
    {
        if flow.drifts {
            R::enter(Over { along: self.whole().drift::<H>(flow.duration, flow.time), sites });
        } else {
            R::enter(Over { along: self.whole().kick::<H>(flow.duration, flow.time), sites });
        }
    }

    /// The flow of `T`, which moves positions.
    #[inline(always)]
    fn drift<H: Gather<Drift, Parameters<R> = P>>(
        self,
        duration: f64,
        time: f64,
    ) -> Sweep<'m, H, Drift, R, K::Slot<R>> {
        let Self { q: moved, p: read, parameters, first, length } = self;
        let (step, beside, flow) = (R::of(duration), Beside::line(), PhantomData);
        Sweep { read, moved, first, length, beside, parameters, step, time, flow }
    }

    /// The flow of `V`, which moves momenta.
    #[inline(always)]
    fn kick<H: Gather<Kick, Parameters<R> = P>>(self, duration: f64, time: f64) -> Sweep<'m, H, Kick, R, K::Slot<R>> {
        let Self { q: read, p: moved, parameters, first, length } = self;
        let (step, beside, flow) = (R::of(-duration), Beside::line(), PhantomData);
        Sweep { read, moved, first, length, beside, parameters, step, time, flow }
    }
}

/// A flow over a range of sites, in the clone for this machine.
struct Over<'m, H: Gather<F>, F, R: Real, S> {
    along: Sweep<'m, H, F, R, S>,
    sites: Range<usize>,
}

impl<H: Gather<F>, F, R: Real, S: Slot<R>> Kernel for Over<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        // Said anew in the clone, which is compiled on its own: nothing of what is beside a line is left in it.
        Sweep { beside: Beside::line(), ..self.along }.over(self.sites);
    }
}
