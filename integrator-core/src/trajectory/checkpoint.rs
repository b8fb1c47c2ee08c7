//! Runs on disk: everything that a run is, bit by bit, in a form that refuses whatever it is not.
//!
//! ```text
//! magic (8 bytes) | version (2 bytes) | record (postcard) | CRC-64 of all before (8 bytes)
//! ```
//!
//! Always true: what is stored is the unfinished state, in the middle of a step, so that a resumed run takes the very
//! steps of one that was never interrupted.

use crate::{
    composition::{Processor, Stage, Stages},
    error::{Error, debug_as_display},
    hamiltonian::Hamiltonian,
    state::{clock::Clock, coords::Coords, digest::Digest, phase::Phase, precision::Precision},
    system::motion::Prepared,
    trajectory::{
        admissible::admissible_with,
        method::{Facts, Memoryless},
        run::Run,
    },
};
use alloc::{borrow::ToOwned, string::String, vec::Vec};
use crc::{CRC_64_XZ, Crc};
use serde::{Deserialize, Serialize};
#[cfg(feature = "std")]
use std::{
    fs::{self, File},
    io::{self, Write},
    path::Path,
};

debug_as_display!(CheckpointError);

/// What every checkpoint begins with.
const MAGIC: [u8; 8] = *b"symplrun";

/// The form of the record; others are refused.
const VERSION: u16 = 2;

const CHECKSUM: Crc<u64> = Crc::<u64>::new(&CRC_64_XZ);

/// Why a checkpoint could not be written or resumed.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The file could not be read or written.
    #[cfg(feature = "std")]
    #[error("the file of the checkpoint: {0}")]
    File(#[from] io::Error),
    /// These are not the bytes of a checkpoint.
    #[error("this is no checkpoint of a run: it does not begin like one")]
    Foreign,
    /// A later version of the library wrote it.
    #[error(
        "this checkpoint has version {version} of the format, which is newer than {VERSION}: update integrator-core"
    )]
    Newer {
        /// The version of its format.
        version: u16,
    },
    /// An earlier version of the library wrote it.
    #[error("this checkpoint has version {version} of the format, and this library reads {VERSION} alone: begin anew")]
    Older {
        /// The version of its format.
        version: u16,
    },
    /// Bytes are missing or have changed.
    #[error("this checkpoint is damaged: its checksum does not match its bytes")]
    Damaged,
    /// It belongs to another system, composition or precision.
    #[error("this checkpoint was made with the {what} `{stored}`, not `{asked}`")]
    Other {
        /// `system`, `composition` or `precision`.
        what: &'static str,
        /// What the checkpoint names.
        stored: String,
        /// What it was to be resumed with.
        asked: String,
    },
    /// The composition has the stored name, but other stages.
    #[error("`{composition}` has other stages than when this checkpoint was made")]
    Stages {
        /// Its name.
        composition: String,
    },
    /// The system computes other flows or energies than then: its functions were changed, or the library was.
    #[error(
        "`{system}` has other formulas than when this checkpoint was made, or another version of the library wrote its flows: \
         if that is meant, `Run::resume_with_changed_parameters` goes on"
    )]
    Formulas {
        /// The name of its type.
        system: String,
    },
    /// The run is of two copies of the state, and a checkpoint holds the one that is shown.
    #[error(
        "`{system}` is split by `symmetric`: its runs carry a copy of the state, which is in no checkpoint, so that another \
         motion would go on from here. A run that begins at `state()` couples a new copy to it"
    )]
    Copies {
        /// The name of its type.
        system: String,
    },
    /// The parameters of the system have other values than then.
    #[error(
        "`{system}` has other parameters than when this checkpoint was made: if that is meant, \
         `Run::resume_with_changed_parameters` goes on"
    )]
    Parameters {
        /// The name of its type.
        system: String,
    },
    /// The state has another number of coordinates than the system.
    #[error("this checkpoint has {positions} positions and {momenta} momenta, which this system does not have")]
    Shape {
        /// How many positions.
        positions: usize,
        /// How many momenta.
        momenta: usize,
    },
    /// No run can go on from there.
    #[error(transparent)]
    Run(#[from] Error),
}

/// All there is to a run.
#[derive(Serialize, Deserialize)]
struct Record {
    system: String,
    /// Fingerprints of what was generated for the system, and of its prepared constants.
    formulas: u64,
    parameters: u64,
    composition: String,
    stages: u64,
    leaf: String,
    steps: u64,
    /// After how many of them the state was last changed from outside.
    opened: u64,
    h: f64,
    t0: f64,
    q: Vec<f64>,
    p: Vec<f64>,
}

