//! A state and one deviation vector, advanced by hand-written derivatives of the flows.
//!
//! Every function takes the initial state and vector, and returns both after some steps.

use crate::{
    by_hand::{
        orbits::{Arc, arc, dot, series},
        plain::march,
    },
    enter::{Kernel, enter},
    functions::sine_and_cosine,
    plan::{HandWritten, Plan},
    problems::{self, Chain32, GRAVITY, Solar},
    vector::{Many, Row, Vector},
};
use integrator_core::{Coords, Phase};

/// A state and a vector.
type Two<C> = [Phase<C>; 2];

struct Pendulum {
    q: [f64; 2],
    p: [f64; 2],
    mobility: f64,
    torque: f64,
}

impl HandWritten for Pendulum {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for (q, p) in self.q.iter_mut().zip(self.p) {
            *q = (t * self.mobility).mul_add(p, *q);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [Many([sine]), Many([cosine])] = sine_and_cosine(Many([self.q[0]]));
        let force = -t * self.torque;
        self.p[0] = force.mul_add(sine, self.p[0]);
        self.p[1] = (force * cosine).mul_add(self.q[1], self.p[1]);
    }
}

/// A pendulum.
pub fn pendulum(system: &problems::Pendulum, [start, vector]: Two<[f64; 1]>, plan: &Plan, steps: u64) -> Two<[f64; 1]> {
    let mobility = 1.0 / (system.mass * system.length * system.length);
    let torque = system.mass * system.gravity * system.length;
    let by_hand = Pendulum { q: [start.q[0], vector.q[0]], p: [start.p[0], vector.p[0]], mobility, torque };
    let Pendulum { q, p, .. } = march(by_hand, plan, steps);
    [Phase::new([q[0]], [p[0]]), Phase::new([q[1]], [p[1]])]
}

/// Written with the fewest operations from one kick to the next.
struct HenonHeiles {
    q: [[f64; 2]; 2],
    p: [[f64; 2]; 2],
}

impl HandWritten for HenonHeiles {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for (q, p) in self.q.as_flattened_mut().iter_mut().zip(self.p.as_flattened()) {
            *q = t.mul_add(*p, *q);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [[x, y], [dx, dy]] = self.q;
        let [[px, py], [dpx, dpy]] = &mut self.p;
        let (by_x, by_y) = (-2.0 * t * x, y + 0.5);
        *px = by_x.mul_add(by_y, *px);
        *py = (-t).mul_add((-y).mul_add(y, x.mul_add(x, y)), *py);
        *dpx = (-2.0 * t * by_y).mul_add(dx, by_x.mul_add(dy, *dpx));
        *dpy = by_x.mul_add(dx, (-t * (-2.0_f64).mul_add(y, 1.0)).mul_add(dy, *dpy));
    }
}

/// The Hénon–Heiles system.
pub fn henon_heiles([start, vector]: Two<[f64; 2]>, plan: &Plan, steps: u64) -> Two<[f64; 2]> {
    let HenonHeiles { q, p } = march(HenonHeiles { q: [start.q, vector.q], p: [start.p, vector.p] }, plan, steps);
    [0, 1].map(|i| Phase::new(q[i], p[i]))
}

/// Positions and momenta of the state and of the vector, in `N` registers each.
struct Registers<R, const N: usize> {
    q: [[R; N]; 2],
    p: [[R; N]; 2],
}

/// A system with its bodies or sites in SIMD lanes.
trait SideBySide<const N: usize>: Copy {
    type Coords: Coords<Leaf = f64>;
    type Flows<R: Row>: Flows<R, N>;

    fn flows<R: Row>(self) -> Self::Flows<R>;
    /// Returns the coordinate index of a lane of a register. Unused lanes repeat the first coordinates.
    fn place(register: usize, lane: usize) -> usize;
}

/// Flows of a state in registers.
trait Flows<R, const N: usize> {
    fn drift(&self, registers: &mut Registers<R, N>, t: f64);
    fn kick(&self, registers: &mut Registers<R, N>, t: f64);
}

