//! Ensembles as bytes: the common data of all members, followed by each of them, in the middle of the current step or,
//! before the first step, as it was given.
//!
//! ```text
//! magic (8 bytes) | version (2 bytes) | record | CRC-64 of all before (8 bytes)
//! ```

use crate::{
    ensemble::{Ensemble, batch::Finished, lane_scalars::LaneScalars, members::refusal},
    error::Error,
    state::{clock::Clock, coords::Coords, phase::Phase, point::shaped},
    system::System,
    trajectory::{
        checkpoint::{CheckpointError, RunRecord, Stored, coordinates, numbers, record_of, sealed_record},
        in_lanes::ResumableInLanes,
    },
};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The first bytes of every checkpoint of an ensemble.
const MAGIC: [u8; 8] = *b"symplens";

/// The version of the format.
const VERSION: u16 = 3;

/// The form without a seed, which is read as well.
const WITHOUT_SEED: u16 = 2;

/// The record of an ensemble.
#[derive(Serialize, Deserialize)]
struct Record {
    /// The record that all members share: that of a run, without its state.
    common: RunRecord,
    /// The composition that the method is over; empty where it is over none.
    over: String,
    members: Vec<Member>,
    /// The seed of random numbers.
    seed: u64,
}

/// A member.
#[derive(Serialize, Deserialize)]
struct Member {
    /// A fingerprint of its prepared constants.
    parameters: u64,
    /// The number of steps and the time at which it failed or finished, if it did.
    finished: Option<Finished>,
    q: Vec<f64>,
    p: Vec<f64>,
}

impl<C: Coords> Ensemble<C> {
    /// Returns this ensemble as bytes, from which [`Ensemble::resume`] continues.
    ///
    /// A resumed ensemble is bitwise identical on the same instruction set, for any number of threads.
    ///
    /// - The parameters of the systems are not saved.
    /// - After [`Ensemble::advance_to`], the end of the last step of all members is saved.
    /// - A checkpoint of methods such as [`Taylor`](crate::taylor::Taylor) or [`Logarithmic`](crate::Logarithmic) can be
    ///   written but not resumed ([`ResumableInLanes`] gives the reason). Start a new ensemble from the states at a time.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Rotor;
    ///
    /// #[hamiltonian]
    /// impl Rotor {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// }
    ///
    /// let members = (0..20).map(|i| (Rotor, Phase::new([0.0_f64], [f64::from(i)])));
    /// let mut rotors = Ensemble::new(Verlet, members, 0.01)?;
    /// rotors.advance(100)?;
    /// let bytes = rotors.checkpoint();
    /// // Later, in another process:
    /// let mut resumed: Ensemble<[f64; 1]> = Ensemble::resume(Verlet, (0..20).map(|_| Rotor), &bytes)?;
    /// resumed.advance(100)?;
    /// rotors.advance(100)?;
    /// assert!(resumed.states().eq(rotors.states()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn checkpoint(&self) -> Vec<u8> {
        let mut members = Vec::with_capacity(self.len());
        self.members.unfinished(&mut |finished, state| {
            let Phase { q, p } = shaped::<C>(state);
            members.push(Member { parameters: self.parameters[members.len()], finished, q: numbers(q), p: numbers(p) });
        });
        // Each member has its own parameters.
        let common =
            RunRecord { parameters: 0, ..self.origin.record::<C::Leaf>(self.members.clock, self.members.opened()) };
        sealed_record(
            MAGIC,
            VERSION,
            &Record { common, over: self.origin.over().to_owned(), members, seed: self.members.seed() },
        )
    }

    /// Resumes an ensemble from a checkpoint, with the method and the systems of the original ensemble.
    ///
    /// `systems` has one system for each member, including failed and finished members. The method is a composition or an
    /// implicit method.
    ///
    /// # Errors
    /// - Those of [`Run::resume_with`](crate::Run::resume_with).
    /// - The number of systems is not the number of members.
    /// - The system of a member has other parameters or formulas than in the original ensemble.
    ///
    /// Other methods are compile errors:
    ///
    /// ```compile_fail,E0277
    /// # use integrator_core::prelude::*;
    /// # struct Rotor;
    /// # #[hamiltonian(taylor)]
    /// # impl Rotor {
    /// #     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    /// #     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// # }
    /// # fn resume(bytes: &[u8]) {
    /// let rotors: Ensemble<[f64; 1]> = Ensemble::resume(Taylor::tolerance(1e-12), [Rotor], bytes).unwrap();
    /// # }
    /// ```
    ///
    /// For these methods, start a new ensemble from the states at a time:
    ///
    /// ```
    /// # use integrator_core::prelude::*;
    /// # struct Rotor;
    /// # #[hamiltonian(taylor)]
    /// # impl Rotor {
    /// #     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    /// #     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    /// # }
    /// let (method, h) = (Taylor::tolerance(1e-12), 0.5);
    /// let members = (0..20).map(|i| (Rotor, Phase::new([0.0_f64], [f64::from(i)])));
    /// let mut rotors = Ensemble::new(method, members, h)?;
    /// rotors.advance_to(3.2)?;
    /// let (time, states): (f64, Vec<_>) = (rotors.time(), rotors.states().collect());
    /// // Later, in another process:
    /// let members = states.into_iter().map(|state| (Rotor, state));
    /// let mut resumed = Ensemble::new(method, members, h)?.at_time(time);
    /// resumed.advance_to(10.0)?;
    /// rotors.advance_to(10.0)?;
    /// for (one, other) in resumed.states().zip(rotors.states()) {
    ///     assert!((one.p[0] - other.p[0]).abs() < 1e-9);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn resume<H, X>(
        method: X,
        systems: impl IntoIterator<Item = H>,
        checkpoint: &[u8],
    ) -> Result<Self, CheckpointError>
    where
        H: System,
        X: ResumableInLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let Record { common, over, members, seed } = record(checkpoint)?;
        let stored = Stored::of_record(common, over);
        if H::COPIES {
            return Err(CheckpointError::Copies { system: stored.record.system });
        }
        stored.belongs_to::<H, C::Leaf>(method.facts())?;
        let RunRecord { system, formulas, steps, opened, h, t0, .. } = stored.record;
        let systems: Vec<H> = systems.into_iter().collect();
        if systems.len() != members.len() {
            return Err(CheckpointError::Members { stored: members.len(), asked: systems.len() });
        }
        let mut states = Vec::with_capacity(members.len());
        for Member { q, p, .. } in &members {
            let shape = CheckpointError::Shape { positions: q.len(), momenta: p.len() };
            let (Some(q), Some(p)) = (coordinates::<C>(q), coordinates::<C>(p)) else { return Err(shape) };
            states.push(Phase { q, p });
        }
        let starts = systems.into_iter().zip(states.iter().cloned());
        let mut refused = Vec::new();
        let resumed = Self::from_starts::<H, X>(method, starts, h, false, &mut refused);
        if !refused.is_empty() {
            return Err(refusal(refused, members.len()).into());
        }
        let mut resumed = resumed?;
        resumed.origin.hold_comparable()?;
        for (member, (stored, asked)) in members.iter().zip(&resumed.parameters).enumerate() {
            if stored.parameters != *asked || formulas != H::FINGERPRINT {
                return Err(CheckpointError::Member { member, system });
            }
        }
        if opened > steps || members.iter().any(|member| member.finished.is_some_and(|at| at.steps > steps)) {
            return Err(CheckpointError::Damaged);
        }
        let clock = Clock { t0, h, steps };
        clock.end(0)?;
        resumed.members.resume(clock, opened, &|member| &states[member], &|member| members[member].finished);
        resumed.members.change_draws(&|draws| draws.seed = seed);
        Ok(resumed)
    }
}

