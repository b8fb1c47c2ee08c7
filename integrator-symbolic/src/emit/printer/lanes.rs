//! Rust code for loops in lanes: the computation of an iteration, in vectors of any width, and the call of the runtime's
//! loop.

use super::{
    block::{Accumulation, Block},
    expression::Printer,
    fields::Fields,
    function::Body,
    lists::gradient_of_points,
};
use crate::{
    graph::{NodeId, index::LoopId},
    program::{
        Item,
        lanes::{LoopInLanes, Points},
    },
    syntax::names::Names,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

impl Block<'_> {
    /// The loop in lanes that a line among others is, if it is one here.
    pub(super) fn loop_in_lanes<'p>(&self, beside: &[Item], item: &'p Item) -> Option<LoopInLanes<'p>> {
        let lanes = self.lanes?.loop_in_lanes(beside, item).ok()?;
        // Lanes in which a condition does not hold add to no gradient.
        let may_add = lanes.target.is_none() || self.masks.is_empty();
        (may_add && matches!(self.accumulation, Accumulation::Fused)).then_some(lanes)
    }

    /// A loop in lanes, with the beginning of its sums.
    pub(super) fn in_lanes(&self, fields: &mut Fields, by: LoopId, lanes: &LoopInLanes<'_>) -> TokenStream {
        if let Some(products) = self.products(fields, by, lanes) {
            return products;
        }
        let (iteration, reads_time) = self.iteration(fields, lanes);
        let call = self.call_of_loop(fields, by, lanes, reads_time);
        let sums = lanes.sums.iter().map(|sum| &self.printer.names[sum]);
        match lanes.sums.is_empty() {
            true => quote!({ #iteration #call; }),
            false => quote!(let [#(#sums),*] = { #iteration #call };),
        }
    }

    /// What an iteration computes; `true` if it reads the time.
    fn iteration(&self, fields: &mut Fields, lanes: &LoopInLanes<'_>) -> (TokenStream, bool) {
        let (printer, names) = (&self.printer, self.names);
        let Names { runtime, scalar, wide, iteration, .. } = names;
        let mut given = printer.names.clone();
        let mut named = |ids: &[NodeId], kind: &str| -> Vec<Ident> {
            let named = ids
                .iter()
                .enumerate()
                .map(|(number, id)| given.entry(*id).or_insert_with(|| format_ident!("{kind}_{number}")).clone());
            named.collect()
        };
        let mut constants = named(&lanes.constants, "constant");
        let kept: Vec<NodeId> = lanes.kept.iter().map(|(id, _)| *id).collect();
        constants.extend(named(&kept, "kept"));
        let mut common = named(&lanes.common, "common");
        let components = lanes.points.components();
        let mut reads = vec![vec![format_ident!("_"); components]; lanes.reads.len()];
        for (id, point, component) in &lanes.coordinates {
            let read = &mut reads[*point][*component];
            // Two spellings of an index are two nodes of one coordinate.
            if *read == "_" {
                *read = given.get(id).cloned().unwrap_or_else(|| format_ident!("read_{point}_{component}"));
            }
            given.insert(*id, read.clone());
        }

        let mut block = Block::new(Printer { names: given, scalar: wide, ..*printer }, names);
        block.accumulation = Accumulation::Points(lanes.targets.clone());
        let coordinates = lanes.coordinates.iter().map(|(id, ..)| *id);
        let numbers = lanes.constants.iter().chain(&kept).chain(&lanes.common).copied();
        block.arguments = numbers.chain(coordinates).collect();
        let mut lines: TokenStream = lanes.body.iter().map(|item| block.item(fields, item)).collect();
        for (number, id) in lanes.results.iter().enumerate() {
            let (point, result) = (point_of_gradient(number), &block.printer.names[id]);
            lines.extend(quote!(#point[0] = #result;));
        }
        let lines = Body::new(lines);
        let reads_time = lines.mentions("time");
        common.extend(reads_time.then(|| format_ident!("time")));
        let read_by = lanes.reads.iter().map(|(part, offset)| {
            let (part, offset) = (Literal::usize_unsuffixed(*part), Literal::i64_unsuffixed(*offset));
            quote!(#runtime::Near { part: #part, offset: #offset })
        });
        let target = lanes.target.filter(|offset| *offset != 0).map(|offset| {
            let offset = Literal::i64_unsuffixed(offset);
            quote!(const TARGET: isize = #offset;)
        });
        let sums: Vec<_> = lanes.sums.iter().map(|sum| &printer.names[sum]).collect();
        let of_gradient = if lanes.apart.is_some() { 2 } else { usize::from(lanes.target.is_some()) };
        let targets = of_gradient.max(lanes.results.len());
        let point: Vec<Ident> = (0..targets).map(point_of_gradient).collect();
        let counts = [reads.len(), constants.len(), common.len(), sums.len(), point.len(), components];
        let counts = counts.map(Literal::usize_unsuffixed);
        let ([of_reads, of_constants, of_common, of_sums, of_targets, of_components], lines) = (&counts, &lines.0);
        let tokens = quote! {
            struct #iteration;
            impl #runtime::Iteration<#(#counts),*> for #iteration {
                const READS: [#runtime::Near; #of_reads] = [#(#read_by),*];
                #target

                #[inline(always)]
                fn next<#scalar: #runtime::Real, #wide: #runtime::Block<#scalar>>(
                    [#([#(#reads),*]),*]: [[#wide; #of_components]; #of_reads],
                    [#(#constants),*]: [#wide; #of_constants],
                    [#(#common),*]: [#wide; #of_common],
                    [#(mut #sums),*]: [#wide; #of_sums],
                    [#(mut #point),*]: [[#wide; #of_components]; #of_targets],
                ) -> ([#wide; #of_sums], [[#wide; #of_components]; #of_targets]) {
                    #lines
                    ([#(#sums),*], [#(#point),*])
                }
            }
        };
        (tokens, reads_time)
    }

    /// The call of the runtime.
    fn call_of_loop(&self, fields: &mut Fields, by: LoopId, lanes: &LoopInLanes<'_>, reads_time: bool) -> TokenStream {
        let Names { runtime, iteration, results, .. } = self.names;
        let values = self.loop_of(fields, by, lanes, reads_time);
        let (method, gradient) = match (lanes.target, lanes.apart) {
            (None, _) if !lanes.results.is_empty() => {
                let lists: Vec<Ident> = (0..lanes.results.len()).map(|n| format_ident!("{results}_{n}")).collect();
                let points = quote!(let [#(#lists),*] = &mut #results; [#(#lists.as_chunks_mut::<1>().0),*]);
                (quote!(run_apart), quote!(&mut { #points }))
            }
            (None, _) => (quote!(run), quote!(&mut [])),
            (Some(_), None) => (quote!(run), gradient_of_points(lanes.points)),
            (Some(_), Some(from)) => {
                let from = self.printer.index(fields, from);
                let count = Literal::usize_unsuffixed(lanes.points.components());
                let apart = match lanes.points {
                    Points::Components(_) => quote!(apart),
                    Points::Numbers | Points::Groups(_) => quote!(groups_apart::<_, #count>),
                };
                (quote!(run_apart), quote!(&mut #runtime::#apart(&mut gradient[..], #from)))
            }
        };
        quote!(#values.#method::<#iteration, _, _, _>(#gradient))
    }

    /// The runtime's struct of a loop.
    pub(super) fn loop_of(
        &self,
        fields: &mut Fields,
        by: LoopId,
        lanes: &LoopInLanes<'_>,
        reads_time: bool,
    ) -> TokenStream {
        let (printer, Names { runtime, kept, .. }) = (&self.printer, self.names);
        let range = printer.range(fields, by);
        let mut constants: Vec<_> = lanes.constants.iter().map(|id| printer.table(fields, by, *id)).collect();
        constants.extend(lanes.kept.iter().map(|(_, number)| {
            let number = Literal::usize_unsuffixed(*number);
            quote!(&#kept[#number][..])
        }));
        let operands = (&lanes.parts[..], lanes.points, &constants[..], &lanes.common[..]);
        let operands = printer.operands(fields, operands, reads_time);
        quote! {
            #runtime::Loop {
                range: #range,
                #operands
            }
        }
    }
}

/// The name of a point of the gradient in an iteration.
pub(super) fn point_of_gradient(number: usize) -> Ident {
    if number == 0 { format_ident!("gradient") } else { format_ident!("gradient_{number}") }
}
