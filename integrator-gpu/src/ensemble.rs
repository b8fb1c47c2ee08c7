//! An ensemble on a device, with the methods of an ensemble on the processor.
//!
//! Always true: it contains an ensemble on the processor, which validated the members and contains the failed and
//! finished ones. That ensemble also takes over the active members for everything except whole steps: energies,
//! checkpoints, members between two steps.

use crate::{
    column::read_column,
    columns::{columns, constants},
    composed::composed,
    error::Error,
    host::Memory,
    launch::Launch,
    place::Place,
};
use integrator_core::{
    __private::{
        Composition, Coords, DeviceText, Elsewhere, LaneScalars, MemberElsewhere, Precision, begin, come_back,
        divergence, leave, steps_before,
    },
    Ensemble as OnProcessor, Error as CoreError, InLanes, Lost, Phase, ResumableInLanes,
};
use std::collections::BTreeMap;

/// The device of an ensemble.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Device {
    /// The device with this index, as in `nvidia-smi`.
    Cuda(usize),
    /// The first device, or the processor if no device is available; [`Ensemble::fallback`] returns the reason.
    Best,
    /// The device code as a program of this machine, built by its C++ compiler: slow, for tests of the code.
    Text,
}

/// The end of a failed or finished member.
#[derive(Clone, Debug)]
pub(crate) struct Ended<C> {
    pub(crate) steps: u64,
    pub(crate) time: f64,
    pub(crate) state: Phase<C>,
}

/// Many trajectories of one type of system, integrated together on a device.
///
/// Each member is bitwise identical to a run of its own on a processor with fused multiply-add. Exceptions are
/// arguments that the kernels of functions leave to the maths library: the device uses that of CUDA.
///
/// Methods take `&mut self` and may fail where those of an ensemble on the processor do not, since they access the
/// device.
pub struct Ensemble<C: Coords> {
    /// Nothing where the members stay on the processor.
    pub(crate) place: Option<Place>,
    pub(crate) processor: OnProcessor<C>,
    /// A state, in whose shape others are read.
    shape: Phase<C>,
    /// The clock of the device, which begins where the states were last changed from outside.
    pub(crate) launch: Launch,
    t0: f64,
    /// How many steps were done then.
    opened: u64,
    /// Those that are no longer in progress, and have a place.
    pub(crate) ended: BTreeMap<usize, Ended<C>>,
    /// Whether the processor has the members where the device has them.
    is_here: bool,
    /// Whether the processor shows them between two steps.
    pub(crate) is_between: bool,
    fallback: Option<Error>,
}

