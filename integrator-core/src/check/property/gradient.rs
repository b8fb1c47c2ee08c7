//! Comparison of the gradients of the energies with the flows.
//!
//! In: a system and a point. Out: the largest difference between a component of the generated gradient and the exact
//! derivative of the generated energy. Always true: the gradient is the increment of a kick or a drift of unit
//! duration, and the derivative comes from dual numbers through the energy, so both are independent. Central
//! differences, which need no dual numbers, confirm the derivative coarsely.

use crate::{
    check::{
        CheckError,
        property::{flow_laws::generator_error, part_flows::Flows},
        start::{IntoStart, Start},
        statistics::points::{begin, coordinate, numbers, origin},
    },
    hamiltonian::Hamiltonian,
    methods::implicit::field::{Constants, Pair, field},
    scalar::{
        bounded::Bounded,
        dual::Dual,
        real::Real,
        tolerance::{largest, ratio, within},
    },
    state::{
        coords::Coords,
        flat::{Flat, flat, shaped},
        phase::Phase,
        precision::Precision,
    },
    system::{
        Shaped,
        motion::{Motion, Prepared},
        user_energies::bounded_energy,
    },
};

/// Returns the largest error of the generated gradients of `T` and `V` at `point` and `time`, in units of rounding
/// errors.
///
/// The error of a component `g` is divided by its condition: `|g| + Σ |∂g/∂xⱼ|·x` with the largest coordinate `x`.
/// Rounding of the coordinates changes `g` by ε times that. A running error analysis adds the rounding within the
/// formulas of `g`. A tiny component is hence compared with its own size, and cancellation of large terms is not
/// counted as an error.
///
/// `point` is a [`Phase`] or a [`Start`], by value or by reference. `time` counts from the time of a `Start`.
///
/// If the parts of `H` are not `T(p)` and `V(q)`, the derivative of each flow by its duration is compared with the
/// gradient of the energy. The result is the largest difference that finite differences do not explain, in units of
/// that derivative.
///
/// # Errors
/// - The point is invalid for a run, or `time` is not finite.
/// - An energy has no derivative at the point, or a flow has no finite one.
pub fn gradient_error<H: Hamiltonian, K: Precision>(
    system: &H,
    point: impl IntoStart<Shaped<H, K>, Leaf = K>,
    time: f64,
) -> Result<f64, CheckError> {
    let Start { phase, time: begin_at } = point.into_start();
    let time = begin_at + time;
    let point = begin::<H, _, K>(system, H::Compose::default(), &phase.at_time(time), 1.0)?.phase;
    error_at(&Energies::new(system, &point), &flat(&point), time)
}

/// [`gradient_error`] at a point that a run may begin with.
pub(crate) fn error_at(system: &dyn Flows, point: &Flat, time: f64) -> Result<f64, CheckError> {
    if !system.is_separable() && !system.in_one_piece() {
        return generator_error(system, point, time);
    }
    let error = |part| Gradient::new(system, part, time).error(point);
    let error = largest([error(Part::Kinetic)?, error(Part::Potential)?]);
    if error.is_nan() { Err(CheckError::NotFinite { what: "a force or a velocity" }) } else { Ok(error) }
}

/// The tolerance of a component of a gradient over `coordinates` coordinates: a sum of as many terms,
/// each of some operations and elementary functions of up to 4 ulp, evaluated twice, as code and through duals, whose
/// chain rule rounds a few times more.
pub(crate) fn gradient_tolerance(coordinates: usize) -> f64 {
    32.0 * (coordinates + 1) as f64 * f64::EPSILON
}

/// One of the two energies. The gradient of `T` or of `V` is by the half of the coordinates that it reads, and moves the
/// other half.
pub(crate) use crate::system::user_energies::Function as Part;

/// The energies of a system and their flows, whatever the shape of its coordinates: in one lane, or along a tangent in
/// the second one of duals.
pub(crate) trait Differentiable {
    /// Whether the energies are `T(p)` and `V(q)`.
    fn is_separable(&self) -> bool;

    /// Whether H has no parts: all of its energy is then the first of the two, and its field moves both halves.
    fn in_one_piece(&self) -> bool;

    /// An energy, and a bound on its rounding.
    fn bounded_energy(&self, part: Part, point: &Flat, time: f64) -> [f64; 2];

