//! Many trajectories of one kind of system: side by side in lanes, shared out among threads.
//!
//! Always true: a member's bits are those of the same system run alone on the same instruction set, whatever its
//! neighbours do and however many threads there are.

#[cfg(debug_assertions)]
use crate::stated::hold_at_start;
use crate::{
    abreast::Abreast,
    admissible::{admissible_with, change},
    clock::Clock,
    coords::Coords,
    error::{Error, Lost},
    hamiltonian::{Hamiltonian, Prepared},
    in_lanes::InLanes,
    instruction_set::InstructionSet,
    pack::{Course, Pack, Start},
    packs::packs,
    panics::Panics,
    phase::Phase,
    run::Run,
    slot::Keep,
    threads::all_threads,
};
use std::{
    fmt,
    panic::resume_unwind,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicU64, Ordering},
    },
    thread,
};

/// From how many updates of a coordinate on, all members together, other threads are started: that takes some ten
/// microseconds each, in which one thread does about so many.
const WORTH_A_THREAD: u64 = 1 << 17;

/// How many vector registers there are without AVX-512, which has 32.
const REGISTERS: usize = if cfg!(target_arch = "x86_64") { 16 } else { 32 };

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
    packs: Vec<Box<dyn Pack<C>>>,
    members: usize,
    /// How many coordinates all members have together.
    coordinates: u64,
    clock: Clock,
    /// Whether the energies of the starts are still to be looked at, where they depend on the time that the clock starts
    /// at.
    starts_unseen: bool,
    threads: usize,
}

impl<C: Coords> Ensemble<C> {
    /// An ensemble of `(system, start)` pairs that take steps `h` with any composition that may integrate the systems, or with
    /// [`Taylor`](crate::taylor::Taylor), where each member goes by polynomials of its own between these steps.
    ///
    /// # Errors
    /// [`Error::NoMembers`] without members; [`Error::Member`] naming the first member whose start or step is refused,
    /// for the reasons of [`Hamiltonian::run`].
    pub fn new<H, K, X>(method: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        K: Abreast,
        X: InLanes<H>,
        H::Coords: Coords<With<K> = C>,
    {
        let (mut prepared, mut coordinates) = (Vec::new(), 0);
        for (member, (system, start)) in members.into_iter().enumerate() {
            let refused = of_member(member);
            admissible_with(method, &start, h).map_err(refused)?;
            let parameters = system.parameters(start.q.length());
            if !H::Parameters::<f64>::not_finite(&parameters).is_empty() {
                // Whether that matters, a run of its own tells.
                Run::start::<H, X, K>(&system, method, start.clone(), h).map_err(refused)?;
            }
            #[cfg(debug_assertions)]
            hold_at_start::<H, K>(&system, &parameters, &start, 0.0).map_err(refused)?;
            coordinates += start.q.flat().len() as u64;
            let parameters = Arc::new(parameters);
            prepared.push(Start { constants: method.constants(parameters.clone()), parameters, state: start });
        }
        if prepared.is_empty() {
            return Err(Error::NoMembers);
        }
        let members = prepared.len();
        let threads = all_threads();
        let packs = match InstructionSet::chosen() {
            InstructionSet::Baseline => {
                packs::<H, X, <K as Abreast>::Plain, <K as Keep>::Plain, K, REGISTERS>(prepared, threads)
            }
            InstructionSet::Fused => {
                packs::<H, X, <K as Abreast>::Fused, <K as Keep>::Fused, K, REGISTERS>(prepared, threads)
            }
            // Alone, a member is what a run would be.
            InstructionSet::Avx512 if X::WIDE => {
                packs::<H, X, <K as Abreast>::Avx512, <K as Keep>::Avx512, K, 32>(prepared, threads)
            }
            InstructionSet::Avx512 => {
                packs::<H, X, <K as Abreast>::Avx512, <K as Keep>::Fused, K, 32>(prepared, threads)
            }
        };
        let clock = Clock { t0: 0.0, h, steps: 0 };
        let mut ensemble = Self { packs, members, coordinates, clock, starts_unseen: true, threads };
        if H::AUTONOMOUS {
            ensemble.see_starts()?;
        }
        Ok(ensemble)
    }

    /// Looks at the energies of the starts, once.
    ///
    /// # Errors
    /// [`Error::Member`] naming the first member whose energy is not finite.
    fn see_starts(&mut self) -> Result<(), Error> {
        if self.starts_unseen {
            let time = self.time();
            for pack in &self.packs {
                for (member, state) in (pack.first()..).zip(pack.states(self.clock)) {
                    pack.energy(member, &state, time).admissible(time).map_err(of_member(member))?;
                }
            }
            self.starts_unseen = false;
        }
        Ok(())
    }

    /// Starts the clock at `t0` instead of 0. A `t0` that is not finite is reported by the first `advance`.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.clock.t0 = t0;
        self
    }

