//! One indicator for many orbits of a system, in SIMD lanes and on threads.

use crate::{
    chaos::{
        growth::{Growth, logarithm, logarithms, of_length, steps_between_samples},
        indicators::{LEAST, OF_A_STEP, generic_direction},
    },
    check::CheckError,
    ensemble::{in_lanes, lane_scalars::LaneScalars, member, members::refusal},
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::exact::power_of_two,
    state::{
        clock::Clock,
        coords::Coords,
        phase::{Phase, StartOf},
        point::Point,
        precision::Precision,
    },
    system::{Shaped, energy::energy},
    threads::{all_threads, in_turns},
    trajectory::{
        dispatch::Deviations,
        engine::Engine,
        method::Memoryless,
        motions::{Form, Motions, show},
        tangent::{self, BETWEEN_SCALES, Units, far_exponent, may_be_far, refused, scaled},
    },
};
use std::sync::Arc;

/// The indicator that a map computes for each orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indicator {
    /// The time average of MEGNO: 2 on regular orbits, larger on chaotic ones.
    Megno,
    /// The estimate of the largest exponent.
    Exponent,
    /// The fast Lyapunov indicator.
    Fli,
}

/// Computes an indicator of the orbit from each start, over `steps` steps of length `h` from time 0.
///
/// Results are in the order of the starts, and bitwise independent of the other orbits and of the number of threads.
///
/// - If an orbit or its deviation vector diverges, its indicator is that of the last sample; NaN if there is none.
/// - If the energy of a state on the orbit is not finite, its indicator is NaN.
///
/// [`map_while`] also returns how each orbit ended, and can stop orbits that are ejected.
///
/// # Errors
/// - [`Error::Member`]: one start, or every one, is invalid.
/// - [`Error::Members`]: several, but not all, are invalid.
/// - [`CheckError::TooFewSteps`]: `steps` is too small.
pub fn map<H, X, K>(
    system: &H,
    method: X,
    starts: impl IntoIterator<Item = Phase<Shaped<H, K>>, IntoIter: Iterator<Item: StartOf<Shaped<H, K>, Leaf = K>>>,
    h: f64,
    steps: u64,
    indicator: Indicator,
) -> Result<Vec<f64>, CheckError>
where
    H: Hamiltonian,
    X: Memoryless<H>,
    K: LaneScalars,
{
    let starts: Vec<_> = starts.into_iter().collect();
    let found = followed::<H, X, K>(system, method, &starts, (h, steps), indicator, None)?;
    let (mut indicators, mut members) = (Vec::with_capacity(found.len()), Vec::new());
    for (member, Mapped { value, end, .. }) in found.into_iter().enumerate() {
        match end {
            End::Refused(error) => members.push((member, error)),
            End::NoEnergy => indicators.push(f64::NAN),
            End::Followed | End::Gone | End::Lost => indicators.push(value),
        }
    }
    if members.is_empty() { Ok(indicators) } else { Err(refusal(members, starts.len()).into()) }
}

/// The result of a map for one orbit.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mapped {
    /// The indicator at the end of the orbit, or at the last sample before it diverged; NaN if there is none.
    pub value: f64,
    /// The integration time of this orbit.
    pub time: f64,
    /// The outcome of the orbit.
    pub end: End,
}

/// The outcome of an orbit of a map: integrated to the end, stopped by the condition, or failed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum End {
    /// The orbit was integrated for all steps.
    Followed,
    /// The condition of [`map_while`] was violated, for example by an ejection or a collision.
    Gone,
    /// The state or the deviation vector diverged, or an implicit method could not solve a step.
    Lost,
    /// The energy is not finite although forces are: a step left the domain of `H`.
    NoEnergy,
    /// The start is invalid.
    Refused(Error),
}

