//! Each conversion against `conics.csv`, which `reference.py` computes by other formulas, with errors of some roundings times the
//! condition of the conversion.

use crate::{apart, norm};
use integrator_core::{
    orbit::{Anomaly, Elements},
    prelude::*,
};

/// Roundings of a conversion: those of a dozen operations, or of a sine of an angle, act as roundings of its numbers.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// A line of the table.
struct Conic {
    parameter: f64,
    elements: Elements,
    position: [f64; 3],
    velocity: [f64; 3],
    /// The change of position and velocity with all elements but the eccentricity.
    by_elements: [f64; 2],
    /// Their change with the eccentricity, at the same time since the pericentre.
    by_eccentricity: [f64; 2],
    /// The change of each element with the state.
    by_state: [f64; 6],
}

fn conics() -> Vec<Conic> {
    let line = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().expect("a number")).collect();
        let part = |from: usize| std::array::from_fn(|d| numbers[from + d]);
        let elements = Elements {
            inclination: numbers[3],
            node: numbers[4],
            argument: numbers[5],
            anomaly: Anomaly::Mean(numbers[6]),
            ..Elements::with_pericentre(numbers[1], numbers[2])
        };
        Conic {
            parameter: numbers[0],
            elements,
            position: part(7),
            velocity: part(10),
            by_elements: [numbers[13], numbers[14]],
            by_eccentricity: [numbers[15], numbers[16]],
            by_state: std::array::from_fn(|d| numbers[17 + d]),
        }
    };
    let conics: Vec<Conic> = include_str!("conics.csv").lines().map(line).collect();
    assert!(conics.len() > 100);
    conics
}

impl Conic {
    /// The errors of a state, in units of the allowed ones.
    fn errors(&self, [position, velocity]: [[f64; 3]; 2], changes: [f64; 2]) -> f64 {
        let of = |found, expected, change| apart(found, expected) / (ROUNDINGS * (norm(expected) + change));
        of(position, self.position, changes[0]).max(of(velocity, self.velocity, changes[1]))
    }
}

#[test]
fn states_are_those_of_the_table() {
    for (number, conic) in conics().iter().enumerate() {
        let error = conic.errors(conic.elements.state(conic.parameter).expect("a state"), conic.by_elements);
        assert!(error < 1.0, "line {}: {error} of {:?}", number + 1, conic.elements);
    }
}

/// A sign that is wrong, a unit that is missing: no tolerance hides it.
#[test]
fn wrong_elements_have_other_states() {
    let conics = conics();
    let wrong: [fn(&Elements, f64) -> Elements; 4] = [
        |right, _| Elements { inclination: std::f64::consts::PI - right.inclination, ..*right },
        |right, _| Elements { node: -right.node, ..*right },
        |right, _| Elements { argument: -right.argument, ..*right },
        |right, parameter| {
            let mean = right.mean_anomaly(parameter).expect("an anomaly");
            Elements { anomaly: Anomaly::Mean(-mean), ..*right }
        },
    ];
    for change in wrong {
        let found = conics.iter().filter(|conic| {
            let state = change(&conic.elements, conic.parameter).state(conic.parameter).expect("a state");
            conic.errors(state, conic.by_elements) > 1e3
        });
        assert!(found.count() > conics.len() / 2);
    }
}

#[test]
fn elements_of_a_state_have_that_state() {
    for (number, conic) in conics().iter().enumerate() {
        let found = Elements::from_state(conic.position, conic.velocity, conic.parameter).expect("elements");
        let changes = [0, 1].map(|half| conic.by_elements[half] + conic.by_eccentricity[half]);
        let error = conic.errors(found.state(conic.parameter).expect("a state"), changes);
        assert!(error < 1.0, "line {}: {error} of {found:?} from {:?}", number + 1, conic.elements);
    }
}

