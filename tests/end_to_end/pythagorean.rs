//! The Pythagorean three-body problem against fifty digits of its motion: `pythagorean/reference.txt`, which the script beside it
//! has written.

use integrator_core::{Method, prelude::*};

const MASSES: [f64; 3] = [3.0, 4.0, 5.0];

/// Bodies of masses 3, 4 and 5.
struct Bodies;

#[hamiltonian]
impl Bodies {
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * MASSES[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                energy -= MASSES[i] * MASSES[j] / (x * x + y * y).sqrt();
            }
        }
        energy
    }
}

/// Times, and positions and velocities of the bodies.
fn reference() -> Vec<(f64, [[f64; 2]; 6])> {
    let lines = include_str!("pythagorean/reference.txt").lines().filter(|line| !line.starts_with('#'));
    let numbers = lines.map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect());
    numbers
        .map(|numbers: Vec<f64>| (numbers[0], std::array::from_fn(|i| [numbers[2 * i + 1], numbers[2 * i + 2]])))
        .collect()
}

/// Where the bodies are at each of the times of the reference, from a start whose first body is displaced.
fn paths<X: Method<Bodies>>(method: X, h: f64, displaced: f64) -> Vec<[[f64; 2]; 3]> {
    let start = Phase::compensated([[1.0, 3.0 + displaced], [-2.0, -1.0], [1.0, -1.0]], [[0.0; 2]; 3]);
    let mut run = Bodies.run_with(method, start, h).expect("a start");
    let at = |(time, _): (f64, _)| {
        run.advance_to(time).expect("finite states");
        run.state().q.map(|body| body.map(|coordinate| coordinate.value))
    };
    reference().into_iter().map(at).collect()
}

/// The largest distance of a body in one path from that in another one, at each of the times.
fn apart(one: &[[[f64; 2]; 3]], other: &[[[f64; 2]; 3]]) -> Vec<f64> {
    let distance = |one: &[f64; 2], other: &[f64; 2]| f64::hypot(one[0] - other[0], one[1] - other[1]);
    let furthest = |(one, other): (&[[f64; 2]; 3], &[[f64; 2]; 3])| {
        one.iter().zip(other).map(|(one, other)| distance(one, other)).fold(0.0, f64::max)
    };
    one.iter().zip(other).map(furthest).collect()
}

#[test]
fn ever_shorter_steps_lead_to_the_true_motion() {
    let by = Logarithmic(SofroniouSpaletta8);
    let exact: Vec<_> = reference().into_iter().map(|(_, [a, b, c, ..])| [a, b, c]).collect();
    let [long, short, shortest] = [0.2, 0.1, 0.05].map(|h| paths(by, h, 0.0));
    // What becomes of two units in the last place of a coordinate of the start: each encounter enlarges it.
    let rounding = apart(&paths(by, 0.05, 4.0 * f64::EPSILON), &shortest);
    let [long, short, shortest] = [long, short, shortest].map(|path| apart(&path, &exact));
    let mut slopes = 0;
    for (at, (time, _)) in reference().into_iter().enumerate() {
        // Compensated states round a step by less than their start was; that there are many of them is a small factor.
        assert!(shortest[at] < 4.0 * rounding[at], "t = {time}: {:.1e} apart, not {:.1e}", shortest[at], rounding[at]);
        if short[at] > 16.0 * rounding[at] {
            let slope = (long[at] / short[at]).log2();
            assert!(slope > 7.7, "t = {time}: errors fall with the power {slope:.1} of the step");
            slopes += 1;
        }
    }
    assert_eq!(slopes, 6, "before the first close encounter all of these steps are at the rounding");
}
