//! Rust code for expressions, with the fewest parentheses; a product inside of a sum becomes a fused multiply-add.

use super::{fields::Fields, frame::Frame};
use crate::{
    graph::{
        Element, ExternalId, Graph, Node, NodeId, Part,
        external::Arguments,
        function::{Function, HUGE, LEAST},
        index::{IndexId, LoopId, LoopSet},
    },
    model::{Method, Parameter, is_field, values::integer::number_literal},
    program::{root, root_cubed},
    syntax::Functions,
};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::collections::{HashMap, HashSet};

/// The precedence of an expression.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The scalar type that code computes in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dialect {
    /// The type parameter of the function.
    Generic,
    /// `f64`, where parameters are prepared.
    Single,
}

/// A printed expression.
pub(crate) struct Printed {
    pub(crate) tokens: TokenStream,
    binding: Binding,
}

impl Printed {
    fn new(binding: Binding, tokens: TokenStream) -> Self {
        Self { tokens, binding }
    }

    /// As the right side of an addition or a subtraction.
    pub(crate) fn term(self) -> TokenStream {
        self.at_least(Binding::Product)
    }

    /// In parentheses, unless it holds together at least as tightly as `needed`.
    pub(crate) fn at_least(self, needed: Binding) -> TokenStream {
        if self.binding >= needed {
            return self.tokens;
        }
        let tokens = self.tokens;
        quote!((#tokens))
    }
}

/// A printer of expressions; `names` are those of the values that have one.
pub(crate) struct Printer<'m> {
    pub(crate) graph: &'m Graph,
    pub(crate) parameters: &'m [Parameter],
    /// How many numbers or points the coordinates are, and how many components a point has.
    pub(crate) lengths: &'m [IndexId],
    pub(crate) running: &'m HashMap<LoopId, Ident>,
    pub(crate) dialect: Dialect,
    pub(crate) names: HashMap<NodeId, Ident>,
    /// The values whose operations are not fused with each other, since a condition compares them.
    pub(crate) compared: &'m HashSet<NodeId>,
    /// What flows compute in.
    pub(crate) scalar: &'m Ident,
    /// The path of the runtime's private API.
    pub(crate) runtime: &'m Ident,
    /// The names of the user's methods, by their ids.
    pub(crate) externals: &'m [Method],
    /// How near the elementary functions have to be.
    pub(crate) functions: Functions,
    /// Whether coordinates are lists, whose length is known at run time.
    pub(crate) is_list: bool,
    /// The coordinates whose length is read: positions, unless these are being changed.
    pub(crate) counted: Part,
    /// Where coordinates and prepared constants are.
    pub(crate) frame: &'m Frame<'m>,
}

impl Printer<'_> {
    /// An expression, by its name if it has one.
    pub(crate) fn expression(&self, fields: &mut Fields, id: NodeId) -> Printed {
        match self.names.get(&id) {
            Some(name) => Printed::new(Binding::Atom, name.to_token_stream()),
            None => self.computation(fields, id),
        }
    }

