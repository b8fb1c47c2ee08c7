//! Checkpoints of lattices, in the format of a run of all sites, which can be resumed on any number of ranks or by a
//! single run.

use crate::{
    ROOT,
    error::{Error, Failure, agree},
    is_root,
    lattice::{
        Lattice,
        exchange::{count, put},
        failure, reach_of,
        slab::Slab,
        slab_of,
    },
    states::{receive_all, send_all},
};
use integrator_core::{
    __private::{Composition, began, go_on_from, numbers, positions_in, unfinished},
    Coords, Hamiltonian, Phase, Resumable, Run,
};
use mpi::traits::{Communicator, Root};
use std::{fs, path::Path};

impl<'w, W: Communicator, C: Coords> Lattice<'w, W, C> {
    /// Writes the checkpoint of a run of all sites to a file, as [`Run::checkpoint_to`] does. Collective.
    ///
    /// Rank 0 gathers all sites and needs the memory for them.
    ///
    /// # Errors
    /// [`Error::Rank`], if the file cannot be written; the previous one remains.
    pub fn checkpoint_to(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let written = self.on_root(&unfinished(&self.run)).map(|state| {
            let run = (self.run_of)(&self.all(), state.clone()).map_err(failure)?;
            let mut run = run.at_time(began(&self.run).0);
            go_on_from(&mut run, self.steps(), self.opened, &state);
            run.checkpoint_to(path.as_ref()).map_err(|error| Failure::Other(error.to_string()))
        });
        agree(self.world, written.transpose().map(drop))
    }

    /// Resumes a lattice from a checkpoint of a lattice, or of a [`Run`] of as many sites, on any number of ranks.
    /// Collective.
    ///
    /// The composition and `slab` must be those at its start; the starts that `slab` returns are ignored. Rank 0 reads
    /// the file and distributes the sites. Each site is bitwise identical to that of a lattice without interruption.
    ///
    /// # Errors
    /// [`Error::Rank`], for the reasons of [`Run::resume_with`] or if the file cannot be read, and those of
    /// [`Lattice::new`].
    pub fn resume<H, X>(
        world: &'w W,
        composition: X,
        sites: usize,
        slab: impl Fn(&[usize]) -> (H, Phase<C>) + 'w,
        path: impl AsRef<Path>,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Composition<H> + Resumable<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let of_rank = slab_of::<H, X, C>(world, sites)?;
        let read = || -> Result<Run<C>, Failure> {
            let at = |error: String| Failure::Other(format!("{}: {error}", path.as_ref().display()));
            let bytes = fs::read(path.as_ref()).map_err(|error| at(error.to_string()))?;
            // A system of more or fewer sites than the checkpoint might not have all of its lists.
            let found = positions_in(&bytes).map_err(|error| at(error.to_string()))?;
            if 2 * found != count::<C>(sites) {
                return Err(at(format!("this checkpoint is not of {sites} sites")));
            }
            let (system, _) = slab(&(0..sites).collect::<Vec<_>>());
            Run::resume_with(&system, composition, &bytes).map_err(|error| at(error.to_string()))
        };
        let whole = agree(world, is_root(world).then(read).transpose())?;
        let (mut times, mut steps) = ([0.0; 2], [0; 2]);
        if let Some(run) = &whole {
            let (t0, opened) = began(run);
            (times, steps) = ([t0, run.step()], [run.steps(), opened]);
        }
        let root = world.process_at_rank(ROOT);
        root.broadcast_into(&mut times[..]);
        root.broadcast_into(&mut steps[..]);
        let (system, mut state) = slab(&of_rank.indices());
        let all = 0..of_rank.indices().len();
        let numbers = match &whole {
            Some(run) => dealt::<H, X, C>(world, &unfinished(run), &of_rank)?,
            None => receive_all(&root, count::<C>(all.len())),
        };
        // A start of another length is refused below.
        if state.q.length() == all.len() {
            put(&mut state, all, &numbers);
        }
        let mut lattice =
            Self::begin(world, composition, times[1], of_rank, system, state.clone(), slab)?.at_time(times[0]);
        lattice.opened = steps[1];
        go_on_from(&mut lattice.run, steps[0], steps[1], &state);
        lattice.exchanged = (state, steps[0]);
        Ok(lattice)
    }
}

/// Sends the numbers of its slab to each other rank, and returns those of rank 0.
fn dealt<H, X, C>(world: &impl Communicator, state: &Phase<C>, own: &Slab) -> Result<Vec<f64>, Error>
where
    H: Hamiltonian,
    X: Composition<H>,
    C: Coords,
{
    let of = |slab: &Slab| -> Vec<f64> {
        let picked = |half: &C| {
            let leaves = slab
                .indices()
                .into_iter()
                .flat_map(|site| half.flat()[site * C::COMPONENTS..(site + 1) * C::COMPONENTS].iter().copied());
            C::from_flat(leaves.collect()).as_ref().map(numbers).unwrap_or_default()
        };
        [picked(&state.q), picked(&state.p)].concat()
    };
    for rank in 1..world.size() {
        let slab = Slab::of(reach_of::<H, X, C>()?, own.sites, rank as usize, world.size() as usize)?;
        send_all(&world.process_at_rank(rank), &of(&slab));
    }
    Ok(of(own))
}
