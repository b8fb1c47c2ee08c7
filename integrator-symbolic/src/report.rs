//! A readable report of what is derived from an annotated impl.

mod places;
mod ways;

use crate::{
    graph::{Part, Tally, index::LoopSet},
    layout::{
        Form, forms,
        lost::{Lost, lost, of_part},
    },
    lower::lower,
    model::{Model, Split},
    pattern::{gradients, recognise},
    prose,
    syntax::{Compose, Input},
};
use quote::ToTokens;
use std::fmt;

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
    /// The computations of the energies `T` and `V`, by their loops, outermost first.
    pub energies: [Vec<Place>; 2],
    /// The layouts of the parts that `split` names, if these have exact flows other than a drift and a kick.
    pub flows_of_parts: Vec<FlowOfPart>,
    /// If `H` is not split: parts with exact flows whose sum it is, or the term that has none.
    pub explicit: Vec<String>,
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
    /// What the time of a kick is proportional to, in words; `None` for a drift, and for a kick without loops.
    pub cost: Option<&'static str>,
    /// The faster layouts that do not apply.
    pub slower: Vec<Slower>,
}

/// The flow of a part that `split` names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlowOfPart {
    /// The names of the functions of the part.
    pub name: String,
    /// The layout of a flow along a gradient; `None` for a matrix, a Kepler motion, a shear or a hand-written flow.
    pub form: Option<Form>,
    /// How the part moves, and why.
    pub way: &'static str,
    /// The faster layouts that do not apply.
    pub slower: Vec<Slower>,
}

/// A faster layout that does not apply to a flow.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slower {
    /// The faster layout.
    pub than: Form,
    /// The loop that is plain code, as `i in 0..n`; `None` if the flow as a whole is concerned.
    pub range: Option<String>,
    /// The reason.
    pub reason: &'static str,
    /// What to write instead; empty if nothing gains from it.
    pub instead: &'static str,
}

impl fmt::Display for Slower {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "not `{}`", self.than.name())?;
        if let Some(range) = &self.range {
            write!(f, " over {range}")?;
        }
        write!(f, ": {}", self.reason)?;
        if !self.instead.is_empty() {
            write!(f, "; write {}", self.instead)?;
        }
        Ok(())
    }
}

/// The computations of a flow in one place, with shared subexpressions computed once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// What the runtime calls a function with these operations for.
    pub each: Each,
    /// The enclosing loops, outermost first, as `i in 0..n`; empty outside of loops.
    pub loops: Vec<String>,
    /// The conditions on indices and flags, as `i != j`, under which these are carried out.
    pub conditions: Vec<String>,
    /// The operations of one iteration. Of a condition on numbers, both sides count.
    pub operations: Tally,
}

/// What a function is called for, once each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Each {
    /// The flow as a whole, whose loops are lines of the function.
    Iterations,
    /// The sites of a lattice.
    Sites,
    /// The bodies.
    Bodies,
    /// Two bodies, in one order.
    Pairs,
    /// Two bodies, in both orders.
    OrderedPairs,
}

impl Place {
    /// Whether the operations are carried out more than once.
    fn repeats(&self) -> bool {
        self.each != Each::Iterations || !self.loops.is_empty()
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { each, loops, conditions, operations } = self;
        let each = match each {
            Each::Iterations => None,
            Each::Sites => Some("per site"),
            Each::Bodies => Some("per body"),
            Each::Pairs => Some("per pair"),
            Each::OrderedPairs => Some("per ordered pair"),
        };
        match (each, &loops[..]) {
            (None, []) => f.write_str("once")?,
            (None, loops) => write!(f, "per iteration of {}", loops.join(", "))?,
            (Some(each), []) => f.write_str(each)?,
            (Some(each), loops) => write!(f, "{each} and iteration of {}", loops.join(", "))?,
        }
        if !conditions.is_empty() {
            write!(f, ", if {}", conditions.join(" and "))?;
        }
        write!(f, ": {operations}")
    }
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
            self.explicit.iter().try_for_each(|line| writeln!(f, "{line}"))?;
            for FlowOfPart { name, form, way, slower } in &self.flows_of_parts {
                let form = form.map_or_else(|| (*way).to_owned(), |form| form.to_string());
                writeln!(f, "flow of {name}: {form}")?;
                slower.iter().try_for_each(|slower| writeln!(f, "  {slower}"))?;
            }
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
        for place in &self.places {
            write!(f, "\n  {place}")?;
        }
        if let Some(cost) = self.cost {
            write!(f, "\n  layout = {}; cost: proportional to {cost}", self.form.name())?;
        }
        self.slower.iter().try_for_each(|slower| write!(f, "\n  {slower}"))
    }
}

