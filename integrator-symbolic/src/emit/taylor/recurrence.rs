//! Rust code for recurrences. The terms that are known from lower orders are summed at the beginning of a block, for
//! all of its values. The newest coefficients are added when a value is computed.
//!
//! - A product: `Σ aⱼ bₖ₋ⱼ`; a square needs half of the terms.
//! - A power `y = aᵉ`: `Σ (e j - (k - j)) aⱼ yₖ₋ⱼ` divided by `k a₀`.
//! - `y' = g x'`: `Σ j xⱼ gₖ₋ⱼ` divided by `k`.
//!
//! Sums run from the middle outwards, so they begin with coefficients that were computed long before.

use super::{
    edges::touches_zero,
    tape::{Kept, Series},
    writer::Writer,
};
use crate::{
    emit::printer::fields::Fields,
    graph::{Node, NodeId},
    program::Item,
    taylor::is_power,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The products that a recurrence sums up, of coefficients whose orders add up to that of the sum.
pub(super) struct Products {
    pub(super) weight: Weight,
    /// What the two factors are coefficients of.
    pub(super) factors: [Factor; 2],
    pub(super) a: Series,
    pub(super) b: Series,
}

/// What coefficients are those of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Factor {
    Value(NodeId),
    /// The derivative of a value.
    Rate(NodeId),
}

impl Factor {
    /// The value.
    pub(super) fn value(self) -> NodeId {
        let (Self::Value(id) | Self::Rate(id)) = self;
        id
    }
}

/// The factor of each product.
pub(super) enum Weight {
    /// One.
    None,
    /// One half where both factors are the same coefficient, since two others stand for each other.
    Half,
    /// `e j - (k - j)` for a power, by the function that computes it with an exponent, which is a number of the flow
    /// too.
    Power { function: TokenStream, exponent: TokenStream, number: TokenStream },
    /// The order of the first factor, or minus that.
    Order { negative: bool },
    /// One or minus one, since the first factor has been multiplied by its order.
    Rate { negative: bool },
}

/// What a function of one argument or two is computed from: an argument, the coefficients of this, and those of the
/// slope.
pub(super) struct Chained {
    /// Whether the product is subtracted.
    pub(super) negative: bool,
    pub(super) x: NodeId,
    series: Series,
    pub(super) slope: Series,
    of_slope: NodeId,
}

/// A value, the name of the sum of its known products, and these products.
pub(super) type Known = (NodeId, Ident, Vec<Products>);

/// A sum of products whose orders add up to `order`.
pub(super) struct Sum {
    rest: TokenStream,
    order: TokenStream,
}

impl Sum {
    pub(super) fn of(rest: impl ToTokens, order: impl ToTokens) -> Self {
        Self { rest: rest.into_token_stream(), order: order.into_token_stream() }
    }
}

