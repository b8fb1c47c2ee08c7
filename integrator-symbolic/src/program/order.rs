//! The lines of a block, in an order in which the operands of each come first.

use super::{Block, End, Item, Scheduler, unwritten::Unwritten};
use crate::graph::{Graph, Node, NodeId, Scope};
use std::collections::{BTreeSet, HashMap};

impl<L: Fn(&Graph, NodeId) -> bool> Scheduler<'_, L> {
    /// Named values as soon as they can be computed, inner blocks as soon as nothing else can, destinations last; `None`
    /// if two blocks wait for each other.
    pub(super) fn items(&self, block: usize, named: &BTreeSet<NodeId>) -> Option<Vec<Item>> {
        let own = &self.blocks[block];
        let pairs = self.pairs(own);
        let paired: HashMap<NodeId, usize> =
            pairs.iter().enumerate().flat_map(|(at, (sine, cosine, _))| [(*sine, at), (*cosine, at)]).collect();
        let blocks: Vec<usize> = own.inner.iter().map(|(_, block)| *block).collect();
        let mut unwritten = Unwritten::of(self, own, named, &blocks);
        let mut begun = BTreeSet::new();
        let mut items = Vec::new();
        loop {
            while let Some(id) = unwritten.next_value() {
                match paired.get(&id).map(|at| pairs[*at]) {
                    _ if self.is_made_inside(id) => {}
                    Some((sine, cosine, argument)) if id == sine.min(cosine) => {
                        items.push(Item::SineCosine { argument, sine, cosine });
                    }
                    Some(_) => {}
                    None => items.push(Item::Let(id)),
                }
            }
            if unwritten.blocks == 0 {
                break;
            }
            let block = blocks[unwritten.next_block()?];
            let makes = self.makes(block).into_iter().filter(|id| own.nodes.contains(id));
            items.extend(makes.filter(|id| begun.insert(*id)).map(Item::Begin));
            items.push(self.inner_item(block, named)?);
        }
        if unwritten.values > 0 {
            return None;
        }
        items.extend(own.ends.iter().map(|end| match *end {
            End::Add { sum, value } => Item::Add { sum, value },
            End::Choose { choice, value } => Item::Choose { choice, value },
            End::Sink(sink, value) => Item::Sink(sink, value),
        }));
        Some(items)
    }

    /// The named values of this block that a node is computed from.
    pub(super) fn needs(&self, id: NodeId, own: &Block, named: &BTreeSet<NodeId>, needs: &mut BTreeSet<NodeId>) {
        for child in self.graph.node(id).children().filter(|child| own.nodes.contains(child)) {
            if named.contains(&child) {
                needs.insert(child);
            } else {
                self.needs(child, own, named, needs);
            }
        }
    }

    /// The values of this block that an inner one uses; they are named, since an inner block uses them.
    pub(super) fn block_needs(&self, block: usize, own: &Block, needs: &mut BTreeSet<NodeId>) {
        let block = &self.blocks[block];
        if let Some(Scope::Branch(condition, _)) = block.scope {
            needs.insert(condition);
        }
        let computed = block.nodes.iter().filter(|id| !self.is_made_inside(**id));
        let used =
            computed.flat_map(|id| self.graph.node(*id).children()).chain(block.ends.iter().map(|end| end.value()));
        for id in used {
            // A change of sign has no name: what is under it has.
            let id = match self.graph.node(id) {
                Node::Neg(inner) if !own.nodes.contains(&id) || own.nodes.contains(&inner) => inner,
                _ => id,
            };
            if own.nodes.contains(&id) {
                needs.insert(id);
            }
        }
        for (_, inner) in &block.inner {
            self.block_needs(*inner, own, needs);
        }
    }

    /// The sums and choices that a block, or one inside it, adds to or makes.
    pub(super) fn makes(&self, block: usize) -> BTreeSet<NodeId> {
        let block = &self.blocks[block];
        let own = block.ends.iter().filter_map(|end| match end {
            End::Add { sum: id, .. } | End::Choose { choice: id, .. } => Some(*id),
            End::Sink(..) => None,
        });
        own.chain(block.inner.iter().flat_map(|(_, inner)| self.makes(*inner))).collect()
    }

    /// Whether a node gets its value in an inner block.
    pub(super) fn is_made_inside(&self, id: NodeId) -> bool {
        match self.graph.node(id) {
            Node::Sum(..) | Node::Fold(..) => true,
            Node::Select(..) => !self.is_selection(id),
            _ => false,
        }
    }

    /// Whether a choice is one of two prepared numbers, which takes an instruction and no branch.
    pub(super) fn is_selection(&self, id: NodeId) -> bool {
        let Node::Select(_, a, b) = self.graph.node(id) else { return false };
        if !self.graph.is_prepared(id) {
            return self.constraints.selects && [a, b].iter().all(|side| self.is_selected(*side));
        }
        // With fewer loops it is prepared itself.
        let is_computed = self.graph.loops_of(id).iter().count() > 1;
        is_computed && [a, b].iter().all(|side| (self.leaf)(self.graph, *side))
    }

    /// Whether a number is prepared, but for its sign, or is one of two such numbers.
    fn is_selected(&self, id: NodeId) -> bool {
        let is_number = |id: NodeId| match self.graph.node(id) {
            Node::Neg(number) => (self.leaf)(self.graph, number),
            _ => self.graph.as_constant(id).is_some() || (self.leaf)(self.graph, id),
        };
        match self.graph.node(id) {
            Node::Select(_, a, b) => [a, b].into_iter().all(is_number),
            _ => is_number(id),
        }
    }

    fn inner_item(&self, block: usize, named: &BTreeSet<NodeId>) -> Option<Item> {
        let body = self.items(block, named)?;
        Some(match self.blocks[block].scope? {
            Scope::Loop(by) => Item::Loop { by, body },
            Scope::Branch(condition, holds) => Item::Branch { condition, holds, body },
        })
    }

    /// Sines and cosines of one argument that are computed in one block.
    pub(super) fn pairs(&self, block: &Block) -> Vec<(NodeId, NodeId, NodeId)> {
        let of = |name: &str| -> HashMap<NodeId, NodeId> {
            let calls = block.nodes.iter().filter_map(|id| match self.graph.node(*id) {
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
}
