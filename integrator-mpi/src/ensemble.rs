//! An ensemble with members distributed over ranks.

use crate::{
    error::{Error, Failure, agree},
    held::Held,
};
use integrator_core::{
    __private::LaneScalars, Coords, Ensemble as Local, Error as CoreError, Hamiltonian, InLanes, Phase,
};
use mpi::{
    collective::SystemOperation,
    traits::{Communicator, CommunicatorCollectives},
};
use std::{fmt, ops::Range};

/// Returns the indices of the members of this rank, for `members` that are distributed evenly.
///
/// Ranks have consecutive members. The numbers of members of two ranks differ by at most one.
///
/// ```
/// let universe = integrator_mpi::start()?;
/// assert_eq!(integrator_mpi::share(&universe.world(), 1_000), 0..1_000);
/// # Ok::<(), integrator_mpi::NotStarted>(())
/// ```
pub fn share(world: &impl Communicator, members: usize) -> Range<usize> {
    share_of(world.rank() as usize, world.size() as usize, members)
}

/// The members of a rank of this number.
pub(crate) fn share_of(rank: usize, ranks: usize, members: usize) -> Range<usize> {
    // The first ranks have one more.
    let (each, more) = (members / ranks, members % ranks);
    let first = |rank: usize| rank * each + rank.min(more);
    first(rank)..first(rank + 1)
}

/// The index of this rank's first member, and the number of members of all ranks, if this rank has the given number.
///
/// # Errors
/// [`Error::NoMembers`]
pub(crate) fn counted(world: &impl Communicator, members: usize) -> Result<(usize, usize), Error> {
    let mut counts = vec![0_u64; world.size() as usize];
    world.all_gather_into(&(members as u64), &mut counts[..]);
    let before = |rank: usize| counts[..rank].iter().sum::<u64>() as usize;
    let (first, count) = (before(world.rank() as usize), before(counts.len()));
    if count == 0 { Err(Error::NoMembers) } else { Ok((first, count)) }
}

/// Many trajectories of one type of system, integrated together on all ranks of a communicator.
///
/// Members are counted over all ranks, in the order of the ranks. Each member is bitwise identical to a run of its own,
/// for every number of ranks.
///
/// Every rank must call the methods that are marked as collective. The arguments must be the same, except those about
/// the members of a rank, and each rank gets the same result. All other methods concern this rank only.
pub struct Ensemble<'w, W: Communicator, C: Coords> {
    world: &'w W,
    /// Nothing where this rank has no members.
    held: Option<Held<C>>,
    /// The index of this rank's first member.
    first: usize,
    /// How many members all ranks have.
    count: usize,
    /// How many steps those in progress have taken.
    steps: u64,
}

/// A member of this rank.
#[derive(Clone)]
pub struct Member<'e, C: Coords> {
    /// The index among the members of all ranks.
    pub index: usize,
    /// The state; for a failed member, the last finite one.
    pub state: Phase<C>,
    /// The number of steps, which is smaller for failed and finished members.
    pub steps: u64,
    /// The time.
    pub time: f64,
    /// The ensemble that it is in, where it has this place.
    local: &'e Local<C>,
    own: usize,
}

impl<C: Coords> Member<'_, C> {
    /// Computes the energy of the state.
    pub fn energy(&self) -> f64 {
        // Members are counted as states are.
        self.local.energy(self.own).unwrap_or(f64::NAN)
    }
}

impl<C: Coords> fmt::Debug for Member<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { index, state, steps, time, .. } = self;
        let mut text = f.debug_struct("Member");
        text.field("index", index).field("state", state).field("steps", steps).field("time", time);
        text.finish_non_exhaustive()
    }
}

impl<'w, W: Communicator, C: Coords> Ensemble<'w, W, C> {
    /// Creates an ensemble of the `(system, start)` pairs of all ranks, with step `h`. Collective.
    ///
    /// Each rank passes its own pairs, which follow those of the previous rank. [`share`] returns their indices for an
    /// even distribution.
    ///
    /// # Errors
    /// - [`Error::NoMembers`]: there are no members.
    /// - [`Error::Refused`]: a start or the step is invalid; the error names the first such member.
    pub fn new<H, X>(
        world: &'w W,
        method: X,
        members_of_rank: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let members: Vec<_> = members_of_rank.into_iter().collect();
        let (first, count) = counted(world, members.len())?;
        let local = match Local::new(method, members, h) {
            Ok(local) => Ok(Some(Held::Processor(Box::new(local.numbered_from(first))))),
            Err(CoreError::NoMembers) => Ok(None),
            Err(error) => Err(Failure::Core { error, first }),
        };
        Ok(Self::of_held(world, agree(world, local)?, first, count, 0))
    }

