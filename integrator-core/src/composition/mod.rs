//! Compositions: proved, static tables of stages, the drifts and kicks of a step in their order.
//!
//! A table contains coefficients and is independent of systems; it needs only [`Flows`] of an executor.
//!
//! A table of drifts and kicks integrates any number of parts. Let `x₁, x₂, …` be the coefficients of its letters in
//! their order. The table is then a composition of `χ`, the flows of all parts in their order, and of its adjoint, with
//! `γ₁ = x₁` and `γₖ = xₖ − γₖ₋₁` (McLachlan 1995, SIAM J. Sci. Comput. 16, 151).
//!
//! The first part has the drifts and the last one the kicks. The parts between them flow for `γₖ` between the letters
//! `k` and `k + 1`, in their order before a kick and backwards before a drift.

pub(crate) mod catalogue;
pub(crate) mod catalogue_list;
pub(crate) mod corrected_durations;
pub(crate) mod flow_counts;
mod inner_durations;
pub(crate) mod inner_steps;
pub(crate) mod order_claim;
pub(crate) mod stage_rows;
pub(crate) mod visitor;

use crate::system::{System, flows::Flows};
use corrected_durations::Between;
use inner_steps::{WithInnerSteps, admits_nested};

/// A drift and a kick of a composition, as fractions of the step `h`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// `a` in the drift, the flow of `T` for a time `a·h`.
    pub drift: f64,
    /// `b` in the kick, the flow of `V` for a time `b·h`.
    pub kick: f64,
    /// `c` in the force-gradient kick with `b·V + c·h²·|∇V|²`; zero in a plain kick.
    pub gradient: f64,
    /// The time at which `T(p, t)` is evaluated, as a fraction of the step: the sum of the kicks before this drift.
    pub drift_time: f64,
    /// The time at which `V(q, t)` is evaluated, as a fraction of the step: the sum of the drifts before this kick.
    pub kick_time: f64,
    /// `γ` of the parts between the first and the last, if there are more than two parts.
    ///
    /// The first entry applies between the two flows of this stage, the second one between this stage and the next.
    pub middle: [f64; 2],
}

impl Stage {
    /// A stage without a drift or a kick.
    pub const NONE: Self =
        Self { drift: 0.0, kick: 0.0, gradient: 0.0, drift_time: 0.0, kick_time: 0.0, middle: [0.0; 2] };

    /// The force evaluations of the kick; one along the gradient of the squared force counts twice.
    pub(crate) const fn forces(&self) -> u64 {
        let has_gradient = self.gradient != 0.0;
        (self.kick != 0.0 || has_gradient) as u64 + has_gradient as u64
    }

    /// The time at which inner steps of this kick begin, as a fraction of the step: the sum of the kicks before it.
    pub(crate) fn inner_time(&self, lead: Lead) -> f64 {
        match lead {
            Lead::Drift => self.drift_time,
            Lead::Kick => self.drift_time - self.kick,
        }
    }
}

/// The flow that comes first in a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lead {
    /// `T` moves the positions, then `V` the momenta.
    Drift,
    /// `V` moves the momenta, then `T` the positions.
    Kick,
}

/// The stages of a composition, merged within a step and across steps.
///
/// A run keeps its state just before the last stage of a step. That stage and the first one of the next step are hence
/// merged.
///
/// - `opening`, then `cycle[1..]`, advance a start to this point.
/// - `cycle` advances from this point to the same point one step later.
/// - `closing` completes the step on a copy.
///
/// If the sequence begins and ends with different flows, nothing merges: `opening` is `cycle[0]` and `closing` is
/// [`Stage::NONE`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stages {
    /// The flow that comes first in every stage.
    pub lead: Lead,
    /// The first stage of the first step: `cycle[0]` without the flow that it has in common with the previous step.
    pub opening: Stage,
    /// One step, from just before its merged first stage.
    pub cycle: &'static [Stage],
    /// The leading flow that ends a step; the other flow of this stage is zero.
    pub closing: Stage,
}

impl Stages {
    /// Whether steps of `H` are taken one by one: a stage that is merged across steps would belong to two pieces of `H`, or would
    /// be the inner steps of two stages.
    pub(crate) const fn are_whole<H: System>(&self) -> bool {
        H::PIECEWISE_IN_TIME || (!H::NESTED.is_empty() && self.closing.kick != 0.0)
    }

    /// The number of force evaluations of a step that is not merged with others, with its processor.
    pub(crate) fn forces(&self, processor: &Processor) -> u64 {
        let step = [&self.opening].into_iter().chain(&self.cycle[1..]).chain([&self.closing]);
        let stages = processor.before.rows.iter().chain(step).chain(processor.after.rows);
        stages.map(Stage::forces).sum()
    }
}

