//! The reference: the motion that a method is measured against.
//!
//! In: a system, a start, a time. Out: the exact motion, with an estimate of the error that is left. It is a Taylor
//! series for a system with recurrences, and a composition of its flows for others. Always true: neither the catalogue
//! nor the executor of runs is involved, so that a wrong coefficient or a wrong time in one of them cannot hide by
//! standing on both sides; in particular, a composition that converges to another motion is noticed.
//!
//! A series is trusted as far as the flows confirm it. It knows nothing of what lies beyond a branch, nor of a force
//! whose first derivatives all vanish, and recurrences may be those of another motion. Whether flows are those of the
//! energies is what the check of gradients measures.

use crate::{
    check::{
        oracle::{composed_reference::ComposedReference, exact::Exact},
        start::Start,
        statistics::path::{Path, Scale},
    },
    methods::taylor::Taylor,
    scalar::tolerance::within,
};
use std::ops::RangeInclusive;

/// The error, in units of the excursion, up to which flows in coarse steps are taken to follow the motion. Halving the
/// steps then leaves little of it, so that what is left is less than what changed.
const FOLLOWED: f64 = 0.1;

/// The fraction of the state that the last coefficients add, of the series and of the one that it is compared with.
/// Both are far below the rounding; polynomials of the second begin at other times, for its steps have another length. Their
/// orders are below those of least work, since what rounds is fewer and shorter terms.
const SERIES: [(f64, usize); 2] = [(1e-20, 25), (1e-18, 22)];

/// The samples in each part of a series for its excursion. A prime, so that a periodic motion is not back at its start
/// at each of them.
const SAMPLES: u64 = 251;

/// The tolerance of composed flows in roundings, beside what refining them changes. Its durations add up to nine times
/// the time, forth and back, and each is rounded as a weight, as a product with the step, and in what its flow adds.
const ROUNDINGS: f64 = 32.0;

/// The exact motion as far as it is known.
pub(crate) struct Reference {
    pub(crate) path: Path,
    /// The motion that it is compared with: of composed flows, the next coarser one.
    ///
    /// Of a series, another one. A compensated state loses nothing, so that the errors of a series are these: each
    /// expansion begins at a state that is rounded to half an ε, which changes its force by as much, and sums of
    /// coefficients are off by a few ε of what they add. Both are stretched by the flow from there on, which no bound
    /// known beforehand covers. The other series rounds at other states, so that its errors are as large and
    /// independent: the root of the mean square of the differences, over four times and all coordinates, is √2 of those
    /// of one. What truncation leaves is 100 times larger in the other one. Over less than an expansion both round
    /// alike, by little more than one rounding of a state.
    pub(crate) other: Path,
    /// The excursion of the motion, sampled at more times than the ends of the path.
    pub(crate) scale: Scale,
}

impl Reference {
    /// Halves the steps that `path` takes, until the two finest motions have settled or the steps are the finest ones.
    pub(crate) fn refined(
        steps: RangeInclusive<u64>,
        path: impl Fn(u64) -> (Path, Scale),
        mut settled: impl FnMut(&Self) -> bool,
    ) -> Self {
        let (mut steps, finest) = steps.into_inner();
        let (mut other, _) = path(steps);
        loop {
            steps *= 2;
            let (path, scale) = path(steps);
            let reference = Self { path, other, scale };
            if settled(&reference) || 2 * steps > finest {
                return reference;
            }
            other = reference.path;
        }
    }

    /// The distance of the two: above the error, for composed flows of any order.
    pub(crate) fn uncertainty(&self) -> f64 {
        self.path.distance(&self.other, self.scale)
    }

    /// The distance that one rounding of every coordinate makes.
    pub(crate) fn rounding(&self) -> f64 {
        self.path.rounding(self.scale)
    }
}

/// The motion of `system` from `start` over `span`, of which a run takes `whole` steps in each part.
pub(crate) fn reference(
    system: &dyn Exact,
    start: &Start<Vec<f64>>,
    span: f64,
    whole: u64,
    halvings: i32,
) -> Reference {
    let composed = || ComposedReference::new(system, start).within_steps(whole).refined(span);
    series_reference(system, start, span, halvings).unwrap_or_else(composed)
}

/// The reference by a series, if there is one and the flows confirm it.
///
/// It is confirmed over each of `span`, its half, its quarter, ... that flows follow in coarse steps, down to the one
/// that they follow to the rounding: the long ones cover more, and the short ones are more exact. The time is halved
/// `halvings` times at most, which bounds the number of expansions. A polynomial does not know of pieces in time.
pub(crate) fn series_reference(
    system: &dyn Exact,
    start: &Start<Vec<f64>>,
    span: f64,
    halvings: i32,
) -> Option<Reference> {
    if system.is_expanded() && !system.piecewise_in_time() {
        confirmed_series(system, start, &ComposedReference::new(system, start), span, halvings)
    } else {
        None
    }
}

