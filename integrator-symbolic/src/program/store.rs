//! Where the components of a gradient may go.

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Scope,
        index::{Index, IndexId, Loops},
    },
};

/// Whether a condition decides if the coordinate that a contribution belongs to is there.
pub(crate) fn is_protected(graph: &mut Graph, contribution: &Contribution) -> bool {
    let coordinate = graph.coordinate(contribution.element);
    let is_branch = |around: &&Scope| matches!(around, Scope::Branch(..));
    contribution.context.iter().filter(is_branch).any(|around| graph.protects(*around, coordinate))
}

/// Whether no coordinate is moved by two contributions or by two iterations of a loop.
pub(crate) fn is_direct(loops: &Loops, gradient: &[Contribution]) -> bool {
    let indices = |element: Element| [Some(element.index), element.component];
    let once = gradient.iter().all(|contribution| {
        contribution.loops().all(|by| {
            let named = indices(contribution.element).into_iter().flatten();
            named.into_iter().any(|index| loops.index(index) == Index::Running(by))
        })
    });
    let apart = |a: Element, b: Element| {
        let differ = |(a, b): (Option<IndexId>, Option<IndexId>)| {
            let numbers = a.zip(b).and_then(|(a, b)| loops.literal(a).zip(loops.literal(b)));
            numbers.is_some_and(|(a, b)| a != b)
        };
        a.part != b.part || indices(a).into_iter().zip(indices(b)).any(differ)
    };
    once && gradient
        .iter()
        .enumerate()
        .all(|(position, first)| gradient[..position].iter().all(|second| apart(first.element, second.element)))
}
