//! Closures in variables and functions inside of functions: read again wherever they are called.

use super::{
    BindingId, Reader,
    integer::operand,
    statement::Assigned,
    text::identifiers,
    value::{Opaque, Value},
};
use quote::{ToTokens, quote};
use std::{collections::HashMap, rc::Rc};
use syn::{Expr, ExprClosure, ItemFn, visit::Visit};

/// What is called with values.
pub(crate) struct Callable {
    closure: ExprClosure,
    /// The variables that it sees, as they were where it was written.
    captured: HashMap<String, BindingId>,
    /// Itself as text, where it reads parameters alone.
    pub(super) text: Option<Opaque>,
}

impl Reader<'_> {
    /// A closure as a value.
    pub(super) fn captured(&mut self, closure: &ExprClosure) -> Option<Value> {
        let expression = Expr::Closure(closure.clone());
        let mut assigned = Assigned::default();
        assigned.visit_expr(&closure.body);
        if let Some(name) = assigned.names.iter().find(|name| self.lookup(name).is_some()) {
            let message =
                format!("this closure assigns to `{name}`, which is outside of it: let it return what it adds");
            self.errors.at(closure, message);
            return None;
        }
        let text = match self.verbatim(&expression) {
            Some(Value::Opaque(text)) => Some(text),
            _ => None,
        };
        let mut names = Vec::new();
        identifiers(closure.body.to_token_stream(), &mut names);
        let known = names.into_iter().filter_map(|name| Some((name.to_string(), self.lookup(&name.to_string())?)));
        let known: Vec<_> = known.collect();
        let captured = known.into_iter().map(|(name, id)| (name, self.copied(id))).collect();
        Some(Value::Closure(Rc::new(Callable { closure: closure.clone(), captured, text })))
    }

    /// A function inside of the function, which sees no variables.
    pub(super) fn inner_function(&mut self, function: &ItemFn) {
        let (inputs, block) = (&function.sig.inputs, &function.block);
        let value = match syn::parse2(quote!(|#inputs| #block)) {
            Ok(closure) => Value::Closure(Rc::new(Callable { closure, captured: HashMap::new(), text: None })),
            Err(_) => Value::Unknown,
        };
        self.declare(function.sig.ident.to_string(), value);
    }

    /// The value of a call: text where all is made of parameters, else that of the body.
    pub(super) fn called(&mut self, callable: &Callable, arguments: Vec<Value>) -> Option<Value> {
        if let (Some(Opaque { text, loops }), Some((arguments, mentioned))) =
            (&callable.text, self.opaque_list(&arguments))
        {
            let function = operand(text.clone());
            return Some(Value::Opaque(Opaque { text: quote!(#function(#arguments)), loops: loops.union(mentioned) }));
        }
        let scopes = std::mem::replace(&mut self.scopes, vec![callable.captured.clone()]);
        let value = self.applied(&callable.closure, arguments);
        self.scopes = scopes;
        value.map(Value::into_operand)
    }
}
