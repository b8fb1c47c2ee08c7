//! Compensated small systems: coordinates are stored with the rounding errors of their updates (Kahan 1965).
//!
//! Values and rounding errors are separate vectors.

use crate::{
    enter::{Kernel, enter, enter_scalar},
    plan::{HandWritten, Plan},
    problems::{Chain32, GRAVITY, Solar},
    vector::{Row, Vector},
};
use integrator_core::Phase;

/// Values, and the accumulated rounding errors that the next update adds.
#[derive(Clone, Copy)]
struct Carrying<V> {
    number: V,
    carried: V,
}

impl<V: Vector> Carrying<V> {
    #[inline(always)]
    fn load(numbers: &[V::Number]) -> Self {
        Self { number: V::load(numbers), carried: V::splat(0.0) }
    }
    /// Adds `d`, which already includes the accumulated error.
    #[inline(always)]
    fn add(&mut self, d: V) {
        let sum = self.number + d;
        self.carried = d - (sum - self.number);
        self.number = sum;
    }
    /// Adds `a * b`.
    #[inline(always)]
    fn fma(&mut self, a: V, b: V) {
        self.add(a.fma(b, self.carried));
    }
}

/// The Hénon–Heiles system.
struct HenonHeiles<V> {
    q: [Carrying<V>; 2],
    p: [Carrying<V>; 2],
}

impl<V: Vector> HandWritten for HenonHeiles<V> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for axis in 0..2 {
            self.q[axis].fma(V::splat(t), self.p[axis].number);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [x, y] = self.q.map(|q| q.number);
        self.p[0].fma(V::splat(-2.0 * t) * x, y + V::splat(0.5));
        self.p[1].fma(V::splat(-t), y.fnma(y, x.fma(x, y)));
    }
}

struct GalaxyMarch<'p> {
    start: [f64; 4],
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for GalaxyMarch<'_> {
    type Out = f64;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> f64 {
        let [x, y, px, py] = self.start.map(|number| Carrying::<V>::load(&[number; 8]));
        let mut star = HenonHeiles { q: [x, y], p: [px, py] };
        self.plan.march(&mut star, self.steps);
        let mut lanes = [0.0; 8];
        star.q[0].number.store(&mut lanes);
        lanes[0]
    }
}

/// Returns the first coordinate of the final state of a Hénon–Heiles orbit, in scalar code.
pub fn henon_heiles(start: [f64; 4], plan: &Plan, steps: u64) -> f64 {
    enter_scalar(GalaxyMarch { start, plan, steps })
}

/// Six bodies in the lanes of a register, as in [`row`](super::row).
struct Ring<R> {
    q: [Carrying<R>; 3],
    p: [Carrying<R>; 3],
    inverse_masses: R,
    /// `G mᵢ mⱼ` for the three rotations.
    couplings: [R; 3],
}

impl<R: Row> Ring<R> {
    /// Returns the pull of the body in lane `i + BY` on the body in lane `i`.
    #[inline(always)]
    fn pull<const BY: usize>(&self) -> [R; 3] {
        let [x, y, z] = self.q.map(|q| q.number.rotate::<BY, 6>() - q.number);
        let pull = z.fma(z, y.fma(y, x * x)).over_cube(self.couplings[BY - 1]);
        [pull * x, pull * y, pull * z]
    }
}

impl<R: Row> HandWritten for Ring<R> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let mobility = R::splat(t) * self.inverse_masses;
        for axis in 0..3 {
            self.q[axis].fma(mobility, self.p[axis].number);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let (near, second, across) = (self.pull::<1>(), self.pull::<2>(), self.pull::<3>());
        for axis in 0..3 {
            let actions = near[axis] + second[axis] + across[axis];
            let reactions = near[axis].rotate::<5, 6>() + second[axis].rotate::<4, 6>();
            self.p[axis].fma(R::splat(t), actions - reactions);
        }
    }
}

struct SolarMarch<'p> {
    system: &'p Solar,
    start: Phase<[[f64; 3]; 6]>,
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for SolarMarch<'_> {
    type Out = [f64; 8];
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> [f64; 8] {
        let row = |of: &dyn Fn(usize) -> f64| {
            // The two lanes without a body repeat the first two bodies.
            let lanes: [f64; 8] = std::array::from_fn(|lane| of(lane % 6));
            Carrying::<R>::load(&lanes)
        };
        let masses = self.system.masses;
        let column = |of: &[[f64; 3]; 6]| [0, 1, 2].map(|axis| row(&|body| of[body][axis]));
        let mut ring = Ring {
            q: column(&self.start.q),
            p: column(&self.start.p),
            inverse_masses: row(&|body| 1.0 / masses[body]).number,
            couplings: [1, 2, 3].map(|by| row(&|body| GRAVITY * masses[body] * masses[(body + by) % 6]).number),
        };
        self.plan.march(&mut ring, self.steps);
        let mut lanes = [0.0; 8];
        ring.q[0].number.store(&mut lanes);
        lanes
    }
}

/// Returns the first coordinates of the six bodies of the outer solar system at the end, and two lanes without a body.
pub fn solar(system: &Solar, start: Phase<[[f64; 3]; 6]>, plan: &Plan, steps: u64) -> [f64; 8] {
    enter(SolarMarch { system, start, plan, steps })
}

/// Thirty-two sites in four registers. Each bond is evaluated once, as in [`row`](super::row).
struct Blocks<R> {
    alpha: f64,
    q: [Carrying<R>; 4],
    p: [Carrying<R>; 4],
}

impl<R: Row> Blocks<R> {
    #[inline(always)]
    fn bond(&self, stretch: R) -> R {
        (R::splat(self.alpha) * stretch).fma(stretch, stretch)
    }
}

impl<R: Row> HandWritten for Blocks<R> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for i in 0..4 {
            self.q[i].fma(R::splat(t), self.p[i].number);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let wall = R::splat(0.0);
        // The last lane of `left` is the bond to the wall on the left.
        let mut left = self.bond(wall.after(self.q[0].number));
        for i in 0..4 {
            let here = self.q[i].number;
            let next = if i < 3 { self.q[i + 1].number } else { wall };
            let right = self.bond(here.after(next) - here);
            self.p[i].fma(R::splat(t), right - right.before(left));
            left = right;
        }
    }
}

struct ChainMarch<'p> {
    alpha: f64,
    start: Phase<[f64; 32]>,
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for ChainMarch<'_> {
    type Out = [f64; 8];
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> [f64; 8] {
        let load = |from: &[f64; 32]| [0, 1, 2, 3].map(|i| Carrying::<R>::load(&from[8 * i..]));
        let mut blocks = Blocks { alpha: self.alpha, q: load(&self.start.q), p: load(&self.start.p) };
        self.plan.march(&mut blocks, self.steps);
        let mut lanes = [0.0; 8];
        blocks.q[0].number.store(&mut lanes);
        lanes
    }
}

/// Returns the positions of the first eight sites of the 32-site chain at the end.
pub fn chain(system: &Chain32, start: Phase<[f64; 32]>, plan: &Plan, steps: u64) -> [f64; 8] {
    enter(ChainMarch { alpha: system.alpha, start, plan, steps })
}
