//! The exact tangent map of a method: the derivative of its steps with respect to where they begin.
//!
//! In: a system, a method, a point, a step. Out: how tangents at the point arrive after some closed steps.
//! Always true: what is differentiated is the very code that a run executes, with no finite difference; a
//! difference quotient of good steps is off by 1e-7 and would pass off steps that are not symplectic by less than that.

use crate::{
    check::{
        dual::Dual,
        points::{coordinate, numbers, origin},
    },
    clock::Clock,
    coords::Coords,
    hamiltonian::{Hamiltonian, Motion},
    method::Method,
    phase::Phase,
};
use nalgebra::DMatrix;
use std::{marker::PhantomData, sync::Arc};

/// Tangents on their way with the point that they are attached to.
pub(crate) struct Tangents<H: Hamiltonian, X: Method<H>> {
    constants: Arc<X::Constants>,
    h: f64,
    marker: PhantomData<H>,
}

impl<H: Hamiltonian, X: Method<H>> Tangents<H, X> {
    pub(crate) fn new(system: &H, method: X, length: usize, h: f64) -> Self {
        Self { constants: method.constants(Arc::new(system.parameters(length))), h, marker: PhantomData }
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
        let moves = X::moves::<Dual, f64>();
        let mut motion = X::Motion::<Dual, f64>::load(&|lane| (&*self.constants, [point, tangent][lane]));
        let clock = Clock { t0, h: self.h, steps: 0 };
        moves.advance(&mut motion, clock, steps);
        let motion = moves.shown(motion, Clock { steps, ..clock });
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
