//! Chaos indicators of many orbits, distributed over ranks.

use crate::{
    ROOT,
    ensemble::{share, share_of},
    error::{Error, Failure, agree},
    is_root,
    states::{receive_all, send_all},
};
pub use integrator_core::chaos::Indicator;
use integrator_core::{
    __private::{LaneScalars, Shaped},
    Hamiltonian, Memoryless, StartOf, chaos,
    check::CheckError,
};
use mpi::traits::Communicator;

/// Computes a chaos indicator of many orbits, as [`chaos::map`] of the core does. Collective.
///
/// `start` returns the start of the orbit with an index. Rank 0 returns the indicators of all orbits, in the order of
/// their indices; all other ranks return `None`. The arguments must be the same on every rank.
///
/// Orbits are distributed by their index, as in [`share`]. Each indicator is bitwise identical to that on one rank.
///
/// # Errors
/// - [`Error::Refused`]: a start is invalid for a run; the error names the first one.
/// - [`Error::Rank`]: there are too few steps.
#[allow(clippy::too_many_arguments, reason = "those of the core's `map`, the world, and how many orbits there are")]
pub fn map<H, X, K, S>(
    world: &impl Communicator,
    system: &H,
    method: X,
    orbits: usize,
    start: impl Fn(usize) -> S,
    h: f64,
    steps: u64,
    indicator: Indicator,
) -> Result<Option<Vec<f64>>, Error>
where
    H: Hamiltonian,
    X: Memoryless<H>,
    K: LaneScalars,
    S: StartOf<Shaped<H, K>, Leaf = K>,
{
    let of_rank = share(world, orbits);
    let first = of_rank.start;
    let own = chaos::map::<H, X, K>(system, method, of_rank.map(|i| start(i).into_phase()), h, steps, indicator);
    let own = agree(
        world,
        own.map_err(|error| match error {
            CheckError::Run(error) => Failure::Core { error, first },
            other => Failure::Other(other.to_string()),
        }),
    )?;
    if !is_root(world) {
        send_all(&world.process_at_rank(ROOT), &own);
        return Ok(None);
    }
    let mut all = own;
    for rank in 1..world.size() {
        let count = share_of(rank as usize, world.size() as usize, orbits).len();
        all.extend(receive_all::<f64>(&world.process_at_rank(rank), count));
    }
    Ok(Some(all))
}
