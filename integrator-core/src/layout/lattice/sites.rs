//! The sites of a lattice, all of them or a segment: the range that a flow advances in one pass. In a plane
//! they are counted in rows.

use crate::{
    layout::lattice::stencil::{AdjacentRows, Drift, Kick, Stencil, StencilPass},
    scalar::real::{Kernel, Real},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{
        motion::Plain,
        sites::{Flow, MovedSites, Sites},
    },
};
use core::{marker::PhantomData, ops::Range};

/// The shortest lattice of a known length whose flows are compiled once for all loops over stages. Those of shorter
/// ones are compiled into the loops.
pub(crate) const LONG: usize = 128;

/// Whether a lattice is short, and known to be so.
pub(crate) const fn is_short<C: Coords>() -> bool {
    match C::LENGTH {
        Some(length) => length < LONG,
        None => false,
    }
}

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// Whether flows are compiled into the loops over stages. Without optimization a function that everything is inlined
    /// into would need megabytes of stack.
    const INLINED: bool = is_short::<C>() && cfg!(not(debug_assertions));

    /// The flow of `T` of a lattice.
    #[inline(always)]
    pub fn drift<H: Stencil<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let pass = self.sites().moved_by(true).pass::<H, Drift>(R::of(duration), time);
        let sites = 0..pass.length;
        if Self::INLINED { pass.apply(sites) } else { R::enter(ApplyPass { pass, sites }) }
    }

    /// The flow of `V` of a lattice.
    #[inline(always)]
    pub fn kick<H: Stencil<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let pass = self.sites().moved_by(false).pass::<H, Kick>(R::of(-duration), time);
        let sites = 0..pass.length;
        if Self::INLINED { pass.apply(sites) } else { R::enter(ApplyPass { pass, sites }) }
    }

    /// All sites.
    #[inline(always)]
    pub fn sites(&mut self) -> Sites<'_, R, C::Leaf, P> {
        let (q, p) = (C::slots_mut(&mut self.q), C::slots_mut(&mut self.p));
        Sites { length: q.len(), q, p, parameters: &self.parameters, first: 0, columns: 1 }
    }
}

impl<'m, R: Real, K: Precision, P> MovedSites<'m, R, K, P> {
    /// Applies a flow to `sites`.
    #[inline(always)]
    pub fn apply<H>(self, flow: &Flow, sites: Range<usize>)
    where
        H: Stencil<Drift, Parameters<R> = P> + Stencil<Kick, Parameters<R> = P>,
    {
        let inlined = const { is_short::<H::Coords>() && cfg!(not(debug_assertions)) };
        if flow.drifts {
            let pass = self.pass::<H, Drift>(R::of(flow.duration), flow.time);
            if inlined { pass.apply(sites) } else { R::enter(ApplyPass { pass, sites }) }
        } else {
            let pass = self.pass::<H, Kick>(R::of(-flow.duration), flow.time);
            if inlined { pass.apply(sites) } else { R::enter(ApplyPass { pass, sites }) }
        }
    }

    /// The pass of a flow along the sites.
    #[inline(always)]
    fn pass<H: Stencil<F, Parameters<R> = P>, F>(self, step: R, time: f64) -> StencilPass<'m, H, F, R, K::Slot<R>> {
        let Self { read, moved, parameters, first, length, .. } = self;
        let (adjacent, flow) = (AdjacentRows::none(), PhantomData);
        StencilPass { read, moved, first, length, adjacent, parameters, step, time, flow }
    }
}

/// A stencil pass over a range of sites, in the multiversioned variant for this machine.
struct ApplyPass<'m, H: Stencil<F>, F, R: Real, S> {
    pass: StencilPass<'m, H, F, R, S>,
    sites: Range<usize>,
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for ApplyPass<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        // The variant is compiled on its own: with the empty constant repeated here, the optimiser removes all that
        // concerns adjacent rows.
        StencilPass { adjacent: AdjacentRows::none(), ..self.pass }.apply(self.sites);
    }
}
