//! One particle in a field, generic over the vector type: scalar or SIMD lanes.

use crate::{
    enter::{Kernel, enter, enter_scalar},
    functions,
    plan::{HandWritten, Plan},
    vector::{Row, Vector},
};
use std::marker::PhantomData;

/// Trajectories in SIMD lanes: columns of coordinates and parameters, one lane per trajectory.
pub(crate) trait Lanes<V: Vector>: HandWritten + Sized {
    fn load(columns: &[Vec<V::Number>], at: usize) -> Self;
    fn store(&self, columns: &mut [Vec<V::Number>], at: usize);
}

/// Selects the sine of the pendulum.
pub(crate) trait Sine {
    fn of<V: Vector>(x: V) -> V;
}

/// Error of at most one unit in the last place.
pub(crate) struct Careful;
/// Error of at most four units in the last place.
pub(crate) struct Fast;

impl Sine for Careful {
    #[inline(always)]
    fn of<V: Vector>(x: V) -> V {
        functions::sine(x)
    }
}
impl Sine for Fast {
    #[inline(always)]
    fn of<V: Vector>(x: V) -> V {
        functions::sine_fast(x)
    }
}

pub(crate) struct Pendulum<V, S> {
    q: V,
    p: V,
    mobility: V,
    torque: V,
    sine: PhantomData<S>,
}

impl<V: Vector, S: Sine> HandWritten for Pendulum<V, S> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        self.q = (V::splat(t) * self.mobility).fma(self.p, self.q);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        self.p = (V::splat(t) * self.torque).fnma(S::of(self.q), self.p);
    }
}

impl<V: Vector, S: Sine> Lanes<V> for Pendulum<V, S> {
    #[inline(always)]
    fn load(columns: &[Vec<V::Number>], at: usize) -> Self {
        let [q, p, mobility, torque] = [0, 1, 2, 3].map(|column| V::load(&columns[column][at..]));
        Self { q, p, mobility, torque, sine: PhantomData }
    }
    #[inline(always)]
    fn store(&self, columns: &mut [Vec<V::Number>], at: usize) {
        self.q.store(&mut columns[0][at..]);
        self.p.store(&mut columns[1][at..]);
    }
}

/// Written with the fewest operations from one kick to the next: ∂V/∂x = 2x(y + ½), ∂V/∂y = y + x² - y².
pub(crate) struct HenonHeiles<V> {
    q: [V; 2],
    p: [V; 2],
}

impl<V: Vector> HandWritten for HenonHeiles<V> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let [x, y] = &mut self.q;
        *x = V::splat(t).fma(self.p[0], *x);
        *y = V::splat(t).fma(self.p[1], *y);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [x, y] = self.q;
        self.p[0] = (V::splat(2.0 * t) * x).fnma(y + V::splat(0.5), self.p[0]);
        self.p[1] = V::splat(t).fnma(y.fnma(y, x.fma(x, y)), self.p[1]);
    }
}

pub(crate) struct Kepler<V> {
    q: [V; 2],
    p: [V; 2],
}

impl<V: Vector> HandWritten for Kepler<V> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let [x, y] = &mut self.q;
        *x = V::splat(t).fma(self.p[0], *x);
        *y = V::splat(t).fma(self.p[1], *y);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [x, y] = self.q;
        let pull = x.fma(x, y * y).over_cube(V::splat(t));
        let [px, py] = &mut self.p;
        *px = pull.fnma(x, *px);
        *py = pull.fnma(y, *py);
    }
}

macro_rules! planar {
    ($name:ident) => {
        impl<V: Vector> Lanes<V> for $name<V> {
            #[inline(always)]
            fn load(columns: &[Vec<V::Number>], at: usize) -> Self {
                let [x, y, px, py] = [0, 1, 2, 3].map(|column| V::load(&columns[column][at..]));
                Self { q: [x, y], p: [px, py] }
            }
            #[inline(always)]
            fn store(&self, columns: &mut [Vec<V::Number>], at: usize) {
                for (column, vector) in columns.iter_mut().zip(self.q.iter().chain(&self.p)) {
                    vector.store(&mut column[at..]);
                }
            }
        }
    };
}
planar!(HenonHeiles);
planar!(Kepler);

/// Selects a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Point {
    /// Pendulum with the careful sine.
    Pendulum,
    /// Pendulum with the fast sine.
    FastPendulum,
    /// Hénon–Heiles.
    HenonHeiles,
    /// Kepler.
    Kepler,
}

/// A single trajectory, in scalar code or repeated in all lanes of a register.
struct Single<'p> {
    point: Point,
    plan: &'p Plan,
    steps: u64,
    columns: [f64; 4],
}

impl Single<'_> {
    #[inline(always)]
    fn march<V: Vector<Number = f64>, L: Lanes<V>>(&self) -> [f64; 4] {
        let mut columns = self.columns.map(|number| vec![number; V::LANES]);
        let mut lanes = L::load(&columns, 0);
        self.plan.march(&mut lanes, self.steps);
        lanes.store(&mut columns, 0);
        columns.map(|column| column[0])
    }
}

impl Kernel for Single<'_> {
    type Out = [f64; 4];
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> [f64; 4] {
        match self.point {
            Point::Pendulum => self.march::<V, Pendulum<V, Careful>>(),
            Point::FastPendulum => self.march::<V, Pendulum<V, Fast>>(),
            Point::HenonHeiles => self.march::<V, HenonHeiles<V>>(),
            Point::Kepler => self.march::<V, Kepler<V>>(),
        }
    }
}

/// Returns the end of a trajectory of `point` after `steps` steps, in scalar code.
pub fn scalar(point: Point, columns: [f64; 4], plan: &Plan, steps: u64) -> [f64; 4] {
    enter_scalar(Single { point, plan, steps, columns })
}

/// The same, repeated in all lanes of a register, to use operations that only the widest instruction sets have.
pub fn wide(point: Point, columns: [f64; 4], plan: &Plan, steps: u64) -> [f64; 4] {
    enter(Single { point, plan, steps, columns })
}
