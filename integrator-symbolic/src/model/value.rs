//! The symbolic value of a user's expression.

use super::{
    closure::Callable,
    joint::Joint,
    sequence::Sequence,
    text::{place, reference_to, referent},
};
use crate::graph::{
    NodeId, Part,
    index::{IndexId, LoopSet},
};
use proc_macro2::TokenStream;
use std::rc::Rc;

/// The meaning of an expression.
#[derive(Clone)]
pub(crate) enum Value {
    /// A number that may depend on coordinates.
    Real(NodeId),
    /// An integer made of literals, loop indices and integer parameters.
    Integer(IndexId),
    /// What holds or does not hold.
    Condition(NodeId),
    /// An argument of the function, indexed part of the way.
    View(View),
    /// An array of values.
    Array(Vec<Value>),
    /// A part of a list, `&q[1..]`.
    List(Sequence),
    /// A tuple of values.
    Tuple(Vec<Value>),
    /// What depends on parameters (and loop indices) alone, kept as the user's own expression.
    Opaque(Opaque),
    /// Arithmetic of parameters of different loops.
    Joint(Joint),
    /// A closure.
    Closure(Rc<Callable>),
    /// A variable that the present loop sums up; it has no value before the loop ends.
    Accumulating,
    /// No value.
    Unit,
    /// What a mistake was noted for already.
    Unknown,
}

/// Coordinates of one part, indexed part of the way.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct View {
    pub(crate) part: Part,
    pub(crate) at: Vec<IndexId>,
}

/// An expression of parameters alone: its text, and the loops whose indices the text mentions.
#[derive(Clone)]
pub(crate) struct Opaque {
    pub(crate) text: TokenStream,
    pub(crate) loops: LoopSet,
}

impl Value {
    /// A reference to the value, which differs from the value itself only in the code of parameters.
    pub(super) fn into_reference(self) -> Self {
        match self {
            Value::Opaque(Opaque { text, loops }) if referent(&text).is_none() => {
                Value::Opaque(Opaque { text: reference_to(&text), loops })
            }
            other => other,
        }
    }

    /// The value behind a reference.
    pub(super) fn into_place(self) -> Self {
        match self {
            Value::Opaque(Opaque { text, loops }) => Value::Opaque(Opaque { text: place(text), loops }),
            other => other,
        }
    }

    /// What it is, for a message.
    pub(crate) fn describe(&self) -> &'static str {
        match self {
            Value::Real(_) | Value::Joint(_) => "an `f64`",
            Value::Integer(_) => "an integer",
            Value::Condition(_) => "a condition",
            Value::View(view) if view.at.is_empty() => "the whole array of coordinates",
            Value::View(view) if view.at.len() > 1 => "a row",
            Value::View(_) => "a point",
            Value::Array(_) => "an array",
            Value::List(_) => "a part of a list",
            Value::Tuple(_) => "a tuple",
            Value::Opaque(_) => "a parameter",
            Value::Closure(_) => "a closure",
            Value::Accumulating => "an incomplete sum",
            Value::Unit => "nothing",
            Value::Unknown => "unknown",
        }
    }
}
