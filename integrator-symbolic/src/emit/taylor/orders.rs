//! The Taylor coefficients of a motion, order by order, as Rust.
//!
//! One pass over the nodes computes their coefficients of an order from those of lower orders. Values that recurrences
//! read are kept in a tape: beside each other where no loop is around, and else in a list with a place for every
//! iteration.

use super::{
    ahead::Mobilities,
    implementation::{Kind, implementation},
    moves::{Found, Moves, next},
    nest::nest_context,
    pass::Pass,
    recurrence::Series,
    tape::{Iterations, Kept, Record, Tape},
};
use crate::{
    differentiate::Contribution,
    emit::printer::{
        expression::Printer,
        fields::{Fields, is_leaf},
        frame::Frame,
        function::Body,
        names::Names,
        places::Places,
    },
    graph::{Graph, Node, NodeId},
    model::Model,
    program::{Constraints, Item, Program, Sink, Store, schedule_with},
    taylor::{Recurrences, mobilities, signed},
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeSet, HashMap};

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
) -> Orders {
    let recurrences = Recurrences::of(&mut model.graph, [&mut kinetic, &mut potential]);
    let constraints = constraints(&model.graph, &recurrences);
    let program = |model: &mut Model, kinetic: &[Contribution], potential: &[Contribution]| {
        let stores = stores(&mut model.graph, kinetic, potential);
        let is_read =
            |graph: &Graph, id| matches!(graph.node(id), Node::Coordinate(_) | Node::Time | Node::Middle | Node::Step);
        let leaf = |graph: &Graph, id| is_read(graph, id) || is_leaf(graph, &model.parameters, id);
        schedule_with(&model.graph, &stores, leaf, &constraints)
    };
    let all = program(model, &kinetic, &potential);
    let rolled = matches!(Moves::of(&model.graph, &all.items), Moves::InPlace);
    // Positions that merely follow momenta are found from these: they are taken out of loops, and come an order ahead.
    let (program, mobile, ahead) = match mobilities(&mut model.graph, &kinetic) {
        Some(mobilities) if rolled => (program(model, &[], &potential), Some(program(model, &mobilities, &[])), None),
        Some(mobilities) => (program(model, &[], &potential), None, Some(Mobilities::of(&mobilities))),
        None => (all, None, None),
    };
    let interleaved = rolled && nest_context(model, &program, &recurrences).reads_neighbours(&program.items);
    let frame = Frame::Series { interleaved: interleaved.then(|| Places::of(&model.graph)) };
    let source = Source { model, names, program: &program, frame: &frame, recurrences: &recurrences };
    let mut writer = Writer::new(&source, Record::of("tape", Iterations::Once));
    writer.moves = if rolled { Moves::InPlace } else { Moves::of(&model.graph, &program.items) };
    writer.allocate(&program.items);
    let body = match (&mobile, &ahead) {
        (_, Some(ahead)) => writer.order_ahead(fields, &program.items, ahead),
        (Some(mobile), None) => {
            let source = Source { program: mobile, ..source };
            let mut of_mobilities = Writer::new(&source, Record::of("tape", Iterations::Once));
            of_mobilities.moves = Moves::Once;
            let mobilities = of_mobilities.items(fields, &mobile.items);
            writer.orders_of_momenta(fields, &program.items, &mobilities)
        }
        (None, None) => writer.order_of_all(fields, &program.items),
    };
    let body = match &frame {
        Frame::Series { interleaved: Some(places) } => {
            let body = Body::new(body);
            let found = places.found(&writer.printer, fields, &body);
            let Body(body) = body;
            quote!(#found #body)
        }
        _ => body,
    };
    let body = Body::new(body);
    let halfway = body.mentions("halfway").then(|| {
        let (scalar, middle) = (&names.scalar, fields.middle());
        quote!(let halfway = if order == 0 { parameters.#middle } else { #scalar::of(0.0) };)
    });
    let Body(body) = body;
    let body = quote!(#halfway #body);
    let tape = Tape { records: &writer.records, is_mobile: mobile.is_some() };
    let kind = Kind { rolled, interleaved, at_once: writer.pass.orders() };
    Orders { tape: tape.structs(names), items: implementation(body, &tape, &kind, names) }
}

/// Recurrences have lines of their own, and read the series of slopes where they stand.
fn constraints(graph: &Graph, recurrences: &Recurrences) -> Constraints {
    let beside = |slopes: &[Option<NodeId>; 2]| slopes.iter().flatten().map(|slope| signed(graph, *slope).1).collect();
    Constraints {
        named: recurrences.kept.union(&recurrences.nonlinear).copied().collect(),
        beside: recurrences.slopes.iter().map(|(id, slopes)| (*id, beside(slopes))).collect(),
    }
}

/// The values that move coordinates: what a sum adds up is added iteration by iteration, so that no iteration waits for
/// another.
fn stores(graph: &mut Graph, kinetic: &[Contribution], potential: &[Contribution]) -> Vec<Store> {
    let mut stores = Vec::new();
    for (gradient, is_force) in [(kinetic, false), (potential, true)] {
        for Contribution { context, element, value } in gradient {
            let value = if is_force { graph.neg(*value) } else { *value };
            let moved = element.partner();
            let addends = crate::taylor::addends(graph, context.clone(), value).into_iter();
            stores.extend(addends.map(|(context, value)| Store { context, sink: Sink::Collect(moved), value }));
        }
    }
    stores
}

/// What lines are written from.
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
    /// What is kept; the first record is that of the function.
    pub(super) records: Vec<Record>,
    /// The records of the blocks around the present line, innermost last.
    pub(super) within: Vec<usize>,
    /// Where the series of a value is.
    pub(super) places: HashMap<NodeId, Series>,
    /// Where it is of what the function begins with, in all of its blocks.
    begun: HashMap<NodeId, Series>,
    /// The lines that keep what the function begins with, where recurrences read its series.
    pub(super) opening: TokenStream,
    pub(super) moves: Moves,
    /// How many orders the lines find.
    pub(super) pass: Pass,
    /// The values whose sums over what is known are those of two orders.
    pub(super) of_two: BTreeSet<NodeId>,
    /// Where the coefficients of the derivatives of values are.
    pub(super) rates: Vec<(NodeId, Series)>,
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
            places: HashMap::new(),
            begun: HashMap::new(),
            opening: TokenStream::new(),
            moves: Moves::InPlace,
            pass: Pass::One,
            of_two: BTreeSet::new(),
            rates: Vec::new(),
        }
    }

    /// One whose lines are those of iterations side by side.
    pub(super) fn abreast(source: &'m Source<'m>, record: Record) -> Self {
        let mut writer = Self::new(source, record);
        writer.printer.scalar = &source.names.wide;
        writer.moves = Moves::Abreast(Found::default());
        writer
    }

    /// Finds places for what is kept in a block, before its lines are written: recurrences read each other.
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
        let mut tokens = self.known(fields, items.clone());
        for item in items {
            tokens.extend(self.item(fields, item));
            // What a block adds to is complete behind the last one; until then, what is kept is written again.
            tokens.extend(begun.iter().filter(|id| makes(item, **id)).filter_map(|id| self.keep(*id)));
        }
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
                if let Moves::Abreast(found) = &mut self.moves {
                    let Some(number) = found.another(self.printer.graph, *id, self.masks.is_empty()) else {
                        return TokenStream::new();
                    };
                    let number = Literal::usize_unsuffixed(number);
                    let value = self.masked(fields, signed(self.printer.graph, *id).1);
                    return match self.pass {
                        Pass::One => quote!(results[#number] = [#value];),
                        Pass::Two => quote!(results[#number][at] = #value;),
                    };
                }
                let value = self.masked(fields, *id);
                if let Moves::Alone(elements) = &self.moves {
                    let next = next(elements.iter().position(|known| known == element).unwrap_or_default());
                    return quote!(#next += #value;);
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

    /// Whether iterations side by side are given a value, since it stays the same in a run.
    fn is_given(&self, id: NodeId) -> bool {
        matches!(self.moves, Moves::Abreast(_)) && self.printer.graph.is_prepared(id)
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
        let keep = self.keep(id);
        quote!(let #name = #value; #keep)
    }

    /// Finds a place for a value in the record of the block.
    fn slot(&mut self, id: NodeId, is_condition: bool) {
        let name = self.printer.names[&id].clone();
        let record = self.record();
        record.keep(name.clone(), if is_condition { Kept::Condition } else { Kept::Series });
        let place = Series::Kept { at: record.at.clone(), name };
        self.places.insert(id, place);
    }

    /// The line that keeps a coefficient, where recurrences read it.
    fn keep(&self, id: NodeId) -> Option<TokenStream> {
        let name = &self.printer.names[&id];
        let place = self.places.get(&id).filter(|_| self.source.recurrences.kept.contains(&id))?;
        let (coefficient, rate) = (place.of(&quote!(order)), self.keep_rate(id));
        Some(quote!(#coefficient = #name; #rate))
    }

    /// Whether a value has a recurrence of its own.
    pub(super) fn is_nonlinear(&self, id: NodeId) -> bool {
        self.source.recurrences.nonlinear.contains(&id) && !self.is_given(id)
    }

    /// What is kept in the block of the present line.
    pub(super) fn record(&mut self) -> &mut Record {
        &mut self.records[self.within[self.within.len() - 1]]
    }

    /// Where the coefficients of a value are.
    pub(super) fn series(&mut self, fields: &mut Fields, id: NodeId) -> Series {
        match (self.printer.graph.node(id), &self.moves) {
            (Node::Coordinate(element), Moves::Alone(_) | Moves::InPlace | Moves::Once) => {
                Series::Row { part: self.printer.part(element), place: self.printer.in_row(fields, element) }
            }
            (Node::Coordinate(_) | Node::Time | Node::Middle | Node::Step, _) => self.begun_with(fields, id),
            _ => match self.places.get(&id) {
                Some(place) => place.clone(),
                // Of a value that no recurrence reads, nobody asks.
                None => Series::Kept { at: format_ident!("tape"), name: self.printer.names[&id].clone() },
            },
        }
    }

    /// Where the series of something is kept that the function begins with.
    fn begun_with(&mut self, fields: &mut Fields, id: NodeId) -> Series {
        if let Some(place) = self.begun.get(&id) {
            return place.clone();
        }
        let value = self.printer.expression(fields, id).tokens;
        let name = Ident::new(&value.to_string(), Span::call_site());
        let record = &mut self.records[0];
        record.keep(name.clone(), Kept::Series);
        let place = Series::Kept { at: record.at.clone(), name };
        let coefficient = place.of(&quote!(order));
        self.opening.extend(quote!(#coefficient = #value;));
        self.begun.insert(id, place.clone());
        place
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
