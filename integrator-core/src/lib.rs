//! Symplectic splitting integrators whose steppers a macro writes.
#![deny(unsafe_code)]

extern crate self as integrator_core;

mod catalogue;
#[cfg(feature = "check")]
pub mod check;
mod composition;
mod coords;
mod error;
mod fused;
mod hamiltonian;
mod instruction_set;
mod phase;
mod real;
mod run;
mod samples;
mod slot;

pub use catalogue::*;
pub use composition::{Class, Composition, Scheme};
pub use coords::Coords;
pub use error::{Divergence, Error};
pub use hamiltonian::{Hamiltonian, QuadraticKinetic};
pub use instruction_set::InstructionSet;
pub use integrator_macros::{composition, hamiltonian};
pub use phase::Phase;
pub use run::Run;
pub use samples::{Sample, Samples};
pub use slot::Compensated;

/// What a user of the library brings into scope with one line.
pub mod prelude {
    pub use crate::catalogue::*;
    #[cfg(feature = "check")]
    pub use crate::check::{Certificate, certify};
    pub use crate::{
        Compensated, Composition, Error, Hamiltonian, Phase, Run, Sample, Samples, Scheme, composition, hamiltonian,
    };
}

/// The door through which generated code enters. Nothing here is stable.
#[doc(hidden)]
pub mod __private {
    pub use crate::{
        catalogue::Verlet,
        composition::{Class, Composition, Lead, Processor, Rows, Scheme, Stage, Stages},
        coords::Coords,
        fused::Fused,
        hamiltonian::{Flows, Hamiltonian, Motion, Plain, Prepared, QuadraticKinetic, Shaped},
        real::{Kernel, Mask, Real},
        slot::{Keep, Slot},
    };
    pub use std::vec::Vec;

    /// A table of prepared constants whose length is known at run time.
    pub fn table<T>(length: usize, element: impl FnMut(usize) -> T) -> Vec<T> {
        (0..length).map(element).collect()
    }
}
