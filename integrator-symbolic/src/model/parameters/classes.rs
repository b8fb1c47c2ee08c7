//! Parameters of two bodies as tables over classes of bodies, such as `self.table[self.kind[i]][self.kind[j]]`.
//!
//! In: the text of a number or condition. Out: the entry of a table in a row and a column, which are prepared numbers of the
//! bodies. Always true: the entry is the value of the text for a pair with equal values, which the loops visit.

use super::{
    factors::factors,
    flags::OTHER_BODY,
    parameter_text::{Texts, without_condition},
    presence::{is_there, looked_up, unlooked},
    running_index::{but_for, mentions, running_index, with_index},
};
use crate::graph::{
    Graph, NodeId, ParameterId,
    index::{LoopId, LoopSet},
    rename::{End, Parameters, Renaming},
};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// The index of the body whose class is determined.
pub(super) const THIS_BODY: &str = "__this_body";

impl Texts<'_> {
    /// A number of a pair as the entry of a table, or as a product of entries and numbers of one body each. A condition of the
    /// user around it, which the flow also tests, is left out if the number can be looked up where its lists have it.
    pub(super) fn number_of_pair(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        let text = self.text_of_pair(id, pair, ends);
        // What is also read without a condition has all elements.
        if let Some(known) = unlooked(&text).and_then(|text| self.known_id(graph, &text, graph.loops.of_parameter(id)))
        {
            return self.number_of_pair(graph, known, pair, ends);
        }
        if let Some(entry) = self.entry_of_pair(graph, id, [&text, &text], pair, ends) {
            return Some(entry);
        }
        let inner = without_condition(&text).unwrap_or_else(|| text.clone());
        let number = unlooked(&inner).unwrap_or(inner);
        let is_conditional = number.to_string() != text.to_string();
        let factors = factors(number);
        if factors.len() < 2 && !is_conditional {
            return None;
        }
        let mut product = graph.constant(1.0);
        for (factor, exponent) in factors {
            let factor = self.factor(graph, &factor, is_conditional, pair, ends)?;
            let power = graph.power(factor, 2 * exponent);
            product = graph.mul(product, power);
        }
        Some(product)
    }

    /// A factor of a number of a pair.
    fn factor(
        &mut self,
        graph: &mut Graph,
        own: &TokenStream,
        is_conditional: bool,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        if is_conditional && !is_safe(own) {
            return None;
        }
        let text = is_conditional.then(|| looked_up(own, self.root)).flatten();
        let may_be_missing = text.is_some();
        let text = text.unwrap_or_else(|| own.clone());
        let bodies = pair.into_iter().filter(|by| mentions(&text, *by));
        let bodies = bodies.fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)));
        let id = self.id(graph, text.clone(), bodies);
        self.show(id, own);
        if may_be_missing {
            graph.declare_maybe_missing(id);
        }
        match bodies.iter().count() {
            2 => self.entry_of_pair(graph, id, [&text, &text], pair, ends),
            _ => Some(graph.parameter(id)),
        }
    }

    /// The entry for a pair; `None` if the text depends on more than one value of each body. `own` is the text as a number.
    pub(super) fn entry_of_pair(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        [text, own]: [&TokenStream; 2],
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        if graph.loops.of_parameter(id).iter().count() > 2 {
            return None;
        }
        let values = pair.map(|by| value_of(text, by));
        let [Some(first), Some(second)] = values else { return None };
        // A list that is read for either body has all elements.
        let alike = with_index(&second, pair[1], running_index(pair[0])).to_string() == first.to_string();
        let bodies = ends.map(|end| but_for(end.filter(|_| !alike), &self.count));
        let count = self.count.clone();
        let root = self.root;
        let (other, this) = (format_ident!("{OTHER_BODY}"), format_ident!("{THIS_BODY}"));
        let equal = [(&first, pair[0]), (&second, pair[1])].map(|(value, by)| {
            let [(a, has_a), (b, has_b)] = [&other, &this].map(|index| {
                let value = with_index(value, by, index.clone());
                let there = is_there(&value, root).unwrap_or_else(|| quote!(true));
                (value, there)
            });
            let equal = quote!(#root::__private::Both(&(#a), &(#b)).are_equal());
            quote!(&|#other, #this| (#has_a) == (#has_b) && !((#has_a) && !#equal))
        });
        let numbers = [0, 1].map(|at| {
            let (by, bodies, equal) = (pair[at], &bodies[at], &equal[at]);
            let index = running_index(by);
            let whole = quote!(#root::__private::classes(#bodies, #count, #equal));
            let number = self.list(graph, quote!((#whole)[#index]), LoopSet::of(by), whole);
            self.show(number, [&first, &second][at]);
            self.rename(graph, number, Renaming::one(by, pair[1 - at]))?;
            Some(graph.parameter(number))
        });
        let [row, column] = [numbers[0]?, numbers[1]?];
        let [first, second] = pair.map(running_index);
        let order = match ends[0] {
            Some(End::Last) => quote!(#first < #second),
            Some(End::First) => quote!(#first > #second),
            None => quote!(#first != #second),
        };
        let ([rows, columns], [of_rows, of_columns]) = (&equal, &bodies);
        let whole = quote!(#root::__private::ByClass::new(
            [#of_rows, #of_columns],
            [#rows, #columns],
            &|#first, #second| if #order { ::core::option::Option::Some(#own) } else { ::core::option::Option::None }
        ));
        let table = self.table(graph, "ByClass", whole);
        let shown = self.own_text(id);
        self.show(table, &shown);
        self.entries.insert(table, (pair, [own.clone(), shown]));
        graph.declare_like(table, id);
        Some(graph.entry(table, row, column))
    }
}

/// Whether a text has a value wherever its lists have their elements: it calls nothing, and no index of it is cast.
fn is_safe(text: &TokenStream) -> bool {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    tokens.iter().enumerate().all(|(at, token)| match token {
        TokenTree::Ident(name) => name != "as",
        TokenTree::Group(group) => {
            let is_argument = group.delimiter() != Delimiter::Bracket && at > 0;
            let is_call = is_argument && matches!(tokens[at - 1], TokenTree::Ident(_) | TokenTree::Group(_));
            group.delimiter() != Delimiter::Brace && !is_call && is_safe(&group.stream())
        }
        TokenTree::Punct(mark) if mark.as_char() == '.' => {
            // No range of an index.
            !matches!(tokens.get(at + 1), Some(TokenTree::Punct(next)) if next.as_char() == '.')
        }
        TokenTree::Punct(mark) => matches!(mark.as_char(), '.' | '*' | '+' | '-' | '/' | '&' | ':'),
        TokenTree::Literal(_) => true,
    })
}

/// The value of a body that a text reads, such as `self.kind[i]` or `self.atoms[i].kind as usize`; `None` if it reads the index
/// of the body elsewhere, or several values.
fn value_of(text: &TokenStream, by: LoopId) -> Option<TokenStream> {
    let mut found: Option<TokenStream> = None;
    let mut fits = true;
    collect(text, by, &mut |value| match &found {
        Some(known) => fits &= value.as_ref().is_some_and(|value| value.to_string() == known.to_string()),
        None => {
            fits &= value.is_some();
            found = value;
        }
    });
    found.filter(|_| fits)
}

/// Reports every value that a text reads of a body; `None` where it reads the index itself.
fn collect(text: &TokenStream, by: LoopId, report: &mut impl FnMut(Option<TokenStream>)) {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket && is_index(&group.stream(), by) => {
                report(path_to(&tokens, at));
            }
            // Whether a list has an element is known where the element is.
            TokenTree::Group(group) if is_index(&group.stream(), by) && follows(&tokens, at, "has") => {}
            TokenTree::Group(group) => collect(&group.stream(), by, report),
            TokenTree::Ident(name) if *name == running_index(by) => report(None),
            _ => {}
        }
    }
}

fn follows(tokens: &[TokenTree], at: usize, name: &str) -> bool {
    at > 0 && matches!(&tokens[at - 1], TokenTree::Ident(ident) if ident == name)
}

fn is_index(text: &TokenStream, by: LoopId) -> bool {
    running_index(by) == text.to_string()
}

/// The path `self.name[i].field as usize` around the brackets at a place; `None` if there is no such path.
fn path_to(tokens: &[TokenTree], at: usize) -> Option<TokenStream> {
    let is_dot = |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == '.');
    let ident = |at: usize| match tokens.get(at) {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    };
    // Names and positions of fields.
    let is_field = |at: usize| ident(at).is_some() || matches!(tokens.get(at), Some(TokenTree::Literal(_)));
    let mut from = at.checked_sub(1)?;
    while from >= 2 && is_field(from) && is_dot(from - 1) {
        from -= 2;
    }
    if ident(from)? != "self" || from + 1 == at {
        return None;
    }
    let mark_before = |places: usize| match from.checked_sub(places).map(|at| &tokens[at]) {
        Some(TokenTree::Punct(mark)) => mark.as_char(),
        _ => ' ',
    };
    let before = mark_before(1);
    let is_reference = before == '&' && mark_before(2) != '&';
    let mut to = at + 1;
    let is_called = |at: usize| matches!(tokens.get(at), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
    while is_dot(to) && is_field(to + 1) && !is_called(to + 2) {
        to += 2;
    }
    // A method or a function that takes a reference may read more of a value than its `==` compares.
    if is_dot(to) || is_reference {
        return None;
    }
    // Values of a type without `==` can be compared as integers.
    let is_path = matches!(tokens.get(to + 2), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
    let is_cast = ident(to).is_some_and(|name| name == "as") && ident(to + 1).is_some();
    if is_cast && !is_path && !matches!(before, '-' | '*' | '!') {
        to += 2;
    }
    Some(tokens[from..to].iter().cloned().collect())
}
