//! Loops with independent iterations, so that several can be computed in SIMD lanes.
//!
//! In: a loop of a program. Out: its innermost lines with the loops around them, and the values that an iteration needs
//! from outside. The result is nothing if an iteration passes a value to another one or to the surrounding lines.
//! Always true: an iteration reads coordinates, numbers that are constant in a run, and values that are the same for
//! all iterations.

use super::{Item, Sink};
use crate::graph::{Element, Graph, Node, NodeId, index::LoopId};
use std::collections::{BTreeMap, BTreeSet};

/// A loop nest: the innermost lines, the loops around them (outermost first), and the operands of an iteration.
#[derive(Debug)]
pub(crate) struct Nest<'p> {
    pub(crate) loops: Vec<LoopId>,
    pub(crate) body: Vec<&'p Item>,
    /// The coordinates that an iteration loads.
    pub(crate) reads: Vec<(NodeId, Element)>,
    /// The numbers that an iteration has for a whole run.
    pub(crate) constants: Vec<NodeId>,
    /// The predicates of an iteration: conditions that hold for a whole run, or do not.
    pub(crate) predicates: Vec<NodeId>,
    /// The loop invariants: prepared numbers that are the same for all iterations, and values with a name.
    pub(crate) invariants: Vec<NodeId>,
    /// The coordinates that an iteration moves.
    pub(crate) targets: Vec<Element>,
    /// The sums of the surrounding lines that an iteration adds to: none, unless the nest may have some.
    pub(crate) sums: Vec<NodeId>,
}

/// The program around a loop nest.
pub(crate) struct NestContext<'s> {
    pub(crate) graph: &'s Graph,
    /// The nodes that have a name.
    pub(crate) named: &'s BTreeSet<NodeId>,
    /// The nodes whose coefficients of all orders a node is computed from.
    pub(crate) operands: &'s BTreeMap<NodeId, Vec<NodeId>>,
}

impl NestContext<'_> {
    /// The nests that a loop consists of.
    pub(crate) fn nests<'p>(&self, by: LoopId, body: &'p [Item]) -> Option<Vec<Nest<'p>>> {
        let mut nests = Vec::new();
        self.split(&mut vec![by], body, &mut nests)?;
        let made: Vec<BTreeSet<NodeId>> = nests.iter().map(|(_, body)| made(body)).collect();
        let of_all: BTreeSet<NodeId> = made.iter().flatten().copied().collect();
        nests
            .into_iter()
            .zip(made)
            .map(|((loops, body), own)| {
                let elsewhere = of_all.difference(&own).copied().collect();
                let mut needs = Needs::new(self, own, elsewhere);
                needs.of_lines(&body)?;
                Some(needs.nest(loops, body))
            })
            .collect()
    }

    /// A loop without others inside, which may add to sums of the surrounding lines. A branch reads no coordinate that the
    /// lines around it do not read.
    pub(crate) fn innermost<'p>(&self, by: LoopId, body: Vec<&'p Item>) -> Option<Nest<'p>> {
        if body.iter().any(|item| matches!(item, Item::Loop { .. })) {
            return None;
        }
        let mut needs = Needs { may_sum: true, ..Needs::new(self, made(&body), BTreeSet::new()) };
        let (branches, lines): (Vec<_>, Vec<_>) =
            body.iter().copied().partition(|item| matches!(item, Item::Branch { .. }));
        needs.of_lines(&lines)?;
        for branch in &branches {
            if let Item::Branch { condition, .. } = branch {
                needs.of(*condition)?;
            }
        }
        let read = needs.reads.len();
        needs.of_lines(&branches)?;
        (needs.reads.len() == read).then(|| needs.nest(vec![by], body))
    }

    /// Whether all loops are such nests, and every iteration reads coordinates of its own first (without it, moves
    /// them), so that neighbours are read by iterations beside each other.
    pub(crate) fn reads_neighbours(&self, items: &[Item]) -> bool {
        let mut nests = Vec::new();
        for item in items {
            match item {
                Item::Loop { by, body } => match self.nests(*by, body) {
                    Some(found) => nests.extend(found),
                    None => return false,
                },
                Item::Branch { body, .. } if body.iter().any(|item| matches!(item, Item::Loop { .. })) => return false,
                _ => {}
            }
        }
        let loops = &self.graph.loops;
        let has_its_own = |Nest { loops: around, reads, targets, .. }: &Nest<'_>| {
            let first = reads.first().map(|(_, element)| *element).or(targets.first().copied());
            first.is_some_and(|first| {
                let of_element = loops.of_element(first);
                loops.is_without_lists(first.index) && around.iter().all(|by| of_element.contains(*by))
            })
        };
        !nests.is_empty() && nests.iter().all(has_its_own)
    }

    /// Takes loops and the lines beside them apart.
    fn split<'p>(
        &self,
        loops: &mut Vec<LoopId>,
        body: &'p [Item],
        nests: &mut Vec<(Vec<LoopId>, Vec<&'p Item>)>,
    ) -> Option<()> {
        let own: Vec<&Item> = body.iter().filter(|item| !matches!(item, Item::Loop { .. })).collect();
        // What a loop inside adds up belongs to the lines around it.
        if own.iter().any(
            |item| matches!(item, Item::Begin(id) if matches!(self.graph.node(*id), Node::Sum(..) | Node::Fold(..))),
        ) {
            return None;
        }
        if !own.is_empty() {
            nests.push((loops.clone(), own));
        }
        for item in body {
            if let Item::Loop { by, body } = item {
                loops.push(*by);
                self.split(loops, body, nests)?;
                loops.pop();
            }
        }
        Some(())
    }
}

