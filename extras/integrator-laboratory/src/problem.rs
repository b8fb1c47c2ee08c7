//! A Hamiltonian with its start and the time of integration.

use integrator_core::{
    Coords, Facts, Method,
    check::{CheckError, TangentMap, observed_order, tangent_maps},
    prelude::*,
};

/// The description of a system for the laboratory.
pub(crate) struct Problem<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) start: Phase<H::Coords>,
    /// About how long the slowest motion takes to come around.
    pub(crate) period: f64,
    /// How often `H` turns within a period by the time that it reads: twice in each oscillation of a drive.
    pub(crate) turns: u32,
    /// The step of energies and of the blob.
    pub(crate) step: f64,
    /// The radius of the blob of starts around `start`, in the plane of the first position and its momentum, unless a
    /// share of the orbit.
    pub(crate) blob: Option<f64>,
    /// The axes of portraits, horizontal and vertical, counted through all positions and then all momenta: with two
    /// degrees of freedom, `[0, 2]` is q₁ and p₁.
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

    /// A method on this system.
    pub(crate) fn by<M: Method<H>>(&self, method: M) -> Box<dyn Stepped<H::Coords> + '_> {
        Box::new(Of { system: self.system, method })
    }

    /// Returns the step of which a period has so many, and a fraction; the period of the drive, where that is shorter.
    pub(crate) fn step_of(&self, count: u32) -> f64 {
        self.period / f64::from(self.cycles()) / steps_per_period(count)
    }

    /// The number of oscillations of a drive in a period, one at least.
    pub(crate) fn cycles(&self) -> u32 {
        (self.turns / 2).max(1)
    }

    /// The degrees of freedom.
    pub(crate) fn freedom(&self) -> usize {
        self.start.q.flat().len()
    }

    /// Returns the coordinates of a state that portraits show.
    pub(crate) fn seen(&self, state: &Phase<H::Coords>) -> (f64, f64) {
        let numbers = numbers(state);
        (numbers[self.view[0]], numbers[self.view[1]])
    }
}

/// The golden section, whose multiples keep the largest distance from whole numbers.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Returns the number of steps per period: never a whole one. If a step divides the period, the orbit passes the same
/// points in each period, and errors that cancel elsewhere add up.
pub(crate) fn steps_per_period(count: u32) -> f64 {
    f64::from(count) + GOLDEN
}

/// The times within a period at which `H` is read, the share of its range by which it turns, and the rounding of a range.
const SAMPLES: u32 = 4096;
const TURN: f64 = 0.01;
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Counts how often `H` turns within a period while the state stays at the start, or where it is after a quarter: in one
/// of the two a drive may do nothing.
///
/// # Errors
/// A start that is invalid for a run.
pub(crate) fn turns<H: Hamiltonian>(system: &H, start: &Phase<H::Coords>, period: f64) -> Result<u32, Error> {
    if H::AUTONOMOUS {
        return Ok(0);
    }
    let run = |state: &Phase<H::Coords>| system.run_with::<f64, _>(KahanLi8, state.clone(), period / 256.0);
    let mut later = run(start)?;
    let mut most = 0;
    for _ in 0..2 {
        let state = later.state();
        let time = |sample: u32| period * f64::from(sample) / f64::from(SAMPLES);
        let energies: Result<Vec<f64>, Error> =
            (0..=SAMPLES).map(|sample| Ok(run(&state)?.at_time(time(sample)).energy())).collect();
        most = most.max(turns_of(&energies?));
        later.advance(64)?;
    }
    Ok(most)
}

/// Counts the turns of a curve.
fn turns_of(curve: &[f64]) -> u32 {
    let [least, most] = [f64::min, f64::max].map(|of| curve.iter().copied().reduce(of).unwrap_or(0.0));
    let threshold = (TURN * (most - least)).max(ROUNDING * most.abs().max(least.abs()));
    let (mut turns, mut rises, mut low, mut high) = (0, None, f64::INFINITY, f64::NEG_INFINITY);
    for value in curve.iter().copied() {
        (low, high) = (value.min(low), value.max(high));
        let rising = match rises {
            Some(true) | None if high - value > threshold => false,
            Some(false) | None if value - low > threshold => true,
            _ => continue,
        };
        turns += u32::from(rises.is_some());
        (rises, low, high) = (Some(rising), value, value);
    }
    turns
}

/// A method on a system. Whatever is measured goes through this, so that measurements are compiled once for a system and
/// not for each of its methods.
pub(crate) trait Stepped<C: Coords> {
    /// Returns the facts that the method claims.
    fn facts(&self) -> Facts;
    /// A run with plain numbers.
    fn run(&self, start: &Phase<C>, h: f64) -> Result<Run<C>, Error>;
    /// The order that it shows, where that can be measured.
    fn slope(&self, start: &Phase<C>, h: f64) -> Option<f64>;
    /// The tangent maps of one step, of two, and so on.
    fn maps(&self, start: &Phase<C>, h: f64, steps: usize) -> Result<Vec<TangentMap>, CheckError>;
}

struct Of<'s, H, M> {
    system: &'s H,
    method: M,
}

impl<H: Hamiltonian, M: Method<H>> Stepped<H::Coords> for Of<'_, H, M> {
    fn facts(&self) -> Facts {
        self.method.facts()
    }
    fn run(&self, start: &Phase<H::Coords>, h: f64) -> Result<Run<H::Coords>, Error> {
        self.system.run_with::<f64, M>(self.method, start.clone(), h)
    }
    fn slope(&self, start: &Phase<H::Coords>, h: f64) -> Option<f64> {
        Some(observed_order::<H, M, f64>(self.system, self.method, start.clone(), h).ok()?.slope)
    }
    fn maps(&self, start: &Phase<H::Coords>, h: f64, steps: usize) -> Result<Vec<TangentMap>, CheckError> {
        tangent_maps::<H, M, f64>(self.system, self.method, start, h, steps)
    }
}

/// All positions, then all momenta.
pub(crate) fn numbers<C: Coords<Leaf = f64>>(state: &Phase<C>) -> Vec<f64> {
    state.q.flat().iter().chain(state.p.flat()).copied().collect()
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
    use super::{name, turns_of};
    use std::f64::consts::TAU;

    #[test]
    fn a_curve_turns_twice_in_each_oscillation() {
        let curve = |of: fn(f64) -> f64| turns_of(&(0..4096).map(|i| of(f64::from(i) / 4096.0)).collect::<Vec<_>>());
        let square = |t: f64| if (5.0 * t).fract() < 0.5 { 1.0 } else { 2.0 };
        let turns = [curve(|t| (40.0 * TAU * t).cos()), curve(|t| 3.0 + t * t), curve(square)];
        assert_eq!(turns, [79, 0, 8]);
        // Rounding is no drive.
        assert_eq!(curve(|t| 1.0 + 4.0 * f64::EPSILON * (1e3 * t).sin()), 0);
    }

    #[test]
    fn coordinates_have_names_however_many_there_are() {
        let names = [(0, 1), (1, 1), (0, 2), (3, 2), (11, 12), (23, 12)].map(|(index, freedom)| name(index, freedom));
        assert_eq!(names, ["q", "p", "q₁", "p₂", "q₁₂", "p₁₂"]);
    }
}
