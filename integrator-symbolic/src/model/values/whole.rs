//! Errors for integers in place of floating-point numbers, with the correct spelling.

use crate::model::{
    Reader, Target,
    code::assigned::{root_name, simple_name},
    values::value::Value,
};
use crate::{
    errors::quoted,
    graph::{NodeId, index::IndexId},
};
use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::{Block, Expr, ExprBinary, ExprIf, ExprIndex, ExprLit, ExprRepeat, ExprUnary, Lit, LitInt, Pat, Stmt, UnOp};

impl Reader<'_> {
    /// Notes an integer where a number belongs: at its literal, where it is one.
    pub(crate) fn note_integer(&mut self, index: IndexId, place: &TokenStream) {
        let Ok(place) = syn::parse2::<Expr>(place.clone()) else {
            self.errors.at(place, "expected an `f64`, found an integer\nhelp: write `2.0`, or `n as f64`");
            return;
        };
        if let Some(literal) = self.whole_literal(&place, index) {
            let message =
                format!("expected an `f64`, found the integer `{literal}`\nhelp: write `{}`", as_number(&literal));
            self.errors.at(literal, message);
            return;
        }
        let declared = simple_name(&place).and_then(|name| self.literal_of_variable(name, &[]));
        let message = match (cast_of(&place), declared) {
            (Some(cast), Some(literal)) => {
                let number = as_number(&literal);
                format!(
                    "expected an `f64`, found the integer `{}`\nhelp: write `{cast}`, or `{number}` where it is declared",
                    quoted(&place)
                )
            }
            (Some(cast), None) => format!("expected an `f64`, found an integer\nhelp: write `{cast}`"),
            (None, _) => "expected an `f64`, found an integer\nhelp: write `2.0`, or `n as f64`".to_owned(),
        };
        self.errors.at(place, message);
    }

    /// Whether one of two branches gives an integer that is written in it, and the other one a number; notes the mistake.
    pub(crate) fn notes_whole_branch(
        &mut self,
        values: [&Value; 2],
        numbers: [Option<NodeId>; 2],
        place: &dyn ToTokens,
    ) -> bool {
        let index = match (values, numbers) {
            ([Value::Integer(index), _], [_, Some(_)]) | ([_, Value::Integer(index)], [Some(_), _]) => *index,
            _ => return false,
        };
        let place = place.to_token_stream();
        let is_written =
            syn::parse2::<Expr>(place.clone()).is_ok_and(|place| self.whole_literal(&place, index).is_some());
        if is_written {
            self.note_integer(index, &place);
        }
        is_written
    }

    /// The literal that an integer is: in its place, at the end of a branch, or where a variable that changes was declared.
    pub(crate) fn whole_literal(&self, place: &Expr, index: IndexId) -> Option<LitInt> {
        let value = self.graph.loops.signed_literal(index)?.unsigned_abs();
        let is_it = |literal: &LitInt| literal.base10_parse::<u64>().is_ok_and(|number| number == value);
        let written = literal_at(place, value);
        let declared = || {
            let id = self.lookup(&root_name(place)?.to_string())?;
            let is_mutable = self.bindings[id.0].mutable;
            self.literal_of_variable(root_name(place)?, &positions(place)?).filter(|_| is_mutable)
        };
        written.or_else(declared).filter(is_it)
    }

    /// The literal that a variable, or an element of it, was declared with.
    fn literal_of_variable(&self, name: &Ident, at: &[usize]) -> Option<LitInt> {
        let id = self.lookup(&name.to_string())?;
        self.declared_literal(&Target { id, at: at.to_vec() })
    }

    /// The same of a variable that is known by its place among all.
    pub(crate) fn declared_literal(&self, target: &Target) -> Option<LitInt> {
        target.at.iter().try_fold(self.declared_as.get(&target.id)?, element_of).and_then(literal_of)
    }

    /// Notes what variables are declared with.
    pub(crate) fn note_declared(&mut self, pattern: &Pat, value: &Expr) {
        match (pattern, value) {
            (Pat::Type(typed), value) => self.note_declared(&typed.pat, value),
            (pattern, Expr::Paren(inner)) => self.note_declared(pattern, &inner.expr),
            (Pat::Tuple(parts), Expr::Tuple(values)) => {
                parts.elems.iter().zip(&values.elems).for_each(|(part, value)| self.note_declared(part, value));
            }
            (Pat::Ident(name), value) if is_whole(value) => {
                if let Some(id) = self.lookup(&name.ident.to_string()) {
                    self.declared_as.insert(id, value.clone());
                }
            }
            _ => {}
        }
    }
}

