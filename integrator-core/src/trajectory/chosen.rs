//! What one trajectory of a system is carried on by, compiled for the instruction sets of which this machine chooses one.

use crate::{
    hamiltonian::{Hamiltonian, Shaped},
    scalar::{instruction_set::InstructionSet, real::Real},
    state::{phase::Phase, slot::Keep},
    system::energies::{Energies, energies, energy},
    trajectory::{
        engine::{Engine, Solo},
        method::Method,
    },
};
use alloc::{boxed::Box, sync::Arc};

/// What is compiled for one system, method and leaf.
pub(crate) struct Chosen<H: Hamiltonian, X: Method<H>, K: Keep> {
    solo: SoloOf<X::Constants, Shaped<H, K>>,
}

/// What makes an engine from constants and a start.
type SoloOf<Q, C> = fn(Arc<Q>, Phase<C>, Arc<dyn Energies<C>>) -> Box<dyn Engine<C>>;

impl<H: Hamiltonian, X: Method<H>, K: Keep> Chosen<H, X, K> {
    /// What this machine takes.
    pub(crate) fn here() -> Self {
        // Known when this is compiled, so that nothing is compiled for the others.
        if const { X::CLONED } {
            match InstructionSet::chosen() {
                InstructionSet::Baseline => Self::computed_in::<K::Plain>(),
                InstructionSet::Avx512 if X::WIDE => Self::computed_in::<K::Avx512>(),
                InstructionSet::Fused | InstructionSet::Avx512 => Self::computed_in::<K::Fused>(),
            }
        } else {
            Self::computed_in::<K::Plain>()
        }
    }

    fn computed_in<R: Real>() -> Self {
        Self { solo: solo::<H, X, R, K> }
    }

    /// The engine of a trajectory.
    pub(crate) fn engine(
        &self,
        method: X,
        parameters: Arc<H::Parameters<f64>>,
        start: Phase<Shaped<H, K>>,
    ) -> Box<dyn Engine<Shaped<H, K>>> {
        let energies = energies(parameters.clone(), energy::<H, K>);
        (self.solo)(method.constants(parameters), start, energies)
    }
}

/// The engine of a trajectory whose steps are computed in `R`.
fn solo<H: Hamiltonian, X: Method<H>, R: Real, K: Keep>(
    constants: Arc<X::Constants>,
    start: Phase<Shaped<H, K>>,
    energies: Arc<dyn Energies<Shaped<H, K>>>,
) -> Box<dyn Engine<Shaped<H, K>>> {
    Box::new(Solo::new(constants, start, X::moves::<R, K>(), energies))
}