struct Stepper<R, F, const N: usize> {
    registers: Registers<R, N>,
    flows: F,
}

impl<R, F: Flows<R, N>, const N: usize> HandWritten for Stepper<R, F, N> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        self.flows.drift(&mut self.registers, t);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        self.flows.kick(&mut self.registers, t);
    }
}

struct March<'p, S: SideBySide<N>, const N: usize> {
    system: S,
    points: Two<S::Coords>,
    plan: &'p Plan,
    steps: u64,
}

impl<S: SideBySide<N>, const N: usize> Kernel for March<'_, S, N> {
    type Out = Two<S::Coords>;
    #[inline(always)]
    fn run<V: Row, R: Row, L: Vector<Number = f32>>(mut self) -> Self::Out {
        let load = |flat: &[f64]| {
            let register = |i: usize| R::load(&std::array::from_fn::<f64, 8, _>(|lane| flat[S::place(i, lane)]));
            std::array::from_fn(register)
        };
        let [state, vector] = &self.points;
        let q = [load(state.q.flat()), load(vector.q.flat())];
        let p = [load(state.p.flat()), load(vector.p.flat())];
        let mut stepper = Stepper { registers: Registers { q, p }, flows: self.system.flows::<R>() };
        self.plan.march(&mut stepper, self.steps);
        let store = |registers: &[R; N], flat: &mut [f64]| {
            for (i, register) in registers.iter().enumerate() {
                let mut lanes = [0.0; 8];
                register.store(&mut lanes);
                // In reverse order, so that the first lanes overwrite the lanes that repeat them.
                for (lane, number) in lanes.into_iter().enumerate().rev() {
                    flat[S::place(i, lane)] = number;
                }
            }
        };
        let Registers { q, p } = &stepper.registers;
        for (i, point) in self.points.iter_mut().enumerate() {
            store(&q[i], point.q.flat_mut());
            store(&p[i], point.p.flat_mut());
        }
        self.points
    }
}

/// Adds multiples of momenta to positions.
#[inline(always)]
fn shear<R: Row, const N: usize>(registers: &mut Registers<R, N>, mobility: R) {
    for i in 0..2 {
        for j in 0..N {
            registers.q[i][j] = mobility.fma(registers.p[i][j], registers.q[i][j]);
        }
    }
}

/// Six bodies in the lanes of a register, as in [`row`](super::row).
struct Ring<R> {
    inverse_masses: R,
    couplings: [R; 3],
}

impl<R: Row> Ring<R> {
    /// Returns the pull of the body in lane `i + BY` on the body in lane `i`, and its derivative along the vector.
    #[inline(always)]
    fn pull<const BY: usize>(&self, [q, dq]: &[[R; 3]; 2], t: f64) -> [[R; 3]; 2] {
        let (mut apart, mut moved) = (*q, *dq);
        for axis in 0..3 {
            apart[axis] = q[axis].rotate::<BY, 6>() - q[axis];
            moved[axis] = dq[axis].rotate::<BY, 6>() - dq[axis];
        }
        let square = dot(&apart, &apart);
        let pull = square.over_cube(self.couplings[BY - 1] * R::splat(t));
        let slope = R::splat(-3.0) * pull * dot(&apart, &moved) / square;
        for axis in 0..3 {
            moved[axis] = slope.fma(apart[axis], pull * moved[axis]);
            apart[axis] = pull * apart[axis];
        }
        [apart, moved]
    }
}

impl<R: Row> Flows<R, 3> for Ring<R> {
    #[inline(always)]
    fn drift(&self, registers: &mut Registers<R, 3>, t: f64) {
        shear(registers, R::splat(t) * self.inverse_masses);
    }
    #[inline(always)]
    fn kick(&self, Registers { q, p }: &mut Registers<R, 3>, t: f64) {
        let (near, second, across) = (self.pull::<1>(q, t), self.pull::<2>(q, t), self.pull::<3>(q, t));
        for i in 0..2 {
            for axis in 0..3 {
                let actions = near[i][axis] + second[i][axis] + across[i][axis];
                let reactions = near[i][axis].rotate::<5, 6>() + second[i][axis].rotate::<4, 6>();
                p[i][axis] = p[i][axis] + (actions - reactions);
            }
        }
    }
}

