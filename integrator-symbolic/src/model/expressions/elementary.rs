//! Elementary functions: the methods of `f64` that may be called with coordinates.

use crate::model::{
    Reader,
    expressions::cure::{by_powf, in_rust},
    values::value::{Opaque, Value, is_list},
};
use crate::{
    graph::{
        Comparison, Node, NodeId,
        function::{Function, Rule, TABLE},
    },
    spelling::nearest,
};
use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::{Expr, ExprLit, ExprUnary, Lit, UnOp};

/// Methods of `f64` that are arithmetic on the functions of the table.
const ARITHMETIC: [&str; 12] = [
    "sqrt",
    "powi",
    "recip",
    "mul_add",
    "sin_cos",
    "log",
    "clamp",
    "fract",
    "rem_euclid",
    "to_radians",
    "to_degrees",
    "clone",
];

/// Names of the tables that are not written as a function of coordinates: an operator, and what changes nothing.
const UNSPELLED: [&str; 2] = ["remainder", "clone"];

impl Reader<'_> {
    /// A method of `f64`.
    pub(crate) fn elementary(
        &mut self,
        name: &Ident,
        receiver: Value,
        place: &Expr,
        arguments: Vec<Value>,
        places: &[&Expr],
    ) -> Option<Value> {
        let method = name.to_string();
        let function = Function::named(&method);
        let expected = match (function.map(|function| &function.row().rule), method.as_str()) {
            (Some(Rule::Unary(..)), _) => 0,
            (Some(Rule::Binary(..)), _) | (None, "powi" | "log" | "rem_euclid") => 1,
            (None, "mul_add" | "clamp") => 2,
            (None, known) if ARITHMETIC.contains(&known) => 0,
            _ if matches!(receiver, Value::Opaque(_)) => {
                let cure = format!("write the formula as a method of this impl, {OR_STATE}");
                self.outside(name, &method, &cure);
                return None;
            }
            _ => {
                let whole: Vec<&Expr> = std::iter::once(place).chain(places.iter().copied()).collect();
                match in_rust(&method, &whole, is_list(&receiver)) {
                    Some(cure) => {
                        self.errors
                            .at(name, format!("numbers and arrays have no method `{method}`\nhelp: write `{cure}`"));
                    }
                    None => self.unknown_function(name, &method),
                }
                return None;
            }
        };
        if method == "clone" {
            return Some(receiver);
        }
        let x = self.operand(&receiver, place)?;
        if method == "log" && arguments.is_empty() {
            let message = "`log` takes the base as an argument\nhelp: write `ln` for the natural logarithm";
            self.errors.at(name, message);
            return None;
        }
        if arguments.len() != expected {
            self.errors.at(name, takes(&method, expected, arguments.len()));
            return None;
        }
        if method != "mul_add" && self.is_mixed(x) {
            self.not_separable(place);
            return None;
        }
        if method == "powi" {
            return self.whole_power(x, &arguments[0], places[0]);
        }
        let numbers: Vec<_> = arguments.iter().zip(places).map(|(value, place)| self.number(value, place)).collect();
        let numbers = numbers.into_iter().collect::<Option<Vec<NodeId>>>()?;
        let mut operands = numbers.iter().zip(places);
        let mixed = operands.find(|(number, _)| self.mixes(x, **number) || self.is_mixed(**number));
        if let Some((_, place)) = mixed.filter(|_| method != "mul_add") {
            self.not_separable(place);
            return None;
        }
        let graph = &mut self.graph;
        Some(Value::Real(match (function, method.as_str(), &numbers[..]) {
            (Some(function), _, []) => graph.unary(function, x),
            (Some(function), _, [y]) => graph.binary(function, x, *y),
            (None, "sqrt", _) => graph.power(x, 1),
            (None, "recip", _) => graph.power(x, -2),
            (None, "mul_add", [factor, addend]) => {
                if self.mixes(x, *factor) {
                    self.not_separable(place);
                    return None;
                }
                let product = self.graph.mul(x, *factor);
                self.graph.add(product, *addend)
            }
            (None, "clamp", [low, high]) => {
                if graph.is_total(x) {
                    let raised = graph.call_two("max", x, *low);
                    graph.call_two("min", raised, *high)
                } else {
                    // A NaN is below nothing and above nothing, and stays; a maximum would hide it.
                    let below = graph.compare(Comparison::Less, x, *low);
                    let above = graph.compare(Comparison::Less, *high, x);
                    let inside = graph.select(above, *high, x);
                    graph.select(below, *low, inside)
                }
            }
            (None, "sin_cos", _) => {
                let (sine, cosine) = (graph.call("sin", x), graph.call("cos", x));
                return Some(Value::Tuple(vec![Value::Real(sine), Value::Real(cosine)]));
            }
            (None, "log", [base]) => {
                let (logarithm, of_base) = (graph.call("ln", x), graph.call("ln", *base));
                graph.div(logarithm, of_base)
            }
            (None, "fract", _) => {
                let whole = graph.call("trunc", x);
                graph.sub(x, whole)
            }
            // As in std: what `%` leaves below zero is moved up by one divisor.
            (None, "rem_euclid", [divisor]) => {
                let zero = graph.constant(0.0);
                let remainder = graph.call_two("remainder", x, *divisor);
                let size = graph.call("abs", *divisor);
                let raised = graph.add(remainder, size);
                let below = graph.compare(Comparison::Less, remainder, zero);
                graph.select(below, raised, remainder)
            }
            (None, "to_degrees", _) => {
                let scale = graph.constant(180.0 / std::f64::consts::PI);
                graph.mul(scale, x)
            }
            _ => {
                let scale = graph.constant(std::f64::consts::PI / 180.0);
                graph.mul(scale, x)
            }
        }))
    }

    /// `x.powi(n)`: multiplications for a literal, a power with real exponent for a parameter.
    fn whole_power(&mut self, x: NodeId, exponent: &Value, place: &Expr) -> Option<Value> {
        if let Some(literal) = signed_literal(place) {
            let Some(halves) = halves_of(literal) else {
                self.errors.at(place, "this exponent is too large");
                return None;
            };
            return Some(Value::Real(self.graph.power(x, halves)));
        }
        let exponent = match &self.of_own_type(exponent.clone().into_own()) {
            Value::Real(number) if matches!(self.graph.node(*number), Node::Constant(_)) => {
                self.errors
                    .at(place, format!("the exponent of `powi` has to be an integer\nhelp: write {}", by_powf(place)));
                return None;
            }
            Value::Integer(index) => {
                let literal = self.graph.loops.signed_literal(*index).and_then(|literal| i32::try_from(literal).ok());
                match literal.and_then(halves_of) {
                    Some(halves) => return Some(Value::Real(self.graph.power(x, halves))),
                    None => self.graph.number_of(*index),
                }
            }
            exponent => {
                let Some(Opaque { text, loops }) = self.opaque(exponent) else {
                    let message = "the exponent of `powi` has to be an integer that does not depend on \
                                   coordinates\nhelp: write `powf` for other exponents";
                    self.errors.at(place, message);
                    return None;
                };
                let exponent = self.parameter(quote!(f64::from(#text)), "number", loops);
                self.graph.parameter(exponent)
            }
        };
        Some(Value::Real(self.graph.call_two("powf", x, exponent)))
    }

    /// Notes a function of coordinates that is none of the table and no helper, with the names nearest to it.
    fn unknown_function(&mut self, place: impl ToTokens, name: &str) {
        let helpers = self.input.functions().map(|function| function.sig.ident.to_string());
        let known: Vec<String> = known_functions().map(str::to_owned).chain(helpers).collect();
        let near: Vec<String> = nearest(name, &known).into_iter().map(|near| format!("`{near}`")).collect();
        let like = if near.is_empty() { String::new() } else { format!("\nhelp: similar names: {}", near.join(", ")) };
        let message = format!(
            "no derivative of `{name}` is known{like}\nnote: supported are the methods of `f64` listed in \
             docs/language.md, and helper methods of this impl"
        );
        self.errors.at(place, message);
    }
}

/// The methods of `f64` that may be called with coordinates.
pub(crate) fn known_functions() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|row| row.name).chain(ARITHMETIC).filter(|name| !UNSPELLED.contains(name))
}

/// Whether a method of numbers gives another number.
pub(crate) fn is_elementary(name: &str) -> bool {
    Function::named(name).is_some() || ARITHMETIC.contains(&name)
}

/// The value of `3`, `-3` or `(3)`.
fn signed_literal(expression: &Expr) -> Option<i32> {
    match expression {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse().ok(),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => signed_literal(expr).and_then(i32::checked_neg),
        Expr::Paren(inner) => signed_literal(&inner.expr),
        _ => None,
    }
}

/// An exponent in halves, if those of derivatives, which are lower still, are numbers as well.
fn halves_of(exponent: i32) -> Option<i32> {
    exponent.checked_mul(2).filter(|halves| halves.unsigned_abs() < 1 << 30)
}

/// What may be done with code that is never looked into.
pub(crate) const OR_STATE: &str = "or call it in a method with a stated derivative, `#[derivative(slope)]`";

/// What to say of a call with too few or too many arguments.
pub(crate) fn takes(name: &str, expected: usize, found: usize) -> String {
    let plural = if expected == 1 { "" } else { "s" };
    format!("`{name}` takes {expected} argument{plural}, not {found}")
}
