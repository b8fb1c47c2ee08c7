//! The problem of a choice: a system over a span, and the error of a candidate on it.

use super::{ChooseError, Goal, candidate::Candidate, splitting::Measured};
use crate::{
    check::{
        CheckError,
        oracle::{edges::greatest_common_divisor, reference::Reference},
        start::Start,
        statistics::path::{PARTS, Path},
    },
    error::Error,
    scalar::tolerance::{largest, ratio, within},
    state::{coords::Coords, flat::flat},
    trajectory::run::Run,
};
use std::time::Instant;

/// The largest number of evaluations of a single run. An arbitrary limit: a small system takes a second for them.
pub(super) const MOST_EVALUATIONS: u64 = 1 << 26;

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

/// A system, a start, a span and a goal. Whatever splitting the candidates are of, the true motion and the energies are
/// those of this one system.
pub(super) struct Problem<'s, C: Coords> {
    system: &'s dyn Measured<C>,
    pub(super) start: Start<C>,
    pub(super) span: f64,
    pub(super) goal: Goal,
    /// The true motion; `None` where the energy is the goal.
    exact: Option<Reference>,
    /// The divisor of all numbers of steps: the number of parts of a path, and where the Hamiltonian is defined by
    /// pieces in time, a multiple of it with which steps end where pieces do.
    unit: u64,
}

impl<'s, C: Coords> Problem<'s, C> {
    pub(super) fn new(
        system: &'s dyn Measured<C>,
        start: Start<C>,
        span: f64,
        goal: Goal,
    ) -> Result<Self, ChooseError> {
        let mut problem = Self { system, start, span, goal, exact: None, unit: PARTS };
        if system.piecewise_in_time() {
            problem.unit = problem.steps_between_edges()?;
        }
        match goal {
            Goal::Energy(_) if !system.autonomous() => return Err(CheckError::NotAutonomous.into()),
            Goal::Energy(_) => {}
            Goal::Trajectory(tolerance) => problem.exact = Some(problem.exact_motion(tolerance)?),
        }
        Ok(problem)
    }

    /// The fewest steps that end at all edges and are shared evenly by the parts.
    fn steps_between_edges(&self) -> Result<u64, ChooseError> {
        let (sampled, _) = self.system.path(&self.start, self.span, EDGE_SAMPLES);
        let points: Vec<_> = [sampled.start].into_iter().chain(sampled.ends).collect();
        match self.system.fewest_steps(&self.start, &points, self.span) {
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

    /// The true motion: a Taylor series, or a run of high order with a compensated state, its step halved until that
    /// changes nothing.
    fn exact_motion(&self, tolerance: f64) -> Result<Reference, ChooseError> {
        let is_known = |reference: &Reference| within(reference.uncertainty() * MARGIN, tolerance);
        if let Some(series) = self.system.series(&self.start, self.span).filter(is_known) {
            return Ok(series);
        }
        let (mut changes, mut least) = ([f64::INFINITY; 2], f64::INFINITY);
        let run = Reference::refined(
            self.unit..=MOST_EVALUATIONS,
            |steps| self.system.path(&self.start, self.span, steps),
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

    /// The error of a candidate in `steps` steps, a multiple of [`PARTS`]; infinite where the run breaks off.
    pub(super) fn error(&self, candidate: &Candidate<'_, C>, steps: u64) -> f64 {
        let error = match &self.exact {
            Some(exact) => self.ends(candidate, steps).map(|path| path.distance(&exact.path, exact.scale)),
            None => self.deviation(candidate, steps),
        };
        error.unwrap_or(f64::INFINITY)
    }

    fn begin(&self, candidate: &Candidate<'_, C>, steps: u64) -> Result<Run<C>, Error> {
        candidate.begin(&self.start, self.span / steps as f64)
    }

    fn ends(&self, candidate: &Candidate<'_, C>, steps: u64) -> Result<Path, Error> {
        let mut run = self.begin(candidate, steps)?;
        if candidate.pace.is_some() {
            let mut part = 0.0;
            return Path::of_run(flat(&self.start.phase), PARTS, &mut || {
                part += 1.0;
                run.advance_to(self.start.time + self.span * part / PARTS as f64).map(|()| flat(&run.state()))
            });
        }
        Path::of_run(flat(&self.start.phase), PARTS, &mut || run.advance(steps / PARTS).map(|_| flat(&run.state())))
    }

    fn deviation(&self, candidate: &Candidate<'_, C>, steps: u64) -> Result<f64, Error> {
        let run = self.begin(candidate, steps)?;
        let energies = self.system.energies(self.start.phase.q.length());
        let [mut kinetic, first] = energies(&self.start.phase, run.time());
        let mut deviation = 0.0;
        let interval = steps.div_ceil(ENERGY_SAMPLES);
        for sample in run.samples(interval).take((steps / interval + 1) as usize) {
            let sample = sample?;
            let [now, energy] = energies(&sample.state, sample.time);
            (kinetic, deviation) = (largest([kinetic, now]), largest([deviation, energy - first]));
        }
        Ok(ratio(deviation, kinetic))
    }

    /// A run by a method with steps of its own over the span, and the shortest time of three.
    pub(super) fn whole_run(&self, candidate: &Candidate<'_, C>) -> Result<(Run<C>, f64), Error> {
        let timed = || -> Result<_, Error> {
            let mut run = self.begin(candidate, self.unit)?;
            let start = Instant::now();
            run.advance(self.unit)?;
            Ok((run, start.elapsed().as_secs_f64()))
        };
        let (run, first) = timed()?;
        Ok((run, first.min(timed()?.1).min(timed()?.1)))
    }

    /// The work of `steps` steps, of a run that counts it where they differ.
    pub(super) fn evaluations(&self, candidate: &Candidate<'_, C>, steps: u64) -> Result<u64, Error> {
        if !candidate.counts {
            return Ok(candidate.evaluations(steps));
        }
        let mut run = self.begin(candidate, steps)?;
        run.advance(steps)?;
        Ok(run.evaluations())
    }

    /// The shortest time that `steps` steps took in three runs, without what is computed once for the durations of the
    /// stages.
    pub(super) fn seconds(&self, candidate: &Candidate<'_, C>, steps: u64) -> Result<f64, Error> {
        let mut shortest = f64::INFINITY;
        for _ in 0..3 {
            let mut run = self.begin(candidate, steps)?;
            // The second step is the first one with all durations of a step between others.
            let first = (steps - 1).min(2);
            run.advance(first)?;
            let start = Instant::now();
            if candidate.pace.is_some() {
                run.advance_to(self.start.time + self.span)?;
                shortest = shortest.min(start.elapsed().as_secs_f64());
                continue;
            }
            run.advance(steps - first)?;
            let share = steps as f64 / (steps - first) as f64;
            shortest = shortest.min(start.elapsed().as_secs_f64() * share);
        }
        Ok(shortest)
    }
}
