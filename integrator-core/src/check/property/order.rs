//! Measurement of the order of a composition.
//!
//! In: a system, a composition, a start, a step. Out: the slope of the logarithm of the error over the logarithm of the
//! step. Always true: only errors well above the rounding enter the slope; if there are too few of them, the result is
//! an error.

use crate::{
    check::{
        CheckError,
        oracle::{
            exact::{Stepper, Steps},
            reference::reference,
        },
        start::{IntoStart, Start},
        statistics::{
            least_squares::fit_finest,
            path::{PARTS, Path},
            points::{begin, flat_start},
        },
    },
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::tolerance::within,
    state::{flat::Flat, precision::Precision},
    system::Shaped,
    trajectory::method::Method,
};

/// The first time that is tried, in steps of the user; a power of two keeps the doublings exact.
const FIRST_SPAN: f64 = 16.0;

/// The largest number of doublings or halvings of the time: between a step 10^19 times too fine and one as much too
/// coarse.
const DOUBLINGS: usize = 64;

/// The error of the coarsest step, in units of the excursion, beyond which a time counts as too long. At a tenth the
/// leading term of the error of the finer steps prevails in all compositions that were tried.
const COARSEST_ERROR: f64 = 0.1;

/// The steps per part of the time, growing by about a quarter each.
pub(crate) const LADDER: [u64; 22] =
    [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160, 192, 256];

/// The smallest ratio of an error to the rounding for its logarithm to count. What is left is 4 % of the finest error
/// at most, and less than 0.04 of a slope over a factor of three in the step.
pub(crate) const CLEARANCE: f64 = 25.0;

/// The largest number of step sizes that enter a slope: the finest ones that are clear of the rounding, where the
/// leading term of the error prevails. Six of them span a factor of three in the step.
pub(crate) const POINTS: usize = 6;

/// The smallest number of step sizes of a slope: two more than a line has parameters, so that its scatter is known.
pub(crate) const NEEDED: usize = 4;

/// The largest numbers of steps per part in which edges are searched for, and which follow the motion from edge to
/// edge.
const FARTHEST_EDGE: u64 = 1 << 12;
const MOST_OVER_EDGES: u64 = 8;

/// The factor in the step over which errors are compared.
const LEVER: f64 = 3.0;

/// The factor by which the time is shortened where the errors do not lie on a line, and the smallest number of times
/// that are tried; shorter ones are tried as long as a step of the run fits in.
const SHORTENING: f64 = 0.75;
const ATTEMPTS: usize = 10;

/// The tolerance of an observed order below the claimed one. Orders are whole numbers, so that what lies within
/// half of one is nearer to the claimed order than to any lower one.
pub(crate) const ORDER_TOLERANCE: f64 = 0.5;

/// The standard error of a slope up to which its points are taken to lie on a line.
const SCATTER: f64 = 0.05;

/// The largest distance of a slope from a whole number where the leading term of the error prevails.
const WHOLE: f64 = 0.1;

/// The number of halvings by a reference of a time that four steps of a method follow: composed flows, in shorter
/// steps, follow it to the rounding before that.
const SHORT: i32 = 8;

/// The observed order of a composition: the fitted slope, its error and the step sizes of the fit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Order {
    /// The slope of the logarithm of the error over the logarithm of the step.
    pub slope: f64,
    /// The standard error of the slope.
    pub uncertainty: f64,
    /// The number of step sizes in the fit.
    pub points: usize,
    /// The finest step in the fit.
    pub finest: f64,
    /// The coarsest step in the fit.
    pub coarsest: f64,
    /// The time from the start over which errors were measured. Negative for a negative step.
    pub span: f64,
    /// The longest time that was tried: four steps still follow the orbit over it. The span is a part of this time.
    pub followed: f64,
}

impl Order {
    fn is_line(&self) -> bool {
        within(self.uncertainty, SCATTER)
    }

    /// Whether the slope is the claimed order. Where errors lie on no line, they fall into the rounding before the
    /// leading one prevails.
    pub(crate) fn reaches(&self, claimed: u32) -> bool {
        self.slope >= if self.is_line() { f64::from(claimed) - ORDER_TOLERANCE } else { needed_along(claimed) }
    }
}

/// Measures the order of `composition` for this system and start.
///
/// - Errors are distances in phase space from the exact orbit, at four times along a common span.
/// - The unit of distance is how far the orbit goes; all states are compensated.
/// - The exact orbit is a Taylor series if `#[hamiltonian(taylor)]` generated recurrences. Otherwise it is a
///   composition of the flows, refined until it converges.
/// - The span is the longest one that four steps follow to a tenth, found by a coarse search over multiples of `h`.
///   Hence `h` itself may be far too fine or far too coarse.
/// - The span is divided into more and more steps, at most 1024, until rounding dominates the error.
/// - The slope is a least-squares fit to the finest four to six errors above the rounding.
///
/// If the errors do not lie on a line or fall short of the claimed order, the span is shortened, down to one step of
/// `h`. This happens if one part of the motion is faster than the rest. A short span shows the order of the
/// composition; [`certify`](crate::check::certify()) finds up to which time of the orbit the order is observed.
///
/// If conditions on the time select pieces of the Hamiltonian, the span contains edges and all steps end there.
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The method chooses its own steps.
/// - Fewer than four step sizes have errors above the rounding.
/// - No step follows the orbit from this start.
pub fn observed_order<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
) -> Result<Order, CheckError> {
    let start = start.into_start();
    let start = begin::<H, X, K>(system, method, &start, h)?;
    order_of(&Steps::new(system, method, &start.phase), flat_start(&start), h)
}

