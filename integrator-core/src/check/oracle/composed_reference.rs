//! The reference by composed flows: Suzuki's composition of eighth order, in steps that are halved until nothing but
//! rounding changes.
//!
//! Always true: neither the catalogue nor the executor of runs is involved.

use crate::{
    check::{
        oracle::{exact::Exact, reference::Reference},
        start::Start,
        statistics::path::{PARTS, Path, Recorder, Scale},
    },
    hamiltonian::{Flows, Hamiltonian, Shaped, Single},
    scalar::tolerance::within,
    state::{
        compensated::Compensated,
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
    },
    system::motion::Motion,
};

/// The steps per part at the first and at the last refinement.
const COARSEST: u64 = 2;
const FINEST: u64 = 64;

/// The composed flows of a system from a start.
pub(crate) struct ComposedReference<'s> {
    system: &'s dyn Exact,
    start: &'s Start<Vec<f64>>,
    weights: Vec<f64>,
    /// The smallest number of steps in a part of the time.
    whole: u64,
}

impl<'s> ComposedReference<'s> {
    pub(crate) fn new(system: &'s dyn Exact, start: &'s Start<Vec<f64>>) -> Self {
        Self { system, start, weights: weights(), whole: 1 }
    }

    /// The same in steps that divide those of a run with `whole` steps in a part: edges between pieces of the
    /// Hamiltonian lie where these end.
    pub(crate) fn within_steps(self, whole: u64) -> Self {
        if self.system.piecewise_in_time() { Self { whole, ..self } } else { self }
    }

    /// The motion over `span`, refined until halving the step changes nothing but rounding.
    pub(crate) fn refined(&self, span: f64) -> Reference {
        self.refined_to(span, FINEST)
    }

    /// The motion over `span` in the two coarsest steps.
    pub(crate) fn coarse(&self, span: f64) -> Reference {
        self.refined_to(span, 2 * COARSEST)
    }

    fn refined_to(&self, span: f64, finest: u64) -> Reference {
        let settled = |reference: &Reference| within(reference.uncertainty(), reference.rounding());
        Reference::refined(COARSEST..=finest, |steps| self.path(span, steps), settled)
    }

    /// The motion in `steps` steps of eighth order over each part of `span`.
    fn path(&self, span: f64, steps: u64) -> (Path, Scale) {
        let Self { system, start, weights, whole } = self;
        let steps = whole * steps;
        let h = span / (PARTS * steps) as f64;
        let mut recorder = Recorder::new(start.phase.clone(), steps);
        system.composed_steps(start, (h, PARTS * steps), weights, &mut |end| recorder.record(end));
        recorder.finish()
    }
}

/// Takes `steps` steps of `h` with a compensated state, each of them Verlet over `fractions` of it, and shows each end.
pub(crate) fn composed_steps<H: Hamiltonian>(
    system: &H,
    Start { phase: start, time: t0 }: Start<H::Coords>,
    (h, steps): (f64, u64),
    fractions: &[f64],
    show: &mut dyn FnMut(Flat),
) {
    let parameters = system.parameters(start.q.length());
    let mut state: Phase<Shaped<H, Compensated<f64>>> = Phase::compensated(start.q, start.p);
    let mut motion = H::Motion::<f64, Compensated<f64>>::load(&[&parameters], &[&state]);
    for step in 0..steps {
        let mut time = t0 + step as f64 * h;
        H::begin_step::<f64, Compensated<f64>>(&mut motion, time + h / 2.0);
        for fraction in fractions {
            verlet::<H>(&mut Single::<H, f64, Compensated<f64>>(&mut motion), fraction * h, time);
            time += fraction * h;
        }
        motion.store(0, &mut state);
        show(flat(&state));
    }
}

/// Drift, kick, drift from `time`, with the parts between them.
fn verlet<H: Hamiltonian>(flows: &mut impl Flows<H>, h: f64, time: f64) {
    flows.drift(h / 2.0, time);
    flows.middle(h / 2.0, false);
    flows.kick(h, time + h / 2.0);
    flows.middle(h / 2.0, true);
    flows.drift(h / 2.0, time + h);
}

/// The fractions of a step over which Verlet is applied to gain order 8: five copies of the step of order p, with
/// weights g, g, 1 - 4g, g, g and g = 1/(4 - 4^(1/(p+1))), have order p + 2 (Suzuki 1990). A formula has no digits to
/// mistype, and no weight is larger than a seventh.
fn weights() -> Vec<f64> {
    [2.0, 4.0, 6.0].into_iter().fold(vec![1.0], |weights, order: f64| {
        let outer = 1.0 / (4.0 - 4.0_f64.powf(1.0 / (order + 1.0)));
        let scaled = |factor: f64| weights.iter().map(move |weight| weight * factor);
        scaled(outer)
            .chain(scaled(outer))
            .chain(scaled(1.0 - 4.0 * outer))
            .chain(scaled(outer))
            .chain(scaled(outer))
            .collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_cancel_the_errors_of_verlet() {
        let weights = weights();
        assert_eq!(weights.len(), 125);
        assert!(weights.iter().eq(weights.iter().rev()), "a palindrome has no errors of even degree");
        let moment = |power| weights.iter().map(|weight| weight.powi(power)).sum::<f64>();
        assert!(within(moment(1) - 1.0, 125.0 * f64::EPSILON), "one rounding for each term of the sum");
        for power in [3, 5, 7] {
            // Necessary at orders 4, 6 and 8: the error of Verlet of that degree, summed over the step.
            assert!(within(moment(power), 8.0 * f64::EPSILON), "degree {power}: {:e}", moment(power));
        }
    }
}