/// A list of stages that are applied once: before the first step, or before an output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rows {
    /// The flow that comes first in every stage.
    pub lead: Lead,
    /// The stages.
    pub rows: &'static [Stage],
}

impl Rows {
    /// An empty list.
    pub const NONE: Self = Self { lead: Lead::Drift, rows: &[] };
}

/// A processor: stages that a processed composition applies once before its first step and inverts before each output.
///
/// For a processor `P` and a kernel `K`, `n` steps are `P`, then `n` times `K`, then the inverse of `P`. The map is
/// conjugate to `K`, hence symplectic if `K` is, at the cost of `K` alone.
///
/// The inverse acts on a copy, so an output never changes a run and never ends it: a run diverges only if `K` does. If
/// only the inverse diverges or leaves the domain of a potential, the output is the state after `K`. `P` is near the
/// identity, and its order has no meaning at such a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Processor {
    /// The stages of `P`.
    pub before: Rows,
    /// The stages of the inverse of `P`.
    pub after: Rows,
}

impl Processor {
    /// No processor.
    pub const NONE: Self = Self { before: Rows::NONE, after: Rows::NONE };
}

/// The class of Hamiltonians that a composition can integrate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Every `T(p)`, and any number of parts with exact flows.
    General,
    /// `T = ½ pᵀ M⁻¹ p` with a constant `M`.
    QuadraticKinetic,
}

/// The properties of a composition, proved when it is compiled. `composition!` implements this trait.
pub trait Scheme: Copy + Default + Send + Sync + 'static {
    /// The name in the declaration.
    const NAME: &'static str;
    /// The publication; empty if the declaration has no citation.
    const CITATION: &'static str;
    /// The order, proved from the order conditions.
    const ORDER: u32;
    /// The generalised orders `(n₁, n₂, …)` for `H = A + ε B`, where kicks integrate the small part `ε B`.
    ///
    /// Errors are of the sizes `ε hⁿ¹`, `ε² hⁿ²` and so on; the last order applies to all higher powers of `ε` (McLachlan
    /// 1995, BIT 35, 258). They are proved if the declaration claims them, as in `order (8, 4)`; otherwise this is
    /// [`ORDER`](Self::ORDER) only.
    const GENERALISED_ORDERS: &'static [u32] = &[Self::ORDER];
    /// Whether the orders hold if the last of two parts is itself a symmetric pair, `J/2 I J/2` for `J + I`.
    ///
    /// The error of such a pair is of third order in its duration. Compositions of order two keep their order; higher orders
    /// need further conditions, beginning with `Σ bᵢ³ = 0`, which are proved.
    const KEEPS_PAIRS: bool = Self::ORDER < 3;
    /// The orders if steps of a symmetric inner composition of order 2, 4, 6 or 8 integrate the last of two parts.
    ///
    /// Each kick consists of the same number of inner steps. An entry is the inner order or [`ORDER`](Self::ORDER),
    /// whichever is lower, unless the errors of the inner steps cancel. They cancel in compositions of `Verlet`, such as
    /// `Yoshida4` and `KahanLi8`.
    ///
    /// The entries are proved for compositions of general class. An entry above the inner order requires that the last kick
    /// of a step and the first kick of the next one are not merged.
    const ORDERS_OVER_INNER: [u32; 4] = lower_orders(Self::ORDER);
    /// Whether the sequence is a palindrome, so that a step by `-h` inverts a step by `h`.
    const SYMMETRIC: bool;
    /// The class of Hamiltonians that the composition can integrate.
    const CLASS: Class;
    /// Force evaluations per step, after merging across steps.
    const FORCE_EVALUATIONS: usize;
    /// Force-gradient kicks per step, each of which costs about one more force evaluation.
    const GRADIENT_EVALUATIONS: usize;
    /// The smallest `h·ω` beyond which the step is unstable for a harmonic oscillator, computed from its step matrix.
    const STABILITY_LIMIT: f64;
    /// The norm of the leading error terms, of degree `ORDER + 1`, for comparing compositions of equal order and class.
    ///
    /// The basis consists of bracketed Lyndon words. For the class of quadratic `T`, brackets that vanish there are
    /// left out.
    const LEADING_ERROR: Option<f64>;
    /// The table of stages over which a run loops.
    const STAGES: Stages;
    /// The processor; none for most compositions.
    const PROCESSOR: Processor = Processor::NONE;

    /// Returns this composition with a number of inner steps other than that of the annotation.
    ///
    /// The number applies to the outermost parentheses of `split = slow + 8 * (bonds + kinetic)`.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// /// A mass on a stiff spring in a shallow well.
    /// struct Stiff;
    ///
    /// #[hamiltonian(split = well + 8 * (spring + kinetic))]
    /// impl Stiff {
    ///     fn well(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
    ///     fn spring(&self, q: [f64; 1]) -> f64 { 5000.0 * q[0] * q[0] }
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    /// }
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let start = Phase::new([0.1], [0.0]);
    /// let mut run = Stiff.run_with(Verlet.nested(32), start, 0.05)?;
    /// run.advance(1_000)?;
    /// # Ok(())
    /// # }
    /// ```
    fn nested(self, steps: u32) -> WithInnerSteps<Self> {
        WithInnerSteps { composition: self, steps }
    }
}

