//! Comparison of the flows of the parts of `H` with their energies and with the properties of exact flows.
//!
//! In: a system whose parts are not `T(p)` and `V(q)`, a point, a duration. Out: the error of each flow in
//! symplecticity, inversion, addition of durations, conservation of its energy, and agreement with the gradient of its
//! energy. Always true:
//!
//! - Derivatives of flows by the point and of energies are exact, by dual numbers.
//! - Derivatives by the duration are extrapolated differences that agree for two widths.
//! - A flow without an error so far is integrated for a long time (`course.rs`).
//! - The flow and its energy are computed independently, so neither a solver nor a hand-written flow is trusted.

use crate::{
    check::{
        CheckError,
        flow::Flow,
        oracle::tangent::{Carry, matrix},
        property::{
            course::Course,
            energies::{Part, gradient_tolerance, slopes},
            part_flows::Flows,
            slope::{KNOWN, SAFETY, Slope, slope_of},
            symplecticity::{Defect, defect_of},
        },
        statistics::points::{coordinate, numbers, origin},
    },
    scalar::tolerance::{largest, ratio, within},
    state::flat::Flat,
};
use nalgebra::DMatrix;
use std::{cell::RefCell, collections::BTreeMap, fmt};

/// A property of exact flows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlowLaw {
    /// The tangent map of the flow preserves the symplectic form.
    Symplecticity,
    /// The flow for the negative duration inverts the flow.
    Inverse,
    /// The flow for a duration, followed by the flow for another one, is the flow for the sum of both.
    Addition,
    /// The flow conserves the energy of its part.
    Energy,
    /// The derivative of the flow by its duration is the Hamiltonian vector field of its part, at the beginning and
    /// along the flow.
    Generator,
}

impl fmt::Display for FlowLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Symplecticity => "is not symplectic",
            Self::Inverse => "is not inverted by the flow for the negative duration",
            Self::Addition => "does not add up: two flows in sequence differ from one flow for the whole duration",
            Self::Energy => "does not conserve the energy of its part",
            Self::Generator => "does not have the vector field of the energy of its part",
        })
    }
}

/// The errors of the flows of parts, in units of rounding errors: at most 1 if the flows are correct.
///
/// The unit of the generator contains the error of finite differences as well. NaN if a flow is not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FlowErrors {
    /// The error of [`FlowLaw::Symplecticity`].
    pub symplecticity: f64,
    /// The error of [`FlowLaw::Inverse`].
    pub inverse: f64,
    /// The error of [`FlowLaw::Addition`].
    pub addition: f64,
    /// The error of [`FlowLaw::Energy`], for parts whose energy is known separately.
    pub energy: f64,
    /// The error of [`FlowLaw::Generator`].
    pub generator: f64,
}

impl FlowErrors {
    /// The larger one of each two errors.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            symplecticity: largest([self.symplecticity, other.symplecticity]),
            inverse: largest([self.inverse, other.inverse]),
            addition: largest([self.addition, other.addition]),
            energy: largest([self.energy, other.energy]),
            generator: largest([self.generator, other.generator]),
        }
    }

    fn of(&mut self, law: FlowLaw) -> &mut f64 {
        match law {
            FlowLaw::Symplecticity => &mut self.symplecticity,
            FlowLaw::Inverse => &mut self.inverse,
            FlowLaw::Addition => &mut self.addition,
            FlowLaw::Energy => &mut self.energy,
            FlowLaw::Generator => &mut self.generator,
        }
    }
}

/// A flow that breaks a law.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Broken {
    pub(crate) part: String,
    pub(crate) law: FlowLaw,
    pub(crate) error: f64,
    pub(crate) tolerance: f64,
    pub(crate) duration: f64,
}

/// The errors of all flows at a point for flows of about this duration, and the worst offence against each law.
///
/// # Errors
/// A flow that is not finite, or whose derivative by the duration could be found for no coordinate.
pub(crate) fn flow_errors(
    system: &dyn Flows,
    point: &Flat,
    time: f64,
    duration: f64,
) -> Result<(FlowErrors, Vec<Broken>), CheckError> {
    let mut judged = Judged { system, errors: FlowErrors::default(), broken: Vec::new() };
    let measured = Measured { system, point, time, duration: with_exact_quarters(duration) };
    if system.copies() {
        // What they do to one copy alone is no flow.
        let FlowErrors { symplecticity, inverse, addition, energy, .. } = &mut judged.errors;
        [symplecticity, inverse, addition, energy].into_iter().for_each(|error| *error = f64::NAN);
    } else {
        for flow in flows(system) {
            measured.laws(flow, &mut judged)?;
        }
    }
    for (part, flows) in parts(system) {
        measured.generator(part, &flows, &mut judged)?;
    }
    Ok((judged.errors, judged.broken))
}

