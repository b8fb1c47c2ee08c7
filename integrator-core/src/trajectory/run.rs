//! One trajectory: integer step counts, stages merged across steps, stopped when the state is not finite.

#[cfg(debug_assertions)]
use crate::system::user_energies::hold_at_start;
#[cfg(feature = "checkpoint")]
use crate::trajectory::checkpoint::Origin;
#[cfg(feature = "std")]
use crate::trajectory::progress::{Progress, in_portions};
use crate::{
    composition::flow_counts::PartFlows,
    error::{Divergence, Error},
    state::{
        clock::{Clock, durations, time_after},
        coords::Coords,
        phase::{Abridged, Phase},
        point::Point,
        precision::Precision,
    },
    system::{
        System,
        counts::{Counts, OwnSteps},
        energy::{Energies, Parts, energies},
        flow_layout::Layouts,
        motion::Prepared,
    },
    trajectory::{
        admissible::{admissible_with, change},
        dispatch::{Bound, Nothing, bound},
        engine::Engine,
        method::Method,
        motions::{Form, Motions, elapsed, show},
        watch::Watch,
    },
};
use alloc::{sync::Arc, vec, vec::Vec};
use core::fmt;
#[cfg(feature = "std")]
use core::ops::ControlFlow;

/// A trajectory that is being integrated, returned by [`Hamiltonian::run`](crate::Hamiltonian::run).
///
/// The type has the coordinates as its only parameter, so that runs of different systems and methods can be stored
/// together.
pub struct Run<C: Coords> {
    pub(crate) engine: Engine,
    energies: Arc<dyn Energies<C>>,
    /// A state of the size of the run, if the type does not determine it.
    shape: Phase<C>,
    pub(crate) clock: Clock,
    /// The number of steps done when the state was last changed from outside.
    pub(crate) opened: u64,
    /// The time, where it is part of the state, when this was last changed from outside: a sum of two numbers.
    pub(crate) opened_at: [f64; 2],
    /// The time and the state that the run shows while it stands at the step before.
    between: Option<(f64, Phase<C>)>,
    pub(crate) watch: Option<Watch>,
    pub(crate) autonomous: bool,
    method: &'static str,
    layout: Layouts,
    /// The number of force evaluations per step, if it is known beforehand.
    forces: Option<usize>,
    /// What determines how often a step applies the flow of each part, if the method composes flows.
    flows: Option<PartFlows>,
    /// The counters of the steps before `opened`.
    counted: Counts,
    /// Whether the energy of the start is still to be checked, where it depends on the time that the clock starts at.
    start_unchecked: bool,
    /// The origin of the run, which its checkpoints name.
    #[cfg(feature = "checkpoint")]
    pub(crate) origin: Origin,
}

/// The properties that runs of one kind of system by one method share.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    pub(crate) autonomous: bool,
    pub(crate) method: &'static str,
    pub(crate) layout: Layouts,
    pub(crate) forces: Option<usize>,
    pub(crate) flows: Option<PartFlows>,
}

