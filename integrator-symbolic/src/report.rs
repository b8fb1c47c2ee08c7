//! What is derived from an annotated impl, for people.

use crate::{
    differentiate::gradient,
    emit,
    errors::Errors,
    graph::Part,
    lower::lower,
    model::{self, Model},
    syntax,
};
use proc_macro2::TokenStream;
use std::fmt;

/// The equations of motion of a Hamiltonian, what is known of it, and what its flows cost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// `dq[i]/dt = ...` and `dp[i]/dt = ...`; `+=` marks one of several terms.
    pub equations: Vec<String>,
    /// Whether `T = ½ pᵀ M⁻¹ p` with a constant `M`.
    pub quadratic_kinetic: bool,
    /// Whether neither `T` nor `V` reads the time.
    pub autonomous: bool,
    /// Operations of one drift and one kick as often as they occur in the derivatives; a sum's body counts once.
    pub operations_written: u64,
    /// The same operations with shared subexpressions computed once.
    pub operations_shared: u64,
    /// Operations of the energies `T` and `V`, with shared subexpressions computed once.
    pub operations_of_energies: u64,
    /// Operations of the energies and of their derivatives together, with shared subexpressions computed once.
    pub operations_together: u64,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for equation in &self.equations {
            writeln!(f, "{equation}")?;
        }
        let kinetic = if self.quadratic_kinetic { "quadratic in p, constant masses" } else { "general" };
        let time = if self.autonomous { "not read" } else { "read" };
        writeln!(f, "T: {kinetic}; time: {time}")?;
        writeln!(
            f,
            "operations of a drift and a kick: {} as derived, {} with what is shared computed once",
            self.operations_written, self.operations_shared
        )?;
        write!(
            f,
            "operations of the energies: {}, of energies and derivatives together: {}",
            self.operations_of_energies, self.operations_together
        )
    }
}

/// What `#[hamiltonian]` derives from an impl; nothing where it has mistakes, which the expansion tells.
pub fn report(arguments: TokenStream, item: TokenStream) -> Option<Report> {
    let mut errors = Errors::default();
    let input = syntax::input(arguments, item, &mut errors)?;
    let mut model = model::model(&input, &mut errors).filter(|_| errors.is_empty())?;
    let kinetic = gradient(&mut model.graph, model.kinetic, Part::Momentum);
    let potential = gradient(&mut model.graph, model.potential, Part::Position);
    let equations = emit::equations(&mut model, &kinetic, &potential);
    let values: Vec<_> = kinetic.iter().chain(&potential).map(|contribution| contribution.value).collect();
    let energies = vec![model.kinetic, model.potential];
    let Model { graph, quadratic, autonomous, .. } = &mut model;
    let all = [&values[..], &energies].concat();
    let [flows, energies, together] = [values, energies, all].map(|roots| {
        let lowered = lower(graph, &roots, |graph, id| graph.is_prepared(id));
        graph.cost(&lowered)
    });
    Some(Report {
        equations,
        quadratic_kinetic: *quadratic,
        autonomous: *autonomous,
        operations_written: flows.written,
        operations_shared: flows.shared,
        operations_of_energies: energies.shared,
        operations_together: together.shared,
    })
}
