//! Conditions of parameters as conditions on numbers of one body each, for sums over pairs.
//!
//! In: the text of a condition, such as `self.kind[i] != self.kind[j]`. Out: a comparison of prepared numbers. Always true: it
//! holds where the text does, whatever types the parameters have, if their `==` is an equivalence relation on the values (where
//! `a == b` and `b == c`, `a == c`).

use super::{
    classes::THIS_BODY,
    parameter_text::Texts,
    running_index::{loop_of, mentions, running_index, with_index},
};
use crate::graph::{
    Comparison, Graph, NodeId, ParameterId,
    index::{Index, LoopId, LoopSet},
    rename::{End, Parameters, Renaming},
};
use proc_macro2::{TokenStream, TokenTree};
use quote::{format_ident, quote};

/// The index of another body in a closure.
pub(super) const OTHER_BODY: &str = "__other_body";

impl Texts<'_> {
    /// The condition for a pair whose bodies have no partner at these ends; `None` if it depends on more than a value of each body.
    pub(super) fn flag_of_pair(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let (text, loops) = (self.text_of_pair(id, pair, ends), graph.loops.of_parameter(id));
        let own = |loops: LoopSet| pair.into_iter().filter(move |by| loops.contains(*by));
        if own(loops).count() < 2 {
            let number = self.id(graph, quote!(((#text) as u8 as f64)), loops);
            let (zero, number) = (graph.constant(0.0), graph.parameter(number));
            return Some(graph.compare(Comparison::Less, zero, number));
        }
        let condition = self.equality(graph, &text, pair, ends, loops);
        let condition = condition.or_else(|| {
            let number = quote!((#text) as u8 as f64);
            let entry = self.entry_of_pair(graph, id, [&text, &number], pair, ends)?;
            let zero = graph.constant(0.0);
            Some(graph.compare(Comparison::Less, zero, entry))
        });
        let condition = condition.or_else(|| self.membership(graph, id, pair, ends));
        condition.or_else(|| self.joined(graph, id, pair, ends))
    }

    /// An equality of values of the two bodies.
    fn equality(
        &mut self,
        graph: &mut Graph,
        text: &TokenStream,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
        loops: LoopSet,
    ) -> Option<NodeId> {
        let (sides, equal) = sides(text)?;
        let of = |side: &TokenStream| pair.into_iter().filter(|by| mentions(side, *by)).collect::<Vec<_>>();
        let [[first], [second]] = [&of(&sides[0])[..], &of(&sides[1])[..]] else { return None };
        let (bodies, is_of_pair) = ([*first, *second], first != second && loops.iter().count() == 2);
        let alike = with_index(&sides[1], *second, running_index(*first)).to_string() == sides[0].to_string();
        let numbers = match alike {
            true => Some(
                [self.class(&sides[0], *first), self.class(&sides[1], *second)]
                    .map(|[text, whole]| (text, Some(whole))),
            ),
            // What is compared with an index is an integer of its type.
            false => sides.iter().any(is_of_indices).then(|| {
                sides.each_ref().map(|side| match is_of_indices(side) {
                    true => (in_numbers(side), None),
                    false => (quote!(((#side) as f64)), None),
                })
            }),
        };
        let numbers = numbers.filter(|_| is_of_pair)?;
        let mut of_body = |side: &TokenStream, (text, whole): &(TokenStream, Option<TokenStream>), by: LoopId| {
            if running_index(by) == side.to_string() {
                let index = graph.loops.intern(Index::Running(by));
                return Some(graph.number_of(index));
            }
            let at = usize::from(by == pair[1]);
            let number = match whole {
                Some(whole) => self.list(graph, text.clone(), LoopSet::of(by), whole.clone()),
                None => self.id(graph, text.clone(), LoopSet::of(by)),
            };
            self.show(number, side);
            self.rename(graph, number, Renaming::one(by, pair[1 - at]))?;
            let number = match ends[at].filter(|_| !alike) {
                None => number,
                Some(end) => self.without(graph, number, false, by, end)?,
            };
            Some(graph.parameter(number))
        };
        let [a, b] = [of_body(&sides[0], &numbers[0], bodies[0])?, of_body(&sides[1], &numbers[1], bodies[1])?];
        let condition = graph.compare(Comparison::Equal, a, b);
        Some(if equal { condition } else { graph.not(condition) })
    }

    /// A number that two bodies have in common where a text has the same value for both, and the code of the numbers of all.
    fn class(&self, text: &TokenStream, by: LoopId) -> [TokenStream; 2] {
        let (root, index, count) = (self.root, running_index(by), &self.count);
        let (other, this) = (format_ident!("{OTHER_BODY}"), format_ident!("{THIS_BODY}"));
        let [a, b] = [&other, &this].map(|index| with_index(text, by, index.clone()));
        let whole = quote!(#root::__private::numbers_of_values(
            #count,
            &|#this| #root::__private::SmallInteger(&(#b)).value(),
            &|#other, #this| #a == #b
        ));
        [quote!((#whole)[#index]), whole]
    }
}

/// The two sides of an equality, and whether it is one; `None` of what is neither `a == b` nor `a != b`.
fn sides(text: &TokenStream) -> Option<([TokenStream; 2], bool)> {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    if let [TokenTree::Group(group)] = &tokens[..] {
        return sides(&group.stream());
    }
    let mark = |at: usize| match tokens.get(at) {
        Some(TokenTree::Punct(mark)) => mark.as_char(),
        _ => ' ',
    };
    let found: Vec<usize> = (0..tokens.len()).filter(|at| "=!<>&|?;".contains(mark(*at)) && mark(*at) != ' ').collect();
    let [at, next] = found[..] else { return None };
    let is_equality = next == at + 1 && mark(next) == '=' && matches!(mark(at), '=' | '!');
    let side = |tokens: &[TokenTree]| tokens.iter().cloned().collect::<TokenStream>();
    is_equality.then(|| ([side(&tokens[..at]), side(&tokens[next + 1..])], mark(at) == '='))
}

/// Whether a text consists of indices of loops and of numbers.
fn is_of_indices(text: &TokenStream) -> bool {
    text.clone().into_iter().all(|token| match token {
        TokenTree::Ident(name) => loop_of(&name).is_some(),
        TokenTree::Group(group) => is_of_indices(&group.stream()),
        TokenTree::Punct(mark) => matches!(mark.as_char(), '+' | '-' | '*'),
        TokenTree::Literal(_) => true,
    })
}

/// A text of indices and numbers as one of real numbers, whose differences have a value for each body.
fn in_numbers(text: &TokenStream) -> TokenStream {
    let tokens = text.clone().into_iter().map(|token| match token {
        TokenTree::Ident(_) | TokenTree::Literal(_) => quote!((#token as f64)),
        TokenTree::Group(group) => {
            let inner = in_numbers(&group.stream());
            quote!((#inner))
        }
        TokenTree::Punct(mark) => quote!(#mark),
    });
    let tokens: TokenStream = tokens.collect();
    quote!((#tokens))
}
