//! Unsplit `H`, for methods that use the whole vector field: `split = none`.

use crate::model::{Called, Reader, code::shape::whole_signature};
use crate::{graph::NodeId, model::Shape, syntax::Compose};
use proc_macro2::Span;
use syn::ImplItemFn;

impl Reader<'_> {
    /// H and nothing else, or notes of what is wrong with it.
    pub(crate) fn unsplit(&mut self, at: Span, whole: Option<&ImplItemFn>) -> Option<([NodeId; 2], Shape, Called)> {
        let Some(function) = whole else {
            let message = "`split = none` requires H in one function\nhelp: write `fn hamiltonian(&self, q: [f64; N], \
                           p: [f64; N]) -> f64`\nnote: implicit methods integrate `kinetic` and `potential` without \
                           `split = none`";
            self.errors.at_span(at, message);
            return None;
        };
        if let Some(coordinates) = &self.input.coordinates {
            let message = "Jacobi coordinates do not support `split = none`\nhelp: write T and V as `kinetic` and \
                           `potential`";
            self.errors.at(&coordinates.name, message);
            return None;
        }
        if let Some(Compose::InPlace(_, span)) = &self.input.compose {
            let message = "`split = none` does not support a sequence of stages\nhelp: name an implicit method, \
                           `compose = GaussLegendre4`\nnote: a sequence composes the flows of parts, and H is in one \
                           piece";
            self.errors.at_span(*span, message);
            return None;
        }
        let signature = whole_signature(function, self.errors)?;
        self.may_mix = true;
        let energy = self.whole_energy(function, &signature);
        self.may_mix = false;
        let zero = self.graph.constant(0.0);
        Some(([energy?, zero], signature.shape, Called::Whole(signature.arguments)))
    }
}
