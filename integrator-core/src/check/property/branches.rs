//! The branches of `H` that an orbit crosses, where deviation vectors may lose their meaning.
//!
//! In: a system, a method, a start, a step. Out: the comparisons in the energies whose result changes between two
//! states of the run. Always true: the comparisons are those of the generated energies at the states of the run; a
//! branch that is crossed twice within a step is not detected.

use crate::{
    check::{
        CheckError,
        start::{IntoStart, Start},
    },
    error::Number,
    hamiltonian::Hamiltonian,
    scalar::watched::{Side, Watched, sides_of},
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{Shaped, energy::part_names, motion::Motion},
    trajectory::method::Method,
};
use core::fmt;

/// A comparison in an energy whose result changes along an orbit.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Crossing {
    /// The function that contains the comparison.
    pub part: &'static str,
    /// The index of the comparison within the function, from 1, in order of evaluation.
    pub number: usize,
    /// The operator or function that compares, such as `<` or `abs`.
    pub by: &'static str,
    /// The number of steps in which this was the first comparison of its function to change.
    pub times: u64,
    /// The index of the first of these steps, and the time at its end.
    pub first: (u64, f64),
    /// The two operands before and after that step. For a function of one argument: the argument, and the position of
    /// the kink or the integer.
    pub operands: [[f64; 2]; 2],
}

impl fmt::Display for Crossing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, number, by, times, first: (step, time), operands } = self;
        let ([[a, b], [c, d]], time) = ((*operands).map(|side| side.map(Number)), Number(*time));
        write!(
            f,
            "comparison {number} of `{part}`, by `{by}`, in {times} steps, the first of which is step {step} to a time of \
             {time}: from {a} and {b} to {c} and {d}"
        )
    }
}

/// The branches of `H` that an orbit crosses. `Display` lists them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Branches {
    /// The number of comparisons in the energies at the start.
    pub comparisons: usize,
    /// The comparisons whose result changed, in the order of the first change. If several comparisons of a function
    /// change in one step, only the first is recorded, since it may decide which others are evaluated.
    pub crossed: Vec<Crossing>,
    /// The number of steps of the orbit.
    pub steps: u64,
}

impl fmt::Display for Branches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { comparisons, crossed, steps } = self;
        if crossed.is_empty() {
            return write!(f, "no branch is crossed in {steps} steps; the energies make {comparisons} comparisons");
        }
        write!(
            f,
            "branches are crossed: where a force jumps there, deviation vectors are the derivatives of the steps and not \
             those of the motion"
        )?;
        crossed.iter().try_for_each(|crossing| write!(f, "\n{crossing}"))
    }
}

/// Finds the branches of `H` that the orbit from `start` crosses in `steps` steps of `h`.
///
/// Deviation vectors are multiplied by the derivative of each step, on the current side of every branch. If the force
/// is discontinuous, as for `abs`, neighbouring orbits cross at different times, and the derivative of a step does not
/// contain this effect. A kink of the force, as for `max(q, 0)²`, does no harm. The check does not distinguish a jump
/// from a kink.
///
/// The energies are evaluated after each step, which costs about as much as a step with few stages.
///
/// ```
/// use integrator_core::{check::branches, prelude::*};
///
/// struct Ball;
///
/// #[hamiltonian]
/// impl Ball {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { q[0].abs() }
/// }
///
/// // It falls for a time of √2 to the kink at the origin.
/// let found = branches(&Ball, Verlet, Phase::new([1.0], [0.0]), 0.01, 200)?;
/// assert_eq!((found.crossed[0].part, found.crossed[0].by), ("potential", "abs"));
/// assert!((found.crossed[0].first.1 - 2.0_f64.sqrt()).abs() < 0.01);
/// println!("{found}");
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The run diverges.
pub fn branches<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<Branches, CheckError> {
    let Start { phase, time } = start.into_start();
    let parameters = system.parameters(phase.q.length());
    let mut run = system.run_with::<K, X>(method, phase, h)?.at_time(time);
    // An unsuitable time is an error before any energy is evaluated.
    run.advance(0)?;
    let mut before = sides_at::<H, K>(&parameters, &run.state(), run.time());
    let mut found = Branches { comparisons: before.iter().map(Vec::len).sum(), crossed: Vec::new(), steps };
    for step in 1..=steps {
        run.advance(1)?;
        let after = sides_at::<H, K>(&parameters, &run.state(), run.time());
        for ((part, before), after) in part_names(H::PARTS).into_iter().zip(&before).zip(&after) {
            found.note(part, [before, after], (step, run.time()));
        }
        before = after;
    }
    Ok(found)
}

impl Branches {
    /// Notes the first comparison of a part whose side is another one after a step.
    fn note(&mut self, part: &'static str, [before, after]: [&[Side]; 2], first: (u64, f64)) {
        let changed = |(before, after): (&Side, &Side)| before.taken != after.taken;
        let Some(place) = before.iter().zip(after).position(changed) else { return };
        let (number, by) = (place + 1, before[place].by);
        let known = |known: &&mut Crossing| (known.part, known.number) == (part, number);
        match self.crossed.iter_mut().find(known) {
            Some(known) => known.times += 1,
            None => {
                let operands = [before[place].operands, after[place].operands];
                self.crossed.push(Crossing { part, number, by, times: 1, first, operands });
            }
        }
    }
}

/// The sides that the two energies take at a state.
fn sides_at<H: Hamiltonian, K: Precision>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
) -> [Vec<Side>; 2] {
    let state = Phase { q: state.q.map(Precision::to_f64), p: state.p.map(Precision::to_f64) };
    let motion = H::Motion::<Watched, f64>::load(&[parameters; 2], &[&state; 2]);
    let (_, kinetic) = sides_of(|| H::kinetic::<Watched, f64>(&motion, time));
    let (_, potential) = sides_of(|| H::potential::<Watched, f64>(&motion, time));
    [kinetic, potential]
}