#[test]
fn elements_are_those_of_the_table() {
    let mut compared = 0;
    for (number, conic) in conics().iter().enumerate().filter(|(_, conic)| conic.by_state[0] >= 0.0) {
        let found = Elements::from_state(conic.position, conic.velocity, conic.parameter).expect("elements");
        let flat = |elements: &Elements| {
            let Elements { pericentre, eccentricity, inclination, node, argument, anomaly } = *elements;
            let Anomaly::Mean(mean) = anomaly else { panic!("a mean anomaly") };
            [pericentre, eccentricity, inclination, node, argument, mean]
        };
        for (k, (x, expected)) in flat(&found).into_iter().zip(flat(&conic.elements)).enumerate() {
            // Angles at π may have either sign.
            let turn = if k == 5 && conic.elements.eccentricity > 1.0 || k < 2 { 0.0 } else { std::f64::consts::TAU };
            let error = [0.0, turn, -turn].map(|turn| (x - expected + turn).abs()).into_iter().fold(f64::MAX, f64::min);
            // The mean motion is that of an eccentricity that is rounded.
            let rounded = if k == 5 { 1.5 * expected.abs() / (1.0 - found.eccentricity).abs() } else { 0.0 };
            let allowed = ROUNDINGS * (expected.abs() + conic.by_state[k] + rounded);
            assert!(
                error < allowed,
                "line {}, element {k}: {x}, not {expected}; {error:e}, not {allowed:e}",
                number + 1
            );
            compared += 1;
        }
    }
    assert!(compared > 200, "{compared}");
}

/// The place of the body is the same by each anomaly, as far as a rounding of that defines it.
#[test]
fn anomalies_are_places_on_the_same_orbit() {
    for (number, conic) in conics().iter().enumerate() {
        let Conic { parameter, elements, .. } = *conic;
        let time = elements.since_pericentre(parameter).expect("a time");
        let same = Elements { anomaly: Anomaly::SincePericentre(time), ..elements };
        let error = conic.errors(same.state(parameter).expect("a state"), conic.by_elements);
        assert!(error < 1.0, "line {}: {error} by the time", number + 1);
        let anomaly = elements.true_anomaly(parameter).expect("an anomaly");
        let same = Elements { anomaly: Anomaly::True(anomaly), ..elements };
        // On a ray that changes by an angle δ, the distance changes by its square times e sin(f) δ / p.
        let Ok(state) = same.state(parameter) else { continue };
        let distance = norm(conic.position);
        let latus = elements.pericentre * (1.0 + elements.eccentricity);
        let steepness = elements.eccentricity * anomaly.sin().abs() * anomaly.abs() * distance / latus;
        let [by_position, by_velocity] = conic.by_elements;
        let speed = (parameter / latus).sqrt();
        let changes = [by_position + distance * steepness, by_velocity + speed * anomaly.abs()];
        let error = conic.errors(state, changes);
        assert!(error < 1.0, "line {}: {error} by the true anomaly {anomaly}", number + 1);
        if steepness < 1e6 {
            let back =
                [same.mean_anomaly(parameter), elements.mean_anomaly(parameter)].map(|mean| mean.expect("an anomaly"));
            let error = (back[0] - back[1]).abs();
            let allowed =
                ROUNDINGS * (1.0 + steepness) * (1.0 + distance / elements.pericentre) * back[1].abs().max(1e-300);
            assert!(
                error <= allowed || (back[0] - back[1]).abs() > 6.0,
                "line {}: {back:?}, {error:e}, {allowed:e}",
                number + 1
            );
        }
    }
}

struct Kepler {
    parameter: f64,
}

#[hamiltonian(taylor)]
impl Kepler {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -self.parameter / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
    }
}

/// A motion that knows nothing of conics: all elements stay, and the time since the pericentre is that of the run.
#[test]
fn elements_are_constants_of_the_motion() -> Result<(), Box<dyn std::error::Error>> {
    for eccentricity in [0.0, 0.3, 0.9, 1.0, 1.1, 5.0] {
        let begin = Elements {
            inclination: 2.0,
            node: -1.0,
            argument: 0.5,
            anomaly: Anomaly::SincePericentre(-0.8),
            ..Elements::with_pericentre(0.7, eccentricity)
        };
        let system = Kepler { parameter: 1.3 };
        let [q, p] = begin.state(system.parameter)?;
        let mut run = system.run_with(Taylor::tolerance(1e-16), Phase::new(q, p), 1.0)?;
        run.advance_to(2.0)?;
        let Phase { q, p } = run.state();
        let end = Elements { anomaly: Anomaly::SincePericentre(1.2), ..begin };
        let [position, velocity] = end.state(system.parameter)?;
        assert!(apart(q, position) < 1e-13 && apart(p, velocity) < 1e-13, "{eccentricity}: {q:?} {position:?}");
        let found = Elements::from_state(q, p, system.parameter)?;
        let since = found.since_pericentre(system.parameter)?;
        assert!((found.pericentre - 0.7).abs() < 1e-13 && (found.inclination - 2.0).abs() < 1e-13);
        assert!(eccentricity == 0.0 || (since - 1.2).abs() < 1e-13, "{eccentricity}: {since}");
    }
    Ok(())
}

