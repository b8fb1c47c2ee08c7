//! The problem of a choice: a system over a span, and the error of a candidate on it.

use super::{ChooseError, Goal, candidate::Candidate};
use crate::{
    check::{
        CheckError,
        oracle::{
            compensated_steps::CompensatedSteps,
            edges::{fewest_steps, greatest_common_divisor},
            exact::Motions,
            reference::{Reference, series_reference},
        },
        property::energy::{Sample, sample},
        start::Start,
        statistics::{
            path::{PARTS, Path, Recorder, Scale},
            points::{flat_start, plain},
        },
    },
    composition::catalogue::SofroniouSpaletta10,
    error::Error,
    hamiltonian::{Hamiltonian, Shaped},
    scalar::tolerance::{largest, ratio, within},
    state::{
        coords::Coords,
        flat::{flat, shaped},
        phase::Phase,
        precision::Precision,
    },
    trajectory::run::Run,
};
use std::time::Instant;

/// The largest number of evaluations of a single run. An arbitrary limit: a small system takes a second for them.
pub(super) const MOST_EVALUATIONS: u64 = 1 << 26;

/// The largest number of halvings of the time until flows in some two thousand evaluations follow the motion: over all
/// of it, these are as many as a run has at most.
const HALVINGS: i32 = 15;

/// The safety factor between the tolerance and the uncertainty of the true motion. The change from one refinement to
/// the next is most of the error of the coarser one; that of the finer one is smaller by a thousand times.
const MARGIN: f64 = 16.0;

/// The number of steps of the motion along which edges are searched for.
const EDGE_SAMPLES: u64 = 1 << 10;

/// The largest number of energy samples of a run.
const ENERGY_SAMPLES: u64 = 4096;

/// Whether rounding has taken over: an error below the root of ε that two halvings of the step have not halved.
pub(super) fn stalled(error: f64, two_halvings_ago: f64, epsilon: f64) -> bool {
    within(error, epsilon.sqrt()) && error > two_halvings_ago / 2.0
}

/// A system, a start, a span and a goal.
pub(super) struct Problem<'s, H: Hamiltonian, K: Precision> {
    pub(super) system: &'s H,
    pub(super) start: Start<Shaped<H, K>>,
    pub(super) span: f64,
    pub(super) goal: Goal,
    /// The true motion; `None` where the energy is the goal.
    exact: Option<Reference>,
    /// The divisor of all numbers of steps: the number of parts of a path, and where the Hamiltonian is defined by
    /// pieces in time, a multiple of it with which steps end where pieces do.
    unit: u64,
}

impl<'s, H: Hamiltonian, K: Precision> Problem<'s, H, K> {
    pub(super) fn new(system: &'s H, start: Start<Shaped<H, K>>, span: f64, goal: Goal) -> Result<Self, ChooseError> {
        let mut problem = Self { system, start, span, goal, exact: None, unit: PARTS };
        if H::PIECEWISE_IN_TIME {
            problem.unit = problem.steps_between_edges()?;
        }
        match goal {
            Goal::Energy(_) if !H::AUTONOMOUS => return Err(CheckError::NotAutonomous.into()),
            Goal::Energy(_) => {}
            Goal::Trajectory(tolerance) => problem.exact = Some(problem.exact_motion(tolerance)?),
        }
        Ok(problem)
    }

    /// The fewest steps that end at all edges and are shared evenly by the parts.
    fn steps_between_edges(&self) -> Result<u64, ChooseError> {
        let start = self.begins();
        let (sampled, _) = self.path(EDGE_SAMPLES);
        let points: Vec<_> =
            [&sampled.start].into_iter().chain(&sampled.ends).map(|point| shaped(&start.phase, point)).collect();
        match fewest_steps(self.system, &points, start.time, self.span) {
            Ok(steps) => Ok(steps * (PARTS / greatest_common_divisor(steps, PARTS))),
            Err(time) => Err(ChooseError::Edge { time, span: self.span }),
        }
    }

    /// The nearest number of steps that can be taken.
    pub(super) fn whole(&self, steps: f64) -> u64 {
        self.unit * ((steps / self.unit as f64).round() as u64).max(1)
    }

    /// The next larger one by an eighth, or by one unit.
    pub(super) fn finer(&self, steps: u64) -> u64 {
        self.whole(steps as f64 * 1.125).max(steps + self.unit)
    }