/// A series that flows confirm.
fn confirmed_series(
    expanded: &dyn Exact,
    start: &Start<Vec<f64>>,
    composed: &ComposedReference<'_>,
    span: f64,
    halvings: i32,
) -> Option<Reference> {
    let series = |span, method, samples| expanded.series(start, span, method, samples);
    let [finer, other] = SERIES.map(|(tolerance, order)| Taylor::tolerance(tolerance).with_order(order));
    let mut is_confirmed = false;
    for halving in 0..=halvings {
        let time = span / 2.0_f64.powi(halving);
        let flows = composed.coarse(time);
        let (uncertainty, rounding) = (flows.uncertainty(), flows.rounding());
        if !within(uncertainty, FOLLOWED) {
            continue;
        }
        let apart = series(time, finer, 1)?.0.distance(&flows.path, flows.scale);
        if !within(apart, uncertainty + ROUNDINGS * rounding) {
            return None;
        }
        is_confirmed = true;
        if within(uncertainty, rounding) {
            break;
        }
    }
    if !is_confirmed {
        return None;
    }
    let ((path, scale), (other, _)) = (series(span, finer, SAMPLES)?, series(span, other, 1)?);
    Some(Reference { path, other, scale })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        check::oracle::exact::Motions,
        hamiltonian,
        hamiltonian::Hamiltonian,
        state::{flat::flat, phase::Phase},
    };

    struct Pendulum {
        gravity: f64,
    }

    #[hamiltonian(taylor)]
    impl Pendulum {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            -self.gravity * q[0].cos()
        }
    }

    struct Kepler;

    #[hamiltonian(taylor)]
    impl Kepler {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0
        }
        fn potential(&self, q: [f64; 2]) -> f64 {
            -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
        }
    }

    struct Driven;

    #[hamiltonian(taylor)]
    impl Driven {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1], t: f64) -> f64 {
            -(1.0 + 0.5 * (2.0 * t).cos()) * q[0].cos()
        }
    }

    struct Chain;

    #[hamiltonian(taylor)]
    impl Chain {
        fn kinetic(&self, p: &[f64]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: &[f64]) -> f64 {
            let mut sum = 0.0;
            for i in 1..q.len() {
                let stretch = q[i] - q[i - 1];
                sum += stretch * stretch / 2.0 + stretch.powi(4) / 4.0;
            }
            sum
        }
    }

    /// A potential whose derivatives at zero vanish up to the 39th.
    struct Blind;

    #[hamiltonian(taylor)]
    impl Blind {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            q[0].powi(40)
        }
    }

    fn agree<H: Hamiltonian>(system: &H, start: Phase<H::Coords>) {
        let (system, start) = (&Motions { system, shape: &start }, flat(&start).at_time(0.0));
        for span in [0.1, 1.0, 5.0, 20.0, -20.0] {
            let series = series_reference(system, &start, span, 8).expect("a series");
            let flows = ComposedReference::new(system, &start).refined(span);
            let apart = series.path.distance(&flows.path, flows.scale);
            // Each unit of time is about a period, and rounds as much as the first one.
            let rounding = ROUNDINGS * (flows.rounding() + f64::EPSILON * span.abs());
            let bound = series.uncertainty() + flows.uncertainty() + rounding;
            assert!(within(apart, bound), "{} over {span}: {apart:e}, {bound:e}", std::any::type_name::<H>());
            // Some sixty expansions over three periods round the state. They add up as a random walk to eight roundings, which
            // motions without an instability stretch up to fourfold.
            assert!(within(series.uncertainty(), 32.0 * f64::EPSILON), "{:e}", series.uncertainty());
        }
    }

    #[test]
    fn series_and_flows_lead_to_the_same_states() {
        agree(&Pendulum { gravity: 1.0 }, Phase::new([2.0], [0.0]));
        agree(&Kepler, Phase::new([0.4, 0.0], [0.0, 2.0]));
        agree(&Driven, Phase::new([1.0], [0.0]));
        agree(&Chain, Phase::new(vec![0.0, 1.0, 0.5, -0.25], vec![0.0, 0.1, 0.0, 0.3]));
    }

    #[test]
    fn a_series_of_another_system_is_not_trusted() {
        let shape = &Phase::new([2.0], [0.0]);
        let start = flat(shape).at_time(0.0);
        let (system, heavier) = (Pendulum { gravity: 1.0 }, Pendulum { gravity: 1.0 + 1e-9 });
        let trusted = |of: &Pendulum, span| {
            let [of, flows] = [of, &system].map(|system| Motions { system, shape });
            confirmed_series(&of, &start, &ComposedReference::new(&flows, &start), span, 20).is_some()
        };
        for span in [1.0, 5.0, 1e4] {
            assert!(trusted(&system, span) && !trusted(&heavier, span), "{span}");
        }
    }

    #[test]
    fn flows_lead_where_a_series_is_blind() {
        let shape = &Phase::new([0.0], [1.0]);
        let (system, start) = (&Motions { system: &Blind, shape }, flat(shape).at_time(0.0));
        for span in [4.0, 400.0] {
            assert!(system.series(&start, span, Taylor::tolerance(1e-20), 1).is_some());
            assert!(series_reference(system, &start, span, 20).is_none());
        }
        let (found, composed) =
            (reference(system, &start, 4.0, 1, 8), ComposedReference::new(system, &start).refined(4.0));
        assert_eq!(found.path.ends, composed.path.ends);
    }

    #[test]
    fn a_long_time_is_known_by_series_alone() {
        let shape = &Phase::new([0.4, 0.0], [0.0, 2.0]);
        let (system, start) = (&Motions { system: &Kepler, shape }, flat(shape).at_time(0.0));
        let uncertainty = |halvings| reference(system, &start, 1e3, 1, halvings).uncertainty();
        // A rounding of the energy shifts the phase ever more: by 1e-16 in each of some thousand steps, times the time.
        assert!(within(uncertainty(20), 1e-16 * 1e3 * 1e3), "{:e}", uncertainty(20));
        assert!(!within(uncertainty(0), FOLLOWED), "{:e}", uncertainty(0));
    }
}