/// [`observed_order`] from a start that a run may begin with.
pub(crate) fn order_of(stepper: &dyn Stepper, start: Start<Vec<f64>>, h: f64) -> Result<Order, CheckError> {
    let problem = Problem { stepper, start };
    let facts = stepper.facts();
    if facts.adaptive {
        return Err(CheckError::NoOrder { method: facts.name });
    }
    if let Some(grid) = problem.over_edges(h)? {
        return problem.order(grid).order;
    }
    let followed = problem.longest_span(h)?;
    let mut span = followed;
    let mut best = problem.order(Grid::over(span));
    let mut attempts = 1;
    while !best.shows(facts.order) && (attempts < ATTEMPTS || within(h, span.abs())) {
        attempts += 1;
        span *= SHORTENING;
        let shorter = problem.order(Grid::over(span));
        if shorter.shows(facts.order) || shorter.is_better_than(&best) {
            best = shorter;
        }
    }
    // Where the next term of the error still shows, the slope is between two orders.
    while best.between_orders() > WHOLE && attempts < ATTEMPTS {
        attempts += 1;
        span *= SHORTENING;
        let shorter = problem.order(Grid::over(span));
        if shorter.shows(facts.order) && shorter.between_orders() < best.between_orders() {
            best = shorter;
        }
    }
    best.order.map(|order| Order { followed, ..order })
}

/// Divisions of a span into steps.
struct Grid {
    span: f64,
    /// The steps of a run in a part of the span, where these matter.
    whole: u64,
    /// The steps in a part of those whose errors are compared.
    ladder: [u64; LADDER.len()],
}

impl Grid {
    /// The divisions for steps of any length.
    fn over(span: f64) -> Self {
        Self { span, whole: 1, ladder: LADDER }
    }
}

/// The slope of the errors over one span.
struct Slope {
    order: Result<Order, CheckError>,
    /// Whether errors are known over a factor of three in the step. Where the exact motion is so fast that no reference
    /// resolves it, coarse steps show another order than those that do.
    known: bool,
}

impl Slope {
    /// Whether errors lie on a line.
    fn is_line(&self) -> bool {
        self.known && self.order.as_ref().is_ok_and(Order::is_line)
    }

    /// Whether errors lie on a line and fall with the order that is claimed. Steps that are longer than what is fastest
    /// in the motion show another order, on a line as straight; what they show over ever shorter times is the order of
    /// the composition.
    fn shows(&self, claimed: u32) -> bool {
        self.is_line() && self.order.as_ref().is_ok_and(|order| order.reaches(claimed))
    }

    /// The distance of the slope from a whole number; none where errors lie on no line.
    fn between_orders(&self) -> f64 {
        match &self.order {
            Ok(order) if self.is_line() => (order.slope - order.slope.round()).abs(),
            _ => 0.0,
        }
    }

    /// Whether this fit is the better line.
    fn is_better_than(&self, other: &Self) -> bool {
        match (&self.order, &other.order) {
            (Ok(one), Ok(other_one)) if self.known == other.known => within(one.uncertainty, other_one.uncertainty),
            (Ok(_), Ok(_)) => self.known,
            (Ok(_), Err(_)) => true,
            (Err(_), _) => false,
        }
    }
}

/// The power of the step with which errors have to shrink everywhere along an orbit. Those of high orders fall into the
/// rounding before the leading one of them prevails.
pub(crate) fn needed_along(claimed: u32) -> f64 {
    let claimed = f64::from(claimed);
    claimed - ORDER_TOLERANCE.max((claimed - 2.0) / 4.0)
}

/// A method, and the start of the runs that measure it.
struct Problem<'s> {
    stepper: &'s dyn Stepper,
    start: Start<Vec<f64>>,
}

