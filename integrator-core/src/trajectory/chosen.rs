//! What one trajectory of a system is carried on by, compiled for the instruction sets of which this machine chooses one.

use crate::{
    hamiltonian::{Hamiltonian, Shaped},
    scalar::{instruction_set::InstructionSet, real::Real},
    state::{phase::Phase, precision::Precision},
    system::energy::{Energies, energies, energy},
    trajectory::{
        engine::{Engine, Solo},
        method::Method,
    },
};
use alloc::{boxed::Box, sync::Arc};

/// The engine of a trajectory, computed in what this machine takes.
pub(crate) fn engine<H: Hamiltonian, X: Method<H>, K: Precision>(
    method: X,
    parameters: Arc<H::Parameters<f64>>,
    start: Phase<Shaped<H, K>>,
) -> Box<dyn Engine<Shaped<H, K>>> {
    let energies = energies(parameters.clone(), energy::<H, K>);
    let constants = method.constants(parameters);
    // Known when this is compiled, so that nothing is compiled for the others.
    if const { X::CLONED } {
        match InstructionSet::chosen() {
            InstructionSet::Baseline => computed_in::<H, X, K::Plain, K>(constants, start, energies),
            InstructionSet::Avx512 if X::WIDE => computed_in::<H, X, K::Avx512, K>(constants, start, energies),
            InstructionSet::Fused | InstructionSet::Avx512 => {
                computed_in::<H, X, K::Fused, K>(constants, start, energies)
            }
        }
    } else {
        computed_in::<H, X, K::Plain, K>(constants, start, energies)
    }
}

/// The engine of a trajectory whose steps are computed in `R`.
fn computed_in<H: Hamiltonian, X: Method<H>, R: Real, K: Precision>(
    constants: Arc<X::Constants>,
    start: Phase<Shaped<H, K>>,
    energies: Arc<dyn Energies<Shaped<H, K>>>,
) -> Box<dyn Engine<Shaped<H, K>>> {
    Box::new(Solo::new(constants, start, X::moves::<R, K>(), energies))
}
