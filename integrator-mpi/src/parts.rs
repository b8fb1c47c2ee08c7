//! Files that ranks write together: one per rank, and a manifest that names them.

use crate::{
    Ensemble, ROOT,
    error::{Error, Failure, agree},
    is_root,
};
use integrator_core::{__private::write_whole, Coords};
use mpi::traits::{Communicator, CommunicatorCollectives, Root};
use serde::{Deserialize, Serialize};
use std::{fs, io, path::Path};

/// The name of the file that says which others of a kind there are.
pub(crate) fn name_of_manifest(extension: &str) -> String {
    format!("{extension}.json")
}

/// What files there are, written once all of them are.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Manifest {
    /// The members of all files.
    pub(crate) members: usize,
    /// The steps that the ensemble had taken.
    pub(crate) steps: u64,
    /// How many manifests there were before this one.
    pub(crate) generation: u64,
    /// Its files, in the order of their members.
    pub(crate) files: Vec<Part>,
}

/// The file of a rank.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Part {
    pub(crate) name: String,
    pub(crate) first: usize,
    pub(crate) members: usize,
}

/// A failure at a file.
pub(crate) fn at<E: ToString>(path: &Path) -> impl Fn(E) -> Failure {
    move |error| Failure::Other(format!("{}: {}", path.display(), error.to_string()))
}

/// The manifest of the files of a kind.
pub(crate) fn manifest(folder: &Path, extension: &str) -> Result<Manifest, Failure> {
    let path = folder.join(name_of_manifest(extension));
    let text = fs::read(&path).map_err(at(&path))?;
    serde_json::from_slice(&text).map_err(at(&path))
}

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// Writes a file for each rank into `folder`, and then a manifest that names them. Collective.
    ///
    /// Names have a number that no manifest before had, and the manifest takes the place of the one before in one piece, so that
    /// at any moment the folder has a manifest whose files are whole: the old ones or the new ones. What only the old one names
    /// is removed.
    pub(crate) fn write_parts(
        &self,
        folder: &Path,
        extension: &str,
        write: impl FnOnce(&Path) -> io::Result<()>,
    ) -> Result<(), Error> {
        let world = self.world();
        let mut generation = manifest(folder, extension).map_or(0, |old| old.generation + 1);
        // What one rank has seen counts for all.
        world.process_at_rank(ROOT).broadcast_into(&mut generation);
        let name = |rank: i32| format!("{generation}-rank-{rank:05}.{extension}");
        let own = folder.join(name(world.rank()));
        let written = fs::create_dir_all(folder).map_err(at(folder)).and_then(|()| write(&own).map_err(at(&own)));
        agree(world, written)?;
        let mut counts = vec![0_u64; world.size() as usize];
        world.all_gather_into(&(self.of_rank().len() as u64), &mut counts[..]);
        let mut first = 0;
        let files = (0..).zip(counts).map(|(rank, members)| {
            let part = Part { name: name(rank), first, members: members as usize };
            first += part.members;
            part
        });
        let new = Manifest { members: self.len(), steps: self.steps(), generation, files: files.collect() };
        agree(world, if is_root(world) { replace(folder, extension, &new) } else { Ok(()) })
    }
}

/// Writes a manifest in the place of the one before, and removes the files that only that one names.
fn replace(folder: &Path, extension: &str, new: &Manifest) -> Result<(), Failure> {
    let old = manifest(folder, extension).ok();
    let path = folder.join(name_of_manifest(extension));
    let text = serde_json::to_vec_pretty(new).map_err(at(&path))?;
    write_whole(&path, &text).map_err(at(&path))?;
    for Part { name, .. } in old.iter().flat_map(|old| &old.files) {
        // A manifest that somebody else wrote may name anything.
        let is_ours = Path::new(name).file_name().is_some_and(|own| own == &**name) && name.contains("-rank-");
        if is_ours && new.files.iter().all(|file| file.name != *name) {
            let gone = folder.join(name);
            fs::remove_file(&gone).map_err(at(&gone))?;
        }
    }
    Ok(())
}
