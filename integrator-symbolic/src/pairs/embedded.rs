//! Energies of bodies that depend on sums over their partners: `F(Σ_j g(i, j))`, such as that of an atom in the electron density of the
//! others (Daw and Baskes 1984; Finnis and Sinclair 1984).
//!
//! In: the energy of a body. Out: the same energy of numbers of the body, its densities, and what a partner adds to each. The gradient
//! is that of the pair terms `w_i g(i, j) + w_j g(j, i)`, whose weights `w = F'` are kept where the densities were.

use super::{
    exchange::{Forms, is_symmetric},
    order::{rewritten, with_numbers},
    partners::{addend_of_distinct_pair, is_partner},
    reads_only,
    renamed::renamed,
};
use crate::graph::{
    Comparison, Graph, Node, NodeId, Part,
    index::{Index, IndexId, Loop, LoopId},
    rename::{Parameters, Renaming, rename},
};

/// Energies of bodies that depend on densities.
#[derive(Default)]
pub(crate) struct Embedded {
    /// The energies of a body.
    pub(crate) energies: Vec<NodeId>,
    /// The densities that these read.
    pub(crate) densities: Vec<Density>,
}

/// A sum over the partners of a body.
#[derive(Clone, Copy)]
pub(crate) struct Density {
    /// The sum.
    sum: NodeId,
    /// The number of a body that has its place.
    pub(crate) number: NodeId,
    /// The loops over the two bodies of a pair, each of which comes twice.
    pub(crate) pair: [LoopId; 2],
    /// What the second body adds.
    pub(crate) addend: NodeId,
}

impl Embedded {
    /// Adds the energy of the body with the index of `by` among `length` bodies; `None` if it is not one of sums over partners.
    pub(super) fn push(
        &mut self,
        graph: &mut Graph,
        energy: NodeId,
        by: LoopId,
        length: IndexId,
        parameters: &mut dyn Parameters,
    ) -> Option<()> {
        let known = self.densities.len();
        let of_numbers = rewritten(graph, energy, |graph, id| self.density(graph, id, by, length, parameters));
        let is_embedded = of_numbers != energy
            && !graph.reads(of_numbers, Part::Position)
            && reads_only(graph, of_numbers, &[by], parameters);
        if !is_embedded {
            self.densities.truncate(known);
            return None;
        }
        self.energies.push(of_numbers);
        Some(())
    }

    /// The number that stands for a sum over partners.
    fn density(
        &mut self,
        graph: &mut Graph,
        sum: NodeId,
        by: LoopId,
        length: IndexId,
        parameters: &mut dyn Parameters,
    ) -> Option<NodeId> {
        if let Some(known) = self.densities.iter().find(|known| known.sum == sum) {
            return Some(known.number);
        }
        let (pair, addend) = match graph.node(sum) {
            Node::Sum(other, body) if is_partner(graph, length, by, other) == Some(true) => {
                ([by, other], addend_of_distinct_pair(graph, [by, other], body)?)
            }
            Node::Add(a, b) => before_and_after(graph, [a, b], by, length, parameters)?,
            _ => return None,
        };
        let addend = with_numbers(graph, addend, pair, [None; 2], parameters)?;
        if !reads_only(graph, addend, &pair, parameters) {
            return None;
        }
        let number = parameters.density(graph, by, self.densities.len())?;
        let number = graph.parameter(number);
        self.densities.push(Density { sum, number, pair, addend });
        Some(number)
    }

    /// The terms of a pair whose gradient is that of the energies, if each number is the derivative by its density.
    pub(super) fn of_pair(
        &self,
        graph: &mut Graph,
        pair: [LoopId; 2],
        parameters: &mut dyn Parameters,
    ) -> Option<NodeId> {
        let mut terms = graph.constant(0.0);
        for Density { number, pair: own, addend, .. } in &self.densities {
            let there = Renaming::exchange(*own);
            let [weight, other_weight] = [*number, rename(graph, *number, there, parameters)?];
            let term = if is_symmetric(graph, *addend, *own, parameters)? {
                let weights = graph.add(weight, other_weight);
                graph.mul(weights, *addend)
            } else {
                let other = renamed(graph, *addend, there, parameters)?;
                let [first, second] = [graph.mul(weight, *addend), graph.mul(other_weight, other)];
                graph.add(first, second)
            };
            let term = renamed(graph, term, Renaming::both(*own, pair), parameters)?;
            terms = graph.add(terms, term);
        }
        Some(terms)
    }

    /// The derivative of the energy of a body by a density; zero where it is infinite at no density, since no partner is there.
    pub(crate) fn weight(&self, graph: &mut Graph, density: NodeId) -> Option<NodeId> {
        let Node::Parameter(parameter) = graph.node(density) else { return None };
        let [zero, infinity] = [0.0, f64::INFINITY].map(|number| graph.constant(number));
        let mut slope = zero;
        for energy in &self.energies {
            let own = graph.by_parameter(*energy, parameter);
            slope = graph.add(slope, own);
        }
        let size = graph.call("abs", slope);
        let [at_zero, is_finite] = [(Comparison::Equal, density, zero), (Comparison::Less, size, infinity)]
            .map(|(comparison, a, b)| graph.compare(comparison, a, b));
        let is_infinite = graph.not(is_finite);
        let is_left_out = graph.and(at_zero, is_infinite);
        Some(graph.select(is_left_out, zero, slope))
    }
}

/// The loops over pairs and what a partner adds, if two sums over the partners before and after a body add the same.
fn before_and_after(
    graph: &mut Graph,
    sums: [NodeId; 2],
    by: LoopId,
    length: IndexId,
    parameters: &mut dyn Parameters,
) -> Option<([LoopId; 2], NodeId)> {
    let [Node::Sum(first, a), Node::Sum(second, b)] = sums.map(|sum| graph.node(sum)) else { return None };
    let are_halves = [first, second].iter().all(|other| is_partner(graph, length, by, *other) == Some(false));
    if !are_halves || first == second {
        return None;
    }
    let from = graph.loops.intern(Index::Literal(0));
    let other = graph.loops.range(Loop { parent: Some(by), from, to: length });
    parameters.name_if_new(other, second);
    let pair = [by, other];
    let a = renamed(graph, a, Renaming::one(first, other), parameters)?;
    let b = renamed(graph, b, Renaming::one(second, other), parameters)?;
    let mut forms = Forms::new(pair, None, parameters);
    (forms.of(graph, a, false)? == forms.of(graph, b, false)?).then_some((pair, b))
}