/// Computes indicators like [`map`], and stops each orbit when `stays(state)` returns `false`.
///
/// An example of `stays` is a maximal distance from the centre. Invalid starts are marked in the result; all other orbits
/// are integrated.
///
/// `stays` is called when the indicator is sampled: about a hundred times in all, and at least every 64 steps. Energies are
/// checked at every eighth sample and at the end. Orbits that end early have small indicators like regular orbits;
/// [`Mapped::end`] distinguishes them.
///
/// ```
/// use integrator_core::{chaos::{self, End, Indicator}, check::CheckError, prelude::*};
///
/// struct HenonHeiles;
///
/// #[hamiltonian]
/// impl HenonHeiles {
///     fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
///         (px * px + py * py) / 2.0
///     }
///     fn potential(&self, [x, y]: [f64; 2]) -> f64 {
///         (x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
///     }
/// }
///
/// // The third one escapes over a saddle.
/// let starts = [0.1, 0.2, 0.7].map(|p| Phase::new([0.0, 0.1], [p, 0.1]));
/// let within = |state: &Phase<[f64; 2]>| state.q[0].hypot(state.q[1]) < 2.0;
/// let found = chaos::map_while(&HenonHeiles, Yoshida4, starts, 0.2, 1_000, Indicator::Megno, within)?;
/// let ends: Vec<_> = found.iter().map(|orbit| &orbit.end).collect();
/// assert_eq!(ends, [&End::Followed, &End::Followed, &End::Gone]);
/// assert!(found[2].time < 200.0);
/// # Ok::<(), CheckError>(())
/// ```
///
/// # Errors
/// - [`CheckError::TooFewSteps`]: `steps` is too small.
/// - [`CheckError::Run`]: the step `h` is invalid.
pub fn map_while<H, X, K>(
    system: &H,
    method: X,
    starts: impl IntoIterator<Item = Phase<Shaped<H, K>>, IntoIter: Iterator<Item: StartOf<Shaped<H, K>, Leaf = K>>>,
    h: f64,
    steps: u64,
    indicator: Indicator,
    stays: impl Fn(&Phase<Shaped<H, K>>) -> bool + Sync,
) -> Result<Vec<Mapped>, CheckError>
where
    H: Hamiltonian,
    X: Memoryless<H>,
    K: LaneScalars,
{
    let starts: Vec<_> = starts.into_iter().collect();
    followed::<H, X, K>(system, method, &starts, (h, steps), indicator, Some(&stays))
}

/// The orbits from all starts.
fn followed<H, X, K>(
    system: &H,
    method: X,
    starts: &[Phase<Shaped<H, K>>],
    (h, steps): (f64, u64),
    indicator: Indicator,
    stays: Option<&Stays<Shaped<H, K>>>,
) -> Result<Vec<Mapped>, CheckError>
where
    H: Hamiltonian,
    X: Memoryless<H>,
    K: LaneScalars,
{
    if steps < LEAST {
        return Err(CheckError::TooFewSteps { steps, needed: LEAST });
    }
    let mut found: Vec<Option<Mapped>> = starts
        .iter()
        .map(|start| admissible_start::<H, X, K>(system, method, start, h).err())
        .map(|refused| Some(Mapped { value: f64::NAN, time: 0.0, end: End::Refused(refused?) }))
        .collect();
    let clock = Clock { t0: 0.0, h, steps: 0 };
    if found.iter().any(Option::is_none) {
        clock.end(steps)?;
    }
    // Constants may depend on the number of bodies: starts of different sizes do not share them.
    let mut lengths: Vec<_> = starts.iter().map(|start| start.q.length()).collect();
    lengths.sort_unstable();
    lengths.dedup();
    for length in lengths {
        let is_of_group = |member: &usize| starts[*member].q.length() == length && found[*member].is_none();
        let members: Vec<_> = (0..starts.len()).filter(is_of_group).collect();
        if members.is_empty() {
            continue;
        }
        let parameters = Arc::new(system.parameters(length));
        let constants = Arc::new(vec![method.constants(parameters.clone())]);
        let like = in_lanes::<H, X, K, Deviations<1>>(constants);
        let group = like.lanes() * like.together() / LANES_OF_ORBIT;
        let look = Look { stays, energy: &|state, time| energy::<H, K>(&parameters, state, time, None).total };
        let follow = |members: &[usize]| {
            let starts = members.iter().map(|member| starts[*member].clone()).collect();
            Batch::new(&*like, starts, h).follow(clock, steps, indicator, look)
        };
        for (member, mapped) in side_by_side(&members, group, &follow) {
            found[member] = Some(mapped);
        }
    }
    Ok(found.into_iter().flatten().collect())
}

