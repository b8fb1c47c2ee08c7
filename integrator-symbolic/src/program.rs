//! What is computed where: nodes and the places their values go to become nested blocks.
//!
//! Comes in: lowered nodes, each with its destination. Goes out: a block of lets, loops and destinations, in order.
//! Always true: a node is computed in the outermost loop that it can be computed in, once; loops over the same range
//! that do not wait for each other are one loop; a node has a name if it is used twice or in a loop inside its own.

use crate::graph::{Element, Graph, Node, NodeId, index::LoopId};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Where a value goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sink {
    /// It is added to a coordinate.
    Update(Element),
    /// It is added to the gradient's component for a coordinate, in a buffer.
    Collect(Element),
    /// It is what the function returns.
    Return,
}

/// A value, where it goes, and the loops around that.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placed {
    pub(crate) context: Vec<LoopId>,
    pub(crate) sink: Sink,
    pub(crate) value: NodeId,
}

/// One line of a block.
#[derive(Debug, PartialEq)]
pub(crate) enum Item {
    /// A named value.
    Let(NodeId),
    /// Sine and cosine of one argument, both named.
    SineCosine { argument: NodeId, sine: NodeId, cosine: NodeId },
    /// A loop, with the sums that it accumulates.
    Loop { by: LoopId, sums: Vec<NodeId>, body: Vec<Item> },
    /// A destination.
    Sink(Sink, NodeId),
}

/// The body of a function.
#[derive(Debug, PartialEq)]
pub(crate) struct Program {
    pub(crate) items: Vec<Item>,
    /// The nodes that have a name.
    pub(crate) named: BTreeSet<NodeId>,
}

/// Orders the computation of everything that is placed. `leaf` tells which nodes are read, not computed.
pub(crate) fn schedule(graph: &Graph, placed: &[Placed], leaf: impl Fn(&Graph, NodeId) -> bool) -> Program {
    let mut scheduler = Scheduler { graph, leaf: &leaf, scopes: vec![Scope::default()] };
    for Placed { context, sink, value } in placed {
        let mut path = vec![0];
        for by in context {
            let stage = scheduler.stage(&path, *value, &mut HashMap::new()) + 1;
            path.push(scheduler.inner(&path, *by, stage));
        }
        scheduler.require(&path, *value);
        let last = path[path.len() - 1];
        scheduler.scopes[last].sinks.push((*sink, *value));
    }
    let named = scheduler.named();
    Program { items: scheduler.items(0, &named), named }
}

/// A block under construction.
#[derive(Default)]
struct Scope {
    by: Option<LoopId>,
    /// Inner loops by stage, in order of their making: a loop of stage `k` waits for loops of stage `k - 1` beside it.
    inner: BTreeMap<u32, Vec<usize>>,
    /// The nodes computed here, by what they wait for.
    nodes: BTreeMap<NodeId, u32>,
    /// The sums that this loop accumulates.
    sums: BTreeSet<NodeId>,
    sinks: Vec<(Sink, NodeId)>,
}

struct Scheduler<'g, L> {
    graph: &'g Graph,
    leaf: &'g L,
    scopes: Vec<Scope>,
}

