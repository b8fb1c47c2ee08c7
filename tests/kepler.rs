//! Parts that are sums over Kepler orbits, moved by these: planets about a star, a satellite of a flattened planet.
//!
//! All of it holds on every instruction set. A process uses one, so [`instruction_sets`] runs these tests again in a
//! process for each of the others.

#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use integrator_core::{Aba864, Ensemble, KahanLi8, Unsolved, check::certify, prelude::*};

/// The outer planets about a star that is held where it is.
#[derive(Clone)]
struct Planets {
    gravity: f64,
    star: f64,
    masses: [f64; 5],
}

#[hamiltonian(split = kepler + interaction, compose = Aba864)]
impl Planets {
    fn kepler(&self, q: [[f64; 3]; 5], p: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            let square = p[i].iter().map(|x| x * x).sum::<f64>();
            energy += square / (2.0 * self.masses[i]) - self.gravity * self.star * self.masses[i] / Self::length(q[i]);
        }
        energy
    }
    fn interaction(&self, q: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 1..5 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.gravity * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
    fn length(q: [f64; 3]) -> f64 {
        (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
    }
}

/// The masses of the planets, and their positions and momenta relative to the sun.
fn outer_solar_system() -> (Planets, [[[f64; 3]; 5]; 2]) {
    let lines = include_str!("../examples/data/outer_solar_system.csv").lines().skip(2);
    let numbers = |line: &str| -> Vec<f64> { line.split(',').skip(1).map(|x| x.parse().expect("a number")).collect() };
    let bodies: Vec<Vec<f64>> = lines.map(numbers).collect();
    let relative = |planet: usize, column: usize| bodies[planet + 1][column] - bodies[0][column];
    let masses: [f64; 5] = std::array::from_fn(|planet| bodies[planet + 1][0]);
    let q = std::array::from_fn(|planet| std::array::from_fn(|d| relative(planet, 1 + d)));
    let p = std::array::from_fn(|planet| std::array::from_fn(|d| masses[planet] * relative(planet, 4 + d)));
    (Planets { gravity: 2.959_122_082_86e-4, star: bodies[0][0], masses }, [q, p])
}

/// A satellite in the plane of a flattened planet's equator.
#[derive(Clone)]
struct Satellite {
    mass: f64,
    strength: f64,
    flattening: f64,
}

#[hamiltonian(split = kepler + flattening, compose = Yoshida4)]
impl Satellite {
    fn kepler(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) / self.mass - self.strength * (x * x + y * y).powf(-0.5)
    }
    fn flattening(&self, q: [f64; 2]) -> f64 {
        -self.flattening / (q[0] * q[0] + q[1] * q[1]).powf(1.5)
    }
}

fn satellite(k: f64) -> Satellite {
    Satellite { mass: 1.0 + 0.1 * k, strength: 2.0, flattening: 0.01 * k }
}

fn orbit(k: f64) -> Phase<[f64; 2]> {
    Phase::new([1.0, 0.05 * k], [0.0, 1.4])
}

/// Any number of particles, some of them free, about a centre that may attract or repel.
#[derive(Clone)]
struct Swarm {
    strengths: Vec<f64>,
}

#[hamiltonian(split = walls + kepler)]
impl Swarm {
    fn walls(&self, q: &[[f64; 2]]) -> f64 {
        q.iter().map(|[x, y]| 0.01 * (x * x + y * y).powi(2)).sum()
    }
    fn kepler(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            energy += 0.5 * (p[i][0] * p[i][0] + p[i][1] * p[i][1]) - self.strengths[i] / q[i][0].hypot(q[i][1]);
        }
        energy
    }
}

fn swarm(k: f64) -> Swarm {
    Swarm { strengths: (0..11).map(|i| [1.0, 0.0, -0.5, 2.0 + 0.1 * k][i % 4]).collect() }
}

fn particles(k: f64) -> Phase<Vec<[f64; 2]>> {
    let q = (0..11).map(|i| [1.0 + 0.1 * f64::from(i), 0.02 * k - 0.3]).collect();
    let p = (0..11).map(|i| [0.1 * f64::from(i) - 0.4, 1.0]).collect();
    Phase::new(q, p)
}

/// Bodies of a list beside a first one that drifts on its own; of those that the list has no strength for, nothing is said.
struct Some {
    strengths: Vec<f64>,
}

