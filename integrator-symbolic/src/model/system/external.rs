//! Attributes of the user's methods.
//!
//! - `#[derivative(slope)]`, on a method that is called unchanged, names the method that computes its derivative. It
//!   can also name several methods, or one that returns an array of derivatives.
//! - `#[flow(part)]` marks a method as the flow of a part.
//! - `#[invariant]` declares that a function is conserved.

use crate::model::{
    Reader,
    code::{
        attributes::{DERIVATIVE, FLOW, INVARIANT, attribute},
        shape::{is_f64, typed_arguments},
    },
    expressions::elementary::takes,
    values::value::Value,
};
use crate::{
    errors::Places,
    graph::{ExternalId, NodeId, external::Arguments},
    syntax::{FRICTION, TEMPERATURE},
};
use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream, TokenTree};
use quote::quote;
use std::fmt;
use syn::{Attribute, Expr, ExprLit, ImplItemFn, Lit, ReturnType, Token, Type, punctuated::Punctuated};

/// Returns the item without these attributes, which have no meaning outside of the macro.
///
/// rustc would report several mistakes a second time, in more lines. Therefore an invariant with the name of an earlier one
/// is removed, and rustc does not check the bodies of functions with mistakes.
pub(crate) fn strip(item: TokenStream, mistakes: &Places) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    let mut invariants: Vec<String> = Vec::new();
    // Where the current function begins, and whether it is an invariant.
    let (mut begin, mut is_invariant) = (0, false);
    for tree in item {
        match tree {
            TokenTree::Group(group) if is_attribute(&group.stream()) && ends_with_hash(&kept) => {
                kept.pop();
                is_invariant |= first(&group.stream()).is_some_and(|name| name == INVARIANT);
            }
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let mut inner = Group::new(group.delimiter(), strip(group.stream(), mistakes));
                inner.set_span(group.span());
                let function = function_name(&kept[begin..]);
                kept.push(inner.into());
                if function.is_some() && !returns_opaque(&kept[begin..]) && mistakes.are_in(&kept[begin..]) {
                    let body = kept.pop();
                    kept.push(unchecked(body));
                }
                match function.filter(|_| is_invariant) {
                    Some(name) if invariants.contains(&name) => kept.truncate(begin),
                    name => invariants.extend(name),
                }
                (begin, is_invariant) = (kept.len(), false);
            }
            TokenTree::Punct(mark) if mark.as_char() == ';' => {
                kept.push(mark.into());
                (begin, is_invariant) = (kept.len(), false);
            }
            tree => kept.push(tree),
        }
    }
    kept.into_iter().collect()
}

