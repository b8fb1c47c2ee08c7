//! Closures in variables and nested functions: interpreted again at every call.

use crate::model::{
    Reader,
    code::assigned::Assigned,
    expressions::types::ending_in,
    parameters::text::{identifiers, operand},
    values::value::{Callable, Opaque, Scope, Value},
};
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};
use std::{collections::HashMap, rc::Rc};
use syn::{Expr, ExprClosure, ItemFn, parse_quote, visit::Visit};

impl Reader<'_> {
    /// A closure with a number of arguments, or a function by its path, as the closure that calls it.
    pub(crate) fn closure(&mut self, expression: &Expr, arguments: usize) -> Option<Rc<ExprClosure>> {
        match expression {
            Expr::Closure(closure) => Some(Rc::new(closure.clone())),
            Expr::Paren(inner) => self.closure(&inner.expr, arguments),
            Expr::Path(function) => {
                let names: Vec<_> = (0..arguments).map(|number| format_ident!("__argument_{number}")).collect();
                Some(Rc::new(parse_quote!(|#(#names),*| #function(#(#names),*))))
            }
            other => {
                let message = "expected a closure or the path of a function\nhelp: write `|x| ...` or `f64::sin`";
                self.errors.at(other, message);
                None
            }
        }
    }

    /// The value of a closure for given arguments.
    pub(crate) fn applied(&mut self, closure: &ExprClosure, arguments: Vec<Value>) -> Option<Value> {
        if closure.inputs.len() != arguments.len() {
            self.errors.at(closure, format!("this closure has to take {} arguments", arguments.len()));
            return None;
        }
        self.scopes.push(HashMap::new());
        for (pattern, argument) in closure.inputs.iter().zip(arguments) {
            self.bind(pattern, argument);
        }
        let value = match &*closure.body {
            Expr::Block(body) if body.label.is_none() => self.returned(&ending_in(&body.block, &closure.output)),
            body => self.expression(body),
        };
        self.scopes.pop();
        value.map(|value| self.of_output(value, &closure.output))
    }

    /// A closure as a value.
    pub(crate) fn captured(&mut self, closure: &ExprClosure) -> Option<Value> {
        let expression = Expr::Closure(closure.clone());
        let mut assigned = Assigned::default();
        assigned.visit_expr(&closure.body);
        if let Some(name) = assigned.names.iter().find(|name| self.lookup(name).is_some()) {
            let message = format!(
                "this closure assigns to `{name}`, which is declared outside of it\nhelp: return the value \
                         from the closure, and assign it outside"
            );
            self.errors.at(closure, message);
            return None;
        }
        let text = match self.verbatim(&expression) {
            Some(Value::Opaque(text)) => Some(text),
            _ => None,
        };
        let captured = self.captured_by(closure.body.to_token_stream());
        Some(Value::Closure(Rc::new(Callable { closure: closure.clone(), captured, text })))
    }

    /// The variables that a text mentions, as they are now.
    pub(crate) fn captured_by(&mut self, text: TokenStream) -> Scope {
        let mut names = Vec::new();
        identifiers(text, &mut names);
        let known = names.into_iter().filter_map(|name| Some((name.to_string(), self.lookup(&name.to_string())?)));
        let known: Vec<_> = known.collect();
        known.into_iter().map(|(name, id)| (name, self.copied(id))).collect()
    }

    /// What `read` gives where no other variables are seen.
    pub(crate) fn seeing<T>(&mut self, variables: &Scope, read: impl FnOnce(&mut Self) -> T) -> T {
        let scopes = std::mem::replace(&mut self.scopes, vec![variables.clone()]);
        let value = read(self);
        self.scopes = scopes;
        value
    }

    /// A function inside of the function, which sees no variables.
    pub(crate) fn inner_function(&mut self, function: &ItemFn) {
        let (inputs, output, block) = (&function.sig.inputs, &function.sig.output, &function.block);
        let value = match syn::parse2(quote!(|#inputs| #output #block)) {
            Ok(closure) => Value::Closure(Rc::new(Callable { closure, captured: HashMap::new(), text: None })),
            Err(_) => Value::Unknown,
        };
        self.declare(function.sig.ident.to_string(), value);
    }

    /// The value of a call: text where all is made of parameters, else that of the body.
    pub(crate) fn called<'e>(
        &mut self,
        callable: &Callable,
        arguments: Vec<Value>,
        places: impl IntoIterator<Item = &'e Expr>,
    ) -> Option<Value> {
        if let (Some(Opaque { text, loops }), Some((arguments, mentioned))) =
            (&callable.text, self.opaque_list(&arguments, places))
        {
            let function = operand(text.clone());
            return Some(Value::Opaque(Opaque { text: quote!(#function(#arguments)), loops: loops.union(mentioned) }));
        }
        let value = self.seeing(&callable.captured, |reader| reader.applied(&callable.closure, arguments));
        value.map(Value::into_operand)
    }
}
