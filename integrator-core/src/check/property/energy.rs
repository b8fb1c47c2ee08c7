//! Energy conservation of a run.
//!
//! In: a time-independent system, a method, a start, a step, a number of steps. Out: the largest deviation of the
//! energy, a fitted line, and whether the energy oscillates, walks at random or drifts. Always true: the run is the
//! user's own, in the precision of the user's state; the energy of a symplectic step oscillates about its value until
//! rounding dominates.

use crate::{
    check::{
        CheckError,
        property::order::CLEARANCE,
        start::IntoStart,
        statistics::{
            points::{origin, plain, resolution, run},
            trend::{Course, GROUPS, Trend},
        },
    },
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::{
        dual::Dual,
        real::Real,
        tolerance::{largest, length, ratio, within},
    },
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{Shaped, motion::Motion},
    trajectory::method::Method,
};

/// The number of energy samples of a longer run; a shorter one is sampled after every step.
const SAMPLES: u64 = 4096;

/// The fraction of the kinetic energy beyond which the energy is not conserved, whether it drifts or not. An arbitrary
/// threshold: no motion that resembles the true one crosses it.
const LOST: f64 = 0.5;

/// The deviation of the energy `H` during a run, in units of the largest kinetic energy of the run.
///
/// The value of `H` itself is not a suitable unit: it may be zero, and a constant in `V` changes it. If the parts of
/// `H` are not `T(p)` and `V(q)`, the kinetic energy is `½ p·∂H/∂p`, which is the same for `H` quadratic in `p`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EnergyDrift {
    /// The largest deviation from the start.
    pub deviation: f64,
    /// The root mean square deviation from the start.
    pub mean_deviation: f64,
    /// Whether the energy oscillates, walks at random or drifts, if the run is long enough to distinguish these.
    pub course: Course,
    /// The mean kinetic energy.
    pub mean_kinetic: f64,
    /// The slope of a straight line fitted to the energy, per unit time.
    pub slope: f64,
    /// The standard error of the slope, which takes into account that the values of a random walk are correlated.
    pub uncertainty: f64,
    /// The step of the run.
    pub step: f64,
    /// The number of steps of the run.
    pub steps: u64,
    /// The part of the deviation that rounding explains.
    pub rounding: f64,
}

impl EnergyDrift {
    /// Returns the change of the energy over the run along the fitted line.
    pub fn drift(&self) -> f64 {
        self.slope * self.step * self.steps as f64
    }

    /// Whether the energy error is so large that the run follows another orbit.
    ///
    /// This is the case if the largest deviation exceeds half of the largest kinetic energy, or if the mean deviation
    /// exceeds the mean kinetic energy. The second limit detects a wrong orbit of a comet, whose kinetic energy is
    /// large for short times only. A smaller step helps if the composition is correct.
    pub fn is_lost(&self) -> bool {
        let strays = !within(self.deviation, LOST) || !within(self.mean_deviation, self.mean_kinetic);
        strays && !within(self.deviation, self.rounding)
    }

    /// Whether the deviation shrinks by this power of the step to the one in steps of half the length, `finer`, or
    /// until that one is of the size of its rounding. Of the largest and the mean deviation one may happen to be small.
    pub(crate) fn shrinks_to(&self, finer: &Self, order: f64) -> bool {
        let shrinks = |coarse: f64, fine: f64| within(fine * order.exp2(), coarse);
        shrinks(self.deviation, finer.deviation)
            || shrinks(self.mean_deviation, finer.mean_deviation)
            || within(finer.deviation, CLEARANCE * finer.rounding)
    }

    /// Whether the energy stays, or walks without a slope that is certain: a single encounter of bodies is a step from
    /// which it does not return. Finer steps show whether the step size explains the walk.
    pub(crate) fn may_stay(&self) -> bool {
        self.is_bounded() || (self.course == Course::RandomWalk && !self.is_lost())
    }

    /// Whether the energy error is bounded.
    ///
    /// The energy is not [lost](Self::is_lost), and either rounding explains the deviation or at most half of it is a
    /// trend. A line fitted to `m` periods of a sine accounts for `6/(πm)` of its amplitude, which is less than half
    /// from the fourth period on. A line fitted to a steady loss or gain accounts for nearly all of it.
    pub fn is_bounded(&self) -> bool {
        let trendless = within(self.deviation, self.rounding) || within(self.drift(), self.deviation / 2.0);
        trendless && !self.is_lost()
    }
}

/// Measures the energy over `steps` steps from `start`.
///
/// # Errors
/// - The Hamiltonian depends on time.
/// - There are fewer than 64 steps.
/// - The start or the step is invalid for a run.
/// - The run diverges.
pub fn energy_drift<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<EnergyDrift, CheckError> {
    if !H::AUTONOMOUS {
        return Err(CheckError::NotAutonomous);
    }
    let needed = GROUPS as u64;
    if steps < needed {
        return Err(CheckError::TooFewSteps { steps, needed });
    }
    let begin = start.into_start();
    let mut run = run::<H, X, K>(system, method, &begin, h)?;
    let parameters = system.parameters(run.state().q.length());
    let first = sample::<H, K>(&parameters, &run.state(), run.time());
    let samples = sample_energies(first, steps, &mut |interval| {
        run.advance(interval)?;
        Ok(sample::<H, K>(&parameters, &run.state(), run.time()))
    })?;
    let resolution = resolution(&[&begin.phase, &run.state()]);
    Ok(samples.drift(h, resolution, method.facts().roundings_in(run.steps())))
}

