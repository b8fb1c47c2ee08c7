//! Parameters for derivatives, `sensitive(mass, length)`: each is a node of the graph, not part of a source expression,
//! so every expression of it has a derivative.

use crate::graph::{Node, ParameterId, index::LoopSet};
use crate::model::{Parameter, Reader, code::sensitive_lists::several, values::value::Value};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::Member;

/// What a text does that reads a sensitive parameter.
enum Reading {
    /// Names it, as `self.mass`.
    Name(TokenTree),
    /// Hands the whole system over to what may read it.
    Whole(TokenTree),
}

impl Reader<'_> {
    /// The number that a field of the system is, if derivatives are taken by it.
    pub(crate) fn sensitive_field(&mut self, of: &TokenStream, member: &Member) -> Option<Value> {
        let Member::Named(name) = member else { return None };
        if !self.is_sensitive(name) || of.to_string() != "self" {
            return None;
        }
        let known = self.sensitive.get(&name.to_string()).copied();
        let id = known.unwrap_or_else(|| self.declare_sensitive(name));
        Some(Value::Real(self.graph.parameter(id)))
    }

    fn declare_sensitive(&mut self, name: &Ident) -> ParameterId {
        let id = ParameterId(self.parameters.len() as u32);
        let text = quote!(self.#name);
        self.parameters.push(Parameter { own: text.clone(), text, whole: None });
        self.graph.loops.declare_parameter(id, LoopSet::EMPTY);
        self.sensitive.insert(name.to_string(), id);
        id
    }

    /// The parameters that derivatives are taken by, in the order of the annotation; notes those that H does not read.
    pub(crate) fn sensitive_parameters(&mut self) -> Vec<ParameterId> {
        let input = self.input;
        self.check_called_as_they_are();
        let mut parameters = Vec::new();
        for name in &input.sensitive {
            match self.sensitive.get(&name.to_string()) {
                Some(id) => parameters.push(*id),
                // What H reads is not known where it could not be read.
                None if !self.errors.is_empty() => {}
                None => {
                    let message = format!("H does not depend on `self.{name}`\nhelp: leave it out");
                    self.errors.at(name, message);
                }
            }
        }
        parameters
    }

    /// Notes functions that are called as they are, and read such a parameter beside their arguments.
    fn check_called_as_they_are(&mut self) {
        let input = self.input;
        for function in input.functions() {
            let name = &function.sig.ident;
            let is_flow = function.attrs.iter().any(|attribute| attribute.path().is_ident("flow"));
            let is_called = is_flow || self.externals.iter().any(|method| method.name == *name);
            if is_called && self.helper_reads_sensitive(name) {
                let cure = if is_flow { "leave out `sensitive`" } else { "pass what it reads as an argument" };
                let message = format!(
                    "the derivatives of `{name}` with respect to parameters are not known\nhelp: {cure}\nnote: it has \
                     a stated derivative, with respect to its arguments only"
                );
                self.errors.at(name, message);
            }
        }
    }

    /// What to say of a value with several numbers that derivatives are taken by.
    pub(crate) fn several_sensitive(&self, value: &Value) -> Option<String> {
        let Value::Real(number) = value else { return None };
        let Node::Parameter(id) = self.graph.node(*number) else { return None };
        let is_it = |name: &&Ident| self.sensitive.get(&name.to_string()) == Some(&id);
        self.input.sensitive.iter().find(is_it).map(several)
    }

    fn is_sensitive(&self, name: &Ident) -> bool {
        self.input.sensitive.contains(name)
    }

    /// Whether a helper method of the impl is to be read, and not called as it is, since it reads a sensitive parameter.
    pub(crate) fn helper_reads_sensitive(&self, name: &Ident) -> bool {
        if self.input.sensitive.is_empty() {
            return false;
        }
        let helper = self.input.function(&name.to_string());
        helper.is_some_and(|helper| self.reading(&helper.block.to_token_stream(), &mut vec![name.clone()]).is_some())
    }

    /// Notes a text that is evaluated as it stands, though it reads a sensitive parameter.
    pub(crate) fn check_sensitive(&mut self, text: &TokenStream) {
        if self.input.sensitive.is_empty() {
            return;
        }
        match self.reading(text, &mut Vec::new()) {
            None => {}
            Some(Reading::Name(at)) => {
                let message = format!(
                    "this expression has no derivative with respect to `{at}`\nnote: supported are arithmetic, \
                     methods of `f64`, `let`, `if` and helper methods of this impl"
                );
                self.errors.at(at, message);
            }
            Some(Reading::Whole(at)) => {
                let [first, ..] = &self.input.sensitive[..] else { return };
                let message = format!(
                    "this call may read `self.{first}`, and its derivative is not known\nhelp: pass the fields that \
                     it needs, or move it into this impl as a helper method"
                );
                self.errors.at(at, message);
            }
        }
    }

    /// How a text reads a sensitive parameter, in helper methods of this impl as well.
    fn reading(&self, text: &TokenStream, helpers: &mut Vec<Ident>) -> Option<Reading> {
        let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
        for (place, token) in tokens.iter().enumerate() {
            let found = match token {
                TokenTree::Group(group) => self.reading(&group.stream(), helpers),
                TokenTree::Ident(own) if own == "self" => self.reading_of_self(&tokens[place..], helpers),
                _ => None,
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// The same of a text that begins with `self`.
    fn reading_of_self(&self, tokens: &[TokenTree], helpers: &mut Vec<Ident>) -> Option<Reading> {
        let [own, dot, TokenTree::Ident(name), rest @ ..] = tokens else {
            return tokens.first().cloned().map(Reading::Whole);
        };
        if !matches!(dot, TokenTree::Punct(dot) if dot.as_char() == '.') {
            return Some(Reading::Whole(own.clone()));
        }
        if self.is_sensitive(name) {
            return Some(Reading::Name(name.clone().into()));
        }
        let is_call =
            matches!(rest.first(), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
        if !is_call || helpers.contains(name) {
            return None;
        }
        helpers.push(name.clone());
        match self.input.function(&name.to_string()) {
            Some(helper) => {
                self.reading(&helper.block.to_token_stream(), helpers).map(|_| Reading::Whole(name.clone().into()))
            }
            None => Some(Reading::Whole(name.clone().into())),
        }
    }
}