impl SideBySide<3> for Solar {
    type Coords = [[f64; 3]; 6];
    type Flows<R: Row> = Ring<R>;

    #[inline(always)]
    fn flows<R: Row>(self) -> Ring<R> {
        let row = |of: &dyn Fn(usize) -> f64| R::load(&std::array::from_fn::<f64, 8, _>(|lane| of(lane % 6)));
        let Solar { masses } = self;
        Ring {
            inverse_masses: row(&|body| 1.0 / masses[body]),
            couplings: [1, 2, 3].map(|by| row(&|body| GRAVITY * masses[body] * masses[(body + by) % 6])),
        }
    }
    fn place(axis: usize, lane: usize) -> usize {
        3 * (lane % 6) + axis
    }
}

/// The outer solar system.
pub fn solar(system: &Solar, points: Two<[[f64; 3]; 6]>, plan: &Plan, steps: u64) -> Two<[[f64; 3]; 6]> {
    enter(March { system: *system, points, plan, steps })
}

/// Nonlinear coefficient of a chain's bonds.
struct Bonds {
    alpha: f64,
}

impl Bonds {
    /// Returns the tension of bonds, and its derivative along the vector.
    #[inline(always)]
    fn bond<R: Row>(&self, [stretch, change]: [R; 2]) -> [R; 2] {
        let part = R::splat(self.alpha) * stretch;
        [part.fma(stretch, stretch), (part + part).fma(change, change)]
    }
}

impl<R: Row> Flows<R, 4> for Bonds {
    #[inline(always)]
    fn drift(&self, registers: &mut Registers<R, 4>, t: f64) {
        shear(registers, R::splat(t));
    }
    #[inline(always)]
    fn kick(&self, Registers { q: [q, dq], p: [p, dp] }: &mut Registers<R, 4>, t: f64) {
        let (wall, t) = (R::splat(0.0), R::splat(t));
        // The last lane of `left` is the bond to the wall on the left.
        let mut left = self.bond([wall.after(q[0]), wall.after(dq[0])]);
        for i in 0..4 {
            let next = if i < 3 { [q[i + 1], dq[i + 1]] } else { [wall; 2] };
            let right = self.bond([q[i].after(next[0]) - q[i], dq[i].after(next[1]) - dq[i]]);
            p[i] = t.fma(right[0] - right[0].before(left[0]), p[i]);
            dp[i] = t.fma(right[1] - right[1].before(left[1]), dp[i]);
            left = right;
        }
    }
}

impl SideBySide<4> for Chain32 {
    type Coords = [f64; 32];
    type Flows<R: Row> = Bonds;

    #[inline(always)]
    fn flows<R: Row>(self) -> Bonds {
        Bonds { alpha: self.alpha }
    }
    fn place(block: usize, lane: usize) -> usize {
        8 * block + lane
    }
}

/// The chain of 32 sites.
pub fn chain(system: &Chain32, points: Two<[f64; 32]>, plan: &Plan, steps: u64) -> Two<[f64; 32]> {
    enter(March { system: *system, points, plan, steps })
}

/// Planets on Kepler orbits, as in [`orbits`](super::orbits).
struct Orbits<R> {
    inverse_masses: R,
    strengths: R,
    spring: f64,
}