/// What a run is called and made of, for its checkpoints.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    system: &'static str,
    formulas: u64,
    parameters: u64,
    composition: &'static str,
    /// Nothing for a method that is no composition; its runs cannot be resumed.
    table: Option<(Stages, Processor)>,
}

impl Origin {
    pub(crate) fn of<H: Hamiltonian>(Facts { name, table, .. }: Facts, parameters: &H::Parameters<f64>) -> Self {
        let mut digest = Digest::EMPTY;
        H::Parameters::<f64>::digest(parameters, &mut digest);
        Self {
            system: core::any::type_name::<H>(),
            formulas: H::FINGERPRINT,
            parameters: digest.value(),
            composition: name,
            table,
        }
    }
}

/// A number that tells the stages of compositions apart.
fn fingerprint(table: Option<&(Stages, Processor)>) -> u64 {
    let mut digest = CHECKSUM.digest();
    let rows = table.into_iter().flat_map(|(stages, processor)| {
        let ends = [stages.opening, stages.closing].into_iter();
        ends.chain(stages.cycle.iter().chain(processor.before.rows).chain(processor.after.rows).copied())
    });
    // What is between the first and the last part follows from these.
    for Stage { drift, kick, gradient, drift_time, kick_time, middle: _ } in rows {
        for number in [drift, kick, gradient, drift_time, kick_time] {
            digest.update(&number.to_bits().to_le_bytes());
        }
    }
    digest.finalize()
}

/// The numbers of some coordinates, one after the other.
fn numbers<C: Coords>(coordinates: &C) -> Vec<f64> {
    coordinates.flat().iter().flat_map(|leaf| leaf.parts().into_iter().take(C::Leaf::PARTS)).collect()
}

/// The coordinates that have these numbers, if their shape has so many.
fn coordinates<C: Coords>(numbers: &[f64]) -> Option<C> {
    let parts = C::Leaf::PARTS;
    let leaves =
        numbers.chunks(parts).map(|chunk| C::Leaf::from_parts(core::array::from_fn(|i| *chunk.get(i).unwrap_or(&0.0))));
    C::from_flat(leaves.collect()).filter(|_| numbers.len().is_multiple_of(parts))
}

impl<C: Coords> Run<C> {
    /// Everything that this run is, as bytes from which [`Run::resume`] goes on as if nothing had happened: bit for bit
    /// the same on one instruction set.
    ///
    /// The parameters of the system are not in it: a run is resumed with the system that it began with. A run by a method
    /// that is no composition is written all the same, but there is nothing to resume it with.
    pub fn checkpoint(&self) -> Vec<u8> {
        let Phase { q, p } = self.unfinished();
        let Clock { t0, h, steps } = self.clock;
        let record = Record {
            system: self.origin.system.to_owned(),
            formulas: self.origin.formulas,
            parameters: self.origin.parameters,
            composition: self.origin.composition.to_owned(),
            stages: fingerprint(self.origin.table.as_ref()),
            leaf: C::Leaf::NAME.to_owned(),
            steps,
            opened: self.opened,
            h,
            t0,
            q: numbers(&q),
            p: numbers(&p),
        };
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        // A record of numbers and names can always be written to memory.
        bytes.extend(postcard::to_allocvec(&record).unwrap_or_default());
        bytes.extend(CHECKSUM.checksum(&bytes).to_le_bytes());
        bytes
    }

