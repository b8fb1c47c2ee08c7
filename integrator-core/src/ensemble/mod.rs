//! Ensembles: many trajectories of one kind of system, in the lanes of vectors and distributed over threads.
//!
//! Always true: a member's bits are those of the same system run alone on the same instruction set, whatever its
//! neighbours do and however many threads there are.

pub(crate) mod batch;
pub(crate) mod batches;
#[cfg(feature = "checkpoint")]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod checkpoint;
#[cfg(feature = "checkpoint")]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod elsewhere;
pub(crate) mod energies;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod in_lanes;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod lane_scalars;
pub(crate) mod members;
pub(crate) mod physical_time;
pub(crate) mod request;
pub(crate) mod watch;

#[cfg(debug_assertions)]
use crate::system::user_energies::hold_at_start;
#[cfg(feature = "checkpoint")]
use crate::trajectory::checkpoint::Origin;
use crate::{
    ensemble::{
        batches::Starts,
        energies::energies_of_members,
        in_lanes::InLanes,
        lane_scalars::LaneScalars,
        members::{Members, of_member, refusal},
    },
    error::{Error, Lost},
    hamiltonian::{Hamiltonian, Shaped},
    scalar::instruction_set::InstructionSet,
    state::{clock::Clock, coords::Coords, phase::Phase, point::shaped, precision::Precision},
    system::{energy::energy, motion::Prepared},
    threads::all_threads,
    trajectory::{
        admissible::{admissible_with, change},
        dispatch::{Carried, Nothing, engine, motions, single},
        method::Method,
        motions::{Constants, Motions},
        progress::{Progress, in_portions},
        run::{Kind, Run},
        samples::Sample,
        step_functions::Interleaved,
    },
};
use std::{fmt, marker::PhantomData, ops::ControlFlow, sync::Arc};

/// The least number of steps in a portion of a call that tells of its progress: reading a member from memory takes about as
/// long as a few of them.
const FIRST_PORTION: u64 = 32;

/// How many vector registers there are without AVX-512, which has 32.
const REGISTERS: usize = if cfg!(target_arch = "x86_64") { 16 } else { 32 };

/// An empty list of motions with members in their lanes, for the instruction set of this machine.
pub(crate) fn in_lanes<H, X, K, V>(constants: Constants<X::Constants>) -> Box<dyn Motions>
where
    H: Hamiltonian,
    X: Method<H>,
    K: LaneScalars,
    V: Carried,
{
    match InstructionSet::chosen() {
        InstructionSet::Baseline => {
            motions::<H, X, V::In<<K as LaneScalars>::Plain>, K, Interleaved<REGISTERS>>(constants)
        }
        InstructionSet::Fused => {
            motions::<H, X, V::In<<K as LaneScalars>::Fused>, K, Interleaved<REGISTERS>>(constants)
        }
        InstructionSet::Avx512 => motions::<H, X, V::In<<K as LaneScalars>::Avx512>, K, Interleaved<32>>(constants),
    }
}

/// Trajectories of one kind of system under way together; parameters may differ from member to member.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Pendulum { length: f64 }
///
/// #[hamiltonian(compose = Yoshida4)]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.length.powi(2)) }
///     fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
/// }
///
/// let members = (1..=100).map(|i| (Pendulum { length: i as f64 / 100.0 }, Phase::new([1.0_f64], [0.0])));
/// let mut swarm = Ensemble::new(Yoshida4, members, 0.01)?;
/// swarm.advance(1_000)?;
/// let shortest = swarm.state(0).expect("a hundred members");
/// assert!(shortest.q[0].abs() < 1.01);
/// # Ok::<(), Error>(())
/// ```
pub struct Ensemble<C: Coords> {
    members: Members,
    /// What runs of members have in common.
    kind: Kind,
    /// What runs of the first member are, for checkpoints, and fingerprints of the parameters of all.
    #[cfg(feature = "checkpoint")]
    origin: Origin,
    #[cfg(feature = "checkpoint")]
    parameters: Vec<u64>,
    shape: PhantomData<C>,
}

