//! Comparison of the gradients of the energies with the flows.
//!
//! In: a system and a point. Out: the largest difference between a component of the generated gradient and the exact
//! derivative of the generated energy. Always true: the gradient is the increment of a kick or a drift of unit
//! duration, and the derivative comes from dual numbers through the energy, so both are independent. Central
//! differences, which need no dual numbers, confirm the derivative coarsely.

use crate::{
    check::{
        CheckError,
        property::{
            energies::{Differentiable, Energies, Part, gradient_tolerance, read_by},
            flow_laws::generator_error,
            part_flows::Flows,
        },
        start::{IntoStart, Start},
        statistics::points::{begin, coordinate, numbers, origin},
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, ratio, within},
    state::{
        coords::Coords,
        flat::{Flat, flat},
        precision::Precision,
    },
    system::Shaped,
};

/// Returns the largest error of the generated gradients of `T` and `V` at `point` and `time`, in units of rounding
/// errors.
///
/// The error of a component `g` is divided by its condition: `|g| + Σ |∂g/∂xⱼ|·x` with the largest coordinate `x`.
/// Rounding of the coordinates changes `g` by ε times that. A running error analysis adds the rounding within the
/// formulas of `g`. A tiny component is hence compared with its own size, and cancellation of large terms is not
/// counted as an error.
///
/// `point` is a [`Phase`](crate::Phase) or a [`Start`], by value or by reference. `time` counts from the time of a `Start`.
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
        let point = read_by(self.system, self.part, point);
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
