//! Choices between numbers by conditions on both bodies of a pair, such as `if self.kind[i] == 0 && self.kind[j] == 0 { 4.0 } else { 6.0 }`.
//!
//! In: a choice whose conditions are entries of tables over classes of bodies. Out: the entry of one table of the chosen numbers.

use super::parameter_text::Texts;
use crate::graph::{Graph, Node, NodeId, ParameterId, index::LoopId, rename::End};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Texts<'_> {
    /// The entry for a pair; `None` if no condition is an entry of such a table, or if the text depends on more than one value of
    /// each body.
    pub(super) fn choice_of_pair(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let mut is_by_class = false;
        for condition in graph.reachable([id]) {
            let Node::Flag(flag) = graph.node(condition) else { continue };
            if pair.iter().all(|by| graph.loops.of_parameter(flag).contains(*by)) {
                let condition = self.flag_of_pair(graph, flag, pair, ends)?;
                let condition = if let Node::Not(inner) = graph.node(condition) { inner } else { condition };
                let Node::Compare(_, _, entry) = graph.node(condition) else { return None };
                let Node::Entry(_, row, _) = graph.node(entry) else { return None };
                is_by_class |= matches!(graph.node(row), Node::Parameter(_));
            }
        }
        if !is_by_class {
            return None;
        }
        let text = chosen(graph, id, &|parameter| self.text(parameter))?;
        let shown = chosen(graph, id, &|parameter| self.own_text(parameter))?;
        let number = self.id(graph, text.clone(), graph.loops_of(id));
        self.show(number, &shown);
        self.entry_of_pair(graph, number, [&text, &text], pair, ends)
    }
}

/// The text of a choice between numbers and parameters.
fn chosen(graph: &Graph, id: NodeId, text_of: &dyn Fn(ParameterId) -> TokenStream) -> Option<TokenStream> {
    let of = |id| chosen(graph, id, text_of);
    Some(match graph.node(id) {
        Node::Constant(bits) => {
            let number = Some(f64::from_bits(bits)).filter(|number| number.is_finite())?;
            let size = Literal::f64_suffixed(number.abs());
            if number.is_sign_negative() { quote!((-#size)) } else { quote!(#size) }
        }
        Node::Parameter(parameter) | Node::Flag(parameter) => {
            let text = text_of(parameter);
            quote!((#text))
        }
        Node::Neg(a) => {
            let a = of(a)?;
            quote!((-#a))
        }
        Node::Not(a) => {
            let a = of(a)?;
            quote!(!(#a))
        }
        Node::And(a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            quote!((#a && #b))
        }
        Node::Or(a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            quote!((#a || #b))
        }
        Node::Select(condition, a, b) => {
            let (condition, a, b) = (of(condition)?, of(a)?, of(b)?);
            quote!((if #condition { #a } else { #b }))
        }
        _ => return None,
    })
}
