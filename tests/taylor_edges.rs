//! Taylor's method across edges: steps end where a condition changes, where a function jumps and where the root of a square
//! is zero.

use integrator_core::{prelude::*, taylor::Taylor};
use std::f64::consts::{PI, SQRT_2};

/// One coordinate with many potentials.
#[derive(Clone, Copy, Debug)]
struct Edges {
    kind: u32,
}

#[hamiltonian(taylor)]
impl Edges {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let q = q[0];
        match self.kind {
            0 => {
                if q > 0.5 {
                    50.0 * (q - 0.5) * (q - 0.5)
                } else {
                    0.0
                }
            }
            1 => {
                if q > 0.5 {
                    (q - 0.5).powi(8) * 1e5
                } else {
                    0.0
                }
            }
            2 => (q - 0.5).max(0.0).powi(8) * 1e5,
            3 => q.abs(),
            4 => 0.5 * q.clamp(-0.5, 0.5),
            5 => {
                if q > 0.0 {
                    if q > 1.0 { 2.0 * q - 1.0 } else { q }
                } else {
                    -q
                }
            }
            6 => (q * q).powf(1.5),
            7 => (q * q).sqrt() * q * q,
            8 => q.floor() * q - 0.5 * q.floor() * (q.floor() + 1.0),
            9 => {
                if q == 0.0 {
                    -1.0
                } else {
                    -q.sin() / q
                }
            }
            _ => -1.0 / (q.abs() + 0.5),
        }
    }
}

/// `∫ du / √(1 - u⁸)` from 0 to 1, which is `Γ(1/8) Γ(1/2) / (8 Γ(5/8))`.
const EIGHTH: f64 = 1.163_592_571_218_268_9;
/// `∫ du / √(1 - u³)` from 0 to 1, which is `Γ(1/3) Γ(1/2) / (3 Γ(5/6))`.
const THIRD: f64 = 1.402_182_105_325_454_2;

/// A free flight to a distance, a wall in which the motion stays for a while, and the flight back.
fn reflected(distance: f64, speed: f64, within: f64, t: f64) -> [f64; 2] {
    [distance - speed * (t - distance / speed - within), -speed]
}

/// Closed forms: the kind, the start, the time, and the state there.
fn closed_forms() -> Vec<(u32, [f64; 2], f64, [f64; 2])> {
    let eighth = 2.0 * (0.32e-5_f64).powf(0.125) / 0.8 * EIGHTH;
    let quarter = THIRD / (SQRT_2 * 0.6_f64.sqrt());
    let speed = (2.0 * 0.6_f64.powi(3)).sqrt();
    // From rest at 1 in |q|: a parabola of the time √2 to 0, then its mirror image.
    let fall = |t: f64| [-(1.0 - 0.5 * (2.0 * SQRT_2 - t).powi(2)), -(2.0 * SQRT_2 - t)];
    // The ramp of the clamp from -0.5 to 0.5 takes 0.5 of the energy: from 2 to √3, and the time of its mean speed.
    let root = (4.0_f64 - 1.0).sqrt();
    let ramp = 2.0 / (2.0 + root);
    // In the steeper part from 1 on, the deceleration is 2: back at 1 after twice 1.5 / 2, with the speed reversed.
    let nested = 1.5;
    // Decelerated by 1 from 1 on, at 1 again after 2.4.
    let stairs = 0.5 / 1.2 + 2.4;
    vec![
        (0, [0.0, 0.8], 4.0, reflected(0.5, 0.8, 0.1 * PI, 4.0)),
        (1, [0.0, 0.8], 4.0, reflected(0.5, 0.8, eighth, 4.0)),
        (2, [0.0, 0.8], 4.0, reflected(0.5, 0.8, eighth, 4.0)),
        (3, [1.0, 0.0], 2.0, fall(2.0)),
        // Thrown up from the kink: a period of 4, at its lowest point after 3 of it.
        (3, [0.0, 1.0], 7.0, [-0.5, 0.0]),
        (4, [-1.5, 2.0], 3.0, [0.5 + root * (3.0 - 0.5 - ramp), root]),
        (5, [1.0, 1.5], 2.0, [1.0 - 1.5 * (2.0 - nested) - 0.5 * (2.0_f64 - nested).powi(2), nested - 3.5]),
        (6, [0.6, 0.0], 3.0 * quarter, [0.0, speed]),
        (7, [0.6, 0.0], 3.0 * quarter, [0.0, speed]),
        (8, [0.5, 1.2], stairs + 0.5, [1.0 - 1.2 * 0.5, -1.2]),
    ]
}