/// A body that rustc does not check, except in tests. rust-analyzer sets `test`, so it completes names in the body.
fn unchecked(body: Option<TokenTree>) -> TokenTree {
    let lints = quote!(#![allow(unused, reason = "the body is left out, since the macro reports a mistake in it")]);
    Group::new(Delimiter::Brace, quote!(#lints #[cfg(test)] #body #[cfg(not(test))] loop {})).into()
}

/// Whether the type that a function returns may contain `impl Trait`, which `loop {}` does not have.
fn returns_opaque(trees: &[TokenTree]) -> bool {
    trees.iter().any(|tree| matches!(tree, TokenTree::Ident(word) if word == "impl"))
}

/// The name after `fn`.
fn function_name(trees: &[TokenTree]) -> Option<String> {
    let keyword = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "fn");
    match trees.get(trees.iter().position(keyword)? + 1)? {
        TokenTree::Ident(name) => Some(name.to_string()),
        _ => None,
    }
}

/// The first token, where it is a name.
fn first(tokens: &TokenStream) -> Option<Ident> {
    match tokens.clone().into_iter().next()? {
        TokenTree::Ident(name) => Some(name),
        _ => None,
    }
}

fn is_attribute(tokens: &TokenStream) -> bool {
    let own = [DERIVATIVE, FLOW, INVARIANT, FRICTION, TEMPERATURE];
    first(tokens).is_some_and(|name| own.iter().any(|own| name == own))
}

fn ends_with_hash(trees: &[TokenTree]) -> bool {
    matches!(trees.last(), Some(TokenTree::Punct(mark)) if mark.as_char() == '#')
}

/// A method of the user, or a part of what one gives.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Method {
    pub(crate) name: Ident,
    /// How many arguments it takes.
    pub(crate) arguments: usize,
    /// Which element is meant, where the method gives an array of slopes, or of arrays of them.
    at: Vec<usize>,
}

impl Method {
    /// The call of the method of a system.
    pub(crate) fn call(&self, system: &TokenStream, arguments: &[TokenStream]) -> TokenStream {
        let (name, at) = (&self.name, self.at.iter().map(|place| Literal::usize_unsuffixed(*place)));
        quote!(#system.#name(#(#arguments),*) #([#at])*)
    }

    /// The call as a formula.
    pub(crate) fn written(&self, arguments: &str) -> String {
        let at: String = self.at.iter().map(|place| format!("[{place}]")).collect();
        format!("{}({arguments}){at}", self.name)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.name.fmt(formatter)
    }
}

impl Reader<'_> {
    /// A call of a method with stated derivatives.
    pub(crate) fn external(&mut self, method: &ImplItemFn, arguments: Vec<Value>, places: &[&Expr]) -> Option<Value> {
        let expected = typed_arguments(method).count();
        if expected != arguments.len() {
            self.errors.at(places.first(), takes(&method.sig.ident.to_string(), expected, arguments.len()));
            return None;
        }
        let id = self.external_id(method, Vec::new())?;
        let numbers: Vec<_> = arguments.iter().zip(places).map(|(value, place)| self.number(value, place)).collect();
        let numbers = numbers.into_iter().collect::<Option<Vec<NodeId>>>()?;
        for (place, later) in numbers.iter().enumerate() {
            if self.is_mixed(*later) || numbers[..place].iter().any(|earlier| self.mixes(*earlier, *later)) {
                self.not_separable(places[place]);
                return None;
            }
        }
        let arguments = Arguments::new(&numbers)?;
        Some(Value::Real(self.graph.external(id, arguments)))
    }

    /// The id of a method, or of an element of what it gives, new or known; its derivatives are looked up by name.
    fn external_id(&mut self, method: &ImplItemFn, at: Vec<usize>) -> Option<ExternalId> {
        let arguments: Vec<_> = typed_arguments(method).collect();
        let own = Method { name: method.sig.ident.clone(), arguments: arguments.len(), at };
        if let Some(known) = self.externals.iter().position(|known| *known == own) {
            return Some(ExternalId(known as u32));
        }
        let fits = arguments.iter().all(|argument| is_f64(&argument.ty)) && Arguments::fits(arguments.len());
        if !fits || !gives(&method.sig.output, arguments.len(), own.at.len()) {
            let (name, most) = (&own.name, Arguments::MOST);
            let message = match own.at.len() {
                0 => format!(
                    "a method with stated derivatives has to take between one and {most} arguments of type \
                     `f64`\nhelp: write `fn {name}(&self, x: f64) -> f64`"
                ),
                depth => format!("`{name}` has to return the derivatives as `{}`", kind(own.arguments, depth)),
            };
            self.errors.at(&method.sig.ident, message);
            return None;
        }
        // Known before its derivatives are, which may lead back to it: exp is its own.
        let id = self.graph.declare_external();
        self.externals.push(own.clone());
        if let Some(attribute) = attribute(method) {
            let slopes = self.slopes_of(method, attribute, &own)?;
            self.graph.derive_external(id, slopes);
        }
        Some(id)
    }

    /// The methods that an attribute names, one for each argument, or one that gives an array of the derivatives.
    fn slopes_of(&mut self, method: &ImplItemFn, attribute: &Attribute, own: &Method) -> Option<Vec<ExternalId>> {
        let count = own.arguments;
        let names = attribute.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
        let names: Vec<Ident> = names.map(|names| names.into_iter().collect()).unwrap_or_default();
        let (one_each, in_array) = (names.len() == count && own.at.is_empty(), names.len() == 1 && count > 1);
        if !one_each && !in_array {
            let message = match (count, own.at.len()) {
                (1, _) => "`#[derivative]` lacks the method that returns the derivative\nhelp: write \
                           `#[derivative(slope)]`"
                    .to_owned(),
                (_, 0) => format!(
                    "`#[derivative]` lacks the methods that return the {count} derivatives\nhelp: write \
                     `#[derivative(by_first, by_second)]`, or `#[derivative(gradient)]` with one method that returns \
                     an array"
                ),
                _ => "`#[derivative]` lacks the method that returns the second derivatives\nhelp: write \
                      `#[derivative(hessian)]`"
                    .to_owned(),
            };
            self.errors.at(attribute, message);
            return None;
        }
        let mut slopes = Vec::new();
        for argument in 0..count {
            let (name, at) = match in_array {
                true => (&names[0], own.at.iter().copied().chain([argument]).collect()),
                false => (&names[argument], Vec::new()),
            };
            let input = self.input;
            let found = input.function(&name.to_string()).filter(|found| typed_arguments(found).count() == count);
            let Some(found) = found else {
                let arguments: Vec<String> = NAMES.iter().take(count).map(|name| format!("{name}: f64")).collect();
                let message = format!(
                    "the impl lacks `fn {name}(&self, {}) -> {}`, the derivative of `{}`",
                    arguments.join(", "),
                    kind(count, at.len()),
                    method.sig.ident
                );
                self.errors.at(name, message);
                return None;
            };
            slopes.push(self.external_id(found, at)?);
        }
        Some(slopes)
    }
}

/// What arguments are called in messages.
const NAMES: [&str; Arguments::MOST] = ["x", "y", "z", "u", "v", "w", "s", "t"];

/// The type of a number, of an array of slopes, or of arrays of them.
fn kind(count: usize, depth: usize) -> String {
    (0..depth).fold("f64".to_owned(), |inner, _| format!("[{inner}; {count}]"))
}

/// Whether a method returns that type. A length that is no literal is the compiler's to compare.
fn gives(output: &ReturnType, count: usize, depth: usize) -> bool {
    let ReturnType::Type(_, returned) = output else { return false };
    let mut kind: &Type = returned;
    for _ in 0..depth {
        let Type::Array(array) = kind else { return false };
        if let Expr::Lit(ExprLit { lit: Lit::Int(length), .. }) = &array.len
            && length.base10_parse::<usize>().is_ok_and(|length| length != count)
        {
            return false;
        }
        kind = &array.elem;
    }
    is_f64(kind)
}
