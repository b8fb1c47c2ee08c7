//! Parameters that are a number times another one, such as half of the side of a box.

use super::{
    factors::factors,
    parameter_text::{Texts, without_sign},
    text::without_parentheses,
};
use crate::graph::{Graph, ParameterId};
use proc_macro2::TokenStream;
use syn::{Expr, Lit, UnOp};

impl Texts<'_> {
    /// The number and the other parameter; one and the parameter itself where its text is no such product.
    pub(super) fn multiple_of(&mut self, graph: &mut Graph, id: ParameterId) -> (f64, ParameterId) {
        let (mut number, mut rest, mut text) = (1.0, None, self.text(id));
        while let Some(positive) = without_sign(text.clone()) {
            (number, text) = (-number, positive);
        }
        for (text, exponent) in factors(text) {
            match literal(&text) {
                Some(factor) => number *= f64::powi(factor, exponent),
                None if exponent == 1 && rest.is_none() => rest = Some(text),
                None => return (1.0, id),
            }
        }
        match rest {
            Some(text) if number != 1.0 => (number, self.id(graph, text, graph.loops.of_parameter(id))),
            _ => (1.0, id),
        }
    }
}

/// The value of a literal of a real number, perhaps with a sign.
fn literal(text: &TokenStream) -> Option<f64> {
    fn value(expression: &Expr) -> Option<f64> {
        match without_parentheses(expression) {
            Expr::Unary(negative) if matches!(negative.op, UnOp::Neg(_)) => value(&negative.expr).map(|value| -value),
            Expr::Lit(literal) => match &literal.lit {
                Lit::Float(number) => number.base10_parse().ok(),
                _ => None,
            },
            _ => None,
        }
    }
    value(&syn::parse2(text.clone()).ok()?)
}