/// The method takes some ten steps per unit of time, each of which rounds a state of size one or two by 1e-16 or twice that.
/// An edge is crossed within a rounding of the time, and walls with a frequency of ten multiply by that.
const TOLERANCE: f64 = 3e-14;

#[test]
fn motions_across_edges_are_those_of_closed_forms() {
    for (kind, [q, p], t, expected) in closed_forms() {
        let mut run = Edges { kind }.run_with(Taylor::tolerance(1e-16), Phase::new([q], [p]), 0.01).expect("a start");
        run.advance_to(t).unwrap_or_else(|error| panic!("{kind}: {error}"));
        let found = [run.state().q[0], run.state().p[0]];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < TOLERANCE,
                "{kind} at {t}: {found} for {expected}, {:?}",
                run.own_steps()
            );
        }
    }
}

#[test]
fn energies_are_kept_across_edges() {
    for kind in (0..=10).filter(|kind| *kind != 3) {
        let start = if (6..8).contains(&kind) { [0.6, 0.0] } else { [0.1, 0.8] };
        let mut run = Edges { kind }
            .run_with(Taylor::tolerance(1e-16), Phase::new([start[0]], [start[1]]), 0.02)
            .expect("a start");
        let energy = run.energy();
        run.advance(2000).unwrap_or_else(|error| panic!("{kind}: {error}"));
        // Some ten steps per unit of time, forty units, each with a rounding of an energy of about one; the guard of kind 9
        // adds steps at the pole of its series.
        assert!((run.energy() - energy).abs() < 1e-13, "{kind}: {:e}, {:?}", run.energy() - energy, run.own_steps());
    }
}

#[test]
fn portions_and_dense_output_do_not_change_a_bit() {
    for (kind, [q, p], ..) in closed_forms() {
        let run = || Edges { kind }.run_with(Taylor::tolerance(1e-15), Phase::new([q], [p]), 0.03).expect("a start");
        let (mut whole, mut parts, mut seen) = (run(), run(), run());
        whole.advance(200).expect("finite states");
        for steps in [1, 7, 32, 60, 100] {
            parts.advance(steps).expect("finite states");
            seen.advance(steps - 1).expect("finite states");
            seen.advance_to(seen.time() + 0.017).expect("finite states");
            seen.advance(1).expect("finite states");
        }
        assert_eq!(whole.state(), parts.state(), "{kind}");
        assert_eq!(whole.state(), seen.state(), "{kind}");
        let last = run().samples_at(0.7).take(8).last().expect("a sample").expect("a state");
        let mut at_once = run();
        at_once.advance_to(last.time).expect("finite states");
        assert_eq!(last.state, at_once.state(), "{kind}");
    }
}

#[test]
fn members_of_an_ensemble_cross_edges_as_they_do_alone() {
    let systems: Vec<_> = [0, 1, 3, 4, 5, 6, 8, 10, 2, 7].map(|kind| Edges { kind }).into();
    let starts: Vec<_> = (0..10).map(|i| Phase::new([0.6 + 0.01 * f64::from(i)], [0.3])).collect();
    let method = Taylor::tolerance(1e-14);
    let members = systems.iter().copied().zip(starts.clone());
    let mut swarm = Ensemble::new(method, members, 0.05).expect("a start");
    swarm.advance(100).expect("finite states");
    for (number, (system, start)) in systems.iter().zip(starts).enumerate() {
        let mut alone = system.run_with(method, start, 0.05).expect("a start");
        alone.advance(100).expect("finite states");
        assert_eq!(swarm.state(number), Some(alone.state()), "{system:?}");
    }
}

