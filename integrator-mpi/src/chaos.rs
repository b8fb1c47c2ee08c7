//! Indicators of chaos of many orbits, dealt out to ranks.

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

/// An indicator of so many orbits, of which `start` gives the one of an index, as [`chaos::map`] of the core computes it: on
/// rank 0 those of all, in the order of their indices, and `None` on all other ranks. Collective, with the same arguments on
/// every rank.
///
/// Orbits are dealt out by their index, as [`share`] does. Each indicator has the bits that it has on one rank.
///
/// # Errors
/// [`Error::Refused`] naming the first start that no run would begin with; [`Error::Rank`] for too few steps.
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
