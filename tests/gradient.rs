//! Gradients of functions of a run, against differences of twice the precision and against deviation vectors.

#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use integrator_core::{Differentiable, Euler, Gradient, InLanes, Sample, VectorFault, prelude::*};

/// A quartic oscillator.
struct Quartic {
    stiffness: f64,
}

#[hamiltonian(sensitive(stiffness))]
impl Quartic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.stiffness * q[0].powi(4) / 4.0
    }
}

/// A galaxy, chaotic at higher energies.
struct HenonHeiles;

#[hamiltonian(compose = KahanLi8)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// A chain of any length.
#[derive(Clone)]
struct Chain {
    hardening: f64,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += stretch * stretch / 2.0 + self.hardening * stretch.powi(4) / 4.0;
        }
        energy
    }
}

/// A well whose states end where q reaches one.
struct Edge;

#[hamiltonian]
impl Edge {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -(1.0 - q[0]).sqrt()
    }
}

/// The sum of two doubles.
#[derive(Clone, Copy)]
struct Double(f64, f64);

impl Double {
    fn of(sum: f64, error: f64) -> Self {
        let high = sum + error;
        Self(high, error - (high - sum))
    }
    fn plus(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        let part = sum - self.0;
        let error = (self.0 - (sum - part)) + (other.0 - part);
        Self::of(sum, error + self.1 + other.1)
    }
    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let error = self.0.mul_add(other.0, -product);
        Self::of(product, error + self.0 * other.1 + self.1 * other.0)
    }
}

/// The end of Verlet's method for [`Quartic`], whose steps begin with a drift.
fn quartic([q, p, stiffness]: [Double; 3], h: f64, steps: u64) -> [Double; 2] {
    let (mut q, mut p) = (q, p);
    for _ in 0..steps {
        q = q.plus(p.times(Double(h / 2.0, 0.0)));
        p = p.plus(stiffness.times(q.times(q).times(q)).times(Double(-h, 0.0)));
        q = q.plus(p.times(Double(h / 2.0, 0.0)));
    }
    [q, p]
}

#[test]
fn gradients_are_derivatives_of_the_steps_by_start_and_parameters() {
    let (start, stiffness, h, steps) = ([0.75, 0.5], 1.25, 1.0 / 64.0, 400);
    // q p², with its derivatives.
    let loss = |end: &Phase<[f64; 1]>| {
        let (q, p) = (end.q[0], end.p[0]);
        (q * p * p, Phase::new([p * p], [2.0 * q * p]))
    };
    let point = Phase::new([start[0]], [start[1]]);
    let found = Quartic { stiffness }.gradient(Verlet, point, h, steps, loss).expect("a gradient");
    let width = 1e-10;
    let value = |place: usize, by: f64| {
        let mut arguments = [start[0], start[1], stiffness].map(|number| Double(number, 0.0));
        arguments[place] = arguments[place].plus(Double(by, 0.0));
        let [q, p] = quartic(arguments, h, steps);
        q.times(p).times(p)
    };
    for (place, slope) in [found.start.q[0], found.start.p[0], found.parameters[0]].into_iter().enumerate() {
        let (up, down) = (value(place, width), value(place, -width));
        // The square of the width times third derivatives, and roundings of 1e-31 by the width, are far below.
        let difference = up.plus(Double(-down.0, -down.1)).0 / (2.0 * width);
        assert!(
            (slope - difference).abs() < 1e4 * f64::EPSILON * difference.abs(),
            "{place}: {slope} and {difference}"
        );
    }
    assert!(found.return_error > 0.0 && found.return_error < 1e-12, "{found:?}");
    let mut run = Quartic { stiffness }.run_with(Verlet, point, h).expect("a start");
    run.advance(steps).expect("finite states");
    assert_eq!(found.value, loss(&run.state()).0);
}

