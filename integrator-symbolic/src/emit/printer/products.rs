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

impl Block<'_> {
    /// A loop that adds up products of a constant and a coordinate, or adds multiples of constants to a gradient.
    pub(super) fn products(&self, fields: &mut Fields, by: LoopId, lanes: &LoopInLanes<'_>) -> Option<TokenStream> {
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
                let (values, offset) = (self.loop_of(fields, by, lanes, false), Literal::i64_unsuffixed(offset));
                let name = &self.printer.names[sum];
                Some(quote!(let #name = #values.inner_product(#offset);))
            }
            (Item::Sink(Sink::Collect(_), value), [], &[common]) if self.is_product(*value, constant, common) => {
                let (values, offset) = (self.loop_of(fields, by, lanes, false), lanes.target?);
                let (offset, gradient) = (Literal::i64_unsuffixed(offset), gradient_of_points(lanes.points));
                Some(quote!(#values.add_multiples(#offset, #gradient);))
            }
            _ => None,
        }
    }

    /// Whether a value is the product of a constant and of another one that is none.
    fn is_product(&self, value: NodeId, constant: NodeId, other: NodeId) -> bool {
        let product = self.printer.product(value).filter(|(is_negative, ..)| !is_negative);
        product.and_then(|(_, a, b)| self.printer.constant_factor(a, b)) == Some((constant, other))
    }
}
