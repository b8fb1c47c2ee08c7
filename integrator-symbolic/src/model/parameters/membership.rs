//! Conditions such as `self.excluded[i].contains(&j)` and `self.bonded.contains(&(i, j))` as sets of pairs, for sums over pairs.
//!
//! In: the text of a condition. Out: whether the numbers of the two bodies are a pair of a set that a run prepares once. Always
//! true: the set has those pairs of the loops for which the text is true. For an own type of collection, this requires that its
//! items are what it contains.

use super::{
    flags::OTHER_BODY,
    parameter_text::Texts,
    running_index::{but_for, mentions, running_index, with_index},
    text::without_parentheses,
};
use crate::graph::{
    Comparison, Graph, NodeId, ParameterId,
    index::{Index, LoopId},
    rename::End,
};
use quote::{ToTokens, format_ident, quote};
use syn::{Expr, UnOp};

impl Texts<'_> {
    /// The condition that a collection of one body contains the number of the other, or one collection the numbers of both; `None`
    /// of other conditions.
    pub(super) fn membership(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let text = self.text_of_pair(id, pair, ends);
        let mut condition = syn::parse2::<Expr>(text).ok()?;
        let mut holds = true;
        let call = loop {
            condition = match condition {
                Expr::Paren(inner) => *inner.expr,
                Expr::Unary(inner) if matches!(inner.op, UnOp::Not(_)) => {
                    holds = !holds;
                    *inner.expr
                }
                Expr::MethodCall(call) if call.method == "contains" => break call,
                _ => return None,
            };
        };
        let [argument] = &call.args.iter().collect::<Vec<_>>()[..] else { return None };
        let Expr::Reference(argument) = without_parentheses(argument) else { return None };
        let (receiver, member) = (call.receiver.to_token_stream(), argument.expr.to_token_stream());
        if graph.loops.of_parameter(id).iter().count() != 2 {
            return None;
        }
        let of_receiver: Vec<usize> = (0..2).filter(|at| mentions(&receiver, pair[*at])).collect();
        let own = of_receiver.first().copied().unwrap_or(0);
        let [first, second] = [pair[own], pair[1 - own]];
        let is_listed = match of_receiver[..] {
            [_] if is_number(&argument.expr, second) => true,
            [] if pair.iter().all(|by| mentions(&member, *by)) => false,
            _ => return None,
        };
        let (root, this, other) = (self.root, running_index(first), format_ident!("{OTHER_BODY}"));
        let member = with_index(&member, second, other.clone());
        let bodies = but_for(ends[own], &self.count);
        let count = &self.count;
        let partners = match ends[own] {
            None => quote!(0..#count),
            Some(End::First) => quote!(0..#this),
            Some(End::Last) => quote!(#this + 1..#count),
        };
        let items = match is_listed {
            true => quote!(#root::__private::Items(&#receiver)),
            false => quote!(#root::__private::Unlisted),
        };
        let table = quote!(#root::__private::PairSet::new(#bodies, #count, &|#this: usize| {
            #items.bodies(#partners, &|#other: usize| #receiver.contains(&#member))
        }));
        // Each pair comes once, so that its bodies may be exchanged.
        let is_symmetric = ends[0].is_some();
        let table = if is_symmetric { quote!(#table.either_way()) } else { table };
        let table = self.table(graph, "PairSet", table);
        if is_symmetric {
            graph.declare_symmetric(table);
        }
        let shown = self.own_text(id);
        self.show(table, &shown);
        let [first, second] = [first, second].map(|by| {
            let index = graph.loops.intern(Index::Running(by));
            graph.number_of(index)
        });
        let (zero, entry) = (graph.constant(0.0), graph.entry(table, first, second));
        let contains = graph.compare(Comparison::Less, zero, entry);
        Some(if holds { contains } else { graph.not(contains) })
    }
}

/// Integers that the number of a body fits into.
const WIDE: [&str; 8] = ["u32", "u64", "u128", "usize", "i32", "i64", "i128", "isize"];

/// Whether an expression is the index of a loop, perhaps as another type.
fn is_number(expression: &Expr, by: LoopId) -> bool {
    match without_parentheses(expression) {
        // A shorter type may not have the number.
        Expr::Cast(inner) => {
            let to = inner.ty.to_token_stream().to_string();
            is_number(&inner.expr, by) && WIDE.contains(&to.as_str())
        }
        index => running_index(by) == index.to_token_stream().to_string(),
    }
}
