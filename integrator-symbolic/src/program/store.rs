//! The possible destinations of gradient components.

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Scope,
        index::{Index, Loops},
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
    let once = gradient.iter().all(|contribution| {
        contribution
            .loops()
            .all(|by| loops.of_coordinate(contribution.element).any(|index| loops.index(index) == Index::Running(by)))
    });
    let apart = |a: Element, b: Element| {
        let differ = |(a, b)| loops.literal(a).zip(loops.literal(b)).is_some_and(|(a, b)| a != b);
        let mut indices = loops.of_coordinate(a).zip(loops.of_coordinate(b));
        a.part != b.part || indices.any(differ)
    };
    once && gradient
        .iter()
        .enumerate()
        .all(|(position, first)| gradient[..position].iter().all(|second| apart(first.element, second.element)))
}
