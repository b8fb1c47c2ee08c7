//! Functions with bodies as arguments: the coordinates of a body as an array, and its prepared constants as another
//! one.

use super::stores::{lower_roots, stores};
use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{
        Comparison, Element, Graph, Node, NodeId, ParameterId, Scope,
        index::{Index, LoopId, Loops},
        rename::{Renaming, rename},
    },
    model::{Model, Texts, is_field, is_leaf},
    program::{Sink, Store, is_direct},
    reason::Reason,
};
use std::collections::{BTreeSet, HashMap};

/// What is prepared of every body, as nodes inside the loop over all of them.
pub(crate) struct Constants {
    pub(crate) bodies: LoopId,
    /// These nodes.
    pub(crate) nodes: Vec<NodeId>,
    /// Which of them are densities, or their weights, which the runtime computes.
    pub(crate) densities: Vec<usize>,
}

impl Constants {
    pub(crate) fn new(bodies: LoopId) -> Self {
        Self { bodies, nodes: Vec::new(), densities: Vec::new() }
    }

    /// How many there are of a body.
    pub(crate) fn count(&self) -> usize {
        self.nodes.len()
    }

    /// The place of what is prepared for the index of a loop.
    fn place(&mut self, model: &mut Model, id: NodeId, by: LoopId) -> Option<usize> {
        let mut texts = Texts::new(&mut model.parameters, &mut model.running, &model.root);
        let renaming = Renaming::one(by, self.bodies);
        let mut node = rename(&mut model.graph, id, renaming, &mut texts)?;
        if let Some(number) = self.first(&model.graph.loops, by) {
            node = texts.of_first(&mut model.graph, node, self.bodies, number);
        }
        let known = self.nodes.iter().position(|known| *known == node);
        Some(known.unwrap_or_else(|| {
            self.nodes.push(node);
            self.nodes.len() - 1
        }))
    }

    /// Keeps a place for a density of the bodies with the index of a loop.
    pub(crate) fn keep_density(&mut self, model: &mut Model, number: NodeId, by: LoopId) -> Option<()> {
        let place = self.place(model, number, by)?;
        self.densities.push(place);
        Some(())
    }

    /// The number of bodies that a loop runs over, if that may be fewer than all.
    fn first(&self, loops: &Loops, by: LoopId) -> Option<ParameterId> {
        let (to, all) = (loops.get(by).to, loops.get(self.bodies).to);
        if to == all {
            return None;
        }
        match loops.index(to) {
            Index::Running(outer) => self.first(loops, outer),
            Index::Parameter(number) if loops.of_parameter(number).is_empty() => Some(number),
            Index::Min(a, b) | Index::Sub(a, b) | Index::Monus(a, b) => {
                let number = |end| match loops.index(end) {
                    Index::Parameter(number) if end != all => Some(number),
                    _ => None,
                };
                number(a).or_else(|| number(b))
            }
            _ => None,
        }
    }

    /// The constant that is the number of a body, if some functions of pairs do nothing but compare it with that of the other
    /// body, and others do not read it.
    pub(crate) fn number(&self, graph: &Graph, of_pairs: &[&OfBodies], others: &[&OfBodies]) -> Option<usize> {
        let index = graph.loops.known(Index::Running(self.bodies))?;
        let place = self.nodes.iter().position(|id| graph.node(*id) == Node::FromIndex(index))?;
        let is_read = |of: &&OfBodies| of.reads.iter().any(|(.., read)| *read == place);
        let is_compared = |of: &&OfBodies| {
            let numbers: Vec<_> = of.reads.iter().filter(|(.., read)| *read == place).map(|(id, ..)| *id).collect();
            let roots = of.stores.iter().flat_map(|store| {
                store.context.iter().filter_map(Scope::condition).chain([store.value]).collect::<Vec<_>>()
            });
            graph.reachable(roots).into_iter().all(|id| match graph.node(id) {
                Node::Compare(Comparison::Less, a, b) if numbers.contains(&a) && numbers.contains(&b) => a != b,
                node => !node.children().any(|child| numbers.contains(&child)),
            })
        };
        (!others.iter().any(is_read) && of_pairs.iter().all(is_compared)).then_some(place)
    }

