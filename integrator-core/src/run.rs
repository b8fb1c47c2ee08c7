//! One trajectory: integer time, stages merged across steps, stopped where it leaves the finite numbers.

#[cfg(feature = "checkpoint")]
use crate::checkpoint::Origin;
#[cfg(debug_assertions)]
use crate::stated::hold_at_start;
use crate::{
    coords::Coords,
    energies::{Energies, energies, energy},
    engine::{Clock, Engine, Solo},
    error::{Divergence, Error},
    fixed::is_power_of_two,
    hamiltonian::{Hamiltonian, Prepared, Shaped},
    instruction_set::InstructionSet,
    method::{Described, Method},
    phase::Phase,
    real::Real,
    samples::Samples,
    slot::Keep,
};
use alloc::{boxed::Box, sync::Arc};
use core::fmt;

/// Whether a run may begin at `start` with step `h`.
///
/// # Errors
/// A step that is zero or not finite; a start that is not finite, whose `q` and `p` differ in length, or that has no place on
/// its grid.
pub(crate) fn admissible<C: Coords>(start: &Phase<C>, h: f64) -> Result<(), Error> {
    if h == 0.0 || !h.is_finite() {
        return Err(Error::Step { h });
    }
    let (positions, momenta) = (start.q.flat().len(), start.p.flat().len());
    if positions != momenta {
        return Err(Error::Length { positions, momenta });
    }
    for (coordinate, leaves) in [("q", start.q.flat()), ("p", start.p.flat())] {
        for (index, leaf) in leaves.iter().enumerate() {
            let (value, limit) = (leaf.to_f64(), leaf.limit());
            if !value.is_finite() {
                return Err(Error::Start { coordinate, index, value });
            }
            let Some(spacing) = leaf.spacing() else { continue };
            if !is_power_of_two(spacing) {
                return Err(Error::Grid { coordinate, index, spacing });
            }
            if value.abs() >= limit {
                return Err(Error::GridRange { coordinate, index, value, spacing, limit });
            }
        }
    }
    Ok(())
}

/// Whether a run with a method may begin at `start` with step `h`.
///
/// # Errors
/// As [`admissible`]; a reversible start and a method that is not symmetric; what the method itself refuses.
pub(crate) fn admissible_with<C: Coords>(method: impl Described, start: &Phase<C>, h: f64) -> Result<(), Error> {
    method.admissible()?;
    let facts = method.facts();
    if C::Leaf::REVERSIBLE && !facts.symmetric {
        return Err(Error::NotSymmetric { composition: facts.name });
    }
    admissible(start, h)
}

/// The engine of a run whose steps are computed in `R`.
fn engine<H: Hamiltonian, X: Method<H>, R: Real, K: Keep>(
    method: X,
    parameters: H::Parameters<f64>,
    start: Phase<Shaped<H, K>>,
) -> Box<dyn Engine<Shaped<H, K>>> {
    let parameters = Arc::new(parameters);
    let energies = energies(parameters.clone(), energy::<H, R, K>);
    Box::new(Solo::new(method.constants(parameters), start, X::moves::<R, K>(), energies))
}

/// A trajectory under way, made by [`Hamiltonian::run`]. Its type names the coordinates alone, so it can be stored.
pub struct Run<C: Coords> {
    engine: Box<dyn Engine<C>>,
    pub(crate) clock: Clock,
    method: &'static str,
    /// How often a step evaluates the force, where that is known beforehand.
    forces: Option<usize>,
    /// Whether the energy of the start is still to be looked at, where it depends on the time that the clock starts at.
    start_unseen: bool,
    /// Whose checkpoints its own are.
    #[cfg(feature = "checkpoint")]
    pub(crate) origin: Origin,
}

