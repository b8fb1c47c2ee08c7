//! The arguments of a launch: the clock and the stages of a composition, in the layout of the device.

use integrator_core::__private::{Composition, Lead, Precision, Rows, Stage, System, corrections};

/// What kernels of any composition know of it: what a launch says.
pub(crate) const ANY_COMPOSITION: &str = "typedef AnyComposition Composed;\n";

/// One stage as the device reads it.
pub(crate) type Row = [f64; 7];

/// By how much the first flow of a kind is longer in some cycles of a compensated run.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Correction {
    pub(crate) longer: f64,
    pub(crate) frequency: u64,
}

/// The arguments of a launch, as `Launch` in `stepper.h`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Launch {
    pub(crate) t0: f64,
    pub(crate) h: f64,
    pub(crate) members: i64,
    pub(crate) done: u64,
    pub(crate) steps: u64,
    pub(crate) leads_with_kick: i32,
    pub(crate) cycle: i32,
    /// The number of stages, below zero if they lead with a kick.
    pub(crate) before: i32,
    pub(crate) after: i32,
    pub(crate) drift: Correction,
    pub(crate) kick: Correction,
    pub(crate) middle: Correction,
}

impl Launch {
    /// A launch from the start, and the stages of its composition: opening, closing, those of a cycle, and those before and
    /// after a processed one.
    pub(crate) fn new<H: System, X: Composition<H>, K: Precision>(h: f64, members: usize) -> (Self, Vec<Row>) {
        let (stages, processor) = (X::STAGES, X::PROCESSOR);
        let of = |rows: &Rows| {
            let count = rows.rows.len() as i32;
            if rows.lead == Lead::Kick { -count } else { count }
        };
        let corrections = if K::COMPENSATED { corrections::<H, X>(h) } else { [(0.0, 0); 3] };
        let [drift, kick, middle] = corrections.map(|(longer, frequency)| Correction { longer, frequency });
        let launch = Self {
            t0: 0.0,
            h,
            members: members as i64,
            done: 0,
            steps: 0,
            leads_with_kick: i32::from(stages.lead == Lead::Kick),
            cycle: stages.cycle.len() as i32,
            before: of(&processor.before),
            after: of(&processor.after),
            drift,
            kick,
            middle,
        };
        let rows = [&stages.opening, &stages.closing].into_iter().chain(stages.cycle);
        (launch, rows.chain(processor.before.rows).chain(processor.after.rows).map(row).collect())
    }

    /// The bytes of the fields, in their order.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let Self { t0, h, members, done, steps, leads_with_kick, cycle, before, after, drift, kick, middle } = *self;
        let counts = [leads_with_kick, cycle, before, after];
        let corrections = [drift, kick, middle].map(|Correction { longer, frequency }| [longer.to_bits(), frequency]);
        [t0.to_bits(), h.to_bits(), members as u64, done, steps]
            .into_iter()
            .flat_map(u64::to_ne_bytes)
            .chain(counts.into_iter().flat_map(i32::to_ne_bytes))
            .chain(corrections.into_iter().flatten().flat_map(u64::to_ne_bytes))
            .collect()
    }
}

fn row(stage: &Stage) -> Row {
    let Stage { drift, kick, gradient, drift_time, kick_time, middle: [within, behind] } = *stage;
    [drift, kick, gradient, drift_time, kick_time, within, behind]
}
