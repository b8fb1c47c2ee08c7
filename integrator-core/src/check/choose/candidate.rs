//! Candidates: compositions without their types, as the search sees them.

use crate::{
    check::{start::Start, statistics::points::run},
    composition::{Class, Composition, Rows, visitor::Visitor},
    error::Error,
    hamiltonian::{Hamiltonian, Shaped},
    state::precision::Precision,
    trajectory::run::Run,
};

/// Begins a run, whatever its composition.
type Begin<H, K> = fn(&H, &Start<Shaped<H, K>>, f64) -> Result<Run<Shaped<H, K>>, Error>;

/// One composition.
pub(super) struct Candidate<H: Hamiltonian, K: Precision> {
    pub(super) name: &'static str,
    pub(super) order: u32,
    pub(super) class: Class,
    /// Evaluations of each step, gradients counted as one more.
    pub(super) each: u64,
    /// Evaluations of the processor and its inverse.
    pub(super) once: u64,
    pub(super) begin: Begin<H, K>,
}

impl<H: Hamiltonian, K: Precision> Candidate<H, K> {
    /// The work of a run.
    pub(super) fn evaluations(&self, steps: u64) -> u64 {
        steps * self.each + self.once
    }
}

/// Collects what it visits.
pub(super) struct Candidates<H: Hamiltonian, K: Precision>(pub(super) Vec<Candidate<H, K>>);

impl<H: Hamiltonian, K: Precision> Visitor<H> for Candidates<H, K> {
    fn visit<X: Composition<H>>(&mut self, _: X) {
        self.0.push(Candidate {
            name: X::NAME,
            order: X::ORDER,
            class: X::CLASS,
            each: (X::FORCE_EVALUATIONS + X::GRADIENT_EVALUATIONS) as u64,
            once: evaluations(&X::PROCESSOR.before) + evaluations(&X::PROCESSOR.after),
            begin: |system, start, h| run::<H, X, K>(system, X::default(), start, h),
        });
    }
}

/// The evaluations of some stages.
fn evaluations(rows: &Rows) -> u64 {
    let gradients = rows.rows.iter().filter(|row| row.gradient != 0.0).count();
    let forces = rows.rows.iter().filter(|row| row.kick != 0.0 || row.gradient != 0.0).count();
    (forces + gradients) as u64
}
