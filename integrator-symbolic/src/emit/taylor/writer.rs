//! The lines of recurrences, item by item, and the records of the tape in which they keep coefficients.

use super::{
    accumulation::{Accumulation, derivative},
    pairs::SideBySide,
    tape::{Kept, OrdersPerCall, Record, Series},
};
use crate::{
    emit::printer::{expression::Printer, fields::Fields, frame::Frame},
    graph::{Node, NodeId},
    model::Model,
    program::{Item, Program, Sink, results::Results},
    syntax::names::Names,
    taylor::Recurrences,
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeSet, HashMap};

/// The source of the lines.
pub(super) struct Source<'m> {
    pub(super) model: &'m Model,
    pub(super) names: &'m Names,
    pub(super) program: &'m Program,
    pub(super) frame: &'m Frame<'m>,
    pub(super) recurrences: &'m Recurrences,
}

/// Writes the lines of a function.
pub(super) struct Writer<'m> {
    pub(super) source: &'m Source<'m>,
    pub(super) printer: Printer<'m>,
    /// The conditions around the present line.
    pub(super) masks: Vec<TokenStream>,
    /// The records of all blocks; the first one is that of the function.
    pub(super) records: Vec<Record>,
    /// The records of the blocks around the present line, innermost last.
    pub(super) within: Vec<usize>,
    /// The series of values.
    pub(super) series_of: HashMap<NodeId, Series>,
    /// The series of coordinates and the time, which all blocks read.
    begun: HashMap<NodeId, Series>,
    /// The lines that keep what the function begins with, where recurrences read its series.
    pub(super) opening: TokenStream,
    pub(super) accumulation: Accumulation,
    /// The number of orders that the lines compute.
    pub(super) orders_per_call: OrdersPerCall,
    /// The values whose sums over what is known are those of two orders.
    pub(super) of_two: BTreeSet<NodeId>,
    /// The coefficients of the derivatives of values.
    pub(super) rates: Vec<(NodeId, Series)>,
    /// The coefficients that the present block keeps as pairs.
    pub(super) side_by_side: Vec<SideBySide>,
    /// The values that the lines so far compute.
    pub(super) computed: BTreeSet<NodeId>,
}

impl<'m> Writer<'m> {
    pub(super) fn new(source: &'m Source<'m>, record: Record) -> Self {
        let Source { model, names, program, frame, .. } = source;
        Self {
            source,
            printer: Printer::new(model, names, program, frame),
            masks: Vec::new(),
            records: vec![record],
            within: vec![0],
            series_of: HashMap::new(),
            begun: HashMap::new(),
            opening: TokenStream::new(),
            accumulation: Accumulation::InPlace,
            orders_per_call: OrdersPerCall::One,
            of_two: BTreeSet::new(),
            rates: Vec::new(),
            side_by_side: Vec::new(),
            computed: BTreeSet::new(),
        }
    }

    /// A writer of iterations that share vectors.
    pub(super) fn in_lanes(source: &'m Source<'m>, record: Record) -> Self {
        let mut writer = Self::new(source, record);
        writer.printer.scalar = &source.names.wide;
        writer.accumulation = Accumulation::Lanes(Results::default());
        writer
    }

