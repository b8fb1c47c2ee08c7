//! Tests of coupled copies of the state, on the example of Tao, whose solution is an elliptic function.

use crate::slope::slope;
use integrator_core::{
    __private::{Doubled, Motion},
    CheckpointError, Composition, Ensemble, Error, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, Phase,
    Run, System,
    check::{CertifyError, Shortfall, certify},
    prelude::*,
};

/// `(q² + 1) (p² + 1)/2`.
struct Mixed {
    coupling: f64,
}

#[hamiltonian(split = symmetric(omega = self.coupling), compose = Yoshida4)]
impl Mixed {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (q[0] * q[0] + 1.0) * (p[0] * p[0] + 1.0) / 2.0
    }
}

const MIXED: Mixed = Mixed { coupling: 10.0 };

/// The largest position.
const A: f64 = 0.9;

/// Sine, cosine and delta amplitude of Jacobi with modulus `k`, by the arithmetic-geometric mean.
fn jacobi(u: f64, k: f64) -> [f64; 3] {
    let mut means = vec![(1.0, k)];
    let (mut a, mut b) = (1.0_f64, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        let c = (a - b) / 2.0;
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
        means.push((a, c));
    }
    let mut phi = 256.0 * a * u;
    for (a, c) in means[1..].iter().rev() {
        phi = (phi + (c / a * phi.sin()).asin()) / 2.0;
    }
    [phi.sin(), phi.cos(), (1.0 - (k * phi.sin()).powi(2)).sqrt()]
}

/// From `(A, 0)`: `q'² = (A² - q²)(1 + q²)`, hence `q = A cn(√(1 + A²) t)`, and `p = q'/(q² + 1)`.
fn exact(t: f64) -> [f64; 2] {
    let rate = (1.0 + A * A).sqrt();
    let [sn, cn, dn] = jacobi(rate * t, A / rate);
    let q = A * cn;
    [q, -A * rate * sn * dn / (q * q + 1.0)]
}

const TIME: f64 = 3.0;

fn error<X: Method<Mixed>>(composition: X, steps: u32) -> f64 {
    let mut run = MIXED.run_with(composition, Phase::new([A], [0.0]), TIME / f64::from(steps)).expect("a start");
    run.advance(u64::from(steps)).expect("finite");
    let (Phase { q, p }, [x, y]) = (run.state(), exact(TIME));
    (q[0] - x).hypot(p[0] - y)
}

#[test]
fn errors_fall_with_the_order() {
    fn measure<X: Composition<Mixed>>(composition: X, steps: [u32; 4]) {
        let points = steps.map(|steps| (TIME / f64::from(steps), error(composition, steps)));
        let (slope, order) = (slope(&points), f64::from(X::ORDER));
        assert!((slope - order).abs() < 0.3, "{} has order {slope}, not {order}: {points:?}", X::NAME);
    }
    measure(Euler, [12_800, 25_600, 51_200, 102_400]);
    measure(Verlet, [400, 800, 1600, 3200]);
    measure(Yoshida4, [800, 1600, 2400, 3200]);
    measure(KahanLi6, [250, 300, 350, 400]);
}

#[test]
fn implicit_methods_follow_the_whole_field() {
    fn measure(order: f64, error: impl Fn(u32) -> f64, steps: [u32; 3]) {
        let points = steps.map(|steps| (TIME / f64::from(steps), error(steps)));
        let slope = slope(&points);
        assert!((slope - order).abs() < 0.2, "order {slope}, not {order}: {points:?}");
    }
    measure(2.0, |steps| error(ImplicitMidpoint, steps), [60, 120, 240]);
    measure(4.0, |steps| error(GaussLegendre4, steps), [30, 60, 120]);
    measure(6.0, |steps| error(GaussLegendre6, steps), [20, 30, 40]);
    certify(&MIXED, GaussLegendre4, Phase::new([A], [0.0]), 0.05).expect("symplectic and symmetric");
    let mut run = MIXED.run_with(GaussLegendre6, Phase::new([A], [0.0]), 1e6).expect("a start");
    assert!(matches!(run.advance(10), Err(Error::NotSolved { method: "GaussLegendre6", .. })));
}

