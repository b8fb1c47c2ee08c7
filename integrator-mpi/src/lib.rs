//! Ensembles of Hamiltonian systems, and long lattices, over the ranks of MPI.
//!
//! Every rank has its members. `mpirun` or `srun` starts the ranks, which exchange messages by MPI. Each member is
//! bitwise identical to a run of its own, and sums over members are exact before they are rounded. Results hence do not
//! depend on the number of ranks.
//!
//! ```no_run
//! use integrator_core::prelude::*;
//! use integrator_mpi as cluster;
//!
//! struct Pendulum { length: f64 }
//!
//! #[hamiltonian(compose = Yoshida4)]
//! impl Pendulum {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.length.powi(2)) }
//!     fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
//! }
//!
//! let universe = cluster::start()?;
//! let world = universe.world();
//! let members = cluster::share(&world, 1_000_000)
//!     .map(|i| (Pendulum { length: 1.0 }, Phase::new([i as f64 * 3e-6], [0.0])));
//! let mut swarm = cluster::Ensemble::new(&world, Yoshida4, members, 0.01)?;
//! swarm.advance(10_000)?;
//! let angles = swarm.moments(|member| Some(member.state.q[0]));
//! if cluster::is_root(&world) {
//!     println!("{} +- {}", angles.mean, angles.standard_deviation());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! If one rank ends before the others, by a panic or because it was killed, the job ends and `mpirun` prints the
//! reason.

#[cfg(feature = "chaos")]
pub mod chaos;
mod checkpoint;
#[cfg(feature = "gpu")]
mod device;
mod ensemble;
mod error;
mod exact_sum;
mod held;
mod lattice;
mod output;
mod parts;
mod reductions;
mod states;

#[cfg(feature = "gpu")]
pub use device::Device;
use ensemble::share_of;
pub use ensemble::{Ensemble, Member, share};
pub use error::{Error, LostMember, StrayedMember};
pub use lattice::Lattice;
/// The MPI bindings whose communicators this crate accepts.
pub use mpi;
pub use output::{Joined, OutputError, join};
pub use reductions::{Histogram, Moments};

use mpi::{environment::Universe, traits::Communicator};

/// The error of [`start`]: MPI was started before by this process, or could not be started.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("MPI was started before in this process\nhelp: call `start` once, and keep its value as long as MPI is used")]
pub struct NotStarted;

/// A running MPI environment, which dereferences to the [`Universe`] with the communicator of all ranks.
///
/// If a rank panics, the job ends with an error of MPI; otherwise the other ranks would wait forever. They do wait
/// forever if `main` returns on one rank only, for example by `?` after an error of another crate. Errors of this crate
/// are the same on all ranks.
pub struct Started(Universe);

impl std::ops::Deref for Started {
    type Target = Universe;

    fn deref(&self) -> &Universe {
        &self.0
    }
}

impl Drop for Started {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.world().abort(1);
        }
    }
}

/// Starts MPI for this process. MPI ends when the returned value is dropped.
///
/// # Errors
/// [`NotStarted`], if it was started before.
pub fn start() -> Result<Started, NotStarted> {
    // Ensembles have threads, of which only this one calls MPI.
    let (universe, _) = mpi::initialize_with_threading(mpi::Threading::Funneled).ok_or(NotStarted)?;
    Ok(Started(universe))
}

/// The rank that has what is gathered.
pub(crate) const ROOT: i32 = 0;

/// Whether this rank is rank 0, which receives gathered data.
pub fn is_root(world: &impl Communicator) -> bool {
    world.rank() == ROOT
}
