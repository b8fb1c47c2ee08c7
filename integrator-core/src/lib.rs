//! Symplectic splitting integrators, generated from your Hamiltonian at compile time.
//!
//! You write `H = T(p) + V(q)` as two Rust functions. [`#[hamiltonian]`](macro@hamiltonian) differentiates them and
//! generates the exact flows of both parts. A composition, such as [`Verlet`] or [`Yoshida4`], combines these flows into
//! a step. A [`Run`] integrates one trajectory.
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
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | Write a Hamiltonian | [`#[hamiltonian]`](macro@hamiltonian) |
//! | Set the initial state and the precision | [`Phase`] |
//! | Start from orbital elements | [`orbit`] |
//! | Integrate a trajectory | [`Hamiltonian::run`], [`Run::advance`], [`Run::advance_to`] |
//! | Choose a composition, or declare one | [structs](#structs) and their [`Scheme`], [`choose`], [`composition!`] |
//! | Read states at regular times, write files | [`Run::samples`], [`Run::samples_at`], [`output`] |
//! | Find Poincaré sections and events | [`Run::crossings`], [`Run::on_crossing`] |
//! | Control the step size | [`Logarithmic`], [`Power`], [`Paced`] |
//! | Integrate many trajectories | [`Ensemble`] |
//! | Verify symplecticity, order and energy drift | [`certify`] |
//! | Measure chaos | [`chaos`], [`Hamiltonian::tangent`] |
//! | Compute gradients for a fit | [`Hamiltonian::gradient`] |
//!
//! Further items:
//!
//! - [`choose_among`] finds the fastest of several splittings, with its composition and step.
//! - [`GaussLegendre`] (orders 2 to 16, [`ImplicitMidpoint`] the lowest) and [`taylor::Taylor`] integrate a Hamiltonian without
//!   splitting it.
//! - [`checkpoint`] and [`resume`] save a run and continue it in another program.
//! - [`Error`] lists what can fail.
//! - [`InstructionSet`] is the instruction set that a run uses; the environment variable `INTEGRATOR_ISA` selects it.
//!
//! # Features
//!
//! - `std` (default): threads, ensembles, files, and the detection of instruction sets. Without `std`, steppers need an
//!   allocator and the feature `libm`, and use the instructions that every machine of the target has.
//! - `libm`: elementary functions without `std`.
//! - `check` (default): certificates and the modules `check` and [`chaos`]. Depends on `std` and nalgebra.
//! - `checkpoint`: saves runs as bytes or files. Depends on serde, postcard and crc.
//! - `frequencies`: frequency analysis of orbits in [`chaos`]. Depends on `check` and rustfft.
//! - `output`: writes samples as CSV and NPZ files. Depends on csv, npyz and zip.
//!
#![cfg_attr(feature = "check", doc = "[`certify`]: fn@check::certify")]
#![cfg_attr(not(feature = "check"), doc = "[`certify`]: #features")]
#![cfg_attr(feature = "check", doc = "[`choose`]: fn@check::choose")]
#![cfg_attr(not(feature = "check"), doc = "[`choose`]: #features")]
#![cfg_attr(feature = "check", doc = "[`choose_among`]: fn@check::choose_among")]
#![cfg_attr(not(feature = "check"), doc = "[`choose_among`]: #features")]
#![cfg_attr(feature = "check", doc = "[`chaos`]: mod@chaos")]
#![cfg_attr(not(feature = "check"), doc = "[`chaos`]: #features")]
#![cfg_attr(feature = "output", doc = "[`output`]: mod@output")]
#![cfg_attr(not(feature = "output"), doc = "[`output`]: #features")]
#![cfg_attr(feature = "checkpoint", doc = "[`checkpoint`]: Run::checkpoint")]
#![cfg_attr(not(feature = "checkpoint"), doc = "[`checkpoint`]: #features")]
#![cfg_attr(feature = "checkpoint", doc = "[`resume`]: Run::resume")]
#![cfg_attr(not(feature = "checkpoint"), doc = "[`resume`]: #features")]
#![cfg_attr(not(feature = "std"), doc = "[`Ensemble`]: #features")]
#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]
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
pub mod orbit;
#[cfg(feature = "output")]
pub mod output;
mod scalar;
mod state;
mod system;
mod threads;
mod trajectory;