/// Whether an orbit continues from a state.
type Stays<'s, C> = dyn Fn(&Phase<C>) -> bool + Sync + 's;

/// The conditions on the state of an orbit.
struct Look<'l, C> {
    stays: Option<&'l Stays<'l, C>>,
    energy: &'l (dyn Fn(&Phase<C>, f64) -> f64 + Sync),
}

impl<C> Clone for Look<'_, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Look<'_, C> {}

/// Whether a run with a vector would begin at a start.
fn admissible_start<H, X, K>(system: &H, method: X, start: &Phase<Shaped<H, K>>, h: f64) -> Result<(), Error>
where
    H: Hamiltonian,
    X: Memoryless<H>,
    K: Precision,
{
    refused::<H, K>(start)?;
    let parameters = member::<H, K, X>(system, method, start, h)?;
    energy::<H, K>(&parameters, start, 0.0, None).admissible(0.0)
}

/// The lanes of an orbit: its state, and one vector.
const LANES_OF_ORBIT: usize = 2;

/// The largest number of groups of orbits that are sampled together. The orbits of a group go through the stages
/// together. A sample begins and ends many loops, and the states of four groups are still near the processor.
const GROUPS: usize = 4;

/// The values of all members, in groups, on all threads. A free thread takes the next group; no value
/// depends on the thread.
fn side_by_side(
    members: &[usize],
    group: usize,
    follow: &(dyn Fn(&[usize]) -> Vec<Mapped> + Sync),
) -> Vec<(usize, Mapped)> {
    let groups = members.len().div_ceil(group);
    let together = groups.div_ceil(all_threads()).min(GROUPS) * group;
    let found = in_turns(members.chunks(together).collect(), follow);
    members.iter().copied().zip(found.into_iter().flatten()).collect()
}

/// Orbits in the lanes of one motion.
struct Batch<C: Coords> {
    engine: Engine,
    orbits: Vec<Orbit>,
    shape: Phase<C>,
    /// The sums of the squares of the positions and momenta of all vectors at the last sample.
    squares: Vec<[f64; 2]>,
    /// The squares of the lengths of these vectors in their units, and their logarithms.
    lengths: Vec<f64>,
    logarithms: Vec<f64>,
}

/// An orbit of a batch.
struct Orbit {
    growth: Growth,
    /// The units in which its vector is measured.
    units: Units,
    /// The power of two by which its vector was divided.
    exponent: i64,
    /// The outcome of the orbit, if it has ended: another orbit uses its lanes.
    end: Option<End>,
}

/// The interval in samples at which energies are read, which takes about as long as a step without a vector.
const BETWEEN_ENERGIES: u64 = 8;

impl<C: Coords> Batch<C> {
    /// The orbits from some starts; there is one at least.
    fn new(like: &dyn Motions, starts: Vec<Phase<C>>, h: f64) -> Self {
        let shape = starts[0].clone();
        let units = units_of(like, &starts, h);
        let vectors = starts.iter().zip(&units).map(|(start, units)| units.stretched(generic_direction(start, 0)));
        let lanes: Vec<_> = starts.iter().cloned().zip(vectors).flat_map(|(start, vector)| [start, vector]).collect();
        let engine = engine(like, &lanes);
        let orbit = |(number, units): (usize, Units)| {
            let length = logarithm(&lanes[LANES_OF_ORBIT * number + 1], 0, units);
            Orbit { growth: Growth::new(length), units, exponent: 0, end: None }
        };
        let orbits: Vec<_> = units.into_iter().enumerate().map(orbit).collect();
        let squares = vec![[0.0; 2]; engine.motions.lanes() * engine.motions.count() / LANES_OF_ORBIT];
        Self { engine, orbits, shape, squares, lengths: Vec::new(), logarithms: Vec::new() }
    }

