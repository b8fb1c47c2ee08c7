//! Energies of planes and volumes as sums over sites.
//!
//! In: an energy of a lattice. Out: the terms of each site as a stencil, or nothing where the energy has another form. Always
//! true: the terms of all sites add up to the energy. A term belongs to the site with the indices of its loops, and one outside
//! of some loops to a site that it reads.

use super::{flat, sites::stencil_on};
use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId, Part, Scope,
        index::{Index, LoopId},
    },
    model::Model,
    stencil::{Components, Lattice, Stencil},
};

/// The terms of an energy of the lattice that the flow of `V` moves, site by site.
pub(crate) fn stencil_of_energy(model: &mut Model, energy: NodeId, of_flow: &Stencil) -> Option<Stencil> {
    if of_flow.lattice() == Lattice::Line {
        return None;
    }
    let mut terms = Terms { graph: &mut model.graph, directions: of_flow.directions.len(), found: Vec::new() };
    terms.add(energy, &mut Vec::new(), None, false)?;
    let found = terms.found;
    let stencil = match of_flow.flat {
        Some(lengths) => flat::stencil_on_rows(model, &found, lengths)?,
        None => {
            let extents = model.extents.clone();
            stencil_on(model, &found, &extents, Components::Sites).ok()?
        }
    };
    stencil.onward().iter().all(|onward| *onward == 0).then_some(stencil)
}

struct Terms<'g> {
    graph: &'g mut Graph,
    /// How many directions the lattice has.
    directions: usize,
    /// The terms, each as a contribution to its site.
    found: Vec<Contribution>,
}

impl Terms<'_> {
    /// Adds the terms of `factor` times a part of the energy inside of these loops, or of its negative.
    fn add(&mut self, id: NodeId, loops: &mut Vec<LoopId>, factor: Option<NodeId>, negative: bool) -> Option<()> {
        let has_sums = |graph: &Graph, id| {
            graph.reachable([id]).into_iter().any(|id| matches!(graph.node(id), Node::Sum(..) | Node::Fold(..)))
        };
        if !has_sums(self.graph, id) {
            return self.term(id, loops, factor, negative);
        }
        match self.graph.node(id) {
            Node::Sum(by, body) => {
                loops.push(by);
                self.add(body, loops, factor, negative)?;
                loops.pop();
                Some(())
            }
            Node::Add(a, b) => {
                self.add(a, loops, factor, negative)?;
                self.add(b, loops, factor, negative)
            }
            Node::Neg(a) => self.add(a, loops, factor, !negative),
            Node::Mul(a, b) => {
                let (own, sum) = if has_sums(self.graph, a) { (b, a) } else { (a, b) };
                if !self.graph.is_prepared(own) || has_sums(self.graph, own) {
                    return None;
                }
                let factor = factor.map_or(own, |factor| self.graph.mul(factor, own));
                self.add(sum, loops, Some(factor), negative)
            }
            _ => None,
        }
    }

    /// Adds a term without sums.
    fn term(&mut self, id: NodeId, loops: &[LoopId], factor: Option<NodeId>, negative: bool) -> Option<()> {
        let read = self.graph.reachable([id]).into_iter().find_map(|id| match self.graph.node(id) {
            Node::Coordinate(element) => Some(element),
            _ => None,
        });
        let own = loops.iter().map(|by| self.graph.loops.intern(Index::Running(*by))).collect::<Vec<_>>();
        let part = read.map_or(Part::Position, |read| read.part);
        let element = match own[..] {
            [row, site] if self.directions == 2 => Element { part, index: row, component: Some(site) },
            [plane, row, site] if self.directions == 3 => {
                let component = Some(self.graph.loops.intern(Index::InPlane(row, site)));
                Element { part, index: plane, component }
            }
            _ => read?,
        };
        let value = factor.map_or(id, |factor| self.graph.mul(factor, id));
        let value = if negative { self.graph.neg(value) } else { value };
        let context = loops.iter().copied().map(Scope::Loop).collect();
        self.found.push(Contribution { context, element, value });
        Some(())
    }
}
