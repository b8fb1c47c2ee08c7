//! Errors on some rank, as reported to all ranks.

use integrator_core::Error as CoreError;
use mpi::traits::CommunicatorCollectives;
use mpi::{datatype::PartitionMut, traits::Communicator};
use serde::{Deserialize, Serialize};

/// The number of members that a message names.
const SHOWN: usize = 4;

/// The reason why an ensemble or a lattice could not start or continue.
///
/// The value is the same on every rank, so all ranks take the same branch and none waits for another.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// No rank has a member.
    #[error("an ensemble requires at least one member on any rank")]
    NoMembers,
    /// A member has an invalid start or step; the error names the first one of all ranks.
    #[error("member {member} (on rank {rank}): {what}")]
    Refused {
        /// The index among the members of all ranks.
        member: usize,
        /// The rank of the member.
        rank: i32,
        /// The reason.
        what: String,
    },
    /// Members diverged. They keep their last finite states; the others have taken the steps.
    #[error("{}", lost_text(members))]
    Lost {
        /// The failed members, with their indices among those of all ranks.
        members: Vec<LostMember>,
    },
    /// The energies of members left the bound of [`Ensemble::watch_energy`](crate::Ensemble::watch_energy).
    ///
    /// These members keep the state of the step before; the others have taken the steps.
    #[error("{}", strayed_text(members))]
    Strayed {
        /// These members, and those that diverged in the same call.
        members: Vec<StrayedMember>,
    },
    /// The system is not a lattice with the same flow for all sites.
    #[error(
        "`{system}` is not a lattice that ranks can share\nhelp: write the coordinates as slices, `q: &[f64]` or `q: \
         &[[f64; M]]`, and both parts as sums over sites and their neighbours, as in `(q[i + 1] - q[i])`"
    )]
    NoLattice {
        /// The type name of the system.
        system: &'static str,
    },
    /// There are too few sites for this number of ranks.
    #[error(
        "{sites} sites are too few for {ranks} ranks, each of which requires at least {least}\nhelp: use fewer \
         ranks\nnote: a rank sends this many sites to its neighbours"
    )]
    FewSites {
        /// The number of sites.
        sites: usize,
        /// The number of ranks.
        ranks: usize,
        /// The smallest number of sites per rank.
        least: usize,
    },
    /// Two ranks that both integrate a site have different values for it.
    #[error(
        "two ranks disagree about site {site}\nhelp: pass the number of sites, or the index of a site, as a field that \
         the closure sets for the sites of a slab\nnote: a formula that reads them differs between slabs"
    )]
    SitesDiffer {
        /// The index among all sites.
        site: usize,
    },
    /// A site diverged. All sites keep the state of the step before.
    #[error(
        "site {site} is not finite after step {step} (t = {time})\nhelp: use a smaller step\nnote: all sites stay at the \
         state before this step"
    )]
    Diverged {
        /// The index among all sites.
        site: usize,
        /// The first step whose state is not finite.
        step: u64,
        /// The time at the end of that step.
        time: f64,
    },
    /// The border of a slab diverged, where the sites of other ranks are missing. All sites keep the state of the step
    /// before.
    #[error(
        "the border of a slab is not finite after step {step} (t = {time})\nhelp: if the coordinates grow from site to \
         site, as in a ring, use the difference to this growth as the coordinate\nnote: at the border, sites of other \
         ranks are missing or different"
    )]
    HaloDiverged {
        /// The first step whose state is not finite.
        step: u64,
        /// The time at the end of that step.
        time: f64,
    },
    /// An argument of a rank is not a valid number of steps, time or interval, or a file could not be written.
    #[error("on rank {rank}: {what}")]
    Rank {
        /// The first rank with this error.
        rank: i32,
        /// The reason.
        what: String,
    },
}

/// A member that diverged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LostMember {
    /// The index among the members of all ranks.
    pub member: usize,
    /// The first step whose state is not finite.
    pub step: u64,
    /// The time at the end of that step.
    pub time: f64,
}

impl LostMember {
    fn what(&self) -> String {
        format!("the state after step {} (t = {}) is not finite", self.step, self.time)
    }
}

/// A member whose energy left its bound, or which diverged in the same call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrayedMember {
    /// The index among the members of all ranks.
    pub member: usize,
    /// The reason.
    pub what: String,
}

/// The number of members, as a noun.
fn count_of(members: usize) -> String {
    match members {
        1 => "1 member".to_owned(),
        count => format!("{count} members"),
    }
}

fn strayed_text(members: &[StrayedMember]) -> String {
    let named: Vec<String> = members.iter().take(SHOWN).map(|strayed| strayed.member.to_string()).collect();
    let more = if members.len() > SHOWN { ", ..." } else { "" };
    let first = members.first().map(|StrayedMember { member, what }| format!("; member {member}: {what}"));
    format!(
        "{} exceeded the bound on their energy, or diverged ({}{more}); the others continued{}",
        count_of(members.len()),
        named.join(", "),
        first.unwrap_or_default()
    )
}

fn lost_text(members: &[LostMember]) -> String {
    let named: Vec<String> = members
        .iter()
        .take(SHOWN)
        .map(|LostMember { member, step, time }| format!("{member} in step {step} (t = {time})"))
        .collect();
    let more = members.len().saturating_sub(SHOWN);
    let more = if more == 0 { String::new() } else { format!(" and {more} more") };
    format!(
        "{} diverged: {}{more}\nhelp: use a smaller step\nnote: they stay at their last finite state",
        count_of(members.len()),
        named.join(", "),
    )
}

/// The outcome of the work of a rank, as sent to the others.
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

/// Returns the result of this rank if all ranks succeeded, and otherwise the same error on all ranks.
///
/// Every rank has to call it.
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
