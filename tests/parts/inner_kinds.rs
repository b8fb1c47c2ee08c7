//! Inner steps of systems whose length is known at run time, of Kepler parts and of quadratic parts.

use crate::{
    derivatives,
    many_parts::{TIME, classical, slope_of},
};
use integrator_core::{Coords, Hamiltonian, Method, Phase, prelude::*};

/// A chain of stiff bonds in a soft well, whose length is known at run time.
struct Chain;

#[hamiltonian(split = well + 2 * BlanesMoan4(bonds + kinetic), compose = Yoshida4)]
impl Chain {
    fn well(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += q[i].cos();
        }
        sum
    }
    fn bonds(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() - 1 {
            sum += 2.0 * (q[i + 1] - q[i]).powi(2) + (q[i + 1] - q[i]).powi(4);
        }
        sum
    }
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += p[i] * p[i] / 2.0;
        }
        sum
    }
}

/// A planet about a star at rest, with a strong and a weak force.
struct Planet;

#[hamiltonian(split = far + 2 * Abah844(kepler + near), compose = Yoshida4)]
impl Planet {
    fn far(&self, q: [f64; 2]) -> f64 {
        0.1 * (q[0] - 2.0 * q[1]).sin()
    }
    fn kepler(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1]) - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn near(&self, q: [f64; 2]) -> f64 {
        0.2 * (q[0] + 2.0 * q[1]).cos()
    }
}

/// An oscillator in a rotating frame, whose flow is a matrix.
struct Rotating;

#[hamiltonian(split = far + 3 * Yoshida4(near + oscillator), compose = Aba864)]
impl Rotating {
    fn far(&self, q: [f64; 2]) -> f64 {
        (q[0] - 0.5 * q[1]).cos()
    }
    fn near(&self, q: [f64; 2]) -> f64 {
        q[0] * q[0] * q[1] - q[1] * q[1] * q[1] / 3.0
    }
    fn oscillator(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + x * x + y * y) / 2.0 + 0.3 * (x * py - y * px)
    }
}

/// The order with a method from a start, by the slope of errors against the motion in this field.
fn slope<H, X, C>(system: &H, method: X, start: Phase<C>, field: impl Fn([f64; 4], f64) -> [f64; 4]) -> f64
where
    H: Hamiltonian<Coords = C>,
    X: Method<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let numbers = |state: &Phase<C>| <[f64; 4]>::try_from(derivatives::numbers(state)).expect("two pairs");
    let exact = classical(numbers(&start), field);
    slope_of(method.facts().name, exact, |steps| {
        let mut run = system.run_with::<f64, X>(method, start.clone(), TIME / f64::from(steps)).expect("a start");
        run.advance(u64::from(steps)).expect("finite");
        numbers(&run.state())
    })
}

fn in_a_chain([x, y, u, v]: [f64; 4], _: f64) -> [f64; 4] {
    let stretch = y - x;
    let pull = 4.0 * stretch + 4.0 * stretch.powi(3);
    [u, v, x.sin() + pull, y.sin() - pull]
}

fn about_a_star([x, y, u, v]: [f64; 4], _: f64) -> [f64; 4] {
    let (cube, far, near) = (x.hypot(y).powi(3), 0.1 * (x - 2.0 * y).cos(), 0.2 * (x + 2.0 * y).sin());
    [u, v, -x / cube - far + near, -y / cube + 2.0 * far + 2.0 * near]
}

fn in_a_rotating_frame([x, y, u, v]: [f64; 4], _: f64) -> [f64; 4] {
    let far = (x - 0.5 * y).sin();
    [u - 0.3 * y, v + 0.3 * x, -x - 0.3 * v - 2.0 * x * y + far, -y + 0.3 * u - x * x + y * y - 0.5 * far]
}

#[test]
fn parts_of_every_kind_keep_the_order() {
    let chain = || Phase::new(vec![0.4, -0.3], vec![0.2, 0.5]);
    let planet = || Phase { q: [1.0, 0.1], p: [0.1, 0.9] };
    let frame = || Phase { q: [0.4, -0.3], p: [0.2, 0.5] };
    for (found, order) in [
        (slope(&Chain, Yoshida4, chain(), in_a_chain), 4.0),
        (slope(&Chain, Aba864.nested(3), chain(), in_a_chain), 4.0),
        (slope(&Chain, Verlet.nested(3), chain(), in_a_chain), 2.0),
        (slope(&Planet, Yoshida4, planet(), about_a_star), 4.0),
        (slope(&Planet, Verlet.nested(5), planet(), about_a_star), 2.0),
        (slope(&Rotating, Aba864, frame(), in_a_rotating_frame), 4.0),
        (slope(&Rotating, Yoshida4.nested(1), frame(), in_a_rotating_frame), 4.0),
    ] {
        // Errors of the next order still show in steps that do not yet reach the rounding.
        assert!(found > order - 0.4, "order {found}, not {order}");
    }
}

#[test]
fn deviation_vectors_are_derivatives_of_the_steps() {
    let chain = Phase::new(vec![0.1, -0.2, 0.4], vec![0.0, 1.0, 0.5]);
    derivatives::holds("a list", &Chain, Verlet.nested(3), chain, 0.05);
    derivatives::holds("a Kepler part", &Planet, Yoshida4, Phase { q: [1.0, 0.1], p: [0.1, 0.9] }, 0.05);
    derivatives::holds("a quadratic part", &Rotating, Aba864, Phase { q: [0.4, -0.3], p: [0.2, 0.5] }, 0.05);
}
