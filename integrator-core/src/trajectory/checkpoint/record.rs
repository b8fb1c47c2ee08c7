//! The bytes of a checkpoint, and what they say.

use super::CheckpointError;
use crate::{
    composition::{Processor, Stage, Stages},
    state::precision::Precision,
    system::{System, motion::Beside},
    trajectory::{method::Facts, motions::Form},
};
use alloc::{borrow::ToOwned, format, string::String, vec::Vec};
use crc::{CRC_64_XZ, Crc};
use serde::{Deserialize, Serialize, de::DeserializeOwned};

/// The first bytes of every checkpoint.
const MAGIC: [u8; 8] = *b"symplrun";

/// The version of the format.
pub(super) const VERSION: u16 = 5;

/// The oldest form that is read. It does not name the composition that a method is over.
pub(super) const OLDEST: u16 = 2;

/// The oldest form that has the seed of random numbers.
const WITH_SEED: u16 = 5;

/// The oldest form that has states as they were given, where no step was taken since.
const AS_GIVEN: u16 = 4;

const CHECKSUM: Crc<u64> = Crc::<u64>::new(&CRC_64_XZ);

/// The contents of a checkpoint.
#[cfg_attr(test, derive(Debug, PartialEq))]
pub(crate) struct Stored {
    pub(crate) record: Record,
    /// The coordinates of its state.
    pub(super) form: Form,
    /// The composition that the method is over; empty where it is over none, and nothing where that is not known.
    pub(super) over: Option<String>,
    /// The seed of random numbers.
    pub(super) seed: u64,
    pub(super) own: Option<OwnTime>,
}

/// The record of a run, without the data beside its state.
#[derive(PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Record {
    pub(crate) system: String,
    /// Fingerprints of what was generated for the system, and of its prepared constants.
    pub(crate) formulas: u64,
    pub(crate) parameters: u64,
    pub(crate) composition: String,
    pub(crate) stages: u64,
    pub(crate) leaf: String,
    pub(crate) steps: u64,
    /// The number of steps after which the state was last changed from outside.
    pub(crate) opened: u64,
    pub(crate) h: f64,
    pub(crate) t0: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) p: Vec<f64>,
}

/// The data of a run beside its state, where the time is part of it.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(Debug, PartialEq))]
pub(super) struct OwnTime {
    pub(super) beside: Beside,
    /// The time when the state was last changed from outside.
    pub(super) opened_at: [f64; 2],
}

impl Stored {
    pub(super) fn new(record: Record, over: Option<String>, own: Option<OwnTime>) -> Self {
        // That there are no more of them than steps is looked at later.
        let form = Form::after(record.steps.saturating_sub(record.opened));
        Self { record, form, over, seed: 0, own }
    }

    /// Creates the stored form of a record that is no run's, with nothing beside states.
    #[cfg(feature = "std")]
    pub(crate) fn of_record(record: Record, over: String) -> Self {
        Self::new(record, Some(over), None)
    }

    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        // Records of numbers and names can always be written to memory.
        bytes.extend(postcard::to_allocvec(&self.record).unwrap_or_default());
        bytes.extend(postcard::to_allocvec(self.over.as_deref().unwrap_or_default()).unwrap_or_default());
        bytes.extend(postcard::to_allocvec(&self.seed).unwrap_or_default());
        if let Some(own) = &self.own {
            bytes.extend(postcard::to_allocvec(own).unwrap_or_default());
        }
        sealed(bytes)
    }

    /// Reads the bytes of a checkpoint.
    pub(crate) fn of_bytes(checkpoint: &[u8]) -> Result<Self, CheckpointError> {
        let (version, records) = unsealed(MAGIC, [OLDEST, VERSION], checkpoint)?;
        Self::of_records(version, records).filter(Self::is_whole).ok_or(CheckpointError::Damaged)
    }

    /// Reads the records of a version; `None` if a byte is left.
    fn of_records(version: u16, bytes: &[u8]) -> Option<Self> {
        let (record, rest) = postcard::take_from_bytes(bytes).ok()?;
        let (over, rest) = match version {
            OLDEST => (None, rest),
            _ => postcard::take_from_bytes(rest).map(|(over, rest)| (Some(over), rest)).ok()?,
        };
        let (seed, rest) = match version {
            WITH_SEED.. => postcard::take_from_bytes(rest).ok()?,
            _ => (0, rest),
        };
        let (own, rest) = match rest {
            [] => (None, rest),
            _ => postcard::take_from_bytes(rest).map(|(own, rest)| (Some(own), rest)).ok()?,
        };
        let mut stored = rest.is_empty().then(|| Self::new(record, over, own))?;
        stored.seed = seed;
        if version < AS_GIVEN {
            stored.form = Form::Own;
        }
        Some(stored)
    }

    /// Whether a run could have been so.
    fn is_whole(&self) -> bool {
        let Record { opened, steps, .. } = self.record;
        opened <= steps && self.own.as_ref().is_none_or(|own| own.beside.conjugate.is_some() == (opened < steps))
    }

    /// Checks that the names of a system, a method and a precision are those that are stored, and the stages too.
    pub(crate) fn belongs_to<H: System, K: Precision>(&self, facts: Facts) -> Result<(), CheckpointError> {
        let Record { system, composition, stages, leaf, .. } = &self.record;
        let over = facts.over.unwrap_or_default();
        let name = with_inner_steps(facts.name, facts.chosen_inner_steps);
        let asked = match self.over {
            Some(_) => named(&name, over),
            None => name,
        };
        let pairs = [
            ("system", system.clone(), core::any::type_name::<H>().to_owned()),
            ("composition", named(composition, self.over.as_deref().unwrap_or_default()), asked.clone()),
            ("precision", leaf.clone(), K::NAME.to_owned()),
        ];
        for (what, stored, asked) in pairs {
            if stored != asked {
                return Err(CheckpointError::Other { what, stored, asked });
            }
        }
        match *stages == fingerprint(facts.table.as_ref()) {
            true => Ok(()),
            false => Err(CheckpointError::Stages { composition: asked }),
        }
    }
}

