//! Safe Rust without vectors: the formulas as written by a careful programmer, with explicit `mul_add`.

use crate::{
    enter::{Kernel, enter_scalar},
    plan::{HandWritten, Plan},
    problems::{Chain32, GRAVITY, Pendulum, Solar},
    vector::{Row, Vector},
};
use integrator_core::Phase;

struct March<'p, T> {
    by_hand: T,
    plan: &'p Plan,
    steps: u64,
}

impl<T: HandWritten> Kernel for March<'_, T> {
    type Out = T;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> T {
        self.plan.march(&mut self.by_hand, self.steps);
        self.by_hand
    }
}

struct PlainPendulum {
    q: f64,
    p: f64,
    mobility: f64,
    torque: f64,
}

impl HandWritten for PlainPendulum {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        self.q = (t * self.mobility).mul_add(self.p, self.q);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        self.p = (-t * self.torque).mul_add(self.q.sin(), self.p);
    }
}

/// Returns a stepper after some steps.
pub(super) fn march<T: HandWritten>(by_hand: T, plan: &Plan, steps: u64) -> T {
    enter_scalar(March { by_hand, plan, steps })
}

/// The pendulum with the sine of the standard library.
pub fn pendulum(system: &Pendulum, start: Phase<[f64; 1]>, plan: &Plan, steps: u64) -> Phase<[f64; 1]> {
    let mobility = 1.0 / (system.mass * system.length * system.length);
    let torque = system.mass * system.gravity * system.length;
    let by_hand = PlainPendulum { q: start.q[0], p: start.p[0], mobility, torque };
    let end = march(by_hand, plan, steps);
    Phase::new([end.q], [end.p])
}

struct PlainSolar {
    masses: [f64; 6],
    q: [[f64; 3]; 6],
    p: [[f64; 3]; 6],
}

impl HandWritten for PlainSolar {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for ((q, p), mass) in self.q.iter_mut().zip(&self.p).zip(self.masses) {
            for axis in 0..3 {
                q[axis] = (t / mass).mul_add(p[axis], q[axis]);
            }
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [0, 1, 2].map(|axis| self.q[i][axis] - self.q[j][axis]);
                let square = z.mul_add(z, y.mul_add(y, x * x));
                let pull = t * GRAVITY * self.masses[i] * self.masses[j] / (square * square.sqrt());
                for (axis, apart) in [x, y, z].into_iter().enumerate() {
                    self.p[i][axis] = (-pull).mul_add(apart, self.p[i][axis]);
                    self.p[j][axis] = pull.mul_add(apart, self.p[j][axis]);
                }
            }
        }
    }
}

/// The outer solar system; forces are computed pair by pair.
pub fn solar(system: &Solar, start: Phase<[[f64; 3]; 6]>, plan: &Plan, steps: u64) -> Phase<[[f64; 3]; 6]> {
    let by_hand = PlainSolar { masses: system.masses, q: start.q, p: start.p };
    let end = march(by_hand, plan, steps);
    Phase::new(end.q, end.p)
}

struct PlainChain {
    alpha: f64,
    q: [f64; 32],
    p: [f64; 32],
}

impl HandWritten for PlainChain {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for (q, p) in self.q.iter_mut().zip(&self.p) {
            *q = t.mul_add(*p, *q);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let mut padded = [0.0; 34];
        padded[1..33].copy_from_slice(&self.q);
        let mut bonds = [0.0; 33];
        for (bond, ends) in bonds.iter_mut().zip(padded.windows(2)) {
            let stretch = ends[1] - ends[0];
            *bond = (self.alpha * stretch).mul_add(stretch, stretch);
        }
        for (p, bonds) in self.p.iter_mut().zip(bonds.windows(2)) {
            *p = t.mul_add(bonds[1] - bonds[0], *p);
        }
    }
}

/// The chain of 32 sites; each bond is evaluated once.
pub fn chain(system: &Chain32, start: Phase<[f64; 32]>, plan: &Plan, steps: u64) -> Phase<[f64; 32]> {
    let end = enter_scalar(March { by_hand: PlainChain { alpha: system.alpha, q: start.q, p: start.p }, plan, steps });
    Phase::new(end.q, end.p)
}