    /// The ensemble with these members on this rank.
    pub(crate) fn of_held(world: &'w W, held: Option<Held<C>>, first: usize, count: usize, steps: u64) -> Self {
        Self { world, held, first, count, steps }
    }

    /// Sets the seed of random numbers, like [`integrator_core::Ensemble::with_seed`]. Results do not depend on the number of
    /// ranks.
    #[must_use]
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.held = self.held.map(|held| held.with_seed(seed));
        self
    }

    /// Starts the clock at `t0` instead of 0.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.held = self.held.map(|held| held.at_time(t0));
        self
    }

    /// Limits the number of threads on this rank; the default is all that it may run on. Results do not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.held = self.held.map(|held| held.with_threads(threads));
        self
    }

    /// Stops members whose energies leave a bound, in every call that takes steps; see [`Local::watch_energy`].
    /// Collective.
    ///
    /// # Errors
    /// - [`Error::Refused`]: an active member has no energy.
    /// - [`Error::Rank`]: the bound is not above zero, `H` depends on time, or the members are on a device, which
    ///   computes no energies.
    pub fn watch_energy(&mut self, relative_bound: f64) -> Result<(), Error> {
        let outcome = self.held.as_mut().map_or(Ok(()), |held| held.watch_energy(relative_bound, self.first));
        agree(self.world, outcome)
    }

    /// Takes `steps` steps with every active member. Collective.
    ///
    /// # Errors
    /// - [`Error::Strayed`]: a [watch](Ensemble::watch_energy) stopped members.
    /// - [`Error::Lost`]: members diverged; the error lists those of all ranks. All others have taken the steps, and
    ///   the ensemble can be continued.
    /// - [`Error::Rank`]: the steps cannot be counted, or the time is not finite.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.carried(steps, |held, first| held.advance(steps, first))
    }

    /// Takes steps like [`Ensemble::advance`], and stops members individually. Collective.
    ///
    /// After every `interval` steps, each active member is passed to `stays` with its index. If it returns `false`, the
    /// member has finished and keeps this state.
    ///
    /// # Errors
    /// Those of [`Ensemble::advance`]; [`Error::Rank`] if the interval is 0.
    pub fn advance_while(
        &mut self,
        steps: u64,
        interval: u64,
        stays: impl Fn(usize, &Phase<C>) -> bool + Sync,
    ) -> Result<(), Error> {
        self.carried(steps, |held, first| held.advance_while(steps, interval, first, &stays))
    }

    /// What came of carrying on the members of each rank, as all of them are told it.
    fn carried(
        &mut self,
        steps: u64,
        advance: impl FnOnce(&mut Held<C>, usize) -> Result<(), Failure>,
    ) -> Result<(), Error> {
        let outcome = self.held.as_mut().map_or(Ok(()), |held| advance(held, self.first));
        let outcome = agree(self.world, outcome);
        // Those that are not lost have taken their steps.
        if matches!(outcome, Ok(()) | Err(Error::Lost { .. } | Error::Strayed { .. })) {
            self.steps += steps;
        }
        outcome
    }

    /// Returns the number of steps that the active members have taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Returns the number of members of all ranks.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns `false`: an ensemble has at least one member.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Returns the indices of the members of this rank.
    pub fn of_rank(&self) -> Range<usize> {
        self.first..self.first + self.local().map_or(0, Local::len)
    }

    /// Returns the number of active members of all ranks, which have neither failed nor finished. Collective.
    pub fn active(&self) -> usize {
        let (own, mut all) = (self.local().map_or(0, Local::active) as u64, 0_u64);
        self.world.all_reduce_into(&own, &mut all, SystemOperation::sum());
        all as usize
    }

    /// Returns the members of this rank as a separate ensemble, counted from 0, or `None` if the rank has no members.
    pub fn local(&self) -> Option<&Local<C>> {
        self.held.as_ref().map(Held::shown)
    }

    /// The communicator.
    pub(crate) fn world(&self) -> &'w W {
        self.world
    }

    /// Iterates over the members of this rank, in their order.
    pub fn members_of_rank(&self) -> impl Iterator<Item = Member<'_, C>> {
        self.local()
            .into_iter()
            .flat_map(|local| local.states().enumerate().map(move |(own, state)| (local, own, state)))
            .map(|(local, own, state)| Member {
                index: self.first + own,
                state,
                // Members are counted as states are.
                steps: local.steps_of(own).unwrap_or_default(),
                time: local.time_of(own).unwrap_or_default(),
                local,
                own,
            })
    }

    /// Calls `visit` with every member of this rank, in their order.
    pub fn for_each_local(&self, visit: impl FnMut(Member<'_, C>)) {
        self.members_of_rank().for_each(visit);
    }
}
