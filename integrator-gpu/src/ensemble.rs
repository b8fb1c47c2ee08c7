//! An ensemble on a device, with the methods of the one on the processor.

use crate::{
    column::read_column,
    columns::{columns, constants},
    cuda,
    error::Error,
    host::{self, Memory},
    launch::Launch,
};
use integrator_core::{
    __private::{Composition, Coords, DeviceText, LaneScalars, Motion, Precision, Real},
    Ensemble as OnProcessor, Error as CoreError, InLanes, Phase,
};
use std::{env, fs, path::PathBuf};

/// Where an ensemble is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Device {
    /// The device of this number, as `nvidia-smi` counts them.
    Cuda(usize),
    /// The first device, or the processor where none can be had: [`Ensemble::fallback`] says why.
    Best,
    /// The text for devices as a program of this machine, made by its C++ compiler: slow, and there to test the text.
    Text,
}

/// What takes the steps.
enum Place<C: Coords> {
    Cuda(Box<cuda::Members>),
    Text(PathBuf, Box<Memory>),
    Processor(Box<OnProcessor<C>>),
}

/// The energy of a member in a state at a time.
type Energies<C> = Box<dyn Fn(usize, &Phase<C>, f64) -> f64>;

/// Trajectories of one kind of system under way together on a device.
///
/// A member has the bits of its run alone on a processor with fused multiply-add, as far as its functions stay with the
/// kernels: the arguments that these leave to the maths library are left to that of CUDA.
pub struct Ensemble<C: Coords> {
    place: Place<C>,
    launch: Launch,
    starts: Vec<Phase<C>>,
    lost: Vec<u64>,
    energies: Energies<C>,
    fallback: Option<Error>,
}

impl<C: Coords> Ensemble<C> {
    /// An ensemble of `(system, start)` pairs on the first device.
    ///
    /// # Errors
    /// As [`Ensemble::on`].
    pub fn new<H, X>(composition: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: DeviceText + 'static,
        X: Composition<H> + InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::on(Device::Cuda(0), composition, members, h)
    }

    /// An ensemble of `(system, start)` pairs on a device.
    ///
    /// # Errors
    /// [`Error::Core`] for the reasons of an ensemble on the processor; all others but [`Error::Lost`] where the device cannot
    /// take the members, and for [`Device::Best`] none of these.
    pub fn on<H, X>(
        device: Device,
        composition: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: DeviceText + 'static,
        X: Composition<H> + InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let (systems, starts): (Vec<H>, Vec<Phase<C>>) = members.into_iter().unzip();
        let parameters: Vec<_> =
            systems.iter().zip(&starts).map(|(system, start)| system.parameters(start.q.length())).collect();
        // It judges members and steps.
        let on_processor = OnProcessor::new(composition, systems.into_iter().zip(starts.iter().cloned()), h)?;
        let (launch, stages) = Launch::new::<H, X, C::Leaf>(h, starts.len());
        let memory = Memory {
            stages,
            constants: constants::<H>(&parameters),
            state: columns(&starts),
            shown: Vec::new(),
            lost: vec![0; starts.len()],
        };
        let on_device = |ordinal| {
            let members = cuda::Members::new(ordinal, H::TEXT, C::Leaf::NAME, &memory)?;
            Ok(Place::Cuda(Box::new(members)))
        };
        let (place, fallback) = match device {
            Device::Cuda(ordinal) => (on_device(ordinal)?, None),
            Device::Best => match on_device(0) {
                Ok(place) => (place, None),
                Err(reason) => (Place::Processor(Box::new(on_processor)), Some(reason)),
            },
            Device::Text => (Place::Text(program(H::TEXT, H::FINGERPRINT)?, Box::new(memory.clone())), None),
        };
        let energies: Energies<C> =
            Box::new(move |member, state, time| energy::<H, C>(&parameters[member], state, time));
        Ok(Self { place, launch, lost: vec![0; starts.len()], starts, energies, fallback })
    }

    /// Why the members are on the processor, if [`Device::Best`] put them there.
    pub fn fallback(&self) -> Option<&Error> {
        self.fallback.as_ref()
    }

