//! Runs on disk: everything that a run is, bit by bit, in a form that refuses whatever it is not.
//!
//! ```text
//! magic (8 bytes) | version (2 bytes) | record | the composition that the method is over | CRC-64 of all before (8 bytes)
//! ```
//!
//! Records and names are in the form of postcard. Where the time is part of the state, another record follows: what a run has
//! beside positions and momenta.
//!
//! Always true: what is stored is the unfinished state, in the middle of a step, so that a resumed run takes the very
//! steps of one that was never interrupted; before the first step, it is the state that the user gave.

mod error;
mod record;

pub use error::CheckpointError;

use crate::{
    composition::{Processor, Stages},
    error::Error,
    state::{clock::Clock, coords::Coords, digest::Digest, phase::Phase, precision::Precision},
    system::{
        System,
        motion::{Beside, Prepared},
    },
    trajectory::{
        admissible::admissible_with,
        dispatch::{Nothing, bound},
        method::{Facts, Resumable},
        motions::Form,
        run::Run,
    },
};
use alloc::{borrow::ToOwned, string::ToString, vec::Vec};
#[cfg(feature = "std")]
pub(crate) use record::Record as RunRecord;
use record::Record;
pub(crate) use record::Stored;
use record::{OwnTime, fingerprint, with_inner_steps};
pub(crate) use record::{record_of, sealed_record};
#[cfg(feature = "std")]
use std::{
    fs::{self, File},
    io::{self, Write},
    path::Path,
};

/// The identity of a run in its checkpoints: names and fingerprints of system, parameters and method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    system: &'static str,
    formulas: u64,
    parameters: u64,
    /// A field that methods read whose value is in no fingerprint.
    unknown: Option<&'static str>,
    composition: &'static str,
    /// The composition that the method is over; empty where it is over none.
    over: &'static str,
    /// The stages of the composition; `None` for a method that is no composition, whose runs cannot be resumed.
    table: Option<(Stages, Processor)>,
    /// The number of inner steps that replaces that of the annotation.
    chosen_inner_steps: Option<u32>,
}

impl Origin {
    /// The origin of runs that are never written.
    pub(crate) const UNKNOWN: Self = Self {
        system: "",
        formulas: 0,
        parameters: 0,
        unknown: None,
        composition: "",
        over: "",
        table: None,
        chosen_inner_steps: None,
    };

    pub(crate) fn of<H: System>(
        Facts { name, over, table, chosen_inner_steps, .. }: Facts,
        parameters: &H::Parameters<f64>,
    ) -> Self {
        let mut digest = Digest::EMPTY;
        H::Parameters::<f64>::digest(parameters, &mut digest);
        Self {
            system: core::any::type_name::<H>(),
            formulas: H::FINGERPRINT,
            parameters: digest.value(),
            unknown: digest.unknown(),
            composition: name,
            over: over.unwrap_or_default(),
            table,
            chosen_inner_steps,
        }
    }

    /// Returns this origin with other prepared constants, by their fingerprint.
    #[cfg(feature = "std")]
    pub(crate) fn with_parameters(self, parameters: u64) -> Self {
        Self { parameters, ..self }
    }

    /// A fingerprint of the prepared constants.
    #[cfg(feature = "std")]
    pub(crate) fn parameters(&self) -> u64 {
        self.parameters
    }

    /// Refuses a system whose parameters cannot be compared with those of a checkpoint.
    pub(crate) fn hold_comparable(&self) -> Result<(), CheckpointError> {
        match self.unknown {
            Some(field) => Err(CheckpointError::Incomparable { system: self.system.to_owned(), field }),
            None => Ok(()),
        }
    }

    /// The composition that the method is over; empty where it is over none.
    #[cfg(feature = "std")]
    pub(crate) fn over(&self) -> &'static str {
        self.over
    }

    /// Returns the record of a run of this origin, without its state.
    pub(crate) fn record<K: Precision>(&self, Clock { t0, h, steps }: Clock, opened: u64) -> Record {
        Record {
            system: self.system.to_owned(),
            formulas: self.formulas,
            parameters: self.parameters,
            composition: with_inner_steps(self.composition, self.chosen_inner_steps),
            stages: fingerprint(self.table.as_ref()),
            leaf: K::NAME.to_owned(),
            steps,
            opened,
            h,
            t0,
            q: Vec::new(),
            p: Vec::new(),
        }
    }
}

/// Writes a file in the place of the one before, in one piece: at any moment there is the old one or the new one.
///
/// # Errors
/// The error of the operating system; the previous file is still there then.
#[cfg(feature = "std")]
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut partial = path.as_os_str().to_owned();
    partial.push(".partial");
    let mut file = File::create(&partial)?;
    file.write_all(bytes)?;
    file.sync_all()?;
    fs::rename(&partial, path)?;
    // A name is on the disk once its folder is. The file is in place also on file systems that cannot confirm this.
    #[cfg(unix)]
    if let Some(folder) = path.parent() {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
    }
    Ok(())
}

/// The numbers of some coordinates, one after the other.
pub fn numbers<C: Coords>(coordinates: &C) -> Vec<f64> {
    coordinates.flat().iter().flat_map(|leaf| leaf.parts().into_iter().take(C::Leaf::PARTS)).collect()
}

/// The coordinates that have these numbers, if their shape has this number of coordinates.
pub fn coordinates<C: Coords>(numbers: &[f64]) -> Option<C> {
    let parts = C::Leaf::PARTS;
    let leaves =
        numbers.chunks(parts).map(|chunk| C::Leaf::from_parts(core::array::from_fn(|i| *chunk.get(i).unwrap_or(&0.0))));
    C::from_flat(leaves.collect()).filter(|_| numbers.len().is_multiple_of(parts))
}

