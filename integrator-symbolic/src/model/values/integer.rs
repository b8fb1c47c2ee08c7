//! Integers: indices, bounds, and literals that can be integers or floating-point numbers.

#[cfg(test)]
mod tests;

use crate::graph::{
    Element, NodeId,
    index::{Index, IndexId, IntegerType, LoopSet, Loops},
};
use crate::model::{
    Reader,
    parameters::{
        running_index::running_index,
        text::{bare, place},
    },
    values::value::{Opaque, Value, View},
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

/// What is known of the type of an integer.
#[derive(Clone, Copy)]
pub(crate) enum Own {
    Usize,
    /// Another type, which a cast or a literal names.
    Named(IntegerType),
    /// Literals, and indices of loops between literals: any type.
    Untyped,
    /// One that the system gives.
    Unknown,
}

impl Reader<'_> {
    /// A value as a number that may depend on coordinates.
    pub(crate) fn real(&mut self, value: &Value) -> Option<NodeId> {
        match value {
            Value::Real(node) => Some(*node),
            Value::Joint(joint) => Some(joint.number),
            Value::Opaque(Opaque { text, loops }) => {
                let parameter = self.parameter(place(text.clone()), "number", *loops);
                Some(self.graph.parameter(parameter))
            }
            _ => None,
        }
    }

    /// An operand as a number: an operator takes references as well.
    pub(crate) fn operand(&mut self, value: &Value, written: impl ToTokens) -> Option<NodeId> {
        if let Value::Opaque(Opaque { text, loops }) = value
            && let text = place(text.clone())
            && syn::parse2(text.clone()).is_ok_and(|expression| self.may_refer(&expression))
        {
            let parameter = self.parameter(text, "operand", *loops);
            return Some(self.graph.parameter(parameter));
        }
        self.number(value, written)
    }

    /// A value as an integer.
    pub(crate) fn integer(&mut self, value: &Value) -> Option<IndexId> {
        match value {
            Value::Integer(index) => Some(*index),
            Value::Opaque(Opaque { text, loops }) => {
                let parameter = self.parameter(bare(place(text.clone())), "integer", *loops);
                Some(self.graph.loops.intern(Index::Parameter(parameter)))
            }
            _ => None,
        }
    }

    /// `a.saturating_sub(b)` and `a.min(b)` of integers without a sign.
    pub(crate) fn integer_method(&mut self, name: &Ident, a: IndexId, b: IndexId) -> Option<IndexId> {
        let loops = &mut self.graph.loops;
        if [a, b].iter().any(|id| loops.is_signed(*id) || loops.cast_type(*id).is_some_and(|kind| kind.signed)) {
            return None;
        }
        match name.to_string().as_str() {
            "saturating_sub" => Some(loops.intern(Index::Monus(a, b))),
            "min" => Some(loops.intern(Index::Min(a, b))),
            _ => None,
        }
    }

    /// A value as text of parameters alone, if it is that.
    pub(crate) fn opaque(&self, value: &Value) -> Option<Opaque> {
        match value {
            Value::Opaque(opaque) => Some(opaque.clone()),
            Value::Closure(callable) => callable.text.clone(),
            Value::Integer(index) => Some(self.own_integers.get(index).cloned().unwrap_or_else(|| self.typed(*index))),
            Value::Real(node) => {
                let number = self.graph.as_constant(*node).filter(|number| number.is_finite())?;
                let literal = number_literal(number.abs());
                let text = if number.is_sign_negative() { quote!((-#literal)) } else { literal.to_token_stream() };
                Some(Opaque { text, loops: Default::default() })
            }
            Value::Tuple(parts) => {
                let parts = parts.iter().map(|part| self.opaque(part)).collect::<Option<Vec<_>>>()?;
                let loops = parts.iter().fold(LoopSet::EMPTY, |loops, part| loops.union(part.loops));
                let texts = parts.iter().map(|part| &part.text);
                Some(Opaque { text: quote!((#(#texts,)*)), loops })
            }
            _ => None,
        }
    }

    /// An integer as code of its own type; a type that only literals determine is left to rustc.
    fn typed(&self, id: IndexId) -> Opaque {
        let loops = &self.graph.loops;
        let mentioned = loops.of_index(id);
        if loops.is_untyped(id) && loops.signed_literal(id).is_none() {
            let text = self.typed_text(id, loops.type_of(id));
            let root = &self.input.root;
            return Opaque { text: quote!(#root::__private::like(&0, #text)), loops: mentioned };
        }
        Opaque { text: self.index_text(id), loops: mentioned.union(self.loops_of_types(id)) }
    }

    /// The loops that the expressions mention whose types an integer has.
    fn loops_of_types(&self, id: IndexId) -> LoopSet {
        let index = self.graph.loops.index(id);
        let own = match index {
            Index::Typed(IntegerType { like: Some(like), .. }, _) => self.types[like as usize].loops,
            _ => LoopSet::EMPTY,
        };
        let operands = index.operands().into_iter().flatten();
        operands.fold(own, |all, operand| all.union(self.loops_of_types(operand)))
    }

    /// An integer as text of the type of indices.
    pub(crate) fn place_text(&self, value: &Value) -> Option<Opaque> {
        match value {
            Value::Integer(index) if !self.own_integers.contains_key(index) || self.graph.loops.runs(*index) => {
                Some(Opaque { text: self.index_text(*index), loops: self.graph.loops.of_index(*index) })
            }
            value => self.opaque(value),
        }
    }

    /// What is known of the type of an integer.
    pub(crate) fn type_of(&self, value: &Value) -> Own {
        let Value::Integer(index) = value else {
            return match value {
                Value::Opaque(Opaque { text, .. }) if self.is_usize(text) => Own::Usize,
                _ => Own::Unknown,
            };
        };
        let loops = &self.graph.loops;
        match loops.cast_type(*index) {
            _ if loops.literal(*index).is_some() => Own::Untyped,
            _ if self.own_integers.contains_key(index) => Own::Unknown,
            Some(kind) if kind.is_usize() => Own::Usize,
            Some(kind) if kind.like.is_none() => Own::Named(kind),
            Some(_) => Own::Unknown,
            None if loops.is_untyped(*index) => Own::Untyped,
            None => Own::Usize,
        }
    }

    /// The type that an integer of the system has.
    pub(crate) fn type_like(&mut self, value: &Value) -> Option<IntegerType> {
        if let Value::Integer(index) = value
            && let Some(kind) = self.graph.loops.cast_type(*index)
        {
            return Some(kind);
        }
        let own = self.opaque(value)?;
        let text = own.text.to_string();
        let known = self.types.iter().position(|kind| kind.text.to_string() == text);
        let at = known.unwrap_or_else(|| {
            self.types.push(own);
            self.types.len() - 1
        });
        Some(IntegerType::like(at as u32))
    }

    /// An array of parameters as text.
    pub(crate) fn list_text(&self, parts: &[Value]) -> Option<Opaque> {
        let mut loops = LoopSet::EMPTY;
        let mut texts = Vec::new();
        for part in parts {
            let part_of_list = match part {
                Value::Array(parts) => self.list_text(parts)?,
                part => self.opaque(part)?,
            };
            loops = loops.union(part_of_list.loops);
            let text = part_of_list.text;
            // One number of a known type determines that of all.
            texts.push(if let Value::Real(_) = part { quote!((#text as f64)) } else { text });
        }
        (!texts.is_empty()).then(|| Opaque { text: quote!([#(#texts),*]), loops })
    }

    /// The coordinate behind a view, or the view itself if an index is missing.
    pub(crate) fn element(&mut self, view: View) -> Value {
        let rank = self.shape.as_ref().map_or(1, crate::model::Shape::rank);
        let (index, component) = match view.at[..] {
            [index] if rank == 1 => (index, None),
            [index, component] if rank == 2 => (index, Some(component)),
            [plane, row, site] if rank == 3 => {
                let sites = self.shape.as_ref().and_then(|shape| shape.inner.last()).cloned();
                let sites = sites.map(|sites| self.length(&sites));
                let loops = &mut self.graph.loops;
                sites.into_iter().for_each(|sites| loops.declare_rows(sites));
                (plane, Some(loops.intern(Index::InPlane(row, site))))
            }
            _ => return Value::View(view),
        };
        Value::Real(self.graph.coordinate(Element { part: view.part, index, component }))
    }

    /// An integer expression as the user would write it, with the types that casts gave to it.
    pub(crate) fn index_text(&self, id: IndexId) -> TokenStream {
        self.typed_text(id, self.graph.loops.cast_type(id).filter(|kind| !kind.is_usize()))
    }

    /// An integer as text of a type that holds it below zero, too, where it may be.
    pub(crate) fn signed_text(&self, id: IndexId) -> TokenStream {
        self.typed_text(id, self.graph.loops.type_of(id).filter(|kind| !kind.is_usize()))
    }

    /// Two integers that are compared as text of one type.
    pub(crate) fn compared_texts(&self, both: [IndexId; 2]) -> [TokenStream; 2] {
        let loops = &self.graph.loops;
        let named = both.into_iter().find_map(|id| loops.cast_type(id));
        let kind = named.or_else(|| both.into_iter().find_map(|id| loops.type_of(id)));
        both.map(|id| self.typed_text(id, kind.filter(|kind| !kind.is_usize())))
    }

    /// A bound of a loop as text.
    pub(crate) fn bound_text(&self, id: IndexId) -> TokenStream {
        if self.graph.loops.is_signed(id) {
            let text = self.signed_text(id);
            return quote!((#text as usize));
        }
        self.index_text(id)
    }

    /// The text of an integer in another type.
    fn in_type(&self, text: TokenStream, kind: IntegerType) -> TokenStream {
        match kind.like {
            Some(like) => {
                let (root, Opaque { text: like, .. }) = (&self.input.root, &self.types[like as usize]);
                quote!(#root::__private::like(&#like, #text))
            }
            None => {
                let kind = Ident::new(kind.name, Span::call_site());
                quote!((#text as #kind))
            }
        }
    }

    /// The receiver of a method as text: methods want a type.
    pub(crate) fn receiver_text(&self, value: &Value) -> Option<Opaque> {
        match value {
            Value::Integer(index) if self.graph.loops.is_untyped(*index) => {
                let loops = &self.graph.loops;
                Some(Opaque { text: self.typed_text(*index, loops.type_of(*index)), loops: loops.of_index(*index) })
            }
            value => self.opaque(value),
        }
    }

    /// The same, in a type other than `usize` if there is one.
    fn typed_text(&self, id: IndexId, kind: Option<IntegerType>) -> TokenStream {
        let known = self.graph.loops.index(id);
        let leaf = |text: TokenStream| match kind {
            Some(kind) => self.in_type(text, kind),
            None => text,
        };
        match (known, known.operands()) {
            (Index::Typed(kind, a) | Index::Wrapped(kind, a), _) => {
                let inner = self.typed_text(a, self.graph.loops.type_of(a).filter(|kind| !kind.is_usize()));
                let inner = if self.graph.loops.is_wrapped(id) { quote!((#inner as isize)) } else { inner };
                self.in_type(inner, kind)
            }
            (_, Some(both)) => {
                let [a, b] = both.map(|id| self.typed_text(id, kind));
                let a = if kind.is_none() { receiver(&self.graph.loops, known, both[0], a) } else { a };
                let signed = kind.is_some_and(|kind| kind.signed);
                let text = if signed { signed_operation(known, a, b) } else { operation(known, a, b) };
                quote!((#text))
            }
            (Index::Literal(value), None) => Literal::u64_unsuffixed(value).to_token_stream(),
            (Index::Running(by), None) => leaf(running_index(by).to_token_stream()),
            (Index::Length, None) => leaf(quote!(length)),
            (Index::Parameter(parameter), None) => {
                let text = &self.parameters[parameter.0 as usize].text;
                leaf(quote!((#text)))
            }
            (_, None) => TokenStream::new(),
        }
    }
}

/// An operation on integers as Rust, of operands that hold together; nothing for what is no operation.
pub(crate) fn operation(index: Index, a: TokenStream, b: TokenStream) -> TokenStream {
    match index {
        Index::Add(..) => quote!(#a + #b),
        Index::Sub(..) | Index::Minus(..) => quote!(#a - #b),
        Index::Mul(..) => quote!(#a * #b),
        Index::Div(..) => quote!(#a / #b),
        Index::Rem(..) => quote!(#a % #b),
        Index::Monus(..) => quote!(#a.saturating_sub(#b)),
        Index::Min(..) => quote!(#a.min(#b)),
        Index::Typed(kind, _) | Index::Wrapped(kind, _) => {
            let kind = Ident::new(kind.name, Span::call_site());
            quote!(#a as #kind)
        }
        // A sum, which the printer writes.
        Index::InPlane(..) => TokenStream::new(),
        Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => TokenStream::new(),
    }
}

/// The same of integers with a sign, of 64 bits.
pub(crate) fn signed_operation(index: Index, a: TokenStream, b: TokenStream) -> TokenStream {
    match index {
        Index::Monus(..) => quote!(::core::cmp::Ord::max(#a - #b, 0)),
        Index::Min(..) => quote!(::core::cmp::Ord::min(#a, #b)),
        Index::Typed(..) => a,
        Index::Wrapped(..) => {
            let wrapped = operation(index, a, b);
            quote!(#wrapped as i64)
        }
        _ => operation(index, a, b),
    }
}

/// The left operand of an operation on `usize`. Where that is a method, it has a type, which literals and indices of loops
/// between literals do not tell.
pub(crate) fn receiver(loops: &Loops, operation: Index, a: IndexId, text: TokenStream) -> TokenStream {
    match (operation, loops.literal(a)) {
        (Index::Monus(..) | Index::Min(..), Some(value)) => Literal::usize_suffixed(value as usize).to_token_stream(),
        (Index::Monus(..) | Index::Min(..), None) if loops.is_untyped(a) => quote!((#text as usize)),
        _ => text,
    }
}

/// A finite number as one would write it: with an exponent where the digits would be many.
pub(crate) fn number_literal(value: f64) -> Literal {
    if value == 0.0 || (1e-5..1e16).contains(&value) {
        return Literal::f64_unsuffixed(value);
    }
    format!("{value:e}").parse().unwrap_or_else(|_| Literal::f64_unsuffixed(value))
}
