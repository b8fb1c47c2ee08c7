//! Two bodies with the logarithmic Hamiltonian. The kick is written without a square root, which is not needed here.

use super::plain::march;
use crate::plan::{HandWritten, Plan};
use integrator_core::Phase;

/// State and compensated time, and twice the momentum conjugate to time.
struct TwoBodies {
    q: [f64; 2],
    p: [f64; 2],
    time: f64,
    carried: f64,
    twice_b: f64,
}

impl HandWritten for TwoBodies {
    #[inline(always)]
    fn drift(&mut self, s: f64) {
        let [u, v] = self.p;
        let duration = (s + s) / v.mul_add(v, u.mul_add(u, self.twice_b));
        self.q = [duration.mul_add(u, self.q[0]), duration.mul_add(v, self.q[1])];
        let addend = duration + self.carried;
        let time = self.time + addend;
        self.carried = addend - (time - self.time);
        self.time = time;
    }
    #[inline(always)]
    fn kick(&mut self, s: f64) {
        let [x, y] = self.q;
        let pull = -s / y.mul_add(y, x * x);
        self.p = [pull.mul_add(x, self.p[0]), pull.mul_add(y, self.p[1])];
    }
}

/// Returns the time and the state after some steps in fictitious time.
pub fn two_bodies(start: Phase<[f64; 2]>, plan: &Plan, steps: u64) -> (f64, Phase<[f64; 2]>) {
    let Phase { q, p } = start;
    let twice_b = 2.0 / q[0].hypot(q[1]) - (p[0] * p[0] + p[1] * p[1]);
    let end = march(TwoBodies { q, p, time: 0.0, carried: 0.0, twice_b }, plan, steps);
    (end.time, Phase::new(end.q, end.p))
}
