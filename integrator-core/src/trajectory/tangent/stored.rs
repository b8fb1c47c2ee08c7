//! Tangents as bytes: the checkpoint of a run, followed by the vectors in the middle of the current step.
//!
//! ```text
//! magic (8 bytes) | version (2 bytes) | vectors | CRC-64 of all before (8 bytes)
//! ```

use super::{Beginning, Tangent, refused};
use crate::{
    state::{coords::Coords, phase::Phase},
    system::System,
    trajectory::{
        checkpoint::{CheckpointError, coordinates, numbers, record_of, sealed_record},
        method::Memoryless,
        run::Run,
        sensitive::{Sensitive, slopes_of},
    },
};
use alloc::{string::ToString, vec::Vec};
use core::ops::Range;
use serde::{Deserialize, Serialize};

/// The first bytes of every checkpoint of a tangent.
const MAGIC: [u8; 8] = *b"sympltan";

/// The version of the format.
const VERSION: u16 = 2;

/// The record of a tangent.
#[derive(Serialize, Deserialize)]
struct Record {
    /// The checkpoint of its first run.
    run: Vec<u8>,
    /// The number of vectors along parameters, after the others.
    parameters: usize,
    /// Positions and momenta of each vector.
    vectors: Vec<[Vec<f64>; 2]>,
    exponents: Vec<i64>,
}

impl<C: Coords> Tangent<C> {
    /// Saves state and vectors as bytes, from which [`Tangent::resume`] continues bitwise, like [`Run::checkpoint`].
    pub fn checkpoint(&self) -> Vec<u8> {
        let vectors = (0..self.exponents.len()).map(|vector| {
            let (run, lane) = self.place(vector);
            let Phase { q, p } = run.unfinished_lane(lane);
            [numbers(&q), numbers(&p)]
        });
        let record = Record {
            run: self.runs[0].checkpoint(),
            parameters: self.parameters,
            vectors: vectors.collect(),
            exponents: self.exponents.clone(),
        };
        sealed_record(MAGIC, VERSION, &record)
    }

    /// The tangent that a checkpoint was made of, with the method that it was begun with: a composition or an implicit
    /// one.
    ///
    /// # Errors
    /// As [`Run::resume_with`]; a checkpoint of a run without vectors, or with derivatives by parameters, which
    /// [`Tangent::resume_sensitivities`] continues with.
    pub fn resume<H, X>(system: &H, method: X, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: System,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::resumed::<H, X, false>(system, method, checkpoint, 0, |_, _, _| Vec::new())
    }

    /// Resumes a run with derivatives by the parameters that the system names.
    ///
    /// # Errors
    /// As [`Tangent::resume`]; derivatives by more or fewer parameters.
    pub fn resume_sensitivities<H, X>(system: &H, method: X, checkpoint: &[u8]) -> Result<Self, CheckpointError>
    where
        H: Sensitive,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let slopes = |length, first, vectors| slopes_of(system, length, first, vectors);
        Self::resumed::<H, X, true>(system, method, checkpoint, H::SENSITIVE.len(), slopes)
    }

    fn resumed<H, X, const SENSITIVE: bool>(
        system: &H,
        method: X,
        checkpoint: &[u8],
        parameters: usize,
        slopes: impl Fn(usize, usize, Range<usize>) -> Vec<H::Parameters<f64>>,
    ) -> Result<Self, CheckpointError>
    where
        H: System,
        X: Memoryless<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let record: Record = record_of(MAGIC, VERSION, checkpoint)?;
        let run = Run::<C>::resume_with(system, method, &record.run)?;
        if record.parameters != parameters {
            let [stored, asked] = [record.parameters, parameters].map(|parameters| parameters.to_string());
            return Err(CheckpointError::Other { what: "number of parameters", stored, asked });
        }
        let unfinished = run.unfinished();
        let like = [&unfinished.q, &unfinished.p].map(|half| half.flat().len());
        let vector = |[q, p]: &[Vec<f64>; 2]| {
            let vector = Phase { q: coordinates::<C>(q)?, p: coordinates::<C>(p)? };
            ([&vector.q, &vector.p].map(|half| half.flat().len()) == like).then_some(vector)
        };
        let vectors: Option<Vec<_>> = record.vectors.iter().map(vector).collect();
        let vectors = vectors.filter(|vectors| !vectors.is_empty() && vectors.len() == record.exponents.len());
        let vectors = vectors.ok_or(CheckpointError::Damaged)?;
        let first = vectors.len().checked_sub(parameters).ok_or(CheckpointError::Damaged)?;
        refused::<H, C::Leaf>(&unfinished)?;
        let slopes = |of: Range<usize>| slopes(unfinished.q.length(), first, of);
        let at = (run.clock, run.opened);
        let beginning = Beginning { start: unfinished.clone(), vectors, parameters, h: run.step(), at: Some(at) };
        let mut tangent = Self::begin::<H, X, C::Leaf, SENSITIVE>(system, method, beginning, slopes)?;
        tangent.exponents = record.exponents;
        Ok(tangent)
    }
}