impl<L: Fn(&Graph, NodeId) -> bool> Scheduler<'_, L> {
    /// How many scopes of `path` a node is computed inside of.
    fn depth(&self, path: &[usize], id: NodeId) -> usize {
        let loops = self.graph.loops_of(id);
        let inside = |scope: &usize| self.scopes[*scope].by.is_some_and(|by| loops.contains(by));
        path.iter().rposition(inside).map_or(1, |deepest| deepest + 1)
    }

    /// Whether a node depends on a loop that is not around `path`.
    fn is_inner(&self, path: &[usize], id: NodeId) -> bool {
        self.graph.loops_of(id).iter().any(|by| path.iter().all(|scope| self.scopes[*scope].by != Some(by)))
    }

    /// How many loops beside each other a node waits for, counted in the last scope of `path`.
    fn stage(&self, path: &[usize], id: NodeId, known: &mut HashMap<NodeId, u32>) -> u32 {
        if let Some(stage) = known.get(&id) {
            return *stage;
        }
        let inner = self.is_inner(path, id);
        let stage = if (self.leaf)(self.graph, id) || (!inner && self.depth(path, id) < path.len()) {
            0
        } else {
            let node = self.graph.node(id);
            let waits = node.children().map(|child| self.stage(path, child, known)).max().unwrap_or(0);
            waits + u32::from(!inner && matches!(node, Node::Sum(..)))
        };
        known.insert(id, stage);
        stage
    }

    /// The loop over `by` of this stage inside the last scope of `path`.
    fn inner(&mut self, path: &[usize], by: LoopId, stage: u32) -> usize {
        let last = path[path.len() - 1];
        let beside = self.scopes[last].inner.entry(stage).or_default().clone();
        if let Some(known) = beside.into_iter().find(|scope| self.scopes[*scope].by == Some(by)) {
            return known;
        }
        let made = self.scopes.len();
        self.scopes.push(Scope { by: Some(by), ..Scope::default() });
        self.scopes[last].inner.entry(stage).or_default().push(made);
        made
    }

    /// Sees to it that a node is computed for use in the last scope of `path`.
    fn require(&mut self, path: &[usize], id: NodeId) {
        let path = &path[..self.depth(path, id)];
        let home = path[path.len() - 1];
        if self.scopes[home].nodes.contains_key(&id) || (self.leaf)(self.graph, id) {
            return;
        }
        let stage = self.stage(path, id, &mut HashMap::new());
        self.scopes[home].nodes.insert(id, stage);
        let node = self.graph.node(id);
        if let Node::Sum(by, body) = node {
            let inner = self.inner(path, by, stage);
            self.scopes[inner].sums.insert(id);
            let path: Vec<usize> = path.iter().copied().chain([inner]).collect();
            self.require(&path, body);
        } else {
            for child in node.children() {
                self.require(path, child);
            }
        }
    }

    /// Sums, what is used twice, and what is used inside a loop that it is computed outside of.
    fn named(&self) -> BTreeSet<NodeId> {
        let mut uses: HashMap<NodeId, u32> = HashMap::new();
        let mut named = BTreeSet::new();
        for scope in &self.scopes {
            let passes = |id: &NodeId| matches!(self.graph.node(*id), Node::Sum(..) | Node::Neg(_));
            let from_nodes = scope.nodes.keys().filter(|id| !passes(id)).flat_map(|id| self.graph.node(*id).children());
            let from_sums = scope.sums.iter().flat_map(|id| self.graph.node(*id).children());
            let from_sinks = scope.sinks.iter().map(|(_, value)| *value);
            for used in from_nodes.chain(from_sums).chain(from_sinks) {
                // A change of sign costs nothing: it is written where it is used, and what is under it is used there.
                let used = match self.graph.node(used) {
                    Node::Neg(inner) if !(self.leaf)(self.graph, used) => inner,
                    _ => used,
                };
                *uses.entry(used).or_default() += 1;
                if !scope.nodes.contains_key(&used) {
                    named.insert(used);
                }
            }
            named.extend(scope.nodes.keys().filter(|id| matches!(self.graph.node(**id), Node::Sum(..))));
        }
        named.extend(uses.into_iter().filter(|(_, count)| *count > 1).map(|(id, _)| id));
        named.retain(|id| !(self.leaf)(self.graph, *id));
        self.name_pairs(&mut named);
        named
    }

    /// Sine and cosine of one argument that are computed in one scope are both named.
    fn name_pairs(&self, named: &mut BTreeSet<NodeId>) {
        for scope in &self.scopes {
            for (sine, cosine, _) in self.pairs(scope) {
                named.extend([sine, cosine]);
            }
        }
    }

    fn pairs(&self, scope: &Scope) -> Vec<(NodeId, NodeId, NodeId)> {
        let of = |name: &str| -> HashMap<NodeId, NodeId> {
            let calls = scope.nodes.keys().filter_map(|id| match self.graph.node(*id) {
                Node::Unary(function, argument) if function.name() == name => Some((argument, *id)),
                _ => None,
            });
            calls.collect()
        };
        let (sines, cosines) = (of("sin"), of("cos"));
        let mut pairs: Vec<_> = sines
            .into_iter()
            .filter_map(|(argument, sine)| cosines.get(&argument).map(|cosine| (sine, *cosine, argument)))
            .collect();
        pairs.sort();
        pairs
    }

    /// The lines of a scope: values that wait for nothing, then the first loops, then what waits for these, ...
    fn items(&self, scope: usize, named: &BTreeSet<NodeId>) -> Vec<Item> {
        let scope = &self.scopes[scope];
        let pairs = self.pairs(scope);
        let last = scope.nodes.values().chain(scope.inner.keys()).max().copied().unwrap_or(0);
        let mut items = Vec::new();
        for stage in 0..=last {
            for inner in scope.inner.get(&stage).into_iter().flatten() {
                let Scope { by: Some(by), sums, .. } = &self.scopes[*inner] else { continue };
                let body = self.items(*inner, named);
                items.push(Item::Loop { by: *by, sums: sums.iter().copied().collect(), body });
            }
            let of_stage = scope.nodes.iter().filter(|(id, own)| **own == stage && named.contains(id));
            for (id, _) in of_stage {
                let pair = pairs.iter().find(|(sine, cosine, _)| sine == id || cosine == id);
                match (pair, self.graph.node(*id)) {
                    (_, Node::Sum(..)) => {}
                    (Some((sine, cosine, argument)), _) if id == sine.min(cosine) => {
                        items.push(Item::SineCosine { argument: *argument, sine: *sine, cosine: *cosine });
                    }
                    (Some(_), _) => {}
                    (None, _) => items.push(Item::Let(*id)),
                }
            }
        }
        items.extend(scope.sinks.iter().map(|(sink, value)| Item::Sink(*sink, *value)));
        items
    }
}
