//! The arguments of a launch: the clock and the stages of a composition, in the layout of the device.

use integrator_core::__private::{
    Composition, DeviceText, Lead, Precision, Rows, StageRow, corrections, push_stages, takes_whole_steps,
};

/// What kernels of any composition know of it: what a launch says.
pub(crate) const ANY_COMPOSITION: &str = "typedef AnyComposition Composed;\n";

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
    /// Whether steps are completed one by one.
    pub(crate) is_whole: i32,
    /// The number of rows of inner compositions.
    pub(crate) inner: i32,
    pub(crate) drift: Correction,
    pub(crate) kick: Correction,
    pub(crate) middle: Correction,
}

impl Launch {
    /// A launch from the start, and the stages of its composition, then those of inner compositions.
    pub(crate) fn new<H: DeviceText, X: Composition<H>, K: Precision>(h: f64, members: usize) -> (Self, Vec<StageRow>) {
        let (stages, processor) = (X::STAGES, X::PROCESSOR);
        let of = |rows: &Rows| {
            let count = rows.rows.len() as i32;
            if rows.lead == Lead::Kick { -count } else { count }
        };
        let corrections = if K::COMPENSATED { corrections::<H, X>(h) } else { [(0.0, 0); 3] };
        let [drift, kick, middle] = corrections.map(|(longer, frequency)| Correction { longer, frequency });
        let mut rows = Vec::new();
        push_stages::<H, X>(&mut rows);
        let own = rows.len();
        H::push_inner_stages(&mut rows);
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
            is_whole: i32::from(takes_whole_steps::<H, X>()),
            inner: (rows.len() - own) as i32,
            drift,
            kick,
            middle,
        };
        (launch, rows)
    }

    /// The bytes of the fields, in their order.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let Self { t0, h, members, done, steps, leads_with_kick, cycle, before, after, is_whole, inner, .. } = *self;
        let counts = [leads_with_kick, cycle, before, after, is_whole, inner];
        let corrections =
            [self.drift, self.kick, self.middle].map(|Correction { longer, frequency }| [longer.to_bits(), frequency]);
        [t0.to_bits(), h.to_bits(), members as u64, done, steps]
            .into_iter()
            .flat_map(u64::to_ne_bytes)
            .chain(counts.into_iter().flat_map(i32::to_ne_bytes))
            .chain(corrections.into_iter().flatten().flat_map(u64::to_ne_bytes))
            .collect()
    }
}