impl<C: Coords> Run<C> {
    /// Returns this run as bytes, from which [`Run::resume`] continues.
    ///
    /// A resumed run is bitwise identical on the same instruction set.
    ///
    /// - The parameters of the system are not saved; a run is resumed with its original system.
    /// - A run by [`Taylor`](crate::taylor::Taylor), or another method with memory, can be saved but not resumed.
    /// - After [`Run::advance_to`], the end of the last whole step is saved.
    pub fn checkpoint(&self) -> Vec<u8> {
        let Phase { q, p } = self.unfinished();
        let record = self.origin.record::<C::Leaf>(self.clock, self.opened);
        let record = Record { q: numbers(&q), p: numbers(&p), ..record };
        let over = Some(self.origin.over.to_owned());
        let own = self.engine.motions.beside().map(|beside| OwnTime { beside, opened_at: self.opened_at });
        Stored { seed: self.engine.motions.draws().seed, ..Stored::new(record, over, own) }.to_bytes()
    }

    /// Writes [`Run::checkpoint`] to a file, atomically.
    ///
    /// If the program is killed at any time, the file contains either the previous checkpoint or this one. The bytes are
    /// first written to disk in a file with the suffix `.partial`, which then replaces the file.
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
    /// [`CheckpointError::File`] if a file cannot be written. The previous checkpoint is kept.
    #[cfg(feature = "std")]
    pub fn checkpoint_to(&self, path: impl AsRef<Path>) -> Result<(), CheckpointError> {
        Ok(write_whole(path.as_ref(), &self.checkpoint())?)
    }

    /// Resumes a run from a checkpoint, with the composition or other method of the original run.
    ///
    /// # Errors
    /// Those of [`Run::resume`]; a checkpoint by [`Power`](crate::Power) with another exponent.
    pub fn resume_with<H, X>(system: &H, composition: X, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: System,
        X: Resumable<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resumed(system, composition, checkpoint, false)
    }

    /// Resumes a run from a checkpoint with changed parameters or formulas, and the method of the original run.
    ///
    /// If the fictitious time depends on the energy, as for [`Logarithmic`](crate::Logarithmic), the current step is completed
    /// and a new run starts from its end, because a changed system has another energy.
    ///
    /// # Errors
    /// Those of [`Run::resume_with_changed_parameters`].
    pub fn resume_with_changed_parameters_with<H, X>(
        system: &H,
        composition: X,
        checkpoint: &[u8],
    ) -> Result<Self, CheckpointError>
    where
        H: System,
        X: Resumable<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resumed(system, composition, checkpoint, true)
    }

    fn resumed<H, X>(system: &H, composition: X, checkpoint: &[u8], changed: bool) -> Result<Self, CheckpointError>
    where
        H: System,
        X: Resumable<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let stored = Stored::of_bytes(checkpoint)?;
        if H::COPIES {
            return Err(CheckpointError::Copies { system: stored.record.system });
        }
        stored.belongs_to::<H, C::Leaf>(composition.facts())?;
        let (form, seed) = (stored.form, stored.seed);
        let Stored { record: Record { formulas, parameters, steps, opened, h, t0, q, p, .. }, own, .. } = stored;
        let shape = CheckpointError::Shape { positions: q.len(), momenta: p.len() };
        let (Some(q), Some(p)) = (coordinates(&q), coordinates(&p)) else { return Err(shape) };
        let unfinished = Phase { q, p };
        admissible_with::<H, _>(composition, &unfinished, h)?;
        let clock = Clock { t0, h, steps };
        let mut run = Self::from_unfinished::<H, C::Leaf>(
            system,
            &bound::<H, X, C::Leaf, Nothing>(composition),
            unfinished.clone(),
            (&[], Vec::new()),
            clock,
            opened,
        )?;
        run.engine.change_draws(&|draws| draws.seed = seed);
        run.resume_stored(form, &unfinished, own)?;
        let name = || run.origin.system.to_owned();
        if !changed && formulas != run.origin.formulas {
            return Err(CheckpointError::Formulas { system: name() });
        }
        if !changed {
            run.origin.hold_comparable()?;
        }
        if !changed && parameters != run.origin.parameters {
            return Err(CheckpointError::Parameters { system: name() });
        }
        if (formulas, parameters) != (run.origin.formulas, run.origin.parameters) && run.time_in_state().is_some() {
            run.map_state(|_| {})?;
            run.check_time()?;
        }
        Ok(run)
    }

    /// Continues from a state in the middle of the current step, and from what the run had beside it.
    fn resume_stored(
        &mut self,
        form: Form,
        unfinished: &Phase<C>,
        own: Option<OwnTime>,
    ) -> Result<(), CheckpointError> {
        self.engine.resume(form, &[unfinished]);
        match (own, self.engine.motions.beside()) {
            (None, None) => Ok(()),
            (Some(OwnTime { beside, opened_at }), Some(Beside { exponent, .. })) => {
                if beside.exponent != exponent {
                    let [stored, asked] = [beside.exponent, exponent].map(|exponent| exponent.to_string());
                    return Err(CheckpointError::Other { what: "exponent", stored, asked });
                }
                self.engine.motions.put_beside(&beside);
                self.opened_at = opened_at;
                Ok(self.check_time()?)
            }
            _ => Err(CheckpointError::Damaged),
        }
    }

    /// Checks that the time of the run is finite.
    fn check_time(&self) -> Result<(), Error> {
        match self.time_at_step() {
            time if time.is_finite() => Ok(()),
            time => Err(Error::Time { time }),
        }
    }
}