/// The values that lines make.
fn made(lines: &[&Item]) -> BTreeSet<NodeId> {
    let mut found = BTreeSet::new();
    for line in lines {
        match line {
            Item::Begin(id) => {
                found.insert(*id);
            }
            Item::Branch { body, .. } => found.extend(made(&body.iter().collect::<Vec<_>>())),
            _ => found.extend(line.named()),
        }
    }
    found
}

/// What the lines of an iteration need.
struct Needs<'s> {
    around: &'s NestContext<'s>,
    /// What the lines make.
    own: BTreeSet<NodeId>,
    /// What other iterations or other lines of the loop make.
    elsewhere: BTreeSet<NodeId>,
    seen: BTreeSet<NodeId>,
    reads: Vec<(NodeId, Element)>,
    constants: Vec<NodeId>,
    predicates: Vec<NodeId>,
    invariants: Vec<NodeId>,
    targets: Vec<Element>,
    sums: Vec<NodeId>,
    /// Whether the lines may add to sums of the lines around them.
    may_sum: bool,
}

impl<'s> Needs<'s> {
    fn new(around: &'s NestContext<'s>, own: BTreeSet<NodeId>, elsewhere: BTreeSet<NodeId>) -> Self {
        Self {
            around,
            own,
            elsewhere,
            seen: BTreeSet::new(),
            reads: Vec::new(),
            constants: Vec::new(),
            predicates: Vec::new(),
            invariants: Vec::new(),
            targets: Vec::new(),
            sums: Vec::new(),
            may_sum: false,
        }
    }

    fn nest<'p>(self, loops: Vec<LoopId>, body: Vec<&'p Item>) -> Nest<'p> {
        let Self { reads, constants, predicates, invariants, targets, sums, .. } = self;
        Nest { loops, body, reads, constants, predicates, invariants, targets, sums }
    }

    fn of_lines(&mut self, lines: &[&Item]) -> Option<()> {
        for line in lines {
            match line {
                Item::Let(_) | Item::SineCosine { .. } => line.named().try_for_each(|id| self.made(id))?,
                Item::Begin(_) => {}
                Item::Branch { condition, body, .. } => {
                    self.of(*condition)?;
                    self.of_lines(&body.iter().collect::<Vec<_>>())?;
                }
                Item::Choose { value, .. } => self.of(*value)?,
                Item::Sink(Sink::Collect(element), value) => {
                    self.targets.push(*element);
                    self.of(*value)?;
                }
                Item::Add { sum, value } if self.may_sum => {
                    if !self.sums.contains(sum) {
                        self.sums.push(*sum);
                    }
                    self.of(*value)?;
                }
                Item::Loop { .. } | Item::Add { .. } | Item::Sink(..) => return None,
            }
        }
        Some(())
    }

    /// A line that gives a value a name.
    fn made(&mut self, id: NodeId) -> Option<()> {
        if self.around.graph.is_prepared(id) {
            return self.of(id);
        }
        for operand in self.around.operands.get(&id).into_iter().flatten().copied() {
            if !self.around.graph.node(operand).is_read() && !self.own.contains(&operand) {
                return None;
            }
            self.of(operand)?;
        }
        self.parts(id)
    }

    fn parts(&mut self, id: NodeId) -> Option<()> {
        self.around.graph.node(id).children().try_for_each(|child| self.of(child))
    }

    /// A value that a line reads.
    fn of(&mut self, id: NodeId) -> Option<()> {
        let graph = self.around.graph;
        let node = graph.node(id);
        if matches!(node, Node::Constant(_) | Node::Time | Node::Step) || !self.seen.insert(id) {
            return Some(());
        }
        match node {
            Node::Coordinate(element) => self.reads.push((id, element)),
            Node::Neg(_) => return self.parts(id),
            _ if graph.is_prepared(id) && node.is_condition() => self.predicates.push(id),
            _ if graph.is_prepared(id) && graph.loops_of(id).is_empty() => self.invariants.push(id),
            _ if graph.is_prepared(id) => self.constants.push(id),
            _ if self.own.contains(&id) => {}
            // A condition of the lines around is one of numbers that are not side by side.
            _ if self.elsewhere.contains(&id) || node.is_condition() && self.around.named.contains(&id) => return None,
            _ if self.around.named.contains(&id) => self.invariants.push(id),
            _ => return self.parts(id),
        }
        Some(())
    }
}
