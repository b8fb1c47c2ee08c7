//! A Hamiltonian with its start and the time of integration.

use integrator_core::{
    Coords, Facts, Method,
    check::{CheckError, TangentMap, observed_order, tangent_maps, turns_in_time},
    prelude::*,
};
use std::f64::consts::{PI, TAU};

/// The description of a system for the laboratory.
pub(crate) struct Problem<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) start: Phase<H::Coords>,
    /// About how long the slowest motion takes to come around.
    pub(crate) period: f64,
    /// How often `H` turns within a period by the time that it reads: twice in each oscillation of a drive.
    pub(crate) turns: u64,
    /// By how much the fastest part of the orbit is faster than an oscillation of this period; one at least.
    pub(crate) haste: u32,
    /// The step of energies and of the blob.
    pub(crate) step: f64,
    /// The radius of the blob of starts around `start`, in the plane of the first position and its momentum, unless a
    /// share of the orbit.
    pub(crate) blob: Option<f64>,
    /// The axes of portraits, horizontal and vertical, counted through all positions and then all momenta: with two
    /// degrees of freedom, `[0, 2]` is q₁ and p₁.
    pub(crate) view: [usize; 2],
    /// The positions that are angles, which portraits show between −π and π.
    pub(crate) angles: Vec<usize>,
    /// The symbols of the coordinates, positions first.
    pub(crate) symbols: Vec<String>,
    /// `T'' V''` in these symbols.
    pub(crate) curvature: String,
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

    /// Returns the step of which a period has `count` and a fraction, or that of the fastest motion.
    pub(crate) fn step_of(&self, count: u32) -> f64 {
        self.period / f64::from(self.cycles()) / steps_per_period(count)
    }

    /// The number of oscillations of a drive in a period, one at least.
    pub(crate) fn drive(&self) -> u32 {
        (self.turns / 2).max(1) as u32
    }

    /// The number of oscillations of the fastest motion in a period: of a drive, or of the system itself.
    pub(crate) fn cycles(&self) -> u32 {
        self.drive().max(self.haste)
    }

    /// The state with these numbers: all positions, then all momenta.
    pub(crate) fn state(&self, numbers: &[f64]) -> Phase<H::Coords> {
        let mut state = self.start.clone();
        let (q, p) = numbers.split_at(self.freedom());
        state.q.flat_mut().copy_from_slice(q);
        state.p.flat_mut().copy_from_slice(p);
        state
    }

    /// The degrees of freedom.
    pub(crate) fn freedom(&self) -> usize {
        self.start.q.flat().len()
    }

    /// Returns the coordinates of a state that portraits show.
    pub(crate) fn seen(&self, state: &Phase<H::Coords>) -> (f64, f64) {
        let numbers = numbers(state);
        let [x, y] = self.view.map(|index| match self.angles.contains(&index) {
            true => wrapped(numbers[index]),
            false => numbers[index],
        });
        (x, y)
    }
}

/// The golden section, whose multiples keep the largest distance from whole numbers.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Returns the number of steps per period: never a whole one. If a step divides the period, the orbit passes the same
/// points in each period, and errors that cancel elsewhere add up.
pub(crate) fn steps_per_period(count: u32) -> f64 {
    f64::from(count) + GOLDEN
}

/// Counts how often `H` turns within a period by its explicit time, with the state at the start or where it is after a
/// quarter: in one of the two a drive may do nothing.
///
/// # Errors
/// A start that is invalid for a run, or a motion that diverges.
pub(crate) fn turns<H: Hamiltonian>(system: &H, start: &Phase<H::Coords>, period: f64) -> Result<u64, CheckError> {
    if H::AUTONOMOUS {
        return Ok(0);
    }
    let mut later = system.run_with::<f64, _>(KahanLi8, start.clone(), period / 256.0)?;
    later.advance(64)?;
    let at = |state| turns_in_time::<H, f64>(system, state, period);
    Ok(at(start)?.max(at(&later.state())?))
}

/// The number of samples in a period from which the speed of a motion follows, and the largest ratio of speeds that steps resolve.
const SAMPLES: u32 = 1024;
const HASTE: f64 = 50.0;

/// Compares the largest speed along the orbit, in units of its size, with that of an oscillator: a comet passes the perihelion in a
/// small part of its period.
///
/// # Errors
/// A start that is invalid for a run, or a motion that diverges.
pub(crate) fn haste<H: Hamiltonian>(system: &H, start: &Phase<H::Coords>, period: f64) -> Result<u32, Error> {
    let h = period / f64::from(SAMPLES);
    let run = system.run_with::<f64, _>(KahanLi8, start.clone(), h)?;
    let samples = run.samples(1).take(SAMPLES as usize + 1);
    let states = samples.map(|sample| Ok(numbers(&sample?.state))).collect::<Result<Vec<_>, Error>>()?;
    let freedom = start.q.flat().len();
    let square = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|number| number * number).sum::<f64>();
    let speeds = [0..freedom, freedom..2 * freedom].map(|part| {
        let range = |i: usize| {
            let of = || states.iter().map(|state| state[i]);
            0.5 * (of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min))
        };
        let steps = states.windows(2).map(|pair| square(&mut part.clone().map(|i| pair[1][i] - pair[0][i])));
        (steps.fold(0.0, f64::max) / square(&mut part.clone().map(range))).sqrt() / h
    });
    // A free particle has no range of momenta.
    let most = speeds.into_iter().filter(|speed| speed.is_finite()).fold(0.0, f64::max);
    Ok((most * period / TAU).clamp(1.0, HASTE) as u32)
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

/// An angle between −π and π.
pub(crate) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// A curve that is broken where an angle passes from one side of the frame to the other.
pub(crate) fn broken(points: &[(f64, f64)], is_angle: [bool; 2]) -> Vec<(f64, f64)> {
    let mut curve: Vec<(f64, f64)> = Vec::with_capacity(points.len());
    for point in points {
        let jumps = |last: &(f64, f64)| {
            is_angle[0] && (last.0 - point.0).abs() > PI || is_angle[1] && (last.1 - point.1).abs() > PI
        };
        if curve.last().is_some_and(jumps) {
            curve.push((f64::NAN, f64::NAN));
        }
        curve.push(*point);
    }
    curve
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
    use super::name;

    #[test]
    fn coordinates_have_names_however_many_there_are() {
        let names = [(0, 1), (1, 1), (0, 2), (3, 2), (11, 12), (23, 12)].map(|(index, freedom)| name(index, freedom));
        assert_eq!(names, ["q", "p", "q₁", "p₂", "q₁₂", "p₁₂"]);
    }
}
