//! A last part that is itself a symmetric pair: which compositions keep their orders, and what slopes say of it.

use crate::{
    catalogue::for_each_composition,
    many_parts::{ByHand, Middle, TIME, reference, slope_of, twisted, walk},
};
use integrator_core::{
    __private::{Flows, QuadraticKinetic, Scheme},
    Composition, Hamiltonian, Phase, Visitor,
    prelude::*,
};

/// The parts of `Twisted`, all but the first of which are one.
struct Paired;

twisted!(Paired: kinetic + (twist + counter + potential));

/// A system of two parts, whose kicks consist of steps of a pair.
pub(crate) struct Two;

#[hamiltonian]
impl Two {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0].cos() + q[1] * q[1]
    }
}

/// The flows by hand for two parts, the second of them the pair, in steps over these fractions of the duration.
pub(crate) struct AsTwo {
    flows: ByHand,
    fractions: Vec<f64>,
}

impl AsTwo {
    pub(crate) fn start(fractions: &[f64]) -> Self {
        Self { flows: ByHand::start(Middle::AsTold), fractions: fractions.to_vec() }
    }

    pub(crate) fn state(&self) -> [f64; 4] {
        self.flows.state()
    }
}

impl Flows<Two> for AsTwo {
    const COMPENSATED: bool = false;

    fn drift(&mut self, t: f64, time: f64) {
        Flows::<Paired>::drift(&mut self.flows, t, time);
    }
    fn kick(&mut self, t: f64, time: f64) {
        for fraction in &self.fractions {
            let t = t * fraction;
            Flows::<Paired>::middle(&mut self.flows, t / 2.0, time, false);
            Flows::<Paired>::kick(&mut self.flows, t, time);
            Flows::<Paired>::middle(&mut self.flows, t / 2.0, time, true);
        }
    }
    fn middle(&mut self, _: f64, _: f64, _: bool) {}
    fn gradient_kick(&mut self, _: f64, _: f64, _: f64)
    where
        Two: QuadraticKinetic,
    {
    }
}

#[test]
fn the_list_is_that_of_the_proof() {
    let (mut listed, mut proved) = (Vec::new(), Vec::new());
    macro_rules! list {
        ($($composition:ident)*) => {$( listed.push($composition::NAME); )*};
    }
    for_each_composition!(pairs: list!);
    macro_rules! prove {
        ($($composition:ident)*) => {$(
            if $composition::KEEPS_PAIRS && $composition::STAGES.closing.kick == 0.0 {
                proved.push($composition::NAME);
            }
        )*};
    }
    for_each_composition!(general: prove!);
    for_each_composition!(near_integrable_general: prove!);
    assert_eq!(listed, proved);
}

#[test]
fn every_composition_for_pairs_keeps_its_order() {
    struct Slopes([f64; 4]);
    impl Visitor<Paired> for Slopes {
        fn visit<X: Composition<Paired>>(&mut self, _: X) {
            let slope = slope_of(X::NAME, self.0, |steps| {
                let mut flows = ByHand::start(Middle::AsTold);
                walk::<Paired, X>(&mut flows, steps);
                flows.state()
            });
            let order = f64::from(X::ORDER);
            // Errors of the next order still show in steps that do not yet reach the rounding.
            assert!(slope > order - 0.4, "{} has order {slope}, not {order}", X::NAME);
        }
    }
    Paired::visit_compositions(&mut Slopes(reference()));
}

#[test]
fn the_others_lose_their_order() {
    fn slope<X: Composition<Two>>(exact: [f64; 4]) -> f64 {
        slope_of(X::NAME, exact, |steps| {
            let mut flows = AsTwo::start(&[1.0]);
            walk::<Two, X>(&mut flows, steps);
            flows.state()
        })
    }
    let exact = reference();
    let kept = slope::<Abah844>(exact);
    assert!(kept > 3.6, "order {kept}");
    for lost in
        [slope::<Pefrl>(exact), slope::<Aba864>(exact), slope::<BlanesMoan6>(exact), slope::<VelocityYoshida4>(exact)]
    {
        assert!(lost < 2.5, "order {lost}");
    }
}

#[test]
fn generated_flows_match_hand_written_ones() {
    let start = Phase { q: [0.4, -0.3], p: [0.2, 0.5] };
    let mut run = Paired.run_with(Abah844, start, TIME / 64.0).expect("a start");
    run.advance(64).expect("finite");
    let Phase { q, p } = run.state();
    let mut flows = ByHand::start(Middle::AsTold);
    walk::<Paired, Abah844>(&mut flows, 64);
    let off = [q[0], q[1], p[0], p[1]].into_iter().zip(flows.state()).map(|(one, other)| (one - other).abs());
    // A few thousand flows of numbers about one, each with a few roundings.
    let off = off.fold(0.0, f64::max);
    assert!(off < 1e4 * f64::EPSILON, "off by {off:e}");
}
