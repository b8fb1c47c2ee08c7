//! Where a run passes through a zero of a function: Poincaré sections, and the times of events.
//!
//! Comes in: a run and a function of state and time. Goes out: the states in which the function changes its sign.
//!
//! Always true: the run takes its steps as `advance` would, bit for bit. Where a step is a polynomial, crossings lie on
//! it: their states are those of the run, had it been sampled then. Where it is not, a crossing is reached from the
//! state before it by one shorter step of the same method, on a copy: it lies on the numerical trajectory to the order
//! of the method, and nothing is interpolated. Hénon (1982) makes the function the independent variable for that one
//! step instead; a shorter step needs no other equations, hence works for every function and every leaf.

use crate::{
    error::Error,
    state::{coords::Coords, phase::Phase},
    trajectory::{run::Run, samples::Sample},
};
use core::{borrow::BorrowMut, fmt, mem};

/// The number of evaluations without a result after which intervals are halved.
const IMPATIENT: u32 = 32;

/// The direction in which a function passes through zero along a run.
///
/// If the step is negative, the run goes backwards in time, and the direction is that of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The function passes from negative to positive values.
    Rising,
    /// The function passes from positive to negative values.
    Falling,
    /// The function passes through zero in either direction.
    Either,
}

impl Direction {
    fn admits(self, rising: bool) -> bool {
        match self {
            Self::Rising => rising,
            Self::Falling => !rising,
            Self::Either => true,
        }
    }
}

/// An iterator over the states in which a function changes its sign along a run.
///
/// Returned by [`Run::crossings`] and by [`ByRef::crossings`](crate::ByRef::crossings). The iterator ends after an error.
#[derive(Clone)]
pub struct Crossings<C: Coords, G, R = Run<C>> {
    run: R,
    steps: u64,
    direction: Direction,
    function: G,
    /// The present state of the run, once it was evaluated.
    present: Option<Point<C>>,
    /// The last value that was not zero; zero until there is one.
    side: f64,
    failed: bool,
}

/// A state, and the function there.
#[derive(Clone)]
pub(crate) struct Point<C> {
    pub(crate) time: f64,
    pub(crate) state: Phase<C>,
    pub(crate) value: f64,
}

impl<C: Coords> Run<C> {
    /// Returns an iterator over the zeros of `function` within the next `steps` steps: a Poincaré section, or events.
    ///
    /// The sign of `function(state, time)` is compared after every step. If it changed, the time of the crossing is
    /// computed to rounding accuracy:
    ///
    /// - for compositions, by shorter steps from the state before, so that crossings have the order of the method;
    /// - for [`Taylor`](crate::taylor::Taylor), on its polynomial, so that crossings have the precision of the run.
    ///
    /// The `step` of such a sample counts the whole steps before it. The state is a zero of the function, or the nearest
    /// state after it, so that a new run from there does not find this crossing again. [`Run::on_crossing`] changes the
    /// state at every crossing.
    ///
    /// Special cases:
    ///
    /// - Two crossings within one step are not found. Choose a step in which the function has at most one extremum.
    /// - If the function is zero at the end of a step, this state is a crossing if the sign differs afterwards; the iterator
    ///   returns it one step later. Of several such states in a row, the last one counts.
    /// - A zero at the start is not a crossing, and neither is a zero that the function touches without changing its sign.
    /// - A jump from one sign to the other is a crossing. A wrapped angle passes zero in one direction and jumps in the
    ///   other, so that a [`Direction`] selects the passages.
    /// - Coordinates in `f32` or on a grid change in discrete amounts; a crossing is a state next to the zero.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian(compose = BlanesMoan6)]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    ///
    /// let run = Oscillator.run(Phase::new([0.0], [1.0]), 0.1)?;
    /// let mut turns = run.crossings(100, Direction::Falling, |state, _| state.p[0]);
    /// let first = turns.next().expect("a turn within 10 units of time")?;
    /// assert!((first.time - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    /// assert!((first.state.q[0] - 1.0).abs() < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// An item is an error if [`Run::advance`] fails, or [`Error::Crossing`] if the function is not finite.
    pub fn crossings<G>(self, steps: u64, direction: Direction, function: G) -> Crossings<C, G>
    where
        G: FnMut(&Phase<C>, f64) -> f64,
    {
        Crossings::new(self.at_step(), steps, direction, function)
    }
}

impl<C: Coords, G: FnMut(&Phase<C>, f64) -> f64, R: BorrowMut<Run<C>>> Crossings<C, G, R> {
    pub(crate) fn new(run: R, steps: u64, direction: Direction, function: G) -> Self {
        Self { run, steps, direction, function, present: None, side: 0.0, failed: false }
    }

    /// The run, after the last step that was evaluated.
    pub fn into_run(self) -> R {
        self.run
    }

