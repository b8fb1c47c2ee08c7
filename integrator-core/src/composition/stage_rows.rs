//! The stages of compositions as rows of numbers, for devices.

use crate::{
    composition::{
        Lead, Scheme, Stage, Stages,
        corrected_durations::Between,
        inner_steps::{InnerParts, Nested},
    },
    system::{System, device_text::StageRow},
};
use alloc::vec::Vec;

/// Adds the stages of a composition of the parts of `H`: opening, closing, those of a cycle, and those before and after a
/// processed one.
pub fn push_stages<H: System, X: Scheme>(rows: &mut Vec<StageRow>) {
    let (Stages { lead, opening, cycle, closing }, processor) = (X::STAGES, X::PROCESSOR);
    let takes_inner_steps = matches!(Between::of::<H>(), Between::InnerSteps);
    let row = |stage: &Stage| {
        let Stage { drift, kick, gradient, drift_time, kick_time, middle: [within, behind] } = *stage;
        let kick_time = if takes_inner_steps { stage.inner_time(lead) } else { kick_time };
        [drift, kick, gradient, drift_time, kick_time, within, behind]
    };
    let stages = [&opening, &closing].into_iter().chain(cycle);
    rows.extend(stages.chain(processor.before.rows).chain(processor.after.rows).map(row));
}

/// Adds the stages of the inner composition of a level, after a row with the number of stages in a cycle, whether kicks come
/// first, and whether steps are taken one by one.
pub fn push_inner_stages<H: Nested<LEVEL>, const LEVEL: usize>(rows: &mut Vec<StageRow>) {
    let Stages { lead, cycle, .. } = <H::Inner as Scheme>::STAGES;
    let flags = [lead == Lead::Kick, takes_whole_steps::<InnerParts<H, LEVEL>, H::Inner>()];
    let [leads_with_kick, is_whole] = flags.map(|flag| f64::from(u8::from(flag)));
    rows.push([cycle.len() as f64, leads_with_kick, 0.0, is_whole, 0.0, 0.0, 0.0]);
    push_stages::<InnerParts<H, LEVEL>, H::Inner>(rows);
}

/// Whether a composition takes steps of `H` one by one, without merging their first and last stages.
pub const fn takes_whole_steps<H: System, X: Scheme>() -> bool {
    X::STAGES.are_whole::<H>()
}
