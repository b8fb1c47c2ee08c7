//! Vectors and derivatives by parameters against fifty digits, which `reference.py` finds by differences of its own steps.

use integrator_core::{Coords, Tangent, prelude::*};
use serde_json::Value;

struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// A pendulum whose point of suspension is shaken.
struct Pendulum {
    length: f64,
    drive: f64,
}

#[hamiltonian(sensitive(length, drive))]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -self.length * (1.0 + self.drive * (self.length * t).sin()) * q[0].cos()
    }
}

/// Sites between walls, with springs that harden.
struct Chain {
    hardening: f64,
}

#[hamiltonian(sensitive(hardening))]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let bond = |stretch: f64| stretch * stretch / 2.0 + self.hardening * stretch.powi(4) / 4.0;
        let mut energy = bond(q[0]) + bond(q[q.len() - 1]);
        for i in 0..q.len() - 1 {
            energy += bond(q[i + 1] - q[i]);
        }
        energy
    }
}

/// Three bodies in a plane that attract each other.
struct Bodies {
    mass: [f64; 3],
    gravity: f64,
    softening: f64,
}

#[hamiltonian(sensitive(gravity, softening))]
impl Bodies {
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (0..2).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (0..2).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>() + self.softening.powi(2);
                energy -= self.gravity * self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

/// The numbers of a list of texts.
fn numbers(texts: &Value) -> Vec<f64> {
    let number = |text: &Value| text.as_str().expect("digits").parse().expect("a number");
    texts.as_array().expect("a list").iter().map(number).collect()
}

/// A point in the shape of another one.
fn point<C: Coords<Leaf = f64>>(like: &Phase<C>, numbers: &[f64]) -> Phase<C> {
    let mut point = like.clone();
    let leaves = point.q.flat_mut().iter_mut().chain(point.p.flat_mut());
    leaves.zip(numbers).for_each(|(leaf, number)| *leaf = *number);
    point
}

/// Holds the end of a run and its derivatives against the digits.
///
/// A step rounds each number of state and vector by some ulps of the largest one, which the steps behind it carry on like any
/// other deviation: by as much as the vectors have grown, at most, and about as much the square of that for what a state
/// that is off does to a vector. A wrong term of any derivative is off in the first digits.
fn holds<C: Coords<Leaf = f64>>(name: &str, steps: u64, tangent: Result<Tangent<C>, Error>) {
    let reference: Value = serde_json::from_str(include_str!("reference.json")).expect("a map of runs");
    let reference = &reference[name];
    let mut tangent = tangent.expect("a start");
    tangent.advance(steps).expect("finite states");
    let rows = |key: &str| reference[key].as_array().expect("rows").iter().map(numbers).collect::<Vec<_>>();
    let expected = [rows("along"), rows("by")].concat();
    let growth = expected.iter().flatten().fold(1.0, |most: f64, number| most.max(number.abs()));
    let end = tangent.state();
    let apart = |found: &Phase<C>, expected: &[f64]| {
        let found = found.q.flat().iter().chain(found.p.flat());
        found.zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    let roundings = 4.0 * f64::EPSILON * (steps as f64).sqrt() * growth;
    let of_state = apart(&end, &numbers(&reference["end"]));
    assert!(of_state < roundings, "{name}: the state is off by {of_state:e}, and not {roundings:e}");
    let vectors = tangent.vectors();
    assert_eq!(vectors.len(), expected.len(), "{name}");
    for (number, (vector, expected)) in vectors.iter().zip(&expected).enumerate() {
        let of_vector = apart(vector, expected);
        let roundings = roundings * growth;
        assert!(of_vector < roundings, "{name}: derivative {number} is off by {of_vector:e}, and not {roundings:e}");
        assert!(roundings < 1e-3 * growth, "{name}: {roundings:e} would hide a wrong derivative");
    }
}

#[test]
fn derivatives_have_the_digits_of_fifty() {
    let start = Phase::new([0.0, -0.25], [0.375, 0.125]);
    let vectors = [[1.0, 0.0, 0.0, 0.0], [0.5, -0.25, 1.0, 0.75]].map(|vector| point(&start, &vector));
    holds("henon_heiles", 400, HenonHeiles.tangent(Verlet, start, vectors, 0.125));

    let start = Phase::new([2.0], [0.25]);
    let vectors = [[1.0, 0.0], [0.5, -1.0]].map(|vector| point(&start, &vector));
    let pendulum = Pendulum { length: 1.25, drive: 0.375 };
    holds("pendulum", 400, pendulum.sensitivities(Verlet, start, vectors, 0.0625));

    let start = Phase::new(vec![0.5, 0.25, -0.5, 0.125, 0.75], vec![0.25, -0.25, 0.5, -0.75, 0.125]);
    let other = [0.5, -1.0, 0.25, 1.0, 0.0, -0.5, 0.75, 0.0, 1.0, -0.25];
    let first = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let vectors = [first, other].map(|vector| point(&start, &vector));
    holds("chain", 200, Chain { hardening: 0.75 }.sensitivities(Verlet, start, vectors, 0.0625));

    let start = Phase::new([[0.0, 0.0], [1.0, 0.25], [-0.5, 1.5]], [[0.125, -0.25], [0.0, 0.5], [-0.25, 0.0]]);
    let vectors = [[&first[..], &[0.0, 0.0]].concat(), [&other[..], &[0.5, 0.125]].concat()];
    let vectors = vectors.map(|vector| point(&start, &vector));
    let bodies = Bodies { mass: [1.0, 0.5, 0.25], gravity: 1.5, softening: 0.25 };
    holds("bodies", 200, bodies.sensitivities(Verlet, start, vectors, 0.015625));
}