    /// The tables that hold what a function reads of its bodies, by the nodes that read them.
    pub(crate) fn tables(&self, of: &OfBodies) -> HashMap<NodeId, NodeId> {
        of.reads.iter().map(|(id, _, place)| (*id, self.nodes[*place])).collect()
    }
}

/// A function of the bodies with the indices of some loops.
pub(crate) struct OfBodies {
    /// The loops whose indices its bodies have.
    pub(crate) of: Vec<LoopId>,
    /// What it stores, within these loops.
    pub(crate) stores: Vec<Store>,
    /// What it reads of the prepared constants: where, of which body, and where among that body's.
    pub(crate) reads: Vec<(NodeId, LoopId, usize)>,
}

impl OfBodies {
    /// The function that gives the components of a gradient.
    pub(crate) fn gradient(
        model: &mut Model,
        constants: &mut Constants,
        of: &[LoopId],
        gradient: &[Contribution],
    ) -> Result<Self, Reason> {
        let folded = fold_branches(&mut model.graph, gradient);
        let branches = folded.iter().any(|contribution| contribution.conditions().next().is_some());
        if is_direct(&model.graph.loops, &folded) && !branches {
            return Self::new(model, constants, of, &folded, Sink::Assign);
        }
        Self::new(model, constants, of, gradient, Sink::Collect)
    }

    /// The function that puts the components of a gradient somewhere.
    pub(crate) fn new(
        model: &mut Model,
        constants: &mut Constants,
        of: &[LoopId],
        gradient: &[Contribution],
        sink: fn(Element) -> Sink,
    ) -> Result<Self, Reason> {
        let stores = stores(model, gradient, sink);
        Self::over(model, constants, of, stores)
    }

    /// The function that gives a value.
    pub(crate) fn value(
        model: &mut Model,
        constants: &mut Constants,
        of: &[LoopId],
        value: NodeId,
    ) -> Result<Self, Reason> {
        let value = lower_roots(model, &[value])[0];
        Self::over(model, constants, of, vec![Store { context: Vec::new(), sink: Sink::Return, value }])
    }

    fn over(
        model: &mut Model,
        constants: &mut Constants,
        of: &[LoopId],
        mut stores: Vec<Store>,
    ) -> Result<Self, Reason> {
        let leaves = read(model, &stores);
        for store in &mut stores {
            store.context.splice(0..0, of.iter().map(|by| Scope::Loop(*by)));
        }
        let mut reads = Vec::new();
        for id in leaves {
            let loops = model.graph.loops_of(id);
            if let Some(by) = of.iter().copied().find(|by| loops.contains(*by)) {
                reads.push((id, by, constants.place(model, id, by).ok_or(Reason::Unrecognised)?));
            }
        }
        Ok(Self { of: of.to_vec(), stores, reads })
    }
}

/// The prepared constants that values and conditions read.
fn read(model: &Model, stores: &[Store]) -> BTreeSet<NodeId> {
    let conditions = stores.iter().flat_map(|store| &store.context).filter_map(|around| match around {
        Scope::Branch(condition, _) => Some(*condition),
        Scope::Loop(_) => None,
    });
    let mut open: Vec<NodeId> = stores.iter().map(|store| store.value).chain(conditions).collect();
    let (mut seen, mut read) = (BTreeSet::new(), BTreeSet::new());
    while let Some(id) = open.pop() {
        let node = model.graph.node(id);
        if matches!(node, Node::FromIndex(_)) || is_field(&model.graph, &model.parameters, id) {
            read.insert(id);
        } else if seen.insert(id) && !is_leaf(&model.graph, &model.parameters, id) {
            open.extend(node.children());
        }
    }
    read
}
