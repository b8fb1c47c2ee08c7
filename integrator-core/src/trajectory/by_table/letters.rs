//! A composition as flows one after the other.

use crate::{
    composition::{Lead, Processor, Scheme, Stage, Stages, corrected_durations::Between},
    system::System,
};
use alloc::vec::Vec;

/// One flow of a step.
#[derive(Clone, Copy)]
pub(super) struct Letter {
    pub(super) flow: Flow,
    /// The duration, as a fraction of the step.
    pub(super) duration: f64,
    /// The coefficient of the gradient of the squared force.
    pub(super) gradient: f64,
    /// The time that the flow reads, as a fraction of the step.
    pub(super) time: f64,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Flow {
    Drift,
    Kick,
    GradientKick,
    /// The flows of the parts between the first and the last, in their order or backwards.
    Middle {
        backwards: bool,
    },
}

/// The table of a composition for a system, of which flows one after the other are made where they are needed.
#[derive(Clone, Copy)]
pub(super) struct Table {
    pub(super) stages: Stages,
    pub(super) processor: Processor,
    /// The flows of the system between its first part and its last.
    pub(super) between: Between,
}

impl Table {
    /// The table of a composition for a system.
    pub(super) fn of<H: System, X: Scheme>() -> Self {
        Self { stages: X::STAGES, processor: X::PROCESSOR, between: const { Between::of::<H>() } }
    }

    /// The flows of the first step, after the processor.
    pub(super) fn opening(&self) -> Vec<Letter> {
        let mut opening = self.moving(self.processor.before.lead, self.processor.before.rows);
        opening.extend(self.steps(&self.stages.opening));
        opening
    }

    /// The flows of a later step.
    pub(super) fn cycle(&self) -> Vec<Letter> {
        self.steps(&self.stages.cycle[0])
    }

    /// The flows of the end of a step.
    pub(super) fn closing(&self) -> Vec<Letter> {
        self.moving(self.stages.lead, &[self.stages.closing])
    }

    /// The flows that undo the processor.
    pub(super) fn undoing(&self) -> Vec<Letter> {
        self.moving(self.processor.after.lead, self.processor.after.rows)
    }

    fn moving(&self, lead: Lead, rows: &[Stage]) -> Vec<Letter> {
        let letters = rows.iter().flat_map(|row| both(lead, row, self.between)).filter(|letter| !letter.stands_still());
        letters.flat_map(|letter| self.paired(letter)).collect()
    }

    fn steps(&self, first: &Stage) -> Vec<Letter> {
        let steps = [first].into_iter().chain(&self.stages.cycle[1..]);
        let letters = steps.flat_map(|stage| all(self.stages.lead, stage, self.between));
        letters.flat_map(|letter| self.paired(letter)).collect()
    }

    fn paired(&self, letter: Letter) -> impl Iterator<Item = Letter> + use<> {
        letter.paired(self.between == Between::Pair)
    }
}

impl Letter {
    fn stands_still(&self) -> bool {
        self.duration == 0.0 && self.gradient == 0.0
    }

    /// A kick of a pair with what is around it; any other letter alone.
    fn paired(self, is_pair: bool) -> impl Iterator<Item = Self> {
        let around = |backwards| {
            let around = Self { flow: Flow::Middle { backwards }, duration: self.duration / 2.0, ..self };
            (is_pair && self.flow == Flow::Kick).then_some(around)
        };
        [around(false), Some(self), around(true)].into_iter().flatten()
    }
}

/// The drift and the kick of a stage.
fn both(lead: Lead, stage: &Stage, between: Between) -> [Letter; 2] {
    let Stage { drift, kick, gradient, drift_time, kick_time, .. } = *stage;
    let kick_time = if between == Between::InnerSteps { stage.inner_time(lead) } else { kick_time };
    let flow = if gradient == 0.0 { Flow::Kick } else { Flow::GradientKick };
    let drift = Letter { flow: Flow::Drift, duration: drift, gradient: 0.0, time: drift_time };
    let kick = Letter { flow, duration: kick, gradient, time: kick_time };
    match lead {
        Lead::Drift => [drift, kick],
        Lead::Kick => [kick, drift],
    }
}

/// All flows of a stage, with those between the first part and the last.
fn all(lead: Lead, stage: &Stage, between: Between) -> impl Iterator<Item = Letter> {
    let [within, behind] = stage.middle;
    let middle = move |duration, time, backwards| {
        let moves = between == Between::Flows && duration != 0.0;
        moves.then_some(Letter { flow: Flow::Middle { backwards }, duration, gradient: 0.0, time })
    };
    let [first, last] = both(lead, stage, between);
    let kick_first = lead == Lead::Kick;
    let before = stage.kick_time;
    let after = if kick_first { before + stage.drift } else { before };
    [Some(first), middle(within, before, kick_first), Some(last), middle(behind, after, !kick_first)]
        .into_iter()
        .flatten()
}
