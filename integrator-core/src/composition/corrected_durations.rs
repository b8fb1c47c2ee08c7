//! Corrected durations: the stages of a compensated run add up to the step, however often it is taken.
//!
//! The stages of a step last `h·a`, rounded, and their sum misses `h` by the duration residual, about ε/10 of it, in
//! every step the same: a clock that is a little fast or slow. One stage is longer in some cycles (error diffusion, as
//! in Bresenham's lines), by an amount that it can be lengthened by without a rounding.
//!
//! Always true: which cycles these are depends on their number alone, so that portions, samples and checkpoints change
//! nothing; and after `n` steps the sum of all durations is off by at most one correction.

use crate::{
    composition::{Processor, Scheme, Stage, Stages},
    scalar::exact::two_sum,
    system::{QuadraticKinetic, System, flows::Flows},
};
use core::mem::take;

/// 2^64.
const MODULUS: f64 = 18_446_744_073_709_551_616.0;

/// The correction of a stage: by how much it is longer, and how often.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Correction {
    longer: f64,
    /// The fraction of the cycles, in units of 2^-64.
    frequency: u64,
}

impl Correction {
    const NONE: Self = Self { longer: 0.0, frequency: 0 };

    /// The correction of the first of the durations `h·a`, with the fractions `a`.
    ///
    /// Fractions and durations are rounded once each. Where the residual is larger than that explains, the composition
    /// is wrong, and nothing may hide it.
    fn new(h: f64, mut fractions: impl Iterator<Item = f64> + Clone) -> Self {
        let residual = residual(h, fractions.clone());
        let explained = f64::EPSILON * fractions.clone().map(|fraction| (h * fraction).abs()).sum::<f64>();
        let first = h * fractions.next().unwrap_or(0.0);
        if residual == 0.0 || !residual.is_finite() || residual.abs() > explained {
            return Self::NONE;
        }
        // The least correction is the spacing of numbers at the first stage's duration, or more where that is short.
        // The stage will last what the sum rounds to, so that the difference is the correction.
        let mut least = f64::from_bits(first.abs().to_bits() + 1) - first.abs();
        let mut longer = 0.0_f64;
        while longer.abs() < residual.abs() {
            longer = (first + least.copysign(residual)) - first;
            least *= 2.0;
        }
        if longer.is_finite() { Self { longer, frequency: (residual / longer * MODULUS) as u64 } } else { Self::NONE }
    }

    /// The correction in the cycle of this number, counted from 1: not zero where the multiple of the frequency passes
    /// an integer. As bits, because flows take all floating-point registers.
    #[inline(always)]
    fn of(&self, cycle: u64) -> u64 {
        let passes = u64::from(cycle.wrapping_mul(self.frequency) < self.frequency);
        self.longer.to_bits() & passes.wrapping_neg()
    }
}

/// The duration residual: `h` less the rounded durations `h·a` of all fractions `a`, in double-double.
fn residual(h: f64, fractions: impl Iterator<Item = f64>) -> f64 {
    let (mut left, mut errors) = (h, 0.0);
    for fraction in fractions {
        let [difference, lost] = two_sum(left, -(h * fraction));
        (left, errors) = (difference, errors + lost);
    }
    left + errors
}

/// The flows that a system has between its first part and its last.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Between {
    Nothing,
    /// Flows between drifts and kicks.
    Flows,
    /// Flows around each kick, half of its duration before it and half after it.
    Pair,
    /// Nothing, and the kick takes inner steps.
    InnerSteps,
}

impl Between {
    pub(crate) const fn of<H: System>() -> Self {
        match (H::PARTS.len(), H::PAIRED) {
            _ if !H::NESTED.is_empty() => Self::InnerSteps,
            (..=2, _) => Self::Nothing,
            (_, false) => Self::Flows,
            (_, true) => Self::Pair,
        }
    }
}

/// The corrections of a composition's drifts and kicks with a step, and of what is between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corrections {
    drift: Correction,
    kick: Correction,
    middle: Correction,
}

impl Corrections {
    pub(crate) const NONE: Self = Self { drift: Correction::NONE, kick: Correction::NONE, middle: Correction::NONE };

    /// The corrections of stages that are merged across steps.
    pub(crate) fn new(stages: &Stages, h: f64, between: Between) -> Self {
        Self::of(h, stages.cycle.iter(), between)
    }

    /// The corrections of steps that are taken one by one, each with its processor.
    pub(crate) fn of_whole_steps(stages: &Stages, processor: &Processor, h: f64, between: Between) -> Self {
        let (before, after) = (processor.before.rows.iter(), processor.after.rows.iter());
        let step = [&stages.opening].into_iter().chain(&stages.cycle[1..]).chain([&stages.closing]);
        Self::of(h, before.chain(step).chain(after), between)
    }

