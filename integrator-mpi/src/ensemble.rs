//! An ensemble whose members are dealt out to ranks.

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

/// The members of this rank, where `members` are dealt out by their index: ranks have neighbouring members, and as many as
/// each other, or one more.
///
/// ```
/// let universe = integrator_mpi::start()?;
/// assert_eq!(integrator_mpi::share(&universe.world(), 1_000), 0..1_000);
/// # Ok::<(), integrator_mpi::NotStarted>(())
/// ```
pub fn share(world: &impl Communicator, members: usize) -> Range<usize> {
    share_of(world.rank() as usize, world.size() as usize, members)
}

/// The members of a rank of so many.
pub(crate) fn share_of(rank: usize, ranks: usize, members: usize) -> Range<usize> {
    // The first ranks have one more.
    let (each, more) = (members / ranks, members % ranks);
    let first = |rank: usize| rank * each + rank.min(more);
    first(rank)..first(rank + 1)
}

/// The index of this rank's first member, and how many all ranks have, where it has so many.
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

/// Trajectories of one kind of system under way together on all ranks of a communicator.
///
/// Members are counted over all ranks, in the order of these. A member has the bits of its run alone, however many ranks
/// there are.
///
/// Where a method is said to be collective, every rank has to call it, with the same arguments but for what it says of its
/// own members; each gets the same answer. All others look at this rank alone.
pub struct Ensemble<'w, W: Communicator, C: Coords> {
    world: &'w W,
    /// Nothing where this rank has no members.
    held: Option<Held<C>>,
    /// The index of this rank's first member.
    first: usize,
    /// How many members all ranks have.
    count: usize,
    /// How many steps those under way have taken.
    steps: u64,
}

/// A member of this rank, as it is shown.
#[derive(Clone)]
pub struct Member<'e, C: Coords> {
    /// Its index among the members of all ranks.
    pub index: usize,
    /// Its state: the last finite one if it is lost.
    pub state: Phase<C>,
    /// How many steps it has taken: fewer than the ensemble if it is lost or gone.
    pub steps: u64,
    /// Its time.
    pub time: f64,
    /// The ensemble that it is in, where it has this place.
    local: &'e Local<C>,
    own: usize,
}

impl<C: Coords> Member<'_, C> {
    /// Its energy in that state, which is computed when it is asked for.
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
    /// An ensemble of the `(system, start)` pairs of all ranks that take steps `h`: each rank gives its own, which follow
    /// those of the rank before. [`share`] says which they are where they are dealt out evenly. Collective.
    ///
    /// # Errors
    /// [`Error::NoMembers`] without any member; [`Error::Refused`] naming the first member whose start or step is refused.
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
            Ok(local) => Ok(Some(Held::Processor(Box::new(local)))),
            Err(CoreError::NoMembers) => Ok(None),
            Err(error) => Err(Failure::Core { error, first }),
        };
        Ok(Self::of_held(world, agree(world, local)?, first, count, 0))
    }

    /// The ensemble with these members on this rank.
    pub(crate) fn of_held(world: &'w W, held: Option<Held<C>>, first: usize, count: usize, steps: u64) -> Self {
        Self { world, held, first, count, steps }
    }

    /// Starts the clock at `t0` instead of 0.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.held = self.held.map(|held| held.at_time(t0));
        self
    }

    /// Uses at most so many threads on this rank, instead of all that it may run on; no result depends on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.held = self.held.map(|held| held.with_threads(threads));
        self
    }

    /// Makes the calls that take steps end members where their energies leave a bound, as [`Local::watch_energy`] does on one rank.
    /// Collective.
    ///
    /// # Errors
    /// [`Error::Refused`] for a member under way that has no energy; [`Error::Rank`] for a bound that is not above zero, an `H` that
    /// reads the time, and members on a device, which computes no energies.
    pub fn watch_energy(&mut self, relative_bound: f64) -> Result<(), Error> {
        let outcome = self.held.as_mut().map_or(Ok(()), |held| held.watch_energy(relative_bound, self.first));
        agree(self.world, outcome)
    }

    /// Takes `steps` steps with every member that is under way. Collective.
    ///
    /// # Errors
    /// [`Error::Strayed`] where a [watch](Ensemble::watch_energy) ends members. [`Error::Lost`] names the members of all ranks that left the finite numbers in these steps; all others have taken
    /// them, and the ensemble goes on without the lost ones. [`Error::Rank`] for steps that cannot be counted, and a time that is
    /// not finite.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.carried(steps, |held, first| held.advance(steps, first))
    }

    /// As [`Ensemble::advance`], but after every `interval` steps each member under way is shown to `stays` with its index,
    /// and those for which it returns `false` stay where they are. Collective.
    ///
    /// # Errors
    /// As [`Ensemble::advance`]; [`Error::Rank`] for an interval of 0.
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

    /// How many steps the members that are under way have taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// How many members all ranks have.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are no members; never so.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The indices of this rank's members.
    pub fn of_rank(&self) -> Range<usize> {
        self.first..self.first + self.local().map_or(0, Local::len)
    }

    /// How many members of all ranks are under way: neither lost nor gone. Collective.
    pub fn active(&self) -> usize {
        let (own, mut all) = (self.local().map_or(0, Local::active) as u64, 0_u64);
        self.world.all_reduce_into(&own, &mut all, SystemOperation::sum());
        all as usize
    }

    /// This rank's members as an ensemble of their own, whose members are counted from 0; `None` where it has none.
    pub fn local(&self) -> Option<&Local<C>> {
        self.held.as_ref().map(Held::shown)
    }

    /// The communicator.
    pub(crate) fn world(&self) -> &'w W {
        self.world
    }

    /// The members of this rank, in their order.
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

    /// Shows every member of this rank, in their order.
    pub fn for_each_local(&self, visit: impl FnMut(Member<'_, C>)) {
        self.members_of_rank().for_each(visit);
    }
}
