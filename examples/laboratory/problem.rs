//! A Hamiltonian with where it starts and how long it is followed.

use integrator_core::{Method, prelude::*};

/// What a row of `systems.rs` says of a system.
pub(crate) struct Problem<H: Hamiltonian> {
    pub(crate) system: H,
    /// `H` and the start, for people.
    pub(crate) formula: &'static str,
    pub(crate) start: Phase<H::Coords>,
    /// About how long the slowest motion takes to come around.
    pub(crate) period: f64,
    /// The step of the phase portraits: coarse, so that errors can be seen.
    pub(crate) step: f64,
    /// The radius of the blob of starts around `start`, in the plane of the first position and its momentum.
    pub(crate) blob: f64,
    /// What portraits show along and up, counted through all positions and then all momenta: with two degrees of
    /// freedom, `[0, 2]` is q₁ and p₁.
    pub(crate) view: [usize; 2],
}

impl<H: Hamiltonian> Problem<H> {
    /// A run with plain numbers.
    pub(crate) fn run<M: Method<H>>(
        &self,
        method: M,
        start: &Phase<H::Coords>,
        h: f64,
    ) -> Result<Run<H::Coords>, Error> {
        self.system.run_with::<f64, M>(method, start.clone(), h)
    }
}

/// All positions, then all momenta.
pub(crate) fn numbers<C: integrator_core::Coords<Leaf = f64>>(state: &Phase<C>) -> Vec<f64> {
    state.q.flat().iter().chain(state.p.flat()).copied().collect()
}

/// The name of one of them.
pub(crate) fn name(index: usize, freedom: usize) -> String {
    let (letter, number) = if index < freedom { ('q', index + 1) } else { ('p', index + 1 - freedom) };
    if freedom == 1 {
        return letter.to_string();
    }
    let lowered = |digit: char| char::from_u32('₀' as u32 + digit as u32 - '0' as u32).unwrap_or(digit);
    format!("{letter}{}", number.to_string().chars().map(lowered).collect::<String>())
}
