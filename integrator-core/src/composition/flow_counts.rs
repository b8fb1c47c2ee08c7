//! How often a step applies the flow of each part of H.

use crate::{
    composition::{Scheme, Stage, Stages},
    system::{System, inner_steps::InnerSteps},
};
use alloc::{vec, vec::Vec};

/// The number of drifts, of flows between the first part and the last, and of kicks. A kick along the gradient of the squared
/// force counts twice.
pub(crate) type FlowCounts = [u64; 3];

/// The flows of a stage.
const fn of_stage(stage: &Stage) -> FlowCounts {
    let [within, behind] = stage.middle;
    let kicks = (stage.kick != 0.0 || stage.gradient != 0.0) as u64 + (stage.gradient != 0.0) as u64;
    [(stage.drift != 0.0) as u64, (within != 0.0) as u64 + (behind != 0.0) as u64, kicks]
}

impl Stages {
    /// The flows of a step in the middle of a run.
    pub(crate) const fn flows_of_cycle(&self) -> FlowCounts {
        let (mut counts, mut row) = ([0; 3], 0);
        while row < self.cycle.len() {
            let [drifts, middle, kicks] = of_stage(&self.cycle[row]);
            counts = [counts[0] + drifts, counts[1] + middle, counts[2] + kicks];
            row += 1;
        }
        counts
    }

    /// The flows that complete a step.
    pub(crate) const fn flows_of_closing(&self) -> FlowCounts {
        let [drifts, _, kicks] = of_stage(&self.closing);
        [drifts, 0, kicks]
    }
}

/// Returns how often a step of `H` applies the flow of each part, with this number of inner steps in place of that of the annotation.
pub(crate) fn flows_of_parts<H: System, X: Scheme>(steps: Option<u32>) -> Vec<u64> {
    let stages = X::STAGES;
    let mut flows = stages.flows_of_cycle();
    if stages.are_whole::<H>() {
        flows = with(flows, stages.flows_of_closing(), 1);
    }
    let [first, mut middle, mut last] = flows;
    if H::PAIRED {
        middle = 2 * last;
    }
    if H::NESTED.is_empty() {
        let mut counts = vec![middle; H::PARTS.len()];
        counts.first_mut().into_iter().for_each(|count| *count = first);
        counts.last_mut().into_iter().for_each(|count| *count = last);
        return counts;
    }
    let mut counts = vec![first];
    for (level, InnerSteps { steps: stated, parts, flows, closing, .. }) in H::NESTED.iter().enumerate() {
        let taken = u64::from(steps.filter(|_| level == 0).unwrap_or(*stated));
        let is_last = level + 1 == H::NESTED.len();
        // Steps that begin and end with parts that take inner steps are completed one by one.
        let completed = if !is_last && closing[2] != 0 { taken } else { 1 };
        let [drifts, between, kicks] = with(flows.map(|count| count * taken), *closing, completed);
        counts.push(last * drifts);
        if is_last {
            counts.extend(vec![last * between; parts.len() - 2]);
            counts.push(last * kicks);
        }
        last *= kicks;
    }
    counts
}

/// The sum of some counts and a multiple of others.
fn with(counts: FlowCounts, others: FlowCounts, times: u64) -> FlowCounts {
    [0, 1, 2].map(|flow| counts[flow] + times * others[flow])
}
