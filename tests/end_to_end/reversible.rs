//! Reversible states: there and back again, to the very bits.

use crate::systems::{HenonHeiles, henon_heiles, pendulum};
use integrator_core::{Visitor, prelude::*};

/// 2^-44, so that coordinates may reach 128.
const GRID: f64 = 1.0 / (1_u64 << 44) as f64;

/// Goes `steps` steps there and as many back; where it turned, and where it ended.
fn there_and_back<H: Hamiltonian<Coords = [f64; N]>, X: Composition<H>, const N: usize>(
    system: &H,
    start: Phase<[Fixed<f64>; N]>,
    h: f64,
    steps: u64,
) -> Result<[Phase<[Fixed<f64>; N]>; 2], Error> {
    let mut there = system.run_with::<Fixed<f64>, X>(X::default(), start, h)?;
    there.advance(steps)?;
    let turnaround = there.state();
    let mut back = system.run_with::<Fixed<f64>, X>(X::default(), turnaround, -h)?;
    back.advance(steps)?;
    Ok([turnaround, back.state()])
}

#[test]
fn ten_million_steps_and_back() {
    let problem = pendulum();
    let start = Phase::reversible(problem.start.0, problem.start.1, GRID);
    let [turnaround, end] = there_and_back::<_, Verlet, 1>(&problem.system, start, 0.01, 10_000_000).expect("in range");
    assert_eq!(end, start);
    assert_ne!(turnaround, start);
}

/// Every symmetric composition returns; every other one is refused.
struct Returns {
    symmetric: usize,
    refused: usize,
}

impl Visitor<HenonHeiles> for Returns {
    fn visit<X: Composition<HenonHeiles>>(&mut self, _: X) {
        let (q, p) = henon_heiles().start;
        let start = Phase::reversible(q, p, GRID);
        match there_and_back::<HenonHeiles, X, 2>(&HenonHeiles, start, 0.1, 5_000) {
            Ok([turnaround, end]) => {
                assert!(X::SYMMETRIC, "{} is not symmetric", X::NAME);
                assert_eq!(end, start, "{}", X::NAME);
                assert_ne!(turnaround, start, "{}", X::NAME);
                self.symmetric += 1;
            }
            Err(error) => {
                assert_eq!(error, Error::NotSymmetric { composition: X::NAME });
                assert!(!X::SYMMETRIC, "{} is symmetric", X::NAME);
                self.refused += 1;
            }
        }
    }
}

#[test]
fn all_symmetric_compositions_return_and_the_others_are_refused() {
    let mut returns = Returns { symmetric: 0, refused: 0 };
    HenonHeiles::visit_compositions(&mut returns);
    assert!(returns.symmetric > 20 && returns.refused > 5, "{} and {}", returns.symmetric, returns.refused);
}

#[test]
fn a_floating_point_state_does_not_return() {
    let problem = pendulum();
    let start = Phase::new(problem.start.0, problem.start.1);
    let mut there = problem.system.run(start, 0.01).expect("an admissible start");
    there.advance(1000).expect("finite");
    let mut back = problem.system.run(there.state(), -0.01).expect("an admissible start");
    back.advance(1000).expect("finite");
    assert_ne!(back.state(), start, "or these tests would show nothing");
}

#[test]
fn the_grid_costs_no_more_than_its_spacing() {
    let problem = pendulum();
    let (q, p) = problem.start;
    let mut fixed = problem.system.run(Phase::reversible(q, p, GRID), 0.01).expect("an admissible start");
    let mut plain = problem.system.run(Phase::new(q, p), 0.01).expect("an admissible start");
    fixed.advance(1000).expect("in range");
    plain.advance(1000).expect("finite");
    let distance = (fixed.state().q[0].value() - plain.state().q[0]).abs();
    // Seven updates a step are rounded by half a spacing each; the pendulum shears errors by at most its time, 10.
    assert!(distance < 1000.0 * 7.0 * 10.0 * GRID, "{distance:e}");
    assert!(distance > 0.0, "the grid is there");
}

#[test]
fn members_of_an_ensemble_are_their_lone_runs() {
    let problem = pendulum();
    let start = |member: usize| Phase::reversible([0.1 * (member + 1) as f64], [0.0], GRID);
    let mut swarm =
        Ensemble::new(Yoshida4, (0..19).map(|member| (pendulum().system, start(member))), 0.01).expect("members");
    swarm.advance(3_000).expect("in range");
    for member in 0..19 {
        let mut alone = problem.system.run_with(Yoshida4, start(member), 0.01).expect("an admissible start");
        alone.advance(3_000).expect("in range");
        assert_eq!(swarm.state(member), Some(alone.state()), "member {member}");
    }
}

