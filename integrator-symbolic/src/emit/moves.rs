//! How the coefficients of coordinates get their addends.

use crate::{
    graph::{Element, Graph},
    program::{Item, Sink},
};
use proc_macro2::Ident;
use quote::format_ident;

/// How lines move coordinates.
pub(super) enum Moves {
    /// Each of a few coordinates has a sum of its own.
    Alone(Vec<Element>),
    /// They are added to coordinates where these are.
    InPlace,
    /// The same, once in a run, by loops as they stand.
    Once,
    /// They are those of turns side by side, which have found numbers for so many targets so far.
    Abreast(usize),
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
}

/// What the sum of a coordinate that is moved alone is called.
pub(super) fn next(number: usize) -> Ident {
    format_ident!("next_{number}")
}
