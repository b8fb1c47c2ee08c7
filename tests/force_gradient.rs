//! Kicks along the gradient of the squared force, on systems with loops, masses, branches and an explicit time.

use integrator_core::{Coords, QuadraticKinetic, check::symplectic_defect, prelude::*};

/// Three attracting bodies in the plane, none light.
struct Bodies {
    masses: [f64; 3],
    softening: f64,
}

#[hamiltonian]
impl Bodies {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            sum += (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.masses[i]);
        }
        sum
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                sum -= self.masses[i] * self.masses[j] / (x * x + y * y + self.softening).sqrt();
            }
        }
        sum
    }
}

/// A particle between smooth walls, which it meets.
struct Walled {
    stiffness: f64,
}

#[hamiltonian]
impl Walled {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let inside = q[0] * q[0] / 2.0 + q[0].powi(3) / 9.0;
        if q[0] > 0.2 { inside + self.stiffness * (q[0] - 0.2).powi(9) } else { inside }
    }
}

/// A pendulum whose pivot is shaken, beside one that is coupled to it through the momenta.
struct Shaken {
    mass: f64,
}

#[hamiltonian]
impl Shaken {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[0] * p[1] + p[1] * p[1]) / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        -(1.0 + 0.5 * t.sin()) * q[0].cos() - q[1].cos() * (2.0 * t).cos()
    }
}

fn end<H: Hamiltonian<Coords = C>, C: Coords<Leaf = f64, With<f64> = C>, X: Composition<H>>(
    system: &H,
    composition: X,
    start: &Phase<C>,
    steps: u64,
) -> Vec<f64> {
    let start = Phase::compensated(start.q.clone(), start.p.clone());
    let run = system.run_with::<Compensated<f64>, X>(composition, start, 2.0 / steps as f64);
    let mut run = run.expect("a start");
    run.advance(steps).expect("finite states");
    let Phase { q, p } = run.state();
    q.flat().iter().chain(p.flat()).map(|leaf| leaf.value).collect()
}

/// The order between 40 and 80 steps, against a method without gradients.
fn check<H, C, X>(system: &H, composition: X, start: &Phase<C>)
where
    H: QuadraticKinetic + Hamiltonian<Coords = C>,
    C: Coords<Leaf = f64, With<f64> = C>,
    X: Composition<H>,
    SofroniouSpaletta10: Composition<H>,
{
    let exact = end(system, SofroniouSpaletta10, start, 200);
    let error = |steps| {
        let found = end(system, composition, start, steps);
        found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let order = (error(40) / error(80)).log2();
    // Where its leading term is small, an error falls faster for a while.
    assert!(order > f64::from(X::ORDER) - 0.1, "{}: {order}", X::NAME);
    let defect = symplectic_defect::<H, X, f64>(system, composition, start.clone(), 0.1).expect("a tangent map");
    assert!(defect < 1e-13, "{}: {defect:e}", X::NAME);
}

macro_rules! check_all {
    ($system:expr, $start:expr) => {
        check(&$system, Chin4A, &$start);
        check(&$system, Chin4B, &$start);
        check(&$system, Chin4C, &$start);
        check(&$system, Chin4D, &$start);
        check(&$system, Schaefers4, &$start);
        check(&$system, Schaefers6, &$start);
        check(&$system, TakahashiImada4, &$start);
        check(&$system, BlanesCasasRos6, &$start);
    };
}

#[test]
fn loops_over_pairs_and_masses() {
    let bodies = Bodies { masses: [1.0, 0.6, 0.3], softening: 0.1 };
    let start = Phase::new([[0.0, 0.1], [1.0, 0.0], [-0.7, 0.9]], [[0.0, -0.2], [0.1, 0.4], [-0.1, -0.2]]);
    check_all!(bodies, start);
}

#[test]
fn branches() {
    check_all!(Walled { stiffness: 2.0 }, Phase::new([0.7], [0.4]));
}

#[test]
fn an_explicit_time_and_masses_that_are_not_diagonal() {
    check_all!(Shaken { mass: 0.7 }, Phase::new([0.8, -0.5], [0.3, 0.6]));
}