/// Reads the record of an ensemble.
fn record(checkpoint: &[u8]) -> Result<Record, CheckpointError> {
    match record_of::<(RunRecord, String, Vec<Member>)>(MAGIC, WITHOUT_SEED, checkpoint) {
        Ok((common, over, members)) => Ok(Record { common, over, members, seed: 0 }),
        Err(CheckpointError::Newer { .. }) => record_of(MAGIC, VERSION, checkpoint),
        Err(error) => Err(error),
    }
}

/// Returns the number of members of a checkpoint, and the checkpoint of a range of them, counted from 0.
///
/// # Errors
/// As [`Ensemble::resume`]; members that the checkpoint does not have.
pub fn part_of(checkpoint: &[u8], of: Range<usize>) -> Result<(usize, Vec<u8>), CheckpointError> {
    let mut record = record(checkpoint)?;
    let (stored, asked) = (record.members.len(), of.end);
    record.members.truncate(of.end);
    if asked > stored || of.start > of.end {
        return Err(CheckpointError::Members { stored, asked });
    }
    record.members.drain(..of.start);
    Ok((stored, sealed_record(MAGIC, VERSION, &record)))
}

/// The checkpoint of the members of several, one after the other; those of ensembles that took the same steps.
///
/// # Errors
/// As [`Ensemble::resume`]; no checkpoint at all, and those that are not of one ensemble.
pub fn joined(checkpoints: &[Vec<u8>]) -> Result<Vec<u8>, CheckpointError> {
    let mut all: Option<Record> = None;
    for checkpoint in checkpoints {
        let mut record = record(checkpoint)?;
        match &mut all {
            None => all = Some(record),
            Some(all) if all.common == record.common && all.over == record.over && all.seed == record.seed => {
                all.members.append(&mut record.members);
            }
            Some(_) => return Err(CheckpointError::Damaged),
        }
    }
    let all = all.ok_or(CheckpointError::Run(Error::NoMembers))?;
    Ok(sealed_record(MAGIC, VERSION, &all))
}
