//! How often steps apply the flow of each part, against flows that count themselves.

use integrator_core::prelude::*;
use std::sync::{
    Arc,
    atomic::{AtomicU64, Ordering::Relaxed},
};

/// The number of calls of each flow.
type Calls = Arc<[AtomicU64; 4]>;

/// Four parts with hand-written flows.
macro_rules! counted {
    ($name:ident: $($split:tt)*) => {
        #[derive(Clone, Default)]
        struct $name(Calls);

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn a(&self, q: [f64; 1]) -> f64 {
                q[0] * q[0] / 8.0
            }
            fn b(&self, p: [f64; 1]) -> f64 {
                p[0] * p[0] / 4.0
            }
            fn c(&self, q: [f64; 1]) -> f64 {
                q[0] * q[0] / 2.0
            }
            fn d(&self, p: [f64; 1]) -> f64 {
                p[0] * p[0] / 4.0
            }
            #[flow(a)]
            fn flow_of_a(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
                self.0[0].fetch_add(1, Relaxed);
                p[0] -= duration * q[0] / 4.0;
            }
            #[flow(b)]
            fn flow_of_b(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
                self.0[1].fetch_add(1, Relaxed);
                q[0] += duration * p[0] / 2.0;
            }
            #[flow(c)]
            fn flow_of_c(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
                self.0[2].fetch_add(1, Relaxed);
                p[0] -= duration * q[0];
            }
            #[flow(d)]
            fn flow_of_d(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
                self.0[3].fetch_add(1, Relaxed);
                q[0] += duration * p[0] / 2.0;
            }
            fn fingerprint(&self) -> u64 {
                0
            }
        }
    };
}

counted!(Flat: a + b + c + d);
counted!(Paired: a + (b + c + d));
counted!(Nested: a + 3 * (b + c + d));
counted!(Twice: a + 3 * Yoshida4(b + 2 * BlanesMoan4(c + d)));
// The middle level begins and ends with parts that take inner steps.
counted!(Completed: a + 3 * VelocityVerlet(b + 2 * (c + d)));

/// The calls of the flows in ten steps in the middle of a run, and what the run says of them.
macro_rules! check {
    ($($system:ident $method:expr;)*) => {$({
        let system = $system::default();
        let mut run = system.run_with($method, Phase::new([0.3], [0.1]), 0.01).expect("a start");
        run.advance(5).expect("finite");
        let mut calls_in = |steps: u64| {
            let now = || system.0.each_ref().map(|calls| calls.load(Relaxed));
            let before = now();
            run.advance(steps).expect("finite");
            std::iter::zip(now(), before).map(|(now, before)| now - before).collect::<Vec<_>>()
        };
        // Each portion also completes its last step on a copy.
        let (few, many) = (calls_in(10), calls_in(20));
        let calls: Vec<u64> = few.iter().zip(&many).map(|(few, many)| many - few).collect();
        let reported = run.evaluations_of_parts();
        let expected: Vec<u64> = reported.iter().map(|(_, flows)| flows / run.steps() * 10).collect();
        let names: Vec<_> = reported.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, ["a", "b", "c", "d"]);
        assert_eq!(calls, expected, "{} {}", stringify!($system), stringify!($method));
        assert_eq!(run.evaluations(), reported[3].1);
    })*};
}

#[test]
fn runs_report_how_often_each_flow_is_applied() {
    check! {
        Flat Verlet; Flat Yoshida4; Flat Euler;
        Paired Verlet; Paired KahanLi8;
        Nested Verlet; Nested Verlet.nested(7); Nested BlanesMoan4; Nested Aba864.nested(1); Nested Euler;
        Twice Verlet; Twice BlanesMoan4.nested(2);
        Completed Verlet; Completed VelocityVerlet.nested(5);
    }
}
