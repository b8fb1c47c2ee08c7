//! The local order: whether the order is observed along the whole orbit.
//!
//! In: a system, a method, a start, a piece of time, a total time. Out: the first time at which errors do not decrease
//! with the order for any step size, or nothing. Always true: every piece begins at a state reached before, so errors
//! of different pieces do not add up, and a chaotic orbit is checked as far as a regular one.
//!
//! A composition has its order if the forces have enough derivatives and steps are short enough. If the order is not
//! observed in a piece, there are two causes: steps are too long (an encounter, a fast oscillation), or a derivative is
//! missing (a kink, a jump, a cutoff). Halving the piece distinguishes them: in the first case parts of the piece show
//! the order, in the second case one part never does.

use crate::{
    check::{
        oracle::exact::Stepper,
        property::{
            energies::{Differentiable, Part, read_by},
            order::CLEARANCE,
        },
        start::Start,
        statistics::path::Path,
    },
    error::Error,
    scalar::tolerance::{largest, length, ratio, within},
};

/// The number of units in a piece. A step is a whole fraction of a unit, so that what switches at one of the user's
/// steps, of which a unit is a half, a quarter, ..., does so between two steps. Odd, so that a piece is unlikely to end
/// just there.
pub(crate) const UNITS: u64 = 7;

/// Divisions of a unit into steps: groups in which the coarsest step is half of that in the group before, and the
/// division that serves as the exact motion. The error from a missing derivative depends on its position in the step
/// and may happen to vanish; the largest one of a group does not.
type Divisions = (&'static [&'static [u64]], u64);

/// The divisions for the first view of one of many pieces. Where there are few, the order may be missing in a single
/// one of them.
const FIRST: Divisions = (&[&[2, 3], &[4, 5, 6]], 12);
const MANY: u64 = 64;

/// The divisions for a part of a piece in which the order is missing: it has to show twice.
const CLOSE: Divisions = (&[&[2, 3], &[4, 5, 6], &[8, 10, 12]], 24);

/// The divisions for a low order, which has to show three times, so that an order that is not reached is not much
/// lower.
const CLOSE_LOW: Divisions = (&[&[2, 3], &[4, 5, 6], &[8, 10, 12], &[16, 20, 24]], 48);

/// The largest number of halvings of a piece. The steps of the shortest one are 10^5 times shorter than those of the
/// longest: at an eccentricity of 0.999 the motion at the pericentre is 3·10^4 times faster than elsewhere.
const HALVINGS: u32 = 16;

/// The smallest ratio of an error to the rounding of a state for the error to count. Forces whose terms cancel may round
/// that much more than the state.
const FLOOR: f64 = 1e3;

/// The number of pieces in a row, each a half of the one before, in which the order has to be missing before errors
/// that drown in the rounding count as those of a missing derivative. Where steps are too long, errors fall faster from
/// one half to the next one, and the order shows before they drown.
const IN_A_ROW: u32 = 4;

/// The loss of the order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Loss {
    /// The beginning of the last piece in which it did not show.
    pub(crate) time: f64,
    /// The power of the step with which errors shrink there, NaN where steps end in NaN.
    pub(crate) order: f64,
}

/// The order along an orbit.
#[derive(Clone, Copy)]
pub(crate) struct OrderAlong {
    /// The time up to which it holds.
    pub(crate) until: f64,
    /// The loss, if there is one.
    pub(crate) loss: Option<Loss>,
}

/// Examines the `order` in `pieces` pieces of `piece` each.
pub(crate) fn order_along(
    (stepper, energies): (&dyn Stepper, &dyn Differentiable),
    order: f64,
    start: &Start<Vec<f64>>,
    (piece, pieces): (f64, u64),
) -> OrderAlong {
    let orbit = Orbit { stepper, energies, order, is_long: pieces > MANY };
    let mut at = start.clone();
    for number in 0..pieces {
        at.time = start.time + number as f64 * piece;
        let (verdict, end) = orbit.examine(&at, piece, 0, Missing::default());
        if let Verdict::Lost(loss) = verdict {
            // No step follows a motion that leaves the finite numbers, and a run that comes there returns an error.
            let stays = orbit.path(&at, 2.0 * piece, 2 * orbit.divisions(0).1).is_ok();
            return OrderAlong { until: loss.time, loss: stays.then_some(loss) };
        }
        at = end;
    }
    OrderAlong { until: start.time + pieces as f64 * piece, loss: None }
}

