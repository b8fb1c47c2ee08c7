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
    program::{Item, lanes::LoopInLanes},
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
        let (constants, mut common) = (named(&lanes.constants, "constant"), named(&lanes.common, "common"));
        let components = lanes.components.unwrap_or(1);
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
        block.accumulation = Accumulation::Point;
        let coordinates = lanes.coordinates.iter().map(|(id, ..)| *id);
        block.arguments = lanes.constants.iter().chain(&lanes.common).copied().chain(coordinates).collect();
        let lines = Body::new(lanes.body.iter().map(|item| block.item(fields, item)).collect());
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
        let point = lanes.target.map(|_| quote!(gradient)).into_iter().collect::<Vec<_>>();
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
        let (printer, Names { runtime, iteration, .. }) = (&self.printer, self.names);
        let (range, operands) =
            printer.operands(fields, by, &lanes.parts, lanes.components, [&lanes.constants, &lanes.common], reads_time);
        let gradient = lanes.target.map_or_else(|| quote!(&mut []), |_| gradient_of_points(lanes.components));
        quote! {
            #runtime::Loop {
                range: #range,
                #operands
            }
            .run::<#iteration, _, _, _>(#gradient)
        }
    }
}