/// The derivative of the final state by the start, from closed forms of the wall of kind 0: the time at which it is reached
/// and left moves with the start.
#[test]
fn deviation_vectors_cross_an_edge_at_which_the_force_is_continuous() {
    let vectors = [Phase::new([1.0], [0.0]), Phase::new([0.0], [1.0])];
    let tangent = |kind, start: [f64; 2]| {
        Edges { kind }
            .tangent(Taylor::tolerance(1e-16), Phase::new([start[0]], [start[1]]), vectors, 0.05)
            .expect("a start")
    };
    let mut wall = tangent(0, [0.0, 0.8]);
    wall.advance_to(4.0).expect("finite states");
    // q(t) = 0.5 + v (t₁ + π/10 - t) with t₁ = (0.5 - q) / v.
    let expected = [[-1.0, 0.0], [-(4.0 - 0.1 * PI), -1.0]];
    for (vector, [dq, dp]) in wall.vectors().iter().zip(expected) {
        // The derivative loses the frequency of the wall to the roundings of states.
        assert!((vector.q[0] - dq).abs() < 1e-12 && (vector.p[0] - dp).abs() < 1e-12, "{vector:?} for {dq}, {dp}");
    }
    let mut kink = tangent(3, [1.0, 0.0]);
    let error = kink.advance_to(4.0).expect_err("a force that jumps");
    assert!(error.to_string().contains("the force jumps"), "{error}");
    let mut cubic = tangent(7, [0.6, 0.0]);
    cubic.advance_to(4.0).expect("a force that is continuous");
}

/// A force that is switched on and off by the time, between the steps of a run.
#[derive(Clone, Copy)]
struct Pulse {
    on: f64,
    off: f64,
}

#[hamiltonian(taylor)]
impl Pulse {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        if t > self.on && t < self.off { -2.0 * q[0] } else { 0.0 }
    }
}

#[test]
fn conditions_on_the_time_end_steps_where_they_change() {
    let (on, off) = (0.37, 1.13);
    for h in [0.25, 0.1, 3.0] {
        let start = Phase::new([0.0], [0.0]);
        let mut run = Pulse { on, off }.run_with(Taylor::tolerance(1e-16), start, h).expect("a start");
        run.advance_to(2.9).expect("finite states");
        let (gained, during) = (2.0 * (off - on), off - on);
        let expected = [during * during + gained * (2.9 - off), gained];
        let found = [run.state().q[0], run.state().p[0]];
        for (found, expected) in found.into_iter().zip(expected) {
            // Times are rounded in front of a force of 2.
            assert!((found - expected).abs() < 8.0 * f64::EPSILON * 3.0, "{found} for {expected} by steps of {h}");
        }
        // All neighbours meet a pulse at once: its jumps leave no trace in derivatives.
        let vectors = [Phase::new([0.0], [1.0])];
        let mut tangent = Pulse { on, off }.tangent(Taylor::tolerance(1e-16), start, vectors, h).expect("a start");
        tangent.advance_to(2.9).expect("finite states");
        assert!((tangent.vectors()[0].q[0] - 2.9).abs() < 1e-14);
    }
}

/// Released from rest, a body falls through the centre, where the root of a square has a kink.
struct Hernquist;

#[hamiltonian(taylor)]
impl Hernquist {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / ((q[0] * q[0] + q[1] * q[1]).sqrt() + 0.5)
    }
}

#[test]
fn radial_orbits_pass_the_centre_as_nearly_radial_ones_do() {
    let mut straight =
        Edges { kind: 10 }.run_with(Taylor::tolerance(1e-16), Phase::new([0.5], [0.0]), 0.02).expect("a start");
    straight.advance(300).expect("finite states");
    for (py, bound) in [(0.0, 1e-13), (1e-14, 1e-11), (1e-10, 1e-7), (1e-6, 1e-3)] {
        let start = Phase::new([0.5, 0.0], [0.0, py]);
        let mut run = Hernquist.run_with(Taylor::tolerance(1e-16), start, 0.02).expect("a start");
        let energy = run.energy();
        run.advance(300).unwrap_or_else(|error| panic!("{py}: {error}"));
        // A few hundred steps at each of five passages, which each round an energy of one.
        assert!((run.energy() - energy).abs() < 2e-13, "{py}: {:e}", run.energy() - energy);
        // The impact parameter turns an orbit by its own size times the number of passages.
        let ([x, y], [radius]): ([f64; 2], [f64; 1]) = (run.state().q, straight.state().q);
        let apart = (x.hypot(y) - radius.abs()).abs();
        assert!(apart < bound, "{py}: {apart:e}");
    }
}

/// A chain whose bonds push and do not pull, in a list and in an array.
struct Contacts;

#[hamiltonian(taylor)]
impl Contacts {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 1..q.len() {
            let overlap = 1.0 - (q[i] - q[i - 1]);
            if overlap > 0.0 {
                sum += 20.0 * overlap * overlap * overlap;
            }
        }
        sum
    }
}

struct Line;

