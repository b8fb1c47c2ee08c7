//! Ensembles over ranks with members on devices.

use crate::{
    Ensemble,
    checkpoint::{bytes_of_rank, manifest_of},
    ensemble::counted,
    error::{Error, agree},
    held::{Held, of_device},
};
use integrator_core::{
    __private::{Composition, DeviceText, LaneScalars},
    Coords, Error as CoreError, InLanes, Phase, ResumableInLanes,
};
/// The device that integrates the members of a rank.
pub use integrator_gpu::Device;
use integrator_gpu::{Ensemble as OnDevice, Error as DeviceError};
use mpi::traits::Communicator;
use std::path::Path;

impl<'w, W: Communicator, C: Coords> Ensemble<'w, W, C> {
    /// Creates an ensemble like [`Ensemble::new`], with the members of this rank on a device of its machine.
    /// Collective.
    ///
    /// Each rank may select its own device. Ranks without a device use [`Device::Best`] and integrate on their
    /// processor.
    ///
    /// After each call that takes steps, the members are copied to the processor. One call should hence take many
    /// steps.
    ///
    /// # Errors
    /// Those of [`Ensemble::new`]; [`Error::Rank`] with the message of the crate `integrator-gpu`, if a device cannot
    /// integrate its members.
    pub fn on<H, X>(
        world: &'w W,
        device: Device,
        composition: X,
        members_of_rank: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H> + InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let members: Vec<_> = members_of_rank.into_iter().collect();
        let (first, count) = counted(world, members.len())?;
        let held = match OnDevice::on(device, composition, members, h) {
            Ok(held) => Ok(Some(Held::Device(Box::new(held)))),
            Err(DeviceError::Core(CoreError::NoMembers)) => Ok(None),
            Err(error) => Err(of_device(error, first)),
        };
        Ok(Self::of_held(world, agree(world, held)?, first, count, 0))
    }

    /// Resumes an ensemble like [`Ensemble::resume`], with the members of this rank on a device of its machine.
    /// Collective.
    ///
    /// A checkpoint does not record where the members were.
    ///
    /// # Errors
    /// Those of [`Ensemble::resume`] and [`Ensemble::on`].
    pub fn resume_on<H, X>(
        world: &'w W,
        device: Device,
        composition: X,
        system: impl Fn(usize) -> H,
        folder: impl AsRef<Path>,
    ) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H> + ResumableInLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let folder = folder.as_ref();
        let (found, own) = manifest_of(world, folder)?;
        let held = || {
            let Some(bytes) = bytes_of_rank(folder, &found, own.clone())? else { return Ok(None) };
            let held = OnDevice::resume(device, composition, own.clone().map(&system), &bytes);
            held.map(|held| Some(Held::Device(Box::new(held)))).map_err(|error| of_device(error, own.start))
        };
        let held = agree(world, held())?;
        Ok(Self::of_held(world, held, own.start, found.members, found.steps))
    }
}
