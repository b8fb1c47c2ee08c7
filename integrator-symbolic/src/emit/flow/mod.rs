//! Flows and energies as Rust.

pub(super) mod bodies;
pub(super) mod constants;
pub(super) mod force_gradient;
pub(super) mod form;
#[cfg(test)]
mod guarded;
pub(super) mod lattice;
pub(super) mod pairs;
pub(super) mod pieces;
pub(super) mod stated;
pub(super) mod texts;

use crate::{
    differentiate::{Contribution, folded},
    emit::printer::{
        block::Block,
        expression::{Dialect, Printer},
        fields::{Fields, is_leaf, lowered},
        frame::Frame,
        function::Body,
        names::Names,
    },
    graph::{Element, Node, NodeId, Part, index::LoopId},
    model::{Length, Model, Shape},
    program::{Item, Placed, Sink, is_direct, is_protected, schedule},
};
use lattice::Sweep;
use proc_macro2::TokenStream;
use quote::quote;

/// The body of a flow: each component of the gradient moves its coordinate.
///
/// Where all sites of a lattice take part alike, the runtime sweeps along them. Where every coordinate gets one
/// contribution, it is updated on the spot; else contributions are collected first.
pub(crate) fn flow(
    model: &mut Model,
    fields: &mut Fields,
    names: &Names,
    gradient: &[Contribution],
    part: Part,
) -> (TokenStream, Option<Sweep>) {
    if gradient.is_empty() {
        return (TokenStream::new(), None);
    }
    let folded = folded(&mut model.graph, gradient);
    // What is moved behind a condition that it is there is not moved by a choice of zero elsewhere.
    let apart = gradient.iter().any(|contribution| is_protected(&mut model.graph, contribution));
    if !apart && let Some(sweep) = lattice::sweep(model, fields, names, &folded, part) {
        return (sweep.flow(), Some(sweep));
    }
    let direct = !apart && is_direct(&model.graph.loops, &folded);
    let gradient = if direct { &folded[..] } else { gradient };
    let placed = placed(model, gradient, if direct { Sink::Update } else { Sink::Collect });
    let scalar = &names.scalar;
    let body = Body::new(updates(model, fields, names, &placed));
    let (read, body) = (body.time(scalar), &body.0);
    let duration = match part {
        Part::Momentum => quote!(duration),
        Part::Position => quote!(-duration),
    };
    (quote!(#read let step = #scalar::of(#duration); #body), None)
}

/// Where the components of a gradient go; what updates a coordinate is multiplied by the step.
pub(crate) fn placed(model: &mut Model, gradient: &[Contribution], sink: fn(Element) -> Sink) -> Vec<Placed> {
    let placed = |contribution: &Contribution| {
        let element = contribution.element;
        sink(element.partner())
    };
    let mut value = |contribution: &Contribution| match placed(contribution) {
        Sink::Update(_) => model.graph.stepped(contribution.value),
        _ => contribution.value,
    };
    let values: Vec<NodeId> = gradient.iter().map(&mut value).collect();
    let conditions = gradient.iter().flat_map(Contribution::conditions);
    let roots: Vec<NodeId> = values.iter().copied().chain(conditions).collect();
    let lowered = lowered(model, &roots);
    let of = |id: NodeId| roots.iter().position(|root| *root == id).map_or(id, |position| lowered[position]);
    let placed = gradient.iter().zip(values).map(|(contribution, value)| Placed {
        context: contribution.around(of),
        sink: placed(contribution),
        value: of(value),
    });
    placed.collect()
}

/// The body of a function that returns `root`, which is lowered.
pub(crate) fn value(model: &Model, fields: &mut Fields, names: &Names, root: NodeId, dialect: Dialect) -> TokenStream {
    let placed = [Placed { context: Vec::new(), sink: Sink::Return, value: root }];
    let program = match dialect {
        Dialect::Generic => schedule(&model.graph, &placed, |graph, id| is_leaf(graph, &model.parameters, id)),
        Dialect::Single => schedule(&model.graph, &placed, |graph, id| {
            matches!(graph.node(id), Node::Constant(_) | Node::FromIndex(_) | Node::Parameter(_))
        }),
    };
    let body = Block::new(model, names, &program, dialect, &Frame::Motion).items(fields, &program.items);
    match dialect {
        Dialect::Generic => body,
        Dialect::Single if program.items.len() > 1 => quote!({ #body }),
        Dialect::Single => body,
    }
}

/// The body of a flow: the lowered updates of the coordinates, each in its loops.
fn updates(model: &Model, fields: &mut Fields, names: &Names, placed: &[Placed]) -> TokenStream {
    let program = schedule(&model.graph, placed, |graph, id| is_leaf(graph, &model.parameters, id));
    let mut block = Block::new(model, names, &program, Dialect::Generic, &Frame::Motion);
    let body = block.items(fields, &program.items);
    let Some(element) = placed.iter().find_map(|placed| match placed.sink {
        Sink::Collect(element) => Some(element),
        _ => None,
    }) else {
        return body;
    };
    let (open, close) =
        buffer(&model.shape, element.part, &block.printer, |place, value| quote!(#place.fma(step, #value);));
    quote!(#open #body #close)
}

/// The lines of a block, with those of a loop in its place.
fn unwrapped(items: Vec<Item>, around: LoopId) -> Vec<Item> {
    let lines = items.into_iter().flat_map(|item| match item {
        Item::Loop { by, body } if by == around => body,
        other => vec![other],
    });
    lines.collect()
}

/// The most elements that a buffer has on the stack; a longer one, or one of a length known at run time, is on the heap.
const SMALL: u64 = 4096;

/// A buffer for the gradient, and its application to each of the coordinates of `part`.
fn buffer(
    shape: &Shape,
    part: Part,
    printer: &Printer<'_>,
    apply: impl Fn(TokenStream, TokenStream) -> TokenStream,
) -> (TokenStream, TokenStream) {
    let (zero, runtime) = (printer.lifted(quote!(0.0)), printer.runtime);
    let coordinates = match part {
        Part::Position => quote!(q),
        Part::Momentum => quote!(p),
    };
    let dimension = shape.dimension.as_ref().map(Length::tokens);
    let element = dimension.as_ref().map_or(zero.clone(), |dimension| quote!([#zero; #dimension]));
    let length = shape.length.tokens();
    let on_stack = match shape.length {
        Length::Literal(length) => length <= SMALL,
        Length::Constant(_) => true,
        Length::OfStart => false,
    };
    let open = if on_stack {
        quote!(let mut gradient = [#element; #length];)
    } else {
        quote!(let mut gradient = #runtime::table(#length, &|_| #element);)
    };
    let at = |indices: TokenStream| apply(quote!(motion.#coordinates #indices), quote!(gradient #indices));
    let close = match dimension {
        None => {
            let application = at(quote!([i]));
            quote!(for i in 0..#length { #application })
        }
        Some(dimension) => {
            let application = at(quote!([i][d]));
            quote!(for i in 0..#length { for d in 0..#dimension { #application } })
        }
    };
    (open, close)
}
