//! The modified Hamiltonian: what a step conserves, to higher powers of the step than `H`.

pub(crate) mod brackets;
pub(crate) mod series;

use crate::{
    check::CheckError,
    composition::Composition,
    hamiltonian::Hamiltonian,
    state::{
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
    },
    trajectory::admissible::admissible_with,
};
use brackets::{Jets, Prepared, terms};
use series::BracketSeries;
use std::{fmt, marker::PhantomData, sync::Arc};

/// The modified Hamiltonian of a composition with a step `h`, as a series in `h` up to its fourth power.
///
/// A symplectic step is, up to terms that are smaller than any power of it, the exact flow of another Hamiltonian,
/// `M = H + h·H₁ + h²·H₂ + …`. Its terms are nested Poisson brackets of `T` and `V` (Hairer, Lubich and Wanner,
/// Geometric Numerical Integration, chapter IX). Runs conserve `M`, and their energy oscillates by the difference
/// `M - H`. It prints as this sum, with `{f, g} = Σ ∂f/∂q ∂g/∂p − ∂f/∂p ∂g/∂q`.
///
/// The table of the composition is expanded, whatever composition of `T(p) + V(q)` it is, and brackets are evaluated by
/// derivatives of the generated flows. Terms of higher powers than the fourth are left out, so that a composition of
/// sixth order has none.
///
/// ```
/// use integrator_core::{check::ModifiedHamiltonian, prelude::*};
///
/// struct Oscillator;
///
/// #[hamiltonian]
/// impl Oscillator {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         0.5 * q[0] * q[0]
///     }
/// }
///
/// let start = Phase::new([1.0], [0.0]);
/// let modified = ModifiedHamiltonian::new(&Oscillator, Euler, &start, 0.1)?;
/// println!("{modified}"); // T + V − 1/2·h·{V, T} + 1/12·h²·{{V, T}, T} − 1/12·h²·{{V, T}, V} ...
/// let mut run = Oscillator.run_with(Euler, start, 0.1)?;
/// let before = modified.energy(&run.state());
/// run.advance(7)?;
/// let swing = (run.energy() - 0.5).abs();
/// let change = (modified.energy(&run.state()) - before).abs();
/// assert!(swing > 0.02 && change < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct ModifiedHamiltonian<'s, C> {
    flat: OfFlat<'s>,
    h: f64,
    /// The number of positions, equal to that of momenta.
    coordinates: usize,
    coords: PhantomData<fn(C)>,
}

impl<C> Clone for ModifiedHamiltonian<'_, C> {
    fn clone(&self) -> Self {
        Self { flat: self.flat.clone(), h: self.h, coordinates: self.coordinates, coords: PhantomData }
    }
}

impl<C> fmt::Debug for ModifiedHamiltonian<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ModifiedHamiltonian")
            .field("series", &self.flat.series)
            .field("h", &self.h)
            .finish_non_exhaustive()
    }
}

/// The series; see [`BracketSeries`].
impl<C> fmt::Display for ModifiedHamiltonian<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.flat.series.fmt(f)
    }
}

impl<'s, C: Coords<Leaf = f64>> ModifiedHamiltonian<'s, C> {
    /// Creates the modified Hamiltonian of a system; `like` is any point of it, for the number of coordinates.
    ///
    /// # Errors
    /// - The Hamiltonian reads the time, or its parts are not `T(p)` and `V(q)`.
    /// - The point or the step is invalid for a run.
    pub fn new<H: Hamiltonian<Coords = C> + 's, X: Composition<H>>(
        system: &H,
        composition: X,
        like: &Phase<C>,
        h: f64,
    ) -> Result<Self, CheckError> {
        if !H::AUTONOMOUS {
            return Err(CheckError::NotAutonomous);
        }
        if !H::SEPARABLE {
            return Err(CheckError::NotSeparable { what: "the modified Hamiltonian" });
        }
        admissible_with::<H, _>(composition, like, h)?;
        system.admissible(like.q.length())?;
        let parameters = Arc::new(system.parameters(like.q.length()));
        let system = Arc::new(Prepared::<H> { parameters, shape: like.clone() });
        let coordinates = like.q.flat().len();
        Ok(Self { flat: OfFlat { system, series: BracketSeries::of::<X>() }, h, coordinates, coords: PhantomData })
    }

    /// Returns the series.
    pub fn series(&self) -> &BracketSeries {
        &self.flat.series
    }

    /// Returns the step.
    pub fn step(&self) -> f64 {
        self.h
    }

    /// Returns the value at a point, with all terms that are known.
    pub fn energy(&self, point: &Phase<C>) -> f64 {
        self.energies(point).last().copied().unwrap_or(f64::NAN)
    }

    /// `H` at a point, and its modifications with one [power](BracketSeries::powers) of the step after the other; NaN for a point
    /// of another number of coordinates.
    pub fn energies(&self, point: &Phase<C>) -> Vec<f64> {
        if [&point.q, &point.p].iter().any(|half| half.flat().len() != self.coordinates) {
            return vec![f64::NAN; self.flat.series.powers().len() + 1];
        }
        self.flat.energies(&flat(point), self.h).0
    }

    /// Returns the modified Hamiltonian without the shape of the coordinates, and for any step.
    pub(crate) fn into_flat(self) -> OfFlat<'s> {
        self.flat
    }
}

/// The modified Hamiltonians of all steps, without the shape of the coordinates.
#[derive(Clone)]
pub(crate) struct OfFlat<'s> {
    system: Arc<dyn Jets + 's>,
    pub(crate) series: BracketSeries,
}

impl OfFlat<'_> {
    /// `H` and its modifications with a step, and the size of the terms of `H`.
    pub(crate) fn energies(&self, point: &Flat, h: f64) -> (Vec<f64>, f64) {
        let [kinetic, potential] = self.system.energies(point);
        let terms = terms(&*self.system, &self.series.brackets, point);
        let mut energies = vec![kinetic + potential];
        for power in self.series.powers() {
            let of_power = self.series.brackets.iter().zip(&terms).filter(|(bracket, _)| bracket.power() == power);
            let last = energies[energies.len() - 1];
            energies.push(last + h.powi(power) * of_power.map(|(_, term)| term).sum::<f64>());
        }
        (energies, kinetic.abs() + potential.abs())
    }
}
