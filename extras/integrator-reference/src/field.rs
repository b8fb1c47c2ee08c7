//! The vector field of a Hamiltonian, from its generated flows or as generated directly.
//!
//! States are a list of numbers here, positions first.

use core::cell::Cell;
use integrator_core::{
    __private::{Dual, Motion, Moved, Prepared, ReadOf, Real, System},
    Coords, Phase,
};
use nalgebra::DMatrix;

/// `y' = f(y, t)`. Behind a pointer, so that methods are compiled once for all systems.
pub(crate) trait Field<R> {
    /// `f`: velocities, then forces.
    fn derivative(&self, y: &[R], time: f64) -> Vec<R>;
    /// Velocities alone: work, where they cost no force, that is not counted.
    fn velocity(&self, y: &[R], time: f64) -> Vec<R>;
    /// Forces alone.
    fn force(&self, y: &[R], time: f64) -> Vec<R>;
    /// `∂f/∂y` at plain numbers.
    fn jacobian(&self, y: &[f64], time: f64) -> DMatrix<f64>;
}

/// The field of `H`, with its parameters and a point that has the shape of its coordinates.
pub(crate) struct Generated<'s, H: System> {
    pub(crate) parameters: &'s H::Parameters<f64>,
    pub(crate) shape: &'s Phase<H::Coords>,
    /// The middle of the step that evaluates it.
    pub(crate) middle: f64,
    /// The number of evaluations of the field; a Jacobian counts once for each of its columns.
    pub(crate) evaluations: Cell<u64>,
}

impl<H: System> Generated<'_, H> {
    /// One half of `y` in every lane, and nothing in the other half.
    fn points<R: Real>(&self, y: &[R], half: fn(&mut Phase<H::Coords>) -> &mut H::Coords) -> Vec<Phase<H::Coords>> {
        let point = |lane: usize| {
            let mut point = self.shape.clone();
            point.q.flat_mut().fill(0.0);
            point.p.flat_mut().fill(0.0);
            for (to, from) in half(&mut point).flat_mut().iter_mut().zip(y) {
                *to = from.lane(lane);
            }
            point
        };
        (0..R::LANES).map(point).collect()
    }

    /// Returns these points after a flow of unit duration.
    fn flown<R: Real>(
        &self,
        mut points: Vec<Phase<H::Coords>>,
        flow: impl Fn(&mut H::Motion<R, f64>),
    ) -> Vec<Phase<H::Coords>> {
        let states: Vec<_> = points.iter().collect();
        let mut motion = H::Motion::<R, f64>::load(&vec![self.parameters; states.len()], &states);
        H::begin_step::<R, f64>(&mut motion, self.middle);
        flow(&mut motion);
        for (lane, point) in points.iter_mut().enumerate() {
            motion.store(lane, point);
        }
        points
    }
}

impl<H: System> Generated<'_, H> {
    /// The field that was written as such: it moves nothing by a unit of time, without rounding.
    fn of_whole<R: Real>(&self, y: &[R], time: f64) -> Vec<R> {
        self.evaluations.set(self.evaluations.get() + 1);
        let half = y.len() / 2;
        let mut parameters = H::Parameters::<R>::gather(&vec![self.parameters; R::LANES]);
        parameters.begin_step(self.middle);
        let slots = |numbers: &[R]| H::Coords::slots_from(half, |k| numbers[k]);
        let (q, p) = (slots(&y[..half]), slots(&y[half..]));
        let zeros = vec![R::of(0.0); half];
        let (mut velocity, mut force) = (slots(&zeros), slots(&zeros));
        let read = ReadOf { q: &q, p: &p, parameters: &parameters };
        H::along_field::<R, f64>(read, Moved { q: &mut velocity, p: &mut force }, 1.0, time);
        [H::Coords::slots(&velocity), H::Coords::slots(&force)].concat()
    }
}

impl<H: System, R: Real> Field<R> for Generated<'_, H> {
    fn derivative(&self, y: &[R], time: f64) -> Vec<R> {
        if const { !H::SEPARABLE } {
            return self.of_whole(y, time);
        }
        let mut derivative = self.velocity(y, time);
        derivative.append(&mut self.force(y, time));
        derivative
    }

    fn velocity(&self, y: &[R], time: f64) -> Vec<R> {
        let half = y.len() / 2;
        if const { !H::SEPARABLE } {
            return self.of_whole(y, time)[..half].to_vec();
        }
        // A drift moves the positions by the velocities, and from zero without rounding.
        let points = self.points(&y[half..], |point| &mut point.p);
        let drifted = self.flown::<R>(points, |motion| H::drift::<R, f64>(motion, 1.0, time));
        (0..half).map(|i| R::state(&|lane| drifted[lane].q.flat()[i])).collect()
    }

    fn force(&self, y: &[R], time: f64) -> Vec<R> {
        let half = y.len() / 2;
        if const { !H::SEPARABLE } {
            return self.of_whole(y, time)[half..].to_vec();
        }
        self.evaluations.set(self.evaluations.get() + 1);
        // A kick moves the momenta by the forces.
        let points = self.points(&y[..half], |point| &mut point.q);
        let kicked = self.flown::<R>(points, |motion| H::kick::<R, f64>(motion, 1.0, time));
        (0..half).map(|i| R::state(&|lane| kicked[lane].p.flat()[i])).collect()
    }

    fn jacobian(&self, y: &[f64], time: f64) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(y.len(), y.len());
        for column in 0..y.len() {
            let along =
                |i: usize| <Dual>::state(&|lane| if lane == 0 { y[i] } else { f64::from(u8::from(i == column)) });
            let y: Vec<Dual> = (0..y.len()).map(along).collect();
            for (row, derivative) in self.derivative(&y, time).into_iter().enumerate() {
                jacobian[(row, column)] = derivative.lane(1);
            }
        }
        jacobian
    }
}
