//! Parts with exact flows whose sum an energy is, for an energy that is written in one piece.
//!
//! If some term mixes positions and momenta: the terms that are quadratic forms are one part if some of them mix them. Other terms that do so are
//! collected in parts with exact flows, each term in the first part that keeps its flow. The terms of momenta alone and
//! those of positions alone are a part each, or join such a part.

use super::{Graph, Node, NodeId, Part, exact::Exact, index::IndexId, same_product::FactorsOf};

/// The most terms that are distributed among parts.
const TERMS: usize = 32;

/// A part with an exact flow.
pub(crate) type Explicit = (NodeId, Exact);

impl Graph {
    /// The parts, or a term without an exact flow.
    pub(crate) fn explicit_parts(
        &mut self,
        energy: NodeId,
        extents: &[IndexId],
        factors_of: FactorsOf<'_>,
    ) -> Result<Vec<Explicit>, NodeId> {
        if let Some(energies) = self.separated(energy) {
            let parts = energies.into_iter().zip([Exact::OfMomenta, Exact::OfPositions]);
            return Ok(parts.filter(|(energy, _)| self.reads_coordinates(*energy)).collect());
        }
        let [quadratic, rest] = self.quadratic_and_rest(energy);
        let form = self.is_mixed(quadratic).then(|| self.exact(quadratic, extents, factors_of));
        let (mut parts, rest) = match form {
            Some(Ok(form)) => (vec![(quadratic, form)], rest),
            _ => (Vec::new(), energy),
        };
        let solved = parts.len();
        let mut terms = Vec::new();
        self.distributed(rest, &mut terms);
        let (mixed, alone): (Vec<_>, Vec<_>) = terms.into_iter().partition(|term| self.is_mixed(*term));
        for term in mixed {
            if !self.joins(&mut parts[solved..], term, extents, factors_of) {
                let form = self.exact(term, extents, factors_of).map_err(|_| term)?;
                parts.push((term, form));
            }
        }
        let (of_momenta, of_positions): (Vec<_>, Vec<_>) =
            alone.into_iter().partition(|term| self.reads(*term, Part::Momentum));
        for (terms, form) in [(of_momenta, Exact::OfMomenta), (of_positions, Exact::OfPositions)] {
            let sum = terms.into_iter().reduce(|sum, term| self.add(sum, term));
            if let Some(sum) = sum.filter(|sum| self.reads_coordinates(*sum))
                && !self.joins(&mut parts[solved..], sum, extents, factors_of)
            {
                parts.push((sum, form));
            }
        }
        Ok(parts)
    }

    /// Adds a term to the first part that then has an exact flow of the cheap kind.
    fn joins(&mut self, parts: &mut [Explicit], term: NodeId, extents: &[IndexId], factors_of: FactorsOf<'_>) -> bool {
        for part in parts {
            let sum = self.add(part.0, term);
            if self.is_mixed(part.0)
                && let Ok(form @ (Exact::Shear | Exact::Shifted(_))) = self.exact(sum, extents, factors_of)
            {
                *part = (sum, form);
                return true;
            }
        }
        false
    }

    /// The terms of a sum, those in parentheses with a common factor too.
    fn distributed(&mut self, id: NodeId, terms: &mut Vec<NodeId>) {
        let before = terms.len();
        if before >= TERMS || !self.is_mixed(id) {
            return terms.push(id);
        }
        match self.node(id) {
            Node::Add(a, b) => [a, b].into_iter().for_each(|side| self.distributed(side, terms)),
            Node::Neg(a) => {
                self.distributed(a, terms);
                terms[before..].iter_mut().for_each(|term| *term = self.neg(*term));
            }
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => {
                self.distributed(a, terms);
                terms[before..].iter_mut().for_each(|term| *term = self.mul(factor, *term));
            }
            Node::Div(a, divisor) if self.is_prepared(divisor) => {
                self.distributed(a, terms);
                terms[before..].iter_mut().for_each(|term| *term = self.div(*term, divisor));
            }
            Node::Sum(by, body) => {
                self.distributed(body, terms);
                terms[before..].iter_mut().for_each(|term| *term = self.sum(by, *term));
            }
            _ => terms.push(id),
        }
    }
}
