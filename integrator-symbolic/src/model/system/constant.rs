//! Constants of the impl with values known to the macro, such as lengths of arrays: `const N: usize = 6;` and
//! `Self::N`.

use crate::graph::index::{Index, IndexId};
use crate::model::{
    Reader, Target,
    loops::sequence::FEW,
    values::value::{Sequence, Value},
};
use proc_macro2::Ident;
use quote::ToTokens;
use std::ops::Range;
use syn::{BinOp, Expr, ExprBinary, ExprLit, ExprPath, ImplItem, Lit};

/// How many elements an array may have that such a constant gives its length.
const MANY: u64 = 1024;

/// How many constants may stand in each other.
const DEEPEST: u32 = 16;

impl Reader<'_> {
    /// The value of an integer that is made of literals and of constants of the impl.
    pub(crate) fn known(&mut self, id: IndexId) -> Option<u64> {
        let index = self.graph.loops.index(id);
        match (index, index.operands()) {
            (Index::Literal(value), _) => Some(value),
            (Index::Parameter(parameter), _) => {
                let text = self.parameters[parameter.0 as usize].own.clone();
                self.constant_value(&syn::parse2(text).ok()?, DEEPEST)
            }
            (_, Some([a, b])) => {
                let (a, b) = (self.known(a)?, self.known(b)?);
                let [a, b] = [a, b].map(|value| self.literal_index(value));
                let folded = self.graph.loops.intern(index.with_operands([a, b]));
                self.graph.loops.literal(folded)
            }
            _ => None,
        }
    }

    /// The iterations of a loop whose bounds are made of constants of the impl, if they are few.
    pub(crate) fn iterations_by_constants(&mut self, sequence: &Sequence) -> Option<Range<u64>> {
        let (from, to) = (self.known(sequence.from)?, self.known(sequence.to)?);
        (to.saturating_sub(from) <= FEW).then_some(from..to)
    }

    /// Where a list of values has a length that is known, as `[0.0; Self::N]` has, its elements one by one, so that each is
    /// assigned by itself.
    pub(crate) fn list_as_array(&mut self, target: &Target) {
        let Some(Value::List(list)) = self.element_of(target).cloned() else { return };
        let count = self.count_of(&list);
        let Some(count) = self.known(count).filter(|count| *count <= MANY) else { return };
        let parts = (0..count).map(|position| {
            let position = self.literal_index(position);
            self.nth(&list, position)
        });
        if let Some(parts) = parts.collect::<Option<Vec<_>>>()
            && let Some(value) = self.element_of_mut(target)
        {
            *value = Value::Array(parts);
        }
    }

    /// What to say of a list whose length is a constant that is not seen here.
    pub(crate) fn unseen_length(&mut self, list: &Sequence) -> Option<String> {
        let count = self.count_of(list);
        self.unseen_constant(count).map(|name| {
            format!(
                "the length `{name}` of this array is not known\nhelp: declare `const {name}: usize = 6;` in this \
                 function, or in this impl and write `Self::{name}`\nnote: the macro sees only this impl"
            )
        })
    }

    /// What to add to a message about the innermost loop, where it would be written out if its bound were seen here.
    pub(crate) fn unseen_bound(&self) -> String {
        self.frames.last().map_or_else(String::new, |frame| self.unseen(self.graph.loops.get(frame.by).to))
    }

    /// The same about a loop that ends there.
    pub(crate) fn unseen(&self, end: IndexId) -> String {
        self.unseen_constant(end).map_or_else(String::new, |name| {
            format!(
                "\nhelp: declare `const {name}: usize = 6;` in this function, or in this impl and write \
                 `Self::{name}`\nnote: the macro sees only this impl, where the value of `{name}` is not declared"
            )
        })
    }

    /// The name of the constant in an integer that is not seen here.
    fn unseen_constant(&self, id: IndexId) -> Option<Ident> {
        let index = self.graph.loops.index(id);
        let Index::Parameter(parameter) = index else {
            return index.operands()?.into_iter().find_map(|operand| self.unseen_constant(operand));
        };
        let text = self.parameters[parameter.0 as usize].own.clone();
        let Ok(Expr::Path(ExprPath { path, qself: None, .. })) = syn::parse2(text) else { return None };
        let name = &path.segments.last()?.ident;
        name.to_string().starts_with(char::is_uppercase).then(|| name.clone())
    }

    /// The value of an expression of literals and of constants of the impl.
    fn constant_value(&self, expression: &Expr, depth: u32) -> Option<u64> {
        let depth = depth.checked_sub(1)?;
        match expression {
            Expr::Paren(inner) => self.constant_value(&inner.expr, depth),
            Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse().ok(),
            Expr::Binary(ExprBinary { left, op, right, .. }) => {
                let (a, b) = (self.constant_value(left, depth)?, self.constant_value(right, depth)?);
                match op {
                    BinOp::Add(_) => a.checked_add(b),
                    BinOp::Sub(_) => a.checked_sub(b),
                    BinOp::Mul(_) => a.checked_mul(b),
                    BinOp::Div(_) => a.checked_div(b),
                    BinOp::Rem(_) => a.checked_rem(b),
                    _ => None,
                }
            }
            Expr::Path(ExprPath { path, qself: None, .. }) => {
                let (Some(first), Some(name), 2) = (path.segments.first(), path.segments.last(), path.segments.len())
                else {
                    return None;
                };
                let of_impl = |item: &'_ ImplItem| match item {
                    ImplItem::Const(constant) if constant.ident == name.ident => {
                        let is_length = constant.ty.to_token_stream().to_string() == "usize";
                        is_length.then(|| constant.expr.clone())
                    }
                    _ => None,
                };
                let value = self.input.item.items.iter().filter(|_| first.ident == "Self").find_map(of_impl)?;
                self.constant_value(&value, depth)
            }
            _ => None,
        }
    }
}
