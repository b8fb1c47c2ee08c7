//! Inner steps: the last part of H is integrated by a composition of its own, several steps for each of its stages.
//!
//! In the molecular literature these are multiple time steps (r-RESPA; Tuckerman, Berne and Martyna 1992, J. Chem. Phys. 97,
//! 1990), in the astronomical one embedded splittings (Rein 2020, MNRAS 492, 5413).
//!
//! A stage of duration `d` takes `n` inner steps of `d/n`. Inner stages merge across inner steps, but not across stages; a
//! composition that begins and ends with the nested part therefore takes its steps one by one.
//! Inner time begins at the sum of the durations of earlier stages of the same part.

use crate::{
    composition::{Composition, Scheme, admits, inner_durations::Durations},
    scalar::real::Real,
    state::precision::Precision,
    system::{StatedEnergy, System, flows::Together, inner_steps::InnerSteps},
};
use core::{convert::Infallible, marker::PhantomData};

impl InnerSteps {
    /// Returns the facts of parts that take this number of steps with a composition.
    pub const fn of<X: Scheme>(steps: u32, parts: &'static [&'static str]) -> Self {
        Self {
            steps,
            parts,
            order: X::ORDER,
            orders_over_inner: X::ORDERS_OVER_INNER,
            symmetric: X::SYMMETRIC,
            stability_limit: X::STABILITY_LIMIT,
            flows: X::STAGES.flows_of_cycle(),
            closing: X::STAGES.flows_of_closing(),
            roundings: 2 * X::STAGES.cycle.len() + 1,
        }
    }
}

/// A system whose last part takes inner steps; where parts in these take inner steps again, one implementation per level.
///
/// `#[hamiltonian]` implements this trait for `split = slow + 8 * (bonds + kinetic)`.
#[diagnostic::on_unimplemented(
    message = "no part of `{Self}` takes inner steps",
    label = "has no inner steps",
    note = "write, for example, `#[hamiltonian(split = slow + 8 * (bonds + kinetic))]`"
)]
pub trait Nested<const LEVEL: usize>: System {
    /// The inner composition.
    type Inner: Composition<InnerParts<Self, LEVEL>>;

    /// Returns the number of inner steps.
    fn steps<R: Real, K: Precision>(motion: &Self::Motion<R, K>) -> usize;
    /// Applies the flow of the first part in the parentheses.
    fn inner_drift<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// Applies the flows of the parts between the first and the last, in their order or backwards.
    fn inner_middle<R: Real, K: Precision>(_: &mut Self::Motion<R, K>, _duration: f64, _time: f64, _backwards: bool) {}
    /// Applies the flow of the last part in the parentheses.
    fn inner_kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64);
    /// Applies the flow of the last part in the parentheses to several motions.
    #[inline(always)]
    fn inner_kick_together<R: Real, K: Precision, const N: usize>(
        motions: &mut [Self::Motion<R, K>; N],
        duration: f64,
        time: f64,
    ) {
        for motion in motions {
            Self::inner_kick::<R, K>(motion, duration, time);
        }
    }
}

/// The parts of `H` in the parentheses of a level, as a system that compositions integrate. It has no values, and no energy of
/// its own.
pub struct InnerParts<H, const LEVEL: usize>(PhantomData<fn(H)>, Infallible);

impl<H: Nested<LEVEL>, const LEVEL: usize> System for InnerParts<H, LEVEL> {
    type Coords = H::Coords;
    type Parameters<R: Real> = H::Parameters<R>;
    type Motion<R: Real, K: Precision> = H::Motion<R, K>;

    const PARTS: &'static [&'static str] = H::NESTED[LEVEL].parts;
    const NESTED: &'static [InnerSteps] = H::NESTED.split_at(LEVEL + 1).1;
    const SEPARABLE: bool = false;
    const AUTONOMOUS: bool = H::AUTONOMOUS;

    fn parameters(&self, _length: usize) -> Self::Parameters<f64> {
        match self.1 {}
    }
    #[inline(always)]
    fn drift<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64) {
        H::inner_drift::<R, K>(motion, duration, time);
    }
    #[inline(always)]
    fn middle<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64, backwards: bool) {
        H::inner_middle::<R, K>(motion, duration, time, backwards);
    }
    #[inline(always)]
    fn kick<R: Real, K: Precision>(motion: &mut Self::Motion<R, K>, duration: f64, time: f64) {
        H::inner_kick::<R, K>(motion, duration, time);
    }
    #[inline(always)]
    fn kick_together<R: Real, K: Precision, const N: usize>(
        motions: &mut [Self::Motion<R, K>; N],
        duration: f64,
        time: f64,
    ) {
        H::inner_kick_together::<R, K, N>(motions, duration, time);
    }
    fn kinetic<R: Real, K: Precision>(_: &Self::Motion<R, K>, _time: f64) -> R {
        R::of(f64::NAN)
    }
    fn potential<R: Real, K: Precision>(_: &Self::Motion<R, K>, _time: f64) -> R {
        R::of(f64::NAN)
    }
    fn stated(&self, _: &Self::Coords, _: &Self::Coords, _time: f64) -> StatedEnergy {
        match self.1 {}
    }
}

