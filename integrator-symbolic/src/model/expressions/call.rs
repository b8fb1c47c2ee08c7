//! Calls: resolution of the function, helper methods of the impl, and functions of parameters only.

use crate::model::{
    Reader,
    code::{assigned::simple_name, index_method::is_index, shape::typed_arguments},
    control::early_return::where_there,
    expressions::{
        cure::{in_rust, is_elsewhere, no_function},
        elementary::{OR_STATE, is_elementary, takes},
        types::ending_in,
    },
    loops::{
        sequence::{ADAPTED, is_adaptor},
        total::is_total,
    },
    parameters::text::{is_reference, operand, place, reference_to},
    values::value::{Callable, Opaque, Value, is_list},
};
use crate::{
    errors::quoted,
    graph::index::{Index, LoopSet},
};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use std::{collections::HashMap, rc::Rc};
use syn::{Expr, ExprCall, ExprLet, ExprMethodCall, ImplItemFn, Pat, parse_quote, parse_quote_spanned};

impl Reader<'_> {
    /// `receiver.name(arguments)`
    pub(crate) fn method(&mut self, call: &ExprMethodCall) -> Option<Value> {
        if is_total(call) || is_adaptor(call) {
            // Parameters alone are summed once per run, by the user's own expression.
            let whole = Expr::MethodCall(call.clone());
            if let Some(value) = self.verbatim(&whole) {
                return Some(value);
            }
            if is_total(call) {
                return self.total(call);
            }
            if is_map_of_array(call) {
                return self.collected(&whole);
            }
            self.errors.at(
                &call.method,
                format!("`{}` returns a sequence, not a number\nhelp: end it with `.sum::<f64>()`", call.method),
            );
            return None;
        }
        if let Some(element) = end_of_list(call).or_else(|| where_some(call).filter(|branch| self.may_be_none(branch)))
            && self.verbatim(&Expr::MethodCall(call.clone())).is_none()
        {
            return self.expression(&element);
        }
        if let Expr::MethodCall(inner) = &*call.receiver
            && is_adaptor(inner)
        {
            let value = self.verbatim(&Expr::MethodCall(call.clone()));
            if value.is_none() && call.method == "collect" {
                return self.collected(&call.receiver);
            }
            if value.is_none() {
                let message = format!(
                    "`{}` of a sequence is not supported\nnote: the supported adaptors are {ADAPTED}, followed by \
                     `sum` or `fold`",
                    call.method
                );
                self.errors.at(&call.method, message);
            }
            return value;
        }
        if let Some(variable) = self.changeable(&call.receiver)
            && !is_harmless(&call.method)
        {
            let cure = match call.method.to_string().as_str() {
                "push" => "write the list as one expression, `let list: Vec<f64> = q.iter().map(|x| ...).collect();`",
                _ => "compute the value in one expression, or in a method of this impl that takes no coordinates",
            };
            let message = format!(
                "`{}` may modify `{variable}`, which is not supported\nhelp: {cure}\nnote: the macro follows \
                         only assignments",
                call.method
            );
            self.errors.at(&call.method, message);
            return None;
        }
        let is_self = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        let receiver = self.expression(&call.receiver);
        let helper = self.input.function(&call.method.to_string()).filter(|_| is_self);
        let arguments = self.arguments(&call.args, helper);
        let (receiver, arguments) = (receiver?, arguments?);
        if let (Value::Integer(a), [Value::Integer(b)]) = (&receiver, &arguments[..])
            && let Some(index) = self.integer_method(&call.method, *a, *b)
        {
            return Some(Value::Integer(index));
        }
        let turbofish = call.turbofish.as_ref().map(ToTokens::to_token_stream);
        let name = &call.method;
        let is_of_loops = |value: &Value| match value {
            Value::Integer(index) => !self.graph.loops.of_index(*index).is_empty(),
            _ => false,
        };
        // As an index of coordinates its form matters: `y * self.width + x` is a site of a plane.
        if helper.is_some_and(is_index) && arguments.iter().any(is_of_loops) {
            return self.helper(name, arguments, &call.args.iter().collect::<Vec<_>>());
        }
        if let Some(object) = self.receiver_text(&receiver)
            && !matches!(receiver, Value::Real(_))
            && !(is_self && self.helper_reads_sensitive(name))
            && let Some((text, loops)) = self.opaque_list(&arguments, &call.args)
        {
            let object_text = place(object.text);
            let text = quote!(#object_text.#name #turbofish(#text));
            return Some(Value::Opaque(Opaque { text, loops: loops.union(object.loops) }));
        }
        if !is_self
            && let Some(value) = self.joint_method(call, &receiver, &arguments, is_elementary(&name.to_string()))
        {
            return value;
        }
        let places: Vec<&Expr> = call.args.iter().collect();
        if name == "len" && places.is_empty() {
            return match &receiver {
                Value::View(view) => self.extent(view.at.len(), &call.receiver).map(Value::Integer),
                Value::Array(parts) => {
                    Some(Value::Integer(self.graph.loops.intern(Index::Literal(parts.len() as u64))))
                }
                Value::List(part) => Some(Value::Integer(self.count_of(part))),
                other => {
                    self.errors.at(name, format!("{} has no length", other.describe()));
                    None
                }
            };
        }
        if is_self {
            return self.helper(name, arguments, &places);
        }
        if places.is_empty()
            && matches!(name.to_string().as_str(), "to_vec" | "to_owned" | "as_slice")
            && matches!(receiver, Value::View(_) | Value::Array(_) | Value::List(_))
        {
            return Some(receiver);
        }
        self.elementary(name, receiver, &call.receiver, arguments, &places)
    }

    /// Whether the value that a branch matches is known to be there or not: one of the system, or coordinates by an index.
    fn may_be_none(&mut self, branch: &Expr) -> bool {
        let Expr::If(branch) = branch else { return false };
        let Expr::Let(ExprLet { pat, expr, .. }) = &*branch.cond else { return false };
        self.verbatim(expr).is_some() || where_there(pat, expr, branch).is_some()
    }

    /// `function(arguments)`
    pub(crate) fn call(&mut self, call: &ExprCall) -> Option<Value> {
        let helper = match &*call.func {
            Expr::Path(path) if path.path.segments.first().is_some_and(|first| first.ident == "Self") => {
                path.path.segments.last().and_then(|last| self.input.function(&last.ident.to_string()))
            }
            _ => None,
        };
        let mut arguments = self.arguments(&call.args, helper)?;
        if let Some(callable) = self.callable(&call.func) {
            let callable = callable?;
            return self.called(&callable, arguments, &call.args);
        }
        if matches!(&*call.func, Expr::Lit(_))
            || (!matches!(&*call.func, Expr::Path(_)) && self.verbatim(&call.func).is_none())
        {
            let value = self.expression(&call.func)?;
            if let Some(message) = no_function("this", &value, call) {
                self.errors.at(&call.func, message);
                return None;
            }
        }
        let mut function = call.func.to_token_stream();
        if let Some(name) = simple_name(&call.func)
            && let Some(id) = self.lookup(&name.to_string())
        {
            match (&self.bindings[id.0].value, self.opaque_list(&arguments, &call.args)) {
                (Value::Unknown, _) => return None,
                (Value::Opaque(Opaque { text, .. }), Some(_)) => function = operand(text.clone()),
                (value, _) => {
                    let message = no_function(&format!("`{name}`"), value, call).unwrap_or_else(|| {
                        format!(
                            "the definition of `{name}` is not visible to the macro\nhelp: write a helper method of \
                             this impl, `fn {name}(&self, x: f64) -> f64`"
                        )
                    });
                    self.errors.at(name, message);
                    // One mistake, one message, however often it is called.
                    self.bindings[id.0].value = Value::Unknown;
                    return None;
                }
            }
        }
        let mut places: Vec<&Expr> = call.args.iter().collect();
        let segments: Vec<&Ident> = match &*call.func {
            Expr::Path(path) if path.qself.is_none() => path.path.segments.iter().map(|part| &part.ident).collect(),
            _ => Vec::new(),
        };
        if let ([kind, name], [value]) = (&segments[..], &arguments[..])
            && *kind == "f64"
            && *name == "from"
        {
            let value = self.of_own_type(value.clone().into_own());
            let number = match value {
                Value::Integer(index) => Some(self.graph.number_of(index)),
                Value::Condition(condition) => Some(self.truth_as_number(condition)),
                Value::Real(number) => Some(number),
                _ => None,
            };
            if let Some(number) = number {
                return Some(Value::Real(number));
            }
            arguments = vec![value];
        }
        // A function of literals that is seen here is a number that is known here.
        let literals = !arguments.is_empty() && arguments.iter().all(|value| matches!(value, Value::Real(_)));
        let is_seen = matches!(segments[..], [.., kind, _] if kind == "f64") || helper.is_some();
        if !(literals && is_seen)
            && let Some((text, loops)) = self.opaque_list(&arguments, &call.args)
        {
            return Some(Value::Opaque(Opaque { text: quote!(#function(#text)), loops }));
        }
        if !is_seen && let Some((text, loops)) = self.own_list(&arguments, &call.args) {
            return Some(Value::Opaque(Opaque { text: quote!(#function(#text)), loops }));
        }
        match segments[..] {
            [.., kind, name] if kind == "f64" && !places.is_empty() => {
                let receiver = arguments.remove(0);
                let place = places.remove(0);
                self.elementary(name, receiver, place, arguments, &places)
            }
            [kind, name] if kind == "Self" => {
                let takes_self =
                    self.input.function(&name.to_string()).is_some_and(|helper| helper.sig.receiver().is_some());
                if takes_self && !arguments.is_empty() {
                    arguments.remove(0);
                    places.remove(0);
                }
                self.helper(name, arguments, &places)
            }
            [] => {
                let message = "only named functions can be called with coordinates\nhelp: write a helper method of \
                               this impl";
                self.errors.at(&call.func, message);
                None
            }
            [.., last] if last == "from_fn" => {
                let message = "the length of this array is not known\nhelp: declare a variable with its type, `let d: \
                               [f64; 3] = std::array::from_fn(|k| ...);`";
                self.errors.at(&call.func, message);
                None
            }
            _ => {
                let is_list = arguments.first().is_some_and(is_list);
                if let [.., name] = segments[..]
                    && is_elsewhere(&segments)
                    && let Some(cure) = in_rust(&name.to_string(), &places, is_list)
                {
                    let named = quoted(&function);
                    self.errors.at(&call.func, format!("Rust has no function `{named}`\nhelp: write `{cure}`"));
                    return None;
                }
                let (name, last) = (quoted(&function), segments.last());
                let last = last.map_or_else(|| name.clone(), ToString::to_string);
                let cure = format!("move the function into this impl and call `Self::{last}`, {OR_STATE}");
                self.outside(&call.func, &name, &cure);
                None
            }
        }
    }

    /// The closure that is called, if it is one; `None` inside if a mistake was noted in it.
    fn callable(&mut self, function: &Expr) -> Option<Option<Rc<Callable>>> {
        let value = match function {
            Expr::Paren(inner) => return self.callable(&inner.expr),
            Expr::Closure(closure) => self.captured(closure),
            _ => {
                let id = self.lookup(&simple_name(function)?.to_string())?;
                Some(self.bindings[id.0].value.clone())
            }
        };
        match value {
            Some(Value::Closure(callable)) => Some(Some(callable)),
            Some(_) => None,
            None => Some(None),
        }
    }

    /// The name of the variable that a receiver is, if it is declared with `mut` and holds values of the system.
    fn changeable<'e>(&self, receiver: &'e Expr) -> Option<&'e Ident> {
        let name = simple_name(receiver)?;
        let binding = &self.bindings[self.lookup(&name.to_string())?.0];
        (binding.mutable && matches!(binding.value, Value::Opaque(_))).then_some(name)
    }

    /// The values of arguments, whose types a method of the impl declares.
    fn arguments<'e>(
        &mut self,
        arguments: impl IntoIterator<Item = &'e Expr>,
        helper: Option<&ImplItemFn>,
    ) -> Option<Vec<Value>> {
        let helper = helper.filter(|helper| !is_generic(helper));
        let mut kinds = helper.into_iter().flat_map(typed_arguments).map(|parameter| &*parameter.ty);
        let values = arguments.into_iter().map(|argument| match kinds.next() {
            Some(kind) => self.expression_of(argument, kind).map(|value| value.where_typed(kind)),
            None => self.expression(argument),
        });
        let values: Vec<_> = values.collect();
        values.into_iter().collect()
    }

    /// Arguments as text, if all of them are parameters.
    pub(crate) fn opaque_list<'e>(
        &self,
        arguments: &[Value],
        places: impl IntoIterator<Item = &'e Expr>,
    ) -> Option<(TokenStream, LoopSet)> {
        let texts = arguments.iter().zip(places).map(|(value, place)| self.argument(value, place));
        let texts: Vec<Opaque> = texts.collect::<Option<_>>()?;
        let loops = texts.iter().fold(LoopSet::EMPTY, |loops, opaque| loops.union(opaque.loops));
        let texts = texts.iter().map(|opaque| &opaque.text);
        Some((quote!(#(#texts),*), loops))
    }

    /// The text of an argument, if it is a parameter. That of a parameter shows whether it is a reference; of integers
    /// and numbers their place does.
    pub(crate) fn argument(&self, value: &Value, place: &Expr) -> Option<Opaque> {
        let Opaque { text, loops } = self.opaque(value)?;
        let is_reference = !matches!(value, Value::Opaque(_)) && is_reference(place);
        Some(Opaque { text: if is_reference { reference_to(&text) } else { text }, loops })
    }

    /// Notes that a function of coordinates is not in this impl.
    pub(crate) fn outside(&mut self, place: impl ToTokens, name: &str, cure: &str) {
        let message = format!(
            "no derivative of `{name}` is known\nhelp: {cure}\nnote: the macro sees only the functions of this impl"
        );
        self.errors.at(place, message);
    }

    /// A helper method of the impl, inlined.
    fn helper(&mut self, name: &Ident, arguments: Vec<Value>, places: &[&Expr]) -> Option<Value> {
        let input = self.input;
        let Some(helper) = input.function(&name.to_string()) else {
            let cure = format!("move the function into this impl, {OR_STATE}");
            self.outside(name, &name.to_string(), &cure);
            return None;
        };
        if crate::model::code::attributes::attribute(helper).is_some() {
            return self.external(helper, arguments, places);
        }
        if self.inlining.iter().any(|known| name == known) {
            self.errors.at(name, format!("`{name}` calls itself, and recursion is not supported\nhelp: write a loop"));
            return None;
        }
        let parameters: Vec<_> = typed_arguments(helper).collect();
        if parameters.len() != arguments.len() {
            self.errors.at(name, takes(&name.to_string(), parameters.len(), arguments.len()));
            return None;
        }
        for (argument, place) in arguments.iter().zip(places) {
            if let Value::Accumulating = argument {
                self.number(argument, place)?;
            }
        }
        let scopes = std::mem::replace(&mut self.scopes, vec![HashMap::new()]);
        let is_generic = is_generic(helper);
        for (parameter, argument) in parameters.into_iter().zip(arguments) {
            let argument = if is_generic { argument } else { self.of_type(argument, &parameter.ty) };
            self.bind(&parameter.pat, argument);
        }
        self.inlining.push(name.to_string());
        let value = match is_generic {
            true => self.returned(&helper.block),
            false => self.returned(&ending_in(&helper.block, &helper.sig.output)),
        };
        self.inlining.pop();
        self.scopes = scopes;
        let value = if is_generic { value } else { value.map(|value| self.of_output(value, &helper.sig.output)) };
        value.map(Value::into_operand)
    }
}

/// Whether a method has parameters of its own, which mean nothing outside of it.
fn is_generic(helper: &ImplItemFn) -> bool {
    !helper.sig.generics.params.is_empty()
}

/// Whether a call is `array.map(...)`, an array, and not `array.iter().map(...)`, a sequence.
fn is_map_of_array(call: &ExprMethodCall) -> bool {
    call.method == "map" && matches!(&*call.receiver, Expr::Path(_) | Expr::Array(_) | Expr::Index(_))
}

/// `list.first().unwrap()` and `list.last().unwrap()` as elements, `list.split_at(n)` and its like as parts: a list with too
/// few is a panic either way.
fn end_of_list(call: &ExprMethodCall) -> Option<Expr> {
    let is_one_of = |call: &ExprMethodCall, names: [&str; 2]| names.iter().any(|name| call.method == name);
    let receiver = |call: &ExprMethodCall| match &*call.receiver {
        Expr::MethodCall(inner) => Some(inner.clone()),
        _ => None,
    };
    if call.method == "split_at" && call.args.len() == 1 {
        let (list, at, span) = (&call.receiver, &call.args[0], call.method.span());
        return Some(parse_quote_spanned!(span=> { let (list, at) = (&#list, #at); (&list[..at], &list[at..]) }));
    }
    let mut end = receiver(call).filter(|_| is_one_of(call, ["unwrap", "expect"]))?;
    while is_one_of(&end, ["copied", "cloned"]) {
        end = receiver(&end)?;
    }
    let (list, at) = (&end.receiver, end.method.span());
    match end.method.to_string().as_str() {
        _ if !end.args.is_empty() || matches!(&**list, Expr::MethodCall(call) if is_adaptor(call)) => None,
        "first" => Some(parse_quote_spanned!(at=> #list[0])),
        "last" => Some(parse_quote_spanned!(at=> { let list = &#list; list[list.len() - 1] })),
        "split_first" => Some(parse_quote_spanned!(at=> { let list = &#list; (&list[0], &list[1..]) })),
        "split_last" => Some(parse_quote_spanned!(at=> {
            let list = &#list;
            (&list[list.len() - 1], &list[..list.len() - 1])
        })),
        _ => None,
    }
}

/// `value.map_or(otherwise, |x| ...)`, `value.map(|x| ...).unwrap_or(otherwise)` and `value.unwrap_or(otherwise)` as the branch
/// that they are.
fn where_some(call: &ExprMethodCall) -> Option<Expr> {
    let mapped = |inner: &Expr| match inner {
        Expr::MethodCall(inner)
            if inner.method == "map" && matches!(inner.args.first(), Some(Expr::Closure(_) | Expr::Path(_))) =>
        {
            Some(((*inner.receiver).clone(), inner.args.first().cloned()))
        }
        _ => None,
    };
    let arguments: Vec<&Expr> = call.args.iter().collect();
    let ((value, change), otherwise) = match (call.method.to_string().as_str(), &arguments[..]) {
        ("map_or", [otherwise, change]) => (((*call.receiver).clone(), Some((*change).clone())), (*otherwise).clone()),
        ("map_or_else", [Expr::Closure(otherwise), change]) if otherwise.inputs.is_empty() => {
            (((*call.receiver).clone(), Some((*change).clone())), (*otherwise.body).clone())
        }
        ("unwrap_or", [otherwise]) => {
            (mapped(&call.receiver).unwrap_or(((*call.receiver).clone(), None)), (*otherwise).clone())
        }
        ("unwrap_or_default", []) => (mapped(&call.receiver)?, parse_quote!(0.0)),
        _ => return None,
    };
    let at = call.method.span();
    let only_input = match &change {
        Some(Expr::Closure(closure)) if closure.inputs.len() == 1 => closure.inputs.first(),
        _ => None,
    };
    let item = match only_input {
        Some(Pat::Ident(name)) => name.ident.clone(),
        _ => Ident::new("__item", at),
    };
    let found: Expr = match change {
        Some(Expr::Path(function)) => parse_quote_spanned!(at=> #function(#item)),
        Some(closure) => parse_quote_spanned!(at=> (#closure)(#item)),
        None => parse_quote_spanned!(at=> #item),
    };
    Some(parse_quote_spanned!(at=> if let Some(#item) = #value { #found } else { #otherwise }))
}

/// Whether a method leaves its receiver unchanged: those of numbers do, and those that only read a list.
fn is_harmless(method: &Ident) -> bool {
    const LOOKS: [&str; 9] = ["len", "is_empty", "iter", "get", "first", "last", "contains", "max", "min"];
    let name = method.to_string();
    is_elementary(&name) || LOOKS.contains(&name.as_str())
}