    /// Returns the values of an indicator after this number of steps.
    fn follow(mut self, mut clock: Clock, steps: u64, indicator: Indicator, look: Look<'_, C>) -> Vec<Mapped> {
        let every = steps_between_samples(steps);
        while clock.steps < steps && self.orbits.iter().any(|orbit| orbit.end.is_none()) {
            let end = (clock.steps + every).min(steps);
            while clock.steps < end {
                let mut taken = 0;
                self.engine.advance(clock, end - clock.steps, &mut taken);
                clock.steps += taken;
                if clock.steps < end && !self.replace_lost() {
                    break;
                }
            }
            let reads_energies = clock.steps == steps || (end / every).is_multiple_of(BETWEEN_ENERGIES);
            let has_ended = self.look(clock, look, reads_energies);
            self.sample(clock);
            if has_ended && !self.replace_ended() {
                break;
            }
        }
        let mapped = |Orbit { growth, end, .. }: Orbit| Mapped {
            value: growth.indicator(indicator),
            time: growth.time(),
            end: end.unwrap_or(End::Followed),
        };
        self.orbits.into_iter().map(mapped).collect()
    }

    /// Ends orbits that do not stay, or have no energy; whether there are any.
    fn look(&mut self, clock: Clock, look: Look<'_, C>, reads_energies: bool) -> bool {
        if look.stays.is_none() && !reads_energies {
            return false;
        }
        let (mut point, time, orbits) = (self.shape.clone(), clock.at(clock.steps), &mut self.orbits);
        let mut has_ended = false;
        self.engine.read(clock, |completed, shown| {
            for (number, orbit) in orbits.iter_mut().enumerate().filter(|(_, orbit)| orbit.end.is_none()) {
                show(completed, shown, LANES_OF_ORBIT * number, &mut point);
                if reads_energies && !(look.energy)(&point, time).is_finite() {
                    orbit.end = Some(End::NoEnergy);
                } else if look.stays.is_some_and(|stays| !stays(&point)) {
                    orbit.end = Some(End::Gone);
                }
                has_ended |= orbit.end.is_some();
            }
        });
        has_ended
    }

    /// Reads all vectors, and divides those by powers of two that are far from one.
    fn sample(&mut self, clock: Clock) {
        self.read_squares(clock);
        self.lengths.clear();
        self.lengths.extend(self.orbits.iter().zip(&self.squares).map(|(orbit, sums)| orbit.units.square(*sums)));
        self.logarithms.clone_from(&self.lengths);
        logarithms(&mut self.logarithms);
        let (time, engine) = (clock.at(clock.steps), &self.engine);
        let vector = |number| vector(engine, clock, number, &self.shape);
        let known = self.lengths.iter().zip(&self.logarithms);
        for ((number, orbit), (square, of_square)) in self.orbits.iter_mut().enumerate().zip(known) {
            if orbit.end.is_none() {
                let vector = || orbit.units.measured(vector(number));
                let length = of_length(*square, *of_square, orbit.exponent, vector);
                orbit.growth.sample(time, length);
            }
        }
        // At steps where a run with vectors divides them, too.
        if clock.steps.is_multiple_of(BETWEEN_SCALES) {
            self.scale(clock);
        }
    }

    /// Finds the sums of the squares of the positions and momenta of all vectors.
    fn read_squares(&mut self, clock: Clock) {
        let (mut point, squares) = (self.shape.clone(), &mut self.squares);
        self.engine.read(clock, |completed, shown| {
            if shown.is_none() && completed.squares(&mut point, squares) {
                return;
            }
            for (number, sums) in squares.iter_mut().enumerate() {
                show(completed, shown, LANES_OF_ORBIT * number + 1, &mut point);
                *sums = tangent::squares(&point);
            }
        });
    }

    /// Divides vectors by powers of two that are far from one.
    fn scale(&mut self, clock: Clock) {
        let exponent = |(number, orbit): (usize, &Orbit)| {
            let far = orbit.end.is_none() && may_be_far(&self.shape, self.squares[number].iter().sum());
            if far { far_exponent(&vector(&self.engine, clock, number, &self.shape)) } else { 0 }
        };
        let exponents: Vec<_> = self.orbits.iter().enumerate().map(exponent).collect();
        if exponents.iter().all(|exponent| *exponent == 0) {
            return;
        }
        let mut lanes = self.lanes();
        for (number, exponent) in exponents.into_iter().enumerate() {
            let vector = &mut lanes[LANES_OF_ORBIT * number + 1];
            *vector = scaled(vector, power_of_two(-exponent));
            self.orbits[number].exponent += i64::from(exponent);
        }
        self.go_on(&lanes);
    }