/// The integer that an expression is or ends in, without its sign.
fn literal_at(place: &Expr, value: u64) -> Option<LitInt> {
    let tail = |block: &Block| match block.stmts.last() {
        Some(Stmt::Expr(end, None)) => literal_at(end, value),
        _ => None,
    };
    match place {
        Expr::If(ExprIf { then_branch, else_branch, .. }) => {
            tail(then_branch).or_else(|| literal_at(&else_branch.as_ref()?.1, value))
        }
        Expr::Block(inner) => tail(&inner.block),
        other => literal_of(other).filter(|literal| literal.base10_parse::<u64>().is_ok_and(|number| number == value)),
    }
}

/// The integer that an expression is, without its sign.
fn literal_of(expression: &Expr) -> Option<LitInt> {
    match expression {
        Expr::Lit(ExprLit { lit: Lit::Int(literal), .. }) if literal.suffix() != "f64" => Some(literal.clone()),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => literal_of(expr),
        Expr::Paren(inner) => literal_of(&inner.expr),
        Expr::Reference(inner) => literal_of(&inner.expr),
        _ => None,
    }
}

/// Whether an expression is an integer, or an array whose first element is one.
fn is_whole(expression: &Expr) -> bool {
    match expression {
        Expr::Array(list) => list.elems.first().is_some_and(is_whole),
        Expr::Repeat(ExprRepeat { expr, .. }) => is_whole(expr),
        other => literal_of(other).is_some(),
    }
}

fn element_of<'e>(list: &'e Expr, at: &usize) -> Option<&'e Expr> {
    match list {
        Expr::Array(list) => list.elems.get(*at),
        Expr::Repeat(ExprRepeat { expr, .. }) => Some(expr),
        _ => None,
    }
}

/// The positions at which an element stands, `2` and `0` of `list[2][0]`; beyond all of them where that is no literal.
fn positions(place: &Expr) -> Option<Vec<usize>> {
    match place {
        Expr::Index(ExprIndex { expr, index, .. }) => {
            let mut outer = positions(expr)?;
            outer.push(literal_of(index).and_then(|index| index.base10_parse().ok()).unwrap_or(usize::MAX));
            Some(outer)
        }
        _ => Some(Vec::new()),
    }
}

/// An integer as a number of floating point.
pub(crate) fn as_number(literal: &LitInt) -> String {
    format!("{}.0", literal.base10_digits())
}

/// What to write for an integer that is no literal. Quotients of integers are rounded, so that each operand is made a number.
fn cast_of(place: &Expr) -> Option<String> {
    let text = quoted(place);
    match place {
        Expr::Lit(ExprLit { lit: Lit::Int(literal), .. }) => Some(as_number(literal)),
        Expr::Paren(inner) => cast_of(&inner.expr).map(|inner| format!("({inner})")),
        Expr::Binary(ExprBinary { left, op, right, .. }) => {
            Some(format!("{} {} {}", cast_of(left)?, quoted(op), cast_of(right)?))
        }
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => cast_of(expr).map(|inner| format!("-{inner}")),
        Expr::Path(_) | Expr::Index(_) | Expr::Field(_) | Expr::MethodCall(_) | Expr::Call(_) => {
            Some(format!("{text} as f64"))
        }
        Expr::Cast(_) => Some(format!("({text}) as f64")),
        _ => None,
    }
}
