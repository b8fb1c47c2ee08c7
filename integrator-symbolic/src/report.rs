//! A readable report of what is derived from an annotated impl.

use crate::{
    differentiate::{Contribution, fold_branches},
    emit::{self, Form},
    graph::{Tally, index::LoopSet},
    lower::lower,
    model::{Model, Split},
    pattern::recognise,
    prose,
    syntax::{Compose, Input},
};
use quote::ToTokens;
use std::{collections::HashMap, fmt};

/// The equations of motion of a Hamiltonian, its properties, and the cost of its flows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The annotated type, as written.
    pub system: String,
    /// The composition in the annotation, a name or a sequence, as written.
    pub compose: String,
    /// The equations `dq[i]/dt = ...` and `dp[i]/dt = ...`, where `+=` marks one of several terms, and `where r = ...`
    /// for named subexpressions.
    pub equations: Vec<String>,
    /// The parts of `H`.
    ///
    /// If `hamiltonian` contains all of `H`, they are `T = ...` and `V = ...`, with the terms of each. If `split` names
    /// parts, there is `name = ...` for each. Otherwise the list is empty.
    pub parts: Vec<String>,
    /// Whether `T = ½ pᵀ M⁻¹ p` with a constant `M`.
    pub quadratic_kinetic: bool,
    /// Whether `H` is `T(p) + V(q)`, in this order.
    pub separable: bool,
    /// Whether `H` is not split, so that no composition can integrate it.
    pub whole: bool,
    /// Whether `H` is independent of time.
    pub autonomous: bool,
    /// The flow that moves the positions.
    pub drift: Flow,
    /// The flow that moves the momenta.
    pub kick: Flow,
    /// The number of operations of one drift and one kick as the derivatives are written; the body of a sum counts
    /// once.
    pub operations_written: u64,
    /// The number of these operations with shared subexpressions computed once.
    pub operations_shared: u64,
    /// The number of operations of the energies `T` and `V`, with shared subexpressions computed once.
    pub operations_of_energies: u64,
    /// The number of operations of the energies and of their derivatives, with shared subexpressions computed once.
    pub operations_together: u64,
}

/// The drift or the kick.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flow {
    /// The layout of the flow.
    pub form: Form,
    /// The layout of the terms beside a sum over pairs, if there are any.
    pub others: Option<Form>,
    /// The computations of the flow, by their loops, outermost first; empty if nothing moves.
    pub places: Vec<Place>,
}

/// The computations of a flow in one place, with shared subexpressions computed once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The enclosing loops, outermost first, as `i in 0..n`; empty outside of loops.
    pub loops: Vec<String>,
    /// The operations of one iteration.
    pub operations: Tally,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in self.parts.iter().chain(&self.equations) {
            writeln!(f, "{line}")?;
        }
        if !self.separable {
            let time = if self.autonomous { "not read" } else { "read" };
            let form = if self.whole { "in one piece" } else { "in parts with exact flows" };
            writeln!(f, "H: {form}; time: {time}")?;
            return write!(f, "operations of the energies: {}", self.operations_of_energies);
        }
        let kinetic = if self.quadratic_kinetic { "quadratic in p, constant masses" } else { "general" };
        let time = if self.autonomous { "not read" } else { "read" };
        writeln!(f, "H: separable; T: {kinetic}; time: {time}")?;
        write!(f, "drift: {}\nkick: {}\n", self.drift, self.kick)?;
        writeln!(
            f,
            "operations of a drift and a kick: {}, or {} after common subexpression elimination",
            self.operations_written, self.operations_shared
        )?;
        write!(
            f,
            "operations of the energies: {}, of energies and derivatives together: {}",
            self.operations_of_energies, self.operations_together
        )
    }
}

impl fmt::Display for Flow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.places.is_empty() {
            return f.write_str("nothing moves");
        }
        write!(f, "{}", self.form)?;
        if let Some(others) = self.others {
            write!(f, "; other terms: {others}")?;
        }
        for Place { loops, operations } in &self.places {
            match &loops[..] {
                [] => write!(f, "\n  once: {operations}")?,
                loops => write!(f, "\n  per iteration of {}: {operations}", loops.join(", "))?,
            }
        }
        Ok(())
    }
}

