//! Agreement of the generated code with the user's own functions.
//!
//! In: a system and the states of an orbit. Out: the numbers of energies, forces, velocities and their tangents that
//! agree with the user's functions, and those that do not. Always true: derivatives are compared with
//! Richardson-extrapolated differences that agree for two widths. If they do not, as at a kink, the comparison is not
//! counted.

use crate::{
    check::{
        CheckError,
        property::{
            flow_laws::slopes,
            gradient::{Energies, Gradient},
            part_flows::Flows,
        },
        shortfall::Shortfall,
        statistics::points::{numbers, origin},
    },
    hamiltonian::Hamiltonian,
    scalar::{
        bounded::Bounded,
        real::Real,
        tolerance::{largest, within},
    },
    state::flat::{Flat, shaped},
    system::{
        StatedEnergy,
        motion::Motion,
        user_energies::{Digits, Function, Values, hold, values},
    },
};

/// The largest number of coordinates of which each is a direction of its own, and the number of directions beyond that.
const COORDINATES: usize = 8;
const DIRECTIONS: usize = 4;

/// The widths at which differences begin, in units of the largest coordinate, and how often each is halved: they reach
/// from a tenth of it down to where rounding takes half of the digits.
const WIDTHS: [f64; 6] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
const LEVELS: usize = 6;

/// The largest uncertainty of a derivative that is compared, in units of its terms. Orders of magnitude below
/// the mistakes that are made in a derivative by hand, and above what differences reach where a function is smooth.
pub(crate) const KNOWN: f64 = 1e-6;

/// The safety factor on the estimated error of a difference: the estimate is the last correction of an
/// extrapolation, which the next ones fall short of where it converges.
pub(crate) const SAFETY: f64 = 8.0;

/// A state and its time.
pub(crate) type Visited = (Flat, f64);

/// The numbers of comparisons between the generated code and the user's functions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Agreement {
    /// The number of energies that agree.
    pub energies: usize,
    /// The number of derivatives that agree: forces, velocities and their tangents, in one direction at one state each.
    pub derivatives: usize,
    /// The number of comparisons that were left out: at a kink or a jump, or where rounding dominates.
    pub left_out: usize,
}

/// Compares the generated energies and flows with the user's functions at some states, each with its time.
///
/// # Errors
/// The first disagreement of each function.
pub(crate) fn agreement(
    system: &dyn Stated,
    states: &[Visited],
) -> Result<Result<Agreement, CheckError>, Vec<Shortfall>> {
    let (mut agreement, mut shortfalls) = (Agreement::default(), Vec::new());
    for function in Function::BOTH {
        let outcome = states.iter().try_for_each(|(state, time)| {
            match hold(state, *time, &|state| system.values(function, state, *time)).map_err(Shortfall::Misread)? {
                true => agreement.energies += 1,
                false => agreement.left_out += 1,
            }
            let point = Point { system, function, state, time: *time };
            point.directions().iter().try_for_each(|direction| {
                let slope = point.slope(direction)?;
                // The tangents of flows that are no shears are compared with these flows by their laws.
                let tangent = if system.energies().is_separable() { Some(point.tangent(direction)?) } else { None };
                for held in [Some(slope), tangent].into_iter().flatten() {
                    if held { agreement.derivatives += 1 } else { agreement.left_out += 1 }
                }
                Ok(())
            })
        });
        shortfalls.extend(outcome.err());
    }
    for number in 0..system.energies().invariants().len() {
        let mut held =
            states.iter().map(|(state, time)| hold(state, *time, &|state| system.invariant_values(number, state)));
        shortfalls.extend(held.find_map(Result::err).map(Shortfall::Misread));
    }
    match agreement {
        _ if !shortfalls.is_empty() => Err(shortfalls),
        Agreement { energies: 0, left_out, .. } | Agreement { derivatives: 0, left_out, .. } => {
            Ok(Err(CheckError::NothingToCompare { left_out }))
        }
        _ => Ok(Ok(agreement)),
    }
}

/// A system beside the user's own functions.
pub(crate) trait Stated {
    /// The generated code alone.
    fn energies(&self) -> &dyn Flows;

