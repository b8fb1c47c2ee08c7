//! The Taylor coefficients of a motion, order by order, as Rust.
//!
//! One pass over the nodes computes their coefficients of an order from those of lower orders. Values that recurrences
//! read are kept in a tape: beside each other where no loop is around, and else in a list with a place for every turn.

use super::{
    expression::{Dialect, Printer},
    fields::{Fields, is_leaf},
    frame::Frame,
    function::Body,
    names::Names,
    tape::{Record, has_tape, kept, list, next, tape},
};
use crate::{
    differentiate::Contribution,
    graph::{Element, Graph, Node, NodeId, index::LoopId},
    model::Model,
    program::{Asked, Item, Placed, Sink, schedule_with},
    taylor::{Recurrences, is_power, signed},
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// The items that hold a tape, and the implementation that computes an order.
pub(super) struct Orders {
    /// The structs of the tape.
    pub(super) tape: TokenStream,
    /// The items of the implementation.
    pub(super) items: TokenStream,
}

/// The recurrences of the motion with these gradients of `T` and `V`.
pub(super) fn orders(
    model: &mut Model,
    fields: &mut Fields,
    names: &Names,
    mut kinetic: Vec<Contribution>,
    mut potential: Vec<Contribution>,
) -> Orders {
    let recurrences = Recurrences::of(&mut model.graph, [&mut kinetic, &mut potential]);
    let placed = placed(&mut model.graph, &kinetic, &potential);
    let is_read = |graph: &Graph, id| matches!(graph.node(id), Node::Coordinate(_) | Node::Time | Node::Step);
    let asked = asked(&model.graph, &recurrences);
    let parameters = &model.parameters;
    let leaf = |graph: &Graph, id| is_read(graph, id) || is_leaf(graph, parameters, id);
    let program = schedule_with(&model.graph, &placed, leaf, &asked);
    let frame = Frame::Series(model.shape.dimension.as_ref());
    let mut writer = Writer {
        printer: Printer::new(model, names, &program, Dialect::Generic, &frame),
        recurrences: &recurrences,
        masks: Vec::new(),
        records: vec![Record { at: format_ident!("tape"), slots: Vec::new() }],
        within: vec![0],
        places: HashMap::new(),
    };
    let clock = writer.clock();
    writer.allocate(&program.items);
    let body = writer.items(fields, &program.items);
    let records = writer.records;
    Orders { tape: tape(&records, names), items: implementation(quote!(#clock #body), &records, names) }
}

/// Recurrences have lines of their own, and read the series of slopes where they stand.
fn asked(graph: &Graph, recurrences: &Recurrences) -> Asked {
    let beside = |slopes: &[Option<NodeId>; 2]| slopes.iter().flatten().map(|slope| signed(graph, *slope).1).collect();
    Asked {
        named: recurrences.kept.union(&recurrences.nonlinear).copied().collect(),
        beside: recurrences.slopes.iter().map(|(id, slopes)| (*id, beside(slopes))).collect(),
    }
}

/// The values that move coordinates.
fn placed(graph: &mut Graph, kinetic: &[Contribution], potential: &[Contribution]) -> Vec<Placed> {
    let mut placed = Vec::new();
    for (gradient, is_force) in [(kinetic, false), (potential, true)] {
        for Contribution { context, element, value } in gradient {
            let value = if is_force { graph.neg(*value) } else { *value };
            let moved = Element { part: element.part.other(), ..*element };
            placed.push(Placed { context: context.clone(), sink: Sink::Collect(moved), value });
        }
    }
    placed
}

struct Writer<'m> {
    printer: Printer<'m>,
    recurrences: &'m Recurrences,
    /// The conditions around the present line.
    masks: Vec<TokenStream>,
    records: Vec<Record>,
    /// The records of the blocks around the present line, innermost last.
    within: Vec<usize>,
    /// Where the series of a value is.
    places: HashMap<NodeId, TokenStream>,
}

impl Writer<'_> {
    /// The lines that keep the time and the step, where recurrences read their series.
    fn clock(&mut self) -> TokenStream {
        let mut lines = TokenStream::new();
        for id in &self.recurrences.kept {
            let name = match self.printer.graph.node(*id) {
                Node::Time => format_ident!("time"),
                Node::Step => format_ident!("step"),
                _ => continue,
            };
            self.places.insert(*id, quote!(tape.#name));
            lines.extend(quote!(tape.#name[order] = #name;));
            self.records[0].slots.push((name, false));
        }
        lines
    }

    /// Finds places for what is kept in a block, before its lines are written: recurrences read each other.
    fn allocate(&mut self, items: &[Item]) {
        for item in items {
            let values = match item {
                Item::Let(id) | Item::Begin(id) => vec![*id],
                Item::SineCosine { sine, cosine, .. } => vec![*sine, *cosine],
                Item::Branch { body, .. } => {
                    self.allocate(body);
                    continue;
                }
                _ => continue,
            };
            for id in values {
                let is_condition = self.printer.graph.node(id).is_condition();
                if is_condition || self.recurrences.kept.contains(&id) {
                    self.slot(id, is_condition);
                }
            }
        }
    }

    fn items(&mut self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        let begun: Vec<NodeId> =
            items.iter().filter_map(|item| if let Item::Begin(id) = item { Some(*id) } else { None }).collect();
        let mut tokens = TokenStream::new();
        for item in items {
            tokens.extend(self.item(fields, item));
            // What a block adds to is complete behind the last one; until then, what is kept is written again.
            tokens.extend(begun.iter().filter(|id| makes(item, **id)).filter_map(|id| self.keep(*id)));
        }
        tokens
    }

    fn item(&mut self, fields: &mut Fields, item: &Item) -> TokenStream {
        match item {
            Item::Let(id) => self.value(fields, *id),
            Item::SineCosine { sine, cosine, .. } => {
                let (sine, cosine) = (self.value(fields, *sine), self.value(fields, *cosine));
                quote!(#sine #cosine)
            }
            Item::Begin(id) => {
                let (name, zero) = (&self.printer.names[id], self.printer.lifted(quote!(0.0)));
                quote!(let mut #name = #zero;)
            }
            Item::Loop { by, body } => self.turns(fields, *by, body),
            Item::Branch { condition, holds, body } => {
                let mask = self.printer.expression(fields, *condition).tokens;
                let mask = if *holds { mask } else { quote!(#mask.not()) };
                self.masks.push(mask.clone());
                let body = self.items(fields, body);
                self.masks.pop();
                quote!(if #mask.any() { #body })
            }
            Item::Add { sum, value } => {
                let (name, value) = (self.printer.names[sum].clone(), self.masked(fields, *value));
                quote!(#name += #value;)
            }
            Item::Choose { choice, value } => {
                let (name, scalar) = (&self.printer.names[choice], self.printer.scalar);
                let value = self.printer.expression(fields, *value).tokens;
                match self.masks.last() {
                    Some(mask) => quote!(#name = #scalar::select(#mask, #value, #name);),
                    None => quote!(#name = #value;),
                }
            }
            Item::Sink(Sink::Collect(element), value) => {
                let value = self.masked(fields, *value);
                let series = self.printer.place(fields, *element);
                quote!(#series[order + 1] += #value;)
            }
            Item::Sink(..) => TokenStream::new(),
        }
    }

    /// A value in the lanes in which all conditions hold, zero elsewhere.
    fn masked(&self, fields: &mut Fields, value: NodeId) -> TokenStream {
        let value = self.printer.expression(fields, value).tokens;
        let (scalar, zero) = (self.printer.scalar, self.printer.lifted(quote!(0.0)));
        self.masks.iter().rev().fold(value, |value, mask| quote!(#scalar::select(#mask, #value, #zero)))
    }

    /// A loop, whose turns keep what they compute each in a place of its own.
    fn turns(&mut self, fields: &mut Fields, by: LoopId, body: &[Item]) -> TokenStream {
        let number = self.records.len();
        let at = format_ident!("turn_{number}");
        self.records.push(Record { at: at.clone(), slots: Vec::new() });
        self.within.push(number);
        // What two loops over the same range both compute is kept by each.
        let outside = self.places.clone();
        self.allocate(body);
        let body = self.items(fields, body);
        self.places = outside;
        self.within.pop();
        let (range, index) = (self.printer.graph.loops.get(by), self.printer.running.get(&by));
        let (from, to) = (self.printer.bound(fields, range.from), self.printer.bound(fields, range.to));
        let turn = (!self.records[number].slots.is_empty()).then(|| {
            let (runtime, list, next) = (self.printer.runtime, list(number), next(number));
            quote!(let #at = #runtime::turn(&mut tape.#list, &mut #next);)
        });
        quote!(for #index in #from..#to { #turn #body })
    }

    /// A named value of an order, kept if a recurrence reads it.
    fn value(&mut self, fields: &mut Fields, id: NodeId) -> TokenStream {
        let name = self.printer.names[&id].clone();
        if self.printer.graph.node(id).is_condition() {
            // The branch that is taken at the point of expansion is taken for all orders.
            let (place, value) = (&self.places[&id], self.printer.computation(fields, id).tokens);
            return quote!(if order == 0 { #place = #value; } let #name = #place;);
        }
        let value = match self.recurrences.nonlinear.contains(&id) {
            true => self.recurrence(fields, id),
            false => self.printer.computation(fields, id).tokens,
        };
        let keep = self.keep(id);
        quote!(let #name = #value; #keep)
    }

    /// Finds a place for a value in the record of the block.
    fn slot(&mut self, id: NodeId, is_condition: bool) {
        let name = &self.printer.names[&id];
        let record = &mut self.records[self.within[self.within.len() - 1]];
        record.slots.push((name.clone(), is_condition));
        let at = &record.at;
        self.places.insert(id, quote!(#at.#name));
    }

    /// The line that keeps a coefficient, where recurrences read it.
    fn keep(&self, id: NodeId) -> Option<TokenStream> {
        let name = &self.printer.names[&id];
        let place = self.places.get(&id).filter(|_| self.recurrences.kept.contains(&id))?;
        Some(quote!(#place[order] = #name;))
    }

    /// A series that is read whole, and whether its sign is changed.
    fn series(&self, fields: &mut Fields, id: NodeId) -> (bool, TokenStream) {
        let (negative, id) = signed(self.printer.graph, id);
        let place = match self.printer.graph.node(id) {
            Node::Coordinate(element) => self.printer.place(fields, element),
            _ => self.places.get(&id).cloned().unwrap_or_default(),
        };
        (negative, quote!(&#place))
    }

    /// The coefficient of an order of a node that is not linear in its children.
    fn recurrence(&self, fields: &mut Fields, id: NodeId) -> TokenStream {
        let (printer, runtime) = (&self.printer, self.printer.runtime);
        let sign = |negative: bool| negative.then(|| quote!(-));
        let node = printer.graph.node(id);
        let own = self.series(fields, id).1;
        match node {
            Node::Mul(a, b) => {
                let ((minus_a, a), (minus_b, b)) = (self.series(fields, a), self.series(fields, b));
                let sign = sign(minus_a != minus_b);
                quote!(#sign #runtime::product(#a, #b, order))
            }
            Node::Power(a, 4) => {
                let (_, a) = self.series(fields, a);
                quote!(#runtime::square(#a, order))
            }
            Node::Div(a, b) => {
                let numerator = printer.expression(fields, a).tokens;
                let (negative, b) = self.series(fields, b);
                let sign = sign(negative);
                quote!(#sign #runtime::quotient(#numerator, #own, #b, order))
            }
            Node::Power(a, halves) if self.recurrences.slopes[&id] == [None, None] => {
                let (_, base) = self.series(fields, a);
                let (first, halves) = (printer.expression(fields, a).tokens, Literal::i32_unsuffixed(halves));
                quote!(if order == 0 { #runtime::half_power(#first, #halves) } else { #runtime::power(#own, #base, #halves, order) })
            }
            Node::Binary(function, a, b) if is_power(function) => {
                let (_, base) = self.series(fields, a);
                let (first, exponent) = (printer.expression(fields, a).tokens, printer.expression(fields, b).tokens);
                quote!(if order == 0 { #first.powf(#exponent) } else { #runtime::real_power(#own, #base, #exponent, order) })
            }
            _ => {
                let first = match node {
                    Node::Power(a, halves) => {
                        let (first, halves) = (printer.expression(fields, a).tokens, Literal::i32_unsuffixed(halves));
                        quote!(#runtime::half_power(#first, #halves))
                    }
                    _ => printer.computation(fields, id).tokens,
                };
                let slopes = self.recurrences.slopes[&id];
                let mut terms = TokenStream::new();
                for (x, slope) in node.children().zip(slopes).filter_map(|(x, slope)| Some((x, slope?))) {
                    let ((minus_x, x), (minus_slope, slope)) = (self.series(fields, x), self.series(fields, slope));
                    let sign = match (minus_x == minus_slope, terms.is_empty()) {
                        (true, true) => None,
                        (true, false) => Some(quote!(+)),
                        (false, _) => Some(quote!(-)),
                    };
                    terms.extend(quote!(#sign #runtime::chain(#x, #slope, order)));
                }
                // A function without a slope, such as the sign, stays what it is.
                let terms = if terms.is_empty() { printer.lifted(quote!(0.0)) } else { terms };
                quote!(if order == 0 { #first } else { #terms })
            }
        }
    }
}

/// Whether a block adds to a sum or makes a choice.
fn makes(item: &Item, id: NodeId) -> bool {
    match item {
        Item::Add { sum: made, .. } | Item::Choose { choice: made, .. } => *made == id,
        Item::Loop { body, .. } | Item::Branch { body, .. } => body.iter().any(|item| makes(item, id)),
        _ => false,
    }
}

fn implementation(body: TokenStream, records: &[Record], names: &Names) -> TokenStream {
    let Names { runtime, scalar, tape, .. } = names;
    let tape = if has_tape(records) { quote!(#tape<#scalar>) } else { quote!(()) };
    let body = Body::new(body);
    let clock = (body.mentions("step") || body.mentions("time"))
        .then(|| quote!(let (step, time) = #runtime::order_of_time::<#scalar>(order, time);));
    let time = Ident::new(if clock.is_some() { "time" } else { "_time" }, Span::call_site());
    let [parameters, length] = ["parameters", "length"].map(|name| body.argument(name));
    let body = &body.0;
    let counters = kept(records).map(|number| {
        let next = next(number);
        quote!(let mut #next = 0;)
    });
    quote! {
        type Tape<#scalar: #runtime::Real> = #tape;

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<#scalar: #runtime::Real>(
            #parameters: &Self::Parameters<#scalar>,
            #length: usize,
            q: &mut [#runtime::Series<#scalar>],
            p: &mut [#runtime::Series<#scalar>],
            tape: &mut Self::Tape<#scalar>,
            order: usize,
            #time: f64,
        ) {
            #clock
            #(#counters)*
            #body
        }
    }
}