pub use composition::catalogue::*;
pub use composition::inner_steps::WithInnerSteps;
pub use composition::visitor::{
    Visitor, visit_general, visit_many_parts, visit_nested, visit_pairs, visit_quadratic, visit_two_parts,
    visit_two_parts_quadratic,
};
pub use composition::{Class, Composition, Lead, Processor, Rows, Scheme, Stage, Stages};
#[cfg(feature = "std")]
pub use ensemble::Ensemble;
pub use error::{Divergence, Error, Lost, Misread, NotFinite, Unsolved, VectorFault};
pub use hamiltonian::Hamiltonian;
pub use integrator_macros::{composition, hamiltonian};
pub use methods::friction::{FrictionScheme, Letter, Metropolis, Metropolised, catalogue::*};
pub use methods::implicit::{GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, RatedField};
pub use methods::pace::{Logarithmic, Paced, Power, Rated, TimeTransformed};
pub use methods::taylor;
pub use methods::taylor::RecurrencesVisitor;
pub use scalar::elementary::Elementary;
pub use scalar::instruction_set::InstructionSet;
pub use state::compensated::Compensated;
pub use state::coords::Coords;
pub use state::fixed::Fixed;
pub use state::phase::{Phase, StartOf};
pub use system::counts::OwnSteps;
pub use system::dissipation::{Dissipation, WithFriction};
pub use system::flow_layout::Layouts;
pub use system::parameter_derivatives::ParameterDerivatives;
pub use system::{QuadraticKinetic, System};
#[cfg(feature = "checkpoint")]
pub use trajectory::checkpoint::CheckpointError;
pub use trajectory::crossings::{Crossings, Direction};
pub use trajectory::gradient::Gradient;
pub use trajectory::heat::EnergyBalance;
#[cfg(feature = "std")]
pub use trajectory::in_lanes::{InLanes, ResumableInLanes};
pub use trajectory::method::{Described, Differentiable, Facts, Memoryless, Method, Resumable};
#[cfg(feature = "std")]
pub use trajectory::progress::Progress;
pub use trajectory::run::Run;
pub use trajectory::samples::{ByRef, Sample, Samples, SamplesAt};
pub use trajectory::sensitive::Sensitive;
pub use trajectory::tangent::Tangent;

/// The programs of the README, of the pages in `docs` and of the documentation of the macros, which are tested here. Only
/// documentation tests read these files of the repository.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../../integrator-macros/src/hamiltonian.md")]
    mod hamiltonian {}
    #[doc = include_str!("../../integrator-macros/src/composition.md")]
    mod composition {}
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

/// The items that most programs use: `use integrator_core::prelude::*;`.
pub mod prelude {
    #[cfg(not(feature = "std"))]
    pub use crate::Elementary;
    #[cfg(feature = "std")]
    pub use crate::Ensemble;
    #[cfg(feature = "check")]
    pub use crate::check::{Certificate, certify};
    pub use crate::composition::catalogue::*;
    pub use crate::methods::friction::catalogue::*;
    // Constants such as `PARTS` and `SENSITIVE`.
    pub use crate::{
        Compensated, Composition, Crossings, Direction, Error, Fixed, GaussLegendre, GaussLegendre4, GaussLegendre6,
        Hamiltonian, ImplicitMidpoint, Logarithmic, Paced, Phase, Power, Run, Sample, Samples, SamplesAt, Scheme,
        Sensitive, composition, hamiltonian, taylor::Taylor,
    };
    pub use crate::{Metropolis as _, ParameterDerivatives as _, System as _};
}

