//! Small systems that fit into registers: bodies or sites in SIMD lanes.

use crate::{
    enter::{Kernel, enter},
    plan::{HandWritten, Plan},
    problems::{Chain32, GRAVITY, Solar},
    vector::{Row, Vector},
};
use integrator_core::Phase;

/// Six bodies in the lanes of a register. Rotations by one and two lanes give the pairs at these distances once each; a
/// rotation by three gives each remaining pair twice, once for each body.
struct Ring<R> {
    q: [R; 3],
    p: [R; 3],
    inverse_masses: R,
    /// `G mᵢ mⱼ` for the three rotations.
    couplings: [R; 3],
}

impl<R: Row> Ring<R> {
    /// Returns the pull of the body in lane `i + BY` on the body in lane `i`.
    #[inline(always)]
    fn pull<const BY: usize>(&self, t: f64) -> [R; 3] {
        let [x, y, z] = self.q;
        let (x, y, z) = (x.rotate::<BY, 6>() - x, y.rotate::<BY, 6>() - y, z.rotate::<BY, 6>() - z);
        let square = z.fma(z, y.fma(y, x * x));
        let pull = square.over_cube(self.couplings[BY - 1] * R::splat(t));
        [pull * x, pull * y, pull * z]
    }
}

impl<R: Row> HandWritten for Ring<R> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let mobility = R::splat(t) * self.inverse_masses;
        for axis in 0..3 {
            self.q[axis] = mobility.fma(self.p[axis], self.q[axis]);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let (near, second, across) = (self.pull::<1>(t), self.pull::<2>(t), self.pull::<3>(t));
        for axis in 0..3 {
            let actions = near[axis] + second[axis] + across[axis];
            let reactions = near[axis].rotate::<5, 6>() + second[axis].rotate::<4, 6>();
            self.p[axis] = self.p[axis] + (actions - reactions);
        }
    }
}

struct SolarMarch<'p> {
    system: &'p Solar,
    state: Phase<[[f64; 3]; 6]>,
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for SolarMarch<'_> {
    type Out = Phase<[[f64; 3]; 6]>;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> Self::Out {
        let row = |of: &dyn Fn(usize) -> f64| {
            let lanes: [f64; 8] = std::array::from_fn(|body| if body < 6 { of(body) } else { 0.0 });
            R::load(&lanes)
        };
        let masses = self.system.masses;
        let column = |of: &[[f64; 3]; 6]| [0, 1, 2].map(|axis| row(&|body| of[body][axis]));
        let mut ring = Ring {
            q: column(&self.state.q),
            p: column(&self.state.p),
            inverse_masses: row(&|body| 1.0 / masses[body]),
            couplings: [1, 2, 3].map(|by| row(&|body| GRAVITY * masses[body] * masses[(body + by) % 6])),
        };
        self.plan.march(&mut ring, self.steps);
        for axis in 0..3 {
            let mut lanes = [[0.0; 8]; 2];
            ring.q[axis].store(&mut lanes[0]);
            ring.p[axis].store(&mut lanes[1]);
            for body in 0..6 {
                self.state.q[body][axis] = lanes[0][body];
                self.state.p[body][axis] = lanes[1][body];
            }
        }
        self.state
    }
}

/// The outer solar system, with one body per lane.
pub fn solar(system: &Solar, start: Phase<[[f64; 3]; 6]>, plan: &Plan, steps: u64) -> Phase<[[f64; 3]; 6]> {
    enter(SolarMarch { system, state: start, plan, steps })
}

/// Thirty-two sites in four registers; each bond is evaluated once.
struct Blocks<R> {
    alpha: f64,
    q: [R; 4],
    p: [R; 4],
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
            self.q[i] = R::splat(t).fma(self.p[i], self.q[i]);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let wall = R::splat(0.0);
        // The last lane of `left` is the bond to the wall on the left.
        let mut left = self.bond(wall.after(self.q[0]));
        for i in 0..4 {
            let next = if i < 3 { self.q[i + 1] } else { wall };
            let right = self.bond(self.q[i].after(next) - self.q[i]);
            self.p[i] = R::splat(t).fma(right - right.before(left), self.p[i]);
            left = right;
        }
    }
}

struct ChainMarch<'p> {
    alpha: f64,
    state: Phase<[f64; 32]>,
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for ChainMarch<'_> {
    type Out = Phase<[f64; 32]>;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> Self::Out {
        let load = |from: &[f64; 32]| [0, 1, 2, 3].map(|i| R::load(&from[8 * i..]));
        let mut blocks = Blocks { alpha: self.alpha, q: load(&self.state.q), p: load(&self.state.p) };
        self.plan.march(&mut blocks, self.steps);
        for i in 0..4 {
            blocks.q[i].store(&mut self.state.q[8 * i..]);
            blocks.p[i].store(&mut self.state.p[8 * i..]);
        }
        self.state
    }
}

/// The chain of 32 sites in four registers.
pub fn chain(system: &Chain32, start: Phase<[f64; 32]>, plan: &Plan, steps: u64) -> Phase<[f64; 32]> {
    enter(ChainMarch { alpha: system.alpha, state: start, plan, steps })
}
