//! Recurrences with separately compiled orders, for a state of a few numbers. The bottleneck is the latency from one
//! order to the next.
//!
//! For a sum `Σ aⱼ bₖ₋ⱼ` that is divided by `k`, the other terms are divided first. Then the product with the newest
//! `b` is added, with an `a₁/k` that was computed long before. For `y' = g x'`, the coefficients `j xⱼ` of `x'` are
//! stored: those of a coordinate are available before its own coefficients, which need a division by the order.

use super::{
    accumulation::Accumulation,
    pairs::Sums,
    recurrence::{Chained, Factor, Known, Products, Sum, Weight, minus},
    tape::{Kept, Series},
    writer::Writer,
};
use crate::{
    emit::printer::fields::Fields,
    graph::{Element, Node, NodeId},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

impl Writer<'_> {
    /// Whether orders are compiled one by one.
    pub(super) fn is_unrolled(&self) -> bool {
        matches!(self.accumulation, Accumulation::Scalars(_))
    }

    /// Allocates the coefficients of `x'`, where a value is computed by `y' = g x'`.
    pub(super) fn allocate_rates(&mut self, id: NodeId) {
        if !self.is_unrolled() || !self.is_nonlinear(id) {
            return;
        }
        let (node, slopes) = (self.printer.graph.node(id), self.source.recurrences.slopes[&id]);
        for (x, _) in node.children().zip(slopes).filter(|(_, slope)| slope.is_some()) {
            let x = self.printer.graph.signed(x).1;
            let is_clock = matches!(self.printer.graph.node(x), Node::Time | Node::Step);
            if is_clock || self.rate(x).is_some() {
                continue;
            }
            let name = format_ident!("rates_{}", self.rates.len());
            let record = self.record();
            record.keep(name.clone(), Kept::Rates);
            let rate = Series::Own { at: record.at.clone(), name };
            self.rates.push((x, rate));
        }
    }

    /// The coefficients of the derivative of a value.
    pub(super) fn rate(&self, id: NodeId) -> Option<&Series> {
        let id = self.printer.graph.signed(id).1;
        self.rates.iter().find(|(known, _)| *known == id).map(|(_, rate)| rate)
    }

    /// The line that keeps such a coefficient of a value that has just been computed.
    pub(super) fn keep_rate(&self, id: NodeId) -> Option<TokenStream> {
        let (name, scalar) = (&self.printer.names[&id], self.printer.scalar);
        let rate = self.rate(id)?.of(&quote!(order));
        Some(quote!(#rate = #scalar::of(order as f64) * #name;))
    }

    /// The line that keeps that of a coordinate: what its own one is before it is divided by its order.
    pub(super) fn keep_rate_of(&self, element: &Element, next: &impl ToTokens) -> Option<TokenStream> {
        let rate = self.rate_of(element)?.of(&quote!(order + 1));
        Some(quote!(#rate = #next;))
    }

    /// The coefficients of the derivative of a coordinate.
    pub(super) fn rate_of(&self, element: &Element) -> Option<&Series> {
        let is_of = |(id, _): &&(NodeId, Series)| self.printer.graph.node(*id) == Node::Coordinate(*element);
        self.rates.iter().find(is_of).map(|(_, rate)| rate)
    }

    /// The product with the newest coefficient of what a value is computed from, to be added to a sum that has been
    /// divided by the order.
    pub(super) fn newest_product(&self, fields: &mut Fields, chained: &Chained) -> [TokenStream; 2] {
        let Chained { negative, x, slope, .. } = chained;
        let (runtime, slope) = (self.printer.runtime, slope.of(&quote!(0)));
        match (self.rate(*x), self.printer.graph.node(self.printer.graph.signed(*x).1)) {
            (Some(rate), Node::Coordinate(_)) => {
                [minus(*negative, rate.of(&quote!(order))), quote!(#runtime::div_by_order(#slope, order))]
            }
            _ => [minus(*negative, self.newest(fields, *x)), slope],
        }
    }

    /// The sums over what is known. Those that are divided by the order are without the latest product. Those of rates
    /// are two, for the products with earlier and with later coefficients of the slope, so that each is half as long.
    /// Each sum has a loop of its own, so short that the compiler unrolls it before anything else.
    pub(super) fn known_unrolled(&mut self, fields: &mut Fields, sums: &[Known]) -> TokenStream {
        let mut lines = Lines::default();
        for sums in Sums::of(sums) {
            match sums {
                Sums::Two { of, factors, common } => self.two_sums(fields, &mut lines, of, factors, common),
                Sums::Halves { of, factors } => self.two_halves(fields, &mut lines, of, factors),
                Sums::One((id, rest, products)) => match products.as_slice() {
                    [Products { weight: Weight::Power { number, .. }, factors, .. }] => {
                        self.power_sums(fields, &mut lines, (*id, rest), number, *factors);
                    }
                    products => self.product_sums(&mut lines, (*id, rest), products),
                },
            }
        }
        lines.tokens()
    }

    fn product_sums(&self, lines: &mut Lines, (id, rest): (NodeId, &Ident), products: &[Products]) {
        let zero = self.printer.lift(quote!(0.0));
        if let [square @ Products { weight: Weight::Half, .. }] = products {
            let sum = Sum::of(rest, quote!(order));
            lines.begin.extend(quote!(let mut #rest = #zero;));
            lines.middle.extend(self.middle(&sum, square));
            lines.outwards(1, &self.pair(&sum, square, [&quote!(low), &quote!(high)]));
            return;
        }
        let name = &self.printer.names[&id];
        let halves = ["early", "late"].map(|half| format_ident!("{half}_of_{name}"));
        lines.begin.extend(quote!(#(let mut #halves = #zero;)*));
        for product in products {
            lines.halves(
                halves.each_ref(),
                orders().map(|j| self.factor(product, &j)),
                orders().map(|j| product.b.of(&j)),
            );
        }
        lines.end.extend(quote!(let #rest = #(#halves)+*;));
    }

    /// Two sums of products.
    fn two_sums(
        &mut self,
        fields: &mut Fields,
        lines: &mut Lines,
        of: [&Known; 2],
        factors: [Factor; 2],
        common: Option<Factor>,
    ) {
        let [one, other] = of.map(|(id, ..)| &self.printer.names[id]);
        let both = format_ident!("{one}_and_{other}");
        let rests = of.map(|(_, rest, _)| rest);
        let zero = self.twice(quote!(0.0));
        let (series, known) = self.side_by_side(fields, factors);
        lines.begin.extend(known);
        let pairs = orders().map(|j| self.pair_of(&series, &j));
        if let Some(rate @ Factor::Rate(_)) = common {
            let halves = ["early", "late"].map(|half| format_ident!("{half}_of_{both}"));
            lines.begin.extend(quote!(#(let mut #halves = #zero;)*));
            lines.halves(halves.each_ref(), orders().map(|j| self.twice_of(fields, rate, &j)), pairs);
            lines.end.extend(quote!(let [#(#rests),*] = (#(#halves)+*).parts();));
            return;
        }
        let [pair_middle, pair_low, pair_high] = pairs;
        let sums = format_ident!("rest_of_{both}");
        lines.begin.extend(quote!(let mut #sums = #zero;));
        match common {
            None => {
                let half = self.twice(quote!(0.5));
                lines.middle.extend(quote!(#sums = #half * #pair_middle * #pair_middle;));
                lines.outwards(1, &quote!(#sums = #pair_low.fma(#pair_high, #sums);));
            }
            Some(common) => {
                let [common_middle, common_low, common_high] = orders().map(|j| self.twice_of(fields, common, &j));
                lines.middle.extend(quote!(#sums = #pair_middle * #common_middle;));
                let line = quote!(#sums = #pair_low.fma(#common_high, #pair_high.fma(#common_low, #sums)););
                lines.outwards(1, &line);
            }
        }
        lines.end.extend(quote!(let [#(#rests),*] = #sums.parts();));
    }

    /// The halves of a sum of products.
    fn two_halves(&mut self, fields: &mut Fields, lines: &mut Lines, (id, rest, _): &Known, factors: [Factor; 2]) {
        let halves = format_ident!("halves_of_{}", self.printer.names[id]);
        let [zero, half] = [quote!(0.0), quote!(0.5)].map(|number| self.twice(number));
        let (series, known) = self.side_by_side(fields, factors);
        let [middle, low, high] = orders().map(|j| self.pair_of(&series, &j));
        lines.begin.extend(quote!(#known let mut #halves = #zero;));
        lines.middle.extend(quote!(#halves = #half * #middle * #middle.swap();));
        lines.outwards(1, &quote!(#halves = #low.fma(#high.swap(), #halves);));
        lines.end.extend(quote!(let #rest = #halves.total();));
    }

    /// The two sums of a power `y = aᵉ`, `Σ aⱼ yₖ₋ⱼ` and `Σ j aⱼ yₖ₋ⱼ`, whose products have no weights of their own.
    fn power_sums(
        &mut self,
        fields: &mut Fields,
        lines: &mut Lines,
        (id, rest): (NodeId, &Ident),
        exponent: &TokenStream,
        [base, own]: [Factor; 2],
    ) {
        let (runtime, scalar, zero) = (self.printer.runtime, self.printer.scalar, self.twice(quote!(0.0)));
        let halves = ["early", "late"].map(|half| format_ident!("{half}_of_{}", self.printer.names[&id]));
        let (series, known) = self.side_by_side(fields, [base, Factor::Rate(base.value())]);
        let own = orders().map(|j| self.twice_of(fields, own, &j));
        lines.begin.extend(quote!(#known #(let mut #halves = #zero;)*));
        lines.halves(halves.each_ref(), orders().map(|j| self.pair_of(&series, &j)), own);
        lines.end.extend(quote!(let #rest = #runtime::power_sum::<#scalar>(#exponent, order, #(#halves)+*);));
    }

    /// The first factor of order `j`.
    fn factor(&self, Products { weight, a, .. }: &Products, j: &TokenStream) -> TokenStream {
        self.weighted(weight, j, &quote!(order), &a.of(j))
    }

    /// A coefficient: the first one by its own lines, the others by the sum over what is known, which is divided by the
    /// order, with `newest` products after that. `scaled` makes of a sum what is divided.
    pub(super) fn divided(
        &mut self,
        fields: &mut Fields,
        id: NodeId,
        first: &TokenStream,
        newest: &[[TokenStream; 2]],
        scaled: impl Fn(TokenStream) -> TokenStream,
    ) -> TokenStream {
        let (runtime, rest) = (self.printer.runtime, self.rest_of(id));
        let with_newest = |sum| newest.iter().fold(sum, |sum, [a, b]| quote!(#a.fma(#b, #sum)));
        if !self.is_unrolled() {
            let rest = scaled(rest);
            let later = with_newest(quote!(#runtime::div_by_order(#rest, order)));
            return quote!(if order == 0 { #first } else { #later });
        }
        let (products, rest) = (self.products(fields, id), scaled(rest));
        let sum = products.iter().fold(quote!(#runtime::div_by_order(#rest, order)), |sum, products| {
            let (a, b) = (scaled(self.factor(products, &quote!(1))), products.b.of(&quote!(order - 1)));
            quote!(#runtime::div_by_order(#a, order).fma(#b, #sum))
        });
        let later = with_newest(sum);
        let second = newest.iter().map(|[a, b]| quote!(#b * #a)).reduce(|sum, product| quote!(#sum + #product));
        quote!(match order { 0 => { #first } 1 => #second, _ => #later, })
    }

    /// Whether a sum gets the sign that all of its products have.
    pub(super) fn is_negated(&self, chained: &[Chained]) -> bool {
        self.is_unrolled() && chained.iter().all(|chained| chained.negative)
    }
}

/// The lines that compute sums over what is known, in the order in which they stand.
#[derive(Default)]
struct Lines {
    begin: TokenStream,
    /// The contributions of the middle of an even order,
    middle: TokenStream,
    /// and those that are left out where they come in when a sum has been divided by the order.
    late_middle: TokenStream,
    loops: TokenStream,
    end: TokenStream,
}

/// The orders that lines name: the middle one, and the lower and the higher one of a pair around it.
fn orders() -> [TokenStream; 3] {
    [quote!(middle), quote!(low), quote!(high)]
}

impl Lines {
    /// From the middle of the order to the product whose lower order is `first`.
    fn outwards(&mut self, first: usize, line: &TokenStream) {
        let first = Literal::usize_unsuffixed(first);
        self.loops.extend(quote! {
            for low in (#first..order.div_ceil(2)).rev() {
                let high = order - low;
                #line
            }
        });
    }

    /// `Σ aⱼ bₖ₋ⱼ` without `j = 1`, in two halves: with the earlier and with the later coefficients of `b`. Both factors are
    /// given at [`orders`].
    fn halves(&mut self, [early, late]: [&Ident; 2], a: [TokenStream; 3], b: [TokenStream; 3]) {
        let ([a_middle, a_low, a_high], [b_middle, b_low, b_high]) = (a, b);
        self.late_middle.extend(quote!(#late = #a_middle.fma(#b_middle, #late);));
        self.outwards(1, &quote!(#early = #a_high.fma(#b_low, #early);));
        self.outwards(2, &quote!(#late = #a_low.fma(#b_high, #late);));
    }

    fn tokens(self) -> TokenStream {
        let Self { begin, middle, late_middle, loops, end } = self;
        let late_middle = (!late_middle.is_empty()).then(|| quote!(if middle > 1 { #late_middle }));
        let middle = (!middle.is_empty() || late_middle.is_some()).then(|| {
            quote! {
                if order > 0 && order % 2 == 0 {
                    let middle = order / 2;
                    #middle
                    #late_middle
                }
            }
        });
        quote!(#begin #middle #loops #end)
    }
}
