//! Tests of compositions with four parts, none of which commutes with another, against flows that are written by hand.

use crate::slope::slope;
use integrator_core::{
    __private::{Flows, QuadraticKinetic},
    Composition, Hamiltonian, Phase, Visitor,
    prelude::*,
};

/// `½ |p|² + ½ q₀² p₁ + ½ q₁² p₀ + cos q₀ + q₀² q₁ + ½ q₁²`, whose parts read one coordinate of a conjugate pair each, in this split.
macro_rules! twisted {
    ($name:ident: $($split:tt)*) => {
        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn kinetic(&self, p: [f64; 2]) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
            fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
                q[0] * q[0] * p[1] / 2.0
            }
            fn counter(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
                q[1] * q[1] * p[0] / 2.0
            }
            fn potential(&self, q: [f64; 2]) -> f64 {
                q[0].cos() + q[0] * q[0] * q[1] + q[1] * q[1] / 2.0
            }
        }
    };
}
pub(crate) use twisted;

/// One part after the other.
struct Twisted;

twisted!(Twisted: kinetic + twist + counter + potential);

/// What is done with the parts between the first and the last.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Middle {
    AsTold,
    /// WRONG: one after the other in the same order always.
    Forwards,
    /// WRONG: for a hundredth longer.
    Longer,
}

/// The flows by hand.
pub(crate) struct ByHand {
    q: [f64; 2],
    p: [f64; 2],
    middle: Middle,
}

impl ByHand {
    pub(crate) fn start(middle: Middle) -> Self {
        Self { q: [0.4, -0.3], p: [0.2, 0.5], middle }
    }
    fn twist(&mut self, t: f64) {
        self.q[1] += t * self.q[0] * self.q[0] / 2.0;
        self.p[0] -= t * self.q[0] * self.p[1];
    }
    fn counter(&mut self, t: f64) {
        self.q[0] += t * self.q[1] * self.q[1] / 2.0;
        self.p[1] -= t * self.q[1] * self.p[0];
    }
    pub(crate) fn state(&self) -> [f64; 4] {
        [self.q[0], self.q[1], self.p[0], self.p[1]]
    }
}

impl<H: Hamiltonian> Flows<H> for ByHand {
    const COMPENSATED: bool = false;

    fn drift(&mut self, t: f64, _time: f64) {
        self.q[0] += t * self.p[0];
        self.q[1] += t * self.p[1];
    }
    fn kick(&mut self, t: f64, _time: f64) {
        let [x, y] = self.q;
        self.p[0] += t * (x.sin() - 2.0 * x * y);
        self.p[1] -= t * (x * x + y);
    }
    fn middle(&mut self, mut t: f64, _time: f64, backwards: bool) {
        if self.middle == Middle::Longer {
            t *= 1.01;
        }
        if backwards && self.middle != Middle::Forwards {
            self.counter(t);
            self.twist(t);
        } else {
            self.twist(t);
            self.counter(t);
        }
    }
    fn gradient_kick(&mut self, _: f64, _: f64, _: f64)
    where
        H: QuadraticKinetic,
    {
    }
}

/// The motion that all parts make together, by the classical method of Runge and Kutta.
pub(crate) fn reference() -> [f64; 4] {
    classical(ByHand::start(Middle::AsTold).state(), |[x, y, u, v], _| {
        [u + y * y / 2.0, v + x * x / 2.0, x.sin() - 2.0 * x * y - x * v, -x * x - y - y * u]
    })
}

/// Where a field leads by that method.
pub(crate) fn classical(start: [f64; 4], field: impl Fn([f64; 4], f64) -> [f64; 4]) -> [f64; 4] {
    const STEPS: u32 = 20_000;
    let h = TIME / f64::from(STEPS);
    let after = |state: [f64; 4], slope: [f64; 4], h: f64| std::array::from_fn(|i| state[i] + h * slope[i]);
    let mut state = start;
    for step in 0..STEPS {
        let time = h * f64::from(step);
        let one = field(state, time);
        let two = field(after(state, one, h / 2.0), time + h / 2.0);
        let three = field(after(state, two, h / 2.0), time + h / 2.0);
        let four = field(after(state, three, h), time + h);
        state = std::array::from_fn(|i| state[i] + h / 6.0 * (one[i] + 2.0 * (two[i] + three[i]) + four[i]));
    }
    state
}

pub(crate) const TIME: f64 = 1.5;

/// The end after so many steps.
fn composed<X: Composition<Twisted>>(steps: u32, middle: Middle) -> [f64; 4] {
    let mut flows = ByHand::start(middle);
    walk::<Twisted, X>(&mut flows, steps);
    flows.state()
}

