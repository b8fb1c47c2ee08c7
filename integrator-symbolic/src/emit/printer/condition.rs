//! Rust code for conditions: masks of lanes in a flow, `bool` in the preparation of parameters.

use super::{
    expression::{Binding, Dialect, Printer},
    fields::Fields,
    frame::Frame,
};
use crate::{
    graph::{Comparison, Node, NodeId, Part},
    program::Watched,
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

impl Printer<'_> {
    /// A condition: a mask of lanes in a flow, `bool` where parameters are prepared.
    pub(crate) fn condition(&self, fields: &mut Fields, condition: Node) -> TokenStream {
        let runtime = self.runtime;
        let scalar = self.scalar;
        match (condition, self.dialect) {
            (Node::Compare(comparison, a, b), _)
                if matches!(self.frame, Frame::Edges) && (self.graph.moves(a) || self.graph.moves(b)) =>
            {
                let (method, of_time) = (method(comparison), self.of_time(&[a, b]));
                let [a, b] = [a, b].map(|side| self.expression(fields, side).tokens);
                quote!({ #of_time watch.#method(#a, #b) })
            }
            (Node::Compare(comparison, a, b), Dialect::Generic) => {
                let a = self.expression(fields, a).at_least(Binding::Atom);
                let (b, method) = (self.expression(fields, b).tokens, method(comparison));
                quote!(#a.#method(#b))
            }
            (Node::Compare(comparison, a, b), Dialect::Single) => {
                let (a, b) = (self.expression(fields, a), self.expression(fields, b));
                let (a, b, sign) = (a.at_least(Binding::Sum), b.at_least(Binding::Sum), sign(comparison));
                quote!(((#a) #sign (#b)))
            }
            (Node::CompareIndex(comparison, a, b), dialect) => {
                let signed = [a, b].iter().any(|id| self.graph.loops.is_signed(*id));
                let [a, b] =
                    [a, b].map(|id| if signed { self.signed_index(fields, id) } else { self.index(fields, id) });
                let sign = sign(comparison);
                match dialect {
                    Dialect::Generic => quote!(<#scalar::Mask as #runtime::Mask>::of((#a) #sign (#b))),
                    Dialect::Single => quote!(((#a) #sign (#b))),
                }
            }
            (Node::Flag(parameter), Dialect::Generic) => {
                let name = fields.flag(self.parameters, parameter);
                let flag = self.shared(name, self.graph.loops.of_parameter(parameter));
                let zero = self.lift(quote!(0.0));
                quote!(#zero.less(#flag))
            }
            (Node::Flag(parameter), Dialect::Single) => {
                let text = self.parameters[parameter.0 as usize].named_text(self.running);
                quote!((#text))
            }
            (Node::And(a, b), dialect) => {
                let (a, b) = (self.expression(fields, a).tokens, self.expression(fields, b).tokens);
                if dialect == Dialect::Generic { quote!(#a.and(#b)) } else { quote!((#a && #b)) }
            }
            (Node::Or(a, b), dialect) => {
                let (a, b) = (self.expression(fields, a).tokens, self.expression(fields, b).tokens);
                if dialect == Dialect::Generic { quote!(#a.or(#b)) } else { quote!((#a || #b)) }
            }
            (Node::Not(a), dialect) => {
                let a = self.expression(fields, a).tokens;
                if dialect == Dialect::Generic { quote!(#a.not()) } else { quote!((!#a)) }
            }
            // Numbers are printed elsewhere.
            _ => TokenStream::new(),
        }
    }
}

impl Printer<'_> {
    /// The line that shows a value to what watches edges. A comparison is shown by the line that computes it.
    pub(crate) fn shown(&self, fields: &mut Fields, watched: Watched, value: NodeId) -> TokenStream {
        let (runtime, of_time) = (self.runtime, self.of_time(&[value]));
        let value = self.expression(fields, value).tokens;
        match watched {
            Watched::Side => TokenStream::new(),
            Watched::Root => quote!(watch.root(#value);),
            Watched::Level(function) => {
                let level = match function {
                    "floor" => quote!(Floor),
                    "ceil" => quote!(Ceil),
                    "trunc" => quote!(Trunc),
                    _ => quote!(Round),
                };
                quote!(#of_time watch.level(#value, #runtime::Level::#level);)
            }
        }
    }

    /// The line that says of the next condition that no coordinate is part of it.
    fn of_time(&self, sides: &[NodeId]) -> Option<TokenStream> {
        let reads = |id: &NodeId| self.graph.reads(*id, Part::Position) || self.graph.reads(*id, Part::Momentum);
        (!sides.iter().any(reads)).then(|| quote!(watch.of_time();))
    }
}

/// The method of the runtime's reals that compares.
fn method(comparison: Comparison) -> Ident {
    match comparison {
        Comparison::Less => format_ident!("less"),
        Comparison::LessOrEqual => format_ident!("less_or_equal"),
        Comparison::Equal => format_ident!("equal"),
    }
}

fn sign(comparison: Comparison) -> TokenStream {
    match comparison {
        Comparison::Less => quote!(<),
        Comparison::LessOrEqual => quote!(<=),
        Comparison::Equal => quote!(==),
    }
}
