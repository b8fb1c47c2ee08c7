//! The function that passes the conditions of a Hamiltonian to the runtime, which ends steps where they change.
//!
//! In: gradients. Out: code that evaluates every condition at the same place as a gradient, within its loops and
//! branches. Always true: a Hamiltonian without edges has no such code.

use crate::{
    differentiate::Contribution,
    emit::printer::{
        block::Emitter,
        frame::Frame,
        function::{Body, Lines},
    },
    graph::{Comparison, Graph, Node, NodeId, Scope},
    pattern::stores::lower_roots,
    program::{Constraints, Sink, Store, Watched},
    taylor::is_power,
};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::{BTreeSet, HashMap};

/// The items of the implementation of `Recurrences` about edges, if there are any.
pub(crate) fn items(emitter: &mut Emitter<'_>, gradients: [&[Contribution]; 2]) -> Option<TokenStream> {
    let stores = stores(emitter, gradients)?;
    let named = compared(&emitter.model.graph, &stores);
    let constraints = Constraints { named, ..Constraints::default() };
    let Lines { tokens, .. } = emitter.evaluate_with(&Frame::Edges, &[], &stores, &constraints);
    let (runtime, scalar) = (&emitter.names.runtime, &emitter.names.scalar);
    let lines = Body::new(tokens);
    let stride = lines.mentions("stride").then(|| quote!(let stride = q.stride();));
    let lines = lines.0;
    let body = Body::new(quote!(#stride #lines));
    let [parameters, length, q, p, time] = ["parameters", "length", "q", "p", "time"].map(|name| body.argument(name));
    let body = &body.0;
    Some(quote! {
        const HAS_EDGES: bool = true;

        fn edges<#scalar: #runtime::Real>(
            #parameters: &Self::Parameters<#scalar>,
            #length: usize,
            #q: &#runtime::Coefficients<'_, #scalar>,
            #p: &#runtime::Coefficients<'_, #scalar>,
            #time: #scalar,
            watch: &mut dyn #runtime::Watch<#scalar>,
        ) { #body }
    })
}

/// What is shown to the runtime, where the gradients evaluate it.
fn stores(emitter: &mut Emitter<'_>, gradients: [&[Contribution]; 2]) -> Option<Vec<Store>> {
    let graph = &mut emitter.model.graph;
    let contributions = || gradients.into_iter().flatten();
    let values: Vec<NodeId> = contributions().flat_map(Contribution::values).collect();
    let reachable = graph.reachable(values);
    let mut walk = Walk { kinked: kinked_radicands(graph, &reachable), ..Walk::default() };
    if !reachable.iter().any(|id| walk.is_edge(graph, *id)) {
        return None;
    }
    for Contribution { context, value, .. } in contributions() {
        let mut around = Vec::new();
        for scope in context {
            if let Some(condition) = scope.condition() {
                walk.visit(graph, &mut around, condition);
            }
            around.push(*scope);
        }
        walk.visit(graph, &mut around, *value);
    }
    let conditions = walk.found.iter().flat_map(|store| store.context.iter().filter_map(Scope::condition));
    let roots: Vec<NodeId> = walk.found.iter().map(|store| store.value).chain(conditions).collect();
    let lowered = lower_roots(emitter.model, &roots);
    let known: HashMap<NodeId, NodeId> = roots.into_iter().zip(lowered).collect();
    let of = |scope: &Scope| match *scope {
        Scope::Branch(condition, holds) => Scope::Branch(known[&condition], holds),
        Scope::Loop(_) => *scope,
    };
    let stores = walk.found.iter().map(|store| Store {
        context: store.context.iter().map(of).collect(),
        sink: store.sink,
        value: known[&store.value],
    });
    let stores: Vec<Store> = stores.collect();
    (!stores.is_empty()).then_some(stores)
}

/// The comparisons that change along a motion: each is computed in a line of its own, where it is shown.
fn compared(graph: &Graph, stores: &[Store]) -> BTreeSet<NodeId> {
    let conditions = stores.iter().flat_map(|store| store.context.iter().filter_map(Scope::condition));
    let reachable = graph.reachable(stores.iter().map(|store| store.value).chain(conditions));
    reachable.into_iter().filter(|id| graph.is_edge_of_motion(*id)).collect()
}

/// The radicands that may be zero where their root has a kink and no pole: sums of squares with a power of a half, of minus
/// a half or above. The motion near a pole shows in the coefficients, and steps end in front of it.
fn kinked_radicands(graph: &Graph, reachable: &[NodeId]) -> BTreeSet<NodeId> {
    let radicand = |id: &NodeId| match graph.node(*id) {
        Node::Power(a, -1..) | Node::Power(a, 1..) if is_root(graph.node(*id)) => Some(a),
        Node::Binary(function, a, b) if is_power(function) && graph.is_prepared(b) => Some(a),
        _ => None,
    };
    reachable.iter().filter_map(radicand).filter(|id| touches_zero(graph, *id)).collect()
}

fn is_root(node: Node) -> bool {
    matches!(node, Node::Power(_, halves) if halves % 2 != 0)
}

/// Whether a value moves and can be zero, but not below.
pub(super) fn touches_zero(graph: &Graph, id: NodeId) -> bool {
    fn may_vanish(graph: &Graph, id: NodeId) -> bool {
        let of = |id| may_vanish(graph, id);
        match graph.node(id) {
            _ if graph.is_prepared(id) => graph.as_constant(id).is_none_or(|constant| constant == 0.0),
            Node::Power(_, halves) => halves > 0 && halves % 4 == 0,
            Node::Add(a, b) => of(a) && of(b),
            Node::Mul(a, b) if graph.is_prepared(a) => of(b),
            Node::Mul(a, b) => a == b || of(a) && of(b),
            Node::Div(a, b) => graph.is_prepared(b) && of(a),
            Node::Sum(_, body) => of(body),
            Node::Select(_, a, b) => of(a) || of(b),
            _ => false,
        }
    }
    !graph.is_prepared(id) && may_vanish(graph, id)
}

/// A walk through gradients that collects what is shown to the runtime.
#[derive(Default)]
struct Walk {
    kinked: BTreeSet<NodeId>,
    /// The contexts in which each node was visited.
    visited: HashMap<NodeId, Vec<Vec<Scope>>>,
    found: Vec<Store>,
}

impl Walk {
    /// Whether a node by itself has an edge.
    fn is_edge(&self, graph: &Graph, id: NodeId) -> bool {
        match graph.node(id) {
            _ if graph.is_prepared(id) => false,
            Node::Compare(..) => graph.is_edge_of_motion(id),
            Node::Power(a, _) => is_root(graph.node(id)) && self.kinked.contains(&a),
            Node::Unary(function, a) => graph.moves(a) && function.row().piecewise,
            Node::Binary(function, a, b) => {
                self.kinked.contains(&a) && is_power(function)
                    || function.row().piecewise
                        && (graph.moves(a) || graph.moves(b))
                        && ![a, b].iter().any(|id| graph.is_huge(*id))
            }
            _ => false,
        }
    }

    /// Collects what a node is made of in these loops and branches.
    fn visit(&mut self, graph: &mut Graph, around: &mut Vec<Scope>, id: NodeId) {
        if graph.is_prepared(id) {
            return;
        }
        let visited = self.visited.entry(id).or_default();
        if visited.iter().any(|context| context.iter().all(|scope| around.contains(scope))) {
            return;
        }
        visited.push(around.clone());
        match graph.node(id) {
            Node::Sum(by, body) => self.within(graph, around, Scope::Loop(by), body),
            Node::Select(condition, a, b) => {
                self.visit(graph, around, condition);
                self.within(graph, around, Scope::Branch(condition, true), a);
                self.within(graph, around, Scope::Branch(condition, false), b);
            }
            node => node.children().for_each(|child| self.visit(graph, around, child)),
        }
        if self.is_edge(graph, id) {
            self.found_at(graph, around, id);
        }
    }

    fn within(&mut self, graph: &mut Graph, around: &mut Vec<Scope>, scope: Scope, id: NodeId) {
        around.push(scope);
        self.visit(graph, around, id);
        around.pop();
    }

    /// What is shown of a node.
    fn found_at(&mut self, graph: &mut Graph, around: &[Scope], id: NodeId) {
        let zero = graph.constant(0.0);
        let (shown, value) = match graph.node(id) {
            Node::Power(a, _) => (Watched::Root, a),
            Node::Unary(function, a) => match function.name() {
                name @ ("floor" | "ceil" | "trunc" | "round" | "round_ties_even") => (Watched::Level(name), a),
                _ => (Watched::Side, graph.compare(Comparison::Less, a, zero)),
            },
            Node::Binary(function, a, b) => match function.name() {
                "remainder" => (Watched::Level("trunc"), graph.div(a, b)),
                "hypot" => {
                    let squares = [a, b].map(|side| graph.power(side, 4));
                    (Watched::Root, graph.add(squares[0], squares[1]))
                }
                // The angle jumps where the ordinate changes its sign at a negative abscissa.
                "atan2" => {
                    let [negative, below] = [b, a].map(|side| graph.compare(Comparison::Less, side, zero));
                    self.found.push(Store {
                        context: around.to_vec(),
                        sink: Sink::Watch(Watched::Side),
                        value: negative,
                    });
                    let context = around.iter().copied().chain([Scope::Branch(negative, true)]).collect();
                    self.found.push(Store { context, sink: Sink::Watch(Watched::Side), value: below });
                    return;
                }
                "min" | "max" => (Watched::Side, graph.compare(Comparison::Less, a, b)),
                _ => (Watched::Root, a),
            },
            _ => (Watched::Side, id),
        };
        let store = Store { context: around.to_vec(), sink: Sink::Watch(shown), value };
        if !self.found.contains(&store) {
            self.found.push(store);
        }
    }
}
