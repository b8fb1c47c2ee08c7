//! The exact tangent map of a method: the derivative of its steps with respect to where they begin.
//!
//! In: a system, a method, a point, a step. Out: the images of tangents at the point after some closed steps.
//! Always true: what is differentiated is the very code that a run executes, with no finite difference; a
//! difference quotient of good steps is off by 1e-7 and would pass off steps that are not symplectic by less than that.

use crate::{
    check::statistics::points::{coordinate, numbers, origin},
    hamiltonian::Hamiltonian,
    scalar::dual::Dual,
    state::{
        clock::Clock,
        coords::Coords,
        flat::{Flat, flat, shaped},
        phase::Phase,
    },
    system::motion::Motion,
    trajectory::{method::Method, step_functions::FlowByFlow},
};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Steps that carry a tangent with the point that it is attached to.
pub(crate) trait Carry {
    /// The images of `point` and `tangent` after `steps` closed steps from time `t0`.
    fn carry(&self, point: &Flat, tangent: &Flat, t0: f64, steps: u64) -> (Flat, Flat);
}

/// The steps of a method, with a point in the shape of the coordinates of its system.
pub(crate) struct Tangents<'s, H: Hamiltonian, X: Method<H>> {
    constants: Arc<X::Constants>,
    shape: &'s Phase<H::Coords>,
    h: f64,
}

impl<'s, H: Hamiltonian, X: Method<H>> Tangents<'s, H, X> {
    pub(crate) fn new(system: &H, method: X, shape: &'s Phase<H::Coords>, h: f64) -> Self {
        Self { constants: method.constants(Arc::new(system.parameters(shape.q.length()))), shape, h }
    }

    /// The Jacobian matrices of 1, 2, ... `steps` steps from `point`, each as [`matrix`].
    pub(crate) fn matrices(&self, point: &Flat, t0: f64, steps: usize) -> Vec<DMatrix<f64>> {
        let size = 2 * point.q.len();
        let mut matrices = vec![DMatrix::zeros(size, size); steps];
        let functions = X::step_functions::<Dual, f64, FlowByFlow>();
        for column in 0..size {
            let mut arrived = [shaped(self.shape, point), shaped(self.shape, &unit(point, column))];
            let mut motion = X::Motion::<Dual, f64>::load(&[&*self.constants; 2], &[&arrived[0], &arrived[1]]);
            let mut clock = Clock { t0, h: self.h, steps: 0 };
            for matrix in &mut matrices {
                functions.advance_one(&mut motion, clock, 1);
                clock.steps += 1;
                functions.shown(motion.clone(), clock).store(1, &mut arrived[1]);
                fill(matrix, column, &flat(&arrived[1]));
            }
        }
        matrices
    }
}

impl<H: Hamiltonian, X: Method<H>> Carry for Tangents<'_, H, X> {
    fn carry(&self, point: &Flat, tangent: &Flat, t0: f64, steps: u64) -> (Flat, Flat) {
        let mut arrived = [shaped(self.shape, point), shaped(self.shape, tangent)];
        let functions = X::step_functions::<Dual, f64, FlowByFlow>();
        let mut motion = X::Motion::<Dual, f64>::load(&[&*self.constants; 2], &[&arrived[0], &arrived[1]]);
        let clock = Clock { t0, h: self.h, steps: 0 };
        functions.advance_one(&mut motion, clock, steps);
        let motion = functions.shown(motion, Clock { steps, ..clock });
        motion.store(0, &mut arrived[0]);
        motion.store(1, &mut arrived[1]);
        (flat(&arrived[0]), flat(&arrived[1]))
    }
}

/// The Jacobian matrix of `steps` steps from `point`, rows and columns ordered as all of `q`, then all of `p`.
///
/// The time is 2n times that of the steps in duals, where n is the number of positions.
pub(crate) fn matrix(tangents: &dyn Carry, point: &Flat, t0: f64, steps: u64) -> DMatrix<f64> {
    let n = point.q.len();
    let mut matrix = DMatrix::zeros(2 * n, 2 * n);
    for column in 0..2 * n {
        let (_, arrived) = tangents.carry(point, &unit(point, column), t0, steps);
        fill(&mut matrix, column, &arrived);
    }
    matrix
}

/// The tangent along a coordinate.
fn unit(point: &Flat, column: usize) -> Flat {
    let mut unit = origin(point);
    *coordinate(&mut unit, column) = 1.0;
    unit
}

/// Writes the image of a tangent into a column.
fn fill(matrix: &mut DMatrix<f64>, column: usize, image: &Flat) {
    for (row, value) in numbers(image).enumerate() {
        matrix[(row, column)] = value;
    }
}
