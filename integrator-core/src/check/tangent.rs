//! The exact tangent map of a composition: the derivative of its steps with respect to where they begin.
//!
//! In: a system, a composition, a point, a step. Out: how tangents at the point arrive after some closed steps.
//! Always true: what is differentiated is the generated code itself, stage by stage, with no finite difference; a
//! difference quotient of good steps is off by 1e-7 and would pass off steps that are not symplectic by less than that.

use crate::{
    check::{
        dual::Dual,
        points::{coordinate, numbers, origin},
    },
    composition::Composition,
    coords::Coords,
    hamiltonian::{Hamiltonian, Motion, Single},
    phase::Phase,
};
use nalgebra::DMatrix;
use std::marker::PhantomData;

/// Tangents on their way with the point that they are attached to.
pub(crate) struct Tangents<H: Hamiltonian, X> {
    parameters: H::Parameters<f64>,
    h: f64,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X: Composition<H>> Tangents<H, X> {
    pub(crate) fn new(system: &H, length: usize, h: f64) -> Self {
        Self { parameters: system.parameters(length), h, marker: PhantomData }
    }

    /// Where `point` is after `steps` steps from time `t0`, closed, and what has become of `tangent` there.
    pub(crate) fn carry(
        &self,
        point: &Phase<H::Coords>,
        tangent: &Phase<H::Coords>,
        t0: f64,
        steps: u64,
    ) -> (Phase<H::Coords>, Phase<H::Coords>) {
        let mut arrived = (point.clone(), tangent.clone());
        let Some(last) = steps.checked_sub(1) else { return arrived };
        let time = |step: u64| t0 + step as f64 * self.h;
        let mut motion = H::Motion::<Dual, f64>::load(|lane| (&self.parameters, [point, tangent][lane]));
        let mut flows = Single::<H, Dual, f64>(&mut motion);
        X::open(&mut flows, self.h, time(0));
        for step in 1..steps {
            X::cycle(&mut flows, self.h, time(step));
        }
        X::close(&mut flows, self.h, time(last));
        motion.store(0, &mut arrived.0);
        motion.store(1, &mut arrived.1);
        arrived
    }

    /// The Jacobian matrix of `steps` steps from `point`, rows and columns ordered as all of `q`, then all of `p`.
    ///
    /// The time is 2n times that of the steps in duals, where n is the number of positions.
    pub(crate) fn matrix(&self, point: &Phase<H::Coords>, t0: f64, steps: u64) -> DMatrix<f64> {
        let n = point.q.flat().len();
        let mut matrix = DMatrix::zeros(2 * n, 2 * n);
        for column in 0..2 * n {
            let mut unit = origin(point);
            *coordinate(&mut unit, column) = 1.0;
            let (_, arrived) = self.carry(point, &unit, t0, steps);
            for (row, value) in numbers(&arrived).enumerate() {
                matrix[(row, column)] = value;
            }
        }
        matrix
    }
}