#[hamiltonian(split = drift + kepler)]
impl Some {
    fn drift(&self, p: &[[f64; 2]]) -> f64 {
        0.5 * (p[0][0] * p[0][0] + p[0][1] * p[0][1])
    }
    fn kepler(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 {
        let bodies = q.iter().zip(p).skip(1).zip(&self.strengths);
        bodies.map(|((q, p), k)| 0.5 * (p[0] * p[0] + p[1] * p[1]) - k / q[0].hypot(q[1])).sum()
    }
}

#[test]
fn bodies_from_the_middle_of_a_list_move_as_they_do_alone() {
    let Phase { q, p } = particles(1.0);
    let some = Some { strengths: vec![1.0, 2.0, 3.0] };
    let mut run = some.run(Phase::new(q[..5].to_vec(), p[..5].to_vec()), 0.1).expect("a run");
    run.advance(20).expect("finite");
    let moved = run.state();
    for body in 1..4 {
        let alone = Satellite { mass: 1.0, strength: body as f64, flattening: 0.0 };
        let mut alone = alone.run_with(Verlet, Phase::new(q[body], p[body]), 0.1).expect("a run");
        alone.advance(20).expect("finite");
        // Its orbit is cut into other pieces, so that it is rounded elsewhere.
        let distance = (moved.q[body][0] - alone.state().q[0]).hypot(moved.p[body][1] - alone.state().p[1]);
        assert!(distance < 1e-13, "{distance}");
    }
    assert_eq!(moved.q[4], q[4], "beyond the list");
    assert!((moved.q[0][0] - q[0][0] - 2.0 * p[0][0]).abs() < 1e-14, "a drift");
}

// A test for each, so that they run side by side.
#[test]
fn planets_are_certified() {
    let (planets, [q, p]) = outer_solar_system();
    certify::<_, _, f64>(&planets, Aba864, Phase::new(q, p), 200.0).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_satellite_is_certified() {
    certify::<_, _, f64>(&satellite(1.0), Yoshida4, orbit(1.0), 0.1).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_swarm_is_certified() {
    certify::<_, _, f64>(&swarm(1.0), Verlet, particles(1.0), 0.02).unwrap_or_else(|error| panic!("{error}"));
}

/// The distance of a run of the satellite from one with a tenth of the step, after a time of 20.
fn error(flattening: f64, steps: u64) -> f64 {
    let end = |steps: u64| {
        let satellite = Satellite { flattening, ..satellite(0.0) };
        let start = Phase::compensated(orbit(0.0).q, orbit(0.0).p);
        let mut run = satellite.run(start, 20.0 / steps as f64).expect("a run");
        run.advance(steps).expect("finite");
        let Phase { q: [x, y], p: [px, py] } = run.state();
        [x, y, px, py].map(|slot| slot.value)
    };
    let (coarse, fine) = (end(steps), end(10 * steps));
    coarse.into_iter().zip(fine).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn errors_fall_with_the_step_and_with_the_perturbation() {
    let slope = (error(0.01, 80) / error(0.01, 160)).log2();
    assert!((slope - 4.0).abs() < 0.2, "{slope}");
    let of_perturbation = (error(1e-3, 200) / error(1e-4, 200)).log10();
    assert!(of_perturbation > 0.9, "{of_perturbation}");
    // Without it there is no error but rounding: 20 units of time in two hundred steps and in two thousand, each of
    // which rounds a few times and carries that along an orbit of a dozen radians.
    assert!(error(0.0, 200) < 1e-12, "{}", error(0.0, 200));
}

/// Members of an ensemble beside each one alone.
macro_rules! assert_members_are_alone {
    ($system:expr, $start:expr, $h:expr) => {{
        let members: Vec<_> = (0..11).map(|k| ($system(k as f64), $start(k as f64))).collect();
        let mut all = Ensemble::new(KahanLi8, members.clone(), $h).expect("an ensemble");
        all.advance(40).expect("finite");
        for ((system, start), together) in members.into_iter().zip(all.states()) {
            let mut alone = system.run_with(KahanLi8, start, $h).expect("a run");
            alone.advance(40).expect("finite");
            assert_eq!(alone.state(), together);
        }
    }};
}

#[test]
fn a_member_has_the_bits_of_its_run_alone() {
    let (planets, [q, p]) = outer_solar_system();
    let heavier = |k: f64| Planets { star: planets.star + 0.1 * k, ..planets.clone() };
    assert_members_are_alone!(heavier, |_| Phase::new(q, p), 300.0);
    assert_members_are_alone!(heavier, |_| Phase::compensated(q, p), -2000.0);
    assert_members_are_alone!(satellite, orbit, 0.3);
    assert_members_are_alone!(swarm, particles, 0.05);
}

#[test]
fn an_orbit_without_a_solution_is_reported_and_the_last_state_is_kept() {
    // 1e150 revolutions in a step: no digit is left of the time.
    let start = Phase::new([1e-100, 0.0], [0.0, 1e50]);
    let mut run = satellite(0.0).run_with(Verlet, start, 1.0).expect("a run");
    let fault = run.advance(3).expect_err("no orbit");
    assert!(matches!(fault, Error::NotSolved { reason: Unsolved::Kepler { body: 0, .. }, step: 1, .. }), "{fault}");
    assert_eq!(run.state(), start);
}
