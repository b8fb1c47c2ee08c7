//! The sums over what is known where orders are compiled one by one: two sums of a kind are computed side by side, and of
//! a product that is left alone its two halves, `aⱼ bₖ₋ⱼ` and `bⱼ aₖ₋ⱼ` with `j < k/2`. Of a power, these are
//! `Σ aⱼ yₖ₋ⱼ` and `Σ j aⱼ yₖ₋ⱼ`, so that no product has a weight of its own.

use super::{
    orders::Writer,
    recurrence::{Known, Products, Series, Weight},
    tape::Kept,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The lines that sum up.
#[derive(Default)]
struct Lines {
    /// What is kept of the order before.
    keep: TokenStream,
    /// The series that lie side by side, by what is kept of them.
    pairs: Vec<(String, Series)>,
    begin: TokenStream,
    /// What the middle of an even order adds,
    middle: TokenStream,
    /// and what it adds where it isn't the product that comes in when a sum has been divided by the order.
    late_middle: TokenStream,
    /// Each sum has a loop of its own, so short that the compiler writes it out before anything else.
    loops: TokenStream,
    /// What each sum is called where two have been computed side by side.
    parts: TokenStream,
}

/// The factors of one sum or two.
enum Factors {
    /// Kept side by side.
    Pairs(Series),
    /// Those of the first sum, for all.
    Shared { is_second: bool },
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
}

impl Writer<'_> {
    /// The sums over what is known. Those that are divided by the order are without the latest product. Those of rates are
    /// two, for the products with earlier and with later coefficients of the slope, so that each is half as long.
    pub(super) fn known_unrolled(&mut self, sums: &[Known]) -> TokenStream {
        let mut lines = Lines::default();
        let mut left: Vec<&Known> = sums.iter().collect();
        for kind in [is_half, is_product, is_rate] {
            let (mut alike, others) =
                left.into_iter().partition::<Vec<_>, _>(|(.., products)| match products.as_slice() {
                    [products] => kind(&products.weight),
                    _ => false,
                });
            left = others;
            // Series that lie beside each other are read together.
            alike.sort_by_key(|(.., products)| products[0].a.of(&quote!(order)).to_string());
            let (twos, rest) = alike.as_chunks::<2>();
            twos.iter().for_each(|two| self.sum_up(&mut lines, two));
            left.extend(rest);
        }
        for sum in left {
            match sum.2.as_slice() {
                [product] if is_product(&product.weight) => self.sum_up_halves(&mut lines, sum, product),
                [Products { weight: Weight::Power { number, .. }, a, b }] => {
                    self.sum_up_power(&mut lines, sum, number, [a, b]);
                }
                _ => self.sum_up(&mut lines, &[sum]),
            }
        }
        let Lines { keep, begin, middle, late_middle, loops, parts, .. } = lines;
        let keep = (!keep.is_empty()).then(|| quote!(if order > 1 { let last = order - 1; #keep }));
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
        quote!(#keep #begin #middle #loops #parts)
    }

    /// One sum, or two with one kind of products each.
    fn sum_up(&mut self, lines: &mut Lines, sums: &[&Known]) {
        let (middle, low, high) = (quote!(middle), quote!(low), quote!(high));
        let rests: Vec<Ident> = sums.iter().map(|(_, rest, _)| rest.clone()).collect();
        let earlies: Vec<Ident> = sums.iter().filter_map(|(id, _, products)| self.early(*id, products)).collect();
        let rest = self.begin(lines, sums, &rests);
        let early = if earlies.is_empty() { rest.clone() } else { self.begin(lines, sums, &earlies) };
        for n in 0..sums[0].2.len() {
            let products: Vec<&Products> = sums.iter().map(|(.., products)| &products[n]).collect();
            let factors = [false, true].map(|is_second| self.factors(lines, &products, is_second));
            let [a, b] = factors.each_ref().map(|factors| |j: &TokenStream| self.of_order(factors, &products, j));
            let product = |rest: &Ident, i: &TokenStream, j: &TokenStream| {
                let (a, b) = (a(i), b(j));
                quote!(#rest = #a.fma(#b, #rest);)
            };
            let (a_middle, b_middle) = (a(&middle), b(&middle));
            match (&products[0].weight, sums.len()) {
                (Weight::None, count) => {
                    let times = self.times(count, a_middle, &b_middle);
                    lines.middle.extend(quote!(#rest = #times;));
                    let (a_low, b_high, a_high, b_low) = (a(&low), b(&high), a(&high), b(&low));
                    lines.outwards(1, &quote!(#rest = #a_low.fma(#b_high, #a_high.fma(#b_low, #rest));));
                }
                (Weight::Half, count) => {
                    let half = self.side_by_side(&vec![self.printer.lifted(quote!(0.5)); count]);
                    let times = self.times(count, self.times(count, half, &a_middle), &b_middle);
                    lines.middle.extend(quote!(#rest = #times;));
                    lines.outwards(1, &product(&rest, &low, &high));
                }
                _ => {
                    lines.late_middle.extend(product(&rest, &middle, &middle));
                    lines.outwards(1, &product(&early, &high, &low));
                    lines.outwards(2, &product(&rest, &low, &high));
                }
            }
        }
    }

    /// The factors of one sum or two.
    fn factors(&mut self, lines: &mut Lines, products: &[&Products], is_second: bool) -> Factors {
        let last = quote!(last);
        let parts: Vec<TokenStream> = products.iter().map(|products| self.of(products, is_second, &last)).collect();
        match parts.as_slice() {
            [one, two] if one.to_string() != two.to_string() => Factors::Pairs(self.pairs(lines, one, two)),
            _ => Factors::Shared { is_second },
        }
    }

    /// Those of an order.
    fn of_order(&self, factors: &Factors, products: &[&Products], j: &TokenStream) -> TokenStream {
        match factors {
            Factors::Pairs(series) => series.of(j),
            Factors::Shared { is_second } => {
                self.side_by_side(&vec![self.of(products[0], *is_second, j); products.len()])
            }
        }
    }

    /// The first factor of order `j`, or the second one.
    fn of(&self, products: &Products, is_second: bool, j: &TokenStream) -> TokenStream {
        if is_second { products.b.of(j) } else { self.factor(products, j) }
    }

    /// A product of one number, or of two of them each.
    fn times(&self, count: usize, a: TokenStream, b: &TokenStream) -> TokenStream {
        if count == 1 { quote!(#a * #b) } else { quote!(#a.mul(#b)) }
    }

    /// The two halves of a sum of products.
    fn sum_up_halves(&mut self, lines: &mut Lines, (id, rest, _): &Known, Products { a, b, .. }: &Products) {
        let (last, middle, low, high) = (quote!(last), quote!(middle), quote!(low), quote!(high));
        let [half, zero] = [quote!(0.5), quote!(0.0)].map(|number| {
            let number = self.printer.lifted(number);
            self.side_by_side(&[number.clone(), number])
        });
        let [a, b] = [a, b].map(|series| series.of(&last));
        let (pairs, turned) = (self.pairs(lines, &a, &b), self.pairs(lines, &b, &a));
        let halves = format_ident!("halves_of_{}", self.printer.names[id]);
        let [of_middle, of_low] = [&middle, &low].map(|j| pairs.of(j));
        let [turned_middle, turned_high] = [&middle, &high].map(|j| turned.of(j));
        lines.begin.extend(quote!(let mut #halves = #zero;));
        lines.middle.extend(quote!(#halves = #half.mul(#of_middle).mul(#turned_middle);));
        lines.outwards(1, &quote!(#halves = #of_low.fma(#turned_high, #halves);));
        lines.parts.extend(quote!(let #rest = #halves.total();));
    }

    /// The sum of a power: what is weighted with an order is in one lane, and what isn't in the other.
    fn sum_up_power(&mut self, lines: &mut Lines, (id, rest, _): &Known, exponent: &TokenStream, [a, b]: [&Series; 2]) {
        let (scalar, runtime) = (self.printer.scalar, self.printer.runtime);
        let (middle, low, high) = (quote!(middle), quote!(low), quote!(high));
        let first = a.of(&quote!(last));
        let pairs = self.pairs(lines, &first, &quote!(#scalar::of(last as f64) * #first));
        let zero = self.printer.lifted(quote!(0.0));
        let zeros = self.side_by_side(&[zero.clone(), zero]);
        let [early, late] = ["early", "late"].map(|half| format_ident!("{half}_of_{}", self.printer.names[id]));
        lines.begin.extend(quote!(let mut #early = #zeros; let mut #late = #zeros;));
        let line = |sum: &Ident, i: &TokenStream, j: &TokenStream| {
            let (a, b) = (pairs.of(i), b.of(j));
            let b = self.side_by_side(&[b.clone(), b]);
            quote!(#sum = #a.fma(#b, #sum);)
        };
        lines.late_middle.extend(line(&late, &middle, &middle));
        lines.outwards(1, &line(&early, &high, &low));
        lines.outwards(2, &line(&late, &low, &high));
        lines.parts.extend(quote!(let #rest = #runtime::weighted(#exponent, order, [#early, #late]);));
    }

    /// Where two coefficients of each order lie side by side, as they are there of the last one.
    fn pairs(&mut self, lines: &mut Lines, first: &TokenStream, second: &TokenStream) -> Series {
        let both = self.side_by_side(&[first.clone(), second.clone()]);
        let key = both.to_string();
        if let Some((_, series)) = lines.pairs.iter().find(|(known, _)| *known == key) {
            return series.clone();
        }
        let record = self.record();
        let number = record.slots.iter().filter(|(_, kept)| matches!(kept, Kept::Pairs)).count();
        let name = format_ident!("pairs_{number}");
        record.keep(name.clone(), Kept::Pairs);
        let series = Series::Own { at: record.at.clone(), name };
        let place = series.of(&quote!(last));
        lines.keep.extend(quote!(#place = #both;));
        lines.pairs.push((key, series.clone()));
        series
    }

    /// Begins sums, or halves of them, with nothing, and says what these are called together.
    fn begin(&self, lines: &mut Lines, sums: &[&Known], names: &[Ident]) -> Ident {
        let zero = self.printer.lifted(quote!(0.0));
        let zeros = self.side_by_side(&vec![zero; names.len()]);
        let name = match (sums, names) {
            ([_, (second, ..)], [first, _]) => {
                let name = format_ident!("{first}_and_{}", self.printer.names[second]);
                lines.parts.extend(quote!(let [#(#names),*] = #name.parts();));
                name
            }
            _ => names[0].clone(),
        };
        lines.begin.extend(quote!(let mut #name = #zeros;));
        name
    }

    /// One number, or two of them.
    fn side_by_side(&self, parts: &[TokenStream]) -> TokenStream {
        let runtime = self.printer.runtime;
        match parts {
            [one] => one.clone(),
            parts => quote!(#runtime::pair(#(#parts),*)),
        }
    }
}

fn is_half(weight: &Weight) -> bool {
    matches!(weight, Weight::Half)
}

fn is_product(weight: &Weight) -> bool {
    matches!(weight, Weight::None)
}

fn is_rate(weight: &Weight) -> bool {
    matches!(weight, Weight::Rate { .. })
}