/// So many steps over the time.
pub(crate) fn walk<H: Hamiltonian, X: Composition<H>>(flows: &mut impl Flows<H>, steps: u32) {
    let h = TIME / f64::from(steps);
    X::open(flows, h, 0.0);
    for step in 1..steps {
        X::cycle(flows, h, h * f64::from(step));
    }
    X::close(flows, h, TIME - h);
}

fn distance(one: [f64; 4], other: [f64; 4]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// The order by the slope of errors at the finest steps whose errors are no rounding.
fn order_of<X: Composition<Twisted>>(exact: [f64; 4], middle: Middle) -> f64 {
    slope_of(X::NAME, exact, |steps| composed::<X>(steps, middle))
}

/// The same of ends after so many steps.
pub(crate) fn slope_of(name: &str, exact: [f64; 4], end: impl Fn(u32) -> [f64; 4]) -> f64 {
    let points = [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128].map(|steps| {
        let error = distance(end(steps), exact);
        (TIME / f64::from(steps), error)
    });
    // The reference takes 20,000 steps with a few roundings each.
    let points: Vec<_> = points.into_iter().filter(|(_, error)| *error > 1e-12).collect();
    assert!(points.len() >= 2, "{name}: {points:?}");
    slope(&points[points.len() - points.len().min(4)..])
}

#[test]
fn every_composition_keeps_its_order() {
    struct Slopes([f64; 4]);
    impl Visitor<Twisted> for Slopes {
        fn visit<X: Composition<Twisted>>(&mut self, _: X) {
            let (slope, order) = (order_of::<X>(self.0, Middle::AsTold), f64::from(X::ORDER));
            // Errors of the next order still show in steps that do not yet reach the rounding.
            assert!(slope > order - 0.4, "{} has order {slope}, not {order}", X::NAME);
        }
    }
    Twisted::visit_compositions(&mut Slopes(reference()));
}

#[test]
fn wrong_flows_in_the_middle_lose_the_order() {
    let exact = reference();
    for middle in [Middle::Forwards, Middle::Longer] {
        let slope = order_of::<Yoshida4>(exact, middle);
        assert!(slope < 2.5, "order {slope}");
    }
}

#[test]
fn generated_flows_match_hand_written_ones() {
    fn end<X: Composition<Twisted>>(composition: X) -> f64 {
        let ByHand { q, p, .. } = ByHand::start(Middle::AsTold);
        let mut run = Twisted.run_with(composition, Phase { q, p }, TIME / 64.0).expect("a start");
        run.advance(64).expect("finite");
        let Phase { q, p } = run.state();
        distance([q[0], q[1], p[0], p[1]], composed::<X>(64, Middle::AsTold))
    }
    // A few hundred flows of numbers about one, each with a few roundings.
    for off in [end(Euler), end(EulerAdjoint), end(Verlet), end(Ruth3), end(KahanLi8)] {
        assert!(off < 1e3 * f64::EPSILON, "off by {off:e}");
    }
}

#[test]
fn an_adjoint_undoes_a_step_and_symmetric_compositions_undo_their_own() {
    fn there_and_back<X: Composition<Twisted>, Y: Composition<Twisted>>() -> f64 {
        let mut flows = ByHand::start(Middle::AsTold);
        let start = flows.state();
        X::open(&mut flows, 0.1, 0.0);
        X::close(&mut flows, 0.1, 0.0);
        let there = distance(flows.state(), start);
        assert!(there > 0.01, "{} moved by {there}", X::NAME);
        Y::open(&mut flows, -0.1, 0.1);
        Y::close(&mut flows, -0.1, 0.1);
        distance(flows.state(), start)
    }
    for off in [
        there_and_back::<Euler, EulerAdjoint>(),
        there_and_back::<EulerAdjoint, Euler>(),
        there_and_back::<VelocityVerlet, VelocityVerlet>(),
        there_and_back::<Yoshida4, Yoshida4>(),
        there_and_back::<KahanLi8, KahanLi8>(),
    ] {
        assert!(off < 100.0 * f64::EPSILON, "off by {off:e}");
    }
    assert!(there_and_back::<Euler, Euler>() > 1e-4, "Euler's method is not its own adjoint");
}

#[test]
fn a_step_back_on_a_grid_undoes_a_step_to_the_bit() {
    let start = Phase::reversible([0.4, -0.3], [0.2, 0.5], 2.0_f64.powi(-40));
    let mut run = Twisted.run_with(KahanLi8, start, 0.1).expect("a start");
    run.advance(15).expect("finite");
    let mut back = Twisted.run_with(KahanLi8, run.state(), -0.1).expect("a start");
    back.advance(15).expect("finite");
    assert!(back.state() == start, "{:?}", back.state());
}
