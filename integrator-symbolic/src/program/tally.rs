//! The operations of a program, by the loops and conditions around them.
//!
//! In: a program and the values that its lines read rather than compute. Out: a tally for each nest. Always true:
//! an operation counts where its line is, once per iteration of the loops around it in which the conditions around it hold.

use super::{Item, Program, Sink};
use crate::graph::{ExternalId, Fold, Graph, Node, NodeId, Tally, index::LoopId};
use std::collections::{BTreeMap, HashMap};

/// The tallies of programs, by the loops and the conditions around, outermost first.
pub(crate) type ByScopes = BTreeMap<Around, Tally>;

/// The loops around a line, and the conditions, each with whether it holds.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Around {
    pub(crate) loops: Vec<LoopId>,
    pub(crate) conditions: Vec<(NodeId, bool)>,
}

/// What decides which values lines compute, and how methods of the user are named.
pub(crate) struct Counting<'c> {
    pub(crate) graph: &'c Graph,
    /// Whether a value is read.
    pub(crate) leaf: &'c dyn Fn(NodeId) -> bool,
    pub(crate) external: &'c dyn Fn(ExternalId) -> String,
}

impl Counting<'_> {
    /// Adds the operations of a program.
    pub(crate) fn add(&self, program: &Program, into: &mut ByScopes) {
        let mut counter = Counter { of: self, program, around: Around::default(), begun: HashMap::new(), into };
        counter.lines(&program.items);
    }
}

/// A program in the middle of its count.
struct Counter<'c> {
    of: &'c Counting<'c>,
    program: &'c Program,
    /// What is around the present line.
    around: Around,
    /// How many conditions were around the beginning of a sum or a choice.
    begun: HashMap<NodeId, usize>,
    into: &'c mut ByScopes,
}

impl Counter<'_> {
    fn lines(&mut self, lines: &[Item]) {
        for line in lines {
            self.line(line);
        }
    }

    fn line(&mut self, line: &Item) {
        match line {
            Item::Let(id) => self.computation(*id),
            Item::SineCosine { argument, .. } => {
                self.call("sin");
                self.call("cos");
                self.value(*argument);
            }
            Item::Begin(id) => {
                self.begun.insert(*id, self.around.conditions.len());
            }
            Item::Loop { by, body } => {
                self.around.loops.push(*by);
                self.lines(body);
                self.around.loops.pop();
            }
            Item::Branch { condition, holds, body } => {
                self.around.conditions.push((*condition, *holds));
                self.lines(body);
                self.around.conditions.pop();
            }
            Item::Add { sum, value } => {
                match self.of.graph.node(*sum) {
                    Node::Fold(Fold::Product, ..) => self.tally().multiplications += 1,
                    Node::Fold(Fold::Largest, ..) => self.call("max"),
                    _ => self.tally().additions += 1,
                }
                self.selection(self.begun.get(sum).copied().unwrap_or_default());
                self.value(*value);
            }
            Item::Choose { choice, value } => {
                self.selection(self.begun.get(choice).copied().unwrap_or_default());
                self.value(*value);
            }
            Item::Sink(sink, value) => {
                match sink {
                    Sink::Update(_) | Sink::Collect(_) => {
                        self.tally().coordinates += 1;
                        self.selection(0);
                    }
                    Sink::Assign(_) | Sink::Contribution(_) => self.tally().coordinates += 1,
                    _ => {}
                }
                self.value(*value);
            }
        }
    }

    /// A value is selected where a condition that was not around `begun` is around the line.
    fn selection(&mut self, begun: usize) {
        self.tally().branches += u64::from(self.around.conditions.len() > begun);
    }

    /// A value that a line reads: without a name, the line computes it.
    fn value(&mut self, id: NodeId) {
        if !self.program.named.contains(&id) {
            self.computation(id);
        }
    }

    fn computation(&mut self, id: NodeId) {
        let Counting { graph, leaf, external } = self.of;
        if leaf(id) {
            return;
        }
        let node = graph.node(id);
        match node {
            Node::Add(..) => self.tally().additions += 1,
            // That by the step belongs to the coordinate moved.
            Node::Mul(a, b) => {
                let by_step = [a, b].into_iter().any(|factor| graph.node(graph.without_sign(factor)) == Node::Step);
                self.tally().multiplications += u64::from(!by_step);
            }
            Node::Div(..) => self.tally().divisions += 1,
            Node::Power(..) => self.tally().roots += 1,
            Node::Unary(function, _) | Node::Binary(function, ..) => self.call(function.name()),
            Node::External(id, _) => self.call(&external(id)),
            Node::Select(..) => self.tally().branches += 1,
            _ => {}
        }
        for child in node.children() {
            self.value(child);
        }
    }

    fn tally(&mut self) -> &mut Tally {
        self.into.entry(self.around.clone()).or_default()
    }

    fn call(&mut self, name: &str) {
        *self.tally().functions.entry(name.to_owned()).or_default() += 1;
    }
}
