//! Fictitious time steps among the splittings of a choice.
//!
//! The search counts steps over a span of physical time. Here, a step of the search is one of fictitious time, in units
//! of the mean rate of a first run over the span. About the same number of steps hence covers the span.

use super::{
    Split,
    candidate::Candidate,
    splitting::{Energies, Erased, Measured, Splitting, of_system},
};
use crate::{
    check::{
        oracle::reference::Reference,
        start::Start,
        statistics::{
            path::{Path, Scale},
            points::run,
        },
    },
    composition::catalogue::{SofroniouSpaletta6S11, SofroniouSpaletta8, SofroniouSpaletta10, Suzuki4},
    error::{Error, Unsolved},
    hamiltonian::Hamiltonian,
    methods::pace::{Logarithmic, Paced, Rated, TimeTransformed},
    state::{coords::Coords, flat::Flat},
    trajectory::method::Method,
};

/// The number of steps of the first run that a pace is taken from, about.
const PILOT: f64 = 512.0;

/// A system with the step-size control of [`Logarithmic`], as a splitting for [`choose_among`](super::choose_among).
///
/// The candidates are compositions of symmetric steps, of orders 4, 6, 8 and 10.
///
/// ```
/// use integrator_core::{check::{Goal, LogarithmicSteps, choose_among}, prelude::*};
///
/// struct Comet;
///
/// #[hamiltonian]
/// impl Comet {
///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let start = Phase::new([0.1, 0.0], [0.0, 19_f64.sqrt()]);
/// let ranking = choose_among(&[&Comet, &LogarithmicSteps(&Comet)], start, 20.0, Goal::Trajectory(1e-6))?;
/// assert_eq!(ranking.best().splitting.to_string(), "Comet (Logarithmic)");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LogarithmicSteps<'s, H>(pub &'s H);

/// A system with the step-size control of [`Paced`], as a splitting; compare [`LogarithmicSteps`].
#[derive(Clone, Copy, Debug)]
pub struct PacedSteps<'s, H>(pub &'s H);

/// The candidates by some methods over the compositions, in units of a pace.
type Begins<'s, H, C> = fn(&'s H, f64) -> Vec<Candidate<'s, C>>;

macro_rules! steps {
    ($steps:ident by $method:ident of $system:ident) => {
        impl<H: Hamiltonian + $system, C: Coords> Splitting<C> for $steps<'_, H>
        where
            H::Coords: Coords<With<C::Leaf> = C>,
        {
            fn measured(&self) -> Erased<'_, C> {
                Erased(self)
            }
        }

        impl<H: Hamiltonian + $system, C: Coords> Measured<C> for $steps<'_, H>
        where
            H::Coords: Coords<With<C::Leaf> = C>,
        {
            fn name(&self) -> Split {
                Split { parts: &[stringify!($method)], ..Measured::<C>::name(self.0) }
            }
            fn candidates(&self, start: &Start<C>, span: f64) -> Result<Vec<Candidate<'_, C>>, &'static str> {
                let pace = pace_of::<H, _, C>(self.0, $method(SofroniouSpaletta8), start, span)?;
                let candidates: Begins<'_, H, C> = |system, pace| {
                    vec![
                        Candidate::paced::<H, _, _>(system, Suzuki4, $method(Suzuki4), pace),
                        Candidate::paced::<H, _, _>(
                            system,
                            SofroniouSpaletta6S11,
                            $method(SofroniouSpaletta6S11),
                            pace,
                        ),
                        Candidate::paced::<H, _, _>(system, SofroniouSpaletta8, $method(SofroniouSpaletta8), pace),
                        Candidate::paced::<H, _, _>(system, SofroniouSpaletta10, $method(SofroniouSpaletta10), pace),
                    ]
                };
                Ok(candidates(self.0, pace))
            }
            of_system!(0);
        }
    };
}
steps!(LogarithmicSteps by Logarithmic of TimeTransformed);
steps!(PacedSteps by Paced of Rated);

/// The mean pace over a span: fictitious time for a unit of time.
///
/// # Errors
/// Why there is none.
fn pace_of<H, X, C>(system: &H, method: X, start: &Start<C>, span: f64) -> Result<f64, &'static str>
where
    H: Hamiltonian,
    X: Method<H>,
    C: Coords,
    H::Coords: Coords<With<C::Leaf> = C>,
{
    // That of the start first, in a step that is short for any pace.
    let (mut pace, mut step) = (1.0, span * f64::EPSILON.sqrt());
    for steps in [1.0, PILOT, PILOT] {
        let mut run = run::<H, X, C::Leaf>(system, method, start, step).map_err(|_| "its run cannot begin")?;
        let outcome = if steps == 1.0 { run.advance(1) } else { run.advance_to(start.time + span) };
        outcome.map_err(|error| reason(&error))?;
        let passed = run.time_at_step() - start.time;
        pace = run.steps() as f64 * step / passed;
        step = pace * span / PILOT;
        if !(pace.is_finite() && step != 0.0) {
            return Err("its time stands still");
        }
    }
    Ok(pace)
}

/// The reason why a run in a fictitious time has ended.
fn reason(error: &Error) -> &'static str {
    match error {
        Error::NotSolved { reason: Unsolved::Domain { .. }, .. } => {
            "V is not negative along the whole orbit: subtract a constant"
        }
        Error::NotSolved { reason: Unsolved::Rate { .. }, .. } => "`rate` is not positive along the whole orbit",
        _ => "its time does not advance, or its run diverges",
    }
}