/// A method as it is written, with the composition that it is over.
fn named(method: &str, over: &str) -> String {
    if over.is_empty() { method.to_owned() } else { format!("{method}({over})") }
}

/// The name of a composition with the number of inner steps that replaces that of the annotation: `Verlet.nested(4)`.
pub(super) fn with_inner_steps(composition: &str, steps: Option<u32>) -> String {
    match steps {
        Some(steps) => format!("{composition}.nested({steps})"),
        None => composition.to_owned(),
    }
}

/// A record of another kind, as bytes that begin like their kind and end in a checksum.
pub(crate) fn sealed_record(magic: [u8; 8], version: u16, record: &impl Serialize) -> Vec<u8> {
    let mut bytes = magic.to_vec();
    bytes.extend(version.to_le_bytes());
    // Records of numbers can always be written to memory.
    bytes.extend(postcard::to_allocvec(record).unwrap_or_default());
    sealed(bytes)
}

/// Reads a record from bytes of this kind.
pub(crate) fn record_of<T: DeserializeOwned>(magic: [u8; 8], newest: u16, bytes: &[u8]) -> Result<T, CheckpointError> {
    let (_, record) = unsealed(magic, [newest, newest], bytes)?;
    let (record, rest) = postcard::take_from_bytes(record).map_err(|_| CheckpointError::Damaged)?;
    if rest.is_empty() { Ok(record) } else { Err(CheckpointError::Damaged) }
}

/// The version of some bytes, between the oldest and the newest that are read, and what they hold.
fn unsealed(magic: [u8; 8], [oldest, newest]: [u16; 2], bytes: &[u8]) -> Result<(u16, &[u8]), CheckpointError> {
    let rest = bytes.strip_prefix(&magic).ok_or(CheckpointError::Foreign)?;
    let (version, rest) = rest.split_first_chunk().ok_or(CheckpointError::Damaged)?;
    let version = u16::from_le_bytes(*version);
    if version > newest {
        return Err(CheckpointError::Newer { version });
    }
    if version < oldest {
        return Err(CheckpointError::Older { version });
    }
    let (records, checksum) = rest.split_last_chunk().ok_or(CheckpointError::Damaged)?;
    let covered = &bytes[..bytes.len() - checksum.len()];
    if CHECKSUM.checksum(covered) != u64::from_le_bytes(*checksum) {
        return Err(CheckpointError::Damaged);
    }
    Ok((version, records))
}

/// Bytes with their checksum.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    bytes.extend(CHECKSUM.checksum(&bytes).to_le_bytes());
    bytes
}

/// A number that distinguishes the stages of compositions.
pub(super) fn fingerprint(table: Option<&(Stages, Processor)>) -> u64 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn stored(over: Option<&str>, is_timed: bool) -> Stored {
        let record = Record {
            system: "Comet".to_owned(),
            formulas: 1 << 60,
            parameters: 3,
            composition: "Power".to_owned(),
            stages: 4,
            leaf: "f64".to_owned(),
            steps: 300,
            opened: 300,
            h: 0.1,
            t0: -0.5,
            q: vec![1.0, 2.0],
            p: vec![3.0, 4.0],
        };
        let beside = || Beside { time: [1.0, 1e-20], conjugate: None, exponent: 0.5 };
        let own = is_timed.then(|| OwnTime { beside: beside(), opened_at: [1.0, 0.0] });
        Stored::new(record, over.map(ToOwned::to_owned), own)
    }

    /// Returns the bytes that the previous version wrote.
    fn without_the_name_of_what_it_is_over(stored: &Stored) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(OLDEST.to_le_bytes());
        bytes.extend(postcard::to_allocvec(&stored.record).expect("memory"));
        if let Some(own) = &stored.own {
            bytes.extend(postcard::to_allocvec(own).expect("memory"));
        }
        sealed(bytes)
    }

    #[test]
    fn current_and_earlier_formats_are_read() {
        for is_timed in [false, true] {
            let written = stored(Some(if is_timed { "Yoshida4" } else { "" }), is_timed);
            assert_eq!(Stored::of_bytes(&written.to_bytes()).expect("it was just written"), written);
            let earlier = without_the_name_of_what_it_is_over(&written);
            let expected = Stored { form: Form::Own, ..stored(None, is_timed) };
            assert_eq!(Stored::of_bytes(&earlier).expect("it was just written"), expected);
        }
        let mut first = without_the_name_of_what_it_is_over(&stored(None, false));
        first[8] = 1;
        assert!(matches!(Stored::of_bytes(&first), Err(CheckpointError::Older { version: 1 })));
    }

    #[test]
    fn a_method_is_printed_with_its_inner_method() {
        assert_eq!([named("Verlet", ""), named("Power", "Verlet")], ["Verlet", "Power(Verlet)"]);
    }
}