    /// Whether the user wrote all of `H` in one function.
    fn is_whole(&self, state: &Flat, time: f64) -> bool;

    /// The values of an invariant by the generated code and by the user's function.
    fn invariant_values(&self, number: usize, state: &Flat) -> Values;

    /// The values of the generated code and of the user's functions.
    fn values(&self, function: Function, state: &Flat, time: f64) -> Values;
}

impl<H: Hamiltonian> Stated for Energies<'_, H> {
    fn energies(&self) -> &dyn Flows {
        self
    }

    fn is_whole(&self, state: &Flat, time: f64) -> bool {
        let state = shaped(self.shape, state);
        matches!(self.system.stated(&state.q, &state.p, time), StatedEnergy::Whole(_))
    }

    fn invariant_values(&self, number: usize, state: &Flat) -> Values {
        if const { H::INVARIANTS.is_empty() } {
            return Values { stated: f64::NAN, generated: f64::NAN, rounding: f64::NAN, name: "" };
        }
        let state = shaped(self.shape, state);
        let motion = H::Motion::<Bounded, f64>::load(&[&self.parameters; 2], &[&state; 2]);
        let generated = H::invariant::<Bounded, f64>(&motion, number);
        Values {
            stated: self.system.stated_invariant(number, &state.q, &state.p),
            generated: generated.lane(0),
            rounding: generated.lane(1),
            name: H::INVARIANTS[number],
        }
    }

    fn values(&self, function: Function, state: &Flat, time: f64) -> Values {
        values(function, self.system, &self.parameters, &shaped(self.shape, state), time)
    }
}

/// A function at a state.
struct Point<'s> {
    system: &'s dyn Stated,
    function: Function,
    state: &'s Flat,
    time: f64,
}

