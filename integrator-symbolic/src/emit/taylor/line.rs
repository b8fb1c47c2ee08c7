//! Rust code for lines of sites: a kernel that computes several vectors of sites per call, and the sums of the
//! contributions of the bonds at each site.

use super::{
    accumulation::Accumulation,
    kernel::{Kernel, iteration, nest_context},
    orders::{Orders, constraints, finished, program},
    tape::{Iterations, OrdersPerCall, Record, list},
    writer::{Source, Writer},
};
use crate::{
    differentiate::Contribution,
    emit::printer::{fields::Fields, frame::Frame, interleaved::InterleavedIndices},
    graph::{
        Element, Part,
        index::{Index, LoopId},
    },
    model::Model,
    program::{Item, Program, Sink, nest::Nest},
    stencil::{Addend, Ends, Line, Stencil},
    syntax::names::Names,
    taylor::{Recurrences, inverse_masses},
};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// The recurrences of a motion whose forces are those of a line of sites that are all alike, where positions follow
/// momenta by an inverse mass.
pub(super) fn orders(
    model: &mut Model,
    fields: &mut Fields,
    names: &Names,
    mut kinetic: Vec<Contribution>,
    stencil: &Stencil,
) -> Option<Orders> {
    let graph = &mut model.graph;
    let mut line = stencil.line(graph)?;
    let mut forces: Vec<_> = line.addends.iter().map(|addend| addend.contribution.clone()).collect();
    let recurrences = Recurrences::of(graph, [&mut kinetic, &mut forces]);
    for (addend, force) in line.addends.iter_mut().zip(&forces) {
        addend.contribution = force.clone();
    }
    let inverse_masses = inverse_masses(graph, &kinetic)?;
    let constraints = constraints(graph, &recurrences);
    let of_positions = program(model, &inverse_masses, &[], &constraints);
    let of_sites = program(model, &[], &forces, &constraints);
    let sites = Sites::of(model, &of_sites, &recurrences, &line)?;
    let frame = Frame::Series { interleaved: Some(InterleavedIndices::of(&model.graph)) };
    let source = Source { model, names, program: &of_positions, frame: &frame, recurrences: &recurrences };
    let mut of_inverse_masses = Writer::new(&source, Record::of("tape", Iterations::Once));
    of_inverse_masses.accumulation = Accumulation::InPlaceOnce;
    let inverse_masses = of_inverse_masses.items(fields, &of_positions.items);
    let source = Source { program: &of_sites, ..source };
    let mut writer = Writer::new(&source, Record::of("tape", Iterations::Once));
    let (first, sites) = (writer.first_order(&inverse_masses), writer.line(fields, &sites));
    Some(finished(&writer, fields, quote!(#first #sites), true))
}

/// The most vectors, with one before the first site, whose results are held in registers.
const FEW: u64 = 7;

/// The loop over the sites of a line.
pub(super) struct Sites<'p> {
    nest: Nest<'p>,
    /// For each coordinate that a site moves, whether the last site computes nothing for it.
    without_last: Vec<bool>,
    ends: Ends,
    site: LoopId,
    /// How many vectors they fill.
    vectors: u64,
}

impl<'p> Sites<'p> {
    /// The loop over the sites of `line`, where that is all of a program.
    pub(super) fn of(model: &Model, program: &'p Program, recurrences: &Recurrences, line: &Line) -> Option<Self> {
        let Line { site, ends, addends, vectors } = line;
        let [Item::Loop { by, body }] = &program.items[..] else { return None };
        let nests = nest_context(model, program, recurrences).nests(*by, body)?;
        let [nest] = <[Nest<'p>; 1]>::try_from(nests).ok()?;
        let graph = &model.graph;
        let is_alike = nest.loops == [*site] && nest.constants.is_empty() && nest.predicates.is_empty();
        let is_common = nest.invariants.iter().all(|id| graph.is_prepared(*id));
        let reads_positions = nest.reads.iter().all(|(_, element)| element.part == Part::Position);
        if !is_alike || !is_common || !reads_positions {
            return None;
        }
        let sink = |item: &&Item| match item {
            Item::Sink(Sink::Collect(element), value) => Some((*element, graph.without_sign(*value))),
            _ => None,
        };
        let without_last = nest.body.iter().filter_map(sink).map(|sink| {
            let mut of_sink =
                addends.iter().filter(|Addend { contribution: Contribution { element, value, .. }, .. }| {
                    (element.partner(), graph.without_sign(*value)) == sink
                });
            let first = of_sink.next()?.without_last;
            of_sink.all(|addend| addend.without_last == first).then_some(first)
        });
        let without_last = without_last.collect::<Option<Vec<_>>>()?;
        (without_last.len() == nest.targets.len()).then_some(Self {
            nest,
            without_last,
            ends: *ends,
            site: *site,
            vectors: *vectors,
        })
    }
}

/// What is beyond the ends, as the runtime knows it.
fn ends(ends: Ends, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    match ends {
        Ends::Ring => quote!(#runtime::Ends::Ring),
        Ends::Open { first_at_rest, .. } => quote!(#runtime::Ends::Open { first_at_rest: #first_at_rest }),
    }
}

impl Writer<'_> {
    /// The lines that compute two orders of the momenta of a line, and the positions that follow.
    pub(super) fn line(&mut self, fields: &mut Fields, sites: &Sites<'_>) -> TokenStream {
        let Sites { nest, without_last, ends: beyond, site, vectors } = sites;
        self.orders_per_call = OrdersPerCall::Two;
        let names = self.source.names;
        let (runtime, scalar) = (&names.runtime, &names.scalar);
        // With the one before the first site.
        let vectors = vectors + 1;
        let few = Literal::u64_unsuffixed(if vectors <= FEW { vectors } else { 0 });
        let number = self.records.len();
        let (list, iteration) = (list(number), iteration(number));
        let Kernel { function, reads, results, clock } =
            self.kernel(fields, nest, &quote!(#runtime::Real), |[_, values, orders]| {
                Iterations::Sites([values, orders])
            });
        let ends = ends(*beyond, names);
        let common = self.common(fields, nest);
        let (times, clock) = self.times(&clock);
        let is_own = |element: Element| self.printer.graph.loops.index(element.index) == Index::Running(*site);
        let read = reads.iter().zip(&nest.reads).map(|(name, (_, element))| match is_own(*element) {
            true => quote!(let #name = vectors.own(q, order);),
            false => quote!(let #name = vectors.next(q, order, ENDS);),
        });
        let read: TokenStream = read.collect();
        let call = quote! {
            #read
            let results = #iteration::<#scalar, _>(vectors.kept, [#(#reads),*], [], [#(#common),*], order, #(#clock,)*);
            vectors.store(&mut few, results);
        };
        let addends = nest.targets.iter().zip(&results.targets).zip(without_last);
        let addends = addends.map(|((element, target), without_last)| match (is_own(*element), without_last) {
            (true, false) => ("own", target),
            (true, true) => ("own_without_last", target),
            (false, _) => ("before", target),
        });
        // A site gets what it computes itself first.
        let (before, mut addends): (Vec<_>, Vec<_>) = addends.partition(|(name, _)| *name == "before");
        addends.extend(before);
        let mut sum = TokenStream::new();
        for (name, (value, negative)) in &addends {
            let (name, value) = (format_ident!("{name}"), Literal::usize_unsuffixed(*value));
            let value = quote!(#name[#value][at]);
            sum = match (sum.is_empty(), negative) {
                (true, false) => value,
                (true, true) => quote!(-#value),
                (false, false) => quote!(#sum + #value),
                (false, true) => quote!(#sum - #value),
            };
        }
        let names: BTreeSet<_> = addends.iter().map(|(name, _)| format_ident!("{name}")).collect();
        let names = names.iter();
        let values = Literal::usize_unsuffixed(results.values());
        quote! {
            const ENDS: #runtime::Ends = #ends;
            #function
            #times
            if tape.#list.is_empty() { tape.#list.build(layout, ENDS); }
            let mut few = #runtime::Few::<#scalar, #values, 2, #few>::zero();
            for number in tape.#list.singles(layout, ENDS) {
                let vectors = tape.#list.single(number, layout, ENDS);
                #call
            }
            for number in tape.#list.bundles(layout, ENDS) {
                let vectors = tape.#list.bundle(number);
                #call
            }
            let sites = tape.#list.computed(&few, layout, ENDS);
            let inverse_masses = tape.inverse_mass.of_all(layout);
            for vector in sites.vectors() {
                #(let #names = sites.#names(vector);)*
                for at in 0..2 {
                    inverse_masses.next_order_of(vector, #sum, q, p, order + at + 1);
                }
            }
        }
    }
}