/// The orbit of a method, and the order that is examined.
struct Orbit<'s> {
    stepper: &'s dyn Stepper,
    energies: &'s dyn Differentiable,
    /// The power of the step with which errors have to shrink.
    order: f64,
    /// Whether the orbit has many pieces.
    is_long: bool,
}

/// The verdict on a piece.
#[derive(Clone, Copy, PartialEq)]
enum Verdict {
    /// Errors shrink with the order.
    Shown,
    /// No step size has an error.
    Silent,
    Lost(Loss),
}

impl Orbit<'_> {
    /// Examines a piece and returns its verdict and its end. The piece is the `depth`th half; `above` are the pieces
    /// around it in which the order was missing.
    fn examine(&self, at: &Start<Vec<f64>>, piece: f64, depth: u32, above: Missing) -> (Verdict, Start<Vec<f64>>) {
        let view = self.view(at, piece, depth);
        let clock = self.clock(at, piece);
        let mut judgement = view.judge(self.order, clock, 0.0);
        if matches!(judgement, Judgement::Missing(_)) {
            judgement = view.judge(self.order, clock, self.force_rounding(&view, at.time, piece));
        }
        let slopes = match judgement {
            Judgement::Passed(verdict) => return (verdict, view.end(at, piece)),
            Judgement::Missing(slopes) => slopes,
        };
        let missing = above.and(&slopes, self.order);
        let power = missing.power();
        // A power that is as high, or higher, in the mean over all halves is hidden by where in their steps a slope of
        // the force jumps.
        let lost =
            if power >= self.order { Verdict::Silent } else { Verdict::Lost(Loss { time: at.time, order: power }) };
        if depth == HALVINGS {
            return (lost, view.end(at, piece));
        }
        let half = piece / 2.0;
        let (first, mut middle) = self.examine(at, half, depth + 1, missing);
        middle.time = at.time + half;
        if matches!(first, Verdict::Lost(_)) {
            return (first, middle);
        }
        let (second, end) = self.examine(&middle, half, depth + 1, missing);
        let verdict = match (first, second) {
            (_, Verdict::Lost(_)) => second,
            (Verdict::Silent, Verdict::Silent) if missing.in_a_row >= IN_A_ROW => lost,
            // Steps were too long, but the finest ones.
            (Verdict::Silent, Verdict::Silent) if missing.in_a_row == 0 => Verdict::Shown,
            (Verdict::Silent, Verdict::Silent) => Verdict::Silent,
            _ => Verdict::Shown,
        };
        (verdict, end)
    }

    /// The time in pieces, where a force reads it.
    fn clock(&self, at: &Start<Vec<f64>>, piece: f64) -> f64 {
        if self.stepper.autonomous() { 0.0 } else { at.time / piece }
    }

    /// What the roundings of forces and velocities change over a piece at most, in units of the excursion. Where forces are
    /// small differences of large terms, that is far more than the rounding of a state.
    fn force_rounding(&self, view: &View, time: f64, piece: f64) -> f64 {
        let has_gradients = self.energies.is_separable() || self.energies.in_one_piece();
        let Some(exact) = view.exact.as_ref().filter(|_| has_gradients) else { return 0.0 };
        let scale = exact.excursion();
        let over_piece = |part, unit| {
            let at =
                |(point, time)| length(self.energies.flow_rounding(part, &read_by(self.energies, part, point), time));
            let last = exact.ends.last().map(|end| (end, time + piece));
            ratio(piece.abs() * largest([(&exact.start, time)].into_iter().chain(last).map(at)), unit)
        };
        let rounding = over_piece(Part::Kinetic, scale.q) + over_piece(Part::Potential, scale.p);
        // Without a bound, the roundings of states have to do.
        if rounding.is_finite() { rounding } else { 0.0 }
    }

    /// Views a piece in steps that are halved again and again.
    fn view(&self, at: &Start<Vec<f64>>, piece: f64, depth: u32) -> View {
        let (groups, finest) = self.divisions(depth);
        let Ok(exact) = self.path(at, piece, finest) else { return View { exact: None, errors: Vec::new() } };
        let scale = exact.excursion();
        // A step too long to stay finite has no error.
        let error = |steps: &u64| self.path(at, piece, *steps).map_or(f64::NAN, |path| path.distance(&exact, scale));
        let errors = groups.iter().map(|group| largest(group.iter().map(error))).collect();
        View { exact: Some(exact), errors }
    }

    fn divisions(&self, depth: u32) -> Divisions {
        match depth {
            0 if self.is_long => FIRST,
            _ if self.order < 3.0 => CLOSE_LOW,
            _ => CLOSE,
        }
    }

    /// The path over a piece, with `steps` steps in each of its units.
    fn path(&self, at: &Start<Vec<f64>>, piece: f64, steps: u64) -> Result<Path, Error> {
        self.stepper.path(at, piece / (UNITS * steps) as f64, UNITS, steps)
    }
}

