//! Ensembles: many trajectories of one kind of system, in the lanes of vectors and distributed over threads.
//!
//! Each member is bitwise identical to a run of the same system alone on the same instruction set, for any number of
//! threads.

pub(crate) mod batch;
pub(crate) mod batches;
mod between;
#[cfg(feature = "checkpoint")]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod checkpoint;
#[cfg(feature = "checkpoint")]
#[allow(unreachable_pub, reason = "what other crates of this repository call is reached by the private API")]
pub(crate) mod elsewhere;
pub(crate) mod energies;
mod gradients;
#[allow(unreachable_pub, reason = "named in bounds, never outside")]
pub(crate) mod lane_scalars;
pub(crate) mod members;
pub(crate) mod physical_time;
pub(crate) mod request;
pub(crate) mod watch;
mod way_back;

#[cfg(debug_assertions)]
use crate::system::user_energies::hold_at_start;
#[cfg(feature = "checkpoint")]
use crate::trajectory::checkpoint::Origin;
use crate::{
    ensemble::{
        batches::Starts,
        energies::energies_of_members,
        lane_scalars::LaneScalars,
        members::{Members, of_member, refusal},
        request::Ended,
    },
    error::{Error, Lost},
    scalar::instruction_set::InstructionSet,
    state::{clock::Clock, coords::Coords, phase::Phase, point::shaped, precision::Precision},
    system::{Shaped, System, energy::energy, flow_layout::Layouts, motion::Prepared},
    threads::all_threads,
    trajectory::{
        admissible::{admissible_with, change},
        dispatch::{Carried, Nothing, bound, motions, single},
        in_lanes::InLanes,
        method::Method,
        motions::{Constants, Motions},
        progress::{Progress, in_portions},
        run::{Kind, Run},
        samples::Sample,
        step_functions::Interleaved,
    },
};
use std::{fmt, marker::PhantomData, ops::ControlFlow, sync::Arc};

/// The least number of steps in a portion of a call that reports its progress: reading a member from memory takes about
/// as long as a few of them.
const FIRST_PORTION: u64 = 32;

/// The number of vector registers without AVX-512, which has 32.
const REGISTERS: usize = if cfg!(target_arch = "x86_64") { 16 } else { 32 };

/// An empty list of motions with members in their lanes, for the instruction set of this machine.
pub(crate) fn in_lanes<H, X, K, V>(constants: Constants<X::Constants>) -> Box<dyn Motions>
where
    H: System,
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

/// Many trajectories of one type of system, integrated together in SIMD lanes and on all cores.
///
/// Parameters may differ between members. Each member is bitwise identical to a run of its own on the same instruction set.
/// A member that diverges has *failed*; one that [`Ensemble::advance_while`] stopped has *finished*. All others are
/// *active*.
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
    /// The properties that runs of all members share.
    kind: Kind,
    /// The origin of runs of the first member, for checkpoints, and fingerprints of the parameters of all members.
    #[cfg(feature = "checkpoint")]
    origin: Origin,
    #[cfg(feature = "checkpoint")]
    parameters: Vec<u64>,
    shape: PhantomData<C>,
}

