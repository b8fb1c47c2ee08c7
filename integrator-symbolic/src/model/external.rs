//! Methods of the user that are called as they are: `#[derivative(slope)]` names the method that gives their derivative.

use super::{
    Reader,
    call::{takes, typed_arguments},
    shape::is_f64,
    value::Value,
};
use crate::graph::{ExternalId, NodeId};
use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::{Attribute, Expr, ImplItemFn, ReturnType, Token, punctuated::Punctuated};

/// The name of the attribute.
const ATTRIBUTE: &str = "derivative";

/// The attribute that makes a method an external one.
pub(super) fn attribute(method: &ImplItemFn) -> Option<&Attribute> {
    method.attrs.iter().find(|attribute| attribute.path().is_ident(ATTRIBUTE))
}

/// An item without the attribute, which means nothing outside of the annotated impl.
pub(crate) fn stripped(item: TokenStream) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    for tree in item {
        match &tree {
            TokenTree::Group(group) if is_attribute(&group.stream()) && ends_with_hash(&kept) => {
                kept.pop();
            }
            TokenTree::Group(group) if group.delimiter() == proc_macro2::Delimiter::Brace => {
                let mut inner = proc_macro2::Group::new(group.delimiter(), stripped(group.stream()));
                inner.set_span(group.span());
                kept.push(inner.into());
            }
            _ => kept.push(tree),
        }
    }
    kept.into_iter().collect()
}

fn is_attribute(tokens: &TokenStream) -> bool {
    matches!(tokens.clone().into_iter().next(), Some(TokenTree::Ident(name)) if name == ATTRIBUTE)
}

fn ends_with_hash(trees: &[TokenTree]) -> bool {
    matches!(trees.last(), Some(TokenTree::Punct(mark)) if mark.as_char() == '#')
}

impl Reader<'_> {
    /// A call of a method with stated derivatives.
    pub(super) fn external(
        &mut self,
        method: &ImplItemFn,
        attribute: &Attribute,
        arguments: Vec<Value>,
        places: &[&Expr],
    ) -> Option<Value> {
        let expected = typed_arguments(method).count();
        if expected != arguments.len() {
            self.errors.at(places.first(), takes(&method.sig.ident.to_string(), expected, arguments.len()));
            return None;
        }
        let id = self.external_id(method, Some(attribute))?;
        let numbers: Vec<_> = arguments.iter().zip(places).map(|(value, place)| self.number(value, place)).collect();
        let numbers = numbers.into_iter().collect::<Option<Vec<NodeId>>>()?;
        Some(Value::Real(match numbers[..] {
            [a, b] if self.mixes(a, b) => {
                self.not_separable(places[1]);
                return None;
            }
            [a, b] => self.graph.external(id, a, Some(b)),
            [a, ..] => self.graph.external(id, a, None),
            [] => return None,
        }))
    }

    /// The id of a method, new or known; its derivatives are looked up by name.
    fn external_id(&mut self, method: &ImplItemFn, attribute: Option<&Attribute>) -> Option<ExternalId> {
        let name = &method.sig.ident;
        if let Some(known) = self.externals.iter().position(|known| known == name) {
            return Some(ExternalId(known as u32));
        }
        let arguments: Vec<_> = typed_arguments(method).collect();
        let returns_f64 = matches!(&method.sig.output, ReturnType::Type(_, kind) if is_f64(kind));
        if !(1..=2).contains(&arguments.len()) || !arguments.iter().all(|argument| is_f64(&argument.ty)) || !returns_f64
        {
            let message =
                format!("a method with stated derivatives takes one f64 or two: `fn {name}(&self, x: f64) -> f64`");
            self.errors.at(&method.sig.ident, message);
            return None;
        }
        // Known before its derivatives are, which may lead back to it: exp is its own.
        let id = self.graph.declare_external();
        self.externals.push(name.clone());
        self.two_arguments.push(arguments.len() == 2);
        if let Some(attribute) = attribute {
            let slopes = self.slopes_of(method, attribute, arguments.len())?;
            self.graph.derive_external(id, slopes);
        }
        Some(id)
    }

    /// The methods that an attribute names, one for each argument.
    fn slopes_of(
        &mut self,
        method: &ImplItemFn,
        attribute: &Attribute,
        count: usize,
    ) -> Option<[Option<ExternalId>; 2]> {
        let names = attribute.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
        let names: Vec<Ident> = match names {
            Ok(names) if names.len() == count => names.into_iter().collect(),
            _ => {
                let message = match count {
                    1 => "name the method that gives the derivative: `#[derivative(slope)]`",
                    _ => "name the methods that give the two derivatives: `#[derivative(by_first, by_second)]`",
                };
                self.errors.at(attribute, message);
                return None;
            }
        };
        let mut slopes = [None; 2];
        let input = self.input;
        for (slope, name) in slopes.iter_mut().zip(&names) {
            let found = input.function(&name.to_string()).filter(|found| typed_arguments(found).count() == count);
            let Some(found) = found else {
                let arguments = if count == 1 { "x: f64" } else { "x: f64, y: f64" };
                let message = format!(
                    "the impl lacks `fn {name}(&self, {arguments}) -> f64`, the derivative of `{}`",
                    method.sig.ident
                );
                self.errors.at(name, message);
                return None;
            };
            *slope = Some(self.external_id(found, super::external::attribute(found))?);
        }
        Some(slopes)
    }
}
