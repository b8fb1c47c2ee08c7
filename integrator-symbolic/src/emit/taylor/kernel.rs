//! Rust code for loops: a kernel that computes iterations in vectors and the lines that call it, or a scalar loop if
//! iterations depend on each other.

use super::{
    accumulation::Accumulation,
    orders_per_call::clock_read,
    tape::{self, Iterations, OrdersPerCall, Record, list},
    writer::{Source, Writer},
};
use crate::{
    emit::printer::{fields::Fields, function::Body},
    graph::{
        NodeId, Part,
        index::{LoopId, Loops},
    },
    model::Model,
    program::{
        Item, Program,
        nest::{Nest, NestContext},
        results::Results,
    },
    taylor::Recurrences,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// A function that computes iterations which share vectors.
pub(super) struct Kernel {
    pub(super) function: TokenStream,
    /// The names of what an iteration reads.
    pub(super) reads: Vec<Ident>,
    pub(super) results: Results,
    /// The coefficients that it reads of the step and of the time.
    pub(super) clock: Vec<Ident>,
}

/// The name of the kernel of a loop.
pub(super) fn iteration(number: usize) -> Ident {
    format_ident!("iteration_{number}")
}

/// The names of a kernel's arguments.
struct KernelArguments {
    reads: Vec<Ident>,
    constants: Vec<Ident>,
    common: Vec<Ident>,
    /// The lines that make conditions of constants.
    flags: TokenStream,
    /// All of it, by what it is.
    names: HashMap<NodeId, Ident>,
}

impl KernelArguments {
    /// Values that have a name keep it.
    fn of(nest: &Nest<'_>, known: &HashMap<NodeId, Ident>, wide: &Ident) -> Self {
        let name = |id: &NodeId, kind: &str, number: usize| {
            known.get(id).cloned().unwrap_or_else(|| format_ident!("{kind}_{number}"))
        };
        let all = |ids: &[NodeId], kind: &str| -> Vec<Ident> {
            ids.iter().enumerate().map(|(number, id)| name(id, kind, number)).collect()
        };
        let read: Vec<NodeId> = nest.reads.iter().map(|(id, _)| *id).collect();
        let (reads, mut constants, common) =
            (all(&read, "read"), all(&nest.constants, "constant"), all(&nest.invariants, "common"));
        let holds = all(&nest.predicates, "holds");
        let ids = read.iter().chain(&nest.constants).chain(&nest.invariants).chain(&nest.predicates);
        let names = reads.iter().chain(&constants).chain(&common).chain(&holds);
        let names = ids.copied().zip(names.cloned()).collect();
        let mut flags = TokenStream::new();
        for (number, holds) in holds.iter().enumerate() {
            let flag = format_ident!("flag_{number}");
            flags.extend(quote!(let #holds = #wide::of(0.0).less(#flag);));
            constants.push(flag);
        }
        Self { reads, constants, common, flags, names }
    }
}

/// The context of a program's loops.
pub(super) fn nest_context<'s>(
    model: &'s Model,
    program: &'s Program,
    recurrences: &'s Recurrences,
) -> NestContext<'s> {
    NestContext { graph: &model.graph, named: &program.named, operands: &recurrences.operands }
}

/// Which numbers an iteration reads together: the first components of a point, in their order, or one alone.
fn points(loops: &Loops, nest: &Nest<'_>) -> Vec<Vec<usize>> {
    let component = |read: &usize| nest.reads[*read].1.component.and_then(|component| loops.literal(component));
    let mut points: Vec<Vec<usize>> = Vec::new();
    for (read, (_, element)) in nest.reads.iter().enumerate() {
        let same = |point: &&mut Vec<usize>| {
            let first = nest.reads[point[0]].1;
            (first.part, first.index) == (element.part, element.index)
        };
        match points.iter_mut().find(same) {
            Some(point) => point.push(read),
            None => points.push(vec![read]),
        }
    }
    let parted = points.into_iter().flat_map(|mut point| {
        point.sort_by_key(component);
        let are_first = point.iter().zip(0..).all(|(read, number)| component(read) == Some(number));
        if are_first { vec![point] } else { point.into_iter().map(|read| vec![read]).collect() }
    });
    parted.collect()
}

impl Writer<'_> {
    /// The nests of a loop whose iterations can share vectors.
    pub(super) fn nests<'p>(&self, by: LoopId, body: &'p [Item]) -> Option<Vec<Nest<'p>>> {
        if self.within.len() > 1 || !self.masks.is_empty() || matches!(self.accumulation, Accumulation::InPlaceOnce) {
            return None;
        }
        let Source { model, program, recurrences, .. } = self.source;
        nest_context(model, program, recurrences).nests(by, body)
    }

    /// A loop whose iterations have a record each.
    pub(super) fn iterations(&mut self, fields: &mut Fields, by: LoopId, body: &[Item]) -> TokenStream {
        let number = self.records.len();
        let record = Record::of(&format!("iteration_{number}"), Iterations::OneByOne);
        let at = record.at.clone();
        self.records.push(record);
        self.within.push(number);
        // A value that two loops over the same range compute has a slot in each.
        let outside = self.series_of.clone();
        self.allocate(body);
        let body = self.items(fields, body);
        self.series_of = outside;
        self.within.pop();
        let iteration = (!self.records[number].slots.is_empty()).then(|| {
            let (runtime, list, next) = (self.printer.runtime, list(number), tape::next(number));
            quote!(let #at = #runtime::next_record(&mut tape.#list, &mut #next);)
        });
        self.printer.loop_over(fields, by, &quote!(#iteration #body))
    }

    /// A nest of loops: its kernel, and the lines that build blocks of its iterations once and call it for each block.
    pub(super) fn nest(&mut self, fields: &mut Fields, nest: &Nest<'_>) -> TokenStream {
        let (runtime, scalar) = (&self.source.names.runtime, &self.source.names.scalar);
        let points = points(&self.printer.graph.loops, nest);
        let number = self.records.len();
        let (iterations, iteration) = (list(number), iteration(number));
        let bound = quote!(#runtime::Row<#scalar>);
        let Kernel { function, reads, results, clock } = self.kernel(fields, nest, &bound, |counts| {
            let [constants, values, orders] = counts;
            Iterations::Blocks([points.len(), constants, nest.targets.len(), values, orders])
        });
        let iteration_list = self.iteration_list(fields, nest, &points, &iterations, &results);
        let common = self.common(fields, nest);
        let read = points.iter().enumerate().map(|(number, point)| {
            let (part, number) = (self.printer.part(nest.reads[point[0]].1), Literal::usize_unsuffixed(number));
            let components = point.iter().map(|read| &reads[*read]);
            quote!(let [#(#components),*] = block.read(#number, #part, order);)
        });
        let moves = |part| nest.targets.iter().any(|element| element.part == part);
        let added = [
            (Part::Position, quote!(add_to_positions(q, order + 1))),
            (Part::Momentum, quote!(add_to_momenta(p, order + 1))),
        ];
        let added = added.into_iter().filter(|(part, _)| moves(*part)).map(|(_, added)| added);
        let (times, clock) = self.times(&clock);
        quote! {
            #function
            #times
            if order == 0 && tape.#iterations.is_empty() { #iteration_list }
            for (block, results) in tape.#iterations.blocks() {
                #(#read)*
                *results = #iteration::<#scalar, #runtime::Wide<#scalar>>(
                    &mut block.kept,
                    [#(#reads),*],
                    block.constants,
                    [#(#common),*],
                    order,
                    #(#clock,)*
                );
            }
            #(tape.#iterations.#added;)*
        }
    }

    /// The kernel of a nest, in vectors of type `bound`, whose record has copies of the kind that the numbers of constants,
    /// of values and of orders per call tell.
    pub(super) fn kernel(
        &mut self,
        fields: &mut Fields,
        nest: &Nest<'_>,
        bound: &TokenStream,
        copies: impl FnOnce([usize; 3]) -> Iterations,
    ) -> Kernel {
        let names = self.source.names;
        let (runtime, scalar, wide) = (&names.runtime, &names.scalar, &names.wide);
        let number = self.records.len();
        let given = KernelArguments::of(nest, &self.printer.names, wide);
        let orders_per_call = self.orders_per_call.count();
        let (body, mut record, results) = {
            let mut writer = Writer::in_lanes(self.source, Record::of("iteration", Iterations::Once));
            writer.orders_per_call = self.orders_per_call;
            writer.printer.names.extend(given.names);
            writer.allocate(nest.body.iter().copied());
            let body = writer.iteration(fields, nest, &given.reads);
            (body, writer.records.swap_remove(0), writer.accumulation.results())
        };
        let counts = [given.constants.len(), results.values(), orders_per_call];
        record.iterations = copies(counts);
        let body = Body::new(body);
        let kept = match record.slots.is_empty() {
            true => quote!(()),
            false => {
                let kept = tape::iteration(number, names);
                quote!(#kept<#wide>)
            }
        };
        self.records.push(record);

        let [of_constants, of_values, of_orders] = counts.map(Literal::usize_unsuffixed);
        let of_common = Literal::usize_unsuffixed(given.common.len());
        let of_reads = Literal::usize_unsuffixed(given.reads.len());
        let (own, order) = (body.argument("iteration"), body.argument("order"));
        let (clock, iteration) = (clock_read(&body), iteration(number));
        let KernelArguments { reads, constants, common, flags, .. } = given;
        let body = &body.0;
        let function = quote! {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn #iteration<#scalar: #runtime::Real, #wide: #bound>(
                #own: &mut #kept,
                reads: [[#wide; #of_orders]; #of_reads],
                [#(#constants),*]: [#wide; #of_constants],
                [#(#common),*]: [#wide; #of_common],
                #order: usize,
                #(#clock: [#wide; #of_orders],)*
            ) -> [[#wide; #of_orders]; #of_values] {
                let mut results = [[#wide::of(0.0); #of_orders]; #of_values];
                #flags
                #body
                results
            }
        };
        Kernel { function, reads, results, clock }
    }

    /// What all iterations of a nest have in common, as arguments of its kernel.
    pub(super) fn common(&self, fields: &mut Fields, nest: &Nest<'_>) -> Vec<TokenStream> {
        let runtime = self.printer.runtime;
        let common = nest.invariants.iter().map(|id| {
            let value = self.printer.expression(fields, *id).tokens;
            quote!(#runtime::splat(#value))
        });
        common.collect()
    }

    /// The lines that give a kernel the coefficients of the time, and its arguments.
    pub(super) fn times(&self, clock: &[Ident]) -> (Option<TokenStream>, Vec<TokenStream>) {
        let runtime = self.printer.runtime;
        // The lines around have the coefficients of the time of one order.
        match self.orders_per_call {
            OrdersPerCall::One => (None, clock.iter().map(|name| quote!([#runtime::splat(#name)])).collect()),
            OrdersPerCall::Two if clock.is_empty() => (None, Vec::new()),
            OrdersPerCall::Two => (
                Some(
                    quote!(let times = [order, order + 1].map(|order| #runtime::time_coefficients(order, time, q.unit()));),
                ),
                clock
                    .iter()
                    .map(|name| {
                        let number = Literal::usize_unsuffixed(usize::from(name == "time"));
                        quote!([#runtime::splat(times[0].#number), #runtime::splat(times[1].#number)])
                    })
                    .collect(),
            ),
        }
    }

    /// The lines of an iteration, for each of the orders per call.
    fn iteration(&mut self, fields: &mut Fields, nest: &Nest<'_>, reads: &[Ident]) -> TokenStream {
        let lines = || nest.body.iter().copied();
        let [known, newest] = match self.orders_per_call {
            OrdersPerCall::One => [TokenStream::new(), TokenStream::new()],
            OrdersPerCall::Two => self.known_of_two(fields, lines()),
        };
        let body = self.items(fields, lines());
        let opening = &self.opening;
        let lines = quote!(#opening #body);
        let clock = clock_read(&Body::new(lines.clone()));
        match self.orders_per_call {
            OrdersPerCall::One => quote!(#(let [#clock] = #clock;)* let [#([#reads]),*] = reads; #lines),
            OrdersPerCall::Two => {
                let numbers = (0..reads.len()).map(Literal::usize_unsuffixed);
                quote! {
                    #known
                    for at in 0..2 {
                        let order = order + at;
                        #(let #clock = #clock[at];)*
                        #(let #reads = reads[#numbers][at];)*
                        #newest
                        #lines
                    }
                }
            }
        }
    }

    /// The lines that append the iterations to their list and build the blocks.
    fn iteration_list(
        &mut self,
        fields: &mut Fields,
        nest: &Nest<'_>,
        points: &[Vec<usize>],
        iterations: &Ident,
        results: &Results,
    ) -> TokenStream {
        let (scalar, runtime) = (self.printer.scalar, self.printer.runtime);
        // Names are those of values that are computed at every order.
        let named = std::mem::take(&mut self.printer.names);
        let printer = &self.printer;
        // Iterations whose predicates do not hold are listed as well.
        let mut place = |element| match nest.predicates.is_empty() {
            true => printer.in_row(fields, element),
            false => printer.near_in_row(fields, element),
        };
        let reads: Vec<_> = points.iter().map(|point| place(nest.reads[point[0]].1)).collect();
        let targets: Vec<_> = nest.targets.iter().map(|element| place(*element)).collect();
        let mut constants: Vec<_> = nest.constants.iter().map(|id| printer.computation(fields, *id).tokens).collect();
        constants.extend(nest.predicates.iter().map(|id| {
            let holds = printer.computation(fields, *id).tokens;
            quote!(#scalar::select(#holds, #scalar::of(1.0), #scalar::of(0.0)))
        }));
        let take = quote!(tape.#iterations.push([#(#reads),*], [#(#constants),*], [#(#targets),*]););
        let take = nest.loops.iter().rev().fold(take, |take, by| printer.loop_over(fields, *by, &take));
        self.printer.names = named;
        let targets = nest.targets.iter().zip(&results.targets).map(|(element, (value, negative))| {
            let value = Literal::usize_unsuffixed(*value);
            let part = match element.part {
                Part::Position => quote!(position),
                Part::Momentum => quote!(momentum),
            };
            let negated = negative.then(|| quote!(.negated()));
            quote!(#runtime::Target::#part(#value) #negated)
        });
        quote!(#take tape.#iterations.build(layout, [#(#targets),*]);)
    }
}