impl Point<'_> {
    /// The coordinates that the function reads, of a state: one half of them, or all of them.
    fn own(&self, state: &Flat) -> Vec<f64> {
        match self.function {
            _ if !self.system.energies().is_separable() => numbers(state).collect(),
            Function::Kinetic => state.p.clone(),
            Function::Potential => state.q.clone(),
        }
    }

    /// The state with other coordinates for the function to read.
    fn with(&self, of: &Flat, own: impl Iterator<Item = f64>) -> Flat {
        let mut state = of.clone();
        let Flat { q, p } = &mut state;
        let (q, p) = match self.function {
            _ if !self.system.energies().is_separable() => (&mut q[..], &mut p[..]),
            Function::Kinetic => (&mut [][..], &mut p[..]),
            Function::Potential => (&mut q[..], &mut [][..]),
        };
        q.iter_mut().chain(p).zip(own).for_each(|(number, own)| *number = own);
        state
    }

    /// The state that far in a direction.
    fn moved(&self, direction: &[f64], distance: f64) -> Flat {
        let own = self.own(self.state).into_iter().zip(direction);
        self.with(self.state, own.map(|(number, along)| number + distance * along))
    }

    /// Each coordinate for itself where there are few, else some fixed directions through all of them; as long as the
    /// largest coordinate.
    fn directions(&self) -> Vec<Vec<f64>> {
        let own = self.own(self.state);
        let extent = largest(own.iter().copied());
        let length = if extent > 0.0 { extent } else { 1.0 };
        let mut digits = Digits::default();
        if own.len() <= COORDINATES {
            let unit = |index| (0..own.len()).map(|other| if other == index { length } else { 0.0 }).collect();
            return (0..own.len()).map(unit).collect();
        }
        (0..DIRECTIONS).map(|_| own.iter().map(|_| length * digits.next()).collect()).collect()
    }

    /// The gradient of the generated code at a state.
    fn generated(&self, state: &Flat) -> Vec<f64> {
        let system = self.system.energies();
        if !system.is_separable() {
            return self.slopes(state);
        }
        let still = origin(state);
        let own = self.with(&still, self.own(state).into_iter());
        Gradient::new(system, self.function, self.time).flow(&own, None)
    }

    /// The derivatives of the generated energy by all coordinates, where these are read by any part.
    fn slopes(&self, state: &Flat) -> Vec<f64> {
        let slopes = |part| slopes(self.system.energies(), part, state, self.time);
        if !self.system.is_whole(state, self.time) {
            return slopes(self.function);
        }
        let [kinetic, potential] = Function::BOTH.map(slopes);
        kinetic.iter().zip(potential).map(|(kinetic, potential)| kinetic + potential).collect()
    }

    /// Whether the force or the velocity is the slope of the user's function in a direction; `false` where no slope is
    /// known.
    fn slope(&self, direction: &[f64]) -> Result<bool, Shortfall> {
        let value = |distance| {
            let state = self.moved(direction, distance);
            let Values { stated, rounding, .. } = self.system.values(self.function, &state, self.time);
            [stated, rounding]
        };
        let terms = self.generated(self.state).into_iter().zip(direction).map(|(slope, along)| slope * along);
        self.hold(1, terms.collect(), slope_of(&value))
    }

    /// Whether the tangent of the force or of the velocity is the slope of the latter in a direction: a sum over all
    /// components, each with a weight of its own.
    fn tangent(&self, direction: &[f64]) -> Result<bool, Shortfall> {
        let mut digits = Digits::default();
        let weights: Vec<f64> = direction.iter().map(|_| 1.5 + 0.5 * digits.next()).collect();
        let value = |distance| {
            let terms = self.generated(&self.moved(direction, distance)).into_iter().zip(&weights);
            let terms: Vec<f64> = terms.map(|(slope, weight)| slope * weight).collect();
            [terms.iter().sum(), f64::EPSILON * terms.iter().map(|term| term.abs()).sum::<f64>()]
        };
        let still = origin(self.state);
        let own = self.with(&still, self.own(self.state).into_iter());
        let along = self.with(&still, direction.iter().copied());
        let gradient = Gradient::new(self.system.energies(), self.function, self.time);
        let tangents = gradient.flow(&own, Some(&along));
        self.hold(
            2,
            tangents.into_iter().zip(&weights).map(|(tangent, weight)| tangent * weight).collect(),
            slope_of(&value),
        )
    }

    /// A derivative of the generated code, as the sum of its terms, against one by differences.
    fn hold(&self, order: u32, terms: Vec<f64>, known: Option<Slope>) -> Result<bool, Shortfall> {
        let Some(Slope { value: stated, uncertainty, scale }) = known else { return Ok(false) };
        let generated: f64 = terms.iter().sum();
        if scale == 0.0 && generated == 0.0 {
            return Ok(true);
        }
        let size = f64::max(scale, terms.iter().map(|term| term.abs()).sum());
        if !within(uncertainty, KNOWN * size) {
            return Ok(false);
        }
        // Beside the differences, the generated code rounds: half of the digits allow for any sum that is of use.
        let tolerance = SAFETY * uncertainty + f64::EPSILON.sqrt() * size;
        if within(generated - stated, tolerance) {
            return Ok(true);
        }
        let (time, state) = (self.time, numbers(self.state).collect());
        let Values { name: function, .. } = self.system.values(self.function, self.state, self.time);
        Err(Shortfall::Derivative { function, order, stated, generated, tolerance, time, state })
    }
}

/// A derivative by differences.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    pub(crate) value: f64,
    pub(crate) uncertainty: f64,
    /// The size of the differences that it was made of.
    pub(crate) scale: f64,
}

/// The derivative at zero of a function that returns its rounding too; `None` where no two widths lead to the same, or
/// where the slopes from both sides differ.
pub(crate) fn slope_of(value: &dyn Fn(f64) -> [f64; 2]) -> Option<Slope> {
    let mut best: Option<Slope> = None;
    for width in WIDTHS {
        let Some(slope) = extrapolated(value, width) else { continue };
        if let Some(before) = best {
            let both = before.uncertainty + slope.uncertainty;
            let still = before.scale == 0.0 && slope.scale == 0.0;
            if (still || within(both, KNOWN * before.scale)) && within(before.value - slope.value, both) {
                return Some(if slope.uncertainty < before.uncertainty { slope } else { before });
            }
        }
        best = Some(slope);
    }
    None
}