impl Writer<'_> {
    /// The sums over what is known of the values that a block gives names.
    pub(super) fn known<'i>(&mut self, fields: &mut Fields, items: impl IntoIterator<Item = &'i Item>) -> TokenStream {
        let sums = self.sums(fields, items);
        if sums.is_empty() {
            return TokenStream::new();
        }
        if self.is_unrolled() {
            return self.known_unrolled(fields, &sums);
        }
        let zero = self.printer.lift(quote!(0.0));
        let (mut middles, mut pairs) = (TokenStream::new(), TokenStream::new());
        for (_, rest, products) in &sums {
            let sum = Sum::of(rest, quote!(order));
            for products in products {
                middles.extend(self.middle(&sum, products));
                pairs.extend(self.pair(&sum, products, [&quote!(low), &quote!(high)]));
            }
        }
        let rests = sums.iter().map(|(_, rest, _)| rest);
        quote! {
            #(let mut #rests = #zero;)*
            if order > 0 && order % 2 == 0 {
                let middle = order / 2;
                #middles
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                #pairs
            }
        }
    }

    /// The same of an even order together with the next one, which share coefficients: the lines that begin with the even
    /// one, and those that each of the two begins with, since the second one needs what the first one finds.
    pub(super) fn known_of_two<'i>(
        &mut self,
        fields: &mut Fields,
        items: impl IntoIterator<Item = &'i Item>,
    ) -> [TokenStream; 2] {
        let sums = self.sums(fields, items);
        if sums.is_empty() {
            return [TokenStream::new(), TokenStream::new()];
        }
        let zero = self.printer.lift(quote!(0.0));
        let (low, next, high) = (quote!(low), quote!(next), quote!(high));
        let (mut middles, mut pairs, mut newest) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
        for (id, rest, products) in &sums {
            self.of_two.insert(*id);
            let [even, odd] =
                [Sum::of(quote!(#rest[0]), quote!(order)), Sum::of(quote!(#rest[1]), quote!((order + 1)))];
            let of_second = Sum::of(quote!(#rest[1]), quote!(order));
            for products in products {
                middles.extend(self.middle(&even, products));
                pairs.extend(self.pair(&even, products, [&low, &high]));
                pairs.extend(self.pair(&odd, products, [&next, &high]));
                newest.extend(self.pair(&of_second, products, [&low, &high]));
            }
        }
        let rests = sums.iter().map(|(_, rest, _)| rest);
        let known = quote! {
            #(let mut #rests = [#zero; 2];)*
            if order > 0 {
                let middle = order / 2;
                #middles
            }
            for low in (1..order / 2).rev() {
                let (next, high) = (low + 1, order - low);
                #pairs
            }
        };
        let newest = quote! {
            if at == 1 && order > 1 {
                let (low, high) = (1, order - 1);
                #newest
            }
        };
        [known, newest]
    }

    /// The line for the middle of a sum.
    pub(super) fn middle(&self, Sum { rest, order }: &Sum, Products { weight, a, b, .. }: &Products) -> TokenStream {
        let middle = quote!(middle);
        let [a, b] = [a, b].map(|series| series.of(&middle));
        match weight {
            Weight::None => quote!(#rest = #a * #b;),
            Weight::Half => {
                let half = self.printer.lift(quote!(0.5));
                quote!(#rest = #half * #a * #b;)
            }
            weight => {
                let a = self.weighted(weight, &middle, order, &a);
                quote!(#rest = #a.fma(#b, #rest);)
            }
        }
    }

    /// The lines for two orders that are as far from the middle.
    pub(super) fn pair(
        &self,
        Sum { rest, order }: &Sum,
        Products { weight, a, b, .. }: &Products,
        [low, high]: [&TokenStream; 2],
    ) -> TokenStream {
        let [a_low, b_low] = [a, b].map(|series| series.of(low));
        let [a_high, b_high] = [a, b].map(|series| series.of(high));
        match weight {
            Weight::None => quote!(#rest = #a_low.fma(#b_high, #a_high.fma(#b_low, #rest));),
            Weight::Half => quote!(#rest = #a_low.fma(#b_high, #rest);),
            weight => {
                let (a_low, a_high) =
                    (self.weighted(weight, low, order, &a_low), self.weighted(weight, high, order, &a_high));
                quote! {
                    #rest = #a_low.fma(#b_high, #rest);
                    #rest = #a_high.fma(#b_low, #rest);
                }
            }
        }
    }

    /// The first factor of order `j` with its weight, which several sums may share.
    pub(super) fn weighted(
        &self,
        weight: &Weight,
        j: &TokenStream,
        order: &TokenStream,
        a: &TokenStream,
    ) -> TokenStream {
        let scalar = self.printer.scalar;
        match weight {
            Weight::None | Weight::Half => a.clone(),
            Weight::Power { function, exponent, .. } => quote!((#function(#exponent, #j, #order) * #a)),
            Weight::Order { negative } => minus(*negative, quote!((#scalar::of(#j as f64) * #a))),
            Weight::Rate { negative } => minus(*negative, a.clone()),
        }
    }

    /// The values of a block that have sums, and the names of these.
    fn sums<'i>(&mut self, fields: &mut Fields, items: impl IntoIterator<Item = &'i Item>) -> Vec<Known> {
        let named = items.into_iter().flat_map(Item::named);
        let is_open = |id: &NodeId| self.is_nonlinear(*id) && !self.of_two.contains(id);
        let named: Vec<NodeId> = named.filter(is_open).collect();
        let sums = named.into_iter().map(|id| (id, self.rest(id), self.products(fields, id)));
        sums.filter(|(.., products)| !products.is_empty()).collect()
    }

    /// The name of the sum of a value's known products.
    fn rest(&self, id: NodeId) -> Ident {
        format_ident!("rest_of_{}", self.printer.names[&id])
    }

    /// That sum, when the value is computed.
    pub(super) fn rest_of(&self, id: NodeId) -> TokenStream {
        let rest = self.rest(id);
        if self.of_two.contains(&id) { quote!(#rest[at]) } else { quote!(#rest) }
    }

    /// The products that a value sums up.
    pub(super) fn products(&mut self, fields: &mut Fields, id: NodeId) -> Vec<Products> {
        let (runtime, scalar) = (self.printer.runtime, self.printer.scalar);
        let (weight, a, b) = match self.printer.graph.node(id) {
            Node::Mul(a, b) => (Weight::None, a, b),
            Node::Div(_, b) => (Weight::None, b, id),
            Node::Power(a, 4) => (Weight::Half, a, a),
            Node::Power(a, halves) if self.has_no_slopes(id) => {
                let exponent = Literal::f64_unsuffixed(f64::from(halves) / 2.0);
                let (function, exponent) = (quote!(#runtime::power_weight::<#scalar>), exponent.into_token_stream());
                let number = self.printer.lift(exponent.clone());
                (Weight::Power { function, exponent, number }, a, id)
            }
            Node::Binary(function, a, b) if is_power(function) => {
                let exponent = self.printer.expression(fields, b).tokens;
                let function = quote!(#runtime::power_weight_with);
                let number = exponent.clone();
                (Weight::Power { function, exponent, number }, a, id)
            }
            _ => {
                let chained = self.chained(fields, id);
                let negated = self.is_negated(&chained);
                let products = chained.into_iter().map(|Chained { negative, x, series, slope, of_slope }| {
                    let negative = negative && !negated;
                    let (weight, a) = match self.rate(x) {
                        Some(rate) => (Weight::Rate { negative }, rate.clone()),
                        None => (Weight::Order { negative }, series),
                    };
                    let x = self.printer.graph.signed(x).1;
                    Products { weight, factors: [Factor::Rate(x), Factor::Value(of_slope)], a, b: slope }
                });
                return products.collect();
            }
        };
        let [a, b] = [a, b].map(|id| self.printer.graph.signed(id).1);
        let factors = [a, b].map(Factor::Value);
        vec![Products { weight, factors, a: self.series(fields, a), b: self.series(fields, b) }]
    }

    /// The coefficient of an order of a value that is not linear in what it is computed from.
    pub(super) fn recurrence(&mut self, fields: &mut Fields, id: NodeId) -> TokenStream {
        let runtime = self.printer.runtime;
        let rest = self.rest_of(id);
        let own = self.series(fields, id).of(&quote!(0));
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
                let two = self.printer.lift(quote!(2.0));
                quote!(if order == 0 { #new * #new } else { #two * #a.fma(#new, #rest) })
            }
            Node::Div(a, b) => {
                let new = self.newest(fields, b);
                let (inverse, inverted) = self.inverse(id, &new);
                let numerator = self.printer.receiver(fields, a);
                let sign = self.printer.graph.signed(b).0.then(|| quote!(-));
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
                let exponent = self.printer.lift(Literal::f64_unsuffixed(f64::from(halves) / 2.0).into_token_stream());
                let is_root = halves > 0;
                let halves = Literal::i32_unsuffixed(halves);
                let first = quote!(#inverted #runtime::half_power(#new, #halves));
                let newest = [[new, quote!(#exponent * #own * #inverse)]];
                let value = self.divided(fields, id, &first, &newest, |x| quote!(#x * #inverse));
                if is_root && touches_zero(self.printer.graph, a) {
                    return self.at_zero(fields, a, &value, &exponent);
                }
                value
            }
            Node::Binary(function, a, b) if is_power(function) => {
                let new = self.newest(fields, a);
                let (inverse, inverted) = self.inverse(id, &new);
                let exponent = self.printer.receiver(fields, b);
                let first = quote!(#inverted #new.powf(#exponent));
                let newest = [[new, quote!(#exponent * #own * #inverse)]];
                let value = self.divided(fields, id, &first, &newest, |x| quote!(#x * #inverse));
                // A parameter may be a whole number, whose power is smooth where its base is zero.
                let may_be_smooth = match self.printer.graph.as_constant(b) {
                    Some(exponent) => exponent > 0.0 && touches_zero(self.printer.graph, a),
                    None => true,
                };
                if may_be_smooth { self.at_zero(fields, a, &value, &exponent) } else { value }
            }
            node => {
                let first = match node {
                    Node::Power(a, halves) => {
                        let (a, halves) = (self.printer.expression(fields, a).tokens, Literal::i32_unsuffixed(halves));
                        quote!(#runtime::half_power(#a, #halves))
                    }
                    Node::Unary(function, _) if matches!(function.name(), "exp" | "exp2") => {
                        let exponential = self.printer.computation(fields, id).tokens;
                        quote!(#runtime::bounded(#exponential))
                    }
                    _ => self.printer.computation(fields, id).tokens,
                };
                let chained = self.chained(fields, id);
                if chained.is_empty() {
                    // A function without a slope, such as the sign, stays what it is.
                    let zero = self.printer.lift(quote!(0.0));
                    return quote!(if order == 0 { #first } else { #zero });
                }
                let negated = self.is_negated(&chained);
                let newest: Vec<_> = chained.iter().map(|chained| self.newest_product(fields, chained)).collect();
                self.divided(fields, id, &first, &newest, |x| minus(negated, x))
            }
        }
    }

    /// The coefficient of a power, of which `value` is right where the base does not begin at zero.
    fn at_zero(
        &mut self,
        fields: &mut Fields,
        base: NodeId,
        value: &TokenStream,
        exponent: &TokenStream,
    ) -> TokenStream {
        let runtime = self.printer.runtime;
        let (negative, base) = self.unsigned(fields, base);
        let base = minus(negative, base.of(&quote!(order)));
        quote!(#runtime::power_at_zero(#value, #exponent, order, |order| #base))
    }

    /// The coefficient of the present order of a value, without a change of its sign.
    pub(super) fn newest(&self, fields: &mut Fields, id: NodeId) -> TokenStream {
        self.printer.receiver(fields, self.printer.graph.signed(id).1)
    }

    /// The arguments of a function with the slopes.
    fn chained(&mut self, fields: &mut Fields, id: NodeId) -> Vec<Chained> {
        let (node, slopes) = (self.printer.graph.node(id), self.source.recurrences.slopes[&id]);
        let of_slopes = node.children().zip(slopes).filter_map(|(x, slope)| Some((x, slope?)));
        let chained = of_slopes.map(|(x, slope)| {
            let of_slope = self.printer.graph.signed(slope).1;
            let ((minus_x, series), (minus_slope, slope)) = (self.unsigned(fields, x), self.unsigned(fields, slope));
            Chained { negative: minus_x != minus_slope, x, series, slope, of_slope }
        });
        chained.collect()
    }

    fn has_no_slopes(&self, id: NodeId) -> bool {
        self.source.recurrences.slopes[&id] == [None, None]
    }

    /// The coefficients of a value, and whether their sign is changed.
    fn unsigned(&mut self, fields: &mut Fields, id: NodeId) -> (bool, Series) {
        let (negative, id) = self.printer.graph.signed(id);
        (negative, self.series(fields, id))
    }

    /// The slot of the reciprocal of a recurrence's divisor, and the line that stores it.
    fn inverse(&mut self, id: NodeId, divisor: &TokenStream) -> (TokenStream, TokenStream) {
        let (name, scalar) = (format_ident!("over_{}", self.printer.names[&id]), self.printer.scalar);
        let record = self.record();
        record.keep(name.clone(), Kept::Number);
        let at = &record.at;
        (quote!(#at.#name), quote!(#at.#name = #scalar::of(1.0) / #divisor;))
    }
}

/// Something, or minus that.
pub(super) fn minus(negative: bool, x: TokenStream) -> TokenStream {
    if negative { quote!((-#x)) } else { x }
}
