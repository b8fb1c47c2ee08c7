//! Rust code for the Taylor coefficients of a motion, order by order.
//!
//! One pass over the nodes computes their coefficients of an order from those of lower orders. The values that
//! recurrences read are stored in a tape: adjacent if they are outside of loops, otherwise in a list with one entry per
//! iteration.

use super::{
    accumulation::Accumulation,
    implementation::{Kind, implementation},
    kernel::nest_context,
    line,
    second_order::InverseMasses,
    tape::{Iterations, Record, Tape},
    writer::{Source, Writer},
};
use crate::{
    differentiate::Contribution,
    emit::printer::{fields::Fields, frame::Frame, function::Body, interleaved::InterleavedIndices},
    graph::{Graph, NodeId},
    model::{Model, is_leaf},
    program::{Constraints, Program, Sink, Store, schedule_with},
    stencil::Stencil,
    syntax::names::Names,
    taylor::{Recurrences, inverse_masses},
};
use proc_macro2::TokenStream;
use quote::quote;

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
        selects: false,
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
