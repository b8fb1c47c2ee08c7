//! Choices between numbers by conditions on both bodies of a pair, such as `if self.kind[i] == 0 && self.kind[j] == 0 { 4.0 } else { 6.0 }`,
//! and sums of entries of tables, such as those of both orders of a pair.
//!
//! In: a choice whose conditions are entries of tables over classes of bodies, or a sum of such entries. Out: the entry of one table of the
//! chosen numbers, or of the sums.

use super::{
    parameter_text::Texts,
    running_index::{running_index, with_indices},
};
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
        let texts = |node| match node {
            Node::Flag(parameter) => self.both_texts(Node::Parameter(parameter)),
            node => self.both_texts(node),
        };
        let texts = [0, 1].map(|which| computed(graph, id, &|node| Some(texts(node)?[which].clone())));
        self.entry_of_number(graph, id, texts, &[], pair, ends)
    }

    /// The entry for a sum of entries; `None` of other numbers, or if the sum depends on more than one value of each body.
    pub(super) fn sum_of_pair(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let entry = |id| self.entry_text(graph, graph.node(id));
        let tables: Vec<_> = graph.reachable([id]).into_iter().filter_map(entry).map(|(table, _)| table).collect();
        if tables.len() < 2 {
            return None;
        }
        let texts = |node| match self.entry_text(graph, node) {
            Some((_, texts)) => Some(texts),
            None => self.both_texts(node),
        };
        let texts = [0, 1].map(|which| computed(graph, id, &|node| Some(texts(node)?[which].clone())));
        self.entry_of_number(graph, id, texts, &tables, pair, ends)
    }

    /// The entry of a number with this text, which is also given as shown to people; the number may be missing where one of `like` may.
    fn entry_of_number(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        [text, shown]: [Option<TokenStream>; 2],
        like: &[ParameterId],
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let text = text?;
        let number = self.id(graph, text.clone(), graph.loops_of(id));
        self.show(number, &shown?);
        like.iter().for_each(|table| graph.declare_like(number, *table));
        self.entry_of_pair(graph, number, [&text, &text], pair, ends)
    }

    /// The text of a parameter, and the same as shown to people.
    fn both_texts(&self, node: Node) -> Option<[TokenStream; 2]> {
        match node {
            Node::Parameter(parameter) => Some([self.text(parameter), self.own_text(parameter)]),
            _ => None,
        }
    }

    /// A table, and the text of an entry of it with the indices of the bodies that it is read with, also as shown to people.
    fn entry_text(&self, graph: &Graph, entry: Node) -> Option<(ParameterId, [TokenStream; 2])> {
        let Node::Entry(table, row, column) = entry else { return None };
        let Node::Parameter(table) = graph.node(table) else { return None };
        let (pair, texts) = self.entries.get(&table)?;
        let [row, column] = [row, column].map(|body| graph.loops_of(body).iter().next());
        let bodies = [row?, column?];
        let index = |by| pair.iter().position(|body| *body == by).map(|at| running_index(bodies[at]).into());
        Some((table, texts.each_ref().map(|text| with_indices(text, &index))))
    }
}

/// The text of a number that is computed from constants and what `text_of` has texts of.
fn computed(graph: &Graph, id: NodeId, text_of: &dyn Fn(Node) -> Option<TokenStream>) -> Option<TokenStream> {
    let of = |id| computed(graph, id, text_of);
    Some(match graph.node(id) {
        Node::Constant(bits) => {
            let number = Some(f64::from_bits(bits)).filter(|number| number.is_finite())?;
            let size = Literal::f64_suffixed(number.abs());
            if number.is_sign_negative() { quote!((-#size)) } else { quote!(#size) }
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
        Node::Add(a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            quote!((#a + #b))
        }
        Node::Mul(a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            quote!((#a * #b))
        }
        node => {
            let text = text_of(node)?;
            quote!((#text))
        }
    })
}