/// The number of pieces, each a half of the one before, in which the order is missing.
#[derive(Clone, Copy, Default)]
struct Missing {
    /// The length of the last sequence in whose finest steps it never shows.
    in_a_row: u32,
    /// The sum of the powers of the step with which errors shrink in them, and their number.
    powers: f64,
    count: usize,
}

impl Missing {
    /// Adds a piece. Where steps were too long, the finest ones are the first in which the order shows.
    fn and(self, slopes: &[f64], order: f64) -> Self {
        let continues = slopes.last().is_some_and(|finest| *finest < order);
        Self {
            in_a_row: if continues { self.in_a_row + 1 } else { 0 },
            powers: self.powers + slopes.iter().sum::<f64>(),
            count: self.count + slopes.len(),
        }
    }

    /// The mean power, NaN where there is none.
    fn power(self) -> f64 {
        self.powers / self.count as f64
    }
}

/// A piece in steps that are halved again and again.
struct View {
    /// The path in the finest steps, if these stay finite.
    exact: Option<Path>,
    /// The largest error of each group, in units of the excursion.
    errors: Vec<f64>,
}

/// The judgement of a piece alone.
enum Judgement {
    Passed(Verdict),
    /// The order is missing; errors shrink with these powers of the step, from coarse to fine steps. NaN where steps
    /// end in NaN.
    Missing(Vec<f64>),
}

impl View {
    /// Judges errors that have to shrink with the power `needed`. A force that reads the time, which is `clock` pieces,
    /// is off by its rounding. `of_forces` bounds the roundings of forces.
    fn judge(&self, needed: f64, clock: f64, of_forces: f64) -> Judgement {
        let Some(exact) = &self.exact else { return Judgement::Missing(Vec::new()) };
        let rounding = exact.rounding(exact.excursion()) + (4.0 + clock.abs()) * f64::EPSILON;
        // Momenta that stay, in free flight, or positions have no unit to measure errors in.
        if !rounding.is_finite() {
            return Judgement::Passed(Verdict::Silent);
        }
        if !self.errors.iter().all(|error| error.is_finite()) {
            return Judgement::Missing(Vec::new());
        }
        let floor = (FLOOR * rounding).max(CLEARANCE * of_forces);
        let mut errors = self.errors.clone();
        // What is smaller than in finer steps is so by chance.
        for index in (1..errors.len()).rev() {
            errors[index - 1] = errors[index - 1].max(errors[index]);
        }
        let clear = errors.iter().take_while(|error| !within(**error, floor)).count();
        let slopes: Vec<f64> = errors[..clear].windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
        if slopes.iter().any(|slope| *slope < needed) {
            return Judgement::Missing(slopes);
        }
        // What drowns in steps of half the length has shrunk as it seems, or to the rounding.
        let shrunk = |finer: f64| (errors[clear - 1] / finer.max(CLEARANCE * rounding).max(of_forces)).log2() >= needed;
        let drowned = clear > 0 && errors.get(clear).is_some_and(|finer| shrunk(*finer));
        Judgement::Passed(if clear > 1 || drowned { Verdict::Shown } else { Verdict::Silent })
    }

    /// The end of the piece that begins at `at`.
    fn end(&self, at: &Start<Vec<f64>>, piece: f64) -> Start<Vec<f64>> {
        let last = self.exact.as_ref().and_then(|path| path.ends.last());
        last.unwrap_or(&at.phase).clone().at_time(at.time + piece)
    }
}
