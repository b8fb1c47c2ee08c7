//! Numbers that are computed from several parameters as one parameter, whose table is prepared once per run.

use super::{parameter_text::Texts, running_index::running_index, text::in_parentheses};
use crate::graph::{
    Graph, Node, NodeId, ParameterId,
    index::{IndexId, LoopId, LoopSet},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Texts<'_> {
    /// A prepared number of several loops as a parameter, because only parameters have tables over several loops. Others stay what
    /// they are; `None` if the text of a parameter does not stand alone.
    pub(crate) fn as_table(&mut self, graph: &mut Graph, number: NodeId) -> Option<NodeId> {
        if graph.loops_of(number).iter().count() < 2 {
            return Some(number);
        }
        let table = self.as_parameter(graph, number)?;
        Some(graph.parameter(table))
    }

    /// A prepared number as a parameter; `None` likewise.
    pub(crate) fn as_parameter(&mut self, graph: &mut Graph, number: NodeId) -> Option<ParameterId> {
        if let Node::Parameter(parameter) = graph.node(number) {
            return Some(parameter);
        }
        let (text, own) = (self.composed(graph, number, Self::text)?, self.composed(graph, number, Self::own_text)?);
        let loops = graph.loops_of(number);
        let parameter = self.id(graph, text, loops);
        self.show(parameter, &own);
        Some(parameter)
    }

    /// A prepared number that is zero from the ends of loops on, where a list that one of these ends by is not read; `None` likewise.
    pub(crate) fn ended(&mut self, graph: &mut Graph, number: NodeId, ends: [(LoopId, IndexId); 2]) -> Option<NodeId> {
        let (text, own) = (self.composed(graph, number, Self::text)?, self.composed(graph, number, Self::own_text)?);
        let mut loops = graph.loops_of(number);
        let mut is_within = Vec::new();
        for (by, end) in ends {
            let (index, text) = (running_index(by), self.text_of(graph, end)?);
            is_within.push(quote!(#index < #text));
            loops = loops.union(LoopSet::of(by)).union(graph.loops.of_index(end));
        }
        let ended = self.id(graph, quote!((if #(#is_within)&&* { #text } else { 0.0 })), loops);
        self.show(ended, &own);
        Some(graph.parameter(ended))
    }

    /// The text of a number that is made of parameters by simple operations.
    fn composed(
        &self,
        graph: &Graph,
        number: NodeId,
        of_parameter: fn(&Self, ParameterId) -> TokenStream,
    ) -> Option<TokenStream> {
        let of = |id| self.composed(graph, id, of_parameter).map(in_parentheses);
        Some(match graph.node(number) {
            Node::Constant(bits) => {
                let value = Some(f64::from_bits(bits)).filter(|value| value.is_finite())?;
                let value = Literal::f64_unsuffixed(value);
                quote!(#value)
            }
            Node::Parameter(parameter) => self.is_plain_number(parameter).then(|| of_parameter(self, parameter))?,
            Node::Neg(a) => {
                let a = of(a)?;
                quote!(-#a)
            }
            Node::Add(a, b) => match graph.node(b) {
                Node::Neg(b) => {
                    let (a, b) = (of(a)?, of(b)?);
                    quote!(#a - #b)
                }
                _ => {
                    let (a, b) = (of(a)?, of(b)?);
                    quote!(#a + #b)
                }
            },
            Node::Mul(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!(#a * #b)
            }
            Node::Div(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!(#a / #b)
            }
            _ => return None,
        })
    }
}