impl Problem<'_> {
    /// The motion over `span`, in `steps` steps for each part.
    fn path(&self, span: f64, steps: u64) -> Result<Path, Error> {
        path(self.stepper, &self.start, span, steps)
    }

    /// The longest time over which the coarsest step follows the motion.
    fn longest_span(&self, h: f64) -> Result<f64, CheckError> {
        let mut span = FIRST_SPAN * h;
        if self.resolves(span, 1) {
            for _ in 0..DOUBLINGS {
                if !self.resolves(2.0 * span, 1) {
                    break;
                }
                span *= 2.0;
            }
            return Ok(self.extended(span));
        }
        for _ in 0..DOUBLINGS {
            span /= 2.0;
            if self.resolves(span, 1) {
                return Ok(self.extended(span));
            }
        }
        Err(CheckError::NotSmooth { finest: (span / PARTS as f64).abs() })
    }

    /// The longest time between a span that is followed and twice that, in eighths: a body that falls from far away is
    /// followed with next to no error until it arrives, and from then on not at all.
    fn extended(&self, span: f64) -> f64 {
        [0.5, 0.25, 0.125]
            .into_iter()
            .fold(1.0, |factor, more| if self.resolves(span * (factor + more), 1) { factor + more } else { factor })
            * span
    }

    /// Steps that end where pieces of the Hamiltonian meet, over a span in which they do; nothing, if none meet in a
    /// time that is followed. The span is the longest one, in a coarse search, that a few steps from edge to edge
    /// follow to a tenth.
    ///
    /// # Errors
    /// An edge inside of a step of `h`.
    fn over_edges(&self, h: f64) -> Result<Option<Grid>, CheckError> {
        let mut found = None;
        let mut whole = FIRST_SPAN as u64 / PARTS;
        while self.stepper.exact().piecewise_in_time() && whole <= FARTHEST_EDGE {
            let apart = self.spacing(h, whole)?;
            if apart == 0 {
                whole *= 2;
                continue;
            }
            whole = whole.next_multiple_of(apart);
            let (span, pieces) = ((PARTS * whole) as f64 * h, whole / self.spacing(h, whole)?);
            let ladder = LADDER.map(|steps| steps * pieces);
            if !ladder.iter().any(|steps| *steps <= MOST_OVER_EDGES && self.resolves(span, *steps)) {
                break;
            }
            found = Some(Grid { span, whole, ladder });
            whole *= 2;
        }
        Ok(found)
    }

    /// The spacing of edges in steps, for `whole` steps in each part.
    fn spacing(&self, h: f64, whole: u64) -> Result<u64, CheckError> {
        let span = (PARTS * whole) as f64 * h;
        let ends = self.path(span, whole).map_or(Vec::new(), |path| path.ends);
        let points: Vec<Flat> = ends.into_iter().chain([self.start.phase.clone()]).collect();
        self.stepper.spacing(&points, self.start.time, h, PARTS * whole)
    }

    /// Whether halving the coarsest step changes little beside the motion itself. No reference is needed: the
    /// difference is most of the error of the coarser one.
    fn resolves(&self, span: f64, steps: u64) -> bool {
        let (Ok(coarse), Ok(fine)) = (self.path(span, steps), self.path(span, 2 * steps)) else { return false };
        let scale = fine.excursion();
        // Over a time so short that the motion itself drowns in the rounding, nothing speaks against a longer one.
        let drowned = !within(fine.rounding(scale), COARSEST_ERROR / CLEARANCE);
        let unseen = drowned && scale.q.is_finite() && scale.p.is_finite();
        unseen || within(fine.distance(&coarse, scale), COARSEST_ERROR)
    }

    /// The slope over one span.
    fn order(&self, grid: Grid) -> Slope {
        let Grid { span, whole, ladder } = grid;
        let exact = reference(self.stepper.exact(), &self.start, span, whole, SHORT);
        let scale = exact.scale;
        // Both states are compensated, so that their sums lose nothing: each is rounded when it is returned. What is
        // left are the roundings of the flows, a few ε of what each adds to the state. These parts of the excursion,
        // forth and back within a step included, sum up to a few excursions, and their errors to a few ε of one,
        // however many steps there are; the error of the reference adds to it.
        let plateau = exact.uncertainty() + 2.0 * exact.rounding() + 4.0 * f64::EPSILON;
        let mut points = Vec::with_capacity(LADDER.len());
        for steps in ladder {
            // A step too coarse to stay finite is no reason to give up the finer ones.
            let Ok(path) = self.path(span, steps) else { continue };
            let count = (PARTS * steps) as f64;
            let error = path.distance(&exact.path, scale);
            // Where positions or momenta stay, their rounding is infinite in units of the motion: no error stands out.
            if error <= CLEARANCE * plateau {
                break;
            }
            if error.is_finite() {
                points.push(((span / count).abs().ln(), error.ln()));
            }
        }
        let coarsest = (span / (PARTS * ladder[0]) as f64).abs();
        let too_few = CheckError::TooFewPoints { found: points.len(), needed: NEEDED, coarsest };
        let step = |point: Option<&(f64, f64)>| point.map_or(f64::NAN, |(logarithm, _)| logarithm.exp());
        let slope = fit_finest(&points, NEEDED..=POINTS).map(|(finest, slope)| Order {
            slope: slope.value,
            uncertainty: slope.uncertainty,
            points: finest.len(),
            finest: step(finest.last()),
            coarsest: step(finest.first()),
            span,
            followed: span,
        });
        let lever = LEVER.powi(self.stepper.facts().order as i32);
        Slope { order: slope.ok_or(too_few), known: within(plateau, COARSEST_ERROR / CLEARANCE / lever) }
    }
}

/// The motion of a compensated run from `start` over `span`, in `steps` steps for each part.
pub(crate) fn path(stepper: &dyn Stepper, start: &Start<Vec<f64>>, span: f64, steps: u64) -> Result<Path, Error> {
    stepper.path(start, span / (PARTS * steps) as f64, PARTS, steps)
}