/// The private API of generated code. Nothing here is stable.
pub mod __private {
    pub use crate::system::external::{External, OwnFlow, external, own_flow};
    pub use crate::{
        composition::{
            Class, Composition, Lead, Processor, Rows, Scheme, Stage, Stages, admits, admits_pairs,
            catalogue::Verlet,
            corrected_durations::corrections,
            inner_steps::{Nested, admits_inner, admits_nested, inner_steps},
            order_claim::claims_order,
            stage_rows::{push_inner_stages, push_stages, takes_whole_steps},
            visitor::{
                Visitor, visit_many_parts, visit_nested, visit_pairs, visit_quadratic, visit_two_parts,
                visit_two_parts_quadratic,
            },
        },
        error::{Error, NotFinite},
        flow::{
            doubled::Doubled,
            kepler::{Kepler, OfBody, shared::shared},
            quadratic::{Form, Quadratic, QuadraticPart},
        },
        hamiltonian::Hamiltonian,
        layout::{
            bodies::{
                jacobi::Jacobi,
                jacobi_map::{
                    JacobiConstants, are_masses, are_masses_of_kinetic, body_at, end_of_leader, leading_body,
                },
                many_rows::ManyRows,
                one_row::OneRow,
                pair_sums::{BodyConstants, ManyBody, OfBodies, Unpacked},
                part::{PartConstants, PartOfBodies},
            },
            lattice::{
                energy::{KineticEnergy, PotentialEnergy},
                stencil::{Drift, Kick, Stencil},
                window::Window,
            },
            lists::{Addend, Read, Term, Terms},
            loops::{Iteration, Loop, Near, apart, groups_apart},
            products::{add_multiples_of_rows, inner_products},
        },
        methods::{
            friction::{
                Damped, DampedOf, FrictionConstants, FrictionScheme, Letter, are_rates, catalogue::Baoab,
                facts_with_friction, steps_with_friction,
            },
            implicit::{BackwardEuler, ImplicitMidpoint, RatedField, TakesWhole},
            pace::{PlainMotion, Rated, TimeTransformed},
            taylor::{
                Recurrences, RecurrencesVisitor,
                edges::{Level, Watch},
                inverse_mass::InverseMass,
                iterations::{Iterations, Target, splat},
                line::{Bundle, Ends, Few, Line},
                series::{
                    COEFFICIENTS, bounded, div_by_order, half_power, next_record, power_at_zero, power_sum,
                    power_weight, power_weight_with, time_coefficients,
                },
                table::{Coefficients, Layout, Table, Wide},
            },
        },
        scalar::{
            dual::Dual,
            fma::Fused,
            real::{Kernel, Mask, Real},
            simd::{
                block::Block,
                pair::{Pair, pair, twice},
                row::Row,
            },
        },
        state::{
            clock::Clock,
            coords::Coords,
            digest::Digest,
            precision::{Precision, Slot},
        },
        system::{
            MovedBy, QuadraticKinetic, ReadBy, Shaped, StatedEnergy, System,
            by_value::by_value,
            classes::{ByClass, classes, numbers_of_values, padded},
            counts::Counts,
            device_text::{DeviceText, StageRow, push_constants, push_lists},
            dissipation::{Dissipation, Momenta, WithFriction},
            elements::Elements,
            entries::{distinct_pairs, entries, weights},
            equal_values::{Both, SmallInteger},
            extremes::{greatest, least},
            flows::Flows,
            inner_steps::InnerSteps,
            integers::{bound, bound_through, like, span, span_through, wrapped},
            least_length::{are_at_least, are_points},
            motion::{Motion, Moved, Plain, Prepared, Read as ReadOf, Solver, Solving, in_place},
            not_finite::{all_found, not_finite},
            pair_set::{Items, PairSet, Unlisted},
            parameter_derivatives::ParameterDerivatives,
            prepared::in_lanes,
            read_by_methods::{Compared, Field, Hashed, ReadByMethods, Unknown},
            shared_table::{SharedTable, table},
            sites::{Boundary, Flow, MovedSites, Sites, StencilRadii, columns},
        },
        trajectory::{
            in_lanes::{InLanes, ResumableInLanes},
            method::{Described, Differentiable, Facts, Memoryless, Method, Resumable},
            sensitive::Sensitive,
            step_functions::{Executor, StepFunctions},
        },
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

    /// Returns a list of `length` copies of an element.
    pub fn repeated<T: Clone>(length: usize, element: T) -> Vec<T> {
        alloc::vec![element; length]
    }
}