    /// An energy, or its derivative along a tangent.
    fn energy(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> f64;

    /// The derivative of an energy along a tangent, and a bound on its rounding.
    fn bounded_slope(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> [f64; 2];

    /// The names of what the user says is conserved.
    fn invariants(&self) -> &'static [&'static str];

    /// An invariant, or its derivative along a tangent.
    fn invariant(&self, number: usize, point: &Flat, tangent: Option<&Flat>) -> f64;

    /// The gradient of `T` or of `V`, or the derivative of that along a tangent.
    fn flow(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> Vec<f64>;

    /// Bounds on the rounding of the components of the gradient of `T` or of `V`.
    fn flow_rounding(&self, part: Part, point: &Flat, time: f64) -> Vec<f64>;
}

/// The energies of a system with its parameters, and a point in the shape of its coordinates.
pub(crate) struct Energies<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) parameters: H::Parameters<f64>,
    pub(crate) shape: &'s Phase<H::Coords>,
}

impl<'s, H: Hamiltonian> Energies<'s, H> {
    pub(crate) fn new(system: &'s H, shape: &'s Phase<H::Coords>) -> Self {
        Self { system, parameters: system.parameters(shape.q.length()), shape }
    }
}

impl<H: Hamiltonian> Differentiable for Energies<'_, H> {
    fn is_separable(&self) -> bool {
        H::SEPARABLE
    }

    fn in_one_piece(&self) -> bool {
        H::PARTS.is_empty()
    }

    fn bounded_energy(&self, part: Part, point: &Flat, time: f64) -> [f64; 2] {
        bounded_energy::<H>(part, &self.parameters, &shaped(self.shape, point), time)
    }

    fn energy(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> f64 {
        let point = shaped(self.shape, point);
        match tangent {
            None => energy::<H, f64>(&self.parameters, part, [&point, &point], time).lane(0),
            Some(tangent) => {
                let tangent = shaped(self.shape, tangent);
                energy::<H, Dual>(&self.parameters, part, [&point, &tangent], time).lane(1)
            }
        }
    }

    fn bounded_slope(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> [f64; 2] {
        let [point, tangent] = [point, tangent].map(|numbers| shaped(self.shape, numbers));
        // The value and the tangent, then the bounds on both.
        let lanes = [&point, &tangent, &point, &tangent];
        let motion = H::Motion::<Dual<Bounded>, f64>::load(&[&self.parameters; 4], &lanes);
        let energy = match part {
            Part::Kinetic => H::kinetic::<Dual<Bounded>, f64>(&motion, time),
            Part::Potential => H::potential::<Dual<Bounded>, f64>(&motion, time),
        };
        [energy.lane(1), energy.lane(3)]
    }

    fn invariants(&self) -> &'static [&'static str] {
        H::INVARIANTS
    }

    fn invariant(&self, number: usize, point: &Flat, tangent: Option<&Flat>) -> f64 {
        if const { H::INVARIANTS.is_empty() } {
            return f64::NAN;
        }
        let point = shaped(self.shape, point);
        match tangent {
            None => H::invariant::<f64, f64>(&H::Motion::load(&[&self.parameters], &[&point]), number),
            Some(tangent) => {
                let lanes = [&point, &shaped(self.shape, tangent)];
                H::invariant::<Dual, f64>(&H::Motion::load(&[&self.parameters; 2], &lanes), number).lane(1)
            }
        }
    }

    fn flow(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> Vec<f64> {
        let point = shaped(self.shape, point);
        match tangent {
            None => flow::<H, f64>(&self.parameters, part, [&point, &point], time, 0),
            Some(tangent) => {
                let tangent = shaped(self.shape, tangent);
                flow::<H, Dual>(&self.parameters, part, [&point, &tangent], time, 1)
            }
        }
    }

    fn flow_rounding(&self, part: Part, point: &Flat, time: f64) -> Vec<f64> {
        let point = shaped(self.shape, point);
        let bounds = flow::<H, Bounded>(&self.parameters, part, [&point, &point], time, 1);
        bounds.into_iter().map(f64::abs).collect()
    }
}

/// An energy at a point, with a tangent in the second lane if there is one.
fn energy<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: [&Phase<H::Coords>; 2],
    time: f64,
) -> R {
    let motion = H::Motion::<R, f64>::load(&[parameters; 2], &lanes);
    match part {
        Part::Kinetic => H::kinetic::<R, f64>(&motion, time),
        Part::Potential => H::potential::<R, f64>(&motion, time),
    }
}