/// The inner orders 2, 4, 6 and 8, or the order of a composition where that is lower.
const fn lower_orders(order: u32) -> [u32; 4] {
    let mut orders = [2, 4, 6, 8];
    let mut entry = 0;
    while entry < orders.len() {
        if orders[entry] > order {
            orders[entry] = order;
        }
        entry += 1;
    }
    orders
}

/// Checks, in a constant, that a composition can integrate a Hamiltonian of this number of parts.
///
/// A processor need not be a composition of whole steps, and generalised orders count powers of a small second part
/// only. Both are therefore limited to two parts.
///
/// # Panics
/// If the composition cannot integrate this number of parts: a compile error, because the call is in a constant.
pub const fn admits<X: Scheme>(parts: usize) {
    assert!(
        parts > 0,
        "a composition composes exact flows, and `split = none` leaves H in one piece; `ImplicitMidpoint` and \
         `GaussLegendre<1>` to `GaussLegendre<8>` integrate it"
    );
    if parts > 2 {
        assert!(
            X::PROCESSOR.before.rows.is_empty(),
            "this composition has a processor, which integrates Hamiltonians of two parts alone; compositions of general \
             class without one, such as `Yoshida4` and `KahanLi8`, integrate any number of parts"
        );
        assert!(
            X::GENERALISED_ORDERS.len() < 2,
            "the orders of this composition count powers of a small second part, so it integrates Hamiltonians of two \
             parts alone; compositions of general class, such as `Yoshida4` and `KahanLi8`, integrate any number of parts"
        );
    }
}

/// Checks, in a constant, that a composition keeps its order if the last part is itself a symmetric pair.
///
/// Two flows of such a pair are not one flow for twice the duration, so kicks cannot be merged across steps.
///
/// # Panics
/// If the composition loses its order or would merge such kicks: a compile error, because the call is in a constant.
pub const fn admits_pairs<X: Scheme>() {
    assert!(
        X::KEEPS_PAIRS,
        "this composition loses its order where a part is itself a pair of parts in parentheses, since the third powers of \
         its kicks do not cancel; `Abah844`, `Abah864` and `Abah1064` keep theirs, and so do those of second order, such as \
         `Verlet` and `Saba4`, and those that are composed of `Verlet`, such as `Yoshida4` and `KahanLi8`"
    );
    assert!(
        X::STAGES.closing.kick == 0.0,
        "this composition begins and ends with a kick, and two of them in a row are not one where a part is itself a pair \
         of parts in parentheses; take one that begins with a drift: `Verlet` for `VelocityVerlet`, `Saba4` for `Sbab4`"
    );
}

/// A composition that can integrate `H`. `composition!` implements this trait.
#[diagnostic::on_unimplemented(
    message = "the composition `{Self}` cannot integrate `{H}`",
    label = "not a composition for this Hamiltonian",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "`composition! {{ pub struct Mine: order 2 = T(1/2) V(1) T(1/2); }}` declares a new composition"
)]
pub trait Composition<H: System>: Scheme {
    /// The kick of one stage.
    #[inline(always)]
    fn kick(flows: &mut impl Flows<H>, stage: &Stage, h: f64, time: f64) {
        if const { matches!(Between::of::<H>(), Between::InnerSteps) } {
            return flows.kick(h * stage.kick, time + h * stage.inner_time(Self::STAGES.lead));
        }
        let (duration, time) = (h * stage.kick, time + h * stage.kick_time);
        if const { H::PAIRED } {
            flows.middle(duration / 2.0, time, false);
            flows.kick(duration, time);
            return flows.middle(duration / 2.0, time, true);
        }
        flows.kick(duration, time);
    }

