//! Errors of checkpoints.

use crate::error::{Error, debug_as_display};
use alloc::string::String;
#[cfg(feature = "std")]
use std::io;

debug_as_display!(CheckpointError);

/// The reason why a checkpoint could not be written or resumed.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The file could not be read or written.
    #[cfg(feature = "std")]
    #[error("the file of the checkpoint could not be read or written: {0}")]
    File(#[from] io::Error),
    /// The bytes are not a checkpoint.
    #[error("this is not a checkpoint of the kind that is to be resumed: its first bytes differ")]
    Foreign,
    /// The checkpoint has a later format than this version of the library.
    #[error(
        "this checkpoint has version {version} of its format, which is newer than this library\nhelp: update \
         integrator-core"
    )]
    Newer {
        /// The version of the format.
        version: u16,
    },
    /// The checkpoint has an earlier format than this version of the library.
    #[error(
        "this checkpoint has version {version} of its format, which this library does not read\nhelp: integrate again \
         from the start"
    )]
    Older {
        /// The version of the format.
        version: u16,
    },
    /// Bytes are missing or were changed, or are from several ensembles.
    #[error(
        "this checkpoint is damaged\nnote: bytes are missing or were changed, or its parts are of several ensembles"
    )]
    Damaged,
    /// The checkpoint is for another system, composition or precision, or for a power with another exponent.
    #[error("this checkpoint was made with the {what} `{stored}`, not `{asked}`")]
    Other {
        /// `system`, `composition`, `precision` or `exponent`.
        what: &'static str,
        /// The name in the checkpoint.
        stored: String,
        /// The name in the run that resumes.
        asked: String,
    },
    /// The composition has the stored name but different stages.
    #[error(
        "`{composition}` has other stages than in this checkpoint\nnote: its declaration was changed, or it is another \
         composition of this name"
    )]
    Stages {
        /// The name of the composition, including the composition that it wraps.
        composition: String,
    },
    /// The flows or energies of the system differ: its functions or the library changed.
    #[error(
        "`{system}` has other formulas than in this checkpoint, or another version of the library generated its \
         flows\nhelp: if this is intended, resume with `Run::resume_with_changed_parameters`"
    )]
    Formulas {
        /// The type name of the system.
        system: String,
    },
    /// The run evolves two copies of the state, and a checkpoint contains only one.
    #[error(
        "`{system}` is split by `symmetric`, and a checkpoint contains only one of the two copies of the state\nhelp: \
         start a run at `state()`, which couples a new copy to it"
    )]
    Copies {
        /// The type name of the system.
        system: String,
    },
    /// The parameters of the system differ from those in the checkpoint.
    #[error(
        "`{system}` has other parameters than in this checkpoint\nhelp: if this is intended, resume with \
         `Run::resume_with_changed_parameters`"
    )]
    Parameters {
        /// The type name of the system.
        system: String,
    },
    /// A method that the generated code calls unchanged reads a field whose values cannot be compared.
    #[error(
        "the checkpoint cannot tell whether `{field}` of `{system}` has changed\nhelp: add `fn fingerprint(&self) -> \
         u64` to the annotated impl, or resume with `Run::resume_with_changed_parameters`\nnote: a `#[flow]` or a method \
         with a stated derivative reads it, and it is neither made of numbers nor `Hash`"
    )]
    Incomparable {
        /// The type name of the system.
        system: String,
        /// The expression that the method reads.
        field: &'static str,
    },
    /// The number of systems differs from the number of members of the ensemble.
    #[error(
        "this checkpoint has {stored} members, not {asked}\nhelp: pass the system of every member, including failed ones"
    )]
    Members {
        /// The number of members in the checkpoint.
        stored: usize,
        /// The number of systems.
        asked: usize,
    },
    /// The system of a member has other parameters than in the checkpoint, or the systems have other formulas.
    #[error(
        "member {member}: `{system}` has other parameters or formulas than in this checkpoint\nnote: an ensemble resumes \
         with the systems that it started with"
    )]
    Member {
        /// The index of the member.
        member: usize,
        /// The type name of the system.
        system: String,
    },
    /// The state has another number of coordinates than the system.
    #[error("this checkpoint has {positions} positions and {momenta} momenta, but the system has another number")]
    Shape {
        /// The number of positions.
        positions: usize,
        /// The number of momenta.
        momenta: usize,
    },
    /// A run cannot resume from the state.
    #[error(transparent)]
    Run(#[from] Error),
}