#[hamiltonian(taylor)]
impl Line {
    fn kinetic(&self, p: [f64; 16]) -> f64 {
        let mut sum = 0.0;
        for i in 0..16 {
            sum += 0.5 * p[i] * p[i];
        }
        sum
    }
    fn potential(&self, q: [f64; 16]) -> f64 {
        let mut sum = 0.0;
        for i in 0..15 {
            let overlap = q[i] - q[i + 1];
            if overlap > 0.0 {
                sum += 20.0 * overlap * overlap * overlap;
            }
        }
        sum
    }
}

/// Discs that repel each other within a cutoff, at which the force is continuous.
struct Discs;

#[hamiltonian(taylor)]
impl Discs {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1])).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                let r2 = x * x + y * y;
                if r2 < 1.0 {
                    sum += 2.0 * (1.0 - r2) * (1.0 - r2) * (1.0 - r2);
                }
            }
        }
        sum
    }
}

/// Compares a run with compensated steps of a composition of fourth order, to the time 4.
fn compared<H: Hamiltonian + integrator_core::taylor::Recurrences>(
    name: &str,
    system: &H,
    start: Phase<H::Coords>,
    numbers: impl Fn(&Phase<H::Coords>) -> Vec<f64>,
) {
    let mut run = system.run_with(Taylor::tolerance(1e-16), start.clone(), 0.0625).expect("a start");
    run.advance(64).unwrap_or_else(|error| panic!("{name}: {error}"));
    let composed = |h: f64, steps: u64| {
        let mut run = system.run_with(Yoshida4, start.clone(), h).expect("a start");
        run.advance(steps).expect("finite states");
        numbers(&run.state())
    };
    let (fine, coarse) = (composed(1.0 / 4096.0, 16384), composed(1.0 / 2048.0, 8192));
    let found = numbers(&run.state());
    for (place, ((fine, coarse), found)) in fine.iter().zip(&coarse).zip(&found).enumerate() {
        // The second derivative of the force jumps at edges, so that steps of h err there by h⁴ as elsewhere: fine ones are
        // nearer than coarse ones are to them; and 1e4 steps round 1e-16 each, times the growth of differences.
        let tolerance = (fine - coarse).abs() + 1e-11;
        assert!((fine - found).abs() < tolerance, "{name} {place}: {found} for {fine}, {:e} apart", fine - found);
    }
}

#[test]
fn conditions_in_sums_and_on_lattices_end_steps_where_they_change() {
    let site = |i: usize| 0.3 * (1.7 * i as f64).sin();
    let chain = Phase::new((0..9).map(|i| i as f64 + 0.3 * site(i)).collect::<Vec<_>>(), (0..9).map(site).collect());
    compared("a list of contacts", &Contacts, chain, |state| [&state.q[..], &state.p[..]].concat());
    let line = Phase::new(std::array::from_fn(|i| site(i + 1)), std::array::from_fn(site));
    compared("a line of contacts", &Line, line, |state| [&state.q[..], &state.p[..]].concat());
    // At rest but for one: all other bonds begin on their edge.
    let pushed = Phase::new([0.0; 16], std::array::from_fn(|i| if i == 3 { 0.7 } else { 0.0 }));
    compared("a line at rest", &Line, pushed, |state| [&state.q[..], &state.p[..]].concat());
    let place = |i: usize| [1.1 * (i % 3) as f64 + 0.2 * site(i), 1.1 * (i / 3) as f64 + 0.2 * site(2 * i)];
    let discs = Phase::new((0..7).map(place).collect::<Vec<_>>(), (0..7).map(|i| [site(i), site(i + 4)]).collect());
    compared("discs", &Discs, discs, |state| [state.q.concat(), state.p.concat()].concat());
}

#[test]
fn crossings_are_found_after_an_edge() {
    let run = Edges { kind: 0 }.run_with(Taylor::tolerance(1e-16), Phase::new([0.0], [0.8]), 0.25).expect("a start");
    let mut crossings = run.crossings(16, Direction::Either, |state, _| state.q[0] - 0.3);
    let times: Vec<f64> = (0..2).map(|_| crossings.next().expect("a crossing").expect("a state").time).collect();
    let back = 0.5 / 0.8 + 0.1 * PI + 0.2 / 0.8;
    assert!((times[0] - 0.375).abs() < 1e-14 && (times[1] - back).abs() < 1e-14, "{times:?} for {back}");
}