    fn of<'s>(h: f64, stages: impl Iterator<Item = &'s Stage> + Clone, between: Between) -> Self {
        let middle = stages.clone();
        Self {
            drift: Correction::new(h, stages.clone().map(|stage| stage.drift)),
            kick: Correction::new(h, stages.map(|stage| stage.kick)),
            middle: match between {
                Between::Nothing | Between::InnerSteps => Correction::NONE,
                Between::Flows => Correction::new(h, middle.flat_map(|stage| stage.middle)),
                Between::Pair => Correction::new(h, middle.flat_map(|stage| [stage.kick / 2.0; 2])),
            },
        }
    }

    /// Whether there are no corrections, because the durations add up as they are.
    pub(crate) fn none(&self) -> bool {
        *self == Self::NONE
    }

    /// The flows for the cycle of this number.
    #[inline(always)]
    pub(crate) fn on<'f, F>(&self, flows: &'f mut F, cycle: u64) -> Corrected<'f, F> {
        Corrected { flows, drift: self.drift.of(cycle), kick: self.kick.of(cycle), middle: self.middle.of(cycle) }
    }
}

/// Returns the corrections of the durations of drifts, kicks and the flows between them in a compensated run with step
/// `h`, each with the fraction of cycles that it applies to, in units of 2^-64: for executors that loop elsewhere.
pub fn corrections<H: System, X: Scheme>(h: f64) -> [(f64, u64); 3] {
    let between = Between::of::<H>();
    let Corrections { drift, kick, middle } = match X::STAGES.are_whole::<H>() {
        true => Corrections::of_whole_steps(&X::STAGES, &X::PROCESSOR, h, between),
        false => Corrections::new(&X::STAGES, h, between),
    };
    [drift, kick, middle].map(|Correction { longer, frequency }| (longer, frequency))
}

/// Flows in one cycle, the first of each kind of which is longer by its correction.
pub(crate) struct Corrected<'f, F> {
    flows: &'f mut F,
    drift: u64,
    kick: u64,
    middle: u64,
}