#[test]
fn the_energy_stays() {
    let mut run = MIXED.run(Phase::new([A], [0.0]), 0.02).expect("a start");
    let start = run.energy();
    let mut worst = [0.0_f64; 2];
    for sample in 0..400 {
        run.advance(100).expect("finite");
        let half = &mut worst[sample / 200];
        *half = half.max((run.energy() - start).abs());
    }
    assert!(worst[0] > 0.0 && worst[0] < 1e-4 && worst[1] < 2.0 * worst[0], "{worst:?}");
}

/// Positions, momenta and their copies, coupled for a while.
fn rotated(mut state: [f64; 4], coupling: f64, durations: &[f64]) -> [f64; 4] {
    let point = Phase { q: [state[0]], p: [state[1]] };
    let parameters = MIXED.parameters(1);
    type Of = Doubled<f64, [f64; 1], <Mixed as System>::Parameters<f64>>;
    let mut motion: Of = Motion::load(&[&parameters], &[&point]);
    (motion.x, motion.y) = ([state[2]], [state[3]]);
    for duration in durations {
        motion.rotate(coupling, *duration);
    }
    state = [motion.q[0], motion.p[0], motion.x[0], motion.y[0]];
    state
}

#[test]
fn the_coupling_rotates_the_differences() {
    let start = [0.3, -0.2, 0.7, 0.4];
    let [q, p, x, y] = rotated(start, 2.0, &[0.3]);
    let (sine, cosine) = 1.2_f64.sin_cos();
    let off = [
        (q + x) - 1.0,
        (p + y) - 0.2,
        (q - x) - (cosine * -0.4 + sine * -0.6),
        (p - y) - (cosine * -0.6 - sine * -0.4),
    ];
    assert!(off.iter().all(|off| off.abs() < 4.0 * f64::EPSILON), "{off:?}");
    for durations in [&[0.3, 0.5, -0.8][..], &[core::f64::consts::FRAC_PI_2]] {
        let end = rotated(start, 2.0, durations);
        let off = end.iter().zip(start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max);
        assert!(off < 8.0 * f64::EPSILON, "{durations:?}: {end:?}");
    }
}

#[test]
fn members_have_the_bits_of_their_runs() {
    let starts: Vec<_> = (0..9).map(|k| Phase::new([0.1 + 0.1 * f64::from(k)], [0.05])).collect();
    let members = starts.iter().map(|start| (MIXED, *start));
    let mut ensemble = Ensemble::new(Yoshida4, members, 0.05).expect("starts");
    ensemble.advance(50).expect("finite");
    for (member, start) in starts.iter().enumerate() {
        let mut run = MIXED.run(*start, 0.05).expect("a start");
        run.advance(50).expect("finite");
        assert_eq!(ensemble.state(member), Some(run.state()));
    }
}

#[test]
fn nothing_is_claimed_of_one_copy_alone() {
    let start = Phase::new([A], [0.0]);
    match certify(&MIXED, Yoshida4, start, 0.02) {
        Err(CertifyError::Refused { certificate, shortfalls }) => {
            assert!(shortfalls.iter().any(|shortfall| matches!(shortfall, Shortfall::NotSymplectic { .. })));
            let others = shortfalls.iter().filter(|shortfall| {
                !matches!(shortfall, Shortfall::NotSymplectic { .. } | Shortfall::Symplecticity { .. })
            });
            assert_eq!(others.count(), 0, "{shortfalls:?}");
            assert!(!certificate.symmetric && certificate.flows.is_some_and(|flows| flows.generator <= 1.0));
        }
        other => panic!("{other:?}"),
    }
    let reversible = MIXED.run(Phase::reversible([A], [0.0], 2.0_f64.powi(-40)), 0.02);
    assert!(matches!(reversible, Err(Error::NotSymmetric { .. })));
    let mut run = MIXED.run(start, 0.02).expect("a start");
    run.advance(10).expect("finite");
    let resumed: Result<Run<[f64; 1]>, _> = Run::resume(&MIXED, &run.checkpoint());
    assert!(matches!(resumed, Err(CheckpointError::Copies { .. })));
}