/// The derivative at zero from differences over a width and its halves, by Richardson's extrapolation: central ones,
/// whose error is a series in the square of the width, and those to either side, in its powers, which have to agree
/// with each other or there is a kink in between.
fn extrapolated(value: &dyn Fn(f64) -> [f64; 2], width: f64) -> Option<Slope> {
    let [middle, mut rounding] = value(0.0);
    let (mut central, mut right, mut left) = ([0.0; LEVELS], [0.0; LEVELS], [0.0; LEVELS]);
    let mut narrowest = width;
    for level in 0..LEVELS {
        narrowest = width / (1_u32 << level) as f64;
        let [[above, of_above], [below, of_below]] = [value(narrowest), value(-narrowest)];
        rounding = f64::max(rounding, f64::max(of_above, of_below));
        central[level] = (above - below) / (2.0 * narrowest);
        right[level] = (above - middle) / narrowest;
        left[level] = (middle - below) / narrowest;
    }
    let scale = largest([right[0], left[0]]);
    if right.iter().chain(&left).all(|difference| *difference == 0.0) {
        // Nothing changes over the whole width by more than a rounding.
        return Some(Slope { value: 0.0, uncertainty: 2.0 * rounding / width, scale });
    }
    // The weights of an extrapolation add up to less than 2 in size where errors fall by four, and to 9 where by two.
    let noise = rounding / narrowest;
    let [(value, error), (right, of_right), (left, of_left)] =
        [(central, 4.0), (right, 2.0), (left, 2.0)].map(|(differences, fall)| limit(differences, fall));
    let uncertainty = error + 2.0 * noise;
    let one_sided = of_right + of_left + 18.0 * noise;
    let smooth = within(right - left, SAFETY * one_sided) && within(one_sided, KNOWN.sqrt() * scale);
    let known = smooth && uncertainty.is_finite();
    known.then_some(Slope { value, uncertainty, scale })
}

/// The limit of a sequence whose error is a series in powers of `1/fall`, and its last correction.
fn limit(mut row: [f64; LEVELS], fall: f64) -> (f64, f64) {
    let mut error = f64::INFINITY;
    let mut factor = 1.0;
    for column in 1..LEVELS {
        factor *= fall;
        let before = row[LEVELS - 1];
        for level in (column..LEVELS).rev() {
            row[level] += (row[level] - row[level - 1]) / (factor - 1.0);
        }
        error = f64::max((row[LEVELS - 1] - before).abs(), (row[LEVELS - 1] - row[LEVELS - 2]).abs());
    }
    (row[LEVELS - 1], error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_found_where_there_are_any() {
        type Function = fn(f64) -> f64;
        let smooth: [(&str, Function, f64); 6] = [
            ("sin", |x| (0.3 + x).sin(), 0.3_f64.cos()),
            ("1/r", |x| 1.0 / (0.001 + x).abs(), -1e6),
            ("a fast wave", |x| (1e3 * x).sin(), 1e3),
            ("a constant", |_| 7.0, 0.0),
            ("a parabola at rest", |x| 0.5 * x * x, 0.0),
            ("a kink nearby", |x| (x - 1e-3).abs(), -1.0),
        ];
        for (name, function, expected) in smooth {
            let found = slope_of(&|x| [function(x), 4.0 * f64::EPSILON * function(x).abs()]);
            let Slope { value, uncertainty, scale } = found.unwrap_or_else(|| panic!("{name} has a slope"));
            assert!((value - expected).abs() <= SAFETY * uncertainty, "{name}: {found:?}");
            assert!(uncertainty <= KNOWN * scale.max(1.0), "{name}: {found:?}");
        }
        let rough: [(&str, Function); 4] = [
            ("a kink", f64::abs),
            ("a jump", |x| if x < 0.0 { 1.0 } else { 2.0 }),
            ("a cusp", |x| x.abs().sqrt()),
            ("the edge of a domain", f64::sqrt),
        ];
        for (name, function) in rough {
            let found = slope_of(&|x| [function(x), 4.0 * f64::EPSILON * function(x).abs()]);
            assert!(found.is_none_or(|slope| slope.uncertainty > KNOWN * slope.scale), "{name}: {found:?}");
        }
    }
}
