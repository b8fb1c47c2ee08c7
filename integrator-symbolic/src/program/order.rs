//! The lines of a block, in an order in which each finds what it needs.

use super::{End, Item, Scheduler, Scope};
use crate::graph::{Around, Graph, Node, NodeId};
use std::collections::{BTreeSet, HashMap};

impl<L: Fn(&Graph, NodeId) -> bool> Scheduler<'_, L> {
    /// Named values as soon as they can be computed, inner blocks as soon as nothing else can, destinations last; `None`
    /// if two blocks wait for each other.
    pub(super) fn items(&self, scope: usize, named: &BTreeSet<NodeId>) -> Option<Vec<Item>> {
        let own = &self.scopes[scope];
        let pairs = self.pairs(own);
        let mut waiting: BTreeSet<NodeId> = own.nodes.iter().filter(|id| named.contains(id)).copied().collect();
        let mut blocks: Vec<usize> = own.inner.iter().map(|(_, block)| *block).collect();
        let mut begun = BTreeSet::new();
        let mut items = Vec::new();
        loop {
            // Children have smaller ids, so one pass finds all that wait for no block.
            for id in waiting.clone() {
                if !self.is_ready(id, own, named, &blocks, &waiting) {
                    continue;
                }
                waiting.remove(&id);
                match pairs.iter().find(|(sine, cosine, _)| *sine == id || *cosine == id) {
                    _ if self.is_made_inside(id) => {}
                    Some((sine, cosine, argument)) if id == *sine.min(cosine) => {
                        items.push(Item::SineCosine { argument: *argument, sine: *sine, cosine: *cosine });
                    }
                    Some(_) => {}
                    None => items.push(Item::Let(id)),
                }
            }
            if blocks.is_empty() {
                break;
            }
            let position = blocks.iter().position(|block| {
                let (mut needs, makes) = (BTreeSet::new(), self.makes(*block));
                self.block_needs(*block, own, &mut needs);
                // What the block itself makes is not needed from outside.
                needs.iter().all(|id| makes.contains(id) || !waiting.contains(id))
            })?;
            let block = blocks.remove(position);
            let makes = self.makes(block).into_iter().filter(|id| own.nodes.contains(id));
            items.extend(makes.filter(|id| begun.insert(*id)).map(Item::Begin));
            items.push(self.block(block, named)?);
        }
        if !waiting.is_empty() {
            return None;
        }
        items.extend(own.ends.iter().map(|end| match *end {
            End::Add { sum, value } => Item::Add { sum, value },
            End::Choose { choice, value } => Item::Choose { choice, value },
            End::Sink(sink, value) => Item::Sink(sink, value),
        }));
        Some(items)
    }

    /// Whether a named value can be computed: what it is made of has been, and no block that makes it is left.
    fn is_ready(
        &self,
        id: NodeId,
        own: &Scope,
        named: &BTreeSet<NodeId>,
        blocks: &[usize],
        waiting: &BTreeSet<NodeId>,
    ) -> bool {
        if self.is_made_inside(id) {
            return !blocks.iter().any(|block| self.makes(*block).contains(&id));
        }
        let mut needs = BTreeSet::new();
        self.needs(id, own, named, &mut needs);
        needs.is_disjoint(waiting)
    }

    /// The named values of this block that a node is computed from.
    fn needs(&self, id: NodeId, own: &Scope, named: &BTreeSet<NodeId>, needs: &mut BTreeSet<NodeId>) {
        for child in self.graph.node(id).children().filter(|child| own.nodes.contains(child)) {
            if named.contains(&child) {
                needs.insert(child);
            } else {
                self.needs(child, own, named, needs);
            }
        }
    }

    /// The values of this block that an inner one uses; they are named, since an inner block uses them.
    fn block_needs(&self, block: usize, own: &Scope, needs: &mut BTreeSet<NodeId>) {
        let block = &self.scopes[block];
        if let Some(Around::Branch(condition, _)) = block.around {
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
    fn makes(&self, block: usize) -> BTreeSet<NodeId> {
        let block = &self.scopes[block];
        let own = block.ends.iter().filter_map(|end| match end {
            End::Add { sum: id, .. } | End::Choose { choice: id, .. } => Some(*id),
            End::Sink(..) => None,
        });
        own.chain(block.inner.iter().flat_map(|(_, inner)| self.makes(*inner))).collect()
    }

    /// Whether a node gets its value in an inner block.
    fn is_made_inside(&self, id: NodeId) -> bool {
        matches!(self.graph.node(id), Node::Sum(..) | Node::Select(..))
    }

    fn block(&self, scope: usize, named: &BTreeSet<NodeId>) -> Option<Item> {
        let body = self.items(scope, named)?;
        Some(match self.scopes[scope].around? {
            Around::Loop(by) => Item::Loop { by, body },
            Around::Branch(condition, holds) => Item::Branch { condition, holds, body },
        })
    }

    /// Sines and cosines of one argument that are computed in one block.
    pub(super) fn pairs(&self, scope: &Scope) -> Vec<(NodeId, NodeId, NodeId)> {
        let of = |name: &str| -> HashMap<NodeId, NodeId> {
            let calls = scope.nodes.iter().filter_map(|id| match self.graph.node(*id) {
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