#[test]
fn gradients_of_a_million_steps_agree_with_deviation_vectors() {
    let start = Phase::new([0.1, 0.1], [0.2, -0.1]);
    let weights = Phase::new([1.0, -0.5], [0.25, 2.0]);
    let found = HenonHeiles.gradient(Verlet, start, 0.01, 1_000_000, |_| (0.0, weights)).expect("a regular orbit");
    let vector = Phase::new([0.3, 0.7], [-0.2, 0.9]);
    let mut tangent = HenonHeiles.tangent(Verlet, start, [vector], 0.01).expect("a start");
    tangent.advance(1_000_000).expect("finite vectors");
    let (at_start, at_end) = (product(&found.start, &vector), product(&weights, &tangent.vectors()[0]));
    // Both ways end at a relative distance of 1e-10, and vectors grow with the time; the derivatives are those of orbits that
    // are this far apart.
    assert!(found.return_error < 1e-9, "{found:?}");
    assert!((at_start - at_end).abs() < 1e2 * found.return_error * at_end.abs(), "{at_start} and {at_end}");
}

#[test]
fn reversible_starts_have_gradients_on_chaotic_orbits() {
    let (q, p, h, steps) = ([0.0, 0.1], [0.5, 0.1], 0.125, 16_000);
    let weights = Phase::new([1.0, -0.5], [0.25, 2.0]);
    let lost = HenonHeiles.gradient(KahanLi8, Phase::new(q, p), h, steps, |_| (0.0, weights));
    assert!(matches!(lost, Err(Error::WayBack { .. })), "{lost:?}");

    let grid = 1.0 / (1_u64 << 44) as f64;
    let start = Phase::reversible(q, p, grid);
    let found = HenonHeiles.gradient(KahanLi8, start, h, steps, |_| (0.0, weights)).expect("a reversible start");
    assert_eq!(found.return_error, 0.0);
    // A vector through the very states of the run, each step of it by a tangent of its own.
    let vector = Phase::new([0.3, 0.7], [-0.2, 0.9]);
    let mut run = HenonHeiles.run_with(KahanLi8, start, h).expect("a start");
    let mut image = vector;
    for _ in 0..steps {
        let mut tangent = HenonHeiles.tangent(KahanLi8, run.state().to_f64(), [image], h).expect("a state");
        tangent.advance(1).and_then(|()| run.advance(1)).expect("finite states");
        image = tangent.vectors()[0];
    }
    let (at_start, at_end) = (product(&found.start, &vector), product(&weights, &image));
    let size = at_end.abs();
    assert!(size > 1e10, "{size:e}: the orbit is chaotic");
    // Each of the steps rounds vectors a few dozen times, and the states of both agree up to a spacing of the grid at each step.
    assert!((at_start - at_end).abs() < 1e2 * grid * steps as f64 * size, "{at_start} and {at_end}");
}

#[test]
fn functions_of_samples_are_added_up() {
    let quartic = Quartic { stiffness: 1.25 };
    let (start, h, interval, samples) = (Phase::new([0.75], [0.5]), 0.05, 7, 20);
    let weight = |step: u64| 1.0 + (step as f64).sin();
    let term = |state: &Phase<[f64; 1]>, step: u64| {
        let (q, p) = (state.q[0], state.p[0]);
        (weight(step) * q * q * p, Phase::new([2.0 * weight(step) * q * p], [weight(step) * q * q]))
    };
    let of_sample = |sample: &Sample<[f64; 1]>| term(&sample.state, sample.step);
    // Three steps after the last sample have no effect.
    let steps = samples * interval + 3;
    let found = quartic.gradient_of_samples(Yoshida4, start, h, interval, steps, of_sample).expect("a gradient");
    let (mut value, mut by_q, mut by_p, mut by_stiffness) = (0.0, 0.0, 0.0, 0.0);
    let run = quartic.run_with(Yoshida4, start, h).expect("a start");
    for sample in run.samples(interval).take(samples as usize + 1) {
        let step = sample.expect("a finite state").step;
        let single = quartic.gradient(Yoshida4, start, h, step, |end| term(end, step)).expect("a gradient");
        value += single.value;
        by_q += single.start.q[0];
        by_p += single.start.p[0];
        by_stiffness += single.parameters[0];
    }
    assert_eq!(found.value, value);
    for (sum, expected) in [(found.start.q[0], by_q), (found.start.p[0], by_p), (found.parameters[0], by_stiffness)] {
        // Twenty-one terms of about one, each with some hundreds of roundings.
        assert!((sum - expected).abs() < 1e4 * f64::EPSILON * (1.0 + expected.abs()), "{sum} and {expected}");
    }
    let refused = quartic.gradient_of_samples(Yoshida4, start, h, 0, 10, of_sample);
    assert_eq!(refused, Err(Error::SampleInterval));
}

