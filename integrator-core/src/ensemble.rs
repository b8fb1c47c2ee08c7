//! Many trajectories of one kind of system: side by side in lanes, shared out among threads.
//!
//! Always true: a member's bits are those of the same system run alone on the same instruction set, whatever its
//! neighbours do and however many threads there are.

use crate::{
    composition::Composition,
    coords::Coords,
    engine::{Clock, Moves, moves},
    error::{Divergence, Error, Lost},
    hamiltonian::{Hamiltonian, Prepared, Shaped},
    instruction_set::InstructionSet,
    lanes::Abreast,
    pack::{Alone, Member, Pack, SideBySide},
    phase::Phase,
    real::Real,
    run::admissible_with,
    slot::Keep,
};
use std::{fmt, num::NonZeroUsize, thread};

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
    clock: Clock,
    threads: usize,
}

impl<C: Coords> Ensemble<C> {
    /// An ensemble of `(system, start)` pairs that take steps `h` with any composition that may integrate the systems.
    ///
    /// # Errors
    /// [`Error::NoMembers`] without members; [`Error::Member`] naming the first member whose start or step is refused,
    /// for the reasons of [`Hamiltonian::run`].
    pub fn new<H, K, X>(composition: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        K: Abreast,
        X: Composition<H>,
        H::Coords: Coords<With<K> = C>,
    {
        let _ = composition;
        let mut prepared = Vec::new();
        for (member, (system, start)) in members.into_iter().enumerate() {
            admissible_with::<X, _>(&start, h).map_err(|error| Error::Member { member, error: Box::new(error) })?;
            prepared.push((system.parameters(start.q.length()), start));
        }
        if prepared.is_empty() {
            return Err(Error::NoMembers);
        }
        let members = prepared.len();
        let packs = match InstructionSet::chosen() {
            InstructionSet::Baseline => packs::<H, X, <K as Abreast>::Plain, <K as Keep>::Plain, K>(prepared),
            InstructionSet::Fused => packs::<H, X, <K as Abreast>::Fused, <K as Keep>::Fused, K>(prepared),
            // Alone, a member is what a run would be.
            InstructionSet::Avx512 if H::WIDE => {
                packs::<H, X, <K as Abreast>::Avx512, <K as Keep>::Avx512, K>(prepared)
            }
            InstructionSet::Avx512 => packs::<H, X, <K as Abreast>::Avx512, <K as Keep>::Fused, K>(prepared),
        };
        let threads = thread::available_parallelism().map_or(1, NonZeroUsize::get);
        Ok(Self { packs, members, clock: Clock { t0: 0.0, h, steps: 0 }, threads })
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

    /// Takes `steps` steps with every member that is still finite.
    ///
    /// # Errors
    /// [`Error::Lost`] names the members that left the finite numbers in these steps; all others have taken them, and
    /// the ensemble goes on without the lost ones, which stay at their last finite state. [`Error::Time`] and
    /// [`Error::Steps`] leave the ensemble as it was.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let end = self.clock.end(steps)?;
        let clock = self.clock;
        let share = self.packs.len().div_ceil(self.threads).max(1);
        let run = |packs: &mut [Box<dyn Pack<C>>]| -> Vec<(usize, Divergence)> {
            packs.iter_mut().flat_map(|pack| pack.advance(clock, steps)).collect()
        };
        let lost: Vec<(usize, Divergence)> = if self.threads == 1 || self.packs.len() == 1 {
            run(&mut self.packs)
        } else {
            thread::scope(|scope| {
                let shares: Vec<_> =
                    self.packs.chunks_mut(share).map(|packs| scope.spawn(move || run(packs))).collect();
                // A thread only ends early if a method of the user panicked in it, and then so does this one.
                shares
                    .into_iter()
                    .flat_map(|share| share.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
                    .collect()
            })
        };
        self.clock.steps = end;
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

    /// The time of the members that are not lost, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.clock.at(self.clock.steps)
    }

    /// How many steps the members that are not lost have taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// The state of a member, its last finite one if it is lost; `None` beyond the last member.
    pub fn state(&self, member: usize) -> Option<Phase<C>> {
        let pack = self.packs.get(self.pack_of(member)?)?;
        Some(pack.state(member, self.clock))
    }

    /// The energy of a member in that state.
    pub fn energy(&self, member: usize) -> Option<f64> {
        let pack = self.packs.get(self.pack_of(member)?)?;
        Some(pack.energy(member, self.clock))
    }

    /// The states of all members, in their order.
    pub fn states(&self) -> impl Iterator<Item = Phase<C>> {
        (0..self.members).filter_map(|member| self.state(member))
    }

    /// The member's pack: packs hold members in their order.
    fn pack_of(&self, member: usize) -> Option<usize> {
        let after = self.packs.partition_point(|pack| pack.first() <= member);
        after.checked_sub(1).filter(|_| member < self.members)
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

/// Neighbours that are alike in what lanes have to share go side by side; a rest that fills no lanes goes alone.
fn packs<H: Hamiltonian, X: Composition<H>, L: Real, R: Real, K: Keep>(
    members: Vec<Member<H::Parameters<f64>, Shaped<H, K>>>,
) -> Vec<Box<dyn Pack<Shaped<H, K>>>> {
    let lanes: Moves<H::Motion<L, K>> = moves::<H, X, L, K>();
    let alone: Moves<H::Motion<R, K>> = moves::<H, X, R, K>();
    let mut packs: Vec<Box<dyn Pack<Shaped<H, K>>>> = Vec::new();
    let mut members = members.into_iter().peekable();
    let mut first = 0;
    while let Some(member) = members.next() {
        let mut alike = vec![member];
        while alike.len() < L::LANES
            && let Some(next) = members.next_if(|next| {
                let same = <H::Parameters<f64> as Prepared<f64>>::alike(&alike[0].0, &next.0);
                same && alike[0].1.q.length() == next.1.q.length()
            })
        {
            alike.push(next);
        }
        let count = alike.len();
        packs.push(if count == L::LANES {
            Box::new(SideBySide::new(first, alike, lanes, alone))
        } else {
            Box::new(Alone::new(first, alike, alone))
        });
        first += count;
    }
    packs
}
