//! The energy of any state of a system, told without its run.

use crate::{
    coords::Coords,
    hamiltonian::{Hamiltonian, Motion, Shaped},
    phase::Phase,
    real::{Kernel, Real},
    slot::Keep,
};
use alloc::sync::Arc;

/// What tells the energy of a state without holding the run.
pub(crate) trait Energies<C: Coords>: Send + Sync {
    fn energy(&self, state: &Phase<C>, time: f64) -> f64;
}

/// Prepared constants, from which the energy of any state can be told.
struct Constants<P, C> {
    parameters: Arc<P>,
    energy: EnergyOf<P, C>,
}

/// What tells the energies of the states of a system.
pub(crate) fn energies<P: Send + Sync + 'static, C: Coords>(
    parameters: Arc<P>,
    energy: EnergyOf<P, C>,
) -> Arc<dyn Energies<C>> {
    Arc::new(Constants { parameters, energy })
}

impl<P: Send + Sync, C: Coords> Energies<C> for Constants<P, C> {
    fn energy(&self, state: &Phase<C>, time: f64) -> f64 {
        (self.energy)(&self.parameters, state, time)
    }
}

/// What tells the energy of a state at a time, compiled for one system and leaf.
pub(crate) type EnergyOf<P, C> = fn(&P, &Phase<C>, f64) -> f64;

/// The energy of a state, in what its leaf asks for, where flows are computed in `R`.
pub(crate) fn energy<H: Hamiltonian, R: Real, K: Keep>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
) -> f64 {
    let part =
        |part: usize| Phase { q: state.q.map(|leaf| leaf.parts()[part]), p: state.p.map(|leaf| leaf.parts()[part]) };
    let value = part(0);
    let carried = if <K::Energy<R>>::LANES > 1 { Some(part(1)) } else { None };
    let of_lane = |lane: usize| (parameters, carried.as_ref().filter(|_| lane > 0).unwrap_or(&value));
    let motion = H::Motion::<K::Energy<R>, f64>::load(of_lane);
    <K::Energy<R>>::enter(Energy::<H, K::Energy<R>> { motion: &motion, time })
}

struct Energy<'m, H: Hamiltonian, R: Real> {
    motion: &'m H::Motion<R, f64>,
    time: f64,
}

impl<H: Hamiltonian, R: Real> Kernel for Energy<'_, H, R> {
    type Out = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        (H::kinetic::<R, f64>(self.motion, self.time) + H::potential::<R, f64>(self.motion, self.time)).lane(0)
    }
}
