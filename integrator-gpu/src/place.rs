//! The place of active members: a device, or the program that replaces it.

use crate::{
    cuda,
    error::Error,
    host::{self, Memory},
    launch::Launch,
};
use std::{
    env, fs,
    path::{Path, PathBuf},
    sync::atomic::{AtomicUsize, Ordering},
};

/// What takes the steps.
pub(crate) enum Place {
    Cuda(Box<cuda::Members>),
    /// The text as a program of this machine, what it works on, and the number of the precision in it.
    Text(PathBuf, Box<Memory>, u64),
}

impl Place {
    /// The device of a number.
    ///
    /// # Errors
    /// As [`cuda::Members::new`].
    pub(crate) fn device(ordinal: usize, text: &str, precision: &str, memory: &Memory) -> Result<Self, Error> {
        Ok(Self::Cuda(Box::new(cuda::Members::new(ordinal, text, precision, memory)?)))
    }

    /// The program of one system, in a folder of its own.
    ///
    /// # Errors
    /// [`Error::Program`]
    pub(crate) fn program(text: &str, fingerprint: u64, precision: &str, memory: Memory) -> Result<Self, Error> {
        let failed = |error: std::io::Error| Error::Program(error.to_string());
        let compiler = host::compiler()
            .ok_or_else(|| Error::Program("no C++ compiler is installed\nhelp: set `CXX`".to_owned()))?;
        // Several ensembles of one system may be made at a time.
        static MADE: AtomicUsize = AtomicUsize::new(0);
        let (process, number) = (std::process::id(), MADE.fetch_add(1, Ordering::Relaxed));
        let folder = env::temp_dir().join(format!("integrator-gpu-{fingerprint:016x}-{process}-{number}"));
        fs::create_dir_all(&folder).map_err(failed)?;
        let text = host::program(&[("one", text)], &host::serving(&["one"]));
        let program = host::compile(&compiler, &text, &folder).map_err(failed)?;
        let number = match precision {
            "f32" => 1,
            "compensated f64" => 2,
            _ => 0,
        };
        Ok(Self::Text(program, Box::new(memory), number))
    }

    /// Takes the steps of a launch, and returns one more than the last finite step of those that fail, or nothing if none
    /// was lost in them.
    ///
    /// # Errors
    /// [`Error::Call`] and [`Error::Program`]
    pub(crate) fn advance(&mut self, launch: &Launch) -> Result<Vec<u64>, Error> {
        match self {
            Self::Cuda(members) => members.advance(launch),
            Self::Text(program, memory, precision) => {
                **memory = ran(program, memory, *precision, launch)?;
                let anybody = memory.lost.last_mut().map(std::mem::take);
                Ok(if anybody == Some(0) { Vec::new() } else { memory.lost[..memory.lost.len() - 1].to_vec() })
            }
        }
    }

    /// The states with the current step completed.
    ///
    /// # Errors
    /// [`Error::Call`]
    pub(crate) fn show(&mut self, launch: &Launch) -> Result<Vec<f64>, Error> {
        match self {
            Self::Cuda(members) => members.show(launch),
            Self::Text(program, memory, precision) => {
                Ok(ran(program, memory, *precision, &Launch { steps: 0, ..*launch })?.shown)
            }
        }
    }

    /// The states in the middle of the current step.
    ///
    /// # Errors
    /// [`Error::Call`]
    pub(crate) fn unfinished(&self) -> Result<Vec<f64>, Error> {
        match self {
            Self::Cuda(members) => members.unfinished(),
            Self::Text(_, memory, _) => Ok(memory.state.clone()),
        }
    }

    /// Continues from other states.
    ///
    /// # Errors
    /// [`Error::Call`]
    pub(crate) fn restart(&mut self, state: &[f64]) -> Result<(), Error> {
        match self {
            Self::Cuda(members) => members.restart(state),
            Self::Text(_, memory, _) => {
                memory.state = state.to_vec();
                Ok(())
            }
        }
    }

    /// Takes no more steps with those of whom `lost` is not zero.
    ///
    /// # Errors
    /// [`Error::Call`]
    pub(crate) fn hold(&mut self, lost: &[u64]) -> Result<(), Error> {
        match self {
            Self::Cuda(members) => members.hold(lost),
            Self::Text(_, memory, _) => {
                memory.lost[..lost.len()].copy_from_slice(lost);
                Ok(())
            }
        }
    }
}

/// What a launch of the program leaves of this.
fn ran(program: &Path, memory: &Memory, precision: u64, launch: &Launch) -> Result<Memory, Error> {
    let mut jobs = [(precision, *launch, memory.clone())];
    Memory::run(program, &mut jobs).map_err(|error| Error::Program(error.to_string()))?;
    let [(_, _, ran)] = jobs;
    Ok(ran)
}
