//! What can go wrong on some rank, as all ranks are told it.

use integrator_core::Error as CoreError;
use mpi::traits::CommunicatorCollectives;
use mpi::{datatype::PartitionMut, traits::Communicator};
use serde::{Deserialize, Serialize};

/// How many members the text of an error names.
const SHOWN: usize = 4;

/// Why an ensemble could not start or go on: the same value on every rank, so that all of them take the same way and none
/// waits for another.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// No rank has a member.
    #[error("an ensemble needs at least one member, on any rank")]
    NoMembers,
    /// A member cannot begin where it was asked to: the first one of all.
    #[error("member {member} (on rank {rank}): {what}")]
    Refused {
        /// Its index among the members of all ranks.
        member: usize,
        /// Its rank.
        rank: i32,
        /// What is wrong with it.
        what: String,
    },
    /// Members left the finite numbers; they stay at their last finite state, and the others went on.
    #[error("{}", lost_text(members))]
    Lost {
        /// These members, by their index among those of all ranks.
        members: Vec<LostMember>,
    },
    /// The energies of members left the bound of [`Ensemble::watch_energy`](crate::Ensemble::watch_energy); they stay one step
    /// before, and the others went on.
    #[error("{}", strayed_text(members))]
    Strayed {
        /// These members, and those that left the finite numbers in the same call.
        members: Vec<StrayedMember>,
    },
    /// The system is no lattice whose sites are moved alike.
    #[error(
        "`{system}` is no lattice that ranks can share: its coordinates have to be slices (`q: &[f64]`, or rows `&[[f64; M]]`), and \
         both parts sums over sites and their neighbours, as in `(q[i + 1] - q[i])`"
    )]
    NoLattice {
        /// The name of its type.
        system: &'static str,
    },
    /// There are too few sites for so many ranks.
    #[error(
        "{sites} sites are too few for {ranks} ranks: each has to have {least} of them, which it tells its neighbours; take fewer ranks"
    )]
    FewSites {
        /// How many sites there are.
        sites: usize,
        /// How many ranks.
        ranks: usize,
        /// How many sites each rank has to have.
        least: usize,
    },
    /// Two ranks that both moved a site do not agree on where it is.
    #[error(
        "site {site} was moved otherwise by two ranks: a formula that reads how many sites there are, or the number of a site, is \
         another one in each slab. Give such numbers as fields, which the closure makes for the sites of a slab"
    )]
    SitesDiffer {
        /// Its number among all sites.
        site: usize,
    },
    /// A site left the finite numbers; all stay at the step before.
    #[error(
        "site {site} left the finite numbers in step {step} (time {time}); all sites stay at the step before. A smaller step helps most \
         often"
    )]
    Diverged {
        /// Its number among all sites.
        site: usize,
        /// The first step whose state is not finite.
        step: u64,
        /// The time at the end of that step.
        time: f64,
    },
    /// The end of a slab left the finite numbers, where the sites of others are missing; all stay at the step before.
    #[error(
        "the end of a slab left the finite numbers in step {step} (time {time}), where it meets no neighbour or another site than its own, as in \
         a ring whose coordinates grow from site to site: take the difference to that growth as coordinate"
    )]
    HaloDiverged {
        /// The first step whose state is not finite.
        step: u64,
        /// The time at the end of that step.
        time: f64,
    },
    /// What was asked of a rank is no number of steps, no time, or no interval, or a file could not be written.
    #[error("on rank {rank}: {what}")]
    Rank {
        /// The first rank that says so.
        rank: i32,
        /// What is wrong.
        what: String,
    },
}

/// A member that left the finite numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LostMember {
    /// Its index among the members of all ranks.
    pub member: usize,
    /// The first step whose state is not finite.
    pub step: u64,
    /// The time at the end of that step.
    pub time: f64,
}

impl LostMember {
    fn what(&self) -> String {
        format!("it left the finite numbers in step {} (time {})", self.step, self.time)
    }
}

/// A member whose energy left its bound, or which left the finite numbers in the same call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrayedMember {
    /// Its index among the members of all ranks.
    pub member: usize,
    /// What is wrong with it.
    pub what: String,
}

fn strayed_text(members: &[StrayedMember]) -> String {
    let named: Vec<String> = members.iter().take(SHOWN).map(|strayed| strayed.member.to_string()).collect();
    let more = if members.len() > SHOWN { ", ..." } else { "" };
    let first = members.first().map(|StrayedMember { member, what }| format!("; member {member}: {what}"));
    format!(
        "{} member(s) left the bound on their energy or the finite numbers ({}{more}); the others went on{}",
        members.len(),
        named.join(", "),
        first.unwrap_or_default()
    )
}

