//! Nested Poisson brackets of `T(p)` and `V(q)` at a point.
//!
//! In: a system and a point. Out: the values of brackets. `D_A f = {f, A}` is the derivative of `f` along the flow of `A`,
//! so that `D_A D_B f` at a point is that of `f` after moving along `A` for a time `a`, then along `B` for `b`, by `a` and
//! `b` at zero. Times are the infinitesimals of duals over duals, one for each operator: where each of them is used
//! once, the flow of `T(p)` for such a time adds `a·∇T`, and the last bracket `{V, T}` is `∇V·∇T`. Always true: gradients
//! are what the generated flows of unit duration add, with derivatives of their very text, so that nothing is known
//! here of a system but its flows.

use super::series::{Bracket, HIGHEST};
use crate::{
    hamiltonian::Hamiltonian,
    scalar::{dual::Dual, real::Real},
    state::{
        coords::Coords,
        flat::{Flat, shaped},
        phase::Phase,
    },
    system::{motion::Motion, user_energies::Function as Part},
};
use std::{array, sync::Arc};

/// A number with three infinitesimals: bit `i` of a lane is set if the lane is a factor of lane `i`.
type Jet = Dual<Dual<Dual>>;

/// The operators of the longest bracket.
const OPERATORS: usize = HIGHEST - 2;
const LANES: usize = 1 << OPERATORS;
const _: () = assert!(<Jet as Real>::LANES == LANES);

/// A vector in all lanes.
type Vector = [Vec<f64>; LANES];

/// The flows of a system with derivatives, whatever the shape of its coordinates.
pub(crate) trait Jets: Send + Sync {
    /// `T` and `V`.
    fn energies(&self, point: &Flat) -> [f64; 2];

    /// The gradient of `T` at momenta, or of `V` at positions.
    fn gradient(&self, part: Part, at: &Vector) -> Vector;
}

/// A system with its parameters, and a point in the shape of its coordinates.
pub(crate) struct Prepared<H: Hamiltonian> {
    pub(crate) parameters: Arc<H::Parameters<f64>>,
    pub(crate) shape: Phase<H::Coords>,
}

impl<H: Hamiltonian> Jets for Prepared<H> {
    fn energies(&self, point: &Flat) -> [f64; 2] {
        let point = shaped(&self.shape, point);
        let motion = H::Motion::<f64, f64>::load(&[&*self.parameters], &[&point]);
        [H::kinetic::<f64, f64>(&motion, 0.0), H::potential::<f64, f64>(&motion, 0.0)]
    }

    fn gradient(&self, part: Part, at: &Vector) -> Vector {
        let origin = vec![0.0; at[0].len()];
        let lanes: [Phase<H::Coords>; LANES] = array::from_fn(|lane| {
            let (read, moved) = (at[lane].clone(), origin.clone());
            let point = match part {
                Part::Kinetic => Phase { q: moved, p: read },
                Part::Potential => Phase { q: read, p: moved },
            };
            shaped(&self.shape, &point)
        });
        let mut motion = H::Motion::<Jet, f64>::load(&[&*self.parameters; LANES], &lanes.each_ref());
        H::begin_step::<Jet, f64>(&mut motion, 0.0);
        match part {
            Part::Kinetic => H::drift::<Jet, f64>(&mut motion, 1.0, 0.0),
            Part::Potential => H::kick::<Jet, f64>(&mut motion, -1.0, 0.0),
        }
        let mut moved = self.shape.clone();
        array::from_fn(|lane| {
            motion.store(lane, &mut moved);
            let half = match part {
                Part::Kinetic => &moved.q,
                Part::Potential => &moved.p,
            };
            half.flat().to_vec()
        })
    }
}

/// The values of some brackets at a point, each times its coefficient.
pub(crate) fn terms(system: &dyn Jets, brackets: &[Bracket], point: &Flat) -> Vec<f64> {
    let mut known: Vec<(Vec<bool>, f64)> = Vec::new();
    // A long bracket comes with those that lack some of its operators.
    for bracket in brackets.iter().rev() {
        if !known.iter().any(|(along, _)| *along == bracket.along) {
            known.extend(values(system, &bracket.along, point));
        }
    }
    let value = |along: &[bool]| known.iter().find(|(other, _)| other == along).map_or(f64::NAN, |(_, value)| *value);
    brackets.iter().map(|bracket| bracket.coefficient * value(&bracket.along)).collect()
}

/// The bracket along these operators, and those with some of them.
fn values(system: &dyn Jets, along: &[bool], point: &Flat) -> Vec<(Vec<bool>, f64)> {
    let still = vec![0.0; point.q.len()];
    let lanes =
        |values: &[f64]| -> Vector { array::from_fn(|lane| if lane == 0 { values.to_vec() } else { still.clone() }) };
    let (mut q, mut p) = (lanes(&point.q), lanes(&point.p));
    for (operator, is_potential) in along.iter().enumerate() {
        match is_potential {
            false => add(&mut q, operator, 1.0, &system.gradient(Part::Kinetic, &p)),
            true => add(&mut p, operator, -1.0, &system.gradient(Part::Potential, &q)),
        }
    }
    let bracket = product(&system.gradient(Part::Potential, &q), &system.gradient(Part::Kinetic, &p));
    let with = |lane: usize| {
        let chosen = along.iter().enumerate().filter(|(operator, _)| lane >> operator & 1 == 1);
        let mut along: Vec<bool> = chosen.map(|(_, is_potential)| *is_potential).collect();
        let pair = along.len().saturating_sub(2);
        along[pair..].sort_unstable();
        (along, bracket[lane])
    };
    (0..1 << along.len()).map(with).collect()
}

/// Adds the multiple of a vector by an infinitesimal.
fn add(to: &mut Vector, infinitesimal: usize, sign: f64, vector: &Vector) {
    let bit = 1 << infinitesimal;
    for lane in (0..LANES).filter(|lane| lane & bit != 0) {
        for (number, added) in to[lane].iter_mut().zip(&vector[lane ^ bit]) {
            *number += sign * added;
        }
    }
}

/// The scalar product: infinitesimals have no squares, so that each lane is a sum over its parts.
fn product(one: &Vector, other: &Vector) -> [f64; LANES] {
    let dot = |one: &[f64], other: &[f64]| -> f64 { one.iter().zip(other).map(|(one, other)| one * other).sum() };
    array::from_fn(|lane| {
        let parts = (0..LANES).filter(|part| part & lane == *part);
        parts.map(|part| dot(&one[part], &other[lane ^ part])).sum()
    })
}
