//! Flat coordinates as the sites of a plane: `q[y * width + x]` is site `x` of row `y`.
//!
//! In: the gradients of `T` and of `V` by flat coordinates. Out: their stencils by rows and sites, or nothing where an index
//! has another form. Always true: if the rows are all coordinates, row and site name the coordinate that the index names. So
//! the runtime sweeps along rows only then; no index leaves its row, which the stencil checks.

use super::sites::{stencil_of, stencil_on};
use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, Scope,
        index::{Index, IndexId, Loop, LoopId, LoopSet},
    },
    model::{Length, Model},
    pairs::rewritten,
    stencil::{Components, Stencil},
};

/// The stencils of the gradients of `T` and of `V`, if that of `V` is one of a plane with flat coordinates.
pub(super) fn stencils(
    model: &mut Model,
    [kinetic, potential]: &[Vec<Contribution>; 2],
) -> Option<[Option<Stencil>; 2]> {
    let is_flat = matches!(model.shape.length, Length::OfStart) && model.shape.inner.is_empty();
    if !is_flat || !model.is_separable() || model.jacobi().is_some() {
        return None;
    }
    let plane = Plane::of(&model.graph, potential, *model.lengths.first()?)?;
    // Without neighbours along rows, they may be the few components of points.
    let has_rows = |stencil: &Stencil| stencil.directions.last().is_some_and(|along| along.has_neighbours());
    let force = plane.stencil(model, potential).filter(has_rows)?;
    let velocity = plane.stencil(model, kinetic);
    Some([velocity.or_else(|| stencil_of(model, kinetic, Components::Unknown).ok()), Some(force)])
}

/// The stencil of contributions to flat coordinates on a plane of these numbers of rows and of sites in a row.
pub(super) fn stencil_on_rows(
    model: &mut Model,
    contributions: &[Contribution],
    [rows, width]: [IndexId; 2],
) -> Option<Stencil> {
    let length = *model.lengths.first()?;
    Plane { rows, width, length }.stencil(model, contributions)
}

/// A plane whose sites are flat coordinates.
struct Plane {
    rows: IndexId,
    width: IndexId,
    /// The number of coordinates.
    length: IndexId,
}

impl Plane {
    /// That of the indices of a gradient.
    fn of(graph: &Graph, gradient: &[Contribution], length: IndexId) -> Option<Self> {
        let mut indices: Vec<IndexId> = gradient.iter().map(|contribution| contribution.element.index).collect();
        let read = graph.reachable(gradient.iter().flat_map(Contribution::values));
        indices.extend(read.into_iter().filter_map(|id| match graph.node(id) {
            Node::Coordinate(element) => Some(element.index),
            _ => None,
        }));
        let products: Vec<_> = indices.into_iter().filter_map(|index| product(graph, index)).collect();
        let &[_, width] = products.first()?;
        if products.iter().any(|[_, other]| *other != width) {
            return None;
        }
        // The number of rows is where they begin anew, or else where the loop over them ends.
        let around = products.iter().find_map(|[row, _]| match graph.loops.index(*row) {
            Index::Rem(_, rows) => Some(rows),
            _ => None,
        });
        let rows = around.or_else(|| {
            let by = graph.loops.of_index(products[0][0]).iter().next()?;
            let end = graph.loops.get(by).to;
            Some(match graph.loops.index(end) {
                Index::Monus(rows, _) => rows,
                _ => end,
            })
        })?;
        [rows, width].iter().all(|number| graph.loops.of_index(*number).is_empty()).then_some(Self {
            rows,
            width,
            length,
        })
    }

    /// The stencil of a gradient by flat coordinates.
    fn stencil(&self, model: &mut Model, gradient: &[Contribution]) -> Option<Stencil> {
        let lengths = [self.rows, self.width];
        let of_sites = gradient.iter().map(|contribution| self.of_sites(model, contribution));
        let of_sites = of_sites.collect::<Option<Vec<_>>>()?;
        let stencil = stencil_on(model, &of_sites, &lengths, Components::Flat).ok()?;
        Some(Stencil { flat: Some(lengths), ..stencil })
    }