/// One lane of the gradient of an energy at a point, with a tangent in the second lane if there is one: what the flow
/// of unit duration adds to the half that is moved, from zero.
pub(crate) fn flow<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: [&Phase<H::Coords>; 2],
    time: f64,
    lane: usize,
) -> Vec<f64> {
    if const { H::PARTS.is_empty() } {
        return half_of_field::<H, R>(parameters, part, &lanes[..R::LANES], time, lane);
    }
    let mut motion = H::Motion::<R, f64>::load(&[parameters; 2], &lanes);
    H::begin_step::<R, f64>(&mut motion, time);
    let mut moved = lanes[0].clone();
    match part {
        Part::Kinetic => {
            H::drift::<R, f64>(&mut motion, 1.0, time);
            motion.store(lane, &mut moved);
            moved.q.flat().to_vec()
        }
        Part::Potential => {
            H::kick::<R, f64>(&mut motion, 1.0, time);
            motion.store(lane, &mut moved);
            negated(moved.p.flat())
        }
    }
}

/// One half of a field that moves positions and momenta together, as a gradient.
fn half_of_field<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: &[&Phase<H::Coords>],
    time: f64,
    lane: usize,
) -> Vec<f64> {
    let mut gathered = H::Parameters::<R>::gather(&vec![parameters; lanes.len()]);
    gathered.begin_step(time);
    let constants = Constants { gathered: &gathered, of_lanes: &[], shape: lanes[0], middle: time };
    let point = Pair { q: H::Coords::pack(lanes, |point| &point.q), p: H::Coords::pack(lanes, |point| &point.p) };
    let Pair { q: velocity, p: force } = field::<H, R>(&constants, &point, time);
    let lane = |slots: &<H::Coords as Coords>::Slots<R>| -> Vec<f64> {
        H::Coords::slots(slots).iter().map(|slot| slot.lane(lane)).collect()
    };
    match part {
        Part::Kinetic => lane(&velocity),
        Part::Potential => negated(&lane(&force)),
    }
}

fn negated(numbers: &[f64]) -> Vec<f64> {
    numbers.iter().map(|number| -number).collect()
}

/// The gradient of `T` or of `V` at a time.
pub(crate) struct Gradient<'s> {
    system: &'s (dyn Differentiable + 's),
    part: Part,
    time: f64,
}