impl<C: Coords> Ensemble<C> {
    /// Creates an ensemble of `(system, start)` pairs on the first device.
    ///
    /// # Errors
    /// Those of [`Ensemble::on`].
    pub fn new<H, X>(composition: X, members: impl IntoIterator<Item = (H, Phase<C>)>, h: f64) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H> + InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self::on(Device::Cuda(0), composition, members, h)
    }

    /// Creates an ensemble of `(system, start)` pairs on a device.
    ///
    /// # Errors
    /// - [`Error::Core`], for the reasons of an ensemble on the processor.
    /// - All others except [`Error::Lost`], if the device cannot integrate the members. [`Device::Best`] returns none
    ///   of these.
    pub fn on<H, X>(
        device: Device,
        composition: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H> + InLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let members: Vec<_> = members.into_iter().collect();
        let constants = constants_of(members.iter().map(|(system, _)| system));
        Self::of::<H, X>(device, OnProcessor::new(composition, members, h)?, constants?)
    }

    /// Resumes an ensemble from a checkpoint of this type or of one on a processor.
    ///
    /// The method and the systems must be those at its start: see [`OnProcessor::resume`].
    ///
    /// # Errors
    /// [`Error::Checkpoint`], for the reasons of an ensemble on the processor, and those of [`Ensemble::on`].
    pub fn resume<H, X>(
        device: Device,
        composition: X,
        systems: impl IntoIterator<Item = H>,
        checkpoint: &[u8],
    ) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H> + ResumableInLanes<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let systems: Vec<H> = systems.into_iter().collect();
        let constants = constants_of(systems.iter());
        let processor = OnProcessor::resume(composition, systems, checkpoint);
        Self::of::<H, X>(device, processor.map_err(|error| Error::Checkpoint(error.to_string()))?, constants?)
    }

    /// The members of an ensemble on the processor, moved to a device.
    fn of<H, X>(device: Device, processor: OnProcessor<C>, constants: Vec<f64>) -> Result<Self, Error>
    where
        H: DeviceText,
        X: Composition<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let Elsewhere { t0, h, steps, opened, members } = leave(&processor);
        let (mut launch, stages) = Launch::new::<H, X, C::Leaf>(h, members.len());
        launch.done = steps - opened;
        let state = columns(&states_of(&members));
        let lost = members.iter().map(held).chain([0]).collect();
        let memory = Memory { stages, constants, state, shown: Vec::new(), lost };
        let text = composed(&launch, &memory.stages) + H::TEXT;
        let (place, fallback) = match device {
            Device::Cuda(ordinal) => (Some(Place::device(ordinal, &text, C::Leaf::NAME, &memory)?), None),
            Device::Best => match Place::device(0, &text, C::Leaf::NAME, &memory) {
                Ok(place) => (Some(place), None),
                Err(reason) => (None, Some(reason)),
            },
            Device::Text => (Some(Place::program(&text, H::FINGERPRINT, C::Leaf::NAME, memory)?), None),
        };
        let shape = members[0].1.clone();
        let ended = members.into_iter().enumerate().filter_map(ended).collect();
        let (is_here, is_between) = (true, false);
        let ensemble = Self { place, processor, shape, launch, t0, opened, ended, is_here, is_between, fallback };
        Ok(ensemble.at_time(t0))
    }

    /// Starts the clock at `t0` instead of 0. If `t0` is not finite, the first `advance` returns an error.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.processor = self.processor.at_time(t0);
        self.t0 = t0;
        self.launch.t0 = self.time_after(self.opened);
        self
    }

    /// Limits the number of threads for computations on the processor. Results do not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.processor = self.processor.with_threads(threads);
        self
    }

    /// Returns the reason why the members are on the processor, if [`Device::Best`] selected it.
    pub fn fallback(&self) -> Option<&Error> {
        self.fallback.as_ref()
    }

    /// Takes `steps` steps with every active member.
    ///
    /// # Errors
    /// - [`Error::Lost`]: members diverged. The error lists them with their last finite states; all other members have
    ///   taken the steps.
    /// - [`Error::Core`]: the time is not finite, the steps cannot be counted, or a start has no energy. The ensemble
    ///   is unchanged.
    /// - [`Error::Call`] and [`Error::Program`]: the device fails.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let done = self.steps();
        let Some(place) = &mut self.place else { return Ok(self.processor.advance(steps)?) };
        begin(&mut self.processor, done, steps)?;
        self.is_between = false;
        if steps == 0 {
            return Ok(());
        }
        self.is_here = false;
        self.launch.steps = steps;
        let lost = place.advance(&self.launch)?;
        self.launch.done += steps;
        let newly = lost.iter().enumerate().filter(|(member, lost)| **lost > 0 && !self.ended.contains_key(member));
        let newly: Vec<_> = newly.map(|(member, lost)| (member, self.opened + lost - 1)).collect();
        if newly.is_empty() { Ok(()) } else { Err(Error::Lost(self.lose(&newly)?)) }
    }

    /// Records members that fail, each with its last finite step, and reports them.
    fn lose(&mut self, newly: &[(usize, u64)]) -> Result<Lost, Error> {
        let (unfinished, shown) = match &mut self.place {
            Some(place) => (place.unfinished()?, place.show(&self.launch)?),
            None => (Vec::new(), Vec::new()),
        };
        let mut members = Vec::with_capacity(newly.len());
        for (member, steps) in newly.iter().copied() {
            let [last, state] = [&unfinished, &shown].map(|columns| self.read(columns, member));
            members.push((member, divergence(&self.processor, member, (steps, self.opened), &last)?));
            self.ended.insert(member, Ended { steps, time: self.time_after(steps), state });
        }
        Ok(Lost { members })
    }

    /// Takes steps like [`Ensemble::advance`], and stops members individually.
    ///
    /// After every `interval` steps, each active member is copied to the processor and passed to `stays`. If it returns
    /// `false`, the member has finished and keeps this state.
    ///
    /// # Errors
    /// Those of [`Ensemble::advance`]; [`Error::Core`] if the interval is 0.
    pub fn advance_while(
        &mut self,
        steps: u64,
        interval: u64,
        stays: impl Fn(usize, &Phase<C>) -> bool + Sync,
    ) -> Result<(), Error> {
        if self.place.is_none() {
            return Ok(self.processor.advance_while(steps, interval, stays)?);
        }
        if interval == 0 {
            return Err(CoreError::SampleInterval.into());
        }
        let done = self.steps();
        begin(&mut self.processor, done, steps)?;
        let (mut left, mut lost) = (steps, Vec::new());
        while left > 0 {
            let block = interval.min(left);
            match self.advance(block) {
                Err(Error::Lost(Lost { members })) => lost.extend(members),
                outcome => outcome?,
            }
            left -= block;
            if block == interval {
                self.let_go(&stays)?;
            }
        }
        lost.sort_unstable_by_key(|(member, _)| *member);
        if lost.is_empty() { Ok(()) } else { Err(Error::Lost(Lost { members: lost })) }
    }

    /// Lets those members go that do not stay.
    fn let_go(&mut self, stays: &impl Fn(usize, &Phase<C>) -> bool) -> Result<(), Error> {
        let (steps, time, before) = (self.steps(), self.time(), self.ended.len());
        for (member, state) in self.states()?.into_iter().enumerate() {
            if !self.ended.contains_key(&member) && !stays(member, &state) {
                self.ended.insert(member, Ended { steps, time, state });
            }
        }
        if self.ended.len() == before { Ok(()) } else { self.hold() }
    }

    /// Takes no more steps with those that have ended.
    fn hold(&mut self) -> Result<(), Error> {
        let held: Vec<_> = (0..self.len()).map(|member| u64::from(self.ended.contains_key(&member))).collect();
        self.place.as_mut().map_or(Ok(()), |place| place.hold(&held))
    }

    /// Advances every active member to a time, up to rounding.
    ///
    /// The device takes whole steps. From there, a copy of each member advances on the processor, as in
    /// [`OnProcessor::advance_to`].
    ///
    /// # Errors
    /// Those of [`Ensemble::advance`]; [`Error::Core`] if the time is not finite or has passed.
    pub fn advance_to(&mut self, time: f64) -> Result<(), Error> {
        if self.place.is_none() {
            return Ok(self.processor.advance_to(time)?);
        }
        let mut lost = Vec::new();
        match self.advance(steps_before(&self.processor, self.steps(), time)?) {
            Err(Error::Lost(Lost { members })) => lost.extend(members),
            outcome => outcome?,
        }
        self.bring()?;
        self.is_between = true;
        if let Err(error) = self.processor.advance_to(time) {
            let CoreError::Lost(Lost { members }) = error else { return Err(error.into()) };
            lost.extend(members);
            // They left in the shorter step, beyond the last one of all.
            self.ended = leave(&self.processor).members.into_iter().enumerate().filter_map(ended).collect();
            self.hold()?;
        }
        lost.sort_unstable_by_key(|(member, _)| *member);
        if lost.is_empty() { Ok(()) } else { Err(Error::Lost(Lost { members: lost })) }
    }

    /// Changes the states of the active members on the processor, one after the other: see [`OnProcessor::map_states`].
    ///
    /// # Errors
    /// [`Error::Core`], for the reasons of an ensemble on the processor, [`Error::Call`] and [`Error::Program`].
    pub fn map_states(&mut self, map: impl FnMut(usize, &mut Phase<C>)) -> Result<(), Error> {
        self.bring()?;
        self.processor.map_states(map)?;
        let Elsewhere { steps, members, .. } = leave(&self.processor);
        if let Some(place) = &mut self.place {
            (self.opened, self.launch.done, self.is_between) = (steps, 0, false);
            self.launch.t0 = self.t0 + steps as f64 * self.launch.h;
            place.restart(&columns(&states_of(&members)))?;
        }
        Ok(())
    }

    /// Returns a checkpoint of the ensemble, for [`Ensemble::resume`], or for [`OnProcessor::resume`] without a device.
    ///
    /// It has the format of an ensemble on the processor.
    ///
    /// # Errors
    /// [`Error::Call`] and [`Error::Program`].
    pub fn checkpoint(&mut self) -> Result<Vec<u8>, Error> {
        Ok(self.on_processor()?.checkpoint())
    }

    /// Copies the members to the processor and returns them, for all operations except steps.
    ///
    /// Examples are [`OnProcessor::run_of`], [`OnProcessor::invariant`] and [`OnProcessor::present`].
    ///
    /// # Errors
    /// [`Error::Call`] and [`Error::Program`].
    pub fn on_processor(&mut self) -> Result<&OnProcessor<C>, Error> {
        self.bring()?;
        Ok(&self.processor)
    }

    /// Returns the members as last copied to the processor: at the start, or by [`Ensemble::on_processor`].
    pub fn last_on_processor(&self) -> &OnProcessor<C> {
        &self.processor
    }

    /// Brings the members to the processor, from where the device has them.
    fn bring(&mut self) -> Result<(), Error> {
        let Some(place) = self.place.as_ref().filter(|_| !self.is_here) else { return Ok(()) };
        let columns = place.unfinished()?;
        let member = |member| match self.ended.get(&member) {
            Some(Ended { steps, time, state }) => (Some((*steps, *time)), state.clone()),
            None => (None, self.read(&columns, member)),
        };
        let members: Vec<MemberElsewhere<C>> = (0..self.len()).map(member).collect();
        come_back(&mut self.processor, self.opened + self.launch.done, self.opened, &members);
        self.is_here = true;
        Ok(())
    }

    /// A member of the columns of all.
    pub(crate) fn read(&self, columns: &[f64], member: usize) -> Phase<C> {
        let mut state = self.shape.clone();
        read_column(columns, self.len(), member, &mut state);
        state
    }

    /// Returns the number of steps that the active members have taken.
    pub fn steps(&self) -> u64 {
        if self.place.is_some() { self.opened + self.launch.done } else { self.processor.steps() }
    }

    /// The time after this number of steps.
    pub(crate) fn time_after(&self, steps: u64) -> f64 {
        self.t0 + steps as f64 * self.launch.h
    }
}

/// A member that has ended.
fn ended<C: Coords>((member, (ended, state)): (usize, MemberElsewhere<C>)) -> Option<(usize, Ended<C>)> {
    ended.map(|(steps, time)| (member, Ended { steps, time, state }))
}

/// The states of members.
fn states_of<C: Coords>(members: &[MemberElsewhere<C>]) -> Vec<Phase<C>> {
    members.iter().map(|(_, state)| state.clone()).collect()
}

/// Whether a device takes no steps with a member, as it notes that.
fn held<C: Coords>((ended, _): &MemberElsewhere<C>) -> u64 {
    u64::from(ended.is_some())
}

/// The prepared constants of systems, as columns; how many coordinates these have is known.
fn constants_of<'s, H: DeviceText + 's>(systems: impl Iterator<Item = &'s H>) -> Result<Vec<f64>, Error> {
    let length = <H::Coords as Coords>::LENGTH.unwrap_or_default();
    constants::<H>(&systems.map(|system| system.parameters(length)).collect::<Vec<_>>()).map_err(Error::List)
}