    /// The true motion: a Taylor series, or a run of order 10 with a compensated state, its step halved until that
    /// changes nothing.
    fn exact_motion(&self, tolerance: f64) -> Result<Reference, ChooseError> {
        let is_known = |reference: &Reference| within(reference.uncertainty() * MARGIN, tolerance);
        if let Some(series) = self.series().filter(is_known) {
            return Ok(series);
        }
        let (mut changes, mut least) = ([f64::INFINITY; 2], f64::INFINITY);
        let run = Reference::refined(
            self.unit..=MOST_EVALUATIONS,
            |steps| self.path(steps),
            |reference| {
                let change = reference.uncertainty();
                least = least.min(change);
                let [two_halvings_ago, last] = changes;
                changes = [last, change];
                is_known(reference) || stalled(change, two_halvings_ago, f64::EPSILON)
            },
        );
        if is_known(&run) { Ok(run) } else { Err(ChooseError::Unfollowed { tolerance, difference: least }) }
    }

    /// One refinement of the true motion, recorded after every step. It has no ends if the run diverges.
    fn path(&self, steps: u64) -> (Path, Scale) {
        let start = self.begins();
        let begin = flat(&start.phase);
        let recorded = || -> Result<_, Error> {
            let mut recorder = Recorder::new(begin.clone(), steps / PARTS);
            let mut run = CompensatedSteps::new(self.system, SofroniouSpaletta10, start, self.span / steps as f64)?;
            for _ in 0..steps {
                recorder.record(run.advance(1)?);
            }
            Ok(recorder.finish())
        };
        recorded().unwrap_or_else(|_| Recorder::new(begin.clone(), 1).finish())
    }

    /// The true motion by a Taylor series, where there is one.
    fn series(&self) -> Option<Reference> {
        let start = self.begins();
        series_reference(
            &Motions { system: self.system, shape: &start.phase },
            &flat_start(&start),
            self.span,
            HALVINGS,
        )
    }

    /// The error of a candidate in `steps` steps, a multiple of [`PARTS`]; infinite where the run breaks off.
    pub(super) fn error(&self, candidate: &Candidate<H, K>, steps: u64) -> f64 {
        let error = match &self.exact {
            Some(exact) => self.ends(candidate, steps).map(|path| path.distance(&exact.path, exact.scale)),
            None => self.deviation(candidate, steps),
        };
        error.unwrap_or(f64::INFINITY)
    }

    /// The start in plain numbers.
    fn begins(&self) -> Start<H::Coords> {
        plain::<H, K>(&self.start.phase).at_time(self.start.time)
    }

    fn begin(&self, candidate: &Candidate<H, K>, steps: u64) -> Result<Run<Shaped<H, K>>, Error> {
        (candidate.begin)(self.system, &self.start, self.span / steps as f64)
    }

    fn ends(&self, candidate: &Candidate<H, K>, steps: u64) -> Result<Path, Error> {
        let mut run = self.begin(candidate, steps)?;
        Path::of_run(flat(&self.start.phase), PARTS, &mut || run.advance(steps / PARTS).map(|_| flat(&run.state())))
    }

    fn deviation(&self, candidate: &Candidate<H, K>, steps: u64) -> Result<f64, Error> {
        let run = self.begin(candidate, steps)?;
        let parameters = self.system.parameters(self.start.phase.q.length());
        let energies = |state: &Phase<Shaped<H, K>>, time| sample::<H, K>(&parameters, state, time);
        let Sample { mut kinetic, energy: first, .. } = energies(&self.start.phase, run.time());
        let mut deviation = 0.0;
        let interval = steps.div_ceil(ENERGY_SAMPLES);
        for sample in run.samples(interval).take((steps / interval + 1) as usize) {
            let sample = sample?;
            let now = energies(&sample.state, sample.time);
            (kinetic, deviation) = (largest([kinetic, now.kinetic]), largest([deviation, now.energy - first]));
        }
        Ok(ratio(deviation, kinetic))
    }

    /// The shortest time that `steps` steps took in three runs.
    pub(super) fn seconds(&self, candidate: &Candidate<H, K>, steps: u64) -> Result<f64, Error> {
        let mut shortest = f64::INFINITY;
        for _ in 0..3 {
            let mut run = self.begin(candidate, steps)?;
            let start = Instant::now();
            run.advance(steps)?;
            shortest = shortest.min(start.elapsed().as_secs_f64());
        }
        Ok(shortest)
    }
}