    /// Takes `steps` steps with every member that is under way.
    ///
    /// # Errors
    /// [`Error::Lost`] names the members that left the finite numbers in these steps; the others have taken them.
    /// [`Error::Call`] and [`Error::Program`] where the device fails.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let done = self.launch.done;
        let end = done.checked_add(steps).ok_or(CoreError::Steps { done, asked: steps })?;
        if steps == 0 {
            return Ok(());
        }
        self.launch.steps = steps;
        let lost = match &mut self.place {
            Place::Cuda(members) => members.advance(&self.launch)?,
            Place::Text(program, memory) => {
                let mut jobs = [(number_of(C::Leaf::NAME), self.launch, (**memory).clone())];
                Memory::run(program, &mut jobs).map_err(|error| Error::Program(error.to_string()))?;
                let [(_, _, ran)] = jobs;
                **memory = ran;
                memory.lost.clone()
            }
            Place::Processor(ensemble) => match ensemble.advance(steps) {
                Ok(()) => self.lost.clone(),
                Err(CoreError::Lost(lost)) => {
                    let mut now = self.lost.clone();
                    lost.members.iter().for_each(|(member, _)| {
                        now[*member] = ensemble.steps_of(*member).unwrap_or_default() + 1;
                    });
                    now
                }
                Err(error) => return Err(error.into()),
            },
        };
        self.launch.done = end;
        let newly = lost.iter().zip(&self.lost).enumerate().filter(|(_, (now, before))| now != before);
        let newly: Vec<_> = newly.map(|(member, (now, _))| (member, now - 1)).collect();
        self.lost = lost;
        if newly.is_empty() { Ok(()) } else { Err(Error::Lost(newly)) }
    }

    /// The number of members.
    pub fn len(&self) -> usize {
        self.starts.len()
    }

    /// Whether there are no members, which no constructor admits.
    pub fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }

    /// The members that were lost, each with its last finite step.
    pub fn lost(&self) -> Vec<(usize, u64)> {
        let lost = self.lost.iter().enumerate();
        lost.filter_map(|(member, lost)| Some((member, lost.checked_sub(1)?))).collect()
    }

    /// The number of steps that the members under way have done.
    pub fn steps(&self) -> u64 {
        let Launch { done, .. } = self.launch;
        done
    }

    /// The time of the members under way.
    pub fn time(&self) -> f64 {
        self.time_after(self.launch.done)
    }

    /// The states of all members; of those who are lost the last finite ones.
    ///
    /// # Errors
    /// [`Error::Call`] where the device fails.
    pub fn states(&mut self) -> Result<Vec<Phase<C>>, Error> {
        let columns = match &mut self.place {
            Place::Cuda(members) => members.show(&self.launch)?,
            Place::Text(_, memory) if memory.shown.is_empty() => memory.state.clone(),
            Place::Text(_, memory) => memory.shown.clone(),
            Place::Processor(ensemble) => return Ok(ensemble.states().collect()),
        };
        let mut states = self.starts.clone();
        let members = states.len();
        states.iter_mut().enumerate().for_each(|(member, state)| read_column(&columns, members, member, state));
        Ok(states)
    }

    /// The energies of all members, computed on the processor from their states.
    ///
    /// # Errors
    /// [`Error::Call`] where the device fails.
    pub fn energies(&mut self) -> Result<Vec<f64>, Error> {
        let states = self.states()?;
        let time = |member: usize| self.time_after(self.lost[member].checked_sub(1).unwrap_or(self.launch.done));
        Ok(states.iter().enumerate().map(|(member, state)| (self.energies)(member, state, time(member))).collect())
    }

    fn time_after(&self, steps: u64) -> f64 {
        self.launch.t0 + steps as f64 * self.launch.h
    }
}

/// The energy of a state, in the scalar of energies.
fn energy<H, C: Coords>(parameters: &H::Parameters<f64>, state: &Phase<C>, time: f64) -> f64
where
    H: DeviceText,
    H::Coords: Coords<With<C::Leaf> = C>,
{
    type Energy<C> = <<C as Coords>::Leaf as Precision>::Energy;
    let motion = <H::Motion<Energy<C>, C::Leaf> as Motion<C, _>>::load(&[parameters], &[state]);
    let kinetic = H::kinetic::<Energy<C>, C::Leaf>(&motion, time);
    (kinetic + H::potential::<Energy<C>, C::Leaf>(&motion, time)).lane(0)
}

/// The number of a precision in the program of one system.
fn number_of(precision: &str) -> u64 {
    match precision {
        "f32" => 1,
        "compensated f64" => 2,
        _ => 0,
    }
}

/// The program of one system, in a folder of its own.
fn program(text: &str, fingerprint: u64) -> Result<PathBuf, Error> {
    let failed = |error: std::io::Error| Error::Program(error.to_string());
    let compiler =
        host::compiler().ok_or_else(|| Error::Program("no C++ compiler is installed: set CXX".to_owned()))?;
    let folder = env::temp_dir().join(format!("integrator-gpu-{fingerprint:016x}-{}", std::process::id()));
    fs::create_dir_all(&folder).map_err(failed)?;
    let text = host::program(&[("one", text)], &host::serving(&["one"]));
    host::compile(&compiler, &text, &folder).map_err(failed)
}
