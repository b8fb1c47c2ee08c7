//! Systems of bodies: heliocentric and Jacobi elements, by sums that are written here once more, and published planets.

use crate::{apart, in_degrees, norm};
use integrator_core::{
    orbit::{self, Anomaly, Elements, Frame, OrbitError},
    prelude::*,
};

const GRAVITY: f64 = 2.959_122_082_86e-4;

/// The Sun and the outer planets on 5 September 1994, in the axes of the ecliptic.
fn planets() -> ([f64; 6], Phase<[[f64; 3]; 6]>) {
    let lines = include_str!("../../examples/data/outer_solar_system.csv").lines().skip(2);
    let mut masses = [0.0; 6];
    let mut state = Phase::new([[0.0; 3]; 6], [[0.0; 3]; 6]);
    let (sine, cosine) = 23.439_291_1_f64.to_radians().sin_cos();
    let turned = |x: f64, y: f64, z: f64| [x, cosine * y + sine * z, cosine * z - sine * y];
    for (i, line) in lines.enumerate() {
        let numbers: Vec<f64> = line.split(',').skip(1).map(|x| x.parse().expect("a number")).collect();
        masses[i] = numbers[0];
        state.q[i] = turned(numbers[1], numbers[2], numbers[3]);
        state.p[i] = turned(numbers[4], numbers[5], numbers[6]).map(|v| masses[i] * v);
    }
    (masses, state)
}

/// Mean elements of 1800 to 2050 by Standish (JPL, Keplerian Elements for Approximate Positions of the Major Planets): semi-major
/// axis, eccentricity, inclination, node. Osculating elements oscillate about them, heliocentric ones by the motion of the Sun:
/// its speed of 12 m/s is 1/400 of that of Neptune.
#[test]
fn planets_have_their_published_orbits() -> Result<(), OrbitError> {
    let published = [
        [5.202_887, 0.048_386, 1.304_397, 100.473_909],
        [9.536_676, 0.053_862, 2.485_992, 113.662_424],
        [19.189_165, 0.047_257, 0.772_638, 74.016_925],
        [30.069_923, 0.008_590, 1.770_043, 131.784_226],
        [39.482_117, 0.248_827, 17.140_012, 110.303_936],
    ];
    let (masses, state) = planets();
    for (frame, part) in [(Frame::Heliocentric, 0.015), (Frame::Jacobi, 0.006)] {
        let found = orbit::elements(frame, GRAVITY, &masses, &state)?;
        for (orbit, [axis, eccentricity, inclination, node]) in found.iter().zip(published) {
            assert!((orbit.axis() / axis - 1.0).abs() < part, "{frame:?} {axis}: {orbit:?}");
            assert!((orbit.eccentricity - eccentricity).abs() < part, "{frame:?} {axis}: {orbit:?}");
            assert!((orbit.inclination.to_degrees() - inclination).abs() < 0.05, "{axis}: {orbit:?}");
            assert!((orbit.node.to_degrees() - node).abs() < 1.0, "{axis}: {orbit:?}");
        }
    }
    Ok(())
}

#[test]
fn states_of_elements_are_the_states_again() -> Result<(), OrbitError> {
    let (masses, given) = planets();
    let sums = |state: &Phase<[[f64; 3]; 6]>| -> [[f64; 3]; 2] {
        [
            std::array::from_fn(|d| (0..6).map(|i| masses[i] * state.q[i][d]).sum::<f64>()),
            std::array::from_fn(|d| (0..6).map(|i| state.p[i][d]).sum::<f64>()),
        ]
    };
    let whole: f64 = masses.iter().sum();
    let [centre, momentum] = sums(&given);
    for frame in [Frame::Heliocentric, Frame::Jacobi] {
        let found = orbit::elements(frame, GRAVITY, &masses, &given)?;
        let again: Phase<[[f64; 3]; 6]> = orbit::state(frame, GRAVITY, &masses, &found)?;
        // A rounding of an eccentricity of 0.01 or more turns the orbit; those of angles up to π move the planet by some
        // roundings of its distance. The innermost planets stand for all, hence the largest distance.
        let tolerance = 64.0 * f64::EPSILON;
        for (i, mass) in masses.iter().enumerate() {
            let expected = std::array::from_fn(|d| given.q[i][d] - centre[d] / whole);
            assert!(apart(again.q[i], expected) < tolerance * 40.0, "{frame:?} {i}: {again:?}");
            let expected: [f64; 3] = std::array::from_fn(|d| given.p[i][d] / mass - momentum[d] / whole);
            let velocity = again.p[i].map(|p| p / mass);
            assert!(apart(velocity, expected) < tolerance * 7e-3, "{frame:?} {i}: {again:?}");
        }
        let [centre, momentum] = sums(&again);
        // The largest addends are those of Jupiter.
        assert!(norm(centre) < 4.0 * f64::EPSILON * 5e-3, "{frame:?}: {centre:?}");
        assert!(norm(momentum) < 4.0 * f64::EPSILON * 7e-6, "{frame:?}: {momentum:?}");
        let listed: Phase<Vec<[f64; 3]>> = orbit::state(frame, GRAVITY, &masses, &found)?;
        assert_eq!((&listed.q[..], &listed.p[..]), (&again.q[..], &again.p[..]));
        assert_eq!(
            orbit::elements(frame, GRAVITY, &masses, &listed)?,
            orbit::elements(frame, GRAVITY, &masses, &again)?
        );
    }
    Ok(())
}

