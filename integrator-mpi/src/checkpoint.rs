//! Checkpoints of ensembles over ranks, which can be resumed on any number of ranks.

use crate::{
    Ensemble,
    ensemble::share,
    error::{Error, Failure, agree},
    held::Held,
    parts::{Manifest, Part, at, manifest},
};
use integrator_core::{
    __private::{LaneScalars, joined, part_of},
    Coords, Ensemble as Local, Hamiltonian, ResumableInLanes,
};
use mpi::traits::Communicator;
use std::{
    fs::{self, File},
    io::Write,
    ops::Range,
    path::Path,
};

/// The ending of the names of files.
const KIND: &str = "members";

impl<'w, W: Communicator, C: Coords> Ensemble<'w, W, C> {
    /// Writes a checkpoint of the ensemble into `folder`: one file per rank and a manifest. Collective.
    ///
    /// All ranks need access to `folder`. If the job is killed at any time, the folder contains either the previous
    /// checkpoint or this one, complete.
    ///
    /// # Errors
    /// [`Error::Rank`], if a file cannot be written; the previous checkpoint remains.
    pub fn checkpoint_to(&self, folder: impl AsRef<Path>) -> Result<(), Error> {
        self.write_parts(folder.as_ref(), KIND, |path| {
            let mut file = File::create(path)?;
            file.write_all(&self.local().map(Local::checkpoint).unwrap_or_default())?;
            file.sync_all()
        })
    }

    /// Resumes an ensemble from a checkpoint, on any number of ranks. Collective.
    ///
    /// [`share`] distributes the members over the ranks. `system` returns the system of each member by its index among
    /// all members; it must be the system at the start of the ensemble. Each member is bitwise identical to one without
    /// interruption, for all numbers of ranks.
    ///
    /// # Errors
    /// [`Error::Rank`], if a file cannot be read, is damaged, or is for another system, method or precision, as in
    /// [`integrator_core::Ensemble::resume`].
    pub fn resume<H, X>(
        world: &'w W,
        method: X,
        system: impl Fn(usize) -> H,
        folder: impl AsRef<Path>,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: ResumableInLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let folder = folder.as_ref();
        let (found, own) = manifest_of(world, folder)?;
        let local = || {
            let Some(bytes) = bytes_of_rank(folder, &found, own.clone())? else { return Ok(None) };
            let local = Local::resume(method, own.clone().map(&system), &bytes);
            let numbered = |local: Local<C>| Some(Held::Processor(Box::new(local.numbered_from(own.start))));
            local.map(numbered).map_err(at(folder))
        };
        let local = agree(world, local())?;
        Ok(Self::of_held(world, local, own.start, found.members, found.steps))
    }
}

/// What a folder has a checkpoint of, and which of its members are dealt out to this rank. Collective.
pub(crate) fn manifest_of(world: &impl Communicator, folder: &Path) -> Result<(Manifest, Range<usize>), Error> {
    let found = agree(world, manifest(folder, KIND))?;
    let own = share(world, found.members);
    Ok((found, own))
}

/// The checkpoint of the members of a rank, if it has any.
pub(crate) fn bytes_of_rank(folder: &Path, found: &Manifest, own: Range<usize>) -> Result<Option<Vec<u8>>, Failure> {
    if own.is_empty() { Ok(None) } else { members_of_files(folder, &found.files, own).map(Some) }
}

/// The checkpoint of some members of all, from the files that have them.
fn members_of_files(folder: &Path, files: &[Part], members: Range<usize>) -> Result<Vec<u8>, Failure> {
    let mut parts = Vec::new();
    for Part { name, first, members: count } in files {
        let (from, to) = (members.start.max(*first), members.end.min(first + count));
        if from < to {
            let path = folder.join(name);
            let bytes = fs::read(&path).map_err(at(&path))?;
            let (whole, part) = part_of(&bytes, from - first..to - first).map_err(at(&path))?;
            if whole != *count {
                return Err(at(&path)(format!("{whole} members, but the manifest says {count}")));
            }
            parts.push(part);
        }
    }
    joined(&parts).map_err(at(folder))
}
