//! Runs of Hamiltonians that are not `T(p) + V(q)`: against closed forms, other splittings and other methods.

use crate::{
    motions::apart,
    runs::{FINE, PER_TIME},
    splits::{double_pendulum, geodesic, heliocentric, jacobi, kepler_and_interaction, rotating_frame},
};
use integrator_core::{
    Coords,
    check::{CertifyError, Shortfall, certify, global_error, observed_order},
    prelude::*,
    taylor::{Recurrences, Taylor},
};

/// What rows of splits do not read, or read as masses.
macro_rules! system {
    ($of:ident) => {
        $of::System { masses: [4.0, 1.0, 0.5, 0.25] }
    };
}

pub(crate) const HUNG: Phase<[f64; 2]> = Phase { q: [1.0, -0.5], p: [0.2, 0.3] };

fn end<H: Hamiltonian + Recurrences>(system: &H, start: &Phase<H::Coords>, h: f64, steps: u64) -> Vec<f64>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut run = system.run_with::<f64, _>(Taylor::tolerance(FINE), start.clone(), h).expect("a start");
    run.advance(steps).expect("finite states");
    let state: Phase<H::Coords> = run.state();
    [state.q.flat(), state.p.flat()].concat()
}

#[test]
fn a_circle_about_a_black_hole_stays_one() {
    let (r, span) = (10.0_f64, 1000.0);
    let momenta = [-(1.0 - 2.0 / r) / (1.0 - 3.0 / r).sqrt(), 0.0, (r * r / (r - 3.0)).sqrt()];
    let start = Phase::compensated([0.0, r, 0.0], momenta);
    let mut run = system!(geodesic).run_with(Taylor::tolerance(FINE), start, span / 100.0).expect("a start");
    run.advance(100).expect("finite states");
    let [time, at, angle] = run.state().q.map(|leaf| leaf.value);
    // dt/dτ = 1/√(1 - 3/r), and dφ/dt = r^(-3/2), as Kepler's. Each unit of time rounds coordinates of size r, and what
    // that changes of the radius turns the angle ever more.
    let unit = PER_TIME * r;
    assert!((at - r).abs() < unit * span, "{at}");
    assert!((time - span / (1.0 - 3.0 / r).sqrt()).abs() < unit * span, "{time}");
    assert!((angle - time * r.powf(-1.5)).abs() < unit * span, "{angle}");
}

/// The same H as T + V.
struct Separate {
    masses: [f64; 4],
}

