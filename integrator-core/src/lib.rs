//! Symplectic splitting integrators whose steppers a macro writes.
//!
//! A Hamiltonian `H = T(p) + V(q)` is written as two plain functions. [`#[hamiltonian]`](macro@hamiltonian)
//! differentiates them while the crate compiles and implements [`Hamiltonian`]; a composition says in which order and
//! for which fractions of a step the two parts move; a [`Run`] follows one trajectory.
//!
//! ```
//! use integrator_core::prelude::*;
//!
//! struct Pendulum {
//!     mass: f64,
//!     length: f64,
//!     gravity: f64,
//! }
//!
//! #[hamiltonian(compose = Yoshida4)]
//! impl Pendulum {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 {
//!         p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
//!     }
//!     fn potential(&self, q: [f64; 1]) -> f64 {
//!         -self.mass * self.gravity * self.length * q[0].cos()
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 9.81 };
//! let mut run = pendulum.run(Phase::new([2.0], [0.0]), 0.01)?;
//! let energy = run.energy();
//! run.advance(10_000)?;
//! assert_eq!(run.time(), 100.0);
//! assert!((run.energy() - energy).abs() < 1e-6);
//! # Ok(())
//! # }
//! ```
//!
//! # Where to look
//!
//! | for | see |
//! |---|---|
//! | what may stand in the two functions | [`#[hamiltonian]`](macro@hamiltonian) |
//! | which compositions there are | the structs below; [`Scheme`] for what is known of each |
//! | declaring a composition | [`composition!`] |
//! | where a run starts, and in which precision | [`Phase`] |
//! | what a run does and promises | [`Run`] |
//! | looking at a run from time to time | [`Run::samples`] |
//! | saving what is seen of a run | `output` (feature `output`) |
//! | Poincaré sections, the times of events | [`Run::crossings`] |
//! | what can go wrong | [`Error`] |
//! | a run that outlives its program | `Run::checkpoint`, `Run::resume` (feature `checkpoint`) |
//! | whether a stepper is what it claims to be | `check`, above all `certify` (feature `check`) |
//! | whether an orbit is chaotic, and how fast neighbours leave it | `chaos` (feature `check`), [`Hamiltonian::tangent`] |
//! | which composition is the cheapest, and with which step | `check::choose` (feature `check`) |
//! | which splitting is the fastest, with which composition | `check::choose_among` (feature `check`) |
//! | which machine code is run | [`InstructionSet`] |
//!
//! # Features
//!
//! `check`, on by default: the measurements behind certificates. It brings nalgebra; a program that only
//! steps turns it off and compiles neither.
//!
//! `std`, on by default: what takes an operating system. Without it, and with the feature `libm` for elementary
//! functions, steppers need an allocator alone; there are no ensembles, no threads and no files, and runs use what
//! every machine of the target has. `check` needs it.
//!
//! `reference`: methods that are no compositions, to compare with (module `reference`). It brings `check` and the crate
//! differential-equations.
//!
//! `checkpoint`: `Run::checkpoint` and `Run::resume`, runs as bytes and as files that survive a killed program. It
//! brings serde, postcard and crc.
//!
//! `output`: samples as CSV and as NPZ files. It brings csv, npyz and zip.
#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![deny(unsafe_code)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("elementary functions come from `std` or from `libm`: turn on one of these features");

extern crate alloc;
extern crate self as integrator_core;

#[cfg(feature = "check")]
pub mod chaos;
#[cfg(feature = "check")]
pub mod check;
mod composition;
#[cfg(feature = "std")]
mod ensemble;
mod error;
mod flow;
mod hamiltonian;
mod layout;
mod methods;
#[cfg(feature = "output")]
pub mod output;
mod scalar;
mod state;
mod system;
mod threads;
mod trajectory;

pub use composition::catalogue::*;
pub use composition::visitor::{
    Visitor, visit_general, visit_many_parts, visit_pairs, visit_quadratic, visit_two_parts, visit_two_parts_quadratic,
};
pub use composition::{Class, Composition, Lead, Processor, Rows, Scheme, Stage, Stages};
#[cfg(feature = "std")]
pub use ensemble::Ensemble;
#[cfg(feature = "std")]
pub use ensemble::in_lanes::{InLanes, ResumableInLanes};
pub use error::{Divergence, Error, Lost, Misread, NotFinite, Unsolved, VectorFault};
pub use hamiltonian::{Hamiltonian, QuadraticKinetic};
pub use integrator_macros::{composition, hamiltonian};
pub use methods::implicit::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
pub use methods::pace::{Logarithmic, Paced, Power, Rated, TimeTransformed};
#[cfg(feature = "reference")]
pub use methods::reference;
pub use methods::taylor;
pub use methods::taylor::RecurrencesVisitor;
#[cfg(not(feature = "std"))]
pub use scalar::elementary::Elementary;
pub use scalar::instruction_set::InstructionSet;
pub use state::compensated::Compensated;
pub use state::coords::Coords;
pub use state::fixed::Fixed;
pub use state::phase::{Phase, StartOf};
pub use system::counts::OwnSteps;
#[cfg(feature = "checkpoint")]
pub use trajectory::checkpoint::CheckpointError;
pub use trajectory::crossings::{Crossings, Direction};
pub use trajectory::method::{Described, Differentiable, Facts, Memoryless, Method, Resumable};
#[cfg(feature = "std")]
pub use trajectory::progress::Progress;
pub use trajectory::run::Run;
pub use trajectory::samples::{ByRef, Sample, Samples, SamplesAt};
pub use trajectory::sensitive::Sensitive;
pub use trajectory::tangent::Tangent;