fn lost_text(members: &[LostMember]) -> String {
    let named: Vec<String> = members
        .iter()
        .take(SHOWN)
        .map(|LostMember { member, step, time }| format!("{member} in step {step} (time {time})"))
        .collect();
    let more = members.len().saturating_sub(SHOWN);
    let more = if more == 0 { String::new() } else { format!(" and {more} more") };
    format!(
        "{} member(s) left the finite numbers: {}{more}. They stay at their last finite state; a smaller step helps most often",
        members.len(),
        named.join(", "),
    )
}

/// What a rank tells the others of its own work.
#[derive(Serialize, Deserialize)]
enum Outcome {
    Done,
    Refused { member: usize, what: String },
    Lost(Vec<LostMember>),
    Strayed(Vec<StrayedMember>),
    Failed(String),
}

/// A failure of this rank's own work.
pub(crate) enum Failure {
    /// Of the core, about members that are counted from `first` on.
    Core { error: CoreError, first: usize },
    /// Anything else.
    Other(String),
}

impl From<Failure> for Outcome {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Core { error: CoreError::Member { member, error }, first } => {
                Self::Refused { member: first + member, what: error.to_string() }
            }
            Failure::Core { error: CoreError::Members { mut members, .. }, first } if !members.is_empty() => {
                let (member, error) = members.swap_remove(0);
                Self::Refused { member: first + member, what: error.to_string() }
            }
            Failure::Core { error: CoreError::Lost(lost), first } => Self::Lost(
                lost.members
                    .into_iter()
                    .map(|(member, at)| LostMember { member: first + member, step: at.step, time: at.time })
                    .collect(),
            ),
            Failure::Core { error: CoreError::Strayed { members }, first } => Self::Strayed(
                members
                    .into_iter()
                    .map(|(member, error)| StrayedMember { member: first + member, what: error.to_string() })
                    .collect(),
            ),
            Failure::Core { error, .. } => Self::Failed(error.to_string()),
            Failure::Other(what) => Self::Failed(what),
        }
    }
}

/// What came of work that every rank did by itself: what this rank has made of it if all of them are done, and otherwise the
/// same error on all. Every rank has to call it.
pub(crate) fn agree<T>(world: &impl Communicator, outcome: Result<T, Failure>) -> Result<T, Error> {
    let (made, outcome) = match outcome {
        Ok(made) => (Some(made), Outcome::Done),
        Err(failure) => (None, failure.into()),
    };
    let (mut lost, mut strayed) = (Vec::new(), Vec::new());
    for (rank, outcome) in (0..).zip(shared(world, &outcome)) {
        match outcome {
            Outcome::Done => {}
            Outcome::Refused { member, what } => return Err(Error::Refused { member, rank, what }),
            Outcome::Lost(members) => lost.extend(members),
            Outcome::Strayed(members) => strayed.extend(members),
            Outcome::Failed(what) => return Err(Error::Rank { rank, what }),
        }
    }
    if !strayed.is_empty() {
        strayed.extend(lost.into_iter().map(|lost| StrayedMember { member: lost.member, what: lost.what() }));
        strayed.sort_unstable_by_key(|strayed| strayed.member);
        return Err(Error::Strayed { members: strayed });
    }
    match made {
        Some(made) if lost.is_empty() => Ok(made),
        _ => Err(Error::Lost { members: lost }),
    }
}

/// The outcomes of all ranks, in their order.
fn shared(world: &impl Communicator, outcome: &Outcome) -> Vec<Outcome> {
    // Numbers and texts can always be written to memory, and what was written can be read.
    let own = postcard::to_allocvec(outcome).unwrap_or_default();
    let ranks = world.size() as usize;
    let mut lengths = vec![0_i32; ranks];
    world.all_gather_into(&(own.len() as i32), &mut lengths[..]);
    let starts: Vec<i32> =
        lengths.iter().scan(0, |next, length| Some(std::mem::replace(next, *next + length))).collect();
    let mut all = vec![0_u8; lengths.iter().map(|length| *length as usize).sum()];
    world.all_gather_varcount_into(&own[..], &mut PartitionMut::new(&mut all[..], &lengths[..], &starts[..]));
    let mut rest = &all[..];
    lengths
        .iter()
        .map(|length| {
            let (own, after) = rest.split_at(*length as usize);
            rest = after;
            postcard::from_bytes(own).unwrap_or_else(|fault| Outcome::Failed(fault.to_string()))
        })
        .collect()
}