impl<C: Coords> Run<C> {
    pub(crate) fn start<H, X, K>(system: &H, method: X, start: Phase<C>, h: f64) -> Result<Self, Error>
    where
        H: System,
        X: Method<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        admissible_with::<H, _>(method, &start, h)?;
        Self::carrying::<H, K>(system, &bound::<H, X, K, Nothing>(method), start, (&[], Vec::new()), h)
    }

    /// A run that carries points in the lanes after those of the state, and perhaps constants of theirs.
    pub(crate) fn carrying<H, K>(
        system: &H,
        method: &Bound<H::Parameters<f64>>,
        start: Phase<C>,
        carried: Behind<'_, C, H::Parameters<f64>>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: System,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        let clock = Clock { t0: 0.0, h, steps: 0 };
        let mut run = Self::from_unfinished::<H, K>(system, method, start, carried, clock, 0)?;
        run.start_unchecked = true;
        if H::AUTONOMOUS {
            run.check_start()?;
        }
        Ok(run)
    }

    /// Checks the energy of the start, once.
    ///
    /// # Errors
    /// [`Error::Energy`]
    pub(crate) fn check_start(&mut self) -> Result<(), Error> {
        if self.start_unchecked {
            self.parts().admissible(self.time())?;
            self.start_unchecked = false;
        }
        Ok(())
    }

    /// A run from a state in the middle of the current step at the clock, where the state was last changed from
    /// outside after
    /// `opened` steps.
    ///
    /// # Errors
    /// [`Error::Parameters`], where a prepared constant is not finite and the motion is not; in builds with debug
    /// assertions [`Error::Misread`].
    pub(crate) fn from_unfinished<H, K>(
        system: &H,
        method: &Bound<H::Parameters<f64>>,
        start: Phase<C>,
        (carried, slopes): Behind<'_, C, H::Parameters<f64>>,
        clock: Clock,
        opened: u64,
    ) -> Result<Self, Error>
    where
        H: System,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        system.admissible(start.q.length())?;
        let parameters = system.parameters(start.q.length());
        #[cfg(debug_assertions)]
        let held = hold_at_start::<H, K>(system, &parameters, &start, clock.at(clock.steps));
        let constants = H::Parameters::<f64>::not_finite(&parameters);
        #[cfg(feature = "checkpoint")]
        let origin = Origin::of::<H>(method.facts, &parameters);
        let parameters = Arc::new(parameters);
        let mut engine = method.engine(parameters.clone(), slopes, lanes(&start, carried));
        engine.share_among(None);
        let run = Self {
            autonomous: H::AUTONOMOUS,
            method: method.facts.name,
            layout: Layouts::of::<H>(system.is_listed(start.q.length())),
            forces: method.forces,
            flows: method.flows,
            #[cfg(feature = "checkpoint")]
            origin,
            ..Self::of_engine(engine, energies::<H, K>(parameters), start, clock, opened)
        };
        // An infinite constant may be meant, such as a cutoff beyond all distances: what counts is what it does.
        if !constants.is_empty() && run.engine.is_not_finite(run.since_opened()) {
            return Err(Error::Parameters { constants });
        }
        #[cfg(debug_assertions)]
        held?;
        Ok(run)
    }

    /// A run without a description: a member of an ensemble has no name of its own.
    pub(crate) fn of_engine(
        engine: Engine,
        energies: Arc<dyn Energies<C>>,
        shape: Phase<C>,
        clock: Clock,
        opened: u64,
    ) -> Self {
        Self {
            engine,
            energies,
            shape,
            clock,
            opened,
            opened_at: [0.0; 2],
            between: None,
            watch: None,
            autonomous: false,
            method: "",
            layout: Layouts::NONE,
            forces: None,
            flows: None,
            counted: Counts::default(),
            start_unchecked: false,
            #[cfg(feature = "checkpoint")]
            origin: Origin::UNKNOWN,
        }
    }

    /// The run of a member of an ensemble, with the method and system of the ensemble.
    #[cfg(feature = "std")]
    pub(crate) fn known_as(
        self,
        Kind { autonomous, method, layout, forces, flows }: Kind,
        #[cfg(feature = "checkpoint")] origin: Origin,
    ) -> Self {
        Self {
            autonomous,
            method,
            layout,
            forces,
            flows,
            #[cfg(feature = "checkpoint")]
            origin,
            ..self
        }
    }

    /// The clock of the engine, which begins where the state was last changed from outside.
    fn since_opened(&self) -> Clock {
        self.clock.since(self.opened)
    }

    /// Starts the clock at `t0` instead of 0.
    ///
    /// If `t0` is not finite, the first `advance` returns an error.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.clock.t0 = t0;
        self
    }

    /// Sets the seed of the random numbers of a system with a temperature; the default is 0.
    ///
    /// Runs with equal seeds draw equal numbers. Without a temperature the seed has no effect.
    #[must_use]
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.engine.change_draws(&|draws| draws.seed = seed);
        self
    }

    /// Limits the number of threads; the default is all cores.
    ///
    /// Only lattices of many sites and pair sums of hundreds of bodies are distributed over threads. Results are bitwise
    /// independent of the number of threads.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.engine.share_among(Some(threads));
        self
    }

    /// Checks that the clock started at a time.
    pub(crate) fn check_clock(&self) -> Result<(), Error> {
        self.clock.check()
    }

    /// Takes `steps` steps.
    ///
    /// `advance(a)` followed by `advance(b)` is bitwise identical to `advance(a + b)`.
    ///
    /// # Errors
    /// - [`Error::Diverged`]: the state is not finite. The run stays at the last finite state, which [`Run::time`] and
    ///   [`Run::state`] return.
    /// - [`Error::NotSolved`]: an implicit method did not solve its equations. The run stays at the last step.
    /// - [`Error::EnergyStrayed`]: the energy left the bound of [`Run::watch_energy`]. The run stays at the last step
    ///   within the bound.
    /// - [`Error::Time`], [`Error::Clock`], [`Error::Steps`]: the run is unchanged.
    /// - [`Error::Energy`]: `H` depends on time, and the energy of the start is not finite. The first call returns this
    ///   error; the run is unchanged.
    ///
    /// # Panics
    /// If your own functions panic. A program that catches the panic finds the run at the last step before it. The panic
    /// message can be printed twice, because this step is located by repeating a block of steps. Without the feature
    /// `std`, the run stays up to 1023 steps before the panic.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let end = self.clock.end(steps)?;
        self.check_start()?;
        self.between = None;
        let Some(watch) = self.watch else { return self.take_steps_to(end) };
        while self.clock.steps < end {
            self.take_steps_to(self.clock.steps + 1)?;
            let (step, time, energy) = (self.clock.steps, self.time(), self.energy());
            if let Some(strayed) = watch.strayed(energy, step, time) {
                self.engine.undo();
                self.clock.steps -= 1;
                return Err(strayed);
            }
        }
        Ok(())
    }

    /// Takes `steps` steps like [`Run::advance`], and calls `progress` about ten times a second.
    ///
    /// The [`Progress`] contains the steps done, the elapsed time and an estimate of the remaining time. If `progress`
    /// returns [`ControlFlow::Break`], the call stops and the run can be continued later. Returns the number of steps
    /// taken.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    /// use std::{
    ///     ops::ControlFlow,
    ///     sync::atomic::{AtomicBool, Ordering},
    /// };
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    ///
    /// // `ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed))` of the crate ctrlc sets it by Ctrl-C.
    /// static STOP: AtomicBool = AtomicBool::new(false);
    ///
    /// let mut run = Oscillator.run(Phase::new([1.0], [0.0]), 0.01)?;
    /// let taken = run.advance_with(100_000, |progress| {
    ///     eprintln!("{progress}"); // 37 %, 12 s left
    ///     if STOP.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    /// })?;
    /// assert_eq!((taken, run.steps()), (100_000, 100_000));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Run::advance`].
    #[cfg(feature = "std")]
    pub fn advance_with(
        &mut self,
        steps: u64,
        mut progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<u64, Error> {
        self.clock.end(steps)?;
        in_portions(steps, 1, &mut |steps| self.advance(steps), &mut progress)
    }

    /// Takes steps up to this number of steps.
    fn take_steps_to(&mut self, end: u64) -> Result<(), Error> {
        let clock = self.since_opened();
        self.engine.advance(clock, end - self.clock.steps, &mut self.clock.steps);
        if self.clock.steps < end {
            let clock = self.clock;
            return Err(match self.engine.completed.unsolved(0) {
                Some(reason) => Error::NotSolved {
                    method: self.method,
                    step: clock.steps.saturating_add(1),
                    time: self.time(),
                    reason: reason.clone(),
                },
                None => self.divergence().into(),
            });
        }
        Ok(())
    }

    /// The report on the step that could not be taken.
    pub(crate) fn divergence(&self) -> Divergence {
        self.state_at_step().divergence(&self.tried_lane(0), self.clock).at_own_time(self.time_in_state())
    }

    /// Shows a state of the step that would be next.
    pub(crate) fn show_at(&mut self, time: f64, state: Phase<C>) {
        self.between = Some((time, state));
    }

    /// The run at the end of its last step.
    pub(crate) fn at_step(mut self) -> Self {
        self.show_step();
        self
    }

    /// Shows the end of the last step.
    pub(crate) fn show_step(&mut self) {
        self.between = None;
    }

    /// Takes one step, whatever a watch says.
    pub(crate) fn take_step(&mut self) -> Result<(), Error> {
        self.take_steps_to(self.clock.end(1)?)
    }

    /// Goes back to where the last steps began, if these were at most a block and taken together.
    pub(crate) fn take_back(&mut self, steps: u64) {
        self.engine.undo();
        self.clock.steps -= steps;
    }

    /// Returns the time, `t0 + n·h`.
    ///
    /// - For a method with a fictitious time, such as [`Logarithmic`](crate::Logarithmic), this is the integrated
    ///   physical time.
    /// - After [`Run::advance_to`], it is the time to which the run advanced.
    pub fn time(&self) -> f64 {
        match &self.between {
            Some((time, _)) => *time,
            None => self.time_at_step(),
        }
    }

    /// The time at the end of the last step.
    pub(crate) fn time_at_step(&self) -> f64 {
        self.time_in_state().unwrap_or_else(|| self.clock.at(self.clock.steps))
    }

    /// The time at the end of the last step, where it is part of the state.
    pub(crate) fn time_in_state(&self) -> Option<f64> {
        self.engine.own_time(self.since_opened(), self.clock.t0, self.opened_at)
    }

    /// The time so long after the state was last changed from outside.
    pub(crate) fn time_of(&self, elapsed: [f64; 2]) -> f64 {
        time_after(self.clock.t0, durations(self.opened_at, elapsed))
    }

    /// Returns the step `h`.
    pub fn step(&self) -> f64 {
        self.clock.h
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// Returns the number of force evaluations in all steps of this run.
    ///
    /// - Compositions: evaluations per step times steps; a force-gradient kick counts twice. If a part takes inner steps, those of
    ///   the last part: [`evaluations_of_parts`](Self::evaluations_of_parts) has all of them.
    /// - Implicit methods: counted; a Jacobian counts once for each of its columns.
    /// - [`Taylor`](crate::taylor::Taylor): counted; a polynomial counts once for each of its orders. The cost of an order
    ///   grows with the number of lower orders.
    pub fn evaluations(&self) -> u64 {
        match self.forces {
            Some(forces) => self.clock.steps.saturating_mul(forces as u64),
            None => self.counts().evaluations,
        }
    }

    /// Returns how often all steps of this run applied the flow of each part of `H`, with the names of the parts.
    ///
    /// A flow that is merged across steps counts once. Empty for methods that do not compose flows.
    pub fn evaluations_of_parts(&self) -> Vec<(&'static str, u64)> {
        let names = self.layout.parts().map(|(name, _)| name);
        let counts = self.flows.iter().flat_map(PartFlows::counts);
        names.zip(counts).map(|(name, count)| (name, self.clock.steps.saturating_mul(count))).collect()
    }

    /// Returns the internal steps of a method that chooses its own steps, such as [`Taylor`](crate::taylor::Taylor);
    /// `None` for other methods.
    ///
    /// An internal step is one Taylor polynomial. It counts when the run has passed its end, so the current polynomial is
    /// not included. If the exact solution is a polynomial in time, one polynomial covers it and the count stays zero.
    pub fn own_steps(&self) -> Option<OwnSteps> {
        self.counts().own_steps
    }

    /// Returns the counters of all steps.
    fn counts(&self) -> Counts {
        self.counted.and(self.engine.motions.counts().unwrap_or_default())
    }

    /// Returns the state at [`Run::time`].
    ///
    /// The last stage of the current step is completed on a copy, so the run does not change.
    pub fn state(&self) -> Phase<C> {
        match &self.between {
            Some((_, state)) => state.clone(),
            None => self.state_at_step(),
        }
    }

    /// The state at the end of the last step.
    pub(crate) fn state_at_step(&self) -> Phase<C> {
        self.lane(0)
    }

    /// Returns the energy `T + V` at [`Run::time`].
    ///
    /// The energy is NaN or infinite where your functions are undefined, for example the logarithm of a negative number.
    /// Steps evaluate forces only, which can be finite there if a step jumped over a pole. [`Run::watch_energy`] stops
    /// such a run.
    pub fn energy(&self) -> f64 {
        self.parts().total
    }

    /// Returns the kinetic energy `T` at [`Run::time`]; with named parts, the energy of the first part.
    pub fn kinetic(&self) -> f64 {
        self.parts().kinetic
    }

    /// Returns the potential energy `V` at [`Run::time`]; with named parts, the energy of all parts except the first.
    pub fn potential(&self) -> f64 {
        self.parts().potential
    }

    /// Returns the layouts in which the flows of the system are computed, such as neighbour sums along a line.
    ///
    /// Methods other than compositions evaluate the equations of motion instead of these flows.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Chain;
    ///
    /// #[hamiltonian]
    /// impl Chain {
    ///     fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| p * p / 2.0).sum() }
    ///     fn potential(&self, q: &[f64]) -> f64 { (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(4)).sum() }
    /// }
    ///
    /// let run = Chain.run(Phase::new(vec![0.0; 100], vec![1.0; 100]), 0.01)?;
    /// assert_eq!(run.layout().kick(), "line");
    /// assert_eq!(run.layout().to_string(), "kinetic: line, potential: line");
    /// # Ok::<(), Error>(())
    /// ```
    pub fn layout(&self) -> Layouts {
        self.layout
    }

    /// Returns the value of a conserved quantity, by its name.
    ///
    /// Conserved quantities are the functions of the impl with [`#[invariant]`](macro@crate::hamiltonian#invariants).
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Kepler;
    ///
    /// #[hamiltonian]
    /// impl Kepler {
    ///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
    ///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
    ///     #[invariant]
    ///     fn angular_momentum(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] - q[1] * p[0] }
    /// }
    ///
    /// let mut run = Kepler.run(Phase::new([1.0, 0.0], [0.0, 0.8]), 0.01)?;
    /// run.advance(10_000)?;
    /// assert!((run.invariant("angular_momentum")? - 0.8).abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoInvariant`] if there is none of this name; the error lists all names.
    pub fn invariant(&self, name: &str) -> Result<f64, Error> {
        self.energies.invariant_named(name, &self.state())
    }

    pub(crate) fn parts(&self) -> Parts {
        self.parts_of(|| self.state())
    }

    /// The energies at [`Run::time`], for the state there.
    pub(crate) fn parts_of(&self, state: impl FnOnce() -> Phase<C>) -> Parts {
        let time = self.time();
        if self.between.is_none()
            && let Some(parts) = self.engine.energy(self.since_opened(), time)
        {
            return parts;
        }
        self.energies.parts(&state(), time, self.engine.motions.found().as_ref())
    }

    /// Changes the state between two steps.
    ///
    /// Examples are wrapping coordinates into a periodic box, or drawing new momenta for a thermostat or a Markov chain.
    /// The time and the number of steps are kept. [`Run::on_crossing`] changes states within steps.
    ///
    /// The run continues bitwise identically to a new run from the changed state [at this time](Run::at_time).
    /// [`Run::state`] returns the changed state until the next step. A [watch](Run::watch_energy) continues with the
    /// energy of the changed state.
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
    /// let mut run = Rotor.run(Phase::new([0.0_f64], [5.0]), 0.01)?;
    /// run.advance(1_000)?;
    /// run.map_state(|state| state.q[0] = state.q[0].rem_euclid(std::f64::consts::TAU))?;
    /// run.advance(1_000)?;
    /// assert_eq!(run.time(), 20.0);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// The run is unchanged after an error.
    ///
    /// - Those of a new run from the changed state, for example [`Error::Start`] if it is not finite.
    /// - [`Error::Resized`]: the changed state has another number of coordinates.
    /// - [`Error::WithinStep`]: [`Run::advance_to`] stopped at a time that is not the end of a step.
    pub fn map_state(&mut self, map: impl FnOnce(&mut Phase<C>)) -> Result<(), Error> {
        if let Some((time, _)) = self.between {
            return Err(Error::WithinStep { time, present: self.time_at_step() });
        }
        let mut state = self.state_at_step();
        change(&mut state, self.clock.h, map)?;
        let time = self.time_at_step();
        let motions = self.engine.reloaded(vec![(self.engine.constants_of(0), &state)]);
        let parts = match motions.energy(time) {
            Some(parts) => parts,
            None => self.energies.parts(&state, time, motions.found().as_ref()),
        };
        // Where the start is unchecked, its time is not settled.
        if !self.start_unchecked {
            parts.admissible(time)?;
        }
        self.between = None;
        self.watch = self.watch.map(|Watch { bound, .. }| Watch::new(bound, parts));
        self.counted = self.counts();
        if let Some(elapsed) = self.engine.elapsed(self.since_opened(), 0) {
            self.opened_at = durations(self.opened_at, elapsed);
        }
        self.engine.restart(motions);
        self.opened = self.clock.steps;
        Ok(())
    }

    /// The state a while into the last step, which [`Run::advance`] took alone and which began at `from`: on the
    /// polynomial of a method that has one, and else after a shorter step; and its time. The run itself stays where it is.
    ///
    /// # Errors
    /// As [`Run::advance`] for this step.
    pub(crate) fn within(&mut self, from: &Phase<C>, duration: f64) -> Result<(f64, Phase<C>), Error> {
        let mut state = from.clone();
        let time = self.read_within(core::slice::from_ref(from), duration, |completed, shown| {
            show(completed, shown, 0, &mut state);
        })?;
        Ok((time, state))
    }

    /// Reads all lanes a while into the last step, from the lanes at its beginning. Each has a time if that is part of
    /// the state.
    pub(crate) fn lanes_within(&mut self, from: &[Phase<C>], duration: f64) -> Result<Vec<Lane<C>>, Error> {
        let mut lanes = Vec::with_capacity(from.len());
        self.read_within(from, duration, |completed, shown| {
            for (number, point) in from.iter().enumerate() {
                let mut point = point.clone();
                show(completed, shown, number, &mut point);
                lanes.push((point, elapsed(completed, shown, number)));
            }
        })?;
        Ok(lanes)
    }

    /// Reads the motion a while into the last step; the time there.
    fn read_within(
        &mut self,
        from: &[Phase<C>],
        duration: f64,
        read: impl FnOnce(&dyn Motions, Option<&dyn Motions>),
    ) -> Result<f64, Error> {
        let step = self.clock.steps;
        let clock = Clock { steps: step.saturating_sub(1), ..self.clock };
        let since = self.since_opened();
        let since = Clock { steps: since.steps.saturating_sub(1), ..since };
        let lanes = from.iter().map(|point| point as &dyn Point).collect();
        match self.engine.within(lanes, since, duration, read) {
            Ok(elapsed) => Ok(elapsed.map_or(clock.at(clock.steps) + duration, |elapsed| self.time_of(elapsed))),
            Err(Some(reason)) => {
                Err(Error::NotSolved { method: self.method, step, time: clock.at(clock.steps), reason })
            }
            Err(None) => Err(Error::Diverged(Divergence {
                step,
                time: clock.at(clock.steps) + duration,
                ..clock.divergence(&from[0], &self.tried_lane(0))
            })),
        }
    }

    /// The state in the middle of the current step, in [`Run::form`].
    #[cfg(feature = "checkpoint")]
    pub(crate) fn unfinished(&self) -> Phase<C> {
        self.unfinished_lane(0)
    }

    /// A lane in the middle of the current step, in [`Run::form`].
    pub(crate) fn unfinished_lane(&self, lane: usize) -> Phase<C> {
        let mut point = self.shape.clone();
        self.engine.unfinished(self.form(), lane, &mut point);
        point
    }

    /// The coordinates of states in the middle of the current step.
    fn form(&self) -> Form {
        Form::after(self.since_opened().steps)
    }

    /// Continues with lanes in the middle of the current step, in [`Run::form`].
    pub(crate) fn resume_lanes(&mut self, state: &Phase<C>, carried: &[Phase<C>]) {
        self.engine.resume(self.form(), &lanes(state, carried));
    }

    /// Continues with other lanes between two steps.
    pub(crate) fn reopen_lanes(&mut self, state: &Phase<C>, carried: &[Phase<C>]) {
        let lanes = lanes(state, carried).into_iter().enumerate();
        let lanes = lanes.map(|(lane, point)| (self.engine.constants_of(lane), point)).collect();
        let motions = self.engine.reloaded(lanes);
        self.counted = self.counts();
        self.engine.restart(motions);
        self.opened = self.clock.steps;
    }

    /// Goes back to motions of the same lanes, after this number of steps.
    pub(crate) fn go_back(&mut self, steps: u64, motions: &dyn Motions) {
        self.engine.go_back(motions);
        self.clock.steps = steps;
    }

    /// A lane at the end of the last step.
    pub(crate) fn lane(&self, lane: usize) -> Phase<C> {
        let mut point = self.shape.clone();
        self.engine.lane(self.since_opened(), lane, &mut point);
        point
    }

    /// The first two lanes at the end of the last step.
    #[cfg(feature = "check")]
    pub(crate) fn state_and_next_lane(&self) -> [Phase<C>; 2] {
        let mut points = [self.shape.clone(), self.shape.clone()];
        self.engine.read(self.since_opened(), |completed, shown| {
            for (lane, point) in points.iter_mut().enumerate() {
                show(completed, shown, lane, point);
            }
        });
        points
    }

    /// A lane in the middle of the current step, in the coordinates of the motion.
    #[cfg(feature = "check")]
    pub(crate) fn own_lane(&self, lane: usize) -> Phase<C> {
        let mut point = self.shape.clone();
        self.engine.unfinished(Form::Own, lane, &mut point);
        point
    }

    /// Returns the time of a lane at the end of the last step, where this is part of the state.
    pub(crate) fn elapsed_in_lane(&self, lane: usize) -> Option<[f64; 2]> {
        self.engine.elapsed(self.since_opened(), lane)
    }

    /// A lane at the end of the step that was tried last.
    pub(crate) fn tried_lane(&self, lane: usize) -> Phase<C> {
        let mut point = self.shape.clone();
        self.engine.completed.store(lane, &mut point);
        point
    }

    pub(crate) fn energies(&self) -> Arc<dyn Energies<C>> {
        self.energies.clone()
    }
}

/// The points in the lanes after a state, and their own constants if they have some.
pub(crate) type Behind<'p, C, P> = (&'p [Phase<C>], Vec<P>);

/// A point in a lane, and what this has of a time that is part of the state.
pub(crate) type Lane<C> = (Phase<C>, Option<[f64; 2]>);

/// The contents of the lanes of a motion, after the state.
fn lanes<'p, C: Coords>(state: &'p Phase<C>, carried: &'p [Phase<C>]) -> Vec<&'p dyn Point> {
    // A plain loop: it is compiled for every system.
    let mut lanes: Vec<&dyn Point> = Vec::with_capacity(1 + carried.len());
    lanes.push(state);
    for point in carried {
        lanes.push(point);
    }
    lanes
}

impl<C: Coords> Clone for Run<C> {
    fn clone(&self) -> Self {
        let (engine, energies) = (self.engine.clone(), self.energies.clone());
        Self { engine, energies, shape: self.shape.clone(), between: self.between.clone(), ..*self }
    }
}

impl<C: Coords> fmt::Debug for Run<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run")
            .field("method", &self.method)
            .field("step", &self.clock.h)
            .field("steps", &self.clock.steps)
            .field("time", &self.time())
            .field("state", &Abridged(&self.state()))
            .finish()
    }
}
