//! Parts that read one kinetic momentum, whose flow is a shear between two canonical shifts.

use crate::{
    derivatives,
    many_parts::{TIME, classical, slope_of},
};
use integrator_core::{Coords, Hamiltonian, Method, Phase, check::certify, prelude::*};

/// A part whose kinetic momentum `u = p₀ - q₀² q₁` and factor `q₁` stay, beside a free third coordinate.
struct Stays;

#[hamiltonian(split = kinetic + free)]
impl Stays {
    fn kinetic(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
        (p[0] - q[0] * q[0] * q[1]).cosh() * (1.0 + q[1] * q[1])
    }
    fn free(&self, p: [f64; 3]) -> f64 {
        p[2]
    }
}

impl Stays {
    /// Where the flow of `kinetic` leads: `q₀` grows by `t sinh(u) (1 + q₁²)`, and momenta follow from `u` and from
    /// `∂(q₀³ q₁/3)/∂q₁`.
    fn after(&self, t: f64, Phase { q: [x, y, _], p: [px, py, _] }: Phase<[f64; 3]>) -> [f64; 4] {
        let u = px - x * x * y;
        let end = x + t * u.sinh() * (1.0 + y * y);
        let shift = (end.powi(3) - x.powi(3)) / 3.0;
        [end, y, u + end * end * y, py - t * 2.0 * y * u.cosh() + shift]
    }
}

/// A charge in a plane wave and a well. The wave is a vector potential along x, which depends on x.
#[derive(Clone)]
struct Wave {
    field: f64,
    number: f64,
    mass: f64,
}

#[hamiltonian(split = x + y + well, compose = Yoshida4)]
impl Wave {
    fn x(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] - self.field * (self.number * q[0] - q[1]).sin()).powi(2) / (2.0 * self.mass)
    }
    fn y(&self, p: [f64; 2]) -> f64 {
        p[1] * p[1] / (2.0 * self.mass)
    }
    fn well(&self, q: [f64; 2]) -> f64 {
        q[0].powi(4) / 4.0 + q[1] * q[1] / 2.0
    }
}

impl Wave {
    fn slope(&self, [x, y, px, py]: [f64; 4]) -> [f64; 4] {
        let (sine, cosine) = (self.number * x - y).sin_cos();
        let speed = (px - self.field * sine) / self.mass;
        let push = speed * self.field * cosine;
        [speed, py / self.mass, self.number * push - x.powi(3), -push - y]
    }
}

const WAVE: Wave = Wave { field: 0.7, number: 1.5, mass: 1.2 };

/// The same with a field that grows, whose derivatives are in both directions.
struct Growing;

#[hamiltonian(split = x + y + well, compose = Yoshida4)]
impl Growing {
    fn x(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        (t.cos() * q[0] * q[1] * q[1] - p[0]).powi(2) / 2.0
    }
    fn y(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[1] + q[1] * q[0].exp()).powi(2) / 2.0
    }
    fn well(&self, q: [f64; 2]) -> f64 {
        q[0].powi(4) / 4.0 + q[1] * q[1] / 2.0
    }
}

fn growing([x, y, px, py]: [f64; 4], t: f64) -> [f64; 4] {
    let (u, v) = (px - t.cos() * x * y * y, py + y * x.exp());
    let along_x = u * t.cos() * y * y - v * y * x.exp() - x.powi(3);
    [u, v, along_x, u * t.cos() * 2.0 * x * y - v * x.exp() - y]
}

/// Many charges, each with a mass of its own, in a list.
#[derive(Clone)]
struct Charges {
    mass: Vec<f64>,
}

#[hamiltonian(split = x + y + well, compose = Yoshida4)]
impl Charges {
    fn x(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += (p[i][0] - 0.7 * (1.5 * q[i][0] - q[i][1]).sin()).powi(2) / (2.0 * self.mass[i]);
        }
        sum
    }
    fn y(&self, p: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += p[i][1] * p[i][1] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn well(&self, q: &[[f64; 2]]) -> f64 {
        q.iter().map(|[x, y]| x.powi(4) / 4.0 + y * y / 2.0).sum()
    }
}

fn start() -> Phase<[f64; 2]> {
    Phase { q: [0.4, -0.3], p: [0.2, 0.5] }
}