    /// One stage of a step that begins at `time`.
    #[inline(always)]
    fn stage(flows: &mut impl Flows<H>, stage: &Stage, h: f64, time: f64) {
        if const { matches!(Between::of::<H>(), Between::Flows) } {
            return Self::stage_of_many(flows, stage, h, time);
        }
        if const { matches!(Self::STAGES.lead, Lead::Kick) } {
            Self::kick(flows, stage, h, time);
        }
        flows.drift(h * stage.drift, time + h * stage.drift_time);
        if const { matches!(Self::STAGES.lead, Lead::Drift) } {
            Self::kick(flows, stage, h, time);
        }
    }

    /// One stage, with the flows of the parts between the first and the last.
    #[inline(always)]
    fn stage_of_many(flows: &mut impl Flows<H>, stage: &Stage, h: f64, time: f64) {
        let [within, behind] = stage.middle;
        let (before, after) = (time + h * stage.kick_time, time + h * (stage.kick_time + stage.drift));
        if const { matches!(Self::STAGES.lead, Lead::Kick) } {
            Self::kick(flows, stage, h, time);
            Self::middle(flows, h * within, before, true);
        }
        flows.drift(h * stage.drift, time + h * stage.drift_time);
        if const { matches!(Self::STAGES.lead, Lead::Drift) } {
            Self::middle(flows, h * within, before, false);
            Self::kick(flows, stage, h, time);
            return Self::middle(flows, h * behind, before, true);
        }
        Self::middle(flows, h * behind, after, false);
    }

    /// The flows of the parts between the first and the last, unless they stand still. They read the time that the drifts
    /// have reached, as kicks do.
    #[inline(always)]
    fn middle(flows: &mut impl Flows<H>, duration: f64, time: f64, backwards: bool) {
        if duration != 0.0 {
            flows.middle(duration, time, backwards);
        }
    }

    /// The stages of a processor. A drift or a kick that is zero is left out.
    #[inline(always)]
    fn once(flows: &mut impl Flows<H>, stages: &Rows, h: f64, time: f64) {
        for stage in stages.rows {
            let kicks = stage.kick != 0.0 || stage.gradient != 0.0;
            if kicks && stages.lead == Lead::Kick {
                Self::kick(flows, stage, h, time);
            }
            if stage.drift != 0.0 {
                flows.drift(h * stage.drift, time + h * stage.drift_time);
            }
            if kicks && stages.lead == Lead::Drift {
                Self::kick(flows, stage, h, time);
            }
        }
    }

    /// From a closed state at `time` to just before the last stage of the step.
    #[inline(always)]
    fn open(flows: &mut impl Flows<H>, h: f64, time: f64) {
        const {
            match Between::of::<H>() {
                Between::Pair => admits_pairs::<Self>(),
                Between::InnerSteps => admits_nested::<Self>(),
                _ => admits::<Self>(H::PARTS.len()),
            }
        };
        if const { !Self::PROCESSOR.before.rows.is_empty() } {
            Self::once(flows, &Self::PROCESSOR.before, h, time);
        }
        Self::stage(flows, &Self::STAGES.opening, h, time);
        for stage in &Self::STAGES.cycle[1..] {
            Self::stage(flows, stage, h, time);
        }
    }

    /// From just before the end of the step that ends at `time` to just before the end of the next one.
    #[inline(always)]
    fn cycle(flows: &mut impl Flows<H>, h: f64, time: f64) {
        for stage in Self::STAGES.cycle {
            Self::stage(flows, stage, h, time);
        }
    }

    /// Completes the step that began at `time`, and undoes the processor.
    #[inline(always)]
    fn close(flows: &mut impl Flows<H>, h: f64, time: f64) {
        Self::complete(flows, h, time);
        Self::show(flows, h, time);
    }

    /// Completes the step of the kernel that began at `time`.
    #[inline(always)]
    fn complete(flows: &mut impl Flows<H>, h: f64, time: f64) {
        let closing = &Self::STAGES.closing;
        match Self::STAGES.lead {
            Lead::Drift if closing.drift != 0.0 => flows.drift(h * closing.drift, time + h * closing.drift_time),
            Lead::Kick if closing.kick != 0.0 || closing.gradient != 0.0 => Self::kick(flows, closing, h, time),
            _ => {}
        }
    }

    /// Undoes the processor at the end of the step that began at `time`.
    #[inline(always)]
    fn show(flows: &mut impl Flows<H>, h: f64, time: f64) {
        if const { !Self::PROCESSOR.after.rows.is_empty() } {
            Self::once(flows, &Self::PROCESSOR.after, h, time);
        }
    }
}
