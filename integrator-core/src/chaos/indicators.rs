//! Indicators of chaos along one orbit.

use crate::{
    chaos::growth::{
        CHAOTIC_ABOVE, Growth, REGULAR_BELOW, alignment_indices, logarithm, orthogonal_part, relative_change,
        smaller_alignment_index, steps_between_samples,
    },
    check::{CheckError, IntoStart, Start},
    error::{Error, Number},
    hamiltonian::Hamiltonian,
    methods::implicit::field::{Constants, Pair, field},
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::Shaped,
    trajectory::{
        method::Differentiable,
        tangent::{TOGETHER, Tangent, Units, numbers},
    },
};
use core::fmt;

/// The verdict on an orbit: regular, chaotic or undecided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Neighbouring orbits separate in proportion to time.
    Regular,
    /// Neighbouring orbits separate exponentially.
    Chaotic,
    /// The integration time is too short for a verdict.
    ///
    /// The mean of MEGNO is between both thresholds, or chaos could not have appeared in so few turns.
    Undecided,
}

impl Verdict {
    /// Returns the verdict for a mean of MEGNO, for example from a [map](crate::chaos::map()): regular below 2.5, chaotic above 4.
    ///
    /// It ignores the integration time, which the verdict of [`indicators()`] takes into account.
    pub fn of_megno(mean: f64) -> Self {
        match mean {
            mean if mean < REGULAR_BELOW => Self::Regular,
            mean if mean > CHAOTIC_ABOVE => Self::Chaotic,
            _ => Self::Undecided,
        }
    }
}

/// The chaos indicators of an orbit that follow from one deviation vector. `Display` prints the verdict and its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Megno {
    /// The estimate of the largest exponent: the mean growth rate of the deviation vector.
    ///
    /// On regular orbits it decreases like `ln t / t`.
    pub exponent: f64,
    /// MEGNO at the end of the orbit.
    ///
    /// It oscillates about 2 on quasiperiodic orbits and is about the exponent times the time on chaotic ones.
    pub megno: f64,
    /// The time average of MEGNO.
    ///
    /// It tends to 2 on quasiperiodic orbits and is about half the exponent times the time on chaotic ones.
    pub mean_megno: f64,
    /// The fast Lyapunov indicator: the maximum over time of the logarithm of `|v(t)| / |v(0)|`.
    pub fli: f64,
    /// The orthogonal fast Lyapunov indicator, of the component orthogonal to the flow.
    ///
    /// On a periodic orbit it stays bounded, whereas `fli` grows like the logarithm of the time.
    pub ofli: f64,
    /// The integration time.
    pub time: f64,
    /// The verdict, from the mean of MEGNO. "Regular" also requires 64 turns of the vector, or its growth by `e^6`.
    pub verdict: Verdict,
}

/// The chaos indicators of an orbit. `Display` prints the verdict and its reason.
///
/// The fields up to `ofli`, the time and the verdict are those of [`Megno`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Indicators {
    /// The estimate of the largest exponent, [`Megno::exponent`].
    pub exponent: f64,
    /// MEGNO at the end of the orbit, [`Megno::megno`].
    pub megno: f64,
    /// The time average of MEGNO, [`Megno::mean_megno`].
    pub mean_megno: f64,
    /// The fast Lyapunov indicator, [`Megno::fli`].
    pub fli: f64,
    /// The orthogonal fast Lyapunov indicator, [`Megno::ofli`].
    pub ofli: f64,
    /// The smaller alignment index: of the order of one on regular orbits of two and more degrees of freedom, and
    /// exponentially small on chaotic ones.
    pub sali: f64,
    /// The generalised alignment indices of two, three and four vectors, up to the dimension of phase space.
    pub gali: Vec<f64>,
    /// The integration time.
    pub time: f64,
    /// The verdict, [`Megno::verdict`].
    pub verdict: Verdict,
}

impl Indicators {
    /// Returns those that follow from one vector.
    fn of_one_vector(&self) -> Megno {
        let Self { exponent, megno, mean_megno, fli, ofli, time, verdict, .. } = *self;
        Megno { exponent, megno, mean_megno, fli, ofli, time, verdict }
    }
}

impl fmt::Display for Indicators {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.of_one_vector().fmt(f)
    }
}

impl fmt::Display for Megno {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let exponent = self.exponent;
        let (mean_megno, time) = (Number(self.mean_megno), Number(self.time));
        match self.verdict {
            Verdict::Regular => {
                write!(f, "regular: the mean MEGNO is {mean_megno:.3} after a time of {time}, below {REGULAR_BELOW}")
            }
            Verdict::Chaotic => write!(
                f,
                "chaotic: the mean MEGNO is {mean_megno:.1} after a time of {time}, above {CHAOTIC_ABOVE}; neighbours leave at a rate of {exponent:.3e}"
            ),
            Verdict::Undecided => write!(
                f,
                "undecided: the mean MEGNO is {mean_megno:.3} after a time of {time}, and 2 is regular, more than {CHAOTIC_ABOVE} chaotic: follow the orbit for longer"
            ),
        }
    }
}

