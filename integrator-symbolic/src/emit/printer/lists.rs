//! Rust code for sums over lists: the computation of a term, in vectors of any width, and the call of the runtime's
//! gather and scatter.

use super::{
    block::{Accumulation, Block},
    expression::Printer,
    fields::Fields,
    function::Body,
    index::part_name,
};
use crate::{
    graph::{
        NodeId,
        index::{Index, IndexId, LoopId},
    },
    layout::list_sum,
    program::{
        Item,
        lanes::{Coordinates, Points},
        lists::ListSum,
        results::Results,
    },
    syntax::names::Names,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

impl Block<'_> {
    /// A loop over a list whose terms share vectors.
    pub(super) fn list_sum(&mut self, fields: &mut Fields, by: LoopId, body: &[Item]) -> Option<TokenStream> {
        let is_plain = matches!(self.accumulation, Accumulation::Fused) && self.masks.is_empty();
        if !is_plain || !self.printer.frame.is_of_motion() {
            return None;
        }
        let named: BTreeSet<NodeId> = self.printer.names.keys().copied().collect();
        let sum = list_sum(self.printer.graph, self.printer.lengths, self.printer.parameters, &named, by, body).ok()?;
        let (term, reads_time) = self.term(fields, &sum);
        let call = self.call(fields, by, &sum, reads_time);
        Some(quote!({ #term #call }))
    }

    /// What a term computes; `true` if it reads the time.
    fn term(&self, fields: &mut Fields, sum: &ListSum<'_>) -> (TokenStream, bool) {
        let (printer, names) = (&self.printer, self.names);
        let Names { runtime, scalar, wide, iteration, .. } = names;
        let mut given = printer.names.clone();
        let mut named = |ids: &[NodeId], kind: &str| -> Vec<Ident> {
            let named = ids.iter().enumerate().map(|(number, id)| {
                let name = format_ident!("{kind}_{number}");
                given.insert(*id, name.clone());
                name
            });
            named.collect()
        };
        let (constants, mut common) = (named(&sum.constants, "constant"), named(&sum.common, "common"));
        let components = sum.components.unwrap_or(1);
        let mut reads = vec![vec![format_ident!("_"); components]; sum.reads.len()];
        for (id, point, component) in &sum.coordinates {
            let name = format_ident!("read_{point}_{component}");
            given.insert(*id, name.clone());
            reads[*point][*component] = name;
        }

        let mut block = Block::new(Printer { names: given, scalar: wide, ..*printer }, names);
        block.accumulation = Accumulation::Lanes(Results::default());
        let coordinates = sum.coordinates.iter().map(|(id, ..)| *id);
        block.arguments = sum.constants.iter().chain(&sum.common).copied().chain(coordinates).collect();
        let lines: TokenStream = sum.body.iter().map(|item| block.item(fields, item)).collect();
        let results = block.accumulation.results();
        let lines = Body::new(lines);
        let reads_time = lines.mentions("time");
        common.extend(reads_time.then(|| format_ident!("time")));
        let addends = sum.targets.iter().zip(&results.targets).map(|((list, component), (value, negative))| {
            let [list, component, value] = [*list, *component, *value].map(Literal::usize_unsuffixed);
            quote!(#runtime::Addend { list: #list, component: #component, value: #value, negative: #negative })
        });
        let read_by = sum.reads.iter().map(|(part, list)| {
            let [part, list] = [*part, *list].map(Literal::usize_unsuffixed);
            quote!(#runtime::Read { part: #part, list: #list })
        });
        let counts = [reads.len(), constants.len(), common.len(), results.values(), components];
        let counts = counts.map(Literal::usize_unsuffixed);
        let ([of_reads, of_constants, of_common, of_values, of_components], lines) = (&counts, &lines.0);
        let term = quote! {
            struct #iteration;
            impl #runtime::Term<#(#counts),*> for #iteration {
                const READS: [#runtime::Read; #of_reads] = [#(#read_by),*];
                const ADDENDS: &'static [#runtime::Addend] = &[#(#addends),*];

                #[inline(always)]
                fn values<#scalar: #runtime::Real, #wide: #runtime::Block<#scalar>>(
                    [#([#(#reads),*]),*]: [[#wide; #of_components]; #of_reads],
                    [#(#constants),*]: [#wide; #of_constants],
                    [#(#common),*]: [#wide; #of_common],
                ) -> [#wide; #of_values] {
                    let mut values = [#wide::of(0.0); #of_values];
                    #lines
                    values
                }
            }
        };
        (term, reads_time)
    }

    /// The call of the runtime.
    fn call(&self, fields: &mut Fields, by: LoopId, sum: &ListSum<'_>, reads_time: bool) -> TokenStream {
        let (printer, Names { runtime, iteration, .. }) = (&self.printer, self.names);
        let points = sum.components.map_or(Points::Numbers, Points::Components);
        let parts: Vec<Coordinates> = sum.parts.iter().copied().map(Coordinates::from).collect();
        let range = printer.range(fields, by);
        let constants: Vec<_> = sum.constants.iter().map(|id| printer.table(fields, by, *id)).collect();
        let operands = printer.operands(fields, (&parts, points, &constants, &sum.common), reads_time);
        let lists: Vec<_> = sum.lists.iter().map(|list| printer.list(fields, by, *list)).collect();
        let sums = gradient_of_points(points);
        quote! {
            #runtime::Terms {
                range: #range,
                lists: [#(#lists),*],
                #operands
            }
            .add_to::<#iteration, _, _>(#sums);
        }
    }
}

/// The gradient as points.
pub(super) fn gradient_of_points(points: Points) -> TokenStream {
    match points {
        Points::Components(_) => quote!(&mut gradient[..]),
        Points::Numbers | Points::Groups(_) => {
            let count = Literal::usize_unsuffixed(points.components());
            quote!(gradient.as_chunks_mut::<#count>().0)
        }
    }
}

impl Printer<'_> {
    /// The range of a loop.
    pub(super) fn range(&self, fields: &mut Fields, by: LoopId) -> TokenStream {
        let range = self.graph.loops.get(by);
        let (from, to) = (self.index(fields, range.from), self.index(fields, range.to));
        quote!(#from..#to)
    }

    /// The fields of the runtime's struct of a loop whose iterations share vectors, for the parts of coordinates that they read,
    /// for their constants, and for the numbers that they have in common.
    pub(super) fn operands(
        &self,
        fields: &mut Fields,
        (parts, points, constants, common): (&[Coordinates], Points, &[TokenStream], &[NodeId]),
        reads_time: bool,
    ) -> TokenStream {
        let parts: Vec<_> = parts.iter().map(|coordinates| self.points(fields, *coordinates, points)).collect();
        let mut common: Vec<_> = common.iter().map(|id| self.expression(fields, *id).tokens).collect();
        common.extend(reads_time.then(|| quote!(time)));
        quote! {
            parts: [#(#parts),*],
            constants: [#(#constants),*],
            common: [#(#common),*],
        }
    }

    /// Coordinates as points. Without an iteration, there may be none from an index on.
    pub(super) fn points(
        &self,
        fields: &mut Fields,
        Coordinates { part, from }: Coordinates,
        points: Points,
    ) -> TokenStream {
        let part = part_name(part);
        let part = match from {
            Some(from) => {
                let from = self.index(fields, from);
                quote!(motion.#part.get(#from..).unwrap_or_default())
            }
            None => quote!(motion.#part),
        };
        match points {
            Points::Components(_) if from.is_some() => part,
            Points::Components(_) => quote!(&#part[..]),
            Points::Numbers | Points::Groups(_) => {
                let count = Literal::usize_unsuffixed(points.components());
                quote!(#part.as_chunks::<#count>().0)
            }
        }
    }

    /// A list of indices, along the loop that is the last of its own.
    fn list(&self, fields: &mut Fields, by: LoopId, list: IndexId) -> TokenStream {
        let Index::Parameter(parameter) = self.graph.loops.index(list) else { return TokenStream::new() };
        let name = fields.integer(self.parameters, parameter);
        let list = self.prepared(name, self.graph.loops.of_parameter(parameter).without(by));
        quote!(&#list[..])
    }

    /// A table of prepared constants, likewise.
    pub(super) fn table(&self, fields: &mut Fields, by: LoopId, id: NodeId) -> TokenStream {
        let name = fields.number(self.graph, self.parameters, id);
        let table = self.prepared(name, self.graph.loops_of(id).without(by));
        quote!(&#table[..])
    }
}
