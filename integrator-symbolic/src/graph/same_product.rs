//! Products that are equal up to the order of their factors, including the source of parameters.

use super::{Graph, Node, NodeId, ParameterId};
use std::collections::BTreeMap;

/// The factors in the text of a parameter, each with its exponent; a text itself where it is no product.
pub(crate) type FactorsOf<'t> = &'t dyn Fn(ParameterId) -> Vec<(String, i32)>;

/// A base of powers.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Base {
    Node(NodeId),
    Text(String),
}

/// A product of powers, in one form however it is written.
struct Powers<'t> {
    factors_of: FactorsOf<'t>,
    /// The numbers that the others are multiplied with and divided by, apart: most are whole, and few quotients are exact.
    numbers: [f64; 2],
    /// Twice the exponents of the others.
    halves: BTreeMap<Base, i64>,
}

impl Graph {
    /// Whether two products of powers are the same up to the order of their factors, where none of these is zero.
    pub(super) fn is_same_product(&self, a: NodeId, b: NodeId, factors_of: FactorsOf<'_>) -> bool {
        let mut quotient = Powers { factors_of, numbers: [1.0; 2], halves: BTreeMap::new() };
        quotient.multiply(self, a, 2);
        quotient.multiply(self, b, -2);
        let [over, under] = quotient.numbers;
        over == under && over.is_normal() && quotient.halves.into_values().all(|halves| halves == 0)
    }
}

impl Powers<'_> {
    /// Multiplies by a node to the power of `halves / 2`.
    fn multiply(&mut self, graph: &Graph, id: NodeId, halves: i64) {
        if halves % 2 != 0 {
            return self.multiply_by_base(Base::Node(id), halves);
        }
        match graph.node(id) {
            Node::Constant(bits) => self.multiply_by_number(f64::from_bits(bits), halves),
            Node::Parameter(parameter) => {
                for (text, exponent) in (self.factors_of)(parameter) {
                    let halves = i64::from(exponent).saturating_mul(halves);
                    match text.parse() {
                        Ok(number) => self.multiply_by_number(number, halves),
                        Err(_) => self.multiply_by_base(Base::Text(text), halves),
                    }
                }
            }
            Node::Neg(x) => {
                self.numbers[0] *= if halves % 4 == 0 { 1.0 } else { -1.0 };
                self.multiply(graph, x, halves);
            }
            Node::Mul(a, b) => {
                self.multiply(graph, a, halves);
                self.multiply(graph, b, halves);
            }
            Node::Div(a, b) => {
                self.multiply(graph, a, halves);
                self.multiply(graph, b, -halves);
            }
            Node::Power(x, own) => self.multiply(graph, x, i64::from(own).saturating_mul(halves / 2)),
            _ => self.multiply_by_base(Base::Node(id), halves),
        }
    }

    fn multiply_by_number(&mut self, number: f64, halves: i64) {
        self.numbers[usize::from(halves < 0)] *= number.powf(halves.abs() as f64 / 2.0);
    }

    fn multiply_by_base(&mut self, base: Base, halves: i64) {
        let sum = self.halves.entry(base).or_default();
        *sum = sum.saturating_add(halves);
    }
}
