//! Friction: the rates and temperatures of all coordinates, as the gradients of linear functions of the positions.

use crate::{
    errors::Errors,
    graph::{NodeId, Part},
    model::{
        Reader,
        code::shape::{Shape, signature},
    },
    syntax::{Friction, RateFunction},
};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{ImplItemFn, parse_quote};

/// What friction is computed from.
pub(crate) struct Rates {
    /// The sum of the rates, each times its position.
    pub(crate) rates: NodeId,
    /// The same of the temperatures.
    pub(crate) temperatures: Option<NodeId>,
    /// Whether one of them depends on time.
    pub(crate) read_time: bool,
}

impl Reader<'_> {
    /// The friction of a system with coordinates of this shape.
    pub(crate) fn rates(&mut self, friction: &Friction, shape: &Shape) -> Option<Rates> {
        let rates = self.times_positions(&friction.rate, shape)?;
        let temperatures = match &friction.temperature {
            Some(temperature) => Some(self.times_positions(temperature, shape)?),
            None => None,
        };
        let nodes = [Some(rates), temperatures];
        let read_time = nodes.into_iter().flatten().any(|node| self.graph.reads_time(node));
        Some(Rates { rates, temperatures, read_time })
    }

    /// The sum of a function of the index, each time with the positions that the index has.
    fn times_positions(&mut self, RateFunction { name, reads_time }: &RateFunction, shape: &Shape) -> Option<NodeId> {
        let kind: syn::Type = syn::parse_str(&shape.text()).ok()?;
        let time = reads_time.then(|| quote!(t));
        let time = time.iter();
        let value = quote!(self.#name(i #(, #time)*));
        let indices: Vec<_> = (0..shape.inner.len()).map(|level| quote::format_ident!("k{level}")).collect();
        let mut body: TokenStream = quote!(sum += #value * q[i] #([#indices])*;);
        for (length, index) in shape.inner.iter().zip(&indices).rev() {
            let length = length.tokens();
            body = quote!(for #index in 0..#length { #body });
        }
        let function: ImplItemFn = parse_quote! {
            fn rates(&self, q: #kind, t: f64) -> f64 {
                let mut sum = 0.0;
                for i in 0..q.len() { #body }
                sum
            }
        };
        let signature = signature(&function, Part::Position, &mut Errors::default())?;
        self.energy(Part::Position, &function, &signature)
    }
}