    /// Ends orbits that cannot take the next step, and replaces them; `false` if none of them continues.
    fn replace_lost(&mut self) -> bool {
        let (mut point, mut found) = (self.shape.clone(), false);
        for (number, orbit) in self.orbits.iter_mut().enumerate().filter(|(_, orbit)| orbit.end.is_none()) {
            let lanes = LANES_OF_ORBIT * number..LANES_OF_ORBIT * (number + 1);
            let is_lost = lanes.into_iter().any(|lane| {
                self.engine.completed.store(lane, &mut point);
                !point.is_finite() || self.engine.completed.unsolved(lane).is_some()
            });
            orbit.end = is_lost.then_some(End::Lost);
            found |= is_lost;
        }
        if !found {
            // If the cause is outside of an orbit, none of them continues.
            self.orbits.iter_mut().for_each(|orbit| _ = orbit.end.get_or_insert(End::Lost));
        }
        self.replace_ended()
    }

    /// Moves an orbit that continues into the lanes of those that have ended; `false` if there is none.
    fn replace_ended(&mut self) -> bool {
        let Some(goes_on) = self.orbits.iter().position(|orbit| orbit.end.is_none()) else { return false };
        let mut lanes = self.lanes();
        for (number, _) in self.orbits.iter().enumerate().filter(|(_, orbit)| orbit.end.is_some()) {
            for lane in 0..LANES_OF_ORBIT {
                lanes[LANES_OF_ORBIT * number + lane] = lanes[LANES_OF_ORBIT * goes_on + lane].clone();
            }
        }
        self.go_on(&lanes);
        true
    }

    /// The lanes of all orbits in the middle of the current step.
    fn lanes(&self) -> Vec<Phase<C>> {
        let lane = |lane| {
            let mut point = self.shape.clone();
            self.engine.motions.store_own(lane, &mut point);
            point
        };
        (0..LANES_OF_ORBIT * self.orbits.len()).map(lane).collect()
    }

    fn go_on(&mut self, lanes: &[Phase<C>]) {
        let motions = &self.engine.motions;
        self.engine.resume(Form::Own, &all_lanes(lanes, motions.lanes() * motions.count()));
    }
}

/// Lanes in an engine, those after the last orbit repeat it.
fn engine<C: Coords>(like: &dyn Motions, lanes: &[Phase<C>]) -> Engine {
    Engine::single(like, all_lanes(lanes, lanes.len().next_multiple_of(like.lanes() * like.together())))
}

/// The units in which the vectors of orbits are measured, from a short step of both probes of each. If it fails for one of
/// them, each takes it alone, since no orbit depends on others.
fn units_of<C: Coords>(like: &dyn Motions, starts: &[Phase<C>], h: f64) -> Vec<Units> {
    let probes =
        starts.iter().flat_map(|start| Units::probes(&generic_direction(start, 0)).map(|probe| [start.clone(), probe]));
    let lanes: Vec<_> = probes.flatten().collect();
    let mut engine = engine(like, &lanes);
    let (mut clock, mut taken) = (Clock { t0: 0.0, h: OF_A_STEP * h, steps: 0 }, 0);
    engine.advance(clock, 1, &mut taken);
    if taken == 0 && starts.len() > 1 {
        return starts.chunks(1).flat_map(|start| units_of(like, start, h)).collect();
    }
    clock.steps += taken;
    let image = |orbit| vector(&engine, clock, orbit, &starts[0]);
    (0..starts.len()).map(|orbit| Units::of_images([image(2 * orbit), image(2 * orbit + 1)].each_ref())).collect()
}

/// The vector of an orbit, with the current step completed.
fn vector<C: Coords>(engine: &Engine, clock: Clock, orbit: usize, shape: &Phase<C>) -> Phase<C> {
    let mut vector = shape.clone();
    engine.lane(clock, LANES_OF_ORBIT * orbit + 1, &mut vector);
    vector
}

/// The lanes of a group; those after the last orbit repeat it.
fn all_lanes<C: Coords>(orbits: &[Phase<C>], count: usize) -> Vec<&dyn Point> {
    let last = &orbits[orbits.len() - LANES_OF_ORBIT..];
    let lanes = orbits.iter().chain(last.iter().cycle()).take(count);
    lanes.map(|point| point as &dyn Point).collect()
}
