//! The symbolic value of a user's expression.

use crate::graph::{
    NodeId, Part,
    index::{IndexId, LoopSet},
};
use crate::model::{
    BindingId, Reader,
    parameters::text::{place, reference_to, referent},
};
use proc_macro2::TokenStream;
use std::{collections::HashMap, rc::Rc};
use syn::ExprClosure;

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
    pub(crate) fn into_reference(self) -> Self {
        match self {
            Value::Opaque(Opaque { text, loops }) if referent(&text).is_none() => {
                Value::Opaque(Opaque { text: reference_to(&text), loops })
            }
            other => other,
        }
    }

    /// The value behind a reference.
    pub(crate) fn into_place(self) -> Self {
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

/// A sequence with one item for every index in `from..to`.
#[derive(Clone)]
pub(crate) struct Sequence {
    pub(crate) from: IndexId,
    pub(crate) to: IndexId,
    pub(crate) at: Rc<ItemAt>,
    /// Whether a filter may leave items out, so that an item's position is not known.
    pub(crate) filtered: bool,
    /// Whether its items are an array's, which has elements for literal indices alone.
    pub(crate) literal: bool,
}

/// Reads the item for an index.
pub(crate) type ItemAt = dyn Fn(&mut Reader<'_>, IndexId) -> Option<Item>;

/// An item, and the condition under which a filter lets it through.
pub(crate) struct Item {
    pub(crate) value: Value,
    pub(crate) condition: Option<NodeId>,
}

impl Item {
    pub(crate) fn plain(value: Value) -> Self {
        Self { value, condition: None }
    }
}

/// Arithmetic of parameters of different loops.
#[derive(Clone)]
pub(crate) struct Joint {
    /// Its value, if the parameters are numbers.
    pub(crate) number: NodeId,
    /// The user's own expression, whose type rustc decides.
    pub(crate) own: Opaque,
}

/// Variables by their names.
pub(crate) type Scope = HashMap<String, BindingId>;

/// What is called with values.
pub(crate) struct Callable {
    pub(crate) closure: ExprClosure,
    /// The variables that it sees, as they were where it was written.
    pub(crate) captured: Scope,
    /// Itself as text, where it reads parameters alone.
    pub(crate) text: Option<Opaque>,
}

/// Whether a value is a list of others.
pub(crate) fn is_list(value: &Value) -> bool {
    matches!(value, Value::View(_) | Value::Array(_) | Value::List(_))
}