/// A particle that falls for ever.
struct Falling;

#[hamiltonian]
impl Falling {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0]
    }
}

#[test]
fn a_run_stops_within_the_range_of_its_grid() {
    // The range is 2^51 · 2^-44 = 128, and t²/2 = 128 at t = 16.
    let mut run = Falling.run(Phase::reversible([0.0], [0.0], GRID), 0.125).expect("an admissible start");
    let error = run.advance(1_000).expect_err("it falls out of the range");
    let Error::Diverged(divergence) = error.clone() else { panic!("{error}") };
    assert_eq!((divergence.step, divergence.time, divergence.limit), (128, 16.0, 128.0));
    assert_eq!((run.steps(), run.state().q[0].value()), (127, 126.0078125));
    assert_eq!(
        error.to_string(),
        "the state after step 128 (t = 16) has a coordinate outside of ±128, the range of its grid, first in q[0]\nhelp: use a \
         coarser grid, or check the forces near the last state within it\nnote: the run stays at this state, q = \
         [126.0078125], p = [15.875]"
    );
}

#[test]
fn grids_that_are_none() {
    let refused = |q: f64, p: f64, grid: f64| {
        HenonHeiles.run(Phase::reversible([0.0, q], [p, 0.0], grid), 0.1).expect_err("this cannot run").to_string()
    };
    for (grid, text) in [(0.001, "0.001"), (0.0, "0"), (-0.5, "-0.5"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let expected = format!(
            "the grid spacing of q[0] is {text}, which is not a power of two\nhelp: write, for example, `1.0 / (1_u64 << 40) as f64`"
        );
        assert_eq!(refused(0.1, 0.1, grid), expected);
    }
    assert_eq!(
        refused(0.1, -128.0, GRID),
        format!(
            "p[0] is -128, outside of ±128, the range of a grid with the spacing {GRID:e}\nhelp: choose a coarser grid, or units \
             in which the coordinates are smaller"
        )
    );
    let start = Phase::reversible([0.0, 0.1], [0.0, 0.0], GRID);
    let error = HenonHeiles.run_with(Euler, start, 0.1).expect_err("not symmetric");
    assert_eq!(
        error.to_string(),
        "Euler is not symmetric, so steps by -h do not undo its steps\nhelp: use a symmetric composition, such as \
         `Verlet` or `Yoshida4`, or write `Phase::new`\nnote: a reversible initial state requires a symmetric composition"
    );
}

#[test]
fn a_run_on_a_grid_is_certified() {
    let problem = pendulum();
    let start = Phase::reversible(problem.start.0, problem.start.1, GRID);
    let certificate = certify(&problem.system, Yoshida4, start, 0.01).expect("it is right");
    assert_eq!(certificate.reversibility.to_bits(), 0, "the very bits");
}

/// Momenta turned around lead back, in steps of the same sign.
#[test]
fn turned_around_a_run_returns_to_its_start() {
    fn turned<K: std::ops::Neg<Output = K>>(state: Phase<[K; 2]>) -> Phase<[K; 2]> {
        Phase { q: state.q, p: state.p.map(|p| -p) }
    }
    let (q, p) = henon_heiles().start;
    let start = Phase::reversible(q, p, GRID);
    let mut there = HenonHeiles.run(start, 0.1).expect("a start");
    there.advance(1_000).expect("in range");
    let mut back = HenonHeiles.run(turned(there.state()), 0.1).expect("a start");
    back.advance(1_000).expect("in range");
    assert_eq!(turned(back.state()), start);
    let mut carried = HenonHeiles.run(turned(Phase::compensated(q, p)), 0.1).expect("a start");
    carried.advance(10).expect("finite");
    // A kick by hand is rounded to the grid and undone to the bit, as those of steps are.
    let (mut kicked, kick) = (start, 0.1_f64);
    kicked.p[0] += kick;
    assert!((f64::from(kicked.p[0]) - (p[0] + kick)).abs() <= GRID);
    kicked.p[0] -= kick;
    assert_eq!(kicked, start);
}
