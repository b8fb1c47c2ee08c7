//! Systems and methods without their types, as the logic of checks sees them: states are flat vectors.
//!
//! Always true: all that is compiled for each system and method is what takes a state from one time to another;
//! ladders, fits and judgements are compiled once, in this crate.

use crate::{
    check::{
        CheckError,
        oracle::{
            compensated_steps::CompensatedSteps,
            composed_reference::composed_steps,
            edges,
            series::{is_written, series},
        },
        start::Start,
        statistics::path::{Path, Scale},
    },
    error::Error,
    hamiltonian::Hamiltonian,
    methods::taylor::Taylor,
    state::{
        compensated::Compensated,
        flat::{Flat, flat, shaped},
        phase::Phase,
    },
    system::{Shaped, motion::Motion},
    trajectory::{
        method::{Facts, Method},
        run::Run,
    },
};

/// The part of a step that shows how fast time passes at the start: what is left of its change within is a thousandth.
const SHORT: f64 = 1.0 / 1024.0;

/// A system, as the search for its exact motion sees it.
pub(crate) trait Exact {
    /// Whether the clock decides on pieces of the Hamiltonian.
    fn piecewise_in_time(&self) -> bool;

    /// Whether there are recurrences for a series.
    fn is_expanded(&self) -> bool;

    /// The motion by Taylor polynomials, as [`series`] makes it.
    fn series(&self, start: &Start<Vec<f64>>, span: f64, method: Taylor, samples: u64) -> Option<(Path, Scale)>;

    /// Steps of `h` by the flows of the system, as [`composed_steps`] takes them.
    fn composed_steps(&self, start: &Start<Vec<f64>>, steps: (f64, u64), fractions: &[f64], show: &mut dyn FnMut(Flat));
}

/// A method on a system.
pub(crate) trait Stepper {
    fn facts(&self) -> Facts;

    /// Whether the Hamiltonian does not read the time.
    fn autonomous(&self) -> bool;

    /// The system alone.
    fn exact(&self) -> &dyn Exact;

    /// The path of a compensated run in steps of `h`, with `steps` steps in each part.
    fn path(&self, start: &Start<Vec<f64>>, h: f64, parts: u64, steps: u64) -> Result<Path, Error>;

    /// The spacing of edges in steps, as [`edges::spacing`] finds it; zero where the clock decides on no pieces.
    fn spacing(&self, points: &[Flat], t0: f64, h: f64, steps: u64) -> Result<u64, CheckError>;
}

/// A system, and a point in the shape of its coordinates.
pub(crate) struct Motions<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) shape: &'s Phase<H::Coords>,
}

/// A system with a method, and a point in the shape of its coordinates.
pub(crate) struct Steps<'s, H: Hamiltonian, X> {
    motions: Motions<'s, H>,
    method: X,
}

impl<'s, H: Hamiltonian, X> Steps<'s, H, X> {
    pub(crate) fn new(system: &'s H, method: X, shape: &'s Phase<H::Coords>) -> Self {
        Self { motions: Motions { system, shape }, method }
    }
}

impl<H: Hamiltonian, X: Method<H>> Steps<'_, H, X> {
    /// The path in steps that are equal in a time of the method's own, about `h` at the start, at the same times as that in
    /// steps of `h`.
    fn path_in_own_time(&self, start: &Start<Vec<f64>>, h: f64, parts: u64, steps: u64) -> Result<Path, Error> {
        let Start { phase, time } = self.motions.start(start);
        let state = Phase::compensated(phase.q, phase.p);
        let begin = |h| {
            let run = Run::start::<H, X, Compensated<f64>>(self.motions.system, self.method, state.clone(), h);
            Ok::<_, Error>(run?.at_time(time))
        };
        let short = h * SHORT;
        let mut probe = begin(short)?;
        probe.advance(1)?;
        let mut run = begin(h * short / (probe.time() - time))?;
        let mut ends = (1..=parts).map(|part| time + (part * steps) as f64 * h);
        Path::of_run(start.phase.clone(), parts, &mut || {
            run.advance_to(ends.next().unwrap_or(time))?;
            Ok(flat(&run.state()))
        })
    }
}

impl<H: Hamiltonian> Motions<'_, H> {
    fn start(&self, start: &Start<Vec<f64>>) -> Start<H::Coords> {
        Start { phase: shaped(self.shape, &start.phase), time: start.time }
    }
}

impl<H: Hamiltonian> Exact for Motions<'_, H> {
    fn piecewise_in_time(&self) -> bool {
        H::PIECEWISE_IN_TIME
    }

    fn is_expanded(&self) -> bool {
        is_written::<H>()
    }

    fn series(&self, start: &Start<Vec<f64>>, span: f64, method: Taylor, samples: u64) -> Option<(Path, Scale)> {
        series(self.system, &self.start(start), span, method, samples)
    }

    fn composed_steps(
        &self,
        start: &Start<Vec<f64>>,
        steps: (f64, u64),
        fractions: &[f64],
        show: &mut dyn FnMut(Flat),
    ) {
        composed_steps(self.system, self.start(start), steps, fractions, show);
    }
}

impl<H: Hamiltonian, X: Method<H>> Stepper for Steps<'_, H, X> {
    fn facts(&self) -> Facts {
        self.method.claims()
    }

    fn autonomous(&self) -> bool {
        H::AUTONOMOUS
    }

    fn exact(&self) -> &dyn Exact {
        &self.motions
    }

    fn path(&self, start: &Start<Vec<f64>>, h: f64, parts: u64, steps: u64) -> Result<Path, Error> {
        if const { <X::Motion<f64, f64> as Motion<Shaped<H, f64>, X::Constants>>::TIMED } {
            return self.path_in_own_time(start, h, parts, steps);
        }
        let mut run = CompensatedSteps::new(self.motions.system, self.method, self.motions.start(start), h)?;
        Path::of_run(start.phase.clone(), parts, &mut || run.advance(steps))
    }

    fn spacing(&self, points: &[Flat], t0: f64, h: f64, steps: u64) -> Result<u64, CheckError> {
        if H::PIECEWISE_IN_TIME {
            let points: Vec<_> = points.iter().map(|point| shaped(self.motions.shape, point)).collect();
            edges::spacing(self.motions.system, &points, t0, h, steps)
        } else {
            Ok(0)
        }
    }
}
