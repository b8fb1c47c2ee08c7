//! Whether the flows belong to the energies.
//!
//! In: a system and a point. Out: the largest difference between a component of the generated gradient and the exact
//! derivative of the generated energy. Always true: the gradient is taken from the flow itself, as what a kick or a
//! drift of unit duration adds, and the derivative from duals through the energy, so that the two meet only here.
//! Central differences, which know nothing of duals, stand by as a coarse witness.

use crate::{
    check::{
        CheckError,
        dual::Dual,
        points::{begin, coordinate, numbers, origin},
        tolerance::{largest, ratio, within},
    },
    coords::Coords,
    hamiltonian::{Hamiltonian, Motion, Shaped},
    phase::Phase,
    real::Real,
    slot::Keep,
};
use std::marker::PhantomData;

/// How far the flows of `T` and `V` are from the gradients of `T` and `V` at `point` and `time`: the largest error of a
/// component, in units of its condition.
///
/// The condition of a component `g` is `|g| + Σ |∂g/∂xⱼ|·x` with the largest coordinate `x`: what rounding the
/// coordinates may do to `g` is ε times that. So a tiny component beside a huge one is judged by its own size, and one
/// that is the small difference of large terms is not blamed for it.
///
/// # Errors
/// A point that no run would begin with, a `time` that is not finite, or a point where an energy has no derivative.
pub fn gradient_error<H: Hamiltonian, K: Keep>(
    system: &H,
    point: Phase<Shaped<H, K>>,
    time: f64,
) -> Result<f64, CheckError> {
    let point = begin::<H, _, K>(system, H::Compose::default(), &point.at_time(time), 1.0)?.phase;
    let parameters = system.parameters(point.q.length());
    let error = |part| Gradient::<H>::new(&parameters, part, time).error(&point);
    Ok(largest([error(Part::Kinetic)?, error(Part::Potential)?]))
}

/// The error up to which a component of a gradient over `coordinates` coordinates is right: a sum of as many terms,
/// each of some operations and elementary functions of up to 4 ulp, evaluated twice, as code and through duals, whose
/// chain rule rounds a few times more.
pub(crate) fn gradient_tolerance(coordinates: usize) -> f64 {
    32.0 * (coordinates + 1) as f64 * f64::EPSILON
}

/// One of the two energies. Its gradient is by the half of the coordinates that it reads, and moves the other half.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Part {
    Kinetic,
    Potential,
}

/// What is differentiated.
pub(crate) struct Gradient<'s, H: Hamiltonian> {
    parameters: &'s H::Parameters<f64>,
    part: Part,
    time: f64,
    marker: PhantomData<H>,
}

impl<'s, H: Hamiltonian> Gradient<'s, H> {
    pub(crate) fn new(parameters: &'s H::Parameters<f64>, part: Part, time: f64) -> Self {
        Self { parameters, part, time, marker: PhantomData }
    }

    /// The largest error of a component, in units of its condition.
    fn error(&self, point: &Phase<H::Coords>) -> Result<f64, CheckError> {
        let still = origin(point);
        let point = match self.part {
            Part::Kinetic => Phase { q: still.q.clone(), p: point.p.clone() },
            Part::Potential => Phase { q: point.q.clone(), p: still.p.clone() },
        };
        let extent = largest(numbers(&point));
        let generated = self.flow::<f64>(&point, &still, 0);
        let mut exact = Vec::with_capacity(generated.len());
        let mut conditions: Vec<f64> = generated.iter().map(|component| component.abs()).collect();
        for index in 0..generated.len() {
            let mut along = still.clone();
            *self.read(&mut along, index) = 1.0;
            let derivative = self.energy::<Dual>(&point, &along, 1);
            self.witness(&point, index, extent, derivative)?;
            exact.push(derivative);
            for (condition, curvature) in conditions.iter_mut().zip(self.flow::<Dual>(&point, &along, 1)) {
                *condition += curvature.abs() * extent;
            }
        }
        let errors = exact.iter().zip(&generated).zip(&conditions);
        Ok(largest(errors.map(|((exact, generated), condition)| ratio(exact - generated, *condition))))
    }