/// Each body is where its elements say, relative to the centre that the frame says.
#[test]
fn bodies_are_relative_to_their_centres() -> Result<(), OrbitError> {
    let masses = [2.0, 0.5, 0.25, 1.0];
    let orbits = [
        in_degrees(Elements::with_axis(1.0, 0.2), [10.0, 20.0, 30.0]),
        in_degrees(Elements { anomaly: Anomaly::Mean(2.0), ..Elements::with_axis(4.0, 0.5) }, [70.0, -20.0, 80.0]),
        in_degrees(Elements { anomaly: Anomaly::True(-1.0), ..Elements::with_axis(-9.0, 1.5) }, [140.0, 5.0, 1.0]),
    ];
    let state: Phase<[[f64; 3]; 4]> = orbit::state(Frame::Jacobi, 1.5, &masses, &orbits)?;
    let star: Phase<[[f64; 3]; 4]> = orbit::state(Frame::Heliocentric, 1.5, &masses, &orbits)?;
    for (body, orbit) in orbits.iter().enumerate().map(|(index, orbit)| (index + 1, orbit)) {
        let inner: f64 = masses[..body].iter().sum();
        let centre: [f64; 3] =
            std::array::from_fn(|d| (0..body).map(|i| masses[i] * state.q[i][d]).sum::<f64>() / inner);
        let drift: [f64; 3] = std::array::from_fn(|d| (0..body).map(|i| state.p[i][d]).sum::<f64>() / inner);
        let [position, velocity] = orbit.state(1.5 * (inner + masses[body]))?;
        let found = std::array::from_fn(|d| state.q[body][d] - centre[d]);
        assert!(apart(found, position) < 1e-14, "{body}: {found:?} {position:?}");
        let found = std::array::from_fn(|d| state.p[body][d] / masses[body] - drift[d]);
        assert!(apart(found, velocity) < 1e-14, "{body}: {found:?} {velocity:?}");

        let [position, velocity] = orbit.state(1.5 * (masses[0] + masses[body]))?;
        let found = std::array::from_fn(|d| star.q[body][d] - star.q[0][d]);
        assert!(apart(found, position) < 1e-14, "{body}: {found:?} {position:?}");
        let found = std::array::from_fn(|d| star.p[body][d] / masses[body] - star.p[0][d] / masses[0]);
        assert!(apart(found, velocity) < 1e-14, "{body}: {found:?} {velocity:?}");
    }
    // With other bodies inside, both are different orbits.
    assert!(apart(state.q[3], star.q[3]) > 0.1);
    Ok(())
}

#[test]
fn orbits_in_a_plane_have_two_components() -> Result<(), OrbitError> {
    let masses = [1.0, 0.1];
    let orbit = Elements { argument: 1.0, anomaly: Anomaly::Mean(0.5), ..Elements::with_axis(2.0, 0.3) };
    for inclination in [0.0, std::f64::consts::PI] {
        let orbit = Elements { inclination, ..orbit };
        let flat: Phase<[[f64; 2]; 2]> = orbit::state(Frame::Jacobi, 1.0, &masses, &[orbit])?;
        let deep: Phase<[[f64; 3]; 2]> = orbit::state(Frame::Jacobi, 1.0, &masses, &[orbit])?;
        assert_eq!(flat.q.map(|[x, y]| [x, y]), deep.q.map(|[x, y, _]| [x, y]));
        let [found] = orbit::elements(Frame::Heliocentric, 1.0, &masses, &flat)?.try_into().expect("one orbit");
        assert!((found.axis() - 2.0).abs() < 1e-14 && found.inclination == inclination, "{found:?}");
        assert!((found.argument - 1.0).abs() < 1e-14, "{found:?}");
    }
    Ok(())
}

struct TwoBodies {
    masses: [f64; 2],
}

#[hamiltonian(taylor)]
impl TwoBodies {
    fn kinetic(&self, p: [[f64; 3]; 2]) -> f64 {
        (0..2).map(|i| (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i])).sum()
    }
    fn potential(&self, q: [[f64; 3]; 2]) -> f64 {
        let [x, y, z] = [q[1][0] - q[0][0], q[1][1] - q[0][1], q[1][2] - q[0][2]];
        -GRAVITY * self.masses[0] * self.masses[1] / (x * x + y * y + z * z).sqrt()
    }
}

/// Two bodies are back after the period of the sum of their masses, and nowhere near by that of the heavier one alone.
#[test]
fn two_bodies_return_after_a_period() -> Result<(), Box<dyn std::error::Error>> {
    let masses = [1.0, 0.3];
    let orbit =
        in_degrees(Elements { anomaly: Anomaly::Mean(1.0), ..Elements::with_axis(1.0, 0.4) }, [50.0, 60.0, 70.0]);
    for frame in [Frame::Heliocentric, Frame::Jacobi] {
        let start: Phase<[[f64; 3]; 2]> = orbit::state(frame, GRAVITY, &masses, &[orbit])?;
        let mut run = TwoBodies { masses }.run_with(Taylor::tolerance(1e-16), start, 10.0)?;
        run.advance_to(orbit.period(GRAVITY * masses[0]))?;
        assert!(apart(run.state().q[1], start.q[1]) > 0.1);
        let mut run = TwoBodies { masses }.run_with(Taylor::tolerance(1e-16), start, 10.0)?;
        run.advance_to(orbit.period(GRAVITY * 1.3))?;
        assert!(apart(run.state().q[1], start.q[1]) < 1e-13, "{:?}", run.state());
    }
    Ok(())
}
