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
            energies::{Energies, read_by, slopes},
            gradient::Gradient,
            part_flows::Flows,
            slope::{KNOWN, SAFETY, Slope, slope_of},
        },
        statistics::points::{numbers, origin},
    },
    error::Misread,
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

/// A value or a derivative of the generated code that is not that of the user's function.
pub(crate) enum Disagreement {
    Misread(Misread),
    /// A derivative of a function, with the fields of `Shortfall::Derivative`.
    Derivative {
        function: &'static str,
        order: u32,
        stated: f64,
        generated: f64,
        tolerance: f64,
        time: f64,
        state: Vec<f64>,
    },
}

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
) -> Result<Result<Agreement, CheckError>, Vec<Disagreement>> {
    let (mut agreement, mut disagreements) = (Agreement::default(), Vec::new());
    for function in Function::BOTH {
        let outcome = states.iter().try_for_each(|(state, time)| {
            match hold(state, *time, &|state| system.values(function, state, *time)).map_err(Disagreement::Misread)? {
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
        disagreements.extend(outcome.err());
    }
    for number in 0..system.energies().invariants().len() {
        let mut held =
            states.iter().map(|(state, time)| hold(state, *time, &|state| system.invariant_values(number, state)));
        disagreements.extend(held.find_map(Result::err).map(Disagreement::Misread));
    }
    match agreement {
        _ if !disagreements.is_empty() => Err(disagreements),
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
        Gradient::new(system, self.function, self.time).flow(&read_by(system, self.function, state), None)
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
    fn slope(&self, direction: &[f64]) -> Result<bool, Disagreement> {
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
    fn tangent(&self, direction: &[f64]) -> Result<bool, Disagreement> {
        let mut digits = Digits::default();
        let weights: Vec<f64> = direction.iter().map(|_| 1.5 + 0.5 * digits.next()).collect();
        let system = self.system.energies();
        let value = |distance| {
            let state = self.moved(direction, distance);
            let terms = self.generated(&state).into_iter().zip(&weights);
            let terms: Vec<f64> = terms.map(|(slope, weight)| slope * weight).collect();
            // Beside the sum, each force rounds by what cancels in it, where a bound on that is known.
            let of_forces = system.flow_rounding(self.function, &read_by(system, self.function, &state), self.time);
            let of_forces: f64 = of_forces.iter().zip(&weights).map(|(bound, weight)| bound * weight).sum();
            let of_sum = f64::EPSILON * terms.iter().map(|term| term.abs()).sum::<f64>();
            [terms.iter().sum(), of_sum + if of_forces.is_finite() { of_forces } else { 0.0 }]
        };
        let along = self.with(&origin(self.state), direction.iter().copied());
        let gradient = Gradient::new(system, self.function, self.time);
        let tangents = gradient.flow(&read_by(system, self.function, self.state), Some(&along));
        self.hold(
            2,
            tangents.into_iter().zip(&weights).map(|(tangent, weight)| tangent * weight).collect(),
            slope_of(&value),
        )
    }

    /// A derivative of the generated code, as the sum of its terms, against one by differences.
    fn hold(&self, order: u32, terms: Vec<f64>, known: Option<Slope>) -> Result<bool, Disagreement> {
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
        Err(Disagreement::Derivative { function, order, stated, generated, tolerance, time, state })
    }
}
