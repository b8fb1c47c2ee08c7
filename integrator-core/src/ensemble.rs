//! Many trajectories of one kind of system: side by side in lanes, shared out among threads.
//!
//! Always true: a member's bits are those of the same system run alone on the same instruction set, whatever its
//! neighbours do and however many threads there are.

#[cfg(debug_assertions)]
use crate::stated::hold_at_start;
use crate::{
    abreast::Abreast,
    admissible::admissible_with,
    clock::Clock,
    coords::Coords,
    energies::{EnergyOf, energy},
    error::{Error, Lost},
    group::GroupMoves,
    hamiltonian::{Hamiltonian, Prepared, Shaped},
    in_lanes::InLanes,
    instruction_set::InstructionSet,
    method::Method,
    moves::Moves,
    pack::{Alone, Course, Pack, Start},
    panics::Panics,
    phase::Phase,
    real::Real,
    run::Run,
    side_by_side::SideBySide,
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

/// How many packs a thread gets, so that all threads end at about the same time, and how large a pack may grow, so that
/// those who leave early leave a gap in few of the motions.
const PACKS_PER_THREAD: usize = 4;
const GROUPS_PER_PACK: usize = 16;

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
            let refused = |error| Error::Member { member, error: Box::new(error) };
            admissible_with(method, &start, h).map_err(refused)?;
            let parameters = system.parameters(start.q.length());
            if !H::Parameters::<f64>::not_finite(&parameters).is_empty() {
                // Whether that matters, a run of its own tells.
                Run::start::<H, X, K>(&system, method, start.clone(), h).map_err(refused)?;
            }
            #[cfg(debug_assertions)]
            hold_at_start::<H, K>(&system, &parameters, &start).map_err(refused)?;
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
            for member in 0..self.members {
                let admissible =
                    self.pack_of(member).map_or(Ok(()), |pack| pack.energy(member, self.clock).admissible(time));
                admissible.map_err(|error| Error::Member { member, error: Box::new(error) })?;
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
        Some(self.pack_of(member)?.energy(member, self.clock).total)
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

/// A member of a system as it starts with a method.
type StartOf<H, X, K> = Start<<H as Hamiltonian>::Parameters<f64>, <X as Method<H>>::Constants, Shaped<H, K>>;

/// Neighbours that are alike in what lanes have to share go side by side, in packs of such a size that threads can share
/// them; whoever is like no neighbour goes alone.
fn packs<H: Hamiltonian, X: InLanes<H>, L: Real, R: Real, K: Keep, const REGISTERS: usize>(
    members: Vec<StartOf<H, X, K>>,
    threads: usize,
) -> Vec<Box<dyn Pack<Shaped<H, K>>>> {
    let together: GroupMoves<X::Motion<L, K>> = X::group_moves::<L, K, REGISTERS>();
    let alone: Moves<X::Motion<R, K>> = X::moves::<R, K>();
    let energy: EnergyOf<H::Parameters<f64>, Shaped<H, K>> = energy::<H, R, K>;
    let group = together.lanes * together.together;
    let size = group * (members.len() / (group * PACKS_PER_THREAD * threads)).clamp(1, GROUPS_PER_PACK);
    let mut packs: Vec<Box<dyn Pack<Shaped<H, K>>>> = Vec::new();
    let mut members = members.into_iter().peekable();
    let mut first = 0;
    while let Some(member) = members.next() {
        let mut alike = vec![member];
        while alike.len() < size
            && let Some(next) = members.next_if(|next| {
                let same = <H::Parameters<f64> as Prepared<f64>>::alike(&alike[0].parameters, &next.parameters);
                same && alike[0].state.q.length() == next.state.q.length()
            })
        {
            alike.push(next);
        }
        let count = alike.len();
        packs.push(match <[_; 1]>::try_from(alike) {
            Ok([member]) => Box::new(Alone::new(first, member, alone, energy)),
            Err(alike) => Box::new(SideBySide::new(first, alike, together, energy)),
        });
        first += count;
    }
    packs
}
