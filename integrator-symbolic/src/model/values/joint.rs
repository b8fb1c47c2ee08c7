//! Arithmetic of parameters of different loops, `self.a[i] * self.b[j]`. The macro does not know types. The context
//! determines whether the operands are numbers, which have a table for each loop, or integers, which remain the user's
//! own expression.

use crate::graph::{NodeId, index::LoopSet};
use crate::model::{
    Reader,
    code::shape::integer_type,
    parameters::text::{in_parentheses, operand},
    values::value::{Joint, Opaque, Value},
};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::{Expr, ExprMethodCall, Type};

/// Methods that numbers and integers have, with a result of their own type.
const OF_BOTH: [&str; 6] = ["abs", "clamp", "max", "min", "rem_euclid", "signum"];

impl Value {
    /// The same value where no number is requested: arithmetic of different loops as the user's own expression.
    pub(crate) fn into_own(self) -> Self {
        match self {
            Value::Joint(Joint { own, .. }) => Value::Opaque(own),
            Value::Tuple(parts) => Value::Tuple(parts.into_iter().map(Value::into_own).collect()),
            other => other,
        }
    }

    /// The same value in a place that has a type.
    pub(crate) fn where_typed(self, kind: &Type) -> Self {
        match self {
            Value::Joint(Joint { own, .. }) if integer_type(kind).is_some() => Value::Opaque(own),
            Value::Joint(Joint { number, .. }) if crate::model::code::shape::is_f64(kind) => Value::Real(number),
            other => other,
        }
    }

    /// The same value with its own expression in parentheses.
    pub(crate) fn in_parentheses(self) -> Self {
        self.with_own_text(in_parentheses)
    }

    /// The same value, whose text stands for one operand wherever it is put.
    pub(crate) fn into_operand(self) -> Self {
        self.with_own_text(operand)
    }

    fn with_own_text(self, change: impl Fn(TokenStream) -> TokenStream) -> Self {
        let changed = |Opaque { text, loops }| Opaque { text: change(text), loops };
        match self {
            Value::Opaque(own) => Value::Opaque(changed(own)),
            Value::Joint(Joint { number, own }) => Value::Joint(Joint { number, own: changed(own) }),
            other => other,
        }
    }
}

impl Reader<'_> {
    /// The two sides of an operator. An integer beside arithmetic of different loops shows that it is one of integers;
    /// what is compared with parameters has the type of these.
    pub(crate) fn sides(left: Value, right: Value, is_arithmetic: bool) -> [Value; 2] {
        let is_joint = |value: &Value| matches!(value, Value::Joint(_));
        let decides = |value: &Value| match value {
            Value::Integer(_) => true,
            Value::Opaque(_) | Value::Joint(_) => !is_arithmetic,
            _ => false,
        };
        if is_joint(&left) && decides(&right) || is_joint(&right) && decides(&left) {
            return [left.into_own(), right.into_own()];
        }
        [left, right]
    }

    /// Parameters as text, also those of different loops.
    pub(crate) fn own_of(&self, value: &Value) -> Option<Opaque> {
        match value {
            Value::Joint(Joint { own, .. }) => Some(own.clone()),
            value => self.opaque(value),
        }
    }

    /// A number that is made of parameters, with their own expression if there is one.
    pub(crate) fn joint(number: NodeId, own: Option<Opaque>) -> Value {
        match own {
            Some(own) => Value::Joint(Joint { number, own }),
            None => Value::Real(number),
        }
    }

    /// The choice between two parameters by a condition of parameters, as an expression.
    pub(crate) fn own_choice(&self, condition: NodeId, first: &Value, second: &Value) -> Option<Opaque> {
        if [first, second].iter().any(|value| matches!(value, Value::Real(_))) {
            return None;
        }
        let (a, b) = (self.own_of(first)?, self.own_of(second)?);
        let Opaque { text, loops } = self.condition_text(condition)?;
        let (loops, a, b) = (loops.union(a.loops).union(b.loops), a.text, b.text);
        Some(Opaque { text: quote!((if #text { #a } else { #b })), loops })
    }

    /// A method of arithmetic of different loops, or of a parameter with such an argument: `None` where it has to be one of
    /// numbers.
    pub(crate) fn joint_method(
        &mut self,
        call: &ExprMethodCall,
        receiver: &Value,
        arguments: &[Value],
        is_elementary: bool,
    ) -> Option<Option<Value>> {
        let values = || std::iter::once(receiver).chain(arguments);
        if !values().any(|value| matches!(value, Value::Joint(_))) || matches!(receiver, Value::Real(_)) {
            return None;
        }
        let own = self.own_method(call, receiver, arguments)?;
        let is_of_both = OF_BOTH.contains(&call.method.to_string().as_str());
        let is_of_integers = arguments.iter().any(|value| matches!(value, Value::Integer(_)));
        let is_of_numbers = arguments.iter().any(|value| matches!(value, Value::Real(_)));
        if !is_elementary || is_of_both && is_of_integers {
            return Some(Some(Value::Opaque(own)));
        }
        if !is_of_both || is_of_numbers {
            return None;
        }
        let places: Vec<&Expr> = call.args.iter().collect();
        let number = self.elementary(&call.method, receiver.clone(), &call.receiver, arguments.to_vec(), &places);
        Some(number.and_then(|number| self.real(&number)).map(|number| Self::joint(number, Some(own))))
    }

    /// A call of a method as the user's own expression.
    fn own_method(&self, call: &ExprMethodCall, receiver: &Value, arguments: &[Value]) -> Option<Opaque> {
        let object = self.own_of(receiver)?;
        let (arguments, loops) = self.own_list(arguments, call.args.iter())?;
        let (text, name): (_, &Ident) = (operand(object.text), &call.method);
        let turbofish = call.turbofish.as_ref().map(ToTokens::to_token_stream);
        Some(Opaque { text: quote!(#text.#name #turbofish(#arguments)), loops: loops.union(object.loops) })
    }

    /// Arguments as text, if all of them are made of parameters.
    pub(crate) fn own_list<'e>(
        &self,
        arguments: &[Value],
        places: impl IntoIterator<Item = &'e Expr>,
    ) -> Option<(TokenStream, LoopSet)> {
        let arguments: Vec<Value> = arguments.iter().cloned().map(Value::into_own).collect();
        self.opaque_list(&arguments, places)
    }
}