/// The programs of the README and of the pages in `docs`, so that they compile and hold. These are files of the
/// repository alone: nothing but its documentation tests reads them.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../../README.md")]
    mod readme {}
    #[doc = include_str!("../../docs/compositions.md")]
    mod compositions {}
    #[doc = include_str!("../../docs/examples.md")]
    mod examples {}
    #[doc = include_str!("../../docs/promises.md")]
    mod promises {}
}

#[cfg(doctest)]
mod guide;

/// What a user of the library brings into scope with one line.
pub mod prelude {
    #[cfg(not(feature = "std"))]
    pub use crate::Elementary;
    #[cfg(feature = "std")]
    pub use crate::Ensemble;
    #[cfg(feature = "check")]
    pub use crate::check::{Certificate, certify};
    pub use crate::composition::catalogue::*;
    pub use crate::{
        Compensated, Composition, Crossings, Direction, Error, Fixed, GaussLegendre4, GaussLegendre6, Hamiltonian,
        ImplicitMidpoint, Logarithmic, Paced, Phase, Power, Run, Sample, Samples, SamplesAt, Scheme, Sensitive,
        composition, hamiltonian, taylor::Taylor,
    };
}

/// The private API of generated code. Nothing here is stable.
pub mod __private {
    pub use crate::system::external::{External, OwnFlow, external, own_flow};
    pub use crate::{
        composition::{
            Class, Composition, Lead, Processor, Rows, Scheme, Stage, Stages, admits, admits_pairs,
            catalogue::Verlet,
            corrected_durations::corrections,
            visitor::{
                Visitor, visit_many_parts, visit_pairs, visit_quadratic, visit_two_parts, visit_two_parts_quadratic,
            },
        },
        error::{Error, NotFinite},
        flow::{
            doubled::Doubled,
            kepler::{Kepler, OfBody},
            quadratic::{Form, Quadratic, QuadraticPart},
        },
        hamiltonian::{Flows, Hamiltonian, MovedBy, QuadraticKinetic, ReadBy, Shaped, StatedEnergy},
        layout::{
            bodies::{
                jacobi::Jacobi,
                jacobi_map::{
                    JacobiConstants, are_masses, are_masses_of_kinetic, body_at, end_of_leader, leading_body,
                },
                many_rows::ManyRows,
                one_row::OneRow,
                pair_sums::{BodyConstants, ManyBody},
            },
            lattice::{
                sites::{MovedSites, Sites},
                stencil::{Boundary, Drift, Kick, Stencil},
                time_tiling::{Flow, StencilRadii},
                window::Window,
            },
            lists::{Addend, Read, Term, Terms},
        },
        methods::implicit::{ImplicitMidpoint, TakesWhole},
        methods::pace::{NODES, PlainMotion, Rated, TimeTransformed},
        methods::taylor::{
            Recurrences, RecurrencesVisitor,
            edges::{Level, Watch},
            inverse_mass::InverseMass,
            iterations::{Iterations, Target, splat},
            line::{Bundle, Ends, Few, Line},
            series::{
                COEFFICIENTS, div_by_order, half_power, next_record, power_at_zero, power_sum, power_weight,
                power_weight_with, time_coefficients,
            },
            table::{Coefficients, Layout, Table, Wide},
        },
        scalar::{
            fma::Fused,
            real::{Kernel, Mask, Real},
            simd::{
                block::Block,
                pair::{Pair, pair, twice},
                row::Row,
            },
        },
        state::{
            coords::Coords,
            digest::Digest,
            precision::{Precision, Slot},
        },
        system::{
            by_value::by_value,
            device_text::{DeviceText, push_constants, push_lists},
            elements::Elements,
            integers::{bound, bound_through, like, span, span_through, wrapped},
            motion::{Motion, Plain, Prepared, Solver, Solving},
            not_finite::{all_found, not_finite},
            prepared::in_lanes,
            read_by_methods::{Compared, Field, Hashed, ReadByMethods, Unknown},
        },
        trajectory::sensitive::Sensitive,
    };
    pub use alloc::{sync::Arc, vec::Vec};
    // Other crates of this repository have ensembles of their own.
    #[cfg(feature = "std")]
    pub use crate::ensemble::lane_scalars::LaneScalars;
    #[cfg(any(all(feature = "checkpoint", feature = "std"), feature = "output"))]
    pub use crate::state::coords::column_names;
    #[cfg(all(feature = "checkpoint", feature = "std"))]
    pub use crate::{
        ensemble::{
            checkpoint::{joined, part_of},
            elsewhere::{
                Elsewhere, MemberElsewhere, begin, come_back, divergence, energy_in, leave, steps_before, under_way,
            },
        },
        trajectory::{
            checkpoint::{coordinates, numbers, write_whole},
            elsewhere::{began, go_on_from, positions_in, unfinished},
        },
    };

    /// A table of prepared constants whose length is known at run time.
    ///
    /// A function of its own for each `T` and not for each table: what is seldom called is compiled as seldom as
    /// possible.
    pub fn table<T>(length: usize, element: &dyn Fn(usize) -> T) -> Vec<T> {
        let mut table = Vec::with_capacity(length);
        for place in 0..length {
            table.push(element(place));
        }
        table
    }

    /// So many copies of an element.
    pub fn repeated<T: Clone>(length: usize, element: T) -> Vec<T> {
        alloc::vec![element; length]
    }
}