#[hamiltonian(taylor)]
impl Separate {
    fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 {
        (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.masses[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 4]) -> f64 {
        let mut sum = 0.0;
        for i in 0..4 {
            for j in 0..i {
                sum -= self.masses[i] * self.masses[j]
                    / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
            }
        }
        sum
    }
}

struct Disturbed;

#[hamiltonian(taylor)]
impl Disturbed {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0] * q[0] * q[1] * q[1] / 8.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

#[test]
fn the_result_does_not_depend_on_the_split() {
    let start = Phase::new([1.0, 0.25], [-0.25, 0.75]);
    let [one, other] = [end(&system!(kepler_and_interaction), &start, 0.25, 40), end(&Disturbed, &start, 0.25, 40)];
    // Two motions, each off by what a closed form would show, and stretched a few times at each of two pericentres.
    assert!(apart(&one, &other) < 2.0 * 16.0 * PER_TIME * 10.0, "{one:?}, {other:?}");
    assert!(apart(&one, &[1.0, 0.25, -0.25, 0.75]) > 0.1, "a motion that does not stand still");

    let start = Phase::new(
        [[0.0, 0.0], [3.0, 0.0], [0.0, 6.0], [-9.0, 0.0]],
        [[0.0, 0.0], [0.0, 1.0], [-0.375, 0.0], [0.0, -0.125]],
    );
    let [one, other] =
        [end(&system!(jacobi), &start, 0.25, 40), end(&Separate { masses: [4.0, 1.0, 0.5, 0.25] }, &start, 0.25, 40)];
    assert!(apart(&one, &other) < 2.0 * 16.0 * PER_TIME * 10.0, "{one:?}, {other:?}");
}

/// What a motion conserves, whatever it splits into.
#[test]
fn energies_walk_and_do_not_drift() {
    macro_rules! conserved {
        ($($of:ident, $start:expr;)*) => {$(
            let mut run = system!($of).run_with(Taylor::tolerance(FINE), $start, 0.5).expect("a start");
            let energy = run.energy();
            run.advance(200).expect("finite states");
            // A few steps per unit of time, each of which rounds every coordinate.
            let error = (run.energy() - energy).abs() / energy.abs().max(1.0);
            assert!(error < 4.0 * PER_TIME * 100.0, "{error:e}: {}", stringify!($of));
        )*};
    }
    conserved! {
        double_pendulum, HUNG;
        rotating_frame, Phase::new([0.4875, 0.866], [-0.866, 0.4875]);
        heliocentric, Phase::new([[1.0, 0.0], [0.0, 8.0], [-40.0, 0.0]], [[0.0, 1.0], [-0.75, 0.0], [0.0, -0.5]]);
    }
}

#[test]
fn other_methods_have_the_order_that_they_claim_against_it() {
    // In one piece, and in parts: the exact motion is a series that the flows, or implicit steps, confirm.
    let measured = [
        (4.0, observed_order(&system!(double_pendulum), GaussLegendre4, HUNG, 0.1)),
        (4.0, observed_order(&system!(rotating_frame), Yoshida4, Phase::new([0.5, 0.75], [-0.75, 0.5]), 0.02)),
    ];
    for (order, found) in measured {
        let slope = found.expect("an order").slope;
        assert!((slope - order).abs() < 0.3, "{slope}, not {order}");
    }
    let error = global_error(&system!(double_pendulum), Taylor::tolerance(FINE), HUNG, 0.25, 40).expect("a reference");
    assert!(error.distance < 1e-14 && error.uncertainty < 1e-14, "{error:?}");
}

#[test]
fn certificates_take_it_for_the_exact_motion_and_never_for_a_symplectic_one() {
    let start = Phase::new([1.0, 0.25], [-0.25, 0.75]);
    certify(&system!(kepler_and_interaction), Yoshida4, start, 0.05).expect("a right stepper");
    let refused = certify(&system!(kepler_and_interaction), Taylor::tolerance(FINE), start, 0.05);
    let Err(CertifyError::Refused { shortfalls, .. }) = refused else { panic!("{refused:?}") };
    assert!(shortfalls.contains(&Shortfall::NotSymplectic { method: "Taylor" }), "{shortfalls:?}");
}

#[test]
fn a_run_can_be_sampled_at_any_time() {
    let begin = |h| system!(double_pendulum).run_with(Taylor::tolerance(FINE), HUNG, h).expect("a start");
    let mut halves = begin(0.25);
    for step in 0..20_u64 {
        halves.advance(1).expect("finite states");
        let middle = step as f64 * 0.5 + 0.25;
        let found: Vec<_> = begin(0.5).crossings(step + 1, Direction::Either, |_, t| t - middle).collect();
        let [Ok(crossing)] = &found[..] else { panic!("{found:?}") };
        assert_eq!((crossing.time, &crossing.state), (middle, &halves.state()));
        halves.advance(1).expect("finite states");
    }
    // In portions, and back.
    let mut whole = begin(0.5);
    whole.advance(40).expect("finite states");
    let mut portions = begin(0.5);
    [1, 0, 7, 32].into_iter().for_each(|steps| portions.advance(steps).expect("finite states"));
    assert_eq!(portions.state(), whole.state());
    let back = end(&system!(double_pendulum), &whole.state(), -0.5, 40);
    assert!(apart(&back, &[1.0, -0.5, 0.2, 0.3]) < 2.0 * 16.0 * PER_TIME * 20.0, "{back:?}");
}