    /// Allocates slots for the values of a block, before its lines are written: recurrences read each other.
    pub(super) fn allocate<'i>(&mut self, items: impl IntoIterator<Item = &'i Item>) {
        for item in items {
            if let Item::Branch { body, .. } = item {
                self.allocate(body);
            }
            let begun = if let Item::Begin(id) = item { Some(*id) } else { None };
            for id in item.named().chain(begun) {
                if self.is_given(id) {
                    continue;
                }
                let is_condition = self.printer.graph.node(id).is_condition();
                if is_condition || self.source.recurrences.kept.contains(&id) {
                    self.slot(id, is_condition);
                }
                self.allocate_rates(id);
            }
        }
    }

    pub(super) fn items<'i>(
        &mut self,
        fields: &mut Fields,
        items: impl IntoIterator<Item = &'i Item> + Clone,
    ) -> TokenStream {
        let begin = |item: &Item| if let Item::Begin(id) = item { Some(*id) } else { None };
        let begun: Vec<NodeId> = items.clone().into_iter().filter_map(begin).collect();
        let around = std::mem::take(&mut self.side_by_side);
        let mut tokens = self.known(fields, items.clone());
        for item in items {
            tokens.extend(self.item(fields, item));
            // A sum is complete after the last block that adds to it; each of them stores it again.
            for id in begun.iter().filter(|id| makes(item, **id)) {
                tokens.extend(self.keep(fields, *id));
            }
        }
        self.side_by_side = around;
        tokens
    }

    fn item(&mut self, fields: &mut Fields, item: &Item) -> TokenStream {
        match item {
            Item::Let(_) | Item::SineCosine { .. } => item.named().map(|id| self.value(fields, id)).collect(),
            Item::Begin(id) => {
                let (name, zero) = (&self.printer.names[id], self.printer.lift(quote!(0.0)));
                quote!(let mut #name = #zero;)
            }
            Item::Loop { by, body } => match self.nests(*by, body) {
                Some(nests) => nests.iter().map(|nest| self.nest(fields, nest)).collect(),
                None => self.iterations(fields, *by, body),
            },
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
            Item::Sink(Sink::Collect(element), id) => {
                if let Accumulation::Lanes(results) = &mut self.accumulation {
                    let Some(number) = results.push(self.printer.graph, *id, self.masks.is_empty()) else {
                        return TokenStream::new();
                    };
                    let number = Literal::usize_unsuffixed(number);
                    let value = self.masked(fields, self.printer.graph.signed(*id).1);
                    return match self.orders_per_call {
                        OrdersPerCall::One => quote!(results[#number] = [#value];),
                        OrdersPerCall::Two => quote!(results[#number][at] = #value;),
                    };
                }
                let value = self.masked(fields, *id);
                if let Accumulation::Scalars(elements) = &self.accumulation {
                    let derivative = derivative(elements.iter().position(|known| known == element).unwrap_or_default());
                    return quote!(#derivative += #value;);
                }
                let (part, place) = (self.printer.part(*element), self.printer.in_row(fields, *element));
                quote!(#part[order + 1][#place] += #value;)
            }
            Item::Sink(..) => TokenStream::new(),
        }
    }

    /// A value in the lanes in which all conditions hold, zero elsewhere.
    fn masked(&self, fields: &mut Fields, value: NodeId) -> TokenStream {
        let value = self.printer.expression(fields, value).tokens;
        let (scalar, zero) = (self.printer.scalar, self.printer.lift(quote!(0.0)));
        self.masks.iter().rev().fold(value, |value, mask| quote!(#scalar::select(#mask, #value, #zero)))
    }

    /// Whether a value is an argument of iterations that share vectors, since it stays the same in a run.
    fn is_given(&self, id: NodeId) -> bool {
        matches!(self.accumulation, Accumulation::Lanes(_)) && self.printer.graph.is_prepared(id)
    }

    /// A named value of an order, kept if a recurrence reads it.
    fn value(&mut self, fields: &mut Fields, id: NodeId) -> TokenStream {
        let name = self.printer.names[&id].clone();
        if self.is_given(id) {
            return TokenStream::new();
        }
        if self.printer.graph.node(id).is_condition() {
            // The branch that is taken at the point of expansion is taken for all orders.
            let value = self.printer.computation(fields, id).tokens;
            let at = &self.record().at;
            return quote!(if order == 0 { #at.#name = #value; } let #name = #at.#name;);
        }
        let value = match self.source.recurrences.nonlinear.contains(&id) {
            true => self.recurrence(fields, id),
            false => self.printer.computation(fields, id).tokens,
        };
        let keep = self.keep(fields, id);
        quote!(let #name = #value; #keep)
    }

    /// Allocates a slot for a value in the record of the block.
    fn slot(&mut self, id: NodeId, is_condition: bool) {
        let name = self.printer.names[&id].clone();
        let record = self.record();
        record.keep(name.clone(), if is_condition { Kept::Condition } else { Kept::Series });
        let series = Series::Kept { at: record.at.clone(), name };
        self.series_of.insert(id, series);
    }

    /// The lines that keep a coefficient, where recurrences read it.
    fn keep(&mut self, fields: &mut Fields, id: NodeId) -> Option<TokenStream> {
        let name = &self.printer.names[&id];
        let series = self.series_of.get(&id).filter(|_| self.source.recurrences.kept.contains(&id))?;
        let (coefficient, rate) = (series.of(&quote!(order)), self.keep_rate(id));
        let own = quote!(#coefficient = #name; #rate);
        let pairs = self.keep_side_by_side(fields, id);
        Some(quote!(#own #pairs))
    }

    /// Whether a value has a recurrence of its own.
    pub(super) fn is_nonlinear(&self, id: NodeId) -> bool {
        self.source.recurrences.nonlinear.contains(&id) && !self.is_given(id)
    }

    /// The record of the current block.
    pub(super) fn record(&mut self) -> &mut Record {
        &mut self.records[self.within[self.within.len() - 1]]
    }

    /// The coefficients of a value.
    pub(super) fn series(&mut self, fields: &mut Fields, id: NodeId) -> Series {
        match (self.printer.graph.node(id), &self.accumulation) {
            (
                Node::Coordinate(element),
                Accumulation::Scalars(_) | Accumulation::InPlace | Accumulation::InPlaceOnce,
            ) => Series::Row { part: self.printer.part(element), place: self.printer.in_row(fields, element) },
            (Node::Coordinate(_) | Node::Time | Node::Step, _) => self.begun_with(fields, id),
            _ => match self.series_of.get(&id) {
                Some(series) => series.clone(),
                // No recurrence reads this one.
                None => Series::Kept { at: format_ident!("tape"), name: self.printer.names[&id].clone() },
            },
        }
    }

    /// The series of a coordinate or of the time.
    fn begun_with(&mut self, fields: &mut Fields, id: NodeId) -> Series {
        if let Some(series) = self.begun.get(&id) {
            return series.clone();
        }
        let value = self.printer.expression(fields, id).tokens;
        let name = Ident::new(&value.to_string(), Span::call_site());
        let record = &mut self.records[0];
        record.keep(name.clone(), Kept::Series);
        let series = Series::Kept { at: record.at.clone(), name };
        let coefficient = series.of(&quote!(order));
        self.opening.extend(quote!(#coefficient = #value;));
        self.begun.insert(id, series.clone());
        series
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
