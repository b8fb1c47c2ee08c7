//! Conditions that join others by `&&` or `||`, such as `molecule[i] != molecule[j] && !excluded[i].contains(&j)`.
//!
//! In: the text of a condition of two bodies. Out: the conditions that it joins, each as one of its own. Always true: each of them may be
//! evaluated where the one before it decides already, since its indices are numbers of bodies as they stand.

use super::{
    parameter_text::Texts,
    running_index::{mentioned, mentions},
    text::without_parentheses,
};
use crate::graph::{Graph, NodeId, ParameterId, index::LoopId, rename::End};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{BinOp, Expr};

impl Texts<'_> {
    /// The condition of a pair by those that it joins; `None` if it joins none, or if one of them may guard another.
    pub(super) fn joined(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let condition = syn::parse2::<Expr>(self.text_of_pair(id, pair, ends)).ok()?;
        let Expr::Binary(joined) = without_parentheses(&condition) else { return None };
        let is_and = match joined.op {
            BinOp::And(_) => true,
            BinOp::Or(_) => false,
            _ => return None,
        };
        let sides = [&joined.left, &joined.right].map(|side| side.to_token_stream());
        let reads_both = |side: &TokenStream| pair.iter().all(|by| mentions(side, *by));
        if !sides.iter().all(|side| reads_both(side) && is_unguarded(side.clone())) {
            return None;
        }
        let loops = graph.loops.of_parameter(id);
        let mut of = |side: TokenStream| {
            let own = mentioned(&side, loops);
            let side = self.id(graph, side, own);
            graph.declare_like(side, id);
            self.flag_of_pair(graph, side, pair, ends)
        };
        let [left, right] = sides.map(&mut of);
        Some(if is_and { graph.and(left?, right?) } else { graph.or(left?, right?) })
    }
}

/// Whether all elements that a text reads are those of the bodies themselves, which exist whatever another condition says.
fn is_unguarded(text: TokenStream) -> bool {
    text.into_iter().all(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
            let index: Vec<TokenTree> = group.stream().into_iter().collect();
            matches!(index[..], [TokenTree::Ident(_)])
        }
        TokenTree::Group(group) => is_unguarded(group.stream()),
        TokenTree::Punct(mark) => !"+-*/%".contains(mark.as_char()),
        TokenTree::Ident(_) | TokenTree::Literal(_) => true,
    })
}
