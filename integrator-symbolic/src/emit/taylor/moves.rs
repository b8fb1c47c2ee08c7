//! How the coefficients of coordinates get their addends.

use crate::{
    graph::{Element, Graph, NodeId},
    program::{Item, Sink},
    taylor::signed,
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// How lines move coordinates.
pub(super) enum Moves {
    /// Each of a few coordinates has a sum of its own.
    Alone(Vec<Element>),
    /// They are added to coordinates where these are.
    InPlace,
    /// The same, once in a run, by loops as they stand.
    Once,
    /// They are those of iterations side by side, which put numbers down.
    Abreast(Found),
}

/// The numbers that iterations have found so far.
#[derive(Default)]
pub(super) struct Found {
    /// Those that are found in all lanes, and may be had by several coordinates.
    values: Vec<Option<NodeId>>,
    /// For each coordinate, which one it gets, and whether that is taken away.
    pub(super) targets: Vec<(usize, bool)>,
}

impl Found {
    /// Another coordinate gets a value. Gives the number's place, where it has to be put down.
    pub(super) fn another(&mut self, graph: &Graph, value: NodeId, in_all_lanes: bool) -> Option<usize> {
        let (negative, value) = signed(graph, value);
        let of_all = in_all_lanes.then_some(value);
        let known = of_all.and_then(|_| self.values.iter().position(|known| *known == of_all));
        self.targets.push((known.unwrap_or(self.values.len()), negative));
        if known.is_some() {
            return None;
        }
        self.values.push(of_all);
        Some(self.values.len() - 1)
    }
    /// How many numbers there are.
    pub(super) fn values(&self) -> usize {
        self.values.len()
    }
}

impl Moves {
    /// Coordinates are moved alone where it is known which they are.
    pub(super) fn of(graph: &Graph, items: &[Item]) -> Self {
        fn elements(graph: &Graph, items: &[Item]) -> Option<Vec<Element>> {
            let mut found = Vec::new();
            for item in items {
                match item {
                    Item::Loop { .. } => return None,
                    Item::Branch { body, .. } => found.extend(elements(graph, body)?),
                    Item::Sink(Sink::Collect(element), _) => {
                        let known = [Some(element.index), element.component].into_iter().flatten();
                        known.map(|index| graph.loops.literal(index)).collect::<Option<Vec<_>>>()?;
                        found.push(*element);
                    }
                    _ => {}
                }
            }
            Some(found)
        }
        elements(graph, items).map_or(Self::InPlace, |mut elements| {
            elements.sort_unstable();
            elements.dedup();
            Self::Alone(elements)
        })
    }

    /// What iterations side by side have found; nothing, of other lines.
    pub(super) fn found(self) -> Found {
        match self {
            Self::Abreast(found) => found,
            Self::Alone(_) | Self::InPlace | Self::Once => Found::default(),
        }
    }
}

/// The lines with which the sums of so many coordinates begin that are moved alone: minus zero is what nothing has been
/// added to.
pub(super) fn begun(count: usize, scalar: &Ident) -> TokenStream {
    let names = (0..count).map(next);
    quote!(#(let mut #names = #scalar::of(-0.0);)*)
}

/// What the sum of a coordinate that is moved alone is called.
pub(super) fn next(number: usize) -> Ident {
    format_ident!("next_{number}")
}