    /// A contribution by rows and sites.
    fn of_sites(&self, model: &mut Model, contribution: &Contribution) -> Option<Contribution> {
        let mut context = Vec::new();
        for scope in &contribution.context {
            match *scope {
                Scope::Loop(by) => match self.loops(&mut model.graph, by) {
                    Some(both) => {
                        let name = model.running.get(&by)?.clone();
                        for by in both {
                            model.running.entry(by).or_insert_with(|| name.clone());
                            context.push(Scope::Loop(by));
                        }
                    }
                    None => context.push(*scope),
                },
                Scope::Branch(..) => context.push(*scope),
            }
        }
        let graph = &mut model.graph;
        let element = self.element(graph, contribution.element)?;
        let is_simple = |id| !matches!(graph.node(id), Node::Sum(..) | Node::Fold(..) | Node::External(..));
        if !graph.reachable([contribution.value]).into_iter().all(is_simple) {
            return None;
        }
        let mut is_of_sites = true;
        let value = rewritten(graph, contribution.value, |graph, id| {
            let Node::Coordinate(element) = graph.node(id) else { return None };
            let element = self.element(graph, element);
            is_of_sites &= element.is_some();
            Some(graph.coordinate(element?))
        });
        // A number of the system by the index of a flat coordinate is none of a row.
        let around: LoopSet = context.iter().fold(LoopSet::EMPTY, |loops, scope| match scope {
            Scope::Loop(by) => loops.union(LoopSet::of(*by)),
            Scope::Branch(..) => loops,
        });
        (is_of_sites && graph.loops_of(value).is_subset(around)).then_some(Contribution { context, element, value })
    }

    /// The loops over rows and over their sites in place of one over all coordinates.
    fn loops(&self, graph: &mut Graph, by: LoopId) -> Option<[LoopId; 2]> {
        let Loop { parent: None, from, to } = graph.loops.get(by) else { return None };
        let all = [[self.rows, self.width], [self.width, self.rows]].map(|[a, b]| graph.loops.known(Index::Mul(a, b)));
        let is_whole = to == self.length || all.contains(&Some(to));
        if !is_whole || graph.loops.literal(from) != Some(0) || graph.loops.count() + 2 > LoopSet::CAPACITY {
            return None;
        }
        let row = graph.loops.range(Loop { parent: None, from, to: self.rows });
        let site = graph.loops.range(Loop { parent: Some(row), from, to: self.width });
        Some([row, site])
    }

    /// The site that a flat coordinate is.
    fn element(&self, graph: &mut Graph, element: Element) -> Option<Element> {
        if element.component.is_some() {
            return Some(element);
        }
        if let Index::Running(by) = graph.loops.index(element.index)
            && let Some(both) = self.loops(graph, by)
        {
            let [index, site] = both.map(|by| graph.loops.intern(Index::Running(by)));
            return Some(Element { index, component: Some(site), ..element });
        }
        let zero = graph.loops.intern(Index::Literal(0));
        let both = self.split(graph, element.index)?;
        let [index, site] = both.map(|part| part.unwrap_or(zero));
        Some(Element { index, component: Some(site), ..element })
    }

    /// The row and the site of an index; nothing for zero.
    fn split(&self, graph: &mut Graph, index: IndexId) -> Option<[Option<IndexId>; 2]> {
        if index == self.width {
            return Some([Some(graph.loops.intern(Index::Literal(1))), None]);
        }
        let joined = |graph: &mut Graph, a, b, of: fn(IndexId, IndexId) -> Index| match (a, b) {
            (Some(a), Some(b)) => Some(Some(graph.loops.intern(of(a, b)))),
            (a, None) => Some(a),
            // Nothing is below the first row or site.
            (None, Some(_)) if matches!(of(index, index), Index::Sub(..)) => None,
            (None, b) => Some(b),
        };
        match graph.loops.index(index) {
            Index::Mul(row, width) | Index::Mul(width, row) if width == self.width => Some([Some(row), None]),
            known @ (Index::Add(a, b) | Index::Sub(a, b)) => {
                let of = if matches!(known, Index::Add(..)) { Index::Add } else { Index::Sub };
                let [[row, site], [other_row, other_site]] = [self.split(graph, a)?, self.split(graph, b)?];
                Some([joined(graph, row, other_row, of)?, joined(graph, site, other_site, of)?])
            }
            _ => Some([None, Some(index)]),
        }
    }
}

/// The product of a row and the width in an index.
fn product(graph: &Graph, index: IndexId) -> Option<[IndexId; 2]> {
    let is_row = |id: &IndexId| !graph.loops.of_index(*id).is_empty();
    match graph.loops.index(index) {
        Index::Add(a, b) | Index::Sub(a, b) => product(graph, a).or_else(|| product(graph, b)),
        Index::Mul(a, b) => [[a, b], [b, a]].into_iter().find(|[row, width]| is_row(row) && !is_row(width)),
        _ => None,
    }
}
