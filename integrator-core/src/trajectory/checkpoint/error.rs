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
    #[error("the file of the checkpoint: {0}")]
    File(#[from] io::Error),
    /// The bytes are not a checkpoint.
    #[error("this is no checkpoint of what is to be resumed: it does not begin like one")]
    Foreign,
    /// The checkpoint has a later format than this version of the library.
    #[error(
        "this checkpoint has version {version} of its format, which is newer than this library: update integrator-core"
    )]
    Newer {
        /// The version of the format.
        version: u16,
    },
    /// The checkpoint has an earlier format than this version of the library.
    #[error("this checkpoint has version {version} of its format, which this library no longer reads: begin anew")]
    Older {
        /// The version of the format.
        version: u16,
    },
    /// Bytes are missing or were changed, or are from several ensembles.
    #[error("this checkpoint is damaged: its bytes do not fit together")]
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
        "`{composition}` has other stages than when this checkpoint was made: they were changed, or it is another one of this name"
    )]
    Stages {
        /// The name of the composition, including the composition that it wraps.
        composition: String,
    },
    /// The flows or energies of the system differ: its functions or the library changed.
    #[error(
        "`{system}` has other formulas than when this checkpoint was made, or another version of the library wrote its flows: \
         if that is meant, `Run::resume_with_changed_parameters` goes on"
    )]
    Formulas {
        /// The type name of the system.
        system: String,
    },
    /// The run evolves two copies of the state, and a checkpoint contains only one.
    #[error(
        "`{system}` is split by `symmetric`: its runs carry a copy of the state, which is in no checkpoint, so that another \
         motion would go on from here. A run that begins at `state()` couples a new copy to it"
    )]
    Copies {
        /// The type name of the system.
        system: String,
    },
    /// The parameters of the system differ from those in the checkpoint.
    #[error(
        "`{system}` has other parameters than when this checkpoint was made: if that is meant, \
         `Run::resume_with_changed_parameters` goes on"
    )]
    Parameters {
        /// The type name of the system.
        system: String,
    },
    /// A method that the generated code calls unchanged reads a field whose values cannot be compared.
    #[error(
        "a `#[flow]` or a method with a stated derivative of `{system}` reads `{field}`, which is neither made of numbers nor \
         `Hash`, so that nothing tells whether it has changed: add `fn fingerprint(&self) -> u64` to the annotated impl, or \
         resume with `Run::resume_with_changed_parameters`"
    )]
    Incomparable {
        /// The type name of the system.
        system: String,
        /// The expression that the method reads.
        field: &'static str,
    },
    /// The number of systems differs from the number of members of the ensemble.
    #[error("this checkpoint has {stored} members, not {asked}: give the system of every member, lost ones included")]
    Members {
        /// The number of members in the checkpoint.
        stored: usize,
        /// The number of systems.
        asked: usize,
    },
    /// The system of a member has other parameters than in the checkpoint, or the systems have other formulas.
    #[error(
        "member {member}: `{system}` has other parameters or formulas than when this checkpoint was made, and an ensemble goes on \
         with those that it was begun with"
    )]
    Member {
        /// The index of the member.
        member: usize,
        /// The type name of the system.
        system: String,
    },
    /// The state has another number of coordinates than the system.
    #[error("this checkpoint has {positions} positions and {momenta} momenta, which this system does not have")]
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