impl<F: Flows<H>, H: System> Flows<H> for Corrected<'_, F> {
    const COMPENSATED: bool = F::COMPENSATED;

    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        self.flows.begin_step(middle);
    }
    #[inline(always)]
    fn drift(&mut self, duration: f64, time: f64) {
        self.flows.drift(duration + f64::from_bits(take(&mut self.drift)), time);
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, time: f64) {
        self.flows.kick(duration + f64::from_bits(take(&mut self.kick)), time);
    }
    #[inline(always)]
    fn middle(&mut self, duration: f64, time: f64, backwards: bool) {
        self.flows.middle(duration + f64::from_bits(take(&mut self.middle)), time, backwards);
    }
    #[inline(always)]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        self.flows.gradient_kick(duration + f64::from_bits(take(&mut self.kick)), gradient, time);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Composition, Phase,
        composition::{Scheme, catalogue::*, catalogue_list::for_each_composition},
    };
    use dashu_float::{FBig, round::mode::HalfEven};

    type Big = FBig<HalfEven, 2>;

    fn big(x: f64) -> Big {
        Big::try_from(x).expect("a finite number").with_precision(400).value()
    }

    /// Returns the deviation of the durations of this number of cycles from `h` times as many, with corrections and
    /// without.
    fn off(h: f64, cycles: u64, fractions: &[f64]) -> [f64; 2] {
        let correction = Correction::new(h, fractions.iter().copied());
        let first = h * fractions[0];
        let rounded: Big = fractions.iter().map(|fraction| big(h * fraction)).sum();
        let without = (rounded - big(h)) * big(cycles as f64);
        let longer: Big =
            (1..=cycles).map(|cycle| big(first + f64::from_bits(correction.of(cycle))) - big(first)).sum();
        [without.clone() + longer, without].map(|sum| sum.to_f64().value())
    }

    #[test]
    fn durations_add_up_in_every_composition() {
        const CYCLES: u64 = 300;
        let mut drifting = 0;
        let mut check = |name: &str, stages: Stages| {
            let drifts: Vec<f64> = stages.cycle.iter().map(|stage| stage.drift).collect();
            let kicks: Vec<f64> = stages.cycle.iter().map(|stage| stage.kick).collect();
            let middle: Vec<f64> = stages.cycle.iter().flat_map(|stage| stage.middle).collect();
            for h in [0.1, -0.1, 1.0 / 3.0, 1e-3, 7e10, 1e-300] {
                for fractions in [&drifts, &kicks, &middle] {
                    let longer = Correction::new(h, fractions.iter().copied()).longer.abs();
                    let [off, without] = off(h, CYCLES, fractions);
                    assert!(off.abs() <= longer, "{name} with h = {h:e} is off by {off:e}, {longer:e} at a time");
                    drifting += u32::from(without.abs() > 10.0 * longer);
                }
            }
        };
        macro_rules! each {
            ($($composition:ident)*) => {$( check($composition::NAME, $composition::STAGES); )*};
        }
        for_each_composition!(general: each!);
        for_each_composition!(quadratic: each!);
        assert!(drifting > 100, "without corrections, {drifting} sums are off by more than ten of them");
    }

    struct Oscillator;

    #[crate::hamiltonian]
    impl Oscillator {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            q[0] * q[0] / 2.0
        }
    }

    /// The flows of the oscillator on the columns of a matrix of many digits.
    #[derive(Clone)]
    struct Exact([[Big; 2]; 2]);

    impl Exact {
        fn one() -> Self {
            Self([[big(1.0), big(0.0)], [big(0.0), big(1.0)]])
        }
        /// Adds a multiple of one row to the other.
        fn shear(&mut self, to: usize, factor: Big) {
            for column in 0..2 {
                let added = factor.clone() * self.0[1 - to][column].clone();
                self.0[to][column] += added;
            }
        }
        fn after(&self, first: &Self) -> Self {
            let entry = |row: usize, column: usize| {
                let term = |k: usize| self.0[row][k].clone() * first.0[k][column].clone();
                term(0) + term(1)
            };
            Self([[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]])
        }
        fn power(&self, mut exponent: u64) -> Self {
            let (mut power, mut result) = (self.clone(), Self::one());
            while exponent > 0 {
                if exponent % 2 == 1 {
                    result = power.after(&result);
                }
                power = power.after(&power);
                exponent /= 2;
            }
            result
        }
    }

    impl Flows<Oscillator> for Exact {
        const COMPENSATED: bool = true;

        fn drift(&mut self, duration: f64, _time: f64) {
            self.shear(0, big(duration));
        }
        fn kick(&mut self, duration: f64, _time: f64) {
            self.shear(1, big(-duration));
        }
        fn middle(&mut self, _duration: f64, _time: f64, _backwards: bool) {}
        fn gradient_kick(&mut self, duration: f64, gradient: f64, _time: f64) {
            // |∇V|² = q².
            self.shear(1, big(-duration) - big(2.0 * gradient));
        }
    }

    /// By how much an oscillator is off after this number of steps from (1, 0), first as it runs and then with
    /// durations that are rounded as they are, from one whose durations add up to the step.
    fn errors<X: Composition<Oscillator>>(composition: X, h: f64, steps: u64) -> [f64; 2] {
        let start = Phase::compensated([1.0], [0.0]);
        let mut run = crate::Hamiltonian::run_with(&Oscillator, composition, start, h).expect("a start");
        run.advance(steps).expect("finite");
        let Phase { q: [q], p: [p] } = run.state();
        let exact = |residual: [f64; 2]| {
            let (mut open, mut cycle, mut close) = (Exact::one(), Exact::one(), Exact::one());
            X::open(&mut open, h, 0.0);
            X::cycle(&mut cycle, h, 0.0);
            // Where in the step it goes changes the motion by `h` times as little.
            cycle.shear(0, big(residual[0]));
            cycle.shear(1, big(-residual[1]));
            X::close(&mut close, h, 0.0);
            close.after(&cycle.power(steps - 1)).after(&open)
        };
        let [drifts, kicks] = [|stage: &Stage| stage.drift, |stage: &Stage| stage.kick];
        let punctual =
            exact([residual(h, X::STAGES.cycle.iter().map(drifts)), residual(h, X::STAGES.cycle.iter().map(kicks))]);
        let rounded = exact([0.0; 2]);
        let off = |q: Big, p: Big| {
            let (q, p) = (q - punctual.0[0][0].clone(), p - punctual.0[1][0].clone());
            q.to_f64().value().hypot(p.to_f64().value())
        };
        [
            off(big(q.value) + big(q.carried), big(p.value) + big(p.carried)),
            off(rounded.0[0][0].clone(), rounded.0[1][0].clone()),
        ]
    }

    #[test]
    fn the_phase_of_a_compensated_oscillator_does_not_drift() {
        const STEPS: u64 = 1 << 20;
        let table = [
            ("Yoshida4", 0.3, errors(Yoshida4, 0.3, STEPS)),
            ("KahanLi8", 0.3, errors(KahanLi8, 0.3, STEPS)),
            ("Chin4A", 0.3, errors(Chin4A, 0.3, STEPS)),
        ];
        // What is left are the roundings of the kicks, some 1e-17 each, of which a random walk makes a thousand times
        // more.
        for (name, h, [run, rounded]) in table {
            assert!(run < rounded / 20.0, "{name} with h = {h} is off by {run:e}, and would be by {rounded:e}");
        }
    }

    #[test]
    fn extreme_durations_do_no_harm() {
        for h in [0.0, 5e-324, -5e-324, 1e-310, f64::MAX, -f64::MAX, f64::INFINITY, f64::NAN] {
            let Correction { longer, frequency } = Correction::new(h, [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0].into_iter());
            assert!(longer.is_finite(), "{h:e}: {longer:e} in {frequency}");
        }
        assert_eq!(Correction::new(0.1, [0.5, 0.5].into_iter()), Correction::NONE, "halves are exact");
        assert_eq!(Correction::new(0.1, [0.5, 0.4999].into_iter()), Correction::NONE, "a mistake stays one");
        assert_eq!(Correction::new(0.1, [].into_iter()).of(u64::MAX), 0, "nothing to lengthen");
    }
}