/// The largest error of the derivative of a flow by the duration, beyond the uncertainty of its differences.
pub(crate) fn generator_error(system: &dyn Flows, point: &Flat, time: f64) -> Result<f64, CheckError> {
    let measured = Measured { system, point, time, duration: 1.0 };
    let mut errors = Vec::new();
    for (part, flows) in parts(system) {
        let derivatives = measured.derivatives(part, &flows)?;
        errors.extend(derivatives.iter().map(|derivative| derivative.excess()));
    }
    Ok(largest(errors))
}

/// The flows of a system.
fn flows(system: &dyn Flows) -> Vec<Flow> {
    let middle = (system.parts().len() > 2).then_some(Flow::Middle { backwards: false });
    [Some(Flow::First), middle, Some(Flow::Last)].into_iter().flatten().collect()
}

/// The energies of a system, each with the flows that share it.
fn parts(system: &dyn Flows) -> [(Part, Vec<Flow>); 2] {
    let all = flows(system);
    // Both copies have the whole of H together, where they begin as one.
    let first = if system.copies() { 2 } else { 1 };
    [(Part::Kinetic, all[..first].to_vec()), (Part::Potential, all[first..].to_vec())]
}

/// The names of the parts that a flow belongs to.
fn name(system: &dyn Flows, flow: Flow) -> String {
    let names = system.parts();
    let last = names.len().saturating_sub(1);
    let of = match flow {
        Flow::First => &names[..1.min(names.len())],
        Flow::Middle { .. } => &names[1.min(last)..last],
        Flow::Last => &names[last..],
    };
    of.join(" + ")
}

/// The flow that undoes this one for the negative duration.
fn backwards(flow: Flow) -> Flow {
    match flow {
        Flow::Middle { backwards } => Flow::Middle { backwards: !backwards },
        other => other,
    }
}

/// A duration without its last bits, so that a quarter and three quarters of it are numbers.
fn with_exact_quarters(duration: f64) -> f64 {
    f64::from_bits(duration.to_bits() & !0b11)
}

/// The errors and the violations found so far.
struct Judged<'s> {
    system: &'s dyn Flows,
    errors: FlowErrors,
    broken: Vec<Broken>,
}

impl Judged<'_> {
    fn judge(&mut self, flows: &[Flow], law: FlowLaw, duration: f64, error: f64, tolerance: f64) {
        let worst = self.errors.of(law);
        let before = *worst;
        *worst = largest([before, ratio(error, tolerance)]);
        if !within(error, tolerance) {
            let names: Vec<String> = flows.iter().map(|flow| name(self.system, *flow)).collect();
            self.broken.push(Broken { part: names.join(" + "), law, error, tolerance, duration });
        }
    }

    /// Judges the component of a vector that is the farthest off.
    fn judge_all(&mut self, flow: Flow, law: FlowLaw, duration: f64, errors: &[f64], tolerances: &[f64]) {
        let off = |index: &usize| ratio(errors[*index].abs(), tolerances[*index]);
        if let Some(index) = (0..errors.len()).max_by(|a, b| off(a).total_cmp(&off(b))) {
            self.judge(&[flow], law, duration, errors[index], tolerances[index]);
        }
    }
}

/// The flows of a system at a point.
struct Measured<'s> {
    system: &'s dyn Flows,
    point: &'s Flat,
    time: f64,
    duration: f64,
}

/// One flow from one point: where it leads, its tangent map, and the rounding of where it leads.
struct Image {
    end: Flat,
    map: DMatrix<f64>,
    /// A flow rounds its state a few times, as often as a component of a gradient is rounded; what is rounded at the
    /// beginning is carried to the end by the tangent map: `|z'| + |M| |z|` in these units.
    rounding: Vec<f64>,
}

/// One flow, as the tangent maps of steps see it.
struct Single<'s> {
    system: &'s dyn Flows,
    flow: Flow,
    duration: f64,
}

impl Carry for Single<'_> {
    fn carry(&self, point: &Flat, tangent: &Flat, t0: f64, _steps: u64) -> (Flat, Flat) {
        self.system.carried(&[(self.flow, self.duration)], point, Some(tangent), t0)
    }
}

