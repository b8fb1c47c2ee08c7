//! A motion by Taylor polynomials, for systems whose recurrences were written.
//!
//! Always true: neither the executor of runs nor the flows of the system are involved, and one scalar is all that it is
//! compiled for.

use crate::{
    check::{
        path::{PARTS, Path},
        points::plain,
    },
    coords::Coords,
    engine::Clock,
    hamiltonian::{Hamiltonian, Motion},
    method::Method,
    phase::Phase,
    slot::Compensated,
    taylor::{Recurrences, Taylor},
    visit::RecurrencesVisitor,
};
use std::sync::Arc;

/// Whether the recurrences of a system were written.
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

/// The motion of `system` from `start` at time 0 over `span`, with a compensated state; nothing where there are no
/// recurrences, or a singularity lies on the way.
pub(crate) fn series<H: Hamiltonian>(
    system: &H,
    start: &Phase<H::Coords>,
    span: f64,
    method: Taylor,
) -> Option<Path<H::Coords>> {
    let mut expansion = Expansion::<H> { system, start, span, method, path: None };
    H::visit_recurrences(&mut expansion);
    expansion.path
}

struct Expansion<'s, H: Hamiltonian> {
    system: &'s H,
    start: &'s Phase<H::Coords>,
    span: f64,
    method: Taylor,
    path: Option<Path<H::Coords>>,
}

impl<H: Hamiltonian> RecurrencesVisitor<H> for Expansion<'_, H> {
    fn visit(&mut self)
    where
        H: Recurrences,
    {
        let Self { system, start, span, method, .. } = *self;
        let constants = Method::<H>::constants(method, Arc::new(system.parameters(start.q.length())));
        let mut state = Phase::compensated(start.q.clone(), start.p.clone());
        let mut motion = <Taylor as Method<H>>::Motion::<f64, Compensated<f64>>::load(|_| (&*constants, &state));
        let moves = <Taylor as Method<H>>::moves::<f64, Compensated<f64>>();
        let mut ends = Vec::with_capacity(PARTS as usize);
        for part in 0..PARTS {
            moves.advance(&mut motion, Clock { t0: 0.0, h: span / PARTS as f64, steps: part }, 1);
            if !motion.finite() {
                return;
            }
            motion.store(0, &mut state);
            ends.push(plain::<H, Compensated<f64>>(&state));
        }
        self.path = Some(Path { start: start.clone(), ends });
    }
}