#[test]
fn other_precisions_have_gradients() {
    let weights = Phase::new([1.0, -0.5], [0.25, 2.0]);
    let (q, p) = ([0.1, 0.1], [0.2, -0.1]);
    let double = HenonHeiles.gradient(Yoshida4, Phase::new(q, p), 0.1, 100, |_| (1.0, weights)).expect("a gradient");
    let compensated = HenonHeiles.gradient(Yoshida4, Phase::compensated(q, p), 0.1, 100, |_| (1.0, weights));
    let single = Phase::new(q.map(|q| q as f32), p.map(|p| p as f32));
    let single = HenonHeiles.gradient(Yoshida4, single, 0.1, 100, |_| (1.0, weights));
    // Hundreds of roundings of each precision.
    for (found, rounding) in [(compensated, f64::EPSILON), (single, f64::from(f32::EPSILON))] {
        let found = found.expect("a gradient");
        for (a, b) in numbers(&found.start).into_iter().zip(numbers(&double.start)) {
            assert!((a - b).abs() < 1e3 * rounding * (1.0 + b.abs()), "{a} and {b}");
        }
    }
}

#[test]
fn a_function_that_does_not_depend_on_the_end_has_no_gradient() {
    let found = Quartic { stiffness: 1.0 }
        .gradient(Verlet, Phase::new([1.0], [0.0]), 0.1, 100, |_| (3.0, Phase::new([0.0], [0.0])));
    let found = found.expect("a gradient");
    assert_eq!((found.value, numbers(&found.start), found.parameters), (3.0, vec![0.0; 2], vec![0.0]));
    // No steps at all.
    let weights = Phase::new([2.0], [3.0]);
    let found = Quartic { stiffness: 1.0 }.gradient(Verlet, Phase::new([1.0], [0.0]), 0.1, 0, |_| (3.0, weights));
    assert_eq!(found.expect("a gradient").start, weights);
}

#[test]
fn bad_functions_and_methods_are_refused() {
    let start = Phase::new(vec![0.0, 0.1], vec![0.0, 0.0]);
    let refused = |derivatives: Phase<Vec<f64>>| {
        let found = Chain { hardening: 1.0 }.gradient(Verlet, start.clone(), 0.1, 10, |_| (0.0, derivatives.clone()));
        found.expect_err("bad derivatives")
    };
    let fault = VectorFault::Length { lengths: [1, 2], positions: 2 };
    assert_eq!(refused(Phase::new(vec![1.0], vec![0.0; 2])), Error::Loss { step: 10, fault });
    let infinite = refused(Phase::new(vec![f64::INFINITY, 0.0], vec![0.0; 2]));
    assert_eq!(infinite, Error::Loss { step: 10, fault: VectorFault::NotFinite });
    let text = infinite.to_string();
    assert_eq!(text, "the derivative of the function with respect to the state after step 10 is not finite");

    let point = Phase::new([0.1, 0.1], [0.2, 0.1]);
    let by_q = |_: &Phase<[f64; 2]>| (0.0, Phase::new([1.0, 0.0], [0.0, 0.0]));
    let refused = HenonHeiles.gradient(Euler, point, 0.1, 10, by_q).expect_err("not symmetric");
    assert!(refused.to_string().contains("steps by -h do not undo steps of this method"), "{refused}");

    // A run that fails has the error of the run.
    let by_q = |_: &Phase<[f64; 1]>| (0.0, Phase::new([1.0], [0.0]));
    let outside = Edge.gradient(Verlet, Phase::new([0.5], [2.0]), 0.1, 100, by_q).expect_err("the edge is passed");
    let mut run = Edge.run_with(Verlet, Phase::new([0.5], [2.0]), 0.1).expect("a start");
    assert_eq!(outside, run.advance(100).expect_err("the edge is passed"));
}