impl<'s> Gradient<'s> {
    pub(crate) fn new(system: &'s (dyn Differentiable + 's), part: Part, time: f64) -> Self {
        Self { system, part, time }
    }

    /// The largest error of a component, in units of its condition.
    fn error(&self, point: &Flat) -> Result<f64, CheckError> {
        let still = origin(point);
        let in_one_piece = self.system.in_one_piece();
        let point = match self.part {
            _ if in_one_piece => point.clone(),
            Part::Kinetic => Phase { q: still.q.clone(), p: point.p.clone() },
            Part::Potential => Phase { q: point.q.clone(), p: still.p.clone() },
        };
        let extent = largest(numbers(&point));
        let generated = self.flow(&point, None);
        let roundings = self.system.flow_rounding(self.part, &point, self.time);
        let unit = gradient_tolerance(still.q.len());
        let mut exact = Vec::with_capacity(generated.len());
        let mut conditions: Vec<f64> = generated.iter().map(|component| component.abs()).collect();
        for index in 0..generated.len() {
            let mut along = still.clone();
            *self.read(&mut along, index) = 1.0;
            let derivative = self.energy(&point, Some(&along));
            self.witness(&point, index, extent, derivative)?;
            exact.push(derivative);
            let rounding = roundings[index] + self.slope_rounding(&point, &along);
            // Where no bound is known, the condition alone has to do.
            conditions[index] += if rounding.is_finite() { rounding / unit } else { 0.0 };
            if in_one_piece {
                let mut across = still.clone();
                *self.read_by(self.part == Part::Potential, &mut across, index) = 1.0;
                self.add_curvature(&mut conditions, (&point, &across), extent);
            }
            self.add_curvature(&mut conditions, (&point, &along), extent);
        }
        let errors = exact.iter().zip(&generated).zip(&conditions);
        Ok(largest(errors.map(|((exact, generated), condition)| ratio(exact - generated, *condition))))
    }

    /// Adds what a change of coordinates in a direction, as large as these are, does to each component.
    fn add_curvature(&self, conditions: &mut [f64], (point, direction): (&Flat, &Flat), extent: f64) {
        for (condition, curvature) in conditions.iter_mut().zip(self.flow(point, Some(direction))) {
            *condition += curvature.abs() * extent;
        }
    }

    /// Whether central differences agree with a derivative by duals. With the width `d` they are off by `c·d²` and the
    /// rounding of the energy over `d`; the difference over twice the width gives `3·c·d²`, and `d = ε^(1/3)` of the
    /// scale of the energy balances the two. That scale may be much shorter than the coordinates are long, where two
    /// bodies are close: then a narrower width shows it. At a kink none does.
    fn witness(&self, point: &Flat, index: usize, extent: f64, dual: f64) -> Result<(), CheckError> {
        const NARROWING: [f64; 4] = [1.0, 3e-2, 1e-3, 3e-5];
        let scale = f64::EPSILON.cbrt() * if extent > 0.0 { extent } else { 1.0 };
        let differences = NARROWING.map(|narrowing| self.difference(point, index, extent, dual, narrowing * scale));
        let agrees = |&(difference, uncertainty): &(f64, f64)| within(difference - dual, uncertainty);
        if differences.iter().any(agrees) {
            return Ok(());
        }
        // Terms that cancel in the energy have larger rounding errors than its size suggests.
        let rounding = |narrowing: f64| self.difference_rounding(point, index, narrowing * scale);
        let bounded = differences.iter().zip(NARROWING);
        let mut bounded = bounded.map(|((value, uncertainty), narrowing)| (*value, uncertainty + rounding(narrowing)));
        if bounded.any(|difference| agrees(&difference)) {
            return Ok(());
        }
        let energy = if self.part == Part::Kinetic { "T" } else { "V" };
        let (difference, uncertainty) = differences[0];
        Err(CheckError::NotDifferentiable { energy, index, dual, difference, uncertainty })
    }

    /// The central difference of a width, and a bound on its truncation and rounding errors.
    fn difference(&self, point: &Flat, index: usize, extent: f64, dual: f64, width: f64) -> (f64, f64) {
        let energy = |offset: f64| {
            let mut moved = point.clone();
            *self.read(&mut moved, index) += offset;
            self.energy(&moved, None)
        };
        let [narrow, wide] = [width, 2.0 * width].map(|width| (energy(width) - energy(-width)) / (2.0 * width));
        let terms = energy(width).abs() + (dual * extent).abs();
        let rounding = gradient_tolerance(point.q.flat().len()) * terms / width;
        (narrow, (wide - narrow).abs() + rounding)
    }

    /// A bound on the rounding of the central differences of a width and of twice the width.
    fn difference_rounding(&self, point: &Flat, index: usize, width: f64) -> f64 {
        let at = |offset: f64| {
            let mut moved = point.clone();
            *self.read(&mut moved, index) += offset;
            self.system.bounded_energy(self.whole(), &moved, self.time)[1]
        };
        // Each of four values over twice the width or four times that, in the difference and in its uncertainty.
        largest([-2.0, -1.0, 1.0, 2.0].map(|steps| at(steps * width))) * 3.0 / width
    }

    /// A coordinate that this energy reads.
    fn read<'p>(&self, point: &'p mut Flat, index: usize) -> &'p mut f64 {
        self.read_by(self.part == Part::Kinetic, point, index)
    }

    /// A momentum, or a position.
    fn read_by<'p>(&self, is_momentum: bool, point: &'p mut Flat, index: usize) -> &'p mut f64 {
        let first = if is_momentum { point.q.flat().len() } else { 0 };
        coordinate(point, first + index)
    }

    /// The energy, or its derivative along a tangent.
    fn energy(&self, point: &Flat, tangent: Option<&Flat>) -> f64 {
        self.system.energy(self.whole(), point, tangent, self.time)
    }

    /// A bound on the rounding of the derivative of the energy along a tangent.
    fn slope_rounding(&self, point: &Flat, tangent: &Flat) -> f64 {
        self.system.bounded_slope(self.whole(), point, tangent, self.time)[1]
    }

    /// The energy that has this gradient: all of H, where that has no parts.
    fn whole(&self) -> Part {
        if self.system.in_one_piece() { Part::Kinetic } else { self.part }
    }

    /// The gradient, or its derivative along a tangent.
    pub(crate) fn flow(&self, point: &Flat, tangent: Option<&Flat>) -> Vec<f64> {
        self.system.flow(self.part, point, tangent, self.time)
    }
}