impl<C: Coords> Ensemble<C> {
    /// Creates an ensemble of `(system, start)` pairs with step `h`.
    ///
    /// The method is a composition or another method with [`InLanes`](crate::InLanes). With
    /// [`Taylor`](crate::taylor::Taylor), each member has its own polynomials between these steps.
    ///
    /// # Errors
    /// [`Ensemble::of_admissible`] leaves out the members that cause these errors.
    ///
    /// - [`Error::NoMembers`]: there are no members.
    /// - [`Error::Member`]: one member, or every one, cannot start, for the reasons of [`Hamiltonian::run`](crate::Hamiltonian::run).
    /// - [`Error::Members`]: several, but not all, cannot start.
    pub fn new<H, X>(method: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: System,
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

    /// Creates an ensemble of the pairs that can start; returns it with the indices and errors of all other pairs.
    ///
    /// Members keep the order of the pairs.
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
    /// - [`Error::NoMembers`]: there are no pairs.
    /// - [`Error::Member`]: no pair can start; the error is that of the first one.
    pub fn of_admissible<H, X>(
        method: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<(Self, Vec<(usize, Error)>), Error>
    where
        H: System,
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

    /// An ensemble of the valid initial states, with their energies checked if requested.
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
        H: System,
        X: InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let (mut parameters, mut constants, mut states) = (Vec::new(), Vec::new(), Vec::new());
        let (mut coordinates, mut are_listed) = (0, true);
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
            are_listed &= system.is_listed(state.q.length());
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
            kind: Kind {
                autonomous: H::AUTONOMOUS,
                method: method.facts().name,
                layout: Layouts::of::<H>(are_listed),
                forces: method.forces(),
                flows: method.flows(),
            },
            #[cfg(feature = "checkpoint")]
            origin: origins[0],
            #[cfg(feature = "checkpoint")]
            parameters: origins.iter().map(Origin::parameters).collect(),
            shape: PhantomData,
        })
    }

    /// Starts the clock at `t0` instead of 0.
    ///
    /// If `t0` is not finite, the first `advance` returns an error.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.members.clock.t0 = t0;
        self
    }

    /// Sets the seed of the random numbers of systems with a temperature; the default is 0.
    ///
    /// Each member draws its own numbers, which depend on the seed and on the index of the member.
    #[must_use]
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.members.change_draws(&|draws| draws.seed = seed);
        self
    }

    /// Numbers the members from `first`, for random numbers: those of other processes come before.
    #[doc(hidden)]
    #[must_use]
    pub fn numbered_from(mut self, first: usize) -> Self {
        self.members.change_draws(&|draws| draws.first = first as u32);
        self
    }

    /// Limits the number of threads; the default is all cores. Results do not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.members.threads = threads.max(1);
        self
    }

    /// Takes `steps` steps with every active member.
    ///
    /// # Errors
    /// - [`Error::Lost`]: members diverged, or came too close to a singularity for [`Taylor`](crate::taylor::Taylor). The
    ///   error lists them; they stay at their last finite state. All other members have taken the steps, and the ensemble
    ///   can be continued.
    /// - [`Error::Time`], [`Error::Clock`], [`Error::Steps`]: the ensemble is unchanged.
    /// - [`Error::Member`]: `H` depends on time, and the energy of a start is not finite. The first call returns this error;
    ///   the ensemble is unchanged.
    ///
    /// # Panics
    /// If your own functions panic; all other members take their steps first. A program that catches the panic finds the
    /// members that panicked finished at the last step before it ([`Ensemble::steps_of`]), and can continue the ensemble.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.members.advance(steps, u64::MAX, &|_, _| true)
    }

    /// Takes `steps` steps like [`Ensemble::advance`], and calls `progress` about ten times a second.
    ///
    /// `progress` is that of [`Run::advance_with`](crate::Run::advance_with). If it returns `ControlFlow::Break`, all members
    /// stop after the same number of steps, which is returned.
    ///
    /// # Errors
    /// Those of [`Ensemble::advance`]; failed members are reported at the end.
    ///
    /// # Panics
    /// If your own functions or `progress` panic, after all members have taken the current portion of steps. Members that
    /// failed in earlier portions are then found by [`Ensemble::steps_of`] only.
    pub fn advance_with(
        &mut self,
        steps: u64,
        mut progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<u64, Error> {
        self.members.clock.end(steps)?;
        let mut ended = Ended::default();
        let mut advance = |steps| match self.members.advance(steps, u64::MAX, &|_, _| true) {
            Err(Error::Lost(Lost { members })) => {
                ended.lost.extend(members);
                Ok(())
            }
            Err(Error::Strayed { members }) => {
                ended.strayed.extend(members);
                Ok(())
            }
            outcome => outcome,
        };
        let taken = in_portions(steps, FIRST_PORTION, &mut advance, &mut progress)?;
        ended.outcome().map(|()| taken)
    }

    /// Takes `steps` steps like [`Ensemble::advance`], and stops members individually.
    ///
    /// After every `interval` steps, `stays(member, state)` is called for each active member. If it returns `false`, the
    /// member has finished and keeps this state. Finished members are removed and the remaining lanes are compacted.
    ///
    /// Any thread can call `stays`, with increasing times for each member. Its result should depend on its arguments only.
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
    /// Those of [`Ensemble::advance`]; [`Error::SampleInterval`] if `interval` is 0.
    pub fn advance_while(
        &mut self,
        steps: u64,
        interval: u64,
        stays: impl Fn(usize, &Phase<C>) -> bool + Sync,
    ) -> Result<(), Error> {
        self.members.advance(steps, interval, &|member, state| stays(member, shaped(state)))
    }

    /// Changes the states of the active members between two steps, one after the other.
    ///
    /// Examples are wrapping coordinates into a periodic box, or drawing new momenta for a thermostat. The time and the
    /// number of steps are kept; failed and finished members are unchanged. After [`Ensemble::advance_to`], the states are
    /// those at the end of the last step that all members have taken.
    ///
    /// Each member is bitwise identical to a run whose state is [changed](crate::Run::map_state) in the same way.
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
    /// [`Error::Member`] with the first member that cannot continue from its new state, for the reasons of
    /// [`Run::map_state`](crate::Run::map_state). All members are unchanged.
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

    /// Returns the number of members.
    pub fn len(&self) -> usize {
        self.members.count()
    }

    /// Returns `false`: an ensemble has at least one member.
    pub fn is_empty(&self) -> bool {
        self.members.count() == 0
    }

    /// Returns the number of active members, which have neither failed nor finished.
    pub fn active(&self) -> usize {
        self.members.active()
    }

    /// Returns the time of the active members: `t0 + n·h`, or the time to which [`Ensemble::advance_to`] advanced.
    ///
    /// For a method with a fictitious time, [`Ensemble::time_of`] returns the physical time of a member.
    pub fn time(&self) -> f64 {
        self.members.time()
    }

    /// Returns the number of steps that the active members have taken.
    pub fn steps(&self) -> u64 {
        self.members.clock.steps
    }

    /// Returns the number of steps of a member, which is smaller for failed and finished members.
    ///
    /// `None` if there is no such member.
    pub fn steps_of(&self, member: usize) -> Option<u64> {
        self.members.steps_of(member)
    }

    /// Returns the time of a member; for failed and finished members, that of the last step.
    ///
    /// For a method with a fictitious time, such as [`Logarithmic`](crate::Logarithmic), this is the physical time of the
    /// member. `None` if there is no such member.
    pub fn time_of(&self, member: usize) -> Option<f64> {
        self.members.time_of(member)
    }

    /// Returns the state of a member: the last finite state if it failed, the last state if it finished.
    pub fn state(&self, member: usize) -> Option<Phase<C>> {
        Some(shaped::<C>(&*self.members.state(member)?).clone())
    }

    /// Returns the energy of a member in the state that [`Ensemble::state`] returns.
    pub fn energy(&self, member: usize) -> Option<f64> {
        self.members.energy(member)
    }

    /// Returns the energies of all members, in their order. This is faster than [`Ensemble::energy`] for each.
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
    /// let members = (0..100).map(|k| (Rotor, Phase::new([0.01 * f64::from(k)], [0.0])));
    /// let mut swarm = Ensemble::new(Verlet, members, 0.01)?;
    /// swarm.advance(1_000)?;
    /// assert_eq!(swarm.energies()[70], swarm.energy(70).expect("a member"));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn energies(&self) -> Vec<f64> {
        self.members.energies()
    }

    /// Returns a conserved quantity of a member, by its name, like [`Run::invariant`](crate::Run::invariant).
    ///
    /// `None` if there is no such member.
    ///
    /// # Errors
    /// [`Error::NoInvariant`] if there is none of this name.
    pub fn invariant(&self, member: usize, name: &str) -> Result<Option<f64>, Error> {
        self.members.invariant(member, name)
    }

    /// Returns an active member as a run of its own, from its current state; the ensemble is unchanged.
    ///
    /// The run can be used for [samples](crate::Run::samples), [crossings](crate::Run::crossings), a
    /// [watch](crate::Run::watch_energy), or changes of the state. Its steps are bitwise identical to those of the member.
    ///
    /// - A checkpoint of the run is resumed with the system of the member.
    /// - If a method counts its [evaluations](crate::Run::evaluations) step by step, the run counts from here on.
    /// - `None` if the member failed or finished, or if there is no such member.
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
    /// let fifth = swarm.run_of(4).expect("in progress");
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

    /// Returns an iterator over samples of all members, at their current or last times.
    ///
    /// `output::csv` and `output::npz` accept `swarm.present().map(Ok)`.
    pub fn present(&self) -> impl Iterator<Item = Sample<C>> {
        self.states().zip(0..).filter_map(|(state, member)| {
            let (time, step) = (self.time_of(member)?, self.steps_of(member)?);
            Some(Sample::of_member(state, time, step, self.energies_of(member)))
        })
    }

    /// Returns an iterator over the states of all members, in their order.
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

/// The parameters of a member, at its requested start time.
///
/// # Errors
/// Those of [`Hamiltonian::run`](crate::Hamiltonian::run).
pub(crate) fn member<H: System, K: Precision, X: Method<H>>(
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
    if unsettled
        && bound::<H, X, K, Nothing>(method).engine(parameters.clone(), vec![], vec![start]).is_not_finite(clock)
    {
        return Err(Error::Parameters { constants });
    }
    #[cfg(debug_assertions)]
    hold_at_start::<H, K>(system, &parameters, start, 0.0)?;
    if unsettled && H::AUTONOMOUS {
        energy::<H, K>(&parameters, start, 0.0, None).admissible(0.0)?;
    }
    Ok(parameters)
}
