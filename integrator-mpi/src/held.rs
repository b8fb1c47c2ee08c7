//! The members of a rank, on its processor or on a device.

use crate::error::Failure;
use integrator_core::{Coords, Ensemble as Local, Phase};
#[cfg(feature = "gpu")]
use integrator_gpu::{Ensemble as OnDevice, Error as DeviceError};

/// The members of a rank.
pub(crate) enum Held<C: Coords> {
    Processor(Box<Local<C>>),
    /// After each call, the processor has them where the device has them.
    #[cfg(feature = "gpu")]
    Device(Box<OnDevice<C>>),
}

impl<C: Coords> Held<C> {
    /// The members, to be looked at.
    pub(crate) fn shown(&self) -> &Local<C> {
        match self {
            Self::Processor(local) => local,
            #[cfg(feature = "gpu")]
            Self::Device(device) => device.last_on_processor(),
        }
    }

    /// Sets the seed of random numbers, which no method for devices draws.
    pub(crate) fn with_seed(self, seed: u64) -> Self {
        match self {
            Self::Processor(local) => Self::Processor(Box::new(local.with_seed(seed))),
            #[cfg(feature = "gpu")]
            Self::Device(device) => Self::Device(device),
        }
    }

    /// Starts the clock at `t0`.
    pub(crate) fn at_time(self, t0: f64) -> Self {
        match self {
            Self::Processor(local) => Self::Processor(Box::new(local.at_time(t0))),
            #[cfg(feature = "gpu")]
            Self::Device(device) => Self::Device(Box::new(device.at_time(t0))),
        }
    }

    /// Uses at most this number of threads.
    pub(crate) fn with_threads(self, threads: usize) -> Self {
        match self {
            Self::Processor(local) => Self::Processor(Box::new(local.with_threads(threads))),
            #[cfg(feature = "gpu")]
            Self::Device(device) => Self::Device(Box::new(device.with_threads(threads))),
        }
    }

    /// Watches the energies of the members, who are counted from `first` on.
    pub(crate) fn watch_energy(&mut self, bound: f64, first: usize) -> Result<(), Failure> {
        match self {
            Self::Processor(local) => local.watch_energy(bound).map_err(|error| Failure::Core { error, first }),
            #[cfg(feature = "gpu")]
            Self::Device(_) => Err(Failure::Other(
                "a device does not compute energies, so they cannot be watched\nhelp: integrate on the processor, with \
                 `Ensemble::new`, or use `advance_while`"
                    .to_owned(),
            )),
        }
    }

    /// Takes steps with those in progress, who are counted from `first` on.
    pub(crate) fn advance(&mut self, steps: u64, first: usize) -> Result<(), Failure> {
        match self {
            Self::Processor(local) => local.advance(steps).map_err(|error| Failure::Core { error, first }),
            #[cfg(feature = "gpu")]
            Self::Device(device) => {
                let outcome = device.advance(steps);
                brought(device, outcome, first)
            }
        }
    }

    /// As [`Held::advance`]; members that do not stay are finished.
    pub(crate) fn advance_while(
        &mut self,
        steps: u64,
        interval: u64,
        first: usize,
        stays: impl Fn(usize, &Phase<C>) -> bool + Sync,
    ) -> Result<(), Failure> {
        let stays = |member: usize, state: &Phase<C>| stays(first + member, state);
        match self {
            Self::Processor(local) => {
                local.advance_while(steps, interval, stays).map_err(|error| Failure::Core { error, first })
            }
            #[cfg(feature = "gpu")]
            Self::Device(device) => {
                let outcome = device.advance_while(steps, interval, stays);
                brought(device, outcome, first)
            }
        }
    }
}

/// What came of steps on a device, whose members the processor has then.
#[cfg(feature = "gpu")]
fn brought<C: Coords>(device: &mut OnDevice<C>, outcome: Result<(), DeviceError>, first: usize) -> Result<(), Failure> {
    let brought = device.on_processor().map(drop);
    outcome.and(brought).map_err(|error| of_device(error, first))
}

/// A failure of a device, or of members on it.
#[cfg(feature = "gpu")]
pub(crate) fn of_device(error: DeviceError, first: usize) -> Failure {
    match error {
        DeviceError::Core(error) => Failure::Core { error, first },
        DeviceError::Lost(lost) => Failure::Core { error: integrator_core::Error::Lost(lost), first },
        other => Failure::Other(other.to_string()),
    }
}