impl<R: Row> Flows<R, 3> for Orbits<R> {
    /// The derivative of the arc with respect to its initial state. The derivative of Kepler's equation gives the
    /// change of the universal variable, and `∂Gₙ/∂β = (n Gₙ₊₂ - s Gₙ₊₁) / 2` the change of its functions.
    #[inline(always)]
    fn drift(&self, Registers { q: [q, dq], p: [p, dp] }: &mut Registers<R, 3>, t: f64) {
        let of = R::splat;
        let (t, w, k) = (of(t), self.inverse_masses, self.strengths);
        let Arc { distances: [r0, inverse, r], mu, eta, beta, zeta, s, functions: [g1, g2, g3] } = arc([q, p], w, k, t);
        let (x, square) = (beta * s * s, s * s);
        let (g4, g5) = (square * square * series(x, 4), square * square * s * series(x, 5));
        let dr0 = dot(q, dq) * inverse;
        let deta = w * (dot(q, dp) + dot(p, dq));
        let dbeta = of(-2.0) * (mu * inverse * inverse).fma(dr0, w * w * dot(p, dp));
        let dzeta = of(-1.0) * dbeta.fma(r0, beta * dr0);
        let half = of(0.5) * dbeta;
        let by_beta = [half * s.fnma(g2, g3), half * s.fnma(g3, g4 + g4), half * s.fnma(g4, of(3.0) * g5)];
        let arrival = of(1.0) / r;
        let late = eta.fma(by_beta[1], zeta * by_beta[2]) + s.fma(dr0, g2.fma(deta, g3 * dzeta));
        let ds = of(-1.0) * late * arrival;
        let g0 = beta.fnma(g2, of(1.0));
        let [dg1, dg2, dg3] = [g0.fma(ds, by_beta[0]), g1.fma(ds, by_beta[1]), g2.fma(ds, by_beta[2])];
        let dr = dr0 + g1.fma(deta, eta * dg1) + g2.fma(dzeta, zeta * dg2);

        let (near, pull) = (mu * inverse, k * inverse * arrival);
        let (f, g, f_dot, g_dot) = (of(-1.0) * near * g2, w * mu.fnma(g3, t), of(-1.0) * pull * g1, mu * g2 * arrival);
        let df = near * (g2 * inverse).fma(dr0, of(-1.0) * dg2);
        let dg = of(-1.0) * w * mu * dg3;
        let df_dot = pull * (g1 * inverse.fma(dr0, arrival * dr) - dg1);
        let dg_dot = mu * arrival * (g2 * arrival).fma(dr, of(-1.0) * dg2);
        for axis in 0..3 {
            let (x, v, dx, dv) = (q[axis], p[axis], dq[axis], dp[axis]);
            q[axis] = x + f.fma(x, g * v);
            p[axis] = v + g_dot.fnma(v, f_dot * x);
            dq[axis] = dx + f.fma(dx, g * dv) + df.fma(x, dg * v);
            dp[axis] = dv + g_dot.fnma(dv, f_dot * dx) + df_dot.fma(x, dg_dot * v);
        }
    }
    #[inline(always)]
    fn kick(&self, Registers { q, p }: &mut Registers<R, 3>, t: f64) {
        for i in 0..2 {
            for axis in 0..3 {
                p[i][axis] = R::splat(-t * self.spring).fma(q[i][axis], p[i][axis]);
            }
        }
    }
}

impl SideBySide<3> for problems::Planets {
    type Coords = [[f64; 3]; 5];
    type Flows<R: Row> = Orbits<R>;

    #[inline(always)]
    fn flows<R: Row>(self) -> Orbits<R> {
        let row = |of: &dyn Fn(usize) -> f64| R::load(&std::array::from_fn::<f64, 8, _>(|lane| of(lane % 5)));
        Orbits {
            inverse_masses: row(&|body| 1.0 / self.masses[body]),
            strengths: row(&|body| self.pull * self.masses[body]),
            spring: self.spring,
        }
    }
    fn place(axis: usize, lane: usize) -> usize {
        3 * (lane % 5) + axis
    }
}

/// Planets orbiting a star.
pub fn planets(system: &problems::Planets, points: Two<[[f64; 3]; 5]>, plan: &Plan, steps: u64) -> Two<[[f64; 3]; 5]> {
    enter(March { system: *system, points, plan, steps })
}
