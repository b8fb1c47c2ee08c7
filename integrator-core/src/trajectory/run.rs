//! One trajectory: integer time, stages merged across steps, stopped where it leaves the finite numbers.

#[cfg(debug_assertions)]
use crate::system::user_energies::hold_at_start;
#[cfg(feature = "checkpoint")]
use crate::trajectory::checkpoint::Origin;
#[cfg(feature = "std")]
use crate::trajectory::progress::{Progress, in_portions};
use crate::{
    error::{Divergence, Error},
    hamiltonian::Hamiltonian,
    state::{
        clock::{Clock, durations, time_after},
        coords::Coords,
        phase::Phase,
        point::Point,
        precision::Precision,
    },
    system::{
        counts::{Counts, OwnSteps},
        energy::{Energies, Parts, energies},
        motion::Prepared,
    },
    trajectory::{
        admissible::{admissible_with, change},
        dispatch::{Carried, Nothing, engine},
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

/// A trajectory under way, made by [`Hamiltonian::run`]. Its type names the coordinates alone, so it can be stored.
pub struct Run<C: Coords> {
    pub(crate) engine: Engine,
    energies: Arc<dyn Energies<C>>,
    /// A state of the size of the run, where the type does not tell it.
    shape: Phase<C>,
    pub(crate) clock: Clock,
    /// How many steps were done when the state was last changed from outside.
    pub(crate) opened: u64,
    /// The time, where it is part of the state, when this was last changed from outside: a sum of two numbers.
    pub(crate) opened_at: [f64; 2],
    /// Where the run is shown while it stands at the step before.
    between: Option<(f64, Phase<C>)>,
    pub(crate) watch: Option<Watch>,
    pub(crate) autonomous: bool,
    method: &'static str,
    /// How often a step evaluates the force, where that is known beforehand.
    forces: Option<usize>,
    /// What steps before `opened` have counted.
    counted: Counts,
    /// Whether the energy of the start is still to be checked, where it depends on the time that the clock starts at.
    start_unchecked: bool,
    /// Whose checkpoints its own are.
    #[cfg(feature = "checkpoint")]
    pub(crate) origin: Origin,
}

/// What runs of one kind of system by one method have in common.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    pub(crate) autonomous: bool,
    pub(crate) method: &'static str,
    pub(crate) forces: Option<usize>,
}

impl<C: Coords> Run<C> {
    pub(crate) fn start<H, X, K>(system: &H, method: X, start: Phase<C>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Method<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        admissible_with::<H, _>(method, &start, h)?;
        Self::carrying::<H, X, K, Nothing>(system, method, start, (&[], Vec::new()), h)
    }

    /// A run whose motion carries points in lanes behind those of the state, and perhaps constants of theirs.
    pub(crate) fn carrying<H, X, K, V>(
        system: &H,
        method: X,
        start: Phase<C>,
        carried: Behind<'_, C, H::Parameters<f64>>,
        h: f64,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Method<H>,
        K: Precision,
        V: Carried,
        H::Coords: Coords<With<K> = C>,
    {
        let clock = Clock { t0: 0.0, h, steps: 0 };
        let mut run = Self::from_unfinished::<H, X, K, V>(system, method, start, carried, clock, 0)?;
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

    /// A run from a state in the middle of the step under way at the clock, where the state was last changed from
    /// outside after
    /// `opened` steps.
    ///
    /// # Errors
    /// [`Error::Parameters`], where a prepared constant is not finite and the motion is not; in builds with debug
    /// assertions [`Error::Misread`].
    pub(crate) fn from_unfinished<H, X, K, V>(
        system: &H,
        method: X,
        start: Phase<C>,
        (carried, slopes): Behind<'_, C, H::Parameters<f64>>,
        clock: Clock,
        opened: u64,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Method<H>,
        K: Precision,
        V: Carried,
        H::Coords: Coords<With<K> = C>,
    {
        system.admissible(start.q.length())?;
        let parameters = system.parameters(start.q.length());
        #[cfg(debug_assertions)]
        let held = hold_at_start::<H, K>(system, &parameters, &start, clock.at(clock.steps));
        let constants = H::Parameters::<f64>::not_finite(&parameters);
        #[cfg(feature = "checkpoint")]
        let origin = Origin::of::<H>(method.facts(), &parameters);
        let parameters = Arc::new(parameters);
        let mut engine = engine::<H, X, K, V>(method, parameters.clone(), slopes, lanes(&start, carried));
        engine.share_among(None);
        let run = Self {
            autonomous: H::AUTONOMOUS,
            method: method.facts().name,
            forces: method.forces(),
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

    /// A run of which no more is known than how it goes on: a member of an ensemble has no name of its own.
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
            forces: None,
            counted: Counts::default(),
            start_unchecked: false,
            #[cfg(feature = "checkpoint")]
            origin: Origin::UNKNOWN,
        }
    }

    /// The run of a member of an ensemble, with what this tells of its method and system.
    #[cfg(feature = "std")]
    pub(crate) fn known_as(
        self,
        Kind { autonomous, method, forces }: Kind,
        #[cfg(feature = "checkpoint")] origin: Origin,
    ) -> Self {
        Self {
            autonomous,
            method,
            forces,
            #[cfg(feature = "checkpoint")]
            origin,
            ..self
        }
    }

    /// The clock of the engine, which begins where the state was last changed from outside.
    fn since_opened(&self) -> Clock {
        self.clock.since(self.opened)
    }

    /// Starts the clock at `t0` instead of 0. A `t0` that is not finite is reported by the first `advance`.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.clock.t0 = t0;
        self
    }

    /// Uses at most so many threads instead of all that the machine has; no result depends on it. Lattices of many
    /// sites and the pairs of hundreds of bodies are shared out among threads, and nothing else.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.engine.share_among(Some(threads));
        self
    }

    /// Whether the clock started at a time.
    pub(crate) fn check_clock(&self) -> Result<(), Error> {
        self.clock.check()
    }

    /// Takes `steps` steps. In any portions, the result is the same bit for bit.
    ///
    /// # Errors
    /// [`Error::Diverged`] if the state leaves the finite numbers; the run then stays at the last finite state, and
    /// [`Run::time`] and [`Run::state`] tell it. [`Error::Time`], [`Error::Clock`] and [`Error::Steps`] leave the run
    /// as it was, and so does [`Error::Energy`], which the first call returns where `H` reads the time and has no value
    /// at the start. [`Error::EnergyStrayed`] if a [watch](Run::watch_energy) says so; the run stays at the last step
    /// within its bound.
    ///
    /// # Panics
    /// Where your own functions would. A program that catches the panic finds the run at the last step before it, as
    /// after a divergence; the message is printed twice where this step has to be found in a block of steps. Without
    /// the feature
    /// `std`, the run stays up to 1023 steps before it.
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

    /// As [`Run::advance`], and tells `progress` about ten times a second how far it is, how long that took, and how long the
    /// rest will take. It stops when it is told to break, as by a key that is pressed, and returns how many steps were taken:
    /// the run is where they led, and goes on from there as if nothing had happened.
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

    /// Takes steps until so many are done.
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
        self.state_at_step().divergence(&self.tried(), self.clock).at_own_time(self.time_in_state())
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

    /// The time, `t0 + n·h`; what was integrated, where the method has a time of its own, such as
    /// [`Logarithmic`](crate::Logarithmic); and what [`Run::advance_to`] was called with.
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

    /// The step `h`.
    pub fn step(&self) -> f64 {
        self.clock.h
    }

    /// How many steps were taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// How often the steps of this run have evaluated the force: that of a step times the steps, where kicks along the
    /// gradient of the squared force count twice; or counted, where the number differs from step to step, with a
    /// Jacobian of an implicit method once for each of its columns, and a polynomial of [`Taylor`](crate::taylor::Taylor) once for
    /// each of its orders: an order of the force takes as many products as there are lower ones.
    pub fn evaluations(&self) -> u64 {
        match self.forces {
            Some(forces) => self.clock.steps.saturating_mul(forces as u64),
            None => self.counts().evaluations,
        }
    }

    /// The steps that the method took by itself, where it does: those of [`Taylor`](crate::taylor::Taylor), which are the
    /// polynomials that the run has left behind. The present one is under way: where the motion is a polynomial of the time, it
    /// covers all of it, and no step is ever completed.
    pub fn own_steps(&self) -> Option<OwnSteps> {
        self.counts().own_steps
    }

    /// What all steps have counted.
    fn counts(&self) -> Counts {
        self.counted.and(self.engine.motions.counts().unwrap_or_default())
    }

    /// The state at [`Run::time`]: the step under way is completed on a copy, the run itself does not change.
    pub fn state(&self) -> Phase<C> {
        match &self.between {
            Some((_, state)) => state.clone(),
            None => self.state_at_step(),
        }
    }

    /// The state at the end of the last step.
    pub(crate) fn state_at_step(&self) -> Phase<C> {
        let mut state = self.shape.clone();
        self.engine.state(self.since_opened(), &mut state);
        state
    }

    /// Where the last step led that was tried.
    fn tried(&self) -> Phase<C> {
        self.tried_lane(0)
    }

    /// The energy `T + V` at [`Run::time`].
    ///
    /// It is NaN or infinite where your functions have no value, as the logarithm left of zero: steps read forces
    /// alone, which may be finite on the other side of a pole that a step has jumped over. [`Run::watch_energy`] stops
    /// a run there.
    pub fn energy(&self) -> f64 {
        self.parts().total
    }

    /// The kinetic energy `T` at [`Run::time`]; where the parts of H have names, the energy of the first one.
    pub fn kinetic(&self) -> f64 {
        self.parts().kinetic
    }

    /// The potential energy `V` at [`Run::time`]; where the parts of H have names, the energy of all but the first one.
    pub fn potential(&self) -> f64 {
        self.parts().potential
    }

    /// A function of the state that the system says is conserved, by its name: [`#[invariant]`](macro@crate::hamiltonian#invariants)
    /// on a function of the impl.
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
    /// [`Error::NoInvariant`], which lists those that there are.
    pub fn invariant(&self, name: &str) -> Result<f64, Error> {
        self.energies.invariant_named(name, &self.state())
    }

    pub(crate) fn parts(&self) -> Parts {
        self.energies.parts(&self.state(), self.time(), self.engine.motions.found().as_ref())
    }

    /// Changes the state between two steps: coordinates that are wrapped into a periodic box, momenta that are drawn
    /// anew by a thermostat or for a Markov chain. Time and the number of steps go on.
    ///
    /// From there, the run has the bits of a new one that starts from the changed state [at this time](Run::at_time), and
    /// [`Run::state`] returns this very state until the next step. A [watch](Run::watch_energy) goes on with its energy.
    ///
    /// [`Run::on_crossing`] changes states within steps.
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
    /// What a run from the new state would be refused for, such as [`Error::Start`] where it is not finite, and
    /// [`Error::Resized`] if it has another number of coordinates; [`Error::WithinStep`] after [`Run::advance_to`] a time that
    /// is not the end of a step. The run stays as it was.
    pub fn map_state(&mut self, map: impl FnOnce(&mut Phase<C>)) -> Result<(), Error> {
        if let Some((time, _)) = self.between {
            return Err(Error::WithinStep { time, present: self.time_at_step() });
        }
        let mut state = self.state_at_step();
        change(&mut state, self.clock.h, map)?;
        let time = self.time_at_step();
        let parts = self.energies.parts(&state, time, self.engine.motions.found().as_ref());
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
        self.engine.restart(vec![(self.engine.constants_of(0), &state)]);
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

    /// The same of all lanes, from those where the step began, each with what it has of a time that is part of the state.
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
                ..clock.divergence(&from[0], &self.tried())
            })),
        }
    }

    /// The state in the middle of the step under way, in [`Run::form`].
    #[cfg(feature = "checkpoint")]
    pub(crate) fn unfinished(&self) -> Phase<C> {
        self.unfinished_lane(0)
    }

    /// A lane in the middle of the step under way, in [`Run::form`].
    pub(crate) fn unfinished_lane(&self, lane: usize) -> Phase<C> {
        let mut point = self.shape.clone();
        self.engine.unfinished(self.form(), lane, &mut point);
        point
    }

    /// The coordinates of states in the middle of the step under way.
    fn form(&self) -> Form {
        Form::after(self.since_opened().steps)
    }

    /// Goes on with lanes in the middle of the step under way, in [`Run::form`].
    pub(crate) fn resume_lanes(&mut self, lanes: &[Phase<C>]) {
        let lanes: Vec<_> = lanes.iter().map(|point| point as &dyn Point).collect();
        self.engine.resume(self.form(), &lanes);
    }

    /// Goes back to motions of the same lanes, after so many steps.
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

    /// What a lane has of the time at the end of the last step, where this is part of the state.
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

/// The points in lanes behind a state, and the constants that go with these, where they have some of their own.
pub(crate) type Behind<'p, C, P> = (&'p [Phase<C>], Vec<P>);

/// A point in a lane, and what this has of a time that is part of the state.
pub(crate) type Lane<C> = (Phase<C>, Option<[f64; 2]>);

/// What a motion carries in its lanes, behind the state.
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
            .field("state", &self.state())
            .finish()
    }
}