/// Computes the chaos indicators of the orbit from `start`, over `steps` steps of length `h`.
///
/// Two to four deviation vectors are integrated with the orbit. They are sampled about a hundred times, and at least
/// every 64 steps. For a method with a fictitious time, such as [`Logarithmic`](crate::Logarithmic), vectors are compared
/// at equal physical times. With these methods and with [`Taylor`](crate::taylor::Taylor), vectors are not rescaled, so
/// that the orbit ends if a vector overflows. [`megno()`] integrates one vector only.
///
/// ```
/// use integrator_core::{chaos::{self, Verdict}, check::CheckError, prelude::*};
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
/// // A start on the section x = 0 with an energy of 1/8.
/// let at = |y: f64, py: f64| {
///     let potential = y * y / 2.0 - y.powi(3) / 3.0;
///     Phase::new([0.0, y], [(2.0 * (0.125 - potential) - py * py).sqrt(), py])
/// };
/// let regular = chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, at(0.55, 0.0), 0.2, 20_000)?;
/// let chaotic = chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, at(-0.25, 0.0), 0.2, 20_000)?;
/// assert_eq!((regular.verdict, chaotic.verdict), (Verdict::Regular, Verdict::Chaotic));
/// println!("{chaotic}");
/// # Ok::<(), CheckError>(())
/// ```
///
/// # Errors
/// - The start or the step is invalid, as for [`Hamiltonian::run`].
/// - The state or a vector diverges.
/// - [`Error::NoEnergy`]: the energy of a state on the orbit is not finite.
/// - [`CheckError::TooFewSteps`]: `steps` is too small.
pub fn indicators<H: Hamiltonian, X: Differentiable<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<Indicators, CheckError> {
    let (of_one, vectors) = follow::<H, X, K>(system, method, start.into_start(), h, steps, TOGETHER)?;
    let Megno { exponent, megno, mean_megno, fli, ofli, time, verdict } = of_one;
    let (sali, gali) = (smaller_alignment_index(&vectors), alignment_indices(&vectors));
    Ok(Indicators { exponent, megno, mean_megno, fli, ofli, sali, gali, time, verdict })
}

/// Computes MEGNO, the other indicators of one deviation vector, and the verdict, like [`indicators()`].
///
/// It takes about half of the time, since SALI and GALI require several vectors.
///
/// ```
/// use integrator_core::{chaos::{self, Verdict}, check::CheckError, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         p[0] * p[0] / 2.0
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         -q[0].cos()
///     }
/// }
///
/// let found = chaos::megno(&Pendulum, BlanesMoanSrkn11, Phase::new([2.0], [0.0]), 0.1, 16_000)?;
/// assert_eq!(found.verdict, Verdict::Regular);
/// # Ok::<(), CheckError>(())
/// ```
///
/// # Errors
/// Those of [`indicators()`].
pub fn megno<H: Hamiltonian, X: Differentiable<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<Megno, CheckError> {
    follow::<H, X, K>(system, method, start.into_start(), h, steps, 1).map(|(of_one, _)| of_one)
}

/// The indicators of the first vector, and all vectors at the end of the orbit.
type Followed<C> = Result<(Megno, Vec<Phase<C>>), CheckError>;

/// Integrates an orbit with at most this number of vectors.
fn follow<H: Hamiltonian, X: Differentiable<H>, K: Precision>(
    system: &H,
    method: X,
    start: Start<Shaped<H, K>>,
    h: f64,
    steps: u64,
    most: usize,
) -> Followed<Shaped<H, K>> {
    let parameters = system.parameters(start.phase.q.length());
    let field = |state: &Phase<Shaped<H, K>>, time| field_at::<H, K>(&parameters, state, time);
    let directions = |phase: &Phase<Shaped<H, K>>, units: Units| {
        let count = (2 * phase.q.flat().len()).min(most);
        (0..count).map(|vector| units.stretched(generic_direction(phase, vector))).collect()
    };
    let vector = |tangent: &Tangent<Shaped<H, K>>, vector| {
        let motion = field(&tangent.state(), tangent.time());
        at_equal_times(tangent.vector(vector), tangent.time_slope(vector), &motion)
    };
    let (tangent, units) = begin::<H, X, K>(system, method, start, h, directions, vector)?;
    of_tangent(tangent, steps, units, &field)
}

/// The velocities and the forces at a state, as a list.
fn field_at<H: Hamiltonian, K: Precision>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
) -> Vec<f64> {
    let shape = Phase { q: state.q.map(Precision::to_f64), p: state.p.map(Precision::to_f64) };
    let half = |half: &H::Coords| H::Coords::slots_from(half.flat().len(), |k| half.flat()[k]);
    let (q, p) = (half(&shape.q), half(&shape.p));
    let of_lanes = core::slice::from_ref(parameters);
    let constants = Constants { gathered: parameters, of_lanes, shape: &shape, middle: time };
    let found: Pair<H, f64> = field(&constants, &Pair { q, p }, time);
    found.halves().concat()
}

/// The smallest number of steps for a meaningful result.
pub(super) const LEAST: u64 = 16;

