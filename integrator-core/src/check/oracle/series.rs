//! The motion as Taylor polynomials, for systems that have recurrences.
//!
//! Always true: neither the executor of runs nor the flows of the system are involved, and one scalar is all that it is
//! compiled for.

use crate::{
    check::{
        start::Start,
        statistics::path::{PARTS, Path, Recorder, Scale},
    },
    hamiltonian::Hamiltonian,
    methods::taylor::{Recurrences, RecurrencesVisitor, Taylor},
    state::{clock::Clock, compensated::Compensated, coords::Coords, flat::flat, phase::Phase},
    system::motion::Motion,
    trajectory::{method::Method, step_functions::FlowByFlow},
};
use std::sync::Arc;

/// Whether a system has recurrences.
pub(crate) fn is_written<H: Hamiltonian>() -> bool {
    struct Written(bool);
    impl<H: Hamiltonian> RecurrencesVisitor<H> for Written {
        fn visit(&mut self)
        where
            H: Recurrences,
        {
            self.0 = true;
        }
    }
    let mut written = Written(false);
    H::visit_recurrences(&mut written);
    written.0
}

/// The motion of `system` from `start` over `span`, with a compensated state, and its excursion from `samples`
/// samples in each part; `None` where there are no recurrences, or a singularity lies on the way.
pub(crate) fn series<H: Hamiltonian>(
    system: &H,
    start: &Start<H::Coords>,
    span: f64,
    method: Taylor,
    samples: u64,
) -> Option<(Path, Scale)> {
    let mut expansion = Expansion::<H> { system, start, span, method, samples, path: None };
    H::visit_recurrences(&mut expansion);
    expansion.path
}

struct Expansion<'s, H: Hamiltonian> {
    system: &'s H,
    start: &'s Start<H::Coords>,
    span: f64,
    method: Taylor,
    samples: u64,
    path: Option<(Path, Scale)>,
}

impl<H: Hamiltonian> RecurrencesVisitor<H> for Expansion<'_, H> {
    fn visit(&mut self)
    where
        H: Recurrences,
    {
        let Self { system, start: &Start { phase: ref start, time: t0 }, span, method, samples, .. } = *self;
        let constants = Method::<H>::constants(method, Arc::new(system.parameters(start.q.length())));
        let mut state = Phase::compensated(start.q.clone(), start.p.clone());
        let mut motion = <Taylor as Method<H>>::Motion::<f64, Compensated<f64>>::load(&[&*constants], &[&state]);
        let functions = <Taylor as Method<H>>::step_functions::<f64, Compensated<f64>, FlowByFlow>();
        let mut recorder = Recorder::new(flat(start), samples);
        for step in 1..=PARTS * samples {
            // Ends of parts are multiples of a part, whatever rounding does to the samples between them.
            let (number, count) = if step % samples == 0 { (step / samples, PARTS) } else { (step, PARTS * samples) };
            functions.advance_one(&mut motion, Clock { t0, h: span / count as f64, steps: number - 1 }, 1);
            if !motion.finite() {
                return;
            }
            motion.store(0, &mut state);
            recorder.record(flat(&state));
        }
        self.path = Some(recorder.finish());
    }
}