    /// Uses at most so many threads instead of all that the machine has; no result depends on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads.max(1);
        self
    }

    /// Takes `steps` steps with every member that is under way.
    ///
    /// # Errors
    /// [`Error::Lost`] names the members that left the finite numbers in these steps, or came too near to a singularity for
    /// [`Taylor`](crate::taylor::Taylor); all others have taken them, and
    /// the ensemble goes on without the lost ones, which stay at their last finite state. [`Error::Time`],
    /// [`Error::Clock`] and [`Error::Steps`] leave the ensemble as it was, and so does [`Error::Member`], which the first
    /// call returns where `H` reads the time and has no value at a start.
    ///
    /// # Panics
    /// Where your own functions would, once all members have taken the steps for which they do not. A program that catches
    /// the panic finds the members for which they do at the last step before it, as if they had left there
    /// ([`Ensemble::steps_of`]); the ensemble goes on without them.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.advance_with(steps, |_| {})
    }

    /// As [`Ensemble::advance`], and tells `progress` from time to time how many of the `steps` are done, as the mean
    /// over all members; at the end, `steps`. It is called by this thread, which works like the others in between.
    ///
    /// # Errors
    /// As [`Ensemble::advance`].
    pub fn advance_with(&mut self, steps: u64, mut progress: impl FnMut(u64)) -> Result<(), Error> {
        self.carry_on(steps, u64::MAX, &|_, _| true, &mut progress)
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
        match interval {
            0 => Err(Error::SampleInterval),
            _ => self.carry_on(steps, interval, &stays, &mut |_| {}),
        }
    }

    fn carry_on(
        &mut self,
        steps: u64,
        interval: u64,
        stays: &(dyn Fn(usize, &Phase<C>) -> bool + Sync),
        progress: &mut dyn FnMut(u64),
    ) -> Result<(), Error> {
        let end = self.clock.end(steps)?;
        self.see_starts()?;
        let panics = Panics::default();
        let course = Course { clock: self.clock, steps, interval, stays, panics: &panics };
        let (members, packs) = (self.members as u64, self.packs.len());
        let updates = self.coordinates.saturating_mul(steps);
        let threads = if updates < WORTH_A_THREAD { 1 } else { self.threads.min(packs) };
        let done = AtomicU64::new(0);
        // Whoever is free takes the next pack; no result depends on who that is.
        let packs = Mutex::new(self.packs.iter_mut());
        let next = || packs.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = |progress: &mut dyn FnMut(u64)| {
            let mut lost = Vec::new();
            while let Some(pack) = next() {
                lost.extend(pack.advance(&course, &mut |took| {
                    let done = done.fetch_add(took, Ordering::Relaxed) + took;
                    panics.attempted(|| progress(done / members));
                }));
            }
            lost
        };
        let mut lost = thread::scope(|scope| {
            let others: Vec<_> = (1..threads).map(|_| scope.spawn(|| work(&mut |_| {}))).collect();
            let mut lost = work(progress);
            for other in others {
                lost.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
            }
            lost
        });
        self.clock.steps = end;
        panics.resume();
        progress(steps);
        lost.sort_unstable_by_key(|(member, _)| *member);
        if lost.is_empty() { Ok(()) } else { Err(Error::Lost(Lost { members: lost })) }
    }

    /// Changes the states of the members that are under way, one after the other, between two steps: coordinates that are
    /// wrapped into a periodic box, momenta that are drawn anew by a thermostat. Time and the number of steps go on; members
    /// that are lost or gone stay as they are.
    ///
    /// Each member has the bits of a run whose state is [changed](Run::map_state) in the same way.
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
    /// [`Error::Member`] naming the first member whose new state is refused, for the reasons of [`Run::map_state`]; all
    /// members stay as they were.
    pub fn map_states(&mut self, mut map: impl FnMut(usize, &mut Phase<C>)) -> Result<(), Error> {
        let mut changed = Vec::with_capacity(self.packs.len());
        for pack in &self.packs {
            let mut states = pack.states(self.clock);
            for (member, state) in (pack.first()..).zip(&mut states).filter(|(member, _)| pack.is_under_way(*member)) {
                self.change(pack.as_ref(), member, state, &mut map).map_err(of_member(member))?;
            }
            changed.push(states);
        }
        for (pack, states) in self.packs.iter_mut().zip(changed) {
            pack.restart(states, self.clock.steps);
        }
        Ok(())
    }

    /// Changes the state of a member.
    ///
    /// # Errors
    /// As [`Run::map_state`].
    fn change(
        &self,
        pack: &dyn Pack<C>,
        member: usize,
        state: &mut Phase<C>,
        map: &mut impl FnMut(usize, &mut Phase<C>),
    ) -> Result<(), Error> {
        change(state, self.clock.h, |state| map(member, state))?;
        // Where the starts are unseen, their time is not settled.
        if !self.starts_unseen {
            let time = self.time();
            pack.energy(member, state, time).admissible(time)?;
        }
        Ok(())
    }

    /// How many members there are.
    pub fn len(&self) -> usize {
        self.members
    }

    /// Whether there are no members; never so.
    pub fn is_empty(&self) -> bool {
        self.members == 0
    }

    /// How many members are under way: neither lost nor gone.
    pub fn active(&self) -> usize {
        self.packs.iter().map(|pack| pack.active()).sum()
    }

    /// The time of the members that are under way, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.clock.at(self.clock.steps)
    }

    /// How many steps the members that are under way have taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// How many steps a member has taken: fewer than the others if it is lost or gone. `None` beyond the last member.
    pub fn steps_of(&self, member: usize) -> Option<u64> {
        Some(self.pack_of(member)?.steps(member, self.clock))
    }

    /// The state of a member: its last finite one if it is lost, the one in which it left if it is gone.
    pub fn state(&self, member: usize) -> Option<Phase<C>> {
        Some(self.pack_of(member)?.state(member, self.clock))
    }

    /// The energy of a member in that state.
    pub fn energy(&self, member: usize) -> Option<f64> {
        let pack = self.pack_of(member)?;
        let time = self.clock.at(pack.steps(member, self.clock));
        Some(pack.energy(member, &pack.state(member, self.clock), time).total)
    }

    /// The states of all members, in their order.
    pub fn states(&self) -> impl Iterator<Item = Phase<C>> {
        self.packs.iter().flat_map(|pack| pack.states(self.clock))
    }

    /// The member's pack: packs hold members in their order.
    fn pack_of(&self, member: usize) -> Option<&dyn Pack<C>> {
        let after = self.packs.partition_point(|pack| pack.first() <= member);
        let pack = after.checked_sub(1).filter(|_| member < self.members)?;
        Some(self.packs.get(pack)?.as_ref())
    }
}

impl<C: Coords> fmt::Debug for Ensemble<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ensemble")
            .field("members", &self.members)
            .field("step", &self.clock.h)
            .field("steps", &self.clock.steps)
            .field("time", &self.time())
            .finish()
    }
}

/// What is said of an error that concerns a member.
fn of_member(member: usize) -> impl Fn(Error) -> Error + Copy {
    move |error| Error::Member { member, error: Box::new(error) }
}