/// The part of a step after which probes are read: so short that images do not depend on the method.
pub(super) const OF_A_STEP: f64 = 1.0 / (1_u64 << 16) as f64;

/// An orbit with vectors, and the units in which these are measured, from a short step of both probes.
pub(super) fn begin<H: Hamiltonian, X: Differentiable<H>, K: Precision>(
    system: &H,
    method: X,
    Start { phase, time }: Start<Shaped<H, K>>,
    h: f64,
    vectors: impl FnOnce(&Phase<Shaped<H, K>>, Units) -> Vec<Phase<Shaped<H, K>>>,
    vector: impl Fn(&Tangent<Shaped<H, K>>, usize) -> Phase<Shaped<H, K>>,
) -> Result<(Tangent<Shaped<H, K>>, Units), CheckError> {
    let start = |vectors, h| Tangent::start::<H, X, K>(system, method, phase.clone(), vectors, h);
    let mut probes = start(Units::probes(&generic_direction(&phase, 0)).into(), OF_A_STEP * h)?.at_time(time);
    probes.advance(1)?;
    let units = Units::of_images([0, 1].map(|probe| vector(&probes, probe)).each_ref());
    Ok((start(vectors(&phase, units), h)?.at_time(time), units))
}

/// The velocities and the forces at a state and a time, as a list.
type Field<'f, C> = dyn Fn(&Phase<C>, f64) -> Vec<f64> + 'f;

fn of_tangent<C: Coords>(mut tangent: Tangent<C>, steps: u64, units: Units, field: &Field<'_, C>) -> Followed<C> {
    if steps < LEAST {
        return Err(CheckError::TooFewSteps { steps, needed: LEAST });
    }
    let begin = tangent.time();
    // State and vector are read together: each reading would undo the processor of a composition again.
    let lengths = |tangent: &Tangent<C>| {
        let [state, vector] = tangent.state_and_first_vector();
        let (energy, mut motion) = (tangent.energy_of(&state), field(&state, tangent.time()));
        let vector = at_equal_times(vector, tangent.time_slope(0), &motion);
        let length = logarithm(&vector, tangent.exponents()[0], units);
        let positions = motion.len() / 2;
        motion[..positions].iter_mut().for_each(|rate| *rate = units.measured_position(*rate));
        [length, length + orthogonal_part(&units.measured(vector), &motion).ln(), energy]
    };
    let [length, first, _] = lengths(&tangent);
    let (mut growth, mut highest) = (Growth::new(length), first);
    let every = steps_between_samples(steps);
    while tangent.steps() < steps {
        let portion = every.min(steps - tangent.steps());
        tangent.advance(portion - 1)?;
        // In the coordinates of the motion, where a vector turns as often: nothing has to be undone to read these.
        let (before, exponent) = (units.measured(tangent.unfinished_vector()), tangent.exponents()[0]);
        tangent.advance(1)?;
        let after = units.measured(tangent.unfinished_vector());
        let change = relative_change(&before, &after, tangent.exponents()[0] - exponent);
        growth.change(portion as f64 * change);
        let [length, orthogonal, energy] = lengths(&tangent);
        if !energy.is_finite() {
            return Err(Error::NoEnergy { time: tangent.time(), energy }.into());
        }
        growth.sample(tangent.time() - begin, length);
        highest = highest.max(orthogonal);
    }
    let motion = field(&tangent.state(), tangent.time());
    let vectors = tangent.vectors().into_iter().zip(tangent.time_slopes());
    let vectors = vectors.map(|(vector, slope)| units.measured(at_equal_times(vector, slope, &motion))).collect();
    let of_one = Megno {
        exponent: growth.exponent(),
        megno: growth.megno(),
        mean_megno: growth.mean_megno(),
        fli: growth.fli(),
        ofli: highest - first,
        time: growth.time(),
        verdict: growth.verdict(),
    };
    Ok((of_one, vectors))
}

/// The difference to a neighbour at equal times, from that after equal numbers of steps, where its time has a slope.
fn at_equal_times<C: Coords>(vector: Phase<C>, slope: f64, motion: &[f64]) -> Phase<C> {
    if slope == 0.0 {
        return vector;
    }
    let at_equal_times: Vec<_> = numbers(&vector).zip(motion).map(|(number, rate)| number - slope * rate).collect();
    let mut moved = vector;
    for (leaf, number) in moved.q.flat_mut().iter_mut().chain(moved.p.flat_mut()).zip(at_equal_times) {
        *leaf = C::Leaf::from_parts([number, 0.0]);
    }
    moved
}

/// A direction that no symmetry of a system knows, one for each number: sines at distances that no two coordinates share.
pub(super) fn generic_direction<C: Coords>(like: &Phase<C>, number: usize) -> Phase<C> {
    let mut direction = like.clone();
    for (place, leaf) in direction.q.flat_mut().iter_mut().chain(direction.p.flat_mut()).enumerate() {
        let angle = 1.0 + (number as f64 + 1.0) * (0.7 + std::f64::consts::SQRT_2 * place as f64);
        *leaf = C::Leaf::from_parts([angle.sin(), 0.0]);
    }
    direction
}
