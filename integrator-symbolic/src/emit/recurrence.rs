//! Recurrences as Rust: what is known since the last order is summed up at the beginning of a block, for all of its
//! values in one loop; the newest coefficients come in where a value is computed.
//!
//! For a product `Σ aⱼ bₖ₋ⱼ`; for a square, half of that; for a power `y = aᵉ`, `Σ (e j - (k - j)) aⱼ yₖ₋ⱼ` over `k a₀`;
//! for `y' = g x'`, `Σ j xⱼ gₖ₋ⱼ` over `k`. Sums run from the middle outwards, so that they begin with coefficients that
//! have been known for long.

use super::{fields::Fields, orders::Writer, tape::Kept};
use crate::{
    graph::{Node, NodeId},
    program::Item,
    taylor::{is_power, signed},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// Where the coefficients of a value are.
#[derive(Clone)]
pub(super) enum Series {
    /// In the rows of a part of the state.
    Row { part: Ident, place: TokenStream },
    /// In a record.
    Kept { at: Ident, name: Ident },
}

impl Series {
    /// The coefficient of an order.
    pub(super) fn of(&self, order: &TokenStream) -> TokenStream {
        match self {
            Series::Row { part, place } => quote!(#part[#order][#place]),
            Series::Kept { at, name } => quote!(#at.kept[#order].#name),
        }
    }
}

/// The products that a recurrence sums up, of coefficients whose orders add up to that of the sum.
struct Products {
    /// The lines for the middle of the sum, and for two orders that are as far from it.
    middle: TokenStream,
    pair: TokenStream,
}

/// The orders in a sum.
fn orders() -> [TokenStream; 3] {
    [quote!(middle), quote!(low), quote!(high)]
}

impl Writer<'_> {
    /// The sums over what is known of the values that a block gives names.
    pub(super) fn known<'i>(&mut self, fields: &mut Fields, items: impl IntoIterator<Item = &'i Item>) -> TokenStream {
        let named = items.into_iter().flat_map(|item| match item {
            Item::Let(id) => vec![*id],
            Item::SineCosine { sine, cosine, .. } => vec![*sine, *cosine],
            _ => Vec::new(),
        });
        let named: Vec<NodeId> = named.filter(|id| self.is_nonlinear(*id)).collect();
        let sums: Vec<(Ident, Products)> =
            named.into_iter().filter_map(|id| Some((self.rest(id), self.products(fields, id)?))).collect();
        if sums.is_empty() {
            return TokenStream::new();
        }
        let rests: Vec<&Ident> = sums.iter().map(|(rest, _)| rest).collect();
        let (middles, pairs) =
            (sums.iter().map(|(_, products)| &products.middle), sums.iter().map(|(_, products)| &products.pair));
        let zero = self.printer.lifted(quote!(0.0));
        quote! {
            #(let mut #rests = #zero;)*
            if order > 0 && order % 2 == 0 {
                let middle = order / 2;
                #(#middles)*
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                #(#pairs)*
            }
        }
    }

    /// What the sum over what is known of a value is called.
    fn rest(&self, id: NodeId) -> Ident {
        format_ident!("rest_of_{}", self.printer.names[&id])
    }

    /// The products that are known, if there are any.
    fn products(&mut self, fields: &mut Fields, id: NodeId) -> Option<Products> {
        let (rest, runtime, scalar) = (self.rest(id), self.printer.runtime, self.printer.scalar);
        let [middle, low, high] = orders();
        let product = |a: &Series, b: &Series| {
            let [a, b] = [a, b].map(|series| orders().map(|order| series.of(&order)));
            let ([a_middle, a_low, a_high], [b_middle, b_low, b_high]) = (a, b);
            Products {
                middle: quote!(#rest = #a_middle * #b_middle;),
                pair: quote!(#rest = #a_low.fma(#b_high, #a_high.fma(#b_low, #rest));),
            }
        };
        // The weight goes with the first factor, which several sums may share.
        let weighted = |weight: &dyn Fn(&TokenStream) -> TokenStream, negative: bool, a: &Series, b: &Series| {
            let [a, b] = [a, b].map(|series| orders().map(|order| series.of(&order)));
            let ([a_middle, a_low, a_high], [b_middle, b_low, b_high]) = (a, b);
            let product = |order: &TokenStream, a: &TokenStream| {
                let weight = weight(order);
                if negative { quote!((-(#weight * #a))) } else { quote!((#weight * #a)) }
            };
            let (of_middle, of_low, of_high) =
                (product(&middle, &a_middle), product(&low, &a_low), product(&high, &a_high));
            Products {
                middle: quote!(#rest = #of_middle.fma(#b_middle, #rest);),
                pair: quote! {
                    #rest = #of_low.fma(#b_high, #rest);
                    #rest = #of_high.fma(#b_low, #rest);
                },
            }
        };
        let own = self.series(fields, id);
        Some(match self.printer.graph.node(id) {
            Node::Mul(a, b) => product(&self.unsigned(fields, a).1, &self.unsigned(fields, b).1),
            Node::Div(_, b) => product(&self.unsigned(fields, b).1, &own),
            Node::Power(a, 4) => {
                let [middle, low, high] = orders().map(|order| self.unsigned(fields, a).1.of(&order));
                let half = self.printer.lifted(quote!(0.5));
                Products {
                    middle: quote!(#rest = #half * #middle * #middle;),
                    pair: quote!(#rest = #low.fma(#high, #rest);),
                }
            }
            Node::Power(a, halves) if self.has_no_slopes(id) => {
                let exponent = Literal::f64_unsuffixed(f64::from(halves) / 2.0);
                let weight = |j: &TokenStream| quote!(#runtime::weight::<#scalar>(#exponent, #j, order));
                weighted(&weight, false, &self.unsigned(fields, a).1, &own)
            }
            Node::Binary(function, a, b) if is_power(function) => {
                let exponent = self.printer.expression(fields, b).tokens;
                let weight = |j: &TokenStream| quote!(#runtime::weight_with(#exponent, #j, order));
                weighted(&weight, false, &self.unsigned(fields, a).1, &own)
            }
            _ => {
                let (mut middle, mut pair) = (TokenStream::new(), TokenStream::new());
                for (negative, _, x, slope) in self.chained(fields, id) {
                    let weight = |j: &TokenStream| quote!(#scalar::of(#j as f64));
                    let products = weighted(&weight, negative, &x, &slope);
                    middle.extend(products.middle);
                    pair.extend(products.pair);
                }
                if pair.is_empty() {
                    return None;
                }
                Products { middle, pair }
            }
        })
    }

    /// The coefficient of an order of a value that is not linear in what it is computed from.
    pub(super) fn recurrence(&mut self, fields: &mut Fields, id: NodeId) -> TokenStream {
        let runtime = self.printer.runtime;
        let (rest, own) = (self.rest(id), self.series(fields, id).of(&quote!(0)));
        match self.printer.graph.node(id) {
            Node::Mul(a, b) => {
                let (new_a, new_b) = (self.newest(fields, a), self.newest(fields, b));
                let ((minus_a, a), (minus_b, b)) = (self.unsigned(fields, a), self.unsigned(fields, b));
                let [a, b] = [a, b].map(|series| series.of(&quote!(0)));
                let sign = (minus_a != minus_b).then(|| quote!(-));
                quote!(if order == 0 { #sign(#new_a * #new_b) } else { #sign #a.fma(#new_b, #new_a.fma(#b, #rest)) })
            }
            Node::Power(a, 4) => {
                let new = self.newest(fields, a);
                let a = self.unsigned(fields, a).1.of(&quote!(0));
                let two = self.printer.lifted(quote!(2.0));
                quote!(if order == 0 { #new * #new } else { #two * #a.fma(#new, #rest) })
            }
            Node::Div(a, b) => {
                let new = self.newest(fields, b);
                let (inverse, inverted) = self.inverse(id, &new);
                let numerator = self.printer.receiver(fields, a);
                let sign = signed(self.printer.graph, b).0.then(|| quote!(-));
                let first = self.printer.computation(fields, id).tokens;
                quote!(if order == 0 {
                    #inverted
                    #first
                } else {
                    (#sign #numerator - #new.fma(#own, #rest)) * #inverse
                })
            }
            Node::Power(a, halves) if self.has_no_slopes(id) => {
                let new = self.newest(fields, a);
                let (inverse, inverted) = self.inverse(id, &new);
                let exponent =
                    self.printer.lifted(Literal::f64_unsuffixed(f64::from(halves) / 2.0).into_token_stream());
                let halves = Literal::i32_unsuffixed(halves);
                quote!(if order == 0 {
                    #inverted
                    #runtime::half_power(#new, #halves)
                } else {
                    #new.fma(#exponent * #own * #inverse, #runtime::over(#rest * #inverse, order))
                })
            }
            Node::Binary(function, a, b) if is_power(function) => {
                let new = self.newest(fields, a);
                let (inverse, inverted) = self.inverse(id, &new);
                let exponent = self.printer.receiver(fields, b);
                quote!(if order == 0 {
                    #inverted
                    #new.powf(#exponent)
                } else {
                    #new.fma(#exponent * #own * #inverse, #runtime::over(#rest * #inverse, order))
                })
            }
            node => {
                let first = match node {
                    Node::Power(a, halves) => {
                        let (a, halves) = (self.printer.expression(fields, a).tokens, Literal::i32_unsuffixed(halves));
                        quote!(#runtime::half_power(#a, #halves))
                    }
                    _ => self.printer.computation(fields, id).tokens,
                };
                let chained = self.chained(fields, id);
                // A function without a slope, such as the sign, stays what it is.
                let later = match chained.is_empty() {
                    true => self.printer.lifted(quote!(0.0)),
                    false => chained.into_iter().fold(
                        quote!(#runtime::over(#rest, order)),
                        |sum, (negative, x, _, slope)| {
                            let (new, slope) = (self.newest(fields, x), slope.of(&quote!(0)));
                            let new = if negative { quote!((-#new)) } else { new };
                            quote!(#new.fma(#slope, #sum))
                        },
                    ),
                };
                quote!(if order == 0 { #first } else { #later })
            }
        }
    }

    /// The coefficient of the present order of a value, without a change of its sign.
    fn newest(&self, fields: &mut Fields, id: NodeId) -> TokenStream {
        self.printer.receiver(fields, signed(self.printer.graph, id).1)
    }

    /// What a function of one argument or two is computed from: whether its sign is changed, an argument, the
    /// coefficients of this, and those of its slope.
    fn chained(&mut self, fields: &mut Fields, id: NodeId) -> Vec<(bool, NodeId, Series, Series)> {
        let (node, slopes) = (self.printer.graph.node(id), self.source.recurrences.slopes[&id]);
        let of_slopes = node.children().zip(slopes).filter_map(|(x, slope)| Some((x, slope?)));
        let chained = of_slopes.map(|(x, slope)| {
            let ((minus_x, of_x), (minus_slope, slope)) = (self.unsigned(fields, x), self.unsigned(fields, slope));
            (minus_x != minus_slope, x, of_x, slope)
        });
        chained.collect()
    }

    fn has_no_slopes(&self, id: NodeId) -> bool {
        self.source.recurrences.slopes[&id] == [None, None]
    }

    /// The coefficients of a value, and whether their sign is changed.
    fn unsigned(&mut self, fields: &mut Fields, id: NodeId) -> (bool, Series) {
        let (negative, id) = signed(self.printer.graph, id);
        (negative, self.series(fields, id))
    }

    /// Where one over the value that a recurrence divides by is kept, and the line that keeps it.
    fn inverse(&mut self, id: NodeId, divisor: &TokenStream) -> (TokenStream, TokenStream) {
        let (name, scalar) = (format_ident!("over_{}", self.printer.names[&id]), self.printer.scalar);
        let record = self.record();
        record.slots.push((name.clone(), Kept::Number));
        let at = &record.at;
        (quote!(#at.#name), quote!(#at.#name = #scalar::of(1.0) / #divisor;))
    }
}