/// What is derived from `input`, whose model is known to make sense.
pub(crate) fn report(input: &Input, mut model: Model) -> Report {
    let [kinetic, potential] = emit::gradients(&mut model);
    let parts = prose::parts(&model);
    let equations = prose::equations(&mut model, &kinetic, &potential);
    let values: Vec<_> = kinetic.iter().chain(&potential).map(|contribution| contribution.value).collect();
    let energies = vec![model.kinetic, model.potential];
    let all = [&values[..], &energies].concat();
    let graph = &mut model.graph;
    let [flows, energies, together] = [values, energies, all].map(|roots| {
        let lowered = lower(graph, &roots, |graph, id| graph.is_prepared(id));
        graph.cost(&lowered)
    });
    let places = [&kinetic, &potential].map(|gradient| places(&mut model, gradient));
    let pattern = recognise(&mut model, [&kinetic, &potential]);
    let mut stated = model.potential;
    let [kinetic, potential] = match pattern.restate(&mut model, &mut stated) {
        true => emit::gradients(&mut model),
        false => [kinetic, potential],
    };
    let (forms, others) = emit::forms(input, &mut model, &kinetic, &potential, &pattern);
    let others = [None, others];
    let [drift, kick] =
        [0, 1].map(|part| Flow { form: forms[part], others: others[part], places: places[part].clone() });
    Report {
        system: readable(&input.item.self_ty),
        compose: match &input.compose {
            None => "Verlet".to_owned(),
            Some(Compose::Named(path)) => readable(path),
            Some(Compose::InPlace(sequence, _)) => sequence.text(),
        },
        equations,
        parts,
        quadratic_kinetic: model.quadratic,
        whole: matches!(model.split, Split::Whole),
        separable: model.is_separable() && model.jacobi().is_none(),
        autonomous: model.autonomous,
        drift,
        kick,
        operations_written: flows.written,
        operations_shared: flows.shared,
        operations_of_energies: energies.shared,
        operations_together: together.shared,
    }
}

/// What a flow along a gradient computes, by the loops around it.
fn places(model: &mut Model, gradient: &[Contribution]) -> Vec<Place> {
    let Model { graph, externals, .. } = model;
    let gradient = fold_branches(graph, gradient);
    let values: Vec<_> = gradient.iter().map(|contribution| contribution.value).collect();
    let lowered = lower(graph, &values, |graph, id| graph.is_prepared(id));
    let tallies = graph.tallies(&lowered, |id| externals[id.0 as usize].to_string());
    let mut by_loops: HashMap<LoopSet, Tally> = HashMap::new();
    // What depends on the index of an inner loop stands in those around it too.
    let whole = |loops: LoopSet| {
        let around = |by| std::iter::successors(Some(by), |by| graph.loops.get(*by).parent);
        loops.iter().flat_map(around).fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)))
    };
    for (loops, tally) in tallies {
        by_loops.entry(whole(loops)).or_default().add(tally);
    }
    for contribution in &gradient {
        let loops = contribution.loops().fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)));
        by_loops.entry(whole(loops)).or_default().coordinates += 1;
    }
    let mut places: Vec<_> = by_loops.into_iter().collect();
    places.sort_by_key(|(loops, _)| loops.iter().collect::<Vec<_>>());
    let place = |(loops, operations): (LoopSet, Tally)| Place { loops: prose::ranges(model, loops), operations };
    places.into_iter().map(place).collect()
}

/// Tokens of a type or a path, with the spaces that people leave.
fn readable(tokens: &impl ToTokens) -> String {
    let text = tokens.to_token_stream().to_string();
    text.replace(" :: ", "::")
        .replace(":: ", "::")
        .replace(" <", "<")
        .replace("< ", "<")
        .replace(" >", ">")
        .replace(" ,", ",")
}