    /// Writes [`Run::checkpoint`] to a file. Whenever the program is killed, the file is whole: it holds the previous
    /// checkpoint or this one. The bytes go to a file beside it first, with `.partial` at the end of its name, and are on
    /// the disk before that file takes the other's place.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    ///
    /// # let path = std::env::temp_dir().join(format!("oscillator-{}.run", std::process::id()));
    /// let mut run = Oscillator.run(Phase::new([1.0], [0.0]), 0.1)?;
    /// run.advance(1_000)?;
    /// run.checkpoint_to(&path)?;
    /// // Later, in another process:
    /// let mut resumed: Run<[f64; 1]> = Run::resume(&Oscillator, &std::fs::read(&path)?)?;
    /// resumed.advance(1_000)?;
    /// run.advance(1_000)?;
    /// assert_eq!(resumed.state(), run.state());
    /// # std::fs::remove_file(&path)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CheckpointError::File`] if a file cannot be written; the previous checkpoint is still there then.
    #[cfg(feature = "std")]
    pub fn checkpoint_to(&self, path: impl AsRef<Path>) -> Result<(), CheckpointError> {
        let path = path.as_ref();
        let mut partial = path.as_os_str().to_owned();
        partial.push(".partial");
        let mut file = File::create(&partial)?;
        file.write_all(&self.checkpoint())?;
        file.sync_all()?;
        fs::rename(&partial, path)?;
        // A name is on the disk once its folder is.
        #[cfg(unix)]
        if let Some(folder) = path.parent() {
            File::open(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })?.sync_all()?;
        }
        Ok(())
    }

    /// The run that a checkpoint was made of, with the annotated composition of its system.
    ///
    /// # Errors
    /// Bytes that are no checkpoint, damaged, or of another format; a checkpoint of another system (by the name of its type,
    /// the formulas of its energies and the values of its parameters), composition or precision; a state from which no run
    /// can go on. What a method with a stated derivative computes is not looked at.
    pub fn resume<H>(system: &H, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resume_with(system, H::Compose::default(), checkpoint)
    }

    /// The run that a checkpoint was made of, with the composition that it was begun with.
    ///
    /// # Errors
    /// As [`Run::resume`].
    pub fn resume_with<H, X>(system: &H, composition: X, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resumed(system, composition, checkpoint, false)
    }

    /// The run that a checkpoint was made of, with the annotated composition of its system, whatever the parameters and the
    /// formulas of the system are now: it goes on with those from the stored state. This one is in the middle of a step, so that
    /// where they differ the step under way is taken with both.
    ///
    /// # Errors
    /// As [`Run::resume`], but for the parameters and the formulas.
    pub fn resume_with_changed_parameters<H>(system: &H, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resume_with_changed_parameters_with(system, H::Compose::default(), checkpoint)
    }

    /// The same with the composition that the run was begun with.
    ///
    /// # Errors
    /// As [`Run::resume_with_changed_parameters`].
    pub fn resume_with_changed_parameters_with<H, X>(
        system: &H,
        composition: X,
        checkpoint: &[u8],
    ) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resumed(system, composition, checkpoint, true)
    }

    fn resumed<H, X>(system: &H, composition: X, checkpoint: &[u8], changed: bool) -> Result<Self, CheckpointError>
    where
        H: Hamiltonian,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let stored = record(checkpoint)?;
        if H::COPIES {
            return Err(CheckpointError::Copies { system: stored.system });
        }
        stored.belongs_to::<H, C::Leaf>(composition.facts())?;
        let Record { formulas, parameters, steps, opened, h, t0, q, p, .. } = stored;
        let shape = CheckpointError::Shape { positions: q.len(), momenta: p.len() };
        let (Some(q), Some(p)) = (coordinates(&q), coordinates(&p)) else { return Err(shape) };
        let unfinished = Phase { q, p };
        admissible_with::<H, _>(composition, &unfinished, h)?;
        let clock = Clock { t0, h, steps };
        let mut run = Self::from_unfinished::<H, X, C::Leaf>(system, composition, unfinished.clone(), clock, opened)?;
        run.resume_own(&unfinished);
        let name = || run.origin.system.to_owned();
        if !changed && formulas != run.origin.formulas {
            return Err(CheckpointError::Formulas { system: name() });
        }
        if !changed && parameters != run.origin.parameters {
            return Err(CheckpointError::Parameters { system: name() });
        }
        Ok(run)
    }
}

impl Record {
    /// Whether the names of a system, a method and a precision are those of this record, and the stages too.
    fn belongs_to<H: Hamiltonian, K: Precision>(&self, facts: Facts) -> Result<(), CheckpointError> {
        let asked = [
            ("system", &self.system, core::any::type_name::<H>()),
            ("composition", &self.composition, facts.name),
            ("precision", &self.leaf, K::NAME),
        ];
        for (what, stored, asked) in asked {
            if stored != asked {
                return Err(CheckpointError::Other { what, stored: stored.clone(), asked: asked.to_owned() });
            }
        }
        match self.stages == fingerprint(facts.table.as_ref()) {
            true => Ok(()),
            false => Err(CheckpointError::Stages { composition: facts.name.to_owned() }),
        }
    }
}

/// What the bytes of a checkpoint say.
fn record(checkpoint: &[u8]) -> Result<Record, CheckpointError> {
    let rest = checkpoint.strip_prefix(&MAGIC).ok_or(CheckpointError::Foreign)?;
    let (version, rest) = rest.split_first_chunk().ok_or(CheckpointError::Damaged)?;
    let version = u16::from_le_bytes(*version);
    if version > VERSION {
        return Err(CheckpointError::Newer { version });
    }
    if version < VERSION {
        return Err(CheckpointError::Older { version });
    }
    let (record, checksum) = rest.split_last_chunk().ok_or(CheckpointError::Damaged)?;
    let covered = &checkpoint[..checkpoint.len() - checksum.len()];
    if CHECKSUM.checksum(covered) != u64::from_le_bytes(*checksum) {
        return Err(CheckpointError::Damaged);
    }
    let record: Record = postcard::from_bytes(record).map_err(|_| CheckpointError::Damaged)?;
    if record.opened > record.steps { Err(CheckpointError::Damaged) } else { Ok(record) }
}