impl<C: Coords> Run<C> {
    pub(crate) fn start<H, X, K>(system: &H, method: X, start: Phase<C>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Method<H>,
        K: Keep,
        H::Coords: Coords<With<K> = C>,
    {
        admissible_with(method, &start, h)?;
        #[cfg(debug_assertions)]
        let state = start.clone();
        let mut run = Self::going_on::<H, X, K>(system, method, start, Clock { t0: 0.0, h, steps: 0 })?;
        run.start_unseen = true;
        if H::AUTONOMOUS {
            run.see_start()?;
        }
        #[cfg(debug_assertions)]
        hold_at_start::<H, K>(system, &system.parameters(state.q.length()), &state)?;
        Ok(run)
    }

    /// Looks at the energy of the start, once.
    ///
    /// # Errors
    /// [`Error::Energy`]
    fn see_start(&mut self) -> Result<(), Error> {
        if self.start_unseen {
            self.engine.energies().parts(&self.state(), self.time()).admissible(self.time())?;
            self.start_unseen = false;
        }
        Ok(())
    }

    /// A run from a state in the middle of the step that the clock tells.
    ///
    /// # Errors
    /// [`Error::Parameters`], where a prepared constant is not finite and the motion is not.
    pub(crate) fn going_on<H, X, K>(system: &H, method: X, start: Phase<C>, clock: Clock) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Method<H>,
        K: Keep,
        H::Coords: Coords<With<K> = C>,
    {
        let parameters = system.parameters(start.q.length());
        let constants = H::Parameters::<f64>::not_finite(&parameters);
        // Known when this is compiled, so that nothing is compiled for the others.
        let mut engine = if const { X::CLONED } {
            match InstructionSet::chosen() {
                InstructionSet::Baseline => engine::<H, X, K::Plain, K>(method, parameters, start),
                InstructionSet::Avx512 if X::WIDE => engine::<H, X, K::Avx512, K>(method, parameters, start),
                InstructionSet::Fused | InstructionSet::Avx512 => {
                    engine::<H, X, K::Fused, K>(method, parameters, start)
                }
            }
        } else {
            engine::<H, X, K::Plain, K>(method, parameters, start)
        };
        engine.share_among(None);
        let run = Self {
            engine,
            clock,
            method: method.facts().name,
            forces: method.forces(),
            start_unseen: false,
            #[cfg(feature = "checkpoint")]
            origin: Origin::of::<H>(method.facts()),
        };
        // An infinite constant may be meant, such as a cutoff beyond all distances: what counts is what it does.
        if !constants.is_empty() && run.is_spoilt() {
            return Err(Error::Parameters { constants });
        }
        Ok(run)
    }

    /// Whether a force or a velocity is not finite: then nor is a step of no length at all.
    fn is_spoilt(&self) -> bool {
        let mut clock = Clock { h: 0.0, ..self.clock };
        self.engine.boxed_clone().advance(&mut clock, 1);
        clock.steps == self.clock.steps
    }

    /// Starts the clock at `t0` instead of 0. A `t0` that is not finite is reported by the first `advance`.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.clock.t0 = t0;
        self
    }

    /// Uses at most so many threads instead of all that the machine has; no result depends on it. Lattices of many sites
    /// and the pairs of thousands of bodies are shared out among threads, and nothing else.
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
    /// [`Run::time`] and [`Run::state`] tell it. [`Error::Time`], [`Error::Clock`] and [`Error::Steps`] leave the run as
    /// it was, and so does [`Error::Energy`], which the first call returns where `H` reads the time and has no value at
    /// the start.
    ///
    /// # Panics
    /// Where your own functions would. A program that catches the panic finds the run at the last step before it, as after
    /// a divergence; the message is printed twice where this step has to be found in a block of steps. Without the feature
    /// `std`, the run stays up to 1023 steps before it.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let end = self.clock.end(steps)?;
        self.see_start()?;
        self.engine.advance(&mut self.clock, steps);
        if self.clock.steps < end {
            let clock = self.clock;
            return Err(match self.engine.unsolved() {
                Some(reason) => Error::NotSolved {
                    method: self.method,
                    step: clock.steps.saturating_add(1),
                    time: clock.at(clock.steps),
                    reason: reason.clone(),
                },
                None => clock.divergence(&self.state()).into(),
            });
        }
        Ok(())
    }

    /// The time, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.clock.at(self.clock.steps)
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
    /// gradient of the squared force count twice; or counted, where the number differs from step to step, with a Jacobian
    /// of an implicit method once for each of its columns.
    pub fn evaluations(&self) -> u64 {
        match self.forces {
            Some(forces) => self.clock.steps.saturating_mul(forces as u64),
            None => self.engine.evaluations().unwrap_or(0),
        }
    }

    /// The state at [`Run::time`]: the step under way is completed on a copy, the run itself does not change.
    pub fn state(&self) -> Phase<C> {
        self.engine.state(self.clock)
    }

    /// The energy `T + V` at [`Run::time`].
    pub fn energy(&self) -> f64 {
        self.engine.energies().energy(&self.state(), self.time())
    }

    /// An iterator over the present state and then the state after every `interval` steps.
    pub fn samples(self, interval: u64) -> Samples<C> {
        Samples::new(self, interval)
    }

    /// The state a while into the last step, which [`Run::advance`] took alone and which began at `from`: on the polynomial
    /// of a method that has one, and else after a shorter step. The run itself stays where it is.
    ///
    /// # Errors
    /// As [`Run::advance`] for this step.
    pub(crate) fn within(&mut self, from: &Phase<C>, duration: f64) -> Result<Phase<C>, Error> {
        let step = self.clock.steps;
        let clock = Clock { steps: step.saturating_sub(1), ..self.clock };
        self.engine.within(from, clock, duration).map_err(|unsolved| match unsolved {
            Some(reason) => Error::NotSolved { method: self.method, step, time: clock.at(clock.steps), reason },
            None => {
                Error::Diverged(Divergence { step, time: clock.at(clock.steps) + duration, ..clock.divergence(from) })
            }
        })
    }

    /// The state in the middle of the step under way.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn unfinished(&self) -> Phase<C> {
        self.engine.unfinished()
    }

    pub(crate) fn energies(&self) -> Arc<dyn Energies<C>> {
        self.engine.energies()
    }
}

impl<C: Coords> Clone for Run<C> {
    fn clone(&self) -> Self {
        Self { engine: self.engine.boxed_clone(), ..*self }
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