#[test]
fn members_of_ensembles_have_the_gradients_of_runs_alone() {
    let site = |i: usize| (0.4 * i as f64).sin();
    let member = |number: usize| {
        // Lists of different lengths share no lanes.
        let sites = if number % 11 < 7 { 5 } else { 9 };
        let momenta = (0..sites).map(|i| 0.1 * site(i + number)).collect();
        let start = Phase::new((0..sites).map(|i| site(i + 3 * number)).collect::<Vec<_>>(), momenta);
        (Chain { hardening: 0.1 * number as f64 }, start)
    };
    let loss = |number: usize, end: &Phase<Vec<f64>>| {
        let slope = |(place, _): (usize, &f64)| 1.0 + (place * number) as f64;
        let by_q = end.q.iter().enumerate().map(slope).collect();
        (end.q[0], Phase::new(by_q, end.p.clone()))
    };
    let found = Ensemble::gradients(KahanLi8, (0..37).map(member), 0.05, 100, loss);
    assert_eq!(found.len(), 37);
    for (number, found) in found.into_iter().enumerate() {
        let (chain, start) = member(number);
        let alone = chain.gradient(KahanLi8, start, 0.05, 100, |end| loss(number, end));
        assert_eq!(found, alone, "member {number}");
        assert!(found.is_ok());
    }
    // Parameters with derivatives, in lanes by a composition and on threads by an implicit method; more than a block of steps.
    let by_q = |_, _: &Phase<[f64; 1]>| (0.0, Phase::new([1.0], [0.0]));
    fn hold<X: InLanes<Quartic> + Differentiable<Quartic>>(method: X, steps: u64) {
        let by_q = |_, end: &Phase<[f64; 1]>| (end.q[0], Phase::new([1.0], [end.p[0]]));
        let member =
            |i: u32| (Quartic { stiffness: 1.0 + 0.1 * f64::from(i) }, Phase::new([1.0], [0.01 * f64::from(i)]));
        let found = Ensemble::gradients(method, (0..21).map(member), 0.1, steps, by_q);
        for (number, found) in (0..).zip(found) {
            let (quartic, start) = member(number);
            assert_eq!(found, quartic.gradient(method, start, 0.1, steps, |end| by_q(0, end)), "member {number}");
            assert_eq!(found.expect("a gradient").parameters.len(), 1);
        }
    }
    hold(Verlet, 150);
    hold(KahanLi8, 64);
    hold(KahanLi8, 0);
    hold(GaussLegendre4, 20);
    // A member that fails beside others.
    let starts = [0.0, 2.0, f64::NAN, 0.1].map(|p| (Edge, Phase::new([0.5], [p])));
    let found = Ensemble::gradients(Verlet, starts, 0.1, 5, by_q);
    let are_found: Vec<bool> = found.iter().map(Result::is_ok).collect();
    assert_eq!(are_found, [true, false, false, true], "{found:?}");
    assert!(matches!(found[2], Err(Error::Start { coordinate: "p", .. })), "{found:?}");
    let alone: Gradient<_> =
        Edge.gradient(Verlet, Phase::new([0.5], [0.1]), 0.1, 5, |end| by_q(0, end)).expect("a gradient");
    assert_eq!(found[3], Ok(alone));
}

/// The numbers of a point, positions first.
fn numbers<const N: usize>(point: &Phase<[f64; N]>) -> Vec<f64> {
    point.q.iter().chain(&point.p).copied().collect()
}

fn product<const N: usize>(a: &Phase<[f64; N]>, b: &Phase<[f64; N]>) -> f64 {
    numbers(a).iter().zip(numbers(b)).map(|(a, b)| a * b).sum()
}
