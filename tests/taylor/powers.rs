//! Powers whose exponents are parameters, from where their base is zero: they move as the products that they stand for.

use crate::runs::FINE;
use integrator_core::{KahanLi8, prelude::*, taylor::Taylor};

struct Whole {
    n: i32,
}

#[hamiltonian(taylor)]
impl Whole {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0].powi(self.n)
    }
}

struct Any {
    x: f64,
}

#[hamiltonian(taylor)]
impl Any {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0].powf(self.x)
    }
}

/// Bonds with exponents of their own, the first two of which are not stretched.
struct Chain {
    exponents: Vec<i32>,
}

#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            energy += (q[i] - q[i + 1]).powi(self.exponents[i]);
        }
        energy
    }
}

/// The force of `q^n / 2` from the origin, by steps of a composition that are short enough for its error to be a few roundings.
fn by_products(n: i32, h: f64) -> [f64; 2] {
    // y = (q, p) by Runge and Kutta's method of order 4 with 4,096 steps for a duration of one: its error is near 1e-14.
    let steps = 4096;
    let tau = h / f64::from(steps);
    let force = |q: f64| if n == 0 { 0.0 } else { -0.5 * f64::from(n) * q.powi(n - 1) };
    let field = |[q, p]: [f64; 2]| [p, force(q)];
    let along = |[q, p]: [f64; 2], [dq, dp]: [f64; 2], t: f64| [q + t * dq, p + t * dp];
    let mut y = [0.0, 0.8];
    for _ in 0..steps {
        let a = field(y);
        let b = field(along(y, a, tau / 2.0));
        let c = field(along(y, b, tau / 2.0));
        let d = field(along(y, c, tau));
        y = along(y, std::array::from_fn(|i| a[i] + 2.0 * (b[i] + c[i]) + d[i]), tau / 6.0);
    }
    y
}

#[test]
fn whole_exponents_are_those_of_products() {
    for n in 0..8 {
        for h in [0.125, -0.125] {
            let start = Phase::new([0.0], [0.8]);
            let mut whole = Whole { n }.run_with(Taylor::tolerance(FINE), start, h).expect("a start");
            let mut any = Any { x: n.into() }.run_with(Taylor::tolerance(FINE), start, h).expect("a start");
            let expected = by_products(n, 8.0 * h);
            whole.advance(8).unwrap_or_else(|error| panic!("q^{n}: {error}"));
            assert_eq!(any.advance(8).map(|()| any.state()), Ok(whole.state()), "q^{n}");
            for (found, expected) in [whole.state().q[0], whole.state().p[0]].into_iter().zip(expected) {
                // Truncation of the reference, and 4,096 roundings of numbers below one.
                assert!((found - expected).abs() < 1e-12, "q^{n}, h = {h}: {found} and {expected}");
            }
        }
    }
}

#[test]
fn whole_exponents_may_differ_from_bond_to_bond() {
    let chain = Chain { exponents: vec![2, 3, 4, 2, 6, 4, 2, 2, 4] };
    let q = vec![0.3, 0.3, 0.3, -0.2, 0.1, 0.1, 0.4, 0.0, 0.1, 0.2];
    let start = Phase::new(q, vec![0.0; 10]);
    let mut run = chain.run_with(Taylor::tolerance(FINE), start.clone(), 0.25).expect("a start");
    let mut reference = chain.run_with(KahanLi8, start, 1.0 / 256.0).expect("a start");
    run.advance(4).expect("a regular motion");
    reference.advance(256).expect("a regular motion");
    for (found, expected) in run.state().q.iter().zip(&reference.state().q) {
        let [found, expected]: [f64; 2] = [*found, *expected];
        // The eighth power of the reference's step is below a rounding; it has some 4,000 stages of roundings.
        assert!((found - expected).abs() < 1e-13, "{found} and {expected}");
    }
}

#[test]
fn a_power_that_is_not_smooth_is_still_singular() {
    for x in [0.5, 2.5, -1.0] {
        let run = Any { x }.run_with(Taylor::tolerance(FINE), Phase::new([0.0], [0.8]), 0.1);
        assert!(run.is_err() || run.is_ok_and(|mut run| run.advance(1).is_err()), "q^{x}");
    }
}
