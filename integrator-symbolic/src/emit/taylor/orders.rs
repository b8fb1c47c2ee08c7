//! Rust code for the Taylor coefficients of a motion, order by order.
//!
//! One pass over the nodes computes their coefficients of an order from those of lower orders. The values that
//! recurrences read are stored in a tape: adjacent if they are outside of loops, otherwise in a list with one entry per
//! iteration.

use super::{
    accumulation::{Accumulation, derivative},
    implementation::{Kind, implementation},
    kernel::nest_context,
    line,
    orders_per_call::OrdersPerCall,
    pairs::SideBySide,
    recurrence::Series,
    second_order::InverseMasses,
    tape::{Iterations, Kept, Record, Tape},
};
use crate::{
    differentiate::Contribution,
    emit::printer::{
        expression::Printer, fields::Fields, frame::Frame, function::Body, interleaved::InterleavedIndices,
    },
    graph::{Graph, Node, NodeId},
    model::{Model, is_leaf},
    program::{Constraints, Item, Program, Sink, Store, results::Results, schedule_with},
    stencil::Stencil,
    syntax::names::Names,
    taylor::{Recurrences, inverse_masses},
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeSet, HashMap};

/// The most operations of orders that are compiled one by one, some ten times those of a pendulum. Beyond it one function
/// serves all orders.
const MOST_UNROLLED: usize = 10_000;

/// The items that hold a tape, and the implementation that computes an order.
pub(crate) struct Orders {
    /// The structs of the tape.
    pub(crate) tape: TokenStream,
    /// The items of the implementation.
    pub(crate) items: TokenStream,
}

/// The recurrences of the motion with these gradients of `T` and `V`.
pub(crate) fn orders(
    model: &mut Model,
    fields: &mut Fields,
    names: &Names,
    mut kinetic: Vec<Contribution>,
    mut potential: Vec<Contribution>,
    stencil: Option<&Stencil>,
) -> Orders {
    if let Some(orders) = stencil.and_then(|stencil| line::orders(model, fields, names, kinetic.clone(), stencil)) {
        return orders;
    }
    let recurrences = Recurrences::of(&mut model.graph, [&mut kinetic, &mut potential]);
    let constraints = constraints(&model.graph, &recurrences);
    let program = |model: &mut Model, kinetic: &[_], potential: &[_]| program(model, kinetic, potential, &constraints);
    let all = program(model, &kinetic, &potential);
    let is_long = recurrences.operations_of_all_orders(&model.graph) > MOST_UNROLLED;
    let rolled = is_long || matches!(Accumulation::of(&model.graph, &all.items), Accumulation::InPlace);
    // With an inverse mass, positions follow from momenta: they are taken out of loops, or come an order ahead.
    let (program, of_positions, second_order) = match inverse_masses(&mut model.graph, &kinetic) {
        Some(inverse_masses) if rolled => {
            (program(model, &[], &potential), Some(program(model, &inverse_masses, &[])), None)
        }
        Some(inverse_masses) => (program(model, &[], &potential), None, Some(InverseMasses::of(&inverse_masses))),
        None => (all, None, None),
    };
    let interleaved = rolled && nest_context(model, &program, &recurrences).reads_neighbours(&program.items);
    let frame = Frame::Series { interleaved: interleaved.then(|| InterleavedIndices::of(&model.graph)) };
    let source = Source { model, names, program: &program, frame: &frame, recurrences: &recurrences };
    let mut writer = Writer::new(&source, Record::of("tape", Iterations::Once));
    writer.accumulation = if rolled { Accumulation::InPlace } else { Accumulation::of(&model.graph, &program.items) };
    writer.allocate(&program.items);
    let body = match (&of_positions, &second_order) {
        (_, Some(inverse_masses)) => writer.second_order(fields, &program.items, inverse_masses),
        (Some(of_positions), None) => {
            let source = Source { program: of_positions, ..source };
            let mut of_inverse_masses = Writer::new(&source, Record::of("tape", Iterations::Once));
            of_inverse_masses.accumulation = Accumulation::InPlaceOnce;
            let inverse_masses = of_inverse_masses.items(fields, &of_positions.items);
            writer.orders_of_momenta(fields, &program.items, &inverse_masses)
        }
        (None, None) => writer.order_of_all(fields, &program.items),
    };
    finished(&writer, fields, body, of_positions.is_some())
}

/// The program that computes the gradients with these contributions.
pub(super) fn program(
    model: &mut Model,
    kinetic: &[Contribution],
    potential: &[Contribution],
    constraints: &Constraints,
) -> Program {
    let stores = stores(&mut model.graph, kinetic, potential);
    let leaf = |graph: &Graph, id| graph.node(id).is_read() || is_leaf(graph, &model.parameters, id);
    schedule_with(&model.graph, &stores, leaf, constraints)
}

/// The implementation with the lines that a writer wrote.
pub(super) fn finished(writer: &Writer<'_>, fields: &mut Fields, body: TokenStream, has_inverse_mass: bool) -> Orders {
    let Source { frame, names, .. } = writer.source;
    let interleaved = if let Frame::Series { interleaved } = frame { interleaved.as_ref() } else { None };
    let body = Body::new(body);
    let indices = interleaved.map(|indices| indices.lines(&writer.printer, fields, &body));
    let Body(body) = body;
    let body = quote!(#indices #body);
    let tape = Tape { records: &writer.records, has_inverse_mass };
    let rolled = !matches!(writer.accumulation, Accumulation::Scalars(_));
    let kind = Kind { rolled, interleaved: interleaved.is_some(), orders_per_call: writer.orders_per_call.count() };
    Orders { tape: tape.structs(names), items: implementation(body, &tape, &kind, names) }
}

/// Recurrences have lines of their own, and read the series of slopes where they stand.
pub(super) fn constraints(graph: &Graph, recurrences: &Recurrences) -> Constraints {
    let beside = |slopes: &[Option<NodeId>; 2]| slopes.iter().flatten().map(|slope| graph.signed(*slope).1).collect();
    Constraints {
        named: recurrences.kept.union(&recurrences.nonlinear).copied().collect(),
        beside: recurrences.slopes.iter().map(|(id, slopes)| (*id, beside(slopes))).collect(),
    }
}

/// The values that move coordinates.
fn stores(graph: &mut Graph, kinetic: &[Contribution], potential: &[Contribution]) -> Vec<Store> {
    let mut stores = Vec::new();
    for (gradient, is_force) in [(kinetic, false), (potential, true)] {
        stores.extend(gradient.iter().map(|Contribution { context, element, value }| {
            let value = if is_force { graph.neg(*value) } else { *value };
            Store { context: context.clone(), sink: Sink::Collect(element.partner()), value }
        }));
    }
    stores
}

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