impl<C: Coords> Ensemble<C> {
    /// An ensemble of `(system, start)` pairs that take steps `h` with any composition that may integrate the systems,
    /// or with [`Taylor`](crate::taylor::Taylor), where each member goes by polynomials of its own between these steps.
    ///
    /// # Errors
    /// [`Error::NoMembers`] without members; [`Error::Member`] naming the member whose start or step is refused, for the
    /// reasons of [`Hamiltonian::run`], or [`Error::Members`] naming all of them where others are not.
    /// [`Ensemble::of_admissible`] leaves them out.
    pub fn new<H, X>(method: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let mut refused = Vec::new();
        let ensemble = Self::from_starts::<H, X>(method, members, h, H::AUTONOMOUS, &mut refused);
        if refused.is_empty() {
            return ensemble;
        }
        let admitted = ensemble.map_or(0, |ensemble| ensemble.len());
        let count = admitted + refused.len();
        Err(refusal(refused, count))
    }

    /// The ensemble of those `(system, start)` pairs that [`Ensemble::new`] takes, in their order, and all others by their
    /// numbers among the pairs, each with the reason.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Rotor;
    ///
    /// #[hamiltonian]
    /// impl Rotor {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// }
    ///
    /// let members = [0.0, f64::NAN, 1.0].map(|p| (Rotor, Phase::new([0.0], [p])));
    /// let (mut rotors, refused) = Ensemble::of_admissible(Verlet, members, 0.01)?;
    /// assert_eq!((rotors.len(), refused[0].0), (2, 1));
    /// println!("member 1 is left out: {}", refused[0].1);
    /// rotors.advance(100)?;
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoMembers`] without pairs; [`Error::Member`] naming the first one, if none is taken.
    pub fn of_admissible<H, X>(
        method: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<(Self, Vec<(usize, Error)>), Error>
    where
        H: Hamiltonian,
        X: InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let mut refused = Vec::new();
        match Self::from_starts::<H, X>(method, members, h, H::AUTONOMOUS, &mut refused) {
            Ok(ensemble) => Ok((ensemble, refused)),
            Err(error) if refused.is_empty() => Err(error),
            Err(_) => {
                let count = refused.len();
                Err(refusal(refused, count))
            }
        }
    }

    /// An ensemble of those starts that are not refused, with a look at their energies where it is asked for.
    ///
    /// # Errors
    /// [`Error::NoMembers`]
    fn from_starts<H, X>(
        method: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
        with_energies: bool,
        refused: &mut Vec<(usize, Error)>,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let (mut parameters, mut constants, mut states) = (Vec::new(), Vec::new(), Vec::new());
        let mut coordinates = 0;
        for (number, (system, state)) in members.into_iter().enumerate() {
            let admitted = member::<H, C::Leaf, X>(&system, method, &state, h).and_then(|member| {
                if with_energies {
                    energy::<H, C::Leaf>(&member, &state, 0.0, None).admissible(0.0)?;
                }
                Ok(member)
            });
            let member = match admitted {
                Ok(member) => member,
                Err(error) => {
                    refused.push((number, error));
                    continue;
                }
            };
            coordinates += state.q.flat().len() as u64;
            constants.push(method.constants(member.clone()));
            parameters.push(member);
            states.push(state);
        }
        if states.is_empty() {
            return Err(Error::NoMembers);
        }
        let constants = Arc::new(constants);
        let single = single::<H, X, C::Leaf, Nothing>(constants.clone());
        let lanes = in_lanes::<H, X, C::Leaf, Nothing>(constants);
        let starts = Starts {
            states: &|member| &states[member],
            alike: &|a, b| {
                let same = <H::Parameters<f64> as Prepared<f64>>::alike(&parameters[a], &parameters[b]);
                same && states[a].q.length() == states[b].q.length()
            },
            lanes: &*lanes,
            single: &*single,
        };
        let batches = starts.batches(states.len(), all_threads());
        #[cfg(feature = "checkpoint")]
        let origins: Vec<_> = parameters.iter().map(|parameters| Origin::of::<H>(method.facts(), parameters)).collect();
        let energies = energies_of_members::<H, C::Leaf>(parameters);
        let mut members = Members::new(batches, energies, states.len(), coordinates, h);
        if with_energies {
            members.starts_are_checked();
        }
        Ok(Self {
            members,
            kind: Kind { autonomous: H::AUTONOMOUS, method: method.facts().name, forces: method.forces() },
            #[cfg(feature = "checkpoint")]
            origin: origins[0],
            #[cfg(feature = "checkpoint")]
            parameters: origins.iter().map(Origin::parameters).collect(),
            shape: PhantomData,
        })
    }

    /// Starts the clock at `t0` instead of 0. A `t0` that is not finite is reported by the first `advance`.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.members.clock.t0 = t0;
        self
    }

    /// Uses at most so many threads instead of all that the machine has; no result depends on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.members.threads = threads.max(1);
        self
    }

    /// Takes `steps` steps with every member that is under way.
    ///
    /// # Errors
    /// [`Error::Lost`] names the members that left the finite numbers in these steps, or came too near to a singularity
    /// for [`Taylor`](crate::taylor::Taylor); all others have taken them, and the ensemble goes on without the lost
    /// ones, which stay at their last finite state. [`Error::Time`], [`Error::Clock`] and [`Error::Steps`] leave the
    /// ensemble as it was, and so does [`Error::Member`], which the first call returns where `H` reads the time and has
    /// no value at a start.
    ///
    /// # Panics
    /// Where your own functions would, once all members have taken the steps for which they do not. A program that
    /// catches the panic finds the members for which they do at the last step before it, as if they had left there
    /// ([`Ensemble::steps_of`]); the ensemble goes on without them.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.members.advance(steps, u64::MAX, &|_, _| true)
    }

    /// As [`Ensemble::advance`], and tells `progress` about ten times a second how far it is, as
    /// [`Run::advance_with`](crate::Run::advance_with) does. When it is told to break, all members stop after the same
    /// number of steps, which it returns.
    ///
    /// # Errors
    /// As [`Ensemble::advance`]; lost members are named at the end.
    ///
    /// # Panics
    /// Where your own functions would, or `progress` does, once all members have taken the portion under way. Members that were
    /// lost in the portions before are told by [`Ensemble::steps_of`] alone then.
    pub fn advance_with(
        &mut self,
        steps: u64,
        mut progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<u64, Error> {
        self.members.clock.end(steps)?;
        let mut lost = Vec::new();
        let mut advance = |steps| match self.members.advance(steps, u64::MAX, &|_, _| true) {
            Err(Error::Lost(Lost { members })) => {
                lost.extend(members);
                Ok(())
            }
            outcome => outcome,
        };
        let taken = in_portions(steps, FIRST_PORTION, &mut advance, &mut progress)?;
        lost.sort_unstable_by_key(|(member, _)| *member);
        if lost.is_empty() { Ok(taken) } else { Err(Lost { members: lost }.into()) }
    }

    /// As [`Ensemble::advance`], but members may leave when they are done: after every `interval` steps, each member
    /// under way is shown to `stays`, and those for which it returns `false` stay where they are from then on. Their
    /// lanes are closed up, so that they cost nothing any more.
    ///
    /// A member is shown at increasing times, by any thread; what is returned should depend on nothing else.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Fall;
    ///
    /// #[hamiltonian]
    /// impl Fall {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { 9.81 * q[0] }
    /// }
    ///
    /// let stones = (1..=20).map(|height| (Fall, Phase::new([f64::from(height)], [0.0])));
    /// let mut stones = Ensemble::new(Verlet, stones, 0.001)?;
    /// stones.advance_while(10_000, 1, |_, stone| stone.q[0] > 0.0)?;
    /// assert_eq!(stones.active(), 0);
    /// let seconds = 0.001 * stones.steps_of(4).expect("twenty stones") as f64;
    /// assert!((seconds - (2.0_f64 * 5.0 / 9.81).sqrt()).abs() < 0.001);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Ensemble::advance`]; [`Error::SampleInterval`] for an interval of 0.
    pub fn advance_while(
        &mut self,
        steps: u64,
        interval: u64,
        stays: impl Fn(usize, &Phase<C>) -> bool + Sync,
    ) -> Result<(), Error> {
        self.members.advance(steps, interval, &|member, state| stays(member, shaped(state)))
    }

    /// Changes the states of the members that are under way, one after the other, between two steps: coordinates that
    /// are wrapped into a periodic box, momenta that are drawn anew by a thermostat. Time and the number of steps go
    /// on; members that are lost or gone stay as they are. After [`Ensemble::advance_to`], these are the states at the end of
    /// the last step of all.
    ///
    /// Each member has the bits of a run whose state is [changed](crate::Run::map_state) in the same way.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    /// use std::f64::consts::TAU;
    ///
    /// struct Rotor;
    ///
    /// #[hamiltonian]
    /// impl Rotor {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// }
    ///
    /// let members = (0..20).map(|i| (Rotor, Phase::new([0.0_f64], [f64::from(i)])));
    /// let mut rotors = Ensemble::new(Verlet, members, 0.01)?;
    /// for _ in 0..10 {
    ///     rotors.advance(100)?;
    ///     rotors.map_states(|_, state| state.q[0] = state.q[0].rem_euclid(TAU))?;
    /// }
    /// assert!(rotors.states().all(|state| (0.0..TAU).contains(&state.q[0])));
    /// assert_eq!((rotors.steps(), rotors.time()), (1_000, 10.0));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Member`] naming the first member whose new state is refused, for the reasons of
    /// [`Run::map_state`](crate::Run::map_state); all members stay as they were.
    pub fn map_states(&mut self, mut map: impl FnMut(usize, &mut Phase<C>)) -> Result<(), Error> {
        let mut states = Vec::with_capacity(self.len());
        for batch in 0..self.members.batches() {
            self.members.states_at_step(batch, &mut |_, state| states.push(shaped::<C>(state).clone()));
        }
        for member in self.members.under_way() {
            let state = &mut states[member];
            change(state, self.members.clock.h, |state| map(member, state)).map_err(of_member(member))?;
            self.members.changed(member, state)?;
        }
        let under_way = self.members.under_way();
        self.members.watch_anew(&under_way, &|member| &states[member]);
        self.members.restart(&|member| &states[member]);
        Ok(())
    }

    /// How many members there are.
    pub fn len(&self) -> usize {
        self.members.count()
    }

    /// Whether there are no members; never so.
    pub fn is_empty(&self) -> bool {
        self.members.count() == 0
    }

    /// How many members are under way: neither lost nor gone.
    pub fn active(&self) -> usize {
        self.members.active()
    }

    /// The time of the members that are under way, `t0 + n·h`; that of one that has a time of its own is
    /// [`Ensemble::time_of`] it; and what [`Ensemble::advance_to`] was called with.
    pub fn time(&self) -> f64 {
        self.members.time()
    }

    /// How many steps the members that are under way have taken.
    pub fn steps(&self) -> u64 {
        self.members.clock.steps
    }

    /// How many steps a member has taken: fewer than the others if it is lost or gone. `None` beyond the last member.
    pub fn steps_of(&self, member: usize) -> Option<u64> {
        self.members.steps_of(member)
    }

    /// The time of a member: that of its last step if it is lost or gone, and its own where the method has one, such as
    /// [`Logarithmic`](crate::Logarithmic). `None` beyond the last member.
    pub fn time_of(&self, member: usize) -> Option<f64> {
        self.members.time_of(member)
    }

    /// The state of a member: its last finite one if it is lost, the one in which it left if it is gone.
    pub fn state(&self, member: usize) -> Option<Phase<C>> {
        Some(shaped::<C>(&*self.members.state(member)?).clone())
    }

    /// The energy of a member in that state.
    pub fn energy(&self, member: usize) -> Option<f64> {
        self.members.energy(member)
    }

    /// An [invariant](crate::Run::invariant) of a member in that state, by its name; `None` beyond the last member.
    ///
    /// # Errors
    /// [`Error::NoInvariant`]
    pub fn invariant(&self, member: usize, name: &str) -> Result<Option<f64>, Error> {
        self.members.invariant(member, name)
    }

    /// A member that is under way as a run of its own, from where it is: for its [samples](crate::Run::samples), its
    /// [crossings](crate::Run::crossings), a [watch](crate::Run::watch_energy), and changes of its state. It takes the steps of
    /// the member, bit for bit, and the ensemble stays where it is. A [checkpoint](crate::Run::checkpoint) of it is resumed with
    /// the system of the member. Where a method counts its [evaluations](crate::Run::evaluations) step by step, the run counts
    /// those from here on. `None` for members that are lost or gone, and beyond the last one.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Pendulum { length: f64 }
    ///
    /// #[hamiltonian]
    /// impl Pendulum {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.length.powi(2)) }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
    /// }
    ///
    /// let members = (1..=10).map(|i| (Pendulum { length: f64::from(i) }, Phase::new([1.0], [0.0])));
    /// let mut swarm = Ensemble::new(Verlet, members, 0.01)?;
    /// swarm.advance(1_000)?;
    /// let fifth = swarm.run_of(4).expect("under way");
    /// let passages = fifth.crossings(1_000, Direction::Rising, |state, _| state.q[0]);
    /// assert_eq!(passages.count(), 2);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn run_of(&self, member: usize) -> Option<Run<C>> {
        let run = self.members.batch_of(member)?.is_under_way(member).then(|| self.alone(member))??;
        Some(run.known_as(
            self.kind,
            #[cfg(feature = "checkpoint")]
            self.origin.with_parameters(self.parameters[member]),
        ))
    }

    /// A sample of each member, in their order, at its present time or where it ended: for
    /// `output::csv` or `output::npz`, each of which takes
    /// `swarm.present().map(Ok)`.
    pub fn present(&self) -> impl Iterator<Item = Sample<C>> {
        self.states().zip(0..).filter_map(|(state, member)| {
            let (time, step) = (self.time_of(member)?, self.steps_of(member)?);
            Some(Sample::of_member(state, time, step, self.energies_of(member)))
        })
    }

    /// The states of all members, in their order.
    pub fn states(&self) -> impl Iterator<Item = Phase<C>> {
        (0..self.members.batches()).flat_map(|batch| {
            let mut states: Vec<Phase<C>> = Vec::new();
            self.members.states(batch, &mut |_, state| states.push(shaped::<C>(state).clone()));
            states
        })
    }
}

