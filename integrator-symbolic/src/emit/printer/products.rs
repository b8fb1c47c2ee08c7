//! Rust code for loops in lanes that only multiply: calls of the runtime, without an iteration of their own.

use super::{block::Block, fields::Fields, lists::gradient_of_points};
use crate::{
    graph::{NodeId, index::LoopId},
    program::{
        Item, Sink,
        lanes::{LoopInLanes, Points},
    },
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// What a loop in lanes does, if it only multiplies.
#[derive(Clone, Copy)]
enum Products {
    /// It adds up products of a constant and a coordinate.
    Inner { sum: NodeId },
    /// It adds multiples of constants to a gradient.
    Multiples { of: NodeId },
}

/// A loop over the entries of each row of a table.
struct Rows {
    /// The table, the range of its columns, and how far the index of a coordinate is from that of its entry.
    arguments: TokenStream,
    products: Products,
    /// What an inner product reads.
    coordinates: TokenStream,
}

impl Block<'_> {
    /// A loop in lanes that only multiplies, with its offset: how far the index of a coordinate is from that of the loop.
    fn products_of(&self, lanes: &LoopInLanes<'_>) -> Option<(Products, i64)> {
        let is_given = |line: &&&Item| !matches!(line, Item::Let(_));
        let mut lines = lanes.body.iter().filter(is_given);
        let (line, None) = (lines.next()?, lines.next()) else { return None };
        let [constant] = lanes.constants[..] else { return None };
        let is_plain = lanes.points == Points::Numbers && lanes.kept.is_empty() && lanes.apart.is_none();
        if !is_plain {
            return None;
        }
        match (line, &lanes.coordinates[..], &lanes.common[..]) {
            (Item::Add { sum, value }, &[(read, ..)], []) if self.is_product(*value, constant, read) => {
                let [(_, offset)] = lanes.reads[..] else { return None };
                Some((Products::Inner { sum: *sum }, offset))
            }
            (Item::Sink(Sink::Collect(_), value), [], &[of]) if self.is_product(*value, constant, of) => {
                Some((Products::Multiples { of }, lanes.target?))
            }
            _ => None,
        }
    }

    /// The call for a loop that only multiplies.
    pub(super) fn products(&self, fields: &mut Fields, by: LoopId, lanes: &LoopInLanes<'_>) -> Option<TokenStream> {
        let (products, offset) = self.products_of(lanes)?;
        let (values, offset) = (self.loop_of(fields, by, lanes, false), Literal::i64_unsuffixed(offset));
        Some(match products {
            Products::Inner { sum } => {
                let name = &self.printer.names[&sum];
                quote!(let #name = #values.inner_product(#offset);)
            }
            Products::Multiples { .. } => {
                let gradient = gradient_of_points(lanes.points);
                quote!(#values.add_multiples(#offset, #gradient);)
            }
        })
    }

    /// The loop that lines in a loop over rows are, if they are one over the entries of each row that only multiplies.
    fn rows(&self, fields: &mut Fields, by: LoopId, lines: &[Item]) -> Option<Rows> {
        let mut loops = lines.iter().filter(|line| matches!(line, Item::Loop { .. }));
        let (line, None) = (loops.next()?, loops.next()) else { return None };
        let (lanes, Item::Loop { by: columns, .. }) = (self.loop_in_lanes(lines, line)?, line) else { return None };
        let (graph, columns) = (self.printer.graph, *columns);
        let (products, offset) = self.products_of(&lanes)?;
        let [constant] = lanes.constants[..] else { return None };
        let (of_table, range) = (graph.loops_of(constant), graph.loops.get(columns));
        let are_alike = ![range.from, range.to].iter().any(|end| graph.loops.of_index(*end).contains(by));
        if !are_alike || !of_table.contains(by) {
            return None;
        }
        let name = fields.number(graph, self.printer.parameters, constant);
        let table = self.printer.prepared(name, of_table.without(by).without(columns));
        let (range, offset) = (self.printer.range(fields, columns), Literal::i64_unsuffixed(offset));
        let part = *lanes.parts.first()?;
        let coordinates = self.printer.points(fields, part, Points::Numbers);
        Some(Rows { arguments: quote!(&#table[..], #range, #offset), products, coordinates })
    }

    /// The call that computes the inner products of all rows, if these lines sum up nothing else.
    pub(super) fn inner_products(
        &self,
        fields: &mut Fields,
        by: LoopId,
        (lines, sums): (&[Item], &[NodeId]),
        to: &TokenStream,
    ) -> Option<TokenStream> {
        let Rows { arguments, products: Products::Inner { sum }, coordinates } = self.rows(fields, by, lines)? else {
            return None;
        };
        let runtime = &self.names.runtime;
        (sums == [sum]).then(|| quote!(#runtime::inner_products(#arguments, #coordinates, #to);))
    }

    /// The call that adds the multiples of all rows to the gradient, and the number that each row is multiplied by.
    pub(super) fn multiples_of_rows(
        &self,
        fields: &mut Fields,
        by: LoopId,
        lines: &[Item],
        factors: impl FnOnce(NodeId) -> Option<TokenStream>,
    ) -> Option<TokenStream> {
        let Rows { arguments, products: Products::Multiples { of }, .. } = self.rows(fields, by, lines)? else {
            return None;
        };
        let (runtime, factors, gradient) = (&self.names.runtime, factors(of)?, gradient_of_points(Points::Numbers));
        Some(quote!(#runtime::add_multiples_of_rows(#arguments, #factors, #gradient);))
    }

    /// Whether a value is the product of a constant and of another one that is none.
    fn is_product(&self, value: NodeId, constant: NodeId, other: NodeId) -> bool {
        let product = self.printer.product(value).filter(|(is_negative, ..)| !is_negative);
        product.and_then(|(_, a, b)| self.printer.constant_factor(a, b)) == Some((constant, other))
    }
}
