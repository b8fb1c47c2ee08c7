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
    [(stage.drift != 0.0) as u64, (within != 0.0) as u64 + (behind != 0.0) as u64, stage.forces()]
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

/// What determines how often a step of a composition applies the flow of each part of a system: data, so that counting is compiled
/// once.
#[derive(Clone, Copy, Debug)]
pub struct PartFlows {
    stages: Stages,
    are_whole: bool,
    parts: usize,
    paired: bool,
    nested: &'static [InnerSteps],
    /// The number of inner steps in place of that of the annotation.
    chosen_inner_steps: Option<u32>,
}

impl PartFlows {
    /// Those of a composition with a system, with a number of inner steps or with that of the annotation.
    pub(crate) const fn of<H: System, X: Scheme>(chosen_inner_steps: Option<u32>) -> Self {
        Self {
            stages: X::STAGES,
            are_whole: X::STAGES.are_whole::<H>(),
            parts: H::PARTS.len(),
            paired: H::PAIRED,
            nested: H::NESTED,
            chosen_inner_steps,
        }
    }

    /// The flows of each part in a step in the middle of a run.
    pub(crate) fn counts(&self) -> Vec<u64> {
        let mut flows = self.stages.flows_of_cycle();
        if self.are_whole {
            flows = with(flows, self.stages.flows_of_closing(), 1);
        }
        let [first, mut middle, mut last] = flows;
        if self.paired {
            middle = 2 * last;
        }
        if self.nested.is_empty() {
            let mut counts = vec![middle; self.parts];
            counts.first_mut().into_iter().for_each(|count| *count = first);
            counts.last_mut().into_iter().for_each(|count| *count = last);
            return counts;
        }
        let mut counts = vec![first];
        for (level, InnerSteps { steps, parts, flows, closing, .. }) in self.nested.iter().enumerate() {
            let taken = u64::from(self.chosen_inner_steps.filter(|_| level == 0).unwrap_or(*steps));
            let is_last = level + 1 == self.nested.len();
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

    /// The flows of the last part.
    pub(crate) fn of_last_part(&self) -> u64 {
        self.counts().last().copied().unwrap_or(0)
    }
}

/// The sum of some counts and a multiple of others.
fn with(counts: FlowCounts, others: FlowCounts, times: u64) -> FlowCounts {
    [0, 1, 2].map(|flow| counts[flow] + times * others[flow])
}