    /// Whether central differences agree with a derivative by duals. With the width `d` they are off by `c·d²` and the
    /// rounding of the energy over `d`; twice the width tells `3·c·d²`, and `d = ε^(1/3)` of the scale of the energy
    /// balances the two. That scale may be much shorter than the coordinates are long, where two bodies are close: then
    /// a narrower width tells. At a kink none does.
    fn witness(&self, point: &Phase<H::Coords>, index: usize, extent: f64, dual: f64) -> Result<(), CheckError> {
        const NARROWING: [f64; 4] = [1.0, 3e-2, 1e-3, 3e-5];
        let scale = f64::EPSILON.cbrt() * if extent > 0.0 { extent } else { 1.0 };
        let differences = NARROWING.map(|narrowing| self.difference(point, index, extent, dual, narrowing * scale));
        if differences.iter().any(|&(difference, uncertainty)| within(difference - dual, uncertainty)) {
            return Ok(());
        }
        let energy = if self.part == Part::Kinetic { "T" } else { "V" };
        let (difference, uncertainty) = differences[0];
        Err(CheckError::NotDifferentiable { energy, index, dual, difference, uncertainty })
    }

    /// The central difference of a width, and what truncation and rounding may add to it.
    fn difference(&self, point: &Phase<H::Coords>, index: usize, extent: f64, dual: f64, width: f64) -> (f64, f64) {
        let still = origin(point);
        let energy = |offset: f64| {
            let mut moved = point.clone();
            *self.read(&mut moved, index) += offset;
            self.energy::<f64>(&moved, &still, 0)
        };
        let [narrow, wide] = [width, 2.0 * width].map(|width| (energy(width) - energy(-width)) / (2.0 * width));
        let terms = energy(width).abs() + (dual * extent).abs();
        let rounding = gradient_tolerance(point.q.flat().len()) * terms / width;
        (narrow, (wide - narrow).abs() + rounding)
    }

    /// One of the numbers that this energy reads.
    fn read<'p>(&self, point: &'p mut Phase<H::Coords>, index: usize) -> &'p mut f64 {
        let first = if self.part == Part::Kinetic { point.q.flat().len() } else { 0 };
        coordinate(point, first + index)
    }

    /// One lane of the energy.
    fn energy<R: Real>(&self, point: &Phase<H::Coords>, tangent: &Phase<H::Coords>, lane: usize) -> f64 {
        let motion = self.load::<R>(point, tangent);
        match self.part {
            Part::Kinetic => H::kinetic::<R, f64>(&motion, self.time),
            Part::Potential => H::potential::<R, f64>(&motion, self.time),
        }
        .lane(lane)
    }

    /// One lane of the gradient: what the flow of unit duration adds to the half that is moved, from zero.
    pub(crate) fn flow<R: Real>(&self, point: &Phase<H::Coords>, tangent: &Phase<H::Coords>, lane: usize) -> Vec<f64> {
        let mut motion = self.load::<R>(point, tangent);
        H::begin_step::<R, f64>(&mut motion, self.time);
        let mut moved = point.clone();
        match self.part {
            Part::Kinetic => {
                H::drift::<R, f64>(&mut motion, 1.0, self.time);
                motion.store(lane, &mut moved);
                moved.q.flat().to_vec()
            }
            Part::Potential => {
                H::kick::<R, f64>(&mut motion, 1.0, self.time);
                motion.store(lane, &mut moved);
                moved.p.flat().iter().map(|change| -change).collect()
            }
        }
    }

    /// A motion at `point`, with `tangent` in the second lane if there is one.
    fn load<R: Real>(&self, point: &Phase<H::Coords>, tangent: &Phase<H::Coords>) -> H::Motion<R, f64> {
        H::Motion::<R, f64>::load(&|lane| (self.parameters, if lane == 0 { point } else { tangent }))
    }
}
