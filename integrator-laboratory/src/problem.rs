//! A Hamiltonian with where it starts and how long it is followed.

use integrator_core::{Coords, Method, prelude::*};

/// What the laboratory is told of a system.
pub(crate) struct Problem<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) start: Phase<H::Coords>,
    /// About how long the slowest motion takes to come around.
    pub(crate) period: f64,
    /// The step of energies and of the blob.
    pub(crate) step: f64,
    /// The radius of the blob of starts around `start`, in the plane of the first position and its momentum.
    pub(crate) blob: f64,
    /// What portraits show along and up, counted through all positions and then all momenta: with two degrees of
    /// freedom, `[0, 2]` is q₁ and p₁.
    pub(crate) view: [usize; 2],
}

impl<H: Hamiltonian> Problem<'_, H> {
    /// A run with plain numbers.
    pub(crate) fn run<M: Method<H>>(
        &self,
        method: M,
        start: &Phase<H::Coords>,
        h: f64,
    ) -> Result<Run<H::Coords>, Error> {
        self.system.run_with::<f64, M>(method, start.clone(), h)
    }

    /// The degrees of freedom.
    pub(crate) fn freedom(&self) -> usize {
        self.start.q.flat().len()
    }

    /// What portraits show of a state.
    pub(crate) fn seen(&self, state: &Phase<H::Coords>) -> (f64, f64) {
        let numbers = numbers(state);
        (numbers[self.view[0]], numbers[self.view[1]])
    }
}

/// All positions, then all momenta.
pub(crate) fn numbers<C: Coords<Leaf = f64>>(state: &Phase<C>) -> Vec<f64> {
    state.q.flat().iter().chain(state.p.flat()).copied().collect()
}

/// The distance of two states in units of the second one.
pub(crate) fn distance(state: &[f64], reference: &[f64]) -> f64 {
    let apart: f64 = state.iter().zip(reference).map(|(a, b)| (a - b).powi(2)).sum();
    let size: f64 = reference.iter().map(|x| x * x).sum();
    (apart / size).sqrt()
}

/// The name of a coordinate.
pub(crate) fn name(index: usize, freedom: usize) -> String {
    let (letter, number) = if index < freedom { ('q', index + 1) } else { ('p', index + 1 - freedom) };
    if freedom == 1 {
        return letter.to_string();
    }
    let lowered = |digit: char| char::from_u32('₀' as u32 + digit as u32 - '0' as u32).unwrap_or(digit);
    format!("{letter}{}", number.to_string().chars().map(lowered).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn coordinates_have_names_however_many_there_are() {
        let names = [(0, 1), (1, 1), (0, 2), (3, 2), (11, 12), (23, 12)].map(|(index, freedom)| name(index, freedom));
        assert_eq!(names, ["q", "p", "q₁", "p₂", "q₁₂", "p₁₂"]);
    }
}