impl Measured<'_> {
    fn image(&self, flow: Flow, duration: f64, point: &Flat) -> Result<Image, CheckError> {
        let (end, _) = self.system.carried(&[(flow, duration)], point, None, self.time);
        let map = matrix(&Single { system: self.system, flow, duration }, point, self.time, 1);
        if !numbers(&end).chain(map.iter().copied()).all(f64::is_finite) {
            return Err(CheckError::NotFinite { what: "the flow of a part, or its derivative," });
        }
        let sizes: Vec<f64> = numbers(point).map(f64::abs).collect();
        let carried = through(&map, &sizes);
        let unit = gradient_tolerance(point.q.len());
        let mut rounding: Vec<f64> =
            numbers(&end).zip(carried).map(|(end, carried)| unit * (end.abs() + carried)).collect();
        if self.system.mixes() {
            for half in rounding.chunks_mut(point.q.len()) {
                half.fill(largest(half.iter().copied()));
            }
        }
        Ok(Image { end, map, rounding })
    }

    /// Tests the laws of a flow that hold for every energy, and that the flow conserves its energy.
    fn laws(&self, flow: Flow, judged: &mut Judged<'_>) -> Result<(), CheckError> {
        let Self { system, point, time, duration } = *self;
        let there = self.image(flow, duration, point)?;
        let roundings = (1.0 + point.q.len() as f64) * system.tangent_error();
        let Defect { size, tolerance } = defect_of(there.map.clone(), roundings);
        judged.judge(&[flow], FlowLaw::Symplecticity, duration, size, tolerance);

        let back = self.image(backwards(flow), -duration, &there.end)?;
        judged.judge_all(flow, FlowLaw::Inverse, duration, &apart(&back.end, point), &back.after(&there));

        // Several flows in a row are no flow of one part.
        let is_one = flow == Flow::First || flow == Flow::Last || system.parts().len() == 3;
        if is_one {
            let first = self.image(flow, duration / 4.0, point)?;
            let second = self.image(flow, duration - duration / 4.0, &first.end)?;
            let rounding = second.after(&first);
            let tolerances: Vec<f64> = rounding.iter().zip(&there.rounding).map(|(one, other)| one + other).collect();
            judged.judge_all(flow, FlowLaw::Addition, duration, &apart(&second.end, &there.end), &tolerances);
        }

        let part = if flow == Flow::First { Part::Kinetic } else { Part::Potential };
        if flow == Flow::First || system.parts().len() < 3 {
            let [[before, of_before], [after, of_after]] =
                [point, &there.end].map(|point| system.bounded_energy(part, point, time));
            let slopes = slopes(system, part, &there.end, time);
            let moved: f64 = slopes.iter().zip(&there.rounding).map(|(slope, rounding)| slope.abs() * rounding).sum();
            judged.judge(&[flow], FlowLaw::Energy, duration, after - before, of_before + of_after + moved);
        }
        Ok(())
    }

    /// Whether flows leave a point along the vector field of the energy that they share.
    fn generator(&self, part: Part, flows: &[Flow], judged: &mut Judged<'_>) -> Result<(), CheckError> {
        let derivatives = self.derivatives(part, flows)?;
        if let Some(worst) = derivatives.iter().max_by(|a, b| a.share().total_cmp(&b.share())) {
            judged.judge(flows, FlowLaw::Generator, worst.unit, worst.error(), worst.tolerance());
        }
        // Several flows share an energy at the beginning alone, and a flow that breaks another law is reported already.
        let Self { system, point, time, .. } = *self;
        if let &[flow] = flows
            && judged.broken.is_empty()
        {
            let course = Course { system, part, flow, point, time };
            for astray in course.compared(self.unit(&field(&slopes(system, part, point, time)))) {
                judged.judge(&[flow], FlowLaw::Generator, astray.duration, astray.error, astray.tolerance);
            }
        }
        Ok(())
    }

    /// The derivatives of coordinates by the duration at zero, for those that are known, each beside what the energy makes
    /// of it.
    fn derivatives(&self, part: Part, flows: &[Flow]) -> Result<Vec<Derivative>, CheckError> {
        let Self { system, point, time, .. } = *self;
        let field = field(&slopes(system, part, point, time));
        let roundings = self.roundings(part);
        let unit = self.unit(&field);
        let ends = RefCell::new(BTreeMap::<u64, Vec<f64>>::new());
        let end = |distance: f64, index: usize| {
            let mut ends = ends.borrow_mut();
            let end = ends.entry(distance.to_bits()).or_insert_with(|| {
                let flows: Vec<_> = flows.iter().map(|flow| (*flow, distance * unit)).collect();
                numbers(&system.carried(&flows, point, None, time).0).collect()
            });
            end[index]
        };
        let mut derivatives = Vec::new();
        for (index, ((driven, rounding), size)) in field.iter().zip(roundings).zip(numbers(point)).enumerate() {
            let value = |distance: f64| {
                let end = end(distance, index);
                [end, gradient_tolerance(point.q.len()) * (end.abs() + size.abs())]
            };
            let Some(slope) = slope_of(&value) else { continue };
            let known = Derivative { driven: driven * unit, rounding: rounding * unit, slope, unit };
            if known.size() == 0.0 || within(slope.uncertainty, KNOWN * known.size()) {
                derivatives.push(known);
            }
        }
        if derivatives.is_empty() && !field.is_empty() {
            return Err(CheckError::NothingToCompare { left_out: field.len() });
        }
        Ok(derivatives)
    }

    /// Bounds on the rounding of the components of the vector field of an energy.
    fn roundings(&self, part: Part) -> Vec<f64> {
        let still = origin(self.point);
        let length = self.point.q.len();
        let rounding = |index: usize| {
            let mut along = still.clone();
            *coordinate(&mut along, (index + length) % (2 * length)) = 1.0;
            self.system.bounded_slope(part, self.point, &along, self.time)[1]
        };
        (0..2 * length).map(rounding).collect()
    }

    /// The time in which the point would move as far as it is from the origin: what widths of differences are measured
    /// in.
    fn unit(&self, field: &[f64]) -> f64 {
        let (velocities, forces) = field.split_at(self.point.q.len());
        let time = |numbers: &[f64], rates: &[f64]| {
            let time = largest(numbers.iter().copied()) / largest(rates.iter().copied());
            if time > 0.0 && time.is_finite() { time } else { f64::INFINITY }
        };
        let unit = time(&self.point.q, velocities).min(time(&self.point.p, forces));
        if unit.is_finite() { unit } else { self.duration.abs() }
    }
}

