//! Members as lines of CSV: one file per rank, a manifest that names them, and a joined file.

use crate::{
    Ensemble, Member,
    error::Error,
    parts::{Manifest, Part, name_of_manifest},
};
use integrator_core::{
    __private::{Precision, column_names, numbers},
    Coords,
};
use mpi::traits::Communicator;
use std::{
    fs::{self, File},
    io::{self, BufRead, BufReader, BufWriter, Write},
    path::{Path, PathBuf},
};

/// The ending of the names of files.
const KIND: &str = "csv";

/// The reason why files were not joined.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// A file cannot be read or written.
    #[error("{}: {error}", path.display())]
    File {
        /// The path of the file.
        path: PathBuf,
        /// The error of the operating system.
        error: io::Error,
    },
    /// The manifest was not written by [`Ensemble::write_csv`].
    #[error("{}: this is not a manifest of an ensemble: {error}", path.display())]
    Manifest {
        /// The path of the manifest.
        path: PathBuf,
        /// The error in the manifest.
        error: serde_json::Error,
    },
    /// A file has more or fewer members than the manifest lists.
    #[error("{}: {found} members, but the manifest says {expected}\nnote: the file is from another run, or incomplete", path.display())]
    Members {
        /// The path of the file.
        path: PathBuf,
        /// The number of members in the file.
        found: usize,
        /// The number of members in the manifest.
        expected: usize,
    },
}

/// The result of [`join`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joined {
    /// The number of joined files.
    pub files: usize,
    /// The number of members.
    pub members: usize,
}

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// Writes one CSV file per rank into `folder`, and then a manifest that names them. Collective.
    ///
    /// All ranks need access to `folder`. The columns are:
    ///
    /// - the index of the `member`, the number of its `steps`, its time `t`;
    /// - positions `q0`, `q1` and so on (`q0_2` is the third component of the first point), and momenta likewise;
    /// - its `energy`.
    ///
    /// Each number has the shortest representation that reads back exactly. A compensated coordinate has two numbers,
    /// one after the other.
    ///
    /// # Errors
    /// [`Error::Rank`], if a file cannot be written; the manifest of an earlier call remains.
    pub fn write_csv(&self, folder: impl AsRef<Path>) -> Result<(), Error> {
        self.write_parts(folder.as_ref(), KIND, |path| self.write_members(path))
    }

    /// The members of this rank as a file.
    fn write_members(&self, path: &Path) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(BufWriter::new(File::create(path)?));
        for member in self.members_of_rank() {
            if member.index == self.of_rank().start {
                writer.write_record(header(&member.state.q))?;
            }
            writer.write_record(row(&member))?;
        }
        writer.flush()
    }
}

/// The names of all columns.
fn header<C: Coords>(like: &C) -> Vec<String> {
    let each = |letter| {
        column_names::<C>(letter, like.flat().len()).flat_map(|name| {
            let carried = (C::Leaf::PARTS > 1).then(|| format!("{name}_carried"));
            [Some(name), carried].into_iter().flatten()
        })
    };
    let first = ["member", "steps", "t"].map(String::from);
    first.into_iter().chain(each('q')).chain(each('p')).chain(["energy".into()]).collect()
}

/// A member in these columns.
fn row<C: Coords>(member: &Member<C>) -> Vec<String> {
    let counts = [member.index.to_string(), member.steps.to_string()];
    let numbers = [member.time].into_iter().chain(numbers(&member.state.q)).chain(numbers(&member.state.p));
    // As `Debug` shows them, numbers are as short as possible, and with an exponent where that is shorter.
    counts.into_iter().chain(numbers.chain([member.energy()]).map(|number| format!("{number:?}"))).collect()
}

/// Joins the files that [`Ensemble::write_csv`] wrote into a folder, with one header line. Needs no ranks.
///
/// The command `join FOLDER FILE` of this package does the same.
///
/// # Errors
/// [`OutputError`], if the folder has no manifest, a file is missing, or a file has another number of members than the
/// manifest lists. The incomplete output remains.
pub fn join(folder: impl AsRef<Path>, to: impl AsRef<Path>) -> Result<Joined, OutputError> {
    let (folder, to) = (folder.as_ref(), to.as_ref());
    let at = |path: &Path| {
        let path = path.to_owned();
        move |error| OutputError::File { path, error }
    };
    let path = folder.join(name_of_manifest(KIND));
    let text = fs::read(&path).map_err(at(&path))?;
    let manifest: Manifest = serde_json::from_slice(&text).map_err(|error| OutputError::Manifest { path, error })?;
    let mut joined = BufWriter::new(File::create(to).map_err(at(to))?);
    let mut named = false;
    for Part { name, members, .. } in &manifest.files {
        let path = folder.join(name);
        let lines = BufReader::new(File::open(&path).map_err(at(&path))?).lines();
        let mut found = 0;
        for (number, line) in lines.enumerate() {
            let line = line.map_err(at(&path))?;
            // The first line of each file names the columns.
            if number > 0 || !named {
                writeln!(joined, "{line}").map_err(at(to))?;
                named = true;
            }
            found += usize::from(number > 0);
        }
        if found != *members {
            return Err(OutputError::Members { path, found, expected: *members });
        }
    }
    joined.flush().map_err(at(to))?;
    Ok(Joined { files: manifest.files.len(), members: manifest.members })
}