    /// An expression as it is computed, whatever its name.
    pub(crate) fn computation(&self, fields: &mut Fields, id: NodeId) -> Printed {
        if self.dialect == Dialect::Generic && is_field(self.graph, self.parameters, id) {
            return Printed::new(Binding::Atom, self.field(fields, id));
        }
        match self.graph.node(id) {
            Node::Constant(bits) => self.constant(f64::from_bits(bits)),
            // Prepared constants know no path of the user's impl.
            Node::Parameter(_) if matches!(self.frame, Frame::Constants) => {
                Printed::new(Binding::Atom, self.field(fields, id))
            }
            Node::Parameter(parameter) => {
                let text = self.parameters[parameter.0 as usize].named_text(self.running);
                match self.dialect {
                    Dialect::Generic => Printed::new(Binding::Atom, self.lift(quote!(#text))),
                    Dialect::Single => Printed::new(binding(&text), quote!(#text)),
                }
            }
            Node::Coordinate(element) => Printed::new(Binding::Atom, self.coordinate(fields, element)),
            Node::Time => Printed::new(Binding::Atom, quote!(time)),
            Node::Middle => {
                let name = fields.middle();
                Printed::new(Binding::Atom, self.shared(name, LoopSet::EMPTY))
            }
            Node::Step => Printed::new(Binding::Atom, quote!(step)),
            Node::FromIndex(_) if self.frame.has_prepared_index(self.graph.loops_of(id)) => {
                Printed::new(Binding::Atom, self.field(fields, id))
            }
            Node::FromIndex(index) => {
                let index = self.number_index(fields, index);
                match self.dialect {
                    Dialect::Generic => Printed::new(Binding::Atom, self.lift(quote!(#index as f64))),
                    Dialect::Single => Printed::new(Binding::Atom, quote!((#index as f64))),
                }
            }
            Node::Neg(a) => {
                let a = self.expression(fields, a).at_least(Binding::Sign);
                Printed::new(Binding::Sign, quote!(-#a))
            }
            Node::Add(a, b) => self.addition(fields, id, a, b),
            Node::Mul(a, b) => {
                if a == b && self.is_of_scalars() {
                    let a = self.receiver(fields, a);
                    return Printed::new(Binding::Atom, quote!(#a.square()));
                }
                if let Some((constant, varied)) = self.constant_factor(a, b) {
                    let factor = self.receiver(fields, constant);
                    let varied = self.expression(fields, varied).tokens;
                    return Printed::new(Binding::Atom, quote!(#factor.scale(#varied)));
                }
                let (a, b) = (self.expression(fields, a), self.expression(fields, b));
                let (a, b) = (a.at_least(Binding::Product), b.at_least(Binding::Sign));
                Printed::new(Binding::Product, quote!(#a * #b))
            }
            Node::Div(a, b) => {
                if self.dialect == Dialect::Generic && !self.compared.contains(&id) {
                    let is_named = |id| self.names.contains_key(&id);
                    // The force of a pair says which instruction set computes all of its sums; a lone root does not.
                    let base =
                        if matches!(self.frame, Frame::Bodies(_)) { root(self.graph, b, is_named) } else { None };
                    let by_root = base.map(|base| (base, quote!(div_sqrt)));
                    let by_cube = || Some((root_cubed(self.graph, b, is_named)?, quote!(div_pow_3_2)));
                    if let Some((base, quotient)) = by_root.or_else(by_cube) {
                        let a = self.expression(fields, a).at_least(Binding::Atom);
                        let base = self.expression(fields, base).tokens;
                        return Printed::new(Binding::Atom, quote!(#a.#quotient(#base)));
                    }
                }
                let (a, b) = (self.expression(fields, a), self.expression(fields, b));
                let (a, b) = (a.at_least(Binding::Product), b.at_least(Binding::Sign));
                Printed::new(Binding::Product, quote!(#a / #b))
            }
            Node::Power(a, 1) => self.method(fields, a, "sqrt", None),
            // Lowering leaves no other power; this prints one all the same.
            Node::Power(a, halves) => {
                let a = self.expression(fields, a).at_least(Binding::Atom);
                let exponent = self.constant(f64::from(halves) / 2.0).tokens;
                Printed::new(Binding::Atom, quote!(#a.powf(#exponent)))
            }
            Node::Unary(function, a) => self.method(fields, a, self.method_name(function), None),
            Node::Binary(function, a, b) => self.method(fields, a, self.method_name(function), Some(b)),
            Node::External(id, arguments) => self.external(fields, id, arguments),
            Node::Entry(table, row, column) => {
                let is_symmetric = self.graph.is_symmetric(table);
                let name = fields.number(self.graph, self.parameters, table);
                let table = self.prepared(name, LoopSet::EMPTY);
                // The order of the bodies decides which is the row, if the table is not symmetric.
                if let (Node::Select(order, first, second), Node::Select(other, b, a)) =
                    (self.graph.node(row), self.graph.node(column))
                    && (order, first, second) == (other, a, b)
                    && !is_symmetric
                {
                    let [order, first, second] = [order, first, second].map(|id| self.expression(fields, id).tokens);
                    return Printed::new(Binding::Atom, quote!(#table.entry_in_order(#order, #first, #second)));
                }
                let [row, column] = [row, column].map(|number| self.expression(fields, number).tokens);
                Printed::new(Binding::Atom, quote!(#table.entry(#row, #column)))
            }
            // Of two prepared numbers; the blocks inside of all other choices, and of sums, compute them.
            Node::Select(condition, a, b) => {
                let [condition, a, b] = [condition, a, b].map(|id| self.expression(fields, id).tokens);
                match self.dialect {
                    Dialect::Generic => {
                        let scalar = self.scalar;
                        Printed::new(Binding::Atom, quote!(#scalar::select(#condition, #a, #b)))
                    }
                    Dialect::Single => Printed::new(Binding::Atom, quote!((if #condition { #a } else { #b }))),
                }
            }
            Node::Sum(_, body) | Node::Fold(_, _, body) => self.expression(fields, body),
            condition => Printed::new(Binding::Atom, self.condition(fields, condition)),
        }
    }

    /// An `f64` as a number that flows compute in.
    pub(crate) fn lift(&self, value: TokenStream) -> TokenStream {
        let scalar = self.scalar;
        quote!(#scalar::of(#value))
    }

    fn method(&self, fields: &mut Fields, receiver: NodeId, name: &str, argument: Option<NodeId>) -> Printed {
        let name = format_ident!("{name}");
        let argument = argument.map(|argument| self.expression(fields, argument).tokens);
        // A method of literals alone would not tell of which type of numbers it is.
        if self.dialect == Dialect::Single && self.is_literal(receiver) {
            let (receiver, argument) = (self.expression(fields, receiver).tokens, argument.into_iter());
            return Printed::new(Binding::Atom, quote!(f64::#name(#receiver #(, #argument)*)));
        }
        let receiver = self.expression(fields, receiver).at_least(Binding::Atom);
        Printed::new(Binding::Atom, quote!(#receiver.#name(#argument)))
    }

    /// What a flow calls an elementary function: the faster one where it is allowed. What is prepared is `f64` of `std`.
    fn method_name(&self, function: Function) -> &'static str {
        match (self.functions, self.dialect) {
            (Functions::Fast, Dialect::Generic) => function.row().fast.unwrap_or(function.name()),
            _ => function.name(),
        }
    }

    fn is_literal(&self, id: NodeId) -> bool {
        let node = self.graph.node(id);
        let is_leaf = node.children().next().is_none();
        matches!(node, Node::Constant(_)) || !is_leaf && node.children().all(|child| self.is_literal(child))
    }

    /// A number that flows compute in.
    pub(crate) fn number(&self, value: f64) -> TokenStream {
        self.constant(value).tokens
    }

    fn constant(&self, number: f64) -> Printed {
        let value = match number {
            _ if number.is_nan() => quote!(f64::NAN),
            f64::INFINITY => quote!(f64::INFINITY),
            f64::NEG_INFINITY => quote!(f64::NEG_INFINITY),
            // Only a finite number has a literal.
            _ => {
                let literal = number_literal(number.abs());
                if number.is_sign_negative() { quote!(-#literal) } else { literal.to_token_stream() }
            }
        };
        match self.dialect {
            Dialect::Generic if number == LEAST => {
                let scalar = self.scalar;
                Printed::new(Binding::Atom, quote!(#scalar::least()))
            }
            Dialect::Generic if number == HUGE => {
                let scalar = self.scalar;
                Printed::new(Binding::Atom, quote!(#scalar::huge()))
            }
            Dialect::Generic => Printed::new(Binding::Atom, self.lift(quote!(#value))),
            Dialect::Single => Printed::new(Binding::Atom, quote!(#value)),
        }
    }

    /// A call of a method of the user: member by member in a flow, with its derivatives for duals.
    fn external(&self, fields: &mut Fields, id: ExternalId, arguments: Arguments) -> Printed {
        let numbers: Vec<TokenStream> =
            arguments.iter().map(|argument| self.expression(fields, argument).tokens).collect();
        if self.dialect == Dialect::Single {
            return Printed::new(Binding::Atom, self.externals[id.0 as usize].call(&quote!(self), &numbers));
        }
        let mut field = |id: Option<ExternalId>| match id {
            Some(id) => {
                let name = fields.external(self.externals, id);
                quote!(::core::option::Option::Some(&motion.parameters.#name))
            }
            None => quote!(::core::option::Option::None),
        };
        let (value, runtime) = (field(Some(id)), self.runtime);
        let slopes: Vec<_> =
            (0..numbers.len()).map(|argument| field(self.graph.external_slope(id, argument))).collect();
        Printed::new(Binding::Atom, quote!(#runtime::external([#(#numbers),*], #value, [#(#slopes),*])))
    }

    /// `sum`, which is `a + b`, where a product among the two is fused with the addition.
    fn addition(&self, fields: &mut Fields, sum: NodeId, a: NodeId, b: NodeId) -> Printed {
        if self.dialect == Dialect::Generic && !self.compared.contains(&sum) {
            for (product, other) in [(b, a), (a, b)] {
                if let Some((negative, x, y)) = self.product(product) {
                    let other = self.expression(fields, other).tokens;
                    return Printed::new(Binding::Atom, self.fused(fields, (negative, x, y), &other));
                }
            }
        }
        let left = self.expression(fields, a).at_least(Binding::Sum);
        if let Node::Neg(subtracted) = self.graph.node(b)
            && !self.names.contains_key(&b)
        {
            let right = self.expression(fields, subtracted).at_least(Binding::Product);
            return Printed::new(Binding::Sum, quote!(#left - #right));
        }
        let right = self.expression(fields, b).at_least(Binding::Product);
        Printed::new(Binding::Sum, quote!(#left + #right))
    }

    /// The factors of a product that has no name, perhaps under a change of sign; `true` if so.
    pub(crate) fn product(&self, id: NodeId) -> Option<(bool, NodeId, NodeId)> {
        if self.names.contains_key(&id) || is_field(self.graph, self.parameters, id) {
            return None;
        }
        match self.graph.node(id) {
            Node::Mul(a, b) => Some((false, a, b)),
            Node::Neg(inner) => self.product(inner).map(|(negative, a, b)| (!negative, a, b)),
            _ => None,
        }
    }

    /// Whether this is the text of a flow, in scalars that may have derivatives.
    fn is_of_scalars(&self) -> bool {
        self.dialect == Dialect::Generic && !matches!(self.frame, Frame::Constants | Frame::Series { .. })
    }

    /// Whether a value is the same for all states: what is prepared, and multiples of the step.
    fn is_without_slope(&self, id: NodeId) -> bool {
        match self.graph.node(id) {
            Node::Step => self.frame.has_fixed_step(),
            Node::Neg(a) => self.is_without_slope(a),
            Node::Mul(a, b) => self.is_without_slope(a) && self.is_without_slope(b),
            _ => self.graph.is_prepared(id),
        }
    }

    /// The factor of a product that is the same for all states, and the other one; `None` where none is, or both are.
    pub(crate) fn constant_factor(&self, a: NodeId, b: NodeId) -> Option<(NodeId, NodeId)> {
        if !self.is_of_scalars() {
            return None;
        }
        match (self.is_without_slope(a), self.is_without_slope(b)) {
            (true, false) => Some((a, b)),
            (false, true) => Some((b, a)),
            _ => None,
        }
    }

    /// A factor, perhaps under a change of sign.
    fn with_sign(&self, fields: &mut Fields, negative: bool, x: NodeId) -> Printed {
        match self.graph.as_constant(x) {
            Some(constant) if negative => self.constant(-constant),
            None if negative => {
                let x = self.expression(fields, x).at_least(Binding::Sign);
                Printed::new(Binding::Sign, quote!(-#x))
            }
            _ => self.expression(fields, x),
        }
    }

    /// The first factor of a fused multiply-add.
    pub(crate) fn factor(&self, fields: &mut Fields, negative: bool, x: NodeId) -> TokenStream {
        self.with_sign(fields, negative, x).at_least(Binding::Atom)
    }

    /// A product, perhaps under a change of sign, added to another value in one operation.
    pub(crate) fn fused(
        &self,
        fields: &mut Fields,
        (negative, x, y): (bool, NodeId, NodeId),
        other: &TokenStream,
    ) -> TokenStream {
        if x == y && self.is_of_scalars() {
            let (x, method) =
                (self.receiver(fields, x), if negative { quote!(square_from) } else { quote!(square_add) });
            return quote!(#x.#method(#other));
        }
        if let Some((constant, varied)) = self.constant_factor(x, y) {
            let (factor, varied) = (self.factor(fields, negative, constant), self.expression(fields, varied).tokens);
            return quote!(#factor.scale_add(#varied, #other));
        }
        let (factor, y) = (self.factor(fields, negative, x), self.expression(fields, y).tokens);
        quote!(#factor.fma(#y, #other))
    }

    /// The first of two arguments that are multiplied.
    pub(crate) fn outer_factor(&self, fields: &mut Fields, negative: bool, x: NodeId) -> TokenStream {
        self.with_sign(fields, negative, x).tokens
    }

    /// An expression that a method is called on.
    pub(crate) fn receiver(&self, fields: &mut Fields, id: NodeId) -> TokenStream {
        self.expression(fields, id).at_least(Binding::Atom)
    }

    /// The value of a coordinate.
    fn coordinate(&self, fields: &mut Fields, element: Element) -> TokenStream {
        let place = |fields| self.place(fields, element);
        match self.frame {
            Frame::System | Frame::Constants | Frame::Motion | Frame::OwnTime | Frame::Apart => {
                let place = place(fields);
                quote!(#place.value())
            }
            Frame::Sites(_) => self.neighbour(element),
            Frame::Bodies(_) | Frame::Series { .. } | Frame::Edges => place(fields),
        }
    }

    /// A coordinate's place: `motion.q[0]`, `motion.p[i][1]`, `q_i[d]`, `q[order][0]`.
    pub(crate) fn place(&self, fields: &mut Fields, element: Element) -> TokenStream {
        let part = self.part(element);
        match self.frame {
            Frame::System | Frame::Constants | Frame::Motion | Frame::OwnTime | Frame::Apart | Frame::Sites(_) => {
                let at = self.at(fields, element);
                quote!(motion.#part #at)
            }
            Frame::Bodies(bodies) => {
                let (part, at) = (bodies.of_index(self.graph, part, element.index), self.at(fields, element));
                quote!(#part #at)
            }
            Frame::Series { .. } => {
                let place = self.in_row(fields, element);
                quote!(#part[order][#place])
            }
            Frame::Edges => {
                let place = self.in_row(fields, element);
                quote!(#part[0][#place])
            }
        }
    }
}

/// How tightly a text of the user holds together: as one operand where it has no operator outside of brackets.
fn binding(text: &TokenStream) -> Binding {
    let is_operator = |mark: char| !matches!(mark, '.' | ':');
    let operators = text.clone().into_iter().any(|token| match token {
        TokenTree::Punct(mark) => is_operator(mark.as_char()),
        TokenTree::Ident(name) => name == "as",
        TokenTree::Group(_) | TokenTree::Literal(_) => false,
    });
    if operators { Binding::Sum } else { Binding::Atom }
}
