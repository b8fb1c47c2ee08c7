//! A Hamiltonian that does not separate, as it is: `split = symmetric(omega = ..)`.

use super::{Called, Reader, shape::whole_signature};
use crate::{
    graph::{NodeId, Part},
    model::Shape,
};
use syn::{Expr, ImplItemFn};

impl Reader<'_> {
    /// H and nothing else, and the coupling of the two copies that it moves; or notes of what is wrong with them.
    pub(super) fn doubled(
        &mut self,
        coupling: &Expr,
        whole: Option<&ImplItemFn>,
    ) -> Option<([NodeId; 2], NodeId, Shape, Called)> {
        let Some(function) = whole else {
            let message = "`symmetric` takes H as it is, in one function: write \
                           `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`; `kinetic` and `potential` need no copies";
            self.errors.at(coupling, message);
            return None;
        };
        if let Some(coordinates) = &self.input.coordinates {
            let message = "Jacobi coordinates are for bodies whose T and V are known apart, not for `symmetric`";
            self.errors.at(&coordinates.name, message);
            return None;
        }
        let signature = whole_signature(function, self.errors)?;
        self.may_mix = true;
        let energy = self.whole_energy(function, &signature);
        let coupling = self.coupling(coupling);
        self.may_mix = false;
        let (energy, coupling) = (energy?, coupling?);
        if self.graph.reads_time(energy) {
            let message = "this reads the time, and compositions know at what time the flows of two parts begin, not those \
                           of two copies and their coupling: make the time a coordinate with a momentum of its own";
            self.errors.at(&function.sig.ident, message);
            return None;
        }
        let zero = self.graph.constant(0.0);
        Some(([energy, zero], coupling, signature.shape, Called::Whole(signature.arguments)))
    }

    /// A number that depends on parameters alone.
    fn coupling(&mut self, expression: &Expr) -> Option<NodeId> {
        self.scopes.push(Default::default());
        let value = self.expression(expression);
        self.scopes.pop();
        let node = self.number(&value?, expression)?;
        let is_constant = |part| !self.graph.reads(node, part);
        debug_assert!([Part::Position, Part::Momentum].into_iter().all(is_constant), "no coordinate is in scope");
        if self.graph.as_constant(node).is_some_and(|omega| omega <= 0.0) {
            self.errors.at(expression, "without a coupling above zero, both copies go their own ways");
            return None;
        }
        Some(node)
    }
}
