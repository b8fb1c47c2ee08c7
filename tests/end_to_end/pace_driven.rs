//! Steps in a time of their own where the potential reads the time: a coordinate whose momentum stands alone in `T`.

use crate::slope::observed_order;
use integrator_core::prelude::*;

/// A comet whose star pulses, with the time as its last coordinate.
struct Pulsing;

#[hamiltonian]
impl Pulsing {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + p[2]
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -(1.0 + 0.1 * q[2].sin()) / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// The same comet with the time as an argument, for fixed steps.
struct InTime;

#[hamiltonian]
impl InTime {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        -(1.0 + 0.1 * t.sin()) / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

const SPAN: f64 = 7.0;

#[test]
fn the_time_may_be_a_coordinate() {
    // Of order 10 and in short steps: its error is far below those that are looked at, 8e-11 and more.
    let mut exact = InTime
        .run_with(SofroniouSpaletta10, Phase::compensated([0.4, 0.0], [0.0, 2.0]), 7.0 / 8192.0)
        .expect("a start");
    exact.advance(8192).expect("finite states");
    let [x, y] = exact.state().q.map(|leaf| leaf.value);
    let begin = |h| {
        let start = Phase::compensated([0.4, 0.0, 0.0], [0.0, 2.0, 0.0]);
        Pulsing.run_with(Logarithmic(Yoshida4), start, h).expect("a start")
    };
    let order = observed_order(4, |steps| {
        let mut run = begin(SPAN / steps as f64);
        run.advance_to(SPAN).expect("finite states");
        let q = run.state().q.map(|leaf| leaf.value);
        assert!((q[2] - SPAN).abs() < 1e-13, "the coordinate is the time: {}", q[2]);
        f64::hypot(q[0] - x, q[1] - y)
    });
    assert!((order - 4.0).abs() < 0.3, "observed {order}");
}
