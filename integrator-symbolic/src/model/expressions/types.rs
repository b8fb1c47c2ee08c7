//! Types of moved source. If a type follows from the context in the user's function, it is added explicitly when the
//! source is moved. A reference is dereferenced where the function does so.

use crate::model::{
    Length, Reader,
    expressions::elementary::is_elementary,
    loops::sequence::is_adaptor,
    parameters::text::identifiers,
    values::value::{Opaque, Value},
};
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{Block, Expr, ExprCall, ExprMethodCall, ImplItem, PathArguments, ReturnType, Stmt, Type, parse_quote};

/// Methods of iterators whose result has the type that is requested, which they take in angle brackets.
const ASKED: [&str; 3] = ["collect", "product", "sum"];

/// Methods beside those of floats whose result has one type alone, or that of an argument.
const KNOWN: [&str; 7] = ["fold", "is_empty", "is_err", "is_none", "is_ok", "is_some", "len"];

impl Reader<'_> {
    /// An expression in a place that has a type.
    pub(crate) fn expression_of(&mut self, expression: &Expr, kind: &Type) -> Option<Value> {
        match array_from_function(expression, kind) {
            Some(array) => self.verbatim(expression).or_else(|| self.expression(&array)),
            None => self.expression(expression),
        }
    }

    /// The value of a place that has a type.
    pub(crate) fn of_type(&self, value: Value, kind: &Type) -> Value {
        match (value.where_typed(kind), kind) {
            (Value::Opaque(Opaque { text, loops }), kind) => {
                Value::Opaque(Opaque { text: self.text_of_type(text, kind), loops })
            }
            (Value::Tuple(parts), Type::Tuple(kinds)) if parts.len() == kinds.elems.len() => {
                let parts = parts.into_iter().zip(&kinds.elems);
                Value::Tuple(parts.map(|(part, kind)| self.of_type(part, kind)).collect())
            }
            (Value::Array(parts), Type::Array(kind)) => {
                Value::Array(parts.into_iter().map(|part| self.of_type(part, &kind.elem)).collect())
            }
            (value, _) => value,
        }
    }

    /// The same of what a function or a closure gives.
    pub(crate) fn of_output(&self, value: Value, output: &ReturnType) -> Value {
        match output {
            ReturnType::Type(_, kind) => self.of_type(value, kind),
            ReturnType::Default => value,
        }
    }

    fn text_of_type(&self, text: TokenStream, kind: &Type) -> TokenStream {
        let Ok(expression) = syn::parse2::<Expr>(text.clone()) else { return text };
        let mut names = Vec::new();
        identifiers(kind.to_token_stream(), &mut names);
        // Constants of the function mean nothing outside of it.
        let is_local = names.iter().any(|name| self.lookup(&name.to_string()).is_some());
        if is_local || !self.is_open(&expression) || mentions_impl(kind.to_token_stream()) {
            return text;
        }
        match within(&expression) {
            Expr::MethodCall(call) if is_asked(call) => {
                let ExprMethodCall { receiver, method, .. } = call;
                quote!((#receiver.#method::<#kind>()))
            }
            _ => quote!(::core::convert::identity::<#kind>(#text)),
        }
    }

    /// The text of a parameter read as what it gives or as what that refers to, where it may be either: Rust's operators take
    /// both.
    pub(crate) fn by_value(&self, text: TokenStream, kind: &str) -> TokenStream {
        let may_refer = match kind {
            "operand" | "number" | "integer" => syn::parse2::<Expr>(text.clone()).is_ok_and(|expression| {
                self.is_name_of_arm(&expression)
                    || is_collected(&expression)
                    || kind == "operand" && self.may_refer(&expression)
            }),
            _ => false,
        };
        let root = &self.input.root;
        if may_refer { quote!(#root::__private::by_value(#text)) } else { text }
    }

    fn is_name_of_arm(&self, expression: &Expr) -> bool {
        match within(expression) {
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| self.is_bound(name)),
            _ => false,
        }
    }

    /// Whether an expression may give a reference, as far as its own tokens and this impl show.
    pub(crate) fn may_refer(&self, expression: &Expr) -> bool {
        self.is_open(expression) || self.gives_reference(expression)
    }

    /// Whether the tokens of an integer show that its type is `usize`.
    pub(crate) fn is_usize(&self, text: &TokenStream) -> bool {
        let Ok(expression) = syn::parse2::<Expr>(text.clone()) else { return false };
        let is = |kind: &Type| matches!(kind, Type::Path(path) if path.path.is_ident("usize"));
        match within(&expression) {
            Expr::Cast(cast) => is(&cast.ty),
            Expr::MethodCall(call) => {
                let own = self.own(call).is_some_and(|output| matches!(output, ReturnType::Type(_, kind) if is(kind)));
                own || call.method == "len" || call.method == "count"
            }
            Expr::Call(call) => call.func.to_token_stream().to_string().ends_with("identity :: < usize >"),
            Expr::Path(path) => self.is_constant_of_usize(&path.to_token_stream().to_string()),
            _ => false,
        }
    }

    /// Whether a path is a constant of this impl that is a `usize`, or the length of an array of coordinates.
    fn is_constant_of_usize(&self, path: &str) -> bool {
        let is = |kind: &Type| kind.to_token_stream().to_string() == "usize";
        let generic = self.input.item.generics.const_params().any(|known| known.ident == path && is(&known.ty));
        let own = self.input.item.items.iter().any(|item| match item {
            ImplItem::Const(known) => {
                path.strip_prefix("Self :: ").is_some_and(|name| known.ident == name) && is(&known.ty)
            }
            _ => false,
        });
        let is_length = |length: &Length| matches!(length, Length::Constant(length) if length.to_token_stream().to_string() == path);
        let lengths = self.shape.iter().flat_map(|shape| std::iter::once(&shape.length).chain(&shape.inner));
        generic || own || lengths.into_iter().any(is_length)
    }

    /// Whether only the context of an expression may determine its type.
    fn is_open(&self, expression: &Expr) -> bool {
        match within(expression) {
            Expr::MethodCall(call) => {
                let name = call.method.to_string();
                let is_known = is_elementary(&name) || KNOWN.contains(&name.as_str()) || self.own(call).is_some();
                call.turbofish.is_none() && !is_known
            }
            Expr::Call(ExprCall { func, .. }) => match &**func {
                Expr::Path(path) => {
                    let is_own = |name: &str| self.input.function(name).is_some();
                    let mut segments = path.path.segments.iter();
                    let names: Vec<String> = segments.clone().map(|segment| segment.ident.to_string()).collect();
                    let is_known = match &names[..] {
                        [.., kind, _] if kind == "f64" => true,
                        [kind, name] => kind == "Self" && is_own(name),
                        _ => false,
                    };
                    !is_known && segments.all(|segment| matches!(segment.arguments, PathArguments::None))
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether an expression is a call of a method of this impl that gives a reference.
    fn gives_reference(&self, expression: &Expr) -> bool {
        let Expr::MethodCall(call) = within(expression) else { return false };
        self.own(call)
            .is_some_and(|output| matches!(output, ReturnType::Type(_, kind) if matches!(**kind, Type::Reference(_))))
    }

    /// What a method of this impl gives, if one is called.
    fn own(&self, call: &ExprMethodCall) -> Option<&ReturnType> {
        let is_self = matches!(within(&call.receiver), Expr::Path(path) if path.path.is_ident("self"));
        let function = self.input.function(&call.method.to_string()).filter(|_| is_self)?;
        Some(&function.sig.output)
    }
}

/// Whether an expression is an item of an iterator that was collected, which may give references.
pub(crate) fn is_collected(expression: &Expr) -> bool {
    let Expr::Index(item) = within(expression) else { return false };
    matches!(within(&item.expr), Expr::MethodCall(call) if call.method == "collect")
}

/// An expression without the parentheses around it, and the last one of a block.
fn within(expression: &Expr) -> &Expr {
    match expression {
        Expr::Paren(inner) => within(&inner.expr),
        Expr::Block(block) => match block.block.stmts.last() {
            Some(Stmt::Expr(last, None)) => within(last),
            _ => expression,
        },
        other => other,
    }
}

/// Whether a method of an iterator takes the type of its result in angle brackets.
fn is_asked(call: &ExprMethodCall) -> bool {
    let of_iterator = matches!(&*call.receiver, Expr::MethodCall(inner) if is_adaptor(inner));
    of_iterator && call.args.is_empty() && ASKED.contains(&call.method.to_string().as_str())
}

/// Whether a type is one that arguments alone may have.
fn mentions_impl(kind: TokenStream) -> bool {
    kind.into_iter().any(|token| match token {
        TokenTree::Ident(word) => word == "impl",
        TokenTree::Group(group) => mentions_impl(group.stream()),
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// `std::array::from_fn(|i| ...)` where the context is an array and determines the length,
/// written as a list that is collected.
pub(crate) fn array_from_function(expression: &Expr, kind: &Type) -> Option<Expr> {
    match (expression, kind) {
        (Expr::Paren(inner), kind) => array_from_function(&inner.expr, kind),
        (Expr::Reference(expression), Type::Reference(kind)) => array_from_function(&expression.expr, &kind.elem),
        (Expr::Call(call), Type::Array(array)) => {
            let Expr::Path(function) = &*call.func else { return None };
            let (length, element) = (&array.len, call.args.first()?);
            let is = function.path.segments.last().is_some_and(|name| name.ident == "from_fn");
            is.then(|| parse_quote!((0..#length).map(#element).collect()))
        }
        _ => None,
    }
}

/// A block whose last expression makes an array in the way that is read.
pub(crate) fn ending_in(block: &Block, output: &ReturnType) -> Block {
    let mut block = block.clone();
    if let (Some(Stmt::Expr(last, None)), ReturnType::Type(_, kind)) = (block.stmts.last_mut(), output)
        && let Some(array) = array_from_function(last, kind)
    {
        *last = array;
    }
    block
}