    /// The next crossing within the steps that are left.
    fn next_crossing(&mut self) -> Result<Option<Sample<C>>, Error> {
        let mut before = match self.present.take() {
            Some(point) => point,
            None => {
                self.run.borrow().check_clock()?;
                let start = present(self.run.borrow(), &mut self.function)?;
                self.side = start.value;
                start
            }
        };
        while let Some(left) = self.steps.checked_sub(1) {
            let run = self.run.borrow_mut();
            let whole_steps = run.steps();
            run.advance(1)?;
            self.steps = left;
            let after = present(run, &mut self.function)?;
            if crosses(&mut self.side, after.value, self.direction) {
                let (_, Point { time, state, .. }) = between(run, &mut self.function, &before, &after)?;
                self.present = Some(after);
                return Ok(Some(Sample::new(self.run.borrow(), time, whole_steps, state)));
            }
            before = after;
        }
        self.present = Some(before);
        Ok(None)
    }
}

/// The present time and state of a run, and the function there.
pub(crate) fn present<C: Coords>(
    run: &Run<C>,
    function: &mut impl FnMut(&Phase<C>, f64) -> f64,
) -> Result<Point<C>, Error> {
    point(run.time(), run.state(), function)
}

pub(crate) fn point<C: Coords>(
    time: f64,
    state: Phase<C>,
    function: &mut impl FnMut(&Phase<C>, f64) -> f64,
) -> Result<Point<C>, Error> {
    let value = function(&state, time);
    if value.is_finite() { Ok(Point { time, state, value }) } else { Err(Error::Crossing { time, value }) }
}

/// Whether a function that was last on a side of zero has passed to the other one in a direction; it is on that side then.
pub(crate) fn crosses(side: &mut f64, value: f64, direction: Direction) -> bool {
    let before = if value == 0.0 { *side } else { mem::replace(side, value) };
    let crosses = (before < 0.0 && value > 0.0) || (before > 0.0 && value < 0.0);
    crosses && direction.admits(value > 0.0)
}

/// Finds the zero of the function in the last step of a run, as a fraction of this step and the point there, by the
/// method of Chandrupatla (1997): the inverse of a parabola through three values where these lie on one without doubt,
/// and the middle otherwise. Where no state has a value of zero, the point is the nearest one on the side of `after`,
/// so that what begins there does not pass the zero again.
pub(crate) fn between<C: Coords>(
    run: &mut Run<C>,
    function: &mut impl FnMut(&Phase<C>, f64) -> f64,
    before: &Point<C>,
    after: &Point<C>,
) -> Result<(f64, Point<C>), Error> {
    let h = run.step();
    // Fractions of the step: the newest, the one on the other side of the zero, and the one that was given up.
    let (mut near, mut far) = ((1.0, after.clone()), (0.0, before.clone()));
    let mut fraction = 0.5_f64;
    for evaluation in 1_u32.. {
        let width: f64 = far.0 - near.0;
        // A rounding of the step, in units of the interval.
        let least = f64::EPSILON / width.abs();
        let exact = near.1.value == 0.0 || far.1.value == 0.0;
        if exact || least > 0.5 {
            break;
        }
        let at = near.0 + fraction.clamp(least, 1.0 - least) * width;
        let (time, state) = run.within(&before.state, at * h)?;
        let newest = (at, point(time, state, function)?);
        let same_side = (newest.1.value > 0.0) == (near.1.value > 0.0);
        let given_up = if same_side { near } else { mem::replace(&mut far, near) };
        near = newest;
        let along = |point: &(f64, Point<C>)| (point.0 - far.0) / (given_up.0 - far.0);
        let up = |point: &(f64, Point<C>)| (point.1.value - far.1.value) / (given_up.1.value - far.1.value);
        let (xi, phi) = (along(&near), up(&near));
        let on_parabola = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        fraction = if on_parabola && evaluation < IMPATIENT { parabola(&near, &far, &given_up) } else { 0.5 };
    }
    let is_behind = |point: &Point<C>| point.value == 0.0 || (point.value > 0.0) == (after.value > 0.0);
    let nearest_is_near = match (is_behind(&near.1), is_behind(&far.1)) {
        (true, true) => near.1.value.abs() < far.1.value.abs(),
        (near, _) => near,
    };
    Ok(if nearest_is_near { near } else { far })
}

/// Returns the zero of the inverse of a parabola through three points, as a fraction of the way from the first of them
/// to the second.
fn parabola<C>(a: &(f64, Point<C>), b: &(f64, Point<C>), c: &(f64, Point<C>)) -> f64 {
    let (fa, fb, fc) = (a.1.value, b.1.value, c.1.value);
    fa / (fb - fa) * fc / (fb - fc) + (c.0 - a.0) / (b.0 - a.0) * fa / (fc - fa) * fb / (fc - fb)
}

impl<C: Coords, G: FnMut(&Phase<C>, f64) -> f64, R: BorrowMut<Run<C>>> Iterator for Crossings<C, G, R> {
    type Item = Result<Sample<C>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        // It stays so if a function of the user panics: what was between two steps is not known any more.
        self.failed = true;
        let crossing = self.next_crossing();
        self.failed = crossing.is_err();
        crossing.transpose()
    }
}

impl<C: Coords, G, R: fmt::Debug> fmt::Debug for Crossings<C, G, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Crossings")
            .field("run", &self.run)
            .field("steps", &self.steps)
            .field("direction", &self.direction)
            .finish_non_exhaustive()
    }
}