impl Image {
    /// The rounding of where this flow leads from the rounded end of another one.
    fn after(&self, before: &Self) -> Vec<f64> {
        let carried = through(&self.map, &before.rounding);
        carried.into_iter().zip(&self.rounding).map(|(carried, own)| carried + own).collect()
    }
}

/// A derivative by the duration, by differences and by the energy.
struct Derivative {
    driven: f64,
    /// A bound on the rounding of what the energy drives.
    rounding: f64,
    slope: Slope,
    /// The time that both are in units of.
    unit: f64,
}

impl Derivative {
    fn size(&self) -> f64 {
        f64::max(self.slope.scale, self.driven.abs())
    }

    fn error(&self) -> f64 {
        (self.slope.value - self.driven).abs()
    }

    /// Beside the differences, both round; where no bound on that is known, half of the digits allow for any sum that is of use.
    fn tolerance(&self) -> f64 {
        let rounding =
            if self.rounding.is_finite() { SAFETY * self.rounding } else { f64::EPSILON.sqrt() * self.size() };
        SAFETY * self.slope.uncertainty + rounding
    }

    fn share(&self) -> f64 {
        ratio(self.error(), self.tolerance())
    }

    /// The part of the error that the differences do not explain, in units of the derivative.
    fn excess(&self) -> f64 {
        let beyond = self.error() - SAFETY * self.slope.uncertainty;
        ratio(if beyond <= 0.0 { 0.0 } else { beyond }, self.size())
    }
}

/// The vector field of an energy with these derivatives.
fn field(slopes: &[f64]) -> Vec<f64> {
    let (by_positions, by_momenta) = slopes.split_at(slopes.len() / 2);
    by_momenta.iter().copied().chain(by_positions.iter().map(|slope| -slope)).collect()
}

/// `|M|` times some sizes.
fn through(map: &DMatrix<f64>, sizes: &[f64]) -> Vec<f64> {
    (0..map.nrows()).map(|row| sizes.iter().enumerate().map(|(i, size)| map[(row, i)].abs() * size).sum()).collect()
}

/// The differences of the coordinates of two points.
fn apart(one: &Flat, other: &Flat) -> Vec<f64> {
    numbers(one).zip(numbers(other)).map(|(one, other)| one - other).collect()
}
