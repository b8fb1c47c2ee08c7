//! The reference by composed flows: Suzuki's composition of eighth order, in steps that are halved until nothing but
//! rounding changes.
//!
//! Always true: neither the catalogue nor the executor of runs is involved.

use crate::{
    check::{
        flow::Flow,
        oracle::{exact::Exact, reference::Reference},
        start::Start,
        statistics::path::{PARTS, Path, Recorder, Scale},
    },
    hamiltonian::Hamiltonian,
    methods::implicit::field::{Constants, Pair, field},
    scalar::tolerance::within,
    state::{
        compensated::Compensated,
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
        precision::Slot,
    },
    system::{
        Shaped,
        motion::{Motion, Plain, Prepared},
    },
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

    /// Returns this reference with steps that divide those of a run with `whole` steps in a part: edges between
    /// pieces of the Hamiltonian lie where these end.
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
    if const { H::PARTS.is_empty() } {
        return midpoint_steps(system, Start { phase: start, time: t0 }, (h, steps), fractions, show);
    }
    let parameters = system.parameters(start.q.length());
    let mut state: Phase<Shaped<H, Compensated<f64>>> = Phase::compensated(start.q, start.p);
    let mut motion = H::Motion::<f64, Compensated<f64>>::load(&[&parameters], &[&state]);
    for step in 0..steps {
        let mut time = t0 + step as f64 * h;
        H::begin_step::<f64, Compensated<f64>>(&mut motion, time + h / 2.0);
        for fraction in fractions {
            verlet::<H>(&mut motion, fraction * h, time);
            time += fraction * h;
        }
        motion.store(0, &mut state);
        show(flat(&state));
    }
}

/// Takes the steps of [`composed_steps`] by implicit midpoint steps, for a system in one piece. They are symmetric and
/// of second order as well.
fn midpoint_steps<H: Hamiltonian>(
    system: &H,
    Start { phase: start, time: t0 }: Start<H::Coords>,
    (h, steps): (f64, u64),
    fractions: &[f64],
    show: &mut dyn FnMut(Flat),
) {
    let single = [system.parameters(start.q.length())];
    let mut gathered = H::Parameters::<f64>::gather(&[&single[0]]);
    let mut state: Phase<Shaped<H, Compensated<f64>>> = Phase::compensated(start.q.clone(), start.p.clone());
    let mut motion = Plain::<f64, Shaped<H, Compensated<f64>>, ()> {
        q: Coords::pack(&[&state], |state| &state.q),
        p: Coords::pack(&[&state], |state| &state.p),
        parameters: (),
    };
    for step in 0..steps {
        let mut time = t0 + step as f64 * h;
        gathered.begin_step(time + h / 2.0);
        let constants = Constants { gathered: &gathered, of_lanes: &single, shape: &start, middle: time + h / 2.0 };
        for fraction in fractions {
            midpoint::<H>(&constants, &mut motion, fraction * h, time);
            time += fraction * h;
        }
        state.q.unpack(&motion.q, 0);
        state.p.unpack(&motion.p, 0);
        show(flat(&state));
    }
}

/// The rounds after which a middle that still moves is no number: steps this long follow no motion.
const ROUNDS: usize = 64;

/// One such step from `time`. Its middle is found where an iteration no longer comes nearer.
fn midpoint<H: Hamiltonian>(
    constants: &Constants<'_, H, f64>,
    motion: &mut Plain<f64, Shaped<H, Compensated<f64>>, ()>,
    h: f64,
    time: f64,
) {
    let slots = [&mut motion.q, &mut motion.p].map(Shaped::<H, Compensated<f64>>::slots_mut);
    let values = slots.each_ref().map(|slots| slots.iter().map(|slot| slot.value()).collect::<Vec<f64>>());
    let mut middle = Pair::<H, f64>::zero(values[0].len());
    for (to, from) in middle.halves_mut().into_iter().zip(&values) {
        to.copy_from_slice(from);
    }
    let mut found = field::<H, f64>(constants, &middle, time + h / 2.0);
    let mut moved = f64::INFINITY;
    for round in 0..=ROUNDS {
        let mut now = 0.0_f64;
        for (half, to) in middle.halves_mut().into_iter().enumerate() {
            for (k, to) in to.iter_mut().enumerate() {
                let next = (h / 2.0).mul_add(found.halves()[half][k], values[half][k]);
                now = now.max((next - *to).abs());
                *to = if round == ROUNDS { f64::NAN } else { next };
            }
        }
        found = field::<H, f64>(constants, &middle, time + h / 2.0);
        if now >= moved {
            break;
        }
        moved = now;
    }
    for (slots, slopes) in slots.into_iter().zip(found.halves()) {
        for (slot, slope) in slots.iter_mut().zip(slopes) {
            slot.add(h * slope);
        }
    }
}

/// Drift, kick, drift from `time`, with the parts between them.
fn verlet<H: Hamiltonian>(motion: &mut H::Motion<f64, Compensated<f64>>, h: f64, time: f64) {
    let (half, middle) = (h / 2.0, time + h / 2.0);
    let flows = [
        (Flow::First, half, time),
        (Flow::Middle { backwards: false }, half, middle),
        (Flow::Last, h, middle),
        (Flow::Middle { backwards: true }, half, middle),
        (Flow::First, half, time + h),
    ];
    for (flow, duration, time) in &flows {
        flow.apply::<H, f64, Compensated<f64>>(motion, *duration, *time);
    }
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