/// The energies at a time.
pub(crate) struct Sample {
    time: f64,
    pub(crate) kinetic: f64,
    pub(crate) energy: f64,
    /// The sum of the sizes of the parts of the energy.
    terms: f64,
}

/// The energies of a state, in the precision of its leaves.
pub(crate) fn sample<H: Hamiltonian, K: Precision>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
) -> Sample {
    let motion = H::Motion::<f64, K>::load(&[parameters], &[state]);
    let (first, other) = (H::kinetic::<f64, K>(&motion, time), H::potential::<f64, K>(&motion, time));
    let kinetic = if const { H::SEPARABLE } { first } else { virial::<H>(parameters, &plain::<H, K>(state), time) };
    Sample { time, kinetic, energy: first + other, terms: first.abs() + other.abs() }
}

/// `½ p·∂H/∂p`, by duals.
fn virial<H: Hamiltonian>(parameters: &H::Parameters<f64>, state: &Phase<H::Coords>, time: f64) -> f64 {
    let along = Phase { q: origin(state).q, p: state.p.clone() };
    let motion = H::Motion::<Dual, f64>::load(&[parameters; 2], &[state, &along]);
    (H::kinetic::<Dual, f64>(&motion, time) + H::potential::<Dual, f64>(&motion, time)).lane(1) / 2.0
}

/// Samples of the energies of a run.
struct EnergySamples {
    /// The number of steps of the run.
    steps: u64,
    /// The time of the start, and the deviations from there, each with its time.
    begin: f64,
    changes: Vec<(f64, f64)>,
    largest_kinetic: f64,
    sum_of_kinetic: f64,
    /// The largest sum of the sizes of both energies.
    largest_term: f64,
}

/// Samples the energies over `steps` steps; `advance` takes some steps and returns the next sample.
fn sample_energies(
    Sample { time: begin, kinetic, energy: first, terms }: Sample,
    steps: u64,
    advance: &mut dyn FnMut(u64) -> Result<Sample, Error>,
) -> Result<EnergySamples, CheckError> {
    let interval = steps.div_ceil(SAMPLES);
    let samples = steps / interval;
    let (mut largest_kinetic, mut largest_term) = (kinetic.abs(), terms);
    let mut changes = Vec::with_capacity(usize::try_from(samples).unwrap_or_default());
    let mut sum_of_kinetic = 0.0;
    for _ in 0..samples {
        let Sample { time, kinetic, energy, terms } = advance(interval)?;
        sum_of_kinetic += kinetic.abs();
        largest_kinetic = largest([largest_kinetic, kinetic]);
        largest_term = largest([largest_term, terms]);
        changes.push((time, energy - first));
    }
    Ok(EnergySamples { steps: samples * interval, begin, changes, largest_kinetic, sum_of_kinetic, largest_term })
}

impl EnergySamples {
    /// Statistics of the samples: of a run in steps of `h` whose states have this `resolution` and were rounded
    /// `roundings` times.
    fn drift(self, h: f64, resolution: f64, roundings: f64) -> EnergyDrift {
        let Self { steps, begin, changes, largest_kinetic, sum_of_kinetic, largest_term } = self;
        let groups: Vec<(f64, f64)> = changes.chunks_exact(changes.len() / GROUPS).take(GROUPS).map(middle).collect();
        let trend = Trend::of(&groups);
        let largest_change = largest(changes.iter().map(|(_, change)| *change));
        let mean = length(changes.iter().map(|(_, change)| *change)) / (changes.len() as f64).sqrt();
        let end = changes.last().map_or(begin, |(time, _)| *time);
        let share = ratio(trend.slope * (end - begin), largest_change);
        // Every flow rounds the state, which changes the energy by up to ε of its terms, at random: the farthest that
        // such a walk gets is about 2.5 times the root of its steps. The factor 16 leaves room for flows that round
        // several numbers, and for the sum of the energy itself.
        let walk = 16.0 * resolution * roundings.sqrt();
        EnergyDrift {
            deviation: ratio(largest_change, largest_kinetic),
            mean_deviation: ratio(mean, largest_kinetic),
            mean_kinetic: ratio(sum_of_kinetic / changes.len() as f64, largest_kinetic),
            course: trend.course(share),
            slope: ratio(trend.slope, largest_kinetic),
            uncertainty: ratio(trend.uncertainty, largest_kinetic),
            step: h,
            steps,
            rounding: ratio(walk * largest_term, largest_kinetic),
        }
    }
}

/// The mean time and the mean value of some samples.
fn middle(samples: &[(f64, f64)]) -> (f64, f64) {
    let count = samples.len() as f64;
    let (time, value) = samples.iter().fold((0.0, 0.0), |sum, sample| (sum.0 + sample.0, sum.1 + sample.1));
    (time / count, value / count)
}
