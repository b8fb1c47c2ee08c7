//! The user's expressions of parameters, rewritten for other indices.

use super::{Parameter, factors::factors};
use crate::graph::{
    Graph, ParameterId,
    index::{LoopId, LoopSet},
    rename::{Parameters, Renaming},
};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::format_ident;
use std::collections::HashMap;

/// The texts of a model, and what the indices in them are called.
pub(crate) struct Texts<'m> {
    parameters: &'m mut Vec<Parameter>,
    running: &'m mut HashMap<LoopId, Ident>,
    /// The parameters by the loops whose indices they mention, and by their text; filled when first asked for.
    known: HashMap<(LoopSet, String), ParameterId>,
}

impl Parameters for Texts<'_> {
    fn rename(&mut self, graph: &mut Graph, id: ParameterId, renaming: Renaming) -> Option<ParameterId> {
        let loops = graph.loops.of_parameter(id);
        if loops.iter().all(|by| renaming.of(by) == by) {
            return Some(id);
        }
        let names = loops.iter().map(|by| Some((self.running.get(&by)?, self.running.get(&renaming.of(by))?)));
        let text = with_names(self.text(id), &names.collect::<Option<Vec<_>>>()?)?;
        let loops = loops.iter().fold(LoopSet::EMPTY, |set, by| set.union(LoopSet::of(renaming.of(by))));
        Some(self.id(graph, text, loops))
    }

    fn factors(&mut self, graph: &mut Graph, id: ParameterId) -> Vec<(ParameterId, i32)> {
        let factors = factors(self.text(id));
        if factors.len() < 2 {
            return vec![(id, 1)];
        }
        let loops = graph.loops.of_parameter(id);
        let mut of = |(text, exponent): (TokenStream, i32)| {
            let own = loops.iter().filter(|by| self.running.get(by).is_some_and(|name| mentions(&text, name)));
            let own = own.fold(LoopSet::EMPTY, |set, by| set.union(LoopSet::of(by)));
            (self.id(graph, text, own), exponent)
        };
        factors.into_iter().map(&mut of).collect()
    }

    fn name(&mut self, new: LoopId, like: LoopId) {
        let base = self.running.get(&like).cloned().unwrap_or_else(|| format_ident!("k"));
        let is_taken = |name: &Ident| {
            let mut texts = self.parameters.iter().map(|parameter| &parameter.text);
            self.running.values().any(|known| known == name) || texts.any(|text| mentions(text, name))
        };
        let free = (2_u32..).map(|count| format_ident!("{base}_{count}")).find(|name| !is_taken(name));
        self.running.insert(new, free.unwrap_or(base));
    }
}

impl<'m> Texts<'m> {
    pub(crate) fn new(parameters: &'m mut Vec<Parameter>, running: &'m mut HashMap<LoopId, Ident>) -> Self {
        Self { parameters, running, known: HashMap::new() }
    }

    fn text(&self, id: ParameterId) -> TokenStream {
        self.parameters[id.0 as usize].text.clone()
    }

    /// The parameter with this text, new or known.
    pub(crate) fn id(&mut self, graph: &mut Graph, text: TokenStream, loops: LoopSet) -> ParameterId {
        if self.known.is_empty() {
            let parameters = (0..).map(ParameterId).zip(self.parameters.iter());
            let key = |id, parameter: &Parameter| (graph.loops.of_parameter(id), parameter.text.to_string());
            self.known = parameters.map(|(id, parameter)| (key(id, parameter), id)).collect();
        }
        *self.known.entry((loops, text.to_string())).or_insert_with(|| {
            let made = ParameterId(self.parameters.len() as u32);
            self.parameters.push(Parameter { own: text.clone(), text });
            graph.loops.declare_parameter(made, loops);
            made
        })
    }
}

/// Whether a text mentions a variable.
fn mentions(text: &TokenStream, name: &Ident) -> bool {
    text.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == *name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// A text with other names of variables. Closures and blocks may have variables of their own, so they are left alone.
fn with_names(text: TokenStream, names: &[(&Ident, &Ident)]) -> Option<TokenStream> {
    let mut after_dot = false;
    let renamed = text.into_iter().map(|token| {
        let is_field = after_dot;
        after_dot = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == '.');
        Some(match token {
            TokenTree::Ident(name) if !is_field => {
                let other = names
                    .iter()
                    .find(|(from, _)| **from == name)
                    .map(|(_, to)| Ident::new(&to.to_string(), name.span()));
                other.unwrap_or(name).into()
            }
            TokenTree::Punct(mark) if mark.as_char() == '|' => return None,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => return None,
            TokenTree::Group(group) => {
                let mut other = Group::new(group.delimiter(), with_names(group.stream(), names)?);
                other.set_span(group.span());
                other.into()
            }
            other => other,
        })
    });
    renamed.collect()
}