/// Angles that are undefined follow the conventions: the others contain what they leave out.
#[test]
fn undefined_angles_are_zero() {
    let circle = Elements::from_state([0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], 1.0).expect("elements");
    let half = std::f64::consts::FRAC_PI_2;
    let expected = Elements { anomaly: Anomaly::Mean(half), ..Elements::with_pericentre(1.0, 0.0) };
    assert_eq!(circle, expected);
    let flat = Elements::from_state([0.0, 1.0, 0.0], [-1.25, 0.0, 0.0], 1.0).expect("elements");
    assert_eq!([flat.inclination, flat.node, flat.argument, flat.mean_anomaly(1.0).expect("M")], [0.0, 0.0, half, 0.0]);
    let retrograde = Elements::from_state([0.0, 1.0, 0.0], [1.25, 0.0, 0.0], 1.0).expect("elements");
    assert_eq!([retrograde.inclination, retrograde.node], [std::f64::consts::PI, 0.0]);
    let tilted = Elements::from_state([0.0, 1.0, 0.0], [0.0, 0.0, 1.0], 1.0).expect("elements");
    assert_eq!(
        [tilted.inclination, tilted.node, tilted.argument, tilted.mean_anomaly(1.0).expect("M")],
        [half, half, 0.0, 0.0]
    );
}

/// Kepler's equation is solved for every eccentricity and time: the state has the energy and the angular momentum of the orbit, which
/// are products of two of its numbers, and by the radial velocity and the distance the time that was given.
#[test]
fn every_time_on_every_conic_has_a_state() {
    let mut random = fastrand::Rng::with_seed(7);
    let near: Vec<f64> = (0..=52).map(|power| 0.5_f64.powi(power)).collect();
    let eccentricities: Vec<f64> =
        near.iter().flat_map(|x| [1.0 - x, 1.0 + x, *x, 1.0 / x]).chain([1e3, 1.0]).collect();
    for e in eccentricities.into_iter().filter(|e| *e <= 1e6) {
        for _ in 0..300 {
            let time = (random.f64() * 64.0 - 32.0).exp() * if random.bool() { 1.0 } else { -1.0 };
            let orbit = Elements { anomaly: Anomaly::SincePericentre(time), ..Elements::with_pericentre(1.0, e) };
            let [q, v] = orbit.state(1.0).unwrap_or_else(|error| panic!("{e} {time}: {error}"));
            let (distance, speed) = (norm(q), norm(v));
            let (beta, latus) = (1.0 - e, 1.0 + e);
            let energy = speed * speed - 2.0 / distance + beta;
            assert!(energy.abs() < 2.0 * ROUNDINGS * (speed * speed + 2.0 / distance + e), "{e} {time}: {energy:e}");
            let momentum = q[0] * v[1] - q[1] * v[0] - latus.sqrt();
            assert!(momentum.abs() < 2.0 * ROUNDINGS * distance * speed, "{e} {time}: {momentum:e}");
            if !(0.9..1.1).contains(&e) && e > 0.1 {
                let (root, radial) = (beta.abs().sqrt(), q[0] * v[0] + q[1] * v[1]);
                let eccentric =
                    if e < 1.0 { (root * radial).atan2(1.0 - beta * distance) } else { (root * radial / e).asinh() };
                let mean = (eccentric - root * radial) * beta.signum();
                let whole = if e < 1.0 { std::f64::consts::TAU } else { f64::INFINITY };
                let expected = time * root.powi(3);
                let late = mean - expected;
                let late = if whole.is_finite() { late - whole * (late / whole).round() } else { late };
                let size = ROUNDINGS * (eccentric.abs() + (root * radial).abs() + expected.abs());
                assert!(late.abs() < 4.0 * size, "{e} {time}: {late:e}, {size:e}");
            }
        }
    }
}
