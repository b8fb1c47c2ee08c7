//! What a system says is conserved: `#[invariant]` in runs, samples, ensembles and certificates, whatever the layout.

use integrator_core::check::{CertifyError, Shortfall};
use integrator_core::prelude::*;

struct Kepler {
    mass: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Kepler {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.mass / q[0].hypot(q[1])
    }
    #[invariant]
    fn angular_momentum(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
    /// The first component of the vector of Laplace, Runge and Lenz.
    #[invariant]
    fn perihelion(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        p[1] * self.angular_momentum(q, p) / self.mass.powi(2) - q[0] / q[0].hypot(q[1])
    }
}

const START: Phase<[f64; 2]> = Phase { q: [0.5, 0.0], p: [0.0, 3.4] };

/// Bodies in rows, where the layout of a motion is not that of the user.
struct Bodies {
    mass: [f64; 3],
}

#[hamiltonian]
impl Bodies {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                sum -= self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        sum
    }
    #[invariant]
    fn momentum(&self, _q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| p[i][0]).sum()
    }
    #[invariant]
    fn angular_momentum(&self, q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| q[i][0] * p[i][1] - q[i][1] * p[i][0]).sum()
    }
}

/// The same in Jacobi coordinates.
struct Planets {
    mass: [f64; 3],
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction)]
impl Planets {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                sum -= self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        sum
    }
    #[invariant]
    fn angular_momentum(&self, q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| q[i][0] * p[i][1] - q[i][1] * p[i][0]).sum()
    }
}

const MASSES: [f64; 3] = [1.0, 1e-3, 3e-4];
const PLANETS: Phase<[[f64; 2]; 3]> =
    Phase { q: [[0.0, 0.0], [1.0, 0.0], [0.0, 2.5]], p: [[0.0, -1e-3], [0.0, 1e-3], [-1.9e-4, 0.0]] };

fn angular_momentum(Phase { q, p }: Phase<[[f64; 2]; 3]>) -> f64 {
    (0..3).map(|i| q[i][0] * p[i][1] - q[i][1] * p[i][0]).sum()
}

#[test]
fn a_run_returns_the_invariants_of_its_system() {
    let mut run = Kepler { mass: 2.0 }.run(START, 0.01).expect("an admissible start");
    let before = ["angular_momentum", "perihelion"].map(|name| run.invariant(name).expect("declared"));
    assert_eq!(before, [0.5 * 3.4, 3.4 * 1.7 / 4.0 - 1.0]);
    run.advance(1_000).expect("finite");
    // Each flow of a central force turns nothing: two roundings of each of 6 flows of each step, at random.
    let after = run.invariant("angular_momentum").expect("declared");
    assert!((after - before[0]).abs() < 64.0 * f64::EPSILON * 6000.0_f64.sqrt(), "{after}");
    // A step of fourth order turns the ellipse all the same.
    let turned = (run.invariant("perihelion").expect("declared") - before[1]).abs();
    assert!(turned > 1e-9 && turned < 1e-2, "{turned}");
    let unknown = run.invariant("spin").expect_err("not declared").to_string();
    assert_eq!(unknown, "the system has no invariant `spin`\nnote: its invariants are angular_momentum, perihelion");
}

#[test]
fn samples_and_members_return_them_too() {
    let systems = [1.0, 2.0, 3.0].map(|mass| (Kepler { mass }, START));
    let mut swarm = Ensemble::new(Yoshida4, systems, 0.01).expect("admissible starts");
    swarm.advance(40).expect("finite");
    for (member, mass) in (0..).zip([1.0, 2.0, 3.0]) {
        let mut samples = Kepler { mass }.run(START, 0.01).expect("an admissible start").samples(40);
        let sample = samples.nth(1).expect("endless").expect("finite");
        let value = sample.invariant("perihelion").expect("declared");
        assert_eq!(swarm.invariant(member, "perihelion"), Ok(Some(value)));
        assert_eq!(sample.invariants().map(|(name, _)| name).collect::<Vec<_>>(), ["angular_momentum", "perihelion"]);
    }
    assert_eq!(swarm.invariant(3, "perihelion"), Ok(None));
    assert!(matches!(swarm.invariant(0, "spin"), Err(Error::NoInvariant { .. })));
}

#[test]
fn invariants_are_those_of_the_users_coordinates() {
    let bodies = Bodies { mass: MASSES };
    let mut rows = bodies.run(PLANETS, 0.01).expect("an admissible start");
    let mut jacobi = Planets { mass: MASSES }.run(PLANETS, 0.01).expect("an admissible start");
    rows.advance(100).expect("finite");
    jacobi.advance(100).expect("finite");
    let value = rows.invariant("angular_momentum").expect("declared");
    assert_eq!(value, angular_momentum(rows.state()));
    let value = jacobi.invariant("angular_momentum").expect("declared");
    // Through Jacobi coordinates and back: some roundings of sums over three bodies.
    assert!((value - angular_momentum(jacobi.state())).abs() < 64.0 * f64::EPSILON * 1e-3, "{value}");
}

#[test]
fn certificates_check_invariants_against_their_hamiltonian() {
    let certificate = certify(&Kepler { mass: 2.0 }, Yoshida4, START, 0.01).expect("both are conserved");
    let [angular_momentum, perihelion] = &certificate.invariants[..] else { panic!("{certificate}") };
    assert!(angular_momentum.deviation < angular_momentum.rounding, "{certificate}");
    assert!(perihelion.deviation > 1e3 * perihelion.rounding, "{certificate}");
    assert!(certificate.to_string().contains("invariant          angular_momentum: bracket with H"));
    let certificate = certify(&Bodies { mass: MASSES }, Verlet, PLANETS, 0.01).expect("both are conserved");
    assert!(certificate.invariants.iter().all(|drift| drift.is_conserved() && drift.deviation < drift.rounding));
}

/// A bar, which turns what moves in it.
struct Bar {
    flattening: f64,
}

#[hamiltonian]
impl Bar {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        0.5 * (1.0 + q[0] * q[0] + q[1] * q[1] / self.flattening.powi(2)).ln()
    }
    #[invariant]
    fn angular_momentum(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        q[0] * p[1] - q[1] * p[0]
    }
}

#[test]
fn a_function_that_is_not_conserved_is_refused() {
    let start = Phase::new([0.7, 0.2], [0.1, 0.6]);
    certify(&Bar { flattening: 1.0 }, Verlet, start, 0.01).expect("a round one turns nothing");
    let refused = certify(&Bar { flattening: 0.9 }, Verlet, start, 0.01).expect_err("a flat one does");
    let CertifyError::Refused { shortfalls, .. } = &refused else { panic!("{refused}") };
    let [Shortfall::NotInvariant(drift)] = &shortfalls[..] else { panic!("{refused}") };
    assert!(drift.name == "angular_momentum" && drift.bracket > 1e-2, "{refused}");
    assert!(
        refused.to_string().contains("`angular_momentum` is not conserved: its Poisson bracket with H is"),
        "{refused}"
    );
}
