//! What may be wrong with a checkpoint.

use crate::error::{Error, debug_as_display};
use alloc::string::String;
#[cfg(feature = "std")]
use std::io;

debug_as_display!(CheckpointError);

/// Why a checkpoint could not be written or resumed.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The file could not be read or written.
    #[cfg(feature = "std")]
    #[error("the file of the checkpoint: {0}")]
    File(#[from] io::Error),
    /// These are not the bytes of a checkpoint.
    #[error("this is no checkpoint of what is to be resumed: it does not begin like one")]
    Foreign,
    /// A later version of the library wrote it.
    #[error(
        "this checkpoint has version {version} of its format, which is newer than this library: update integrator-core"
    )]
    Newer {
        /// The version of its format.
        version: u16,
    },
    /// An earlier version of the library wrote it.
    #[error("this checkpoint has version {version} of its format, which this library no longer reads: begin anew")]
    Older {
        /// The version of its format.
        version: u16,
    },
    /// Bytes are missing or have changed, or are of several ensembles.
    #[error("this checkpoint is damaged: its bytes do not fit together")]
    Damaged,
    /// It belongs to another system, composition or precision, or to a power with another exponent.
    #[error("this checkpoint was made with the {what} `{stored}`, not `{asked}`")]
    Other {
        /// `system`, `composition`, `precision` or `exponent`.
        what: &'static str,
        /// What the checkpoint names.
        stored: String,
        /// What it was to be resumed with.
        asked: String,
    },
    /// The composition has the stored name, but other stages.
    #[error(
        "`{composition}` has other stages than when this checkpoint was made: they were changed, or it is another one of this name"
    )]
    Stages {
        /// Its name, with what it is over.
        composition: String,
    },
    /// The system computes other flows or energies than then: its functions were changed, or the library was.
    #[error(
        "`{system}` has other formulas than when this checkpoint was made, or another version of the library wrote its flows: \
         if that is meant, `Run::resume_with_changed_parameters` goes on"
    )]
    Formulas {
        /// The name of its type.
        system: String,
    },
    /// The run is of two copies of the state, and a checkpoint holds the one that is shown.
    #[error(
        "`{system}` is split by `symmetric`: its runs carry a copy of the state, which is in no checkpoint, so that another \
         motion would go on from here. A run that begins at `state()` couples a new copy to it"
    )]
    Copies {
        /// The name of its type.
        system: String,
    },
    /// The parameters of the system have other values than then.
    #[error(
        "`{system}` has other parameters than when this checkpoint was made: if that is meant, \
         `Run::resume_with_changed_parameters` goes on"
    )]
    Parameters {
        /// The name of its type.
        system: String,
    },
    /// A method that generated code calls as it is reads a field whose values cannot be compared.
    #[error(
        "a `#[flow]` or a method with a stated derivative of `{system}` reads `{field}`, which is neither made of numbers nor \
         `Hash`, so that nothing tells whether it has changed: add `fn fingerprint(&self) -> u64` to the annotated impl, or \
         resume with `Run::resume_with_changed_parameters`"
    )]
    Incomparable {
        /// The name of its type.
        system: String,
        /// What the method reads, as it is written.
        field: &'static str,
    },
    /// There are more or fewer systems than members of the ensemble.
    #[error("this checkpoint has {stored} members, not {asked}: give the system of every member, lost ones included")]
    Members {
        /// How many members it has.
        stored: usize,
        /// How many were asked for.
        asked: usize,
    },
    /// The system of a member has other parameters than then, or that of all other formulas.
    #[error(
        "member {member}: `{system}` has other parameters or formulas than when this checkpoint was made, and an ensemble goes on \
         with those that it was begun with"
    )]
    Member {
        /// The number of the member.
        member: usize,
        /// The name of its type.
        system: String,
    },
    /// The state has another number of coordinates than the system.
    #[error("this checkpoint has {positions} positions and {momenta} momenta, which this system does not have")]
    Shape {
        /// How many positions.
        positions: usize,
        /// How many momenta.
        momenta: usize,
    },
    /// No run can go on from there.
    #[error(transparent)]
    Run(#[from] Error),
}