/// Takes the inner steps of a level that integrate its parts for `duration`, with several motions stage by stage.
#[inline(always)]
pub fn inner_steps<H: Nested<LEVEL>, const LEVEL: usize, R: Real, K: Precision, const N: usize>(
    motions: &mut [H::Motion<R, K>; N],
    duration: f64,
    time: f64,
) {
    const {
        if LEVEL + 1 < H::NESTED.len() {
            admits_nested::<H::Inner>();
        } else {
            admits_inner::<H::Inner>(H::NESTED[LEVEL].parts.len());
        }
    }
    let Some(steps) = motions.first().map(H::steps::<R, K>) else { return };
    let durations = Durations::of(duration, steps, K::COMPENSATED);
    let flows = &mut Together::<InnerParts<H, LEVEL>, R, K, N>(motions);
    let begin = |step: usize| time + durations.each * step as f64;
    if const { <H::Inner as Scheme>::STAGES.are_whole::<InnerParts<H, LEVEL>>() } {
        for step in 0..steps {
            H::Inner::open(flows, durations.of_step(step), begin(step));
            H::Inner::complete(flows, durations.of_step(step), begin(step));
        }
        return;
    }
    if const { H::LARGE_FLOWS } {
        // Inlined once: the first stage of all differs by its coefficients alone.
        let stages = const { &<H::Inner as Scheme>::STAGES };
        for step in 0..steps {
            for (number, stage) in stages.cycle.iter().enumerate() {
                let stage = if step == 0 && number == 0 { &stages.opening } else { stage };
                H::Inner::stage(flows, stage, durations.of_step(step), begin(step));
            }
        }
    } else {
        H::Inner::open(flows, durations.of_step(0), time);
        for step in 1..steps {
            H::Inner::cycle(flows, durations.of_step(step), begin(step));
        }
    }
    let last = steps.saturating_sub(1);
    H::Inner::complete(flows, durations.of_step(last), begin(last));
}

/// Checks, in a constant, that a composition can integrate two parts if the last one takes inner steps.
///
/// # Panics
/// If it cannot: a compile error, because the call is in a constant.
pub const fn admits_nested<X: Scheme>() {
    assert!(
        X::PROCESSOR.before.rows.is_empty(),
        "this composition has a processor, which does not support inner steps; use a composition such as `Verlet`, `Yoshida4` \
         or `Aba864`"
    );
}

/// Checks, in a constant, that a composition can integrate this number of parts in inner steps.
///
/// # Panics
/// If it cannot: a compile error, because the call is in a constant.
pub const fn admits_inner<X: Scheme>(parts: usize) {
    assert!(
        X::PROCESSOR.before.rows.is_empty(),
        "this composition has a processor, which inner steps do not support; use a composition such as `Verlet`, `Yoshida4` \
         or `BlanesMoan4`"
    );
    admits::<X>(parts);
}

/// A composition with a number of inner steps that replaces that of the annotation: [`Scheme::nested`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WithInnerSteps<X> {
    pub(crate) composition: X,
    pub(crate) steps: u32,
}

/// The order of a composition whose second part takes inner steps of this order.
const fn order_over(own: u32, over: [u32; 4], inner: u32, symmetric: bool) -> u32 {
    match inner {
        2 | 4 | 6 | 8 if symmetric => over[inner as usize / 2 - 1],
        _ if inner < own => inner,
        _ => own,
    }
}

/// The order of the flows of these levels, and whether they are symmetric. Those of the innermost parts are exact.
const fn order_of_levels(levels: &[InnerSteps]) -> (u32, bool) {
    let Some((outer, inner)) = levels.split_first() else { return (u32::MAX, true) };
    let (order, symmetric) = order_of_levels(inner);
    (order_over(outer.order, outer.orders_over_inner, order, symmetric), symmetric && outer.symmetric)
}

/// The order of a step by a composition whose second part takes inner steps at these levels.
pub(crate) const fn order_of_step<X: Scheme>(levels: &[InnerSteps]) -> u32 {
    let (order, symmetric) = order_of_levels(levels);
    order_over(X::ORDER, X::ORDERS_OVER_INNER, order, symmetric)
}

/// The properties of a step of `H` whose last part takes inner steps.
pub(crate) struct Composed {
    /// The order of the whole step.
    pub(crate) order: u32,
    /// Whether a step by `-h` undoes a step by `h`.
    pub(crate) symmetric: bool,
    /// The number of times that a step rounds the state.
    pub(crate) roundings: usize,
    /// The number of innermost steps in a step.
    pub(crate) innermost: f64,
    /// The stability limit of an innermost step.
    pub(crate) stability_limit: f64,
}

impl Composed {
    /// The properties of a step by a composition, with this number of inner steps in place of that of the annotation.
    pub(crate) fn of<H: System, X: Scheme>(steps: Option<u32>) -> Self {
        let (mut roundings, mut innermost) = (2 * X::STAGES.cycle.len() + 1, 1.0);
        for (level, inner) in H::NESTED.iter().enumerate() {
            let taken = steps.filter(|_| level == 0).unwrap_or(inner.steps);
            roundings = roundings.saturating_mul(taken as usize).saturating_mul(inner.roundings);
            innermost *= f64::from(taken);
        }
        Self {
            order: order_of_step::<X>(H::NESTED),
            symmetric: X::SYMMETRIC && H::NESTED.iter().all(|inner| inner.symmetric),
            roundings,
            innermost,
            stability_limit: H::NESTED.last().map_or(f64::INFINITY, |innermost| innermost.stability_limit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::composition::catalogue::{BlanesMoan4, Yoshida4};

    #[test]
    fn the_order_is_the_lower_one_unless_errors_cancel() {
        let (blanes_moan, yoshida) = (BlanesMoan4::ORDERS_OVER_INNER, Yoshida4::ORDERS_OVER_INNER);
        assert_eq!([2, 4, 6].map(|inner| order_over(4, blanes_moan, inner, true)), [2, 4, 4]);
        // A composition of whole steps of Verlet.
        assert_eq!([2, 4, 6].map(|inner| order_over(4, yoshida, inner, true)), [4, 4, 4]);
        assert_eq!([1, 2, 3, 7, 10].map(|inner| order_over(4, yoshida, inner, false)), [1, 2, 3, 4, 4]);
    }
}
