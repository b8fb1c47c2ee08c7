//! Blocks as Rust: lets, loops, and where values go.

use super::{
    expression::{Dialect, Printer},
    fields::{Fields, is_leaf},
    names::Names,
};
use crate::{
    graph::{Element, Graph, Node, NodeId, Part, index::Index},
    lower::lower,
    model::{Model, Shape},
    program::{Item, Placed, Program, Sink, schedule},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::{BTreeSet, HashMap};

/// The body of a function that returns `root`, which is lowered.
pub(super) fn function(
    model: &Model,
    fields: &mut Fields,
    names: &Names,
    root: NodeId,
    dialect: Dialect,
) -> TokenStream {
    let placed = [Placed { context: Vec::new(), sink: Sink::Return, value: root }];
    let program = match dialect {
        Dialect::Generic => schedule(&model.graph, &placed, |graph, id| is_leaf(graph, &model.parameters, id)),
        Dialect::Single => schedule(&model.graph, &placed, |graph, id| {
            matches!(graph.node(id), Node::Constant(_) | Node::FromIndex(_) | Node::Parameter(_))
        }),
    };
    let body = Block::new(model, names, &program, dialect).items(fields, &program.items);
    match dialect {
        Dialect::Generic => body,
        Dialect::Single if program.items.len() > 1 => quote!({ #body }),
        Dialect::Single => body,
    }
}

/// The body of a flow: the lowered updates of the coordinates, each in its loops.
pub(super) fn flow(model: &Model, fields: &mut Fields, names: &Names, placed: &[Placed]) -> TokenStream {
    let program = schedule(&model.graph, placed, |graph, id| is_leaf(graph, &model.parameters, id));
    let block = Block::new(model, names, &program, Dialect::Generic);
    let body = block.items(fields, &program.items);
    let Some(element) = placed.iter().find_map(|placed| match placed.sink {
        Sink::Collect(element) => Some(element),
        _ => None,
    }) else {
        return body;
    };
    let (open, close) = buffer(&model.shape, element.part, &block.printer.lifted(quote!(0.0)));
    quote!(#open #body #close)
}

/// A buffer for the gradient, and its application to the coordinates of `part`.
fn buffer(shape: &Shape, part: Part, zero: &TokenStream) -> (TokenStream, TokenStream) {
    let coordinates = match part {
        Part::Position => quote!(q),
        Part::Momentum => quote!(p),
    };
    let length = shape.length.tokens();
    match &shape.dimension {
        None => (
            quote!(let mut gradient = [#zero; #length];),
            quote!(for i in 0..#length { motion.#coordinates[i].fma(step, gradient[i]); }),
        ),
        Some(dimension) => {
            let dimension = dimension.tokens();
            (
                quote!(let mut gradient = [[#zero; #dimension]; #length];),
                quote!(for i in 0..#length {
                    for d in 0..#dimension { motion.#coordinates[i][d].fma(step, gradient[i][d]); }
                }),
            )
        }
    }
}

/// Values for `roots` without powers, whose prepared constants are left alone.
pub(super) fn lowered(model: &mut Model, roots: &[NodeId]) -> Vec<NodeId> {
    let Model { graph, parameters, .. } = model;
    lower(graph, roots, |graph, id| is_leaf(graph, parameters, id))
}

struct Block<'m> {
    printer: Printer<'m>,
}

impl<'m> Block<'m> {
    fn new(model: &'m Model, reserved: &'m Names, program: &Program, dialect: Dialect) -> Self {
        let printer = Printer {
            graph: &model.graph,
            parameters: &model.parameters,
            running: &model.running,
            dialect,
            names: names(&model.graph, model, &program.named),
            scalar: &reserved.scalar,
        };
        Self { printer }
    }

    fn items(&self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        items.iter().map(|item| self.item(fields, item)).collect()
    }

    fn item(&self, fields: &mut Fields, item: &Item) -> TokenStream {
        let printer = &self.printer;
        match item {
            Item::Let(id) => {
                let (name, value) = (&printer.names[id], printer.computation(fields, *id).tokens);
                quote!(let #name = #value;)
            }
            Item::SineCosine { argument, sine, cosine } => {
                let (sine, cosine) = (&printer.names[sine], &printer.names[cosine]);
                let argument = printer.receiver(fields, *argument);
                quote!(let (#sine, #cosine) = #argument.sin_cos();)
            }
            Item::Loop { by, sums, body } => self.repeat(fields, *by, sums, body),
            Item::Sink(Sink::Return, value) => printer.expression(fields, *value).tokens,
            Item::Sink(Sink::Update(element), value) => {
                let place = printer.place(fields, *element);
                match printer.product(*value) {
                    Some((negative, a, b)) => {
                        let (a, b) = (printer.outer_factor(fields, negative, a), printer.expression(fields, b).tokens);
                        quote!(motion.#place.fma(#a, #b);)
                    }
                    None => {
                        let value = printer.expression(fields, *value).tokens;
                        quote!(motion.#place.add(#value);)
                    }
                }
            }
            Item::Sink(Sink::Collect(element), value) => {
                let at = printer.at(fields, *element);
                self.accumulated(fields, quote!(gradient #at), *value)
            }
        }
    }

    /// `target += value`, fused where the value is a product.
    fn accumulated(&self, fields: &mut Fields, target: TokenStream, value: NodeId) -> TokenStream {
        let printer = &self.printer;
        if printer.dialect == Dialect::Generic
            && let Some((negative, a, b)) = printer.product(value)
        {
            let (a, b) = (printer.factor(fields, negative, a), printer.expression(fields, b).tokens);
            return quote!(#target = #a.fma(#b, #target););
        }
        if let Node::Neg(inner) = printer.graph.node(value)
            && !printer.names.contains_key(&value)
        {
            let value = printer.expression(fields, inner).tokens;
            return quote!(#target -= #value;);
        }
        let value = printer.expression(fields, value).tokens;
        quote!(#target += #value;)
    }

    fn repeat(
        &self,
        fields: &mut Fields,
        by: crate::graph::index::LoopId,
        sums: &[NodeId],
        body: &[Item],
    ) -> TokenStream {
        let printer = &self.printer;
        let range = printer.graph.loops.get(by);
        let index = printer.running.get(&by);
        let (from, to) = (printer.index(fields, range.from), printer.index(fields, range.to));
        let body = self.items(fields, body);
        let zero = match printer.dialect {
            Dialect::Generic => printer.lifted(quote!(0.0)),
            Dialect::Single => quote!(0.0_f64),
        };
        let names: Vec<&Ident> = sums.iter().map(|sum| &printer.names[sum]).collect();
        let additions: TokenStream = sums
            .iter()
            .map(|sum| match printer.graph.node(*sum) {
                Node::Sum(_, body) => self.accumulated(fields, printer.names[sum].to_token_stream(), body),
                _ => TokenStream::new(),
            })
            .collect();
        quote!(#(let mut #names = #zero;)* for #index in #from..#to { #body #additions })
    }
}

/// Names that say what a value is: coordinates by theirs, sums and shared subexpressions by number.
fn names(graph: &Graph, model: &Model, named: &BTreeSet<NodeId>) -> HashMap<NodeId, Ident> {
    let mut names = HashMap::new();
    let (mut sums, mut shared) = (0, 0);
    for id in named {
        let name = match graph.node(*id) {
            Node::Coordinate(element) => coordinate_name(graph, model, element),
            Node::Sum(..) => {
                sums += 1;
                Some(format!("sum_{}", sums - 1))
            }
            _ => None,
        };
        let name = name.unwrap_or_else(|| {
            shared += 1;
            format!("shared_{}", shared - 1)
        });
        names.insert(*id, format_ident!("{name}"));
    }
    names
}

/// `q0`, `p_i_1`: where the indices are numbers or running.
fn coordinate_name(graph: &Graph, model: &Model, element: Element) -> Option<String> {
    let index = |id| match graph.loops.index(id) {
        Index::Literal(value) => Some(value.to_string()),
        Index::Running(by) => model.running.get(&by).map(ToString::to_string),
        _ => None,
    };
    let letter = match element.part {
        Part::Position => "q",
        Part::Momentum => "p",
    };
    let first = index(element.index)?;
    let separator = if first.starts_with(|first: char| first.is_ascii_digit()) { "" } else { "_" };
    let second = element.component.map_or(Some(String::new()), |component| Some(format!("_{}", index(component)?)))?;
    Some(format!("{letter}{separator}{first}{second}"))
}

impl crate::model::Length {
    /// The length as Rust.
    pub(super) fn tokens(&self) -> TokenStream {
        match self {
            crate::model::Length::Literal(length) => Literal::u64_unsuffixed(*length).to_token_stream(),
            crate::model::Length::Constant(expression) => quote!({ #expression }),
        }
    }
}
