//! What can go wrong with a run.

/// Why a run could not start or go on. Displays what is wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The step is zero or not finite.
    #[error("the step h is {h}: it has to be finite and not zero (negative steps run backwards)")]
    Step {
        /// The step that was asked for.
        h: f64,
    },
    /// A coordinate of the start is not finite.
    #[error("the start is not finite: {coordinate}[{index}] is {value} (coordinates counted one after the other)")]
    Start {
        /// `q` or `p`.
        coordinate: &'static str,
        /// Which one, counted over the flattened coordinates.
        index: usize,
        /// What it is.
        value: f64,
    },
    /// Positions and momenta of a start whose size is known at run time differ in number.
    #[error("the start has {positions} positions but {momenta} momenta: every position needs its momentum")]
    Length {
        /// How many positions.
        positions: usize,
        /// How many momenta.
        momenta: usize,
    },
    /// The start time is not finite.
    #[error("the start time t0 is {time}: it has to be finite")]
    Time {
        /// The time that was asked for.
        time: f64,
    },
    /// Samples every 0 steps.
    #[error("samples(0) would stay at one point for ever: ask for a sample every 1 or more steps")]
    SampleInterval,
    /// The number of steps exceeds `u64::MAX`.
    #[error("{done} steps are done and {asked} more exceed the largest step count, {}", u64::MAX)]
    Steps {
        /// Steps done.
        done: u64,
        /// Steps asked for on top.
        asked: u64,
    },
    /// The state left the finite numbers.
    #[error(transparent)]
    Diverged(#[from] Divergence),
    /// An ensemble without members.
    #[error("an ensemble needs one member at least")]
    NoMembers,
    /// A member of an ensemble is refused.
    #[error("member {member}: {error}")]
    Member {
        /// Which member, counted from 0.
        member: usize,
        /// Why.
        error: Box<Error>,
    },
    /// Members of an ensemble left the finite numbers.
    #[error(transparent)]
    Lost(#[from] Lost),
}

/// Where a run left the finite numbers. The run itself stays at the last finite state.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the state after step {step} (t = {time}) is not finite; the last finite one is kept (q = {q:?}, p = {p:?}). \
     A smaller step, or a look at the forces there, helps"
)]
pub struct Divergence {
    /// The first step whose state is not finite.
    pub step: u64,
    /// The time at the end of that step.
    pub time: f64,
    /// The positions one step earlier, flattened.
    pub q: Vec<f64>,
    /// The momenta one step earlier, flattened.
    pub p: Vec<f64>,
}

/// Which members of an ensemble left the finite numbers. They stay at their last finite state; the others have gone on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.text())]
pub struct Lost {
    /// The members that were lost in these steps, in order, each with where it happened.
    pub members: Vec<(usize, Divergence)>,
}

impl Lost {
    fn text(&self) -> String {
        let first = self.members.first().map(|(member, divergence)| format!("; member {member}: {divergence}"));
        let names: Vec<String> = self.members.iter().take(8).map(|(member, _)| member.to_string()).collect();
        let more = if self.members.len() > names.len() { ", ..." } else { "" };
        format!(
            "{} members left the finite numbers (members {}{more}); the others went on{}",
            self.members.len(),
            names.join(", "),
            first.unwrap_or_default()
        )
    }
}
