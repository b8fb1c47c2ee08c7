//! A composition as flows one after the other.

use crate::composition::{Lead, Processor, Stage, Stages, corrected_durations::Between};
use alloc::vec::Vec;

/// One flow of a step.
#[derive(Clone, Copy)]
pub(super) struct Letter {
    pub(super) flow: Flow,
    /// How long it lasts, as a fraction of the step.
    pub(super) duration: f64,
    /// The coefficient of the gradient of the squared force.
    pub(super) gradient: f64,
    /// When it reads the time, as a fraction of the step.
    pub(super) time: f64,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Flow {
    Drift,
    Kick,
    GradientKick,
    /// Those of the parts between the first and the last, in their order or backwards.
    Middle {
        backwards: bool,
    },
}

/// A composition as flows one after the other.
pub(super) struct Letters {
    pub(super) stages: Stages,
    pub(super) processor: Processor,
    pub(super) opening: Vec<Letter>,
    pub(super) cycle: Vec<Letter>,
    pub(super) closing: Vec<Letter>,
    pub(super) undoing: Vec<Letter>,
}

impl Letters {
    /// The flows that [`Composition`](crate::Composition) takes, with what a system has between its first part and its last.
    pub(super) fn new(stages: Stages, processor: Processor, between: Between) -> Self {
        let paired = |letter: Letter| letter.paired(between == Between::Pair);
        let moving = |lead, rows: &[Stage]| -> Vec<Letter> {
            let letters = rows.iter().flat_map(|row| both(lead, row)).filter(|letter| !letter.stands_still());
            letters.flat_map(paired).collect()
        };
        let steps = |first: &Stage| -> Vec<Letter> {
            let steps = [first].into_iter().chain(&stages.cycle[1..]);
            steps.flat_map(|stage| all(stages.lead, stage, between)).flat_map(paired).collect()
        };
        let mut opening = moving(processor.before.lead, processor.before.rows);
        opening.extend(steps(&stages.opening));
        Self {
            stages,
            processor,
            opening,
            cycle: steps(&stages.cycle[0]),
            closing: moving(stages.lead, &[stages.closing]),
            undoing: moving(processor.after.lead, processor.after.rows),
        }
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
fn both(lead: Lead, stage: &Stage) -> [Letter; 2] {
    let Stage { drift, kick, gradient, drift_time, kick_time, .. } = *stage;
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
    let [first, last] = both(lead, stage);
    let kick_first = lead == Lead::Kick;
    let before = stage.kick_time;
    let after = if kick_first { before + stage.drift } else { before };
    [Some(first), middle(within, before, kick_first), Some(last), middle(behind, after, !kick_first)]
        .into_iter()
        .flatten()
}