/// What is derived from `input`, whose model is known to make sense.
pub(crate) fn report(input: &Input, mut model: Model) -> Report {
    // In the order in which generated code is made, so that nodes have the same numbers.
    let mut stated = [model.kinetic, model.potential];
    model.choose_in_the_middle();
    let written = gradients(&mut model);
    let energies = [model.kinetic, model.potential];
    let equations = prose::equations(&mut model, &written[0], &written[1]);
    let pattern = recognise(&mut model, [&written[0], &written[1]]);
    let restated = pattern.restate(&mut model, &mut stated[1]).then(|| gradients(&mut model));
    let [kinetic, potential] = restated.as_ref().unwrap_or(&written);
    let places = places::of_flows(&mut model, [kinetic, potential], &pattern);
    let of_energies = places::of_energies(&mut model, stated, &pattern);
    let (forms, others) = forms(&mut model, [kinetic, potential], &pattern);
    let others = [None, others];
    let slower = [(kinetic, Part::Momentum), (potential, Part::Position)].map(|(gradient, part)| {
        let lost = lost(&mut model, gradient, part, &pattern);
        slower(&model, &lost)
    });
    let parts = prose::parts(&model);
    let values: Vec<_> = written.iter().flatten().map(|contribution| contribution.value).collect();
    let all = [&values[..], &energies].concat();
    let graph = &mut model.graph;
    let [flows, energies, together] = [values, energies.into(), all].map(|roots| {
        let lowered = lower(graph, &roots, |graph, id| graph.is_prepared(id));
        graph.cost(&lowered)
    });
    let [drift, kick] = [0, 1].map(|part| Flow {
        form: forms[part],
        others: others[part],
        places: places[part].clone(),
        cost: (part == 1 && places[part].iter().any(Place::repeats)).then(|| forms[part].cost()),
        slower: slower[part].clone(),
    });
    let explicit = ways::explicit(&mut model);
    let whole = matches!(model.split, Split::Whole);
    let flows_of_parts = if model.is_separable() { Vec::new() } else { flows_of_parts(&mut model) };
    Report {
        system: readable(&input.item.self_ty),
        compose: match &input.compose {
            None if whole => "ImplicitMidpoint".to_owned(),
            None => "Verlet".to_owned(),
            Some(Compose::Named(path)) => readable(path),
            Some(Compose::InPlace(sequence, _)) => sequence.text(),
        },
        equations,
        parts,
        quadratic_kinetic: model.quadratic,
        whole,
        separable: model.is_separable() && model.jacobi().is_none(),
        autonomous: model.autonomous,
        drift,
        kick,
        energies: of_energies,
        flows_of_parts,
        explicit,
        operations_written: flows.written,
        operations_shared: flows.shared,
        operations_of_energies: energies.shared,
        operations_together: together.shared,
    }
}

/// The faster layouts that do not apply, in words.
fn slower(model: &Model, lost: &[Lost]) -> Vec<Slower> {
    let slower = lost.iter().map(|Lost { form, by, reason }| {
        let [reason, instead] = reason.texts();
        let range = by.map(|by| prose::ranges(model, LoopSet::of(by)).concat());
        Slower { than: *form, range, reason, instead }
    });
    slower.collect()
}

fn flows_of_parts(model: &mut Model) -> Vec<FlowOfPart> {
    let count = model.parts.len();
    let part = |number: usize| {
        let (form, lost) = of_part(model, number).unzip();
        let (name, slower) = (model.parts[number].name(), slower(model, &lost.unwrap_or_default()));
        FlowOfPart { name, form, way: ways::way(&model.parts[number].form), slower }
    };
    (0..count).map(part).collect()
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