fn numbers(Phase { q: [x, y], p: [u, v] }: Phase<[f64; 2]>) -> [f64; 4] {
    [x, y, u, v]
}

/// The largest distance between numbers.
fn distance<const N: usize>(one: [f64; N], other: [f64; N]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// The order by the slope of errors.
fn slope<H: Hamiltonian<Coords = [f64; 2]>, X: Method<H>>(system: &H, method: X, exact: [f64; 4]) -> f64 {
    slope_of(method.facts().name, exact, |steps| {
        let mut run = system.run_with::<f64, X>(method, start(), TIME / f64::from(steps)).expect("a start");
        run.advance(u64::from(steps)).expect("finite");
        numbers(run.state())
    })
}

#[test]
fn the_flow_is_the_closed_form() {
    let begin = Phase { q: [0.3, -0.6, 0.0], p: [0.5, 0.2, 0.1] };
    // Steps forwards and backwards, with one of which all others agree, since they are of one flow.
    for (h, steps) in [(2.0, 1), (0.02, 100), (-0.5, 3)] {
        let mut run = Stays.run_with(Verlet, begin, h).expect("a start");
        run.advance(steps).expect("finite");
        let Phase { q: [x, y, _], p: [px, py, _] } = run.state();
        let exact = Stays.after(h * steps as f64, begin);
        let moved = distance(exact, [begin.q[0], begin.q[1], begin.p[0], begin.p[1]]);
        assert!(moved > 0.5, "moved by {moved}");
        // A hundred flows of numbers below four, of ten roundings each.
        let off = distance([x, y, px, py], exact);
        assert!(off < 4.0 * 1e3 * f64::EPSILON, "{steps} steps of {h} are off by {off:e}");
        let energy = (run.energy() - Stays.run_with(Verlet, begin, h).expect("a start").energy()).abs();
        assert!(energy < 4.0 * 1e3 * f64::EPSILON, "the energy is off by {energy:e}");
    }
}

#[test]
fn compositions_keep_their_order() {
    let exact = classical(numbers(start()), |state, _| WAVE.slope(state));
    let mut implicit = WAVE.run_with(GaussLegendre::<8>, start(), TIME / 8.0).expect("a start");
    implicit.advance(8).expect("finite");
    // The references have nothing in common with the flows. One takes 20,000 steps with a few roundings each.
    let apart = distance(numbers(implicit.state()), exact);
    assert!(apart < 1e-12, "the references differ by {apart:e}");
    for (found, order) in [
        (slope(&WAVE, Euler, exact), 1.0),
        (slope(&WAVE, Verlet, exact), 2.0),
        (slope(&WAVE, Ruth3, exact), 3.0),
        (slope(&WAVE, Yoshida4, exact), 4.0),
        (slope(&WAVE, KahanLi8, exact), 8.0),
    ] {
        // Errors of the next order still show in steps that do not yet reach the rounding.
        assert!(found > order - 0.4, "order {found}, not {order}");
    }
}

#[test]
fn parts_that_read_the_time_keep_the_order() {
    let exact = classical(numbers(start()), growing);
    for (found, order) in [
        (slope(&Growing, Verlet, exact), 2.0),
        (slope(&Growing, Yoshida4, exact), 4.0),
        (slope(&Growing, KahanLi8, exact), 8.0),
    ] {
        assert!(found > order - 0.4, "order {found}, not {order}");
    }
}

#[test]
fn a_wrong_field_is_seen_by_the_slope() {
    let wrong = classical(numbers(start()), |state, _| Wave { field: 0.71, ..WAVE }.slope(state));
    let found = slope(&WAVE, Yoshida4, wrong);
    assert!(found < 1.0, "order {found}");
}

#[test]
fn steps_are_certified() {
    let certificate = certify(&WAVE, Yoshida4, start(), 0.05).unwrap_or_else(|error| panic!("{error}"));
    // Products of three dozen matrices with entries of order one.
    assert!(certificate.symplectic_defect < 1e-13, "{certificate}");
    certify::<_, _, f64>(&Growing, Yoshida4, start(), 0.05).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_wave_number_of_zero_is_an_error() {
    let error = Wave { number: 0.0, ..WAVE }.run(start(), 0.05).expect_err("no antiderivative");
    assert!(error.to_string().contains("field / number"), "{error}");
}

#[test]
fn bodies_of_a_list_move_as_alone() {
    let mass: Vec<f64> = (0..21).map(|i| 1.0 + 0.1 * f64::from(i)).collect();
    let body = |i: usize| Phase { q: [0.4, 0.1 * i as f64 - 1.0], p: [0.2, 0.5] };
    let all: Vec<Phase<[f64; 2]>> = (0..mass.len()).map(body).collect();
    let all = Phase::new(all.iter().map(|body| body.q).collect::<Vec<_>>(), all.iter().map(|body| body.p).collect());
    let mut charges = Charges { mass: mass.clone() }.run(all, 0.05).expect("a start");
    charges.advance(40).expect("finite");
    let Phase { q, p } = charges.state();
    for (i, mass) in mass.into_iter().enumerate() {
        let mut alone = Wave { mass, ..WAVE }.run(body(i), 0.05).expect("a start");
        alone.advance(40).expect("finite");
        let off = distance(numbers(Phase { q: q[i], p: p[i] }), numbers(alone.state()));
        // Loops in lanes multiply by steps after they have summed up: a few roundings in each of 120 stages.
        assert!(off < 1e3 * f64::EPSILON, "body {i} is off by {off:e}");
    }
}

#[test]
fn members_of_an_ensemble_have_the_bits_of_their_runs() {
    let members: Vec<_> = (0..13).map(|i| (Wave { number: 1.0 + 0.1 * f64::from(i), ..WAVE }, start())).collect();
    let mut swarm = Ensemble::new(Yoshida4, members.clone(), 0.05).expect("members");
    swarm.advance(40).expect("finite");
    for ((system, start), state) in members.iter().zip(swarm.states()) {
        let mut alone = system.run(*start, 0.05).expect("a start");
        alone.advance(40).expect("finite");
        assert_eq!(state, alone.state());
    }
}

#[test]
fn deviation_vectors_are_derivatives_of_the_steps() {
    derivatives::holds("a wave", &WAVE, Yoshida4, start(), 0.05);
    derivatives::holds("a growing field", &Growing, Yoshida4, start(), 0.05);
    let start = Phase::new(vec![[0.4, -0.3], [0.1, 0.2]], vec![[0.2, 0.5], [0.3, -0.1]]);
    derivatives::holds("a list", &Charges { mass: vec![1.0, 1.3] }, Yoshida4, start, 0.05);
}

/// How far a run of many short steps ends from where the motion leads.
fn off<C: Coords>(run: Result<Run<C>, Error>) -> f64 {
    let mut run = run.expect("a start");
    run.advance(10_000).expect("finite");
    let Phase { q, p } = run.state().to_f64();
    let end: Vec<f64> = q.flat().iter().chain(p.flat()).copied().collect();
    distance(end.try_into().expect("two pairs"), classical(numbers(start()), |state, _| WAVE.slope(state)))
}

#[test]
fn every_kind_of_coordinate_is_shifted() {
    let (h, Phase { q, p }) = (TIME / 10_000.0, start());
    // The error of the method is of the order h⁴, below 1e-15. A step rounds eighteen numbers below one; what rounds in
    // one direction for 10,000 steps is 1.8e5 roundings at most.
    let plain = off(WAVE.run(start(), h));
    assert!(plain < 1.8e5 * f64::EPSILON, "off by {plain:e}");
    let single = off(WAVE.run(Phase::new(q.map(|x| x as f32), p.map(|x| x as f32)), h));
    assert!(single < 1.8e5 * f64::from(f32::EPSILON), "off by {single:e}");
    // Here only the reference rounds, in 20,000 steps, and the read coordinates do.
    let compensated = off(WAVE.run(Phase::compensated(q, p), h));
    assert!(compensated < 2e4 * f64::EPSILON, "off by {compensated:e}");
}

#[test]
fn a_step_back_on_a_grid_undoes_a_step_to_the_bit() {
    let start = Phase::reversible([0.4, -0.3], [0.2, 0.5], 2.0_f64.powi(-40));
    let mut there = WAVE.run(start, 0.05).expect("a start");
    let begin = there.state();
    there.advance(100).expect("finite");
    assert_ne!(there.state(), begin);
    let mut back = WAVE.run(there.state(), -0.05).expect("a start");
    back.advance(100).expect("finite");
    assert_eq!(back.state(), begin);
}
