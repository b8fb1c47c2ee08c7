//! Blocks as Rust: lets, loops, and where values go.

use super::{
    expression::{Dialect, Printer},
    fields::{Fields, is_leaf},
    frame::Frame,
    lattice,
    names::Names,
};
use crate::{
    gather::Gathered,
    graph::{
        Element, Graph, Node, NodeId, Part,
        index::{Index, LoopId},
    },
    lower::lower,
    model::{Length, Model, Shape, integer::operand},
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
    let body = Block::new(model, names, &program, dialect, &Frame::Motion).items(fields, &program.items);
    match dialect {
        Dialect::Generic => body,
        Dialect::Single if program.items.len() > 1 => quote!({ #body }),
        Dialect::Single => body,
    }
}

/// The body of a flow: the lowered updates of the coordinates, each in its loops.
pub(super) fn flow(model: &Model, fields: &mut Fields, names: &Names, placed: &[Placed]) -> TokenStream {
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

/// The body of a function that returns what the sites of a lattice share out.
pub(super) fn shares(model: &Model, fields: &mut Fields, names: &Names, gathered: &Gathered) -> TokenStream {
    let placed = lattice::placed(gathered);
    let program = schedule(&model.graph, &placed, |graph, id| is_leaf(graph, &model.parameters, id));
    let frame = Frame::Sites(gathered);
    let mut block = Block::new(model, names, &program, Dialect::Generic, &frame);
    // The runtime goes from site to site.
    let items = gathered.directions.iter().fold(program.items, |items, along| unwrapped(items, along.place));
    let body = block.items(fields, &items);
    let shares = block.printer.shares(gathered);
    quote!(#body [#(#shares),*])
}

/// The body of a function that replaces the coordinates of `part`: nothing is written before all is read.
pub(super) fn replacement(
    model: &Model,
    fields: &mut Fields,
    names: &Names,
    part: Part,
    placed: &[Placed],
) -> TokenStream {
    let program = schedule(&model.graph, placed, |graph, id| is_leaf(graph, &model.parameters, id));
    let mut block = Block::new(model, names, &program, Dialect::Generic, &Frame::Motion);
    let body = block.items(fields, &program.items);
    let (open, close) = buffer(&model.shape, part, &block.printer, |place, value| quote!(#place = #value;));
    quote!(#open #body #close)
}

/// The body of a function of bodies that are its arguments: the lowered updates or components, in the loops over
/// `around`, which are not written, and their own.
pub(super) fn of_bodies(
    model: &Model,
    fields: &mut Fields,
    names: &Names,
    frame: &Frame<'_>,
    around: &[LoopId],
    placed: &[Placed],
) -> TokenStream {
    // The coordinates are numbers already.
    let is_read = |graph: &Graph, id| matches!(graph.node(id), Node::Coordinate(_));
    let program =
        schedule(&model.graph, placed, |graph, id| is_read(graph, id) || is_leaf(graph, &model.parameters, id));
    let mut block = Block::new(model, names, &program, Dialect::Generic, frame);
    let items = around.iter().fold(program.items, |items, by| unwrapped(items, *by));
    block.items(fields, &items)
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

/// Values for `roots` without powers, whose prepared constants are left alone.
pub(super) fn lowered(model: &mut Model, roots: &[NodeId]) -> Vec<NodeId> {
    let Model { graph, parameters, .. } = model;
    lower(graph, roots, |graph, id| is_leaf(graph, parameters, id))
}

/// A block being printed.
struct Block<'m> {
    printer: Printer<'m>,
    /// The conditions around the present line, as masks, outermost first.
    masks: Vec<TokenStream>,
    /// How many conditions were around the beginning of a sum or a choice.
    begun: HashMap<NodeId, usize>,
}

impl<'m> Printer<'m> {
    /// What prints the expressions of a program.
    pub(super) fn new(
        model: &'m Model,
        reserved: &'m Names,
        program: &Program,
        dialect: Dialect,
        frame: &'m Frame,
    ) -> Self {
        Self {
            graph: &model.graph,
            parameters: &model.parameters,
            running: &model.running,
            dialect,
            names: names(&model.graph, model, &program.named),
            scalar: frame.scalar(reserved),
            runtime: &reserved.runtime,
            externals: &model.externals,
            functions: model.functions,
            frame,
        }
    }
}

impl<'m> Block<'m> {
    fn new(model: &'m Model, reserved: &'m Names, program: &Program, dialect: Dialect, frame: &'m Frame) -> Self {
        let printer = Printer::new(model, reserved, program, dialect, frame);
        Self { printer, masks: Vec::new(), begun: HashMap::new() }
    }

    fn items(&mut self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        items.iter().map(|item| self.item(fields, item)).collect()
    }

    fn item(&mut self, fields: &mut Fields, item: &Item) -> TokenStream {
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
            Item::Begin(id) => {
                self.begun.insert(*id, self.masks.len());
                let (name, zero) = (&printer.names[id], self.zero());
                quote!(let mut #name = #zero;)
            }
            Item::Loop { by, body } => {
                let body = self.items(fields, body);
                self.printer.looped(fields, *by, &body)
            }
            Item::Branch { condition, holds, body } => self.branch(fields, *condition, *holds, body),
            Item::Add { sum, value } => {
                let (name, depth) = (printer.names[sum].to_token_stream(), self.begun.get(sum).copied());
                self.accumulated(fields, name, *value, depth.unwrap_or_default())
            }
            Item::Choose { choice, value } => {
                let (name, value) = (&printer.names[choice], printer.expression(fields, *value).tokens);
                let chosen = self.masked(self.begun.get(choice).copied().unwrap_or_default(), &value, &quote!(#name));
                quote!(#name = #chosen;)
            }
            Item::Sink(Sink::Share(share), value) => {
                let value = printer.expression(fields, *value).tokens;
                printer.share(fields, *share, value)
            }
            Item::Sink(Sink::Return, value) => printer.expression(fields, *value).tokens,
            Item::Sink(Sink::Update(element), value) => self.updated(fields, *element, *value),
            Item::Sink(Sink::Collect(element), value) => {
                let at = printer.at(fields, *element);
                self.accumulated(fields, quote!(gradient #at), *value, 0)
            }
            Item::Sink(Sink::Assign(element), value) => {
                let (at, value) = (printer.at(fields, *element), printer.expression(fields, *value).tokens);
                quote!(gradient #at = #value;)
            }
        }
    }

    fn zero(&self) -> TokenStream {
        match self.printer.dialect {
            Dialect::Generic => self.printer.lifted(quote!(0.0)),
            Dialect::Single => quote!(0.0_f64),
        }
    }

    /// A block that is skipped where no lane needs it.
    fn branch(&mut self, fields: &mut Fields, condition: NodeId, holds: bool, body: &[Item]) -> TokenStream {
        let mask = self.printer.expression(fields, condition).tokens;
        let generic = self.printer.dialect == Dialect::Generic;
        let mask = match (holds, generic) {
            (true, _) => mask,
            (false, true) => quote!(#mask.not()),
            (false, false) => quote!(!#mask),
        };
        self.masks.push(mask.clone());
        let body = self.items(fields, body);
        self.masks.pop();
        match (body.is_empty(), generic) {
            (true, _) => TokenStream::new(),
            (false, true) => quote!(if #mask.any() { #body }),
            (false, false) => quote!(if #mask { #body }),
        }
    }

    /// `value` in the lanes in which all conditions beyond the first `depth` hold, `other` elsewhere.
    fn masked(&self, depth: usize, value: &TokenStream, other: &TokenStream) -> TokenStream {
        let mut masks = self.masks[depth..].iter();
        match (masks.next(), self.printer.dialect) {
            (Some(first), Dialect::Generic) => {
                let scalar = self.printer.scalar;
                quote!(#scalar::select(#first #(.and(#masks))*, #value, #other))
            }
            _ => value.clone(),
        }
    }

    /// A coordinate's update. Under a condition it is an addition, so that lanes that do not take part add zero.
    fn updated(&self, fields: &mut Fields, element: Element, value: NodeId) -> TokenStream {
        let printer = &self.printer;
        let place = printer.place(fields, element);
        match printer.product(value) {
            Some((negative, a, b)) if self.masks.is_empty() => {
                let (a, b) = (printer.outer_factor(fields, negative, a), printer.expression(fields, b).tokens);
                quote!(#place.fma(#a, #b);)
            }
            _ => {
                let value = self.masked(0, &printer.expression(fields, value).tokens, &self.zero());
                quote!(#place.add(#value);)
            }
        }
    }

    /// `target += value`, fused where the value is a product, in the lanes in which all conditions beyond `depth` hold.
    fn accumulated(&self, fields: &mut Fields, target: TokenStream, value: NodeId, depth: usize) -> TokenStream {
        let printer = &self.printer;
        let is_masked = self.masks.len() > depth && printer.dialect == Dialect::Generic;
        if printer.dialect == Dialect::Generic
            && let Some((negative, a, b)) = printer.product(value)
        {
            let (a, b) = (printer.factor(fields, negative, a), printer.expression(fields, b).tokens);
            let sum = self.masked(depth, &quote!(#a.fma(#b, #target)), &target);
            return quote!(#target = #sum;);
        }
        let (sign, value) = match printer.graph.node(value) {
            Node::Neg(inner) if !printer.names.contains_key(&value) => (quote!(-), inner),
            _ => (quote!(+), value),
        };
        let value = printer.expression(fields, value);
        if is_masked {
            let value = value.term();
            let sum = self.masked(depth, &quote!(#target #sign #value), &target);
            return quote!(#target = #sum;);
        }
        let value = value.tokens;
        let operator = if sign.to_string() == "-" { quote!(-=) } else { quote!(+=) };
        quote!(#target #operator #value;)
    }
}

/// Names that say what a value is: coordinates by theirs, sums and shared subexpressions by number.
fn names(graph: &Graph, model: &Model, named: &BTreeSet<NodeId>) -> HashMap<NodeId, Ident> {
    let mut names = HashMap::new();
    let mut counts: HashMap<&str, u32> = HashMap::new();
    for id in named {
        let kind = match graph.node(*id) {
            Node::Sum(..) => "sum",
            Node::Select(..) => "choice",
            node if node.is_condition() => "condition",
            _ => "shared",
        };
        let coordinate = match graph.node(*id) {
            Node::Coordinate(element) => coordinate_name(graph, model, element),
            _ => None,
        };
        let name = coordinate.unwrap_or_else(|| {
            let count = counts.entry(kind).or_default();
            *count += 1;
            format!("{kind}_{}", *count - 1)
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

impl Length {
    /// The length as Rust.
    pub(super) fn tokens(&self) -> TokenStream {
        match self {
            Length::Literal(length) => Literal::u64_unsuffixed(*length).to_token_stream(),
            Length::Constant(expression) => operand(expression.to_token_stream()),
            Length::OfStart => quote!(motion.q.len()),
        }
    }
}
