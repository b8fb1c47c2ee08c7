//! Sums of products that are computed as pairs, in two lanes of a register if there is one.
//!
//! A pair is one of these: two sums with a common factor; those of two squares; those of a power; or the halves
//! `Σ aⱼ bₖ₋ⱼ` and `Σ bⱼ aₖ₋ⱼ`, `j < k/2`, of one sum. The coefficients of two factors are interleaved in memory; those
//! of coordinates are read from their rows.

use super::{
    recurrence::{Factor, Known, Products, Weight},
    tape::{Kept, Series},
    writer::Writer,
};
use crate::{
    emit::printer::fields::Fields,
    graph::{Node, NodeId},
};
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

/// Factors whose coefficients are stored as pairs.
#[derive(Clone)]
pub(super) struct SideBySide {
    factors: [Factor; 2],
    kept: Series,
}

/// What is computed in pairs.
pub(super) enum Sums<'s> {
    /// A sum by itself.
    One(&'s Known),
    /// The halves of a sum of products, with the factors of these.
    Halves { of: &'s Known, factors: [Factor; 2] },
    /// Two sums: the factors that differ, and the one in common; squares have none.
    Two { of: [&'s Known; 2], factors: [Factor; 2], common: Option<Factor> },
}

/// The coefficients of two factors.
pub(super) enum Coefficients {
    Read([Series; 2]),
    Kept(Series),
}

impl<'s> Sums<'s> {
    /// The sums of a block: each is computed beside the next one with which it has a factor in common.
    pub(super) fn of(sums: &'s [Known]) -> Vec<Self> {
        let mut left: Vec<&Known> = sums.iter().collect();
        let mut found = Vec::new();
        while !left.is_empty() {
            let first = left.remove(0);
            let beside = left.iter().enumerate().find_map(|(at, other)| Some((at, Self::two(first, other)?)));
            found.push(match beside {
                Some((at, two)) => {
                    left.remove(at);
                    two
                }
                None => match first.2.as_slice() {
                    [Products { weight: Weight::None, factors, .. }] => Self::Halves { of: first, factors: *factors },
                    _ => Self::One(first),
                },
            });
        }
        found
    }

    fn two(first: &'s Known, second: &'s Known) -> Option<Self> {
        let ([one], [other]) = (first.2.as_slice(), second.2.as_slice()) else { return None };
        let [[a, b], [c, d]] = [one.factors, other.factors];
        let (factors, common) = match (&one.weight, &other.weight) {
            (Weight::Half, Weight::Half) => ([a, c], None),
            (Weight::None, Weight::None) => {
                let shared = [([b, d], a, c), ([b, c], a, d), ([a, d], b, c), ([a, c], b, d)];
                let (factors, common, _) = shared.into_iter().find(|(_, one, other)| one == other)?;
                (factors, Some(common))
            }
            (Weight::Rate { negative: false }, Weight::Rate { negative: false }) if a == c => ([b, d], Some(a)),
            _ => return None,
        };
        // In one order, whatever the factor in common, so that no two coefficients are kept twice.
        let [one, other] = factors;
        Some(match one <= other {
            true => Self::Two { of: [first, second], factors, common },
            false => Self::Two { of: [second, first], factors: [other, one], common },
        })
    }
}

impl Writer<'_> {
    /// The coefficients of two factors as a pair, and the line that keeps those that are known already.
    pub(super) fn side_by_side(
        &mut self,
        fields: &mut Fields,
        factors: [Factor; 2],
    ) -> (Coefficients, Option<TokenStream>) {
        if factors.iter().all(|factor| self.is_in_a_row(*factor)) {
            return (Coefficients::Read(factors.map(|factor| self.series(fields, factor.value()))), None);
        }
        if let Some(known) = self.side_by_side.iter().find(|known| known.factors == factors) {
            return (Coefficients::Kept(known.kept.clone()), None);
        }
        let record = self.record();
        let number = record.slots.iter().filter(|(_, kept)| *kept == Kept::Pairs).count();
        let name = format_ident!("pairs_{number}");
        record.keep(name.clone(), Kept::Pairs);
        let kept = Series::Own { at: record.at.clone(), name };
        let pair = SideBySide { factors, kept: kept.clone() };
        self.side_by_side.push(pair.clone());
        let are_known = factors.iter().all(|factor| self.is_computed(*factor));
        (Coefficients::Kept(kept), are_known.then(|| self.keep_pair(fields, &pair)))
    }

    /// The lines that keep coefficients beside that of a value, which has just been computed.
    pub(super) fn keep_side_by_side(&mut self, fields: &mut Fields, id: NodeId) -> TokenStream {
        self.computed.insert(id);
        let with_it = |pair: &&SideBySide| pair.factors.iter().any(|factor| factor.value() == id);
        let pairs: Vec<SideBySide> = self.side_by_side.iter().filter(with_it).cloned().collect();
        let known = pairs.iter().filter(|pair| pair.factors.iter().all(|factor| self.is_computed(*factor)));
        let known: Vec<&SideBySide> = known.collect();
        known.into_iter().map(|pair| self.keep_pair(fields, pair)).collect()
    }

    fn keep_pair(&mut self, fields: &mut Fields, SideBySide { factors, kept }: &SideBySide) -> TokenStream {
        let runtime = self.printer.runtime;
        let order = quote!(order);
        let [first, second] = factors.map(|factor| self.coefficient(fields, factor, &order));
        let kept = kept.of(&order);
        quote!(#kept = #runtime::pair(#first, #second);)
    }

    /// The coefficient of a factor.
    fn coefficient(&mut self, fields: &mut Fields, factor: Factor, order: &TokenStream) -> TokenStream {
        let scalar = self.printer.scalar;
        match factor {
            Factor::Value(id) => self.series(fields, id).of(order),
            Factor::Rate(id) => match self.rate(id) {
                Some(rate) => rate.of(order),
                None => {
                    let value = self.series(fields, id).of(order);
                    quote!(#scalar::of(#order as f64) * #value)
                }
            },
        }
    }

    /// Two coefficients of an order as a pair.
    pub(super) fn pair_of(&self, coefficients: &Coefficients, order: &TokenStream) -> TokenStream {
        let runtime = self.printer.runtime;
        match coefficients {
            Coefficients::Kept(series) => series.of(order),
            Coefficients::Read(series) => {
                let [first, second] = series.each_ref().map(|series| series.of(order));
                quote!(#runtime::pair(#first, #second))
            }
        }
    }

    /// The coefficient of a factor of an order beside itself.
    pub(super) fn twice_of(&mut self, fields: &mut Fields, factor: Factor, order: &TokenStream) -> TokenStream {
        let (runtime, coefficient) = (self.printer.runtime, self.coefficient(fields, factor, order));
        quote!(#runtime::twice(#coefficient))
    }

    /// A number beside itself.
    pub(super) fn twice(&self, number: impl ToTokens) -> TokenStream {
        let (runtime, number) = (self.printer.runtime, self.printer.lift(number.into_token_stream()));
        quote!(#runtime::twice(#number))
    }

    fn is_in_a_row(&self, factor: Factor) -> bool {
        matches!(factor, Factor::Value(id) if matches!(self.printer.graph.node(id), Node::Coordinate(_)))
    }

    /// Whether a coefficient of the present order is known to the present line.
    fn is_computed(&self, factor: Factor) -> bool {
        let id = factor.value();
        self.printer.graph.node(id).is_read() || self.computed.contains(&id)
    }
}