impl<C: Coords> fmt::Debug for Ensemble<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ensemble")
            .field("members", &self.len())
            .field("step", &self.members.clock.h)
            .field("steps", &self.steps())
            .field("time", &self.time())
            .finish()
    }
}

/// The parameters of a member, which may begin where it is asked to.
///
/// # Errors
/// Those of [`Hamiltonian::run`].
pub(crate) fn member<H: Hamiltonian, K: Precision, X: Method<H>>(
    system: &H,
    method: X,
    start: &Phase<Shaped<H, K>>,
    h: f64,
) -> Result<Arc<H::Parameters<f64>>, Error> {
    admissible_with::<H, _>(method, start, h)?;
    system.admissible(start.q.length())?;
    let parameters = Arc::new(system.parameters(start.q.length()));
    let constants = H::Parameters::<f64>::not_finite(&parameters);
    let unsettled = !constants.is_empty();
    let clock = Clock { t0: 0.0, h, steps: 0 };
    // An infinite constant may be meant: what counts is what a run of its own does with it.
    if unsettled && engine::<H, X, K, Nothing>(method, parameters.clone(), vec![], vec![start]).is_not_finite(clock) {
        return Err(Error::Parameters { constants });
    }
    #[cfg(debug_assertions)]
    hold_at_start::<H, K>(system, &parameters, start, 0.0)?;
    if unsettled && H::AUTONOMOUS {
        energy::<H, K>(&parameters, start, 0.0, None).admissible(0.0)?;
    }
    Ok(parameters)
}
