//! A Hamiltonian that is not separable, without a splitting: `split = symmetric(omega = ..)`.

use crate::model::{Called, Reader, code::shape::whole_signature};
use crate::{
    graph::{NodeId, Part},
    model::Shape,
};
use syn::{Expr, ImplItemFn};

impl Reader<'_> {
    /// H and nothing else, and the coupling of the two copies that it moves; or notes of what is wrong with them.
    pub(crate) fn doubled(
        &mut self,
        coupling: &Expr,
        whole: Option<&ImplItemFn>,
    ) -> Option<([NodeId; 2], NodeId, Shape, Called)> {
        let Some(function) = whole else {
            let message = "`split = symmetric` requires H in one function\nhelp: write `fn hamiltonian(&self, q: \
                           [f64; N], p: [f64; N]) -> f64`\nnote: `kinetic` and `potential` already have exact flows, \
                           without copies of the state";
            self.errors.at(coupling, message);
            return None;
        };
        if let Some(coordinates) = &self.input.coordinates {
            let message = "Jacobi coordinates do not support `split = symmetric`\nhelp: write T and V as `kinetic` \
                           and `potential`";
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
            let message = "`split = symmetric` does not support an H that depends on time\nhelp: make the time a \
                           coordinate with a conjugate momentum";
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
            self.errors.at(
                expression,
                "the coupling `omega` has to be greater than zero\nnote: without it, the two \
                                        copies of the state drift apart",
            );
            return None;
        }
        Some(node)
    }
}
