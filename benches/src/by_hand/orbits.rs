//! Five planets on Kepler orbits in SIMD lanes; the second part is a weak spring to the star.

use crate::{
    enter::{Kernel, enter},
    plan::{HandWritten, Plan},
    problems::Planets,
    vector::{Row, Vector},
};
use integrator_core::Phase;

/// The planets; the star attracts a planet with the strength `k = pull · mass`.
struct Orbits<R> {
    q: [R; 3],
    p: [R; 3],
    inverse_masses: R,
    strengths: R,
    spring: f64,
}

/// Solves `d + a d² + b d³ + c d⁴ = y` for a short arc: the universal variable, or a correction to it.
#[inline(always)]
fn reverted<R: Row>(y: R, [a, b, c]: [R; 3]) -> R {
    let square = a * a;
    let quartic = (R::splat(5.0) * a).fma(square - b, c);
    let high = quartic.fnma(y, (square + square) - b);
    y * (y * y).fma(high, y.fnma(a, R::splat(1.0)))
}

/// A series of eight terms with the reciprocals of every second factorial.
#[inline(always)]
pub(super) fn series<R: Row>(x: R, first: i32) -> R {
    let mut terms = [R::splat(0.0); 8];
    let mut factorial = (1..=first).map(f64::from).product::<f64>();
    for (n, term) in terms.iter_mut().enumerate() {
        *term = R::splat(if n % 2 == 0 { 1.0 } else { -1.0 } / factorial);
        let next = f64::from(first + 2 * n as i32);
        factorial *= (next + 1.0) * (next + 2.0);
    }
    let [a, b, c, d, e, f, g, h] = terms;
    let square = x * x;
    let low = square.fma(x.fma(d, c), x.fma(b, a));
    (square * square).fma(square.fma(x.fma(h, g), x.fma(f, e)), low)
}

/// A solved arc of an orbit.
pub(super) struct Arc<R> {
    /// Initial distance, its reciprocal, and the final distance.
    pub(super) distances: [R; 3],
    /// Gravity times masses, `q·v`, `2μ/r - v²`, and the remaining term in the change of the second one.
    pub(super) mu: R,
    pub(super) eta: R,
    pub(super) beta: R,
    pub(super) zeta: R,
    /// Universal variable, and its functions from the first one on.
    pub(super) s: R,
    pub(super) functions: [R; 3],
}

#[inline(always)]
pub(super) fn dot<R: Row>(a: &[R; 3], b: &[R; 3]) -> R {
    a[2].fma(b[2], a[1].fma(b[1], a[0] * b[0]))
}

/// Solves Kepler's equation for the arcs of all planets. A further correction follows if one planet needs it. Without
/// optimisation, a function with all of this inlined would need megabytes of stack.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn arc<R: Row>([q, p]: [&[R; 3]; 2], w: R, k: R, t: R) -> Arc<R> {
    let one = R::splat(1.0);
    let r0 = dot(q, q).sqrt();
    let inverse = one / r0;
    let (mu, eta, speed) = (k * w, w * dot(q, p), w * w * dot(p, p));
    let beta = (mu + mu).fma(inverse, R::splat(0.0) - speed);
    let zeta = speed.fma(r0, R::splat(0.0) - mu);
    let terms = [R::splat(0.5) * eta, R::splat(1.0 / 6.0) * zeta, R::splat(-1.0 / 24.0) * beta * eta];
    let mut s = reverted(t * inverse, terms.map(|term| term * inverse));
    loop {
        let (x, square) = (beta * s * s, s * s);
        let (g2, g3) = (square * series(x, 2), square * s * series(x, 3));
        let (g0, g1) = (beta.fnma(g2, one), beta.fnma(g3, s));
        let late = zeta.fma(g3, eta.fma(g2, r0.fma(s, R::splat(0.0) - t)));
        let r = zeta.fma(g2, eta.fma(g1, r0));
        let slope = zeta.fma(g1, eta * g0);
        let curvature = beta.fnma(r, mu);
        let over = one / r;
        let a = R::splat(0.5) * slope * over;
        let linear = R::splat(0.0) - late * over;
        let terms = [a, R::splat(1.0 / 6.0) * curvature * over, R::splat(-1.0 / 12.0) * beta * a];
        let d = reverted(linear, terms);
        if (a * linear).largest() > 1.0 / 8192.0 {
            s = s + d;
            continue;
        }
        let (square, x) = (d * d, beta * d * d);
        let d1 = d * x.fma(R::splat(-1.0 / 6.0), one);
        let d2 = square * x.fma(R::splat(-1.0 / 24.0), R::splat(0.5));
        let d3 = square * d * R::splat(1.0 / 6.0);
        let (h2, h3) = (g2 + g1.fma(d1, g0 * d2), g3 + g2.fma(d, g1.fma(d2, g0 * d3)));
        let h1 = g1 + g0.fma(d1, R::splat(0.0) - beta * g1 * d2);
        let end = r + slope.fma(d1, curvature * d2);
        return Arc { distances: [r0, inverse, end], mu, eta, beta, zeta, s: s + d, functions: [h1, h2, h3] };
    }
}

impl<R: Row> HandWritten for Orbits<R> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let (t, w, k) = (R::splat(t), self.inverse_masses, self.strengths);
        let Arc { distances: [_, inverse, r], mu, functions: [g1, g2, g3], .. } = arc([&self.q, &self.p], w, k, t);
        let arrival = R::splat(1.0) / r;
        let (f, g) = (R::splat(0.0) - mu * inverse * g2, w * mu.fnma(g3, t));
        let (f_dot, g_dot) = (k * inverse * (g1 * arrival), mu * (g2 * arrival));
        for axis in 0..3 {
            let (q, p) = (self.q[axis], self.p[axis]);
            self.q[axis] = q + f.fma(q, g * p);
            self.p[axis] = p - f_dot.fma(q, g_dot * p);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        for axis in 0..3 {
            self.p[axis] = R::splat(-t * self.spring).fma(self.q[axis], self.p[axis]);
        }
    }
}

struct March<'p> {
    system: &'p Planets,
    state: Phase<[[f64; 3]; 5]>,
    plan: &'p Plan,
    steps: u64,
}

impl Kernel for March<'_> {
    type Out = Phase<[[f64; 3]; 5]>;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> Self::Out {
        // Lanes after the last planet repeat the first planets.
        let row = |of: &dyn Fn(usize) -> f64| R::load(&std::array::from_fn::<f64, 8, _>(|lane| of(lane % 5)));
        let column = |of: &[[f64; 3]; 5]| [0, 1, 2].map(|axis| row(&|body| of[body][axis]));
        let Planets { masses, pull, spring } = *self.system;
        let mut orbits = Orbits {
            q: column(&self.state.q),
            p: column(&self.state.p),
            inverse_masses: row(&|body| 1.0 / masses[body]),
            strengths: row(&|body| pull * masses[body]),
            spring,
        };
        self.plan.march(&mut orbits, self.steps);
        for axis in 0..3 {
            let mut lanes = [[0.0; 8]; 2];
            orbits.q[axis].store(&mut lanes[0]);
            orbits.p[axis].store(&mut lanes[1]);
            for body in 0..5 {
                self.state.q[body][axis] = lanes[0][body];
                self.state.p[body][axis] = lanes[1][body];
            }
        }
        self.state
    }
}

/// Planets orbiting a star.
pub fn planets(system: &Planets, start: Phase<[[f64; 3]; 5]>, plan: &Plan, steps: u64) -> Phase<[[f64; 3]; 5]> {
    enter(March { system, state: start, plan, steps })
}
