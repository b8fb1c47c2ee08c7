//! Gradients in which every site of a lattice takes part alike, in a form in which each gets all its addends at once.
//!
//! Comes in: contributions to a gradient. Goes out: a stencil: each contribution is computed at a site from its
//! neighbourhood and belongs to that site or to one further on. A lattice is a line of sites, or a plane of rows.
//! Always true: the stencil adds up what comes in, iteration by iteration, with the iterations of every loop renumbered
//! so that none belongs to a site behind; or nothing comes out, where one contribution is of another kind.

mod direction;
mod line;
mod pieces;

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId,
        index::{IndexId, LoopId},
    },
};
use direction::Iterations;
pub(crate) use direction::{Along, Direction, Extent};
pub(crate) use line::{Addend, Ends, Line};
use pieces::{Piece, pieces};
use std::collections::{BTreeSet, HashMap};

/// How far the contributions of a site look and go along a line or a row.
const FARTHEST: i64 = 2;

/// How many rows they look and go over.
const FARTHEST_ROW: i64 = 1;

/// A stencil: what is computed at each site, and where the sites are that differ from the others.
#[derive(Debug)]
pub(crate) struct Stencil {
    /// From row to row, where there are rows, and from site to site.
    pub(crate) directions: Vec<Direction>,
    pub(crate) contributions: Vec<SiteContribution>,
}

/// A contribution of a range of sites to themselves or to others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SiteContribution {
    /// How far it goes in every direction.
    pub(crate) along: Vec<Along>,
    pub(crate) value: NodeId,
}

impl SiteContribution {
    /// How many places further on the contribution goes in every direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        self.along.iter().map(|along| along.onward).collect()
    }
}

impl Stencil {
    /// Whether the sites are those of a plane.
    pub(crate) fn is_plane(&self) -> bool {
        self.directions.len() > 1
    }

    /// How many places further on the farthest contribution goes in each direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        let farthest =
            |direction: usize| self.contributions.iter().map(|contribution| contribution.along[direction].onward).max();
        (0..self.directions.len()).map(|direction| farthest(direction).unwrap_or(0)).collect()
    }

    /// The forward offsets of contributions, in order: along a line or a row as far as any goes, then those for the next
    /// row, as far as one of them goes.
    pub(crate) fn places(&self) -> Vec<Vec<usize>> {
        match self.onward()[..] {
            [rows, sites] => {
                let onward = self.contributions.iter().map(SiteContribution::onward).filter(|onward| onward[0] > 0);
                let below = onward.map(|onward| onward[1]).max().unwrap_or(0);
                let far = move |row| if row == 0 { sites } else { below };
                (0..=rows).flat_map(|row| (0..=far(row)).map(move |site| vec![row, site])).collect()
            }
            ref line => (0..=line.iter().sum()).map(|site| vec![site]).collect(),
        }
    }
}

/// How many sites a line or a row has at least, if their number is known: fewer are as fast in a plain loop.
const FEWEST: u64 = 8;

/// What is known of coordinates with two indices where the second has no literal number of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Components {
    /// The sites of rows: another gradient of the system adds to neighbours along them.
    Sites,
    /// They may be the few components of points, too.
    Unknown,
}

/// The stencil of `gradient`, where all of it has that form, on a line or a plane of such lengths; `leaf` tells which
/// nodes are read, not computed.
pub(crate) fn stencil(
    graph: &mut Graph,
    gradient: &[Contribution],
    lengths: &[IndexId],
    components: Components,
    leaf: impl Fn(&Graph, NodeId) -> bool,
) -> Option<Stencil> {
    let pieces = pieces(graph, gradient, &leaf)?;
    let mut of = |begins| stencil_of(graph, &pieces, (lengths, components), begins, &leaf);
    of(Begins::Together).or_else(|| of(Begins::Apart))
}

/// Which site sees what an iteration adds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begins {
    /// The first one that iterations of its loop add to: what is added to several sites is computed once.
    Together,
    /// The one that it is added to. A site that adds to its neighbours on both sides reads no farther than these.
    Apart,
}

/// The stencil of a gradient in pieces as seen from these sites.
fn stencil_of(
    graph: &mut Graph,
    pieces: &[Piece],
    (lengths, components): (&[IndexId], Components),
    begins: Begins,
    leaf: &impl Fn(&Graph, NodeId) -> bool,
) -> Option<Stencil> {
    let number = graph.loops.literal(*lengths.last()?);
    if number.is_some_and(|number| number < FEWEST) {
        return None;
    }
    let mut directions: Vec<Direction> = Vec::new();
    for (level, length) in lengths.iter().enumerate() {
        let farthest = if level + 1 < lengths.len() { FARTHEST_ROW } else { FARTHEST };
        let parent = directions.last().map(|outer| outer.place);
        directions.push(Direction::new(graph, parent, *length, farthest)?);
    }
    let mut gathering = Gathering { leaf, begins, graph, stencil: Stencil { directions, contributions: Vec::new() } };
    let mut made = Vec::new();
    for piece in pieces {
        made.extend(gathering.iterations(piece)?.map(|iterations| (&piece.contribution, iterations)));
    }
    let (gradient, iterations): (Vec<_>, Vec<_>) = made.into_iter().unzip();
    // Nothing is gained where no loops run over the lattice.
    iterations.iter().find(|iterations| iterations.iter().all(Iterations::run))?;
    for (contribution, own) in gradient.iter().zip(&iterations) {
        let begins = own.iter().enumerate().map(|(direction, own)| {
            if begins == Begins::Apart {
                return own.to_place;
            }
            let all = iterations.iter().map(|iterations| &iterations[direction]);
            let together = all.filter(|other| own.by.is_some() && other.by == own.by);
            together.map(|other| other.to_place).min().unwrap_or_default()
        });
        gathering.contribution(contribution.value, own, &begins.collect::<Vec<_>>())?;
    }
    let stencil = gathering.finished()?;
    let may_be_points = stencil.is_plane() && number.is_none() && components == Components::Unknown;
    let is_row = stencil.directions.last().is_some_and(Direction::has_neighbours);
    (!may_be_points || is_row).then_some(stencil)
}

/// What is computed of a value and what it reads, children first; `leaf` tells what is read.
fn computed(graph: &Graph, value: NodeId, leaf: impl Fn(&Graph, NodeId) -> bool) -> BTreeSet<NodeId> {
    let (mut nodes, mut open) = (BTreeSet::new(), vec![value]);
    while let Some(id) = open.pop() {
        if nodes.insert(id) && !leaf(graph, id) {
            open.extend(graph.node(id).children());
        }
    }
    nodes
}

/// The indices of a coordinate, one per direction.
fn indices(element: Element) -> impl Iterator<Item = IndexId> {
    [Some(element.index), element.component].into_iter().flatten()
}

struct Gathering<'g, L> {
    graph: &'g mut Graph,
    leaf: &'g L,
    begins: Begins,
    stencil: Stencil,
}

impl<L: Fn(&Graph, NodeId) -> bool> Gathering<'_, L> {
    /// The iterations in which a contribution is made, direction by direction; nothing inside, where there are none.
    fn iterations(&mut self, Piece { contribution, conditions }: &Piece) -> Option<Option<Vec<Iterations>>> {
        let indices = indices(contribution.element);
        let iterations = self.stencil.directions.iter_mut().zip(indices);
        let mut iterations =
            iterations.map(|(direction, index)| direction.iterations(self.graph, index)).collect::<Option<Vec<_>>>()?;
        for (condition, holds) in conditions {
            let loops = self.graph.loops_of(*condition);
            let mut directions = self.stencil.directions.iter().zip(&mut iterations);
            let (direction, own) = directions.find(|(_, own)| own.by.is_some_and(|by| loops.contains(by)))?;
            if !direction.narrow(self.graph, own, self.graph.node(*condition), *holds)? {
                return Some(None);
            }
        }
        // Every loop around it runs in one direction, and nothing else is around it.
        let by: BTreeSet<LoopId> = iterations.iter().filter_map(|iterations| iterations.by).collect();
        let around: BTreeSet<LoopId> = contribution.loops().collect();
        let running = iterations.iter().filter(|iterations| iterations.by.is_some()).count();
        (by == around && running == by.len() && running == contribution.context.len()).then_some(Some(iterations))
    }

    /// Notes what some iterations add to a site, as seen from the first site that iterations of their loops add to.
    fn contribution(&mut self, value: NodeId, iterations: &[Iterations], begins: &[i64]) -> Option<()> {
        let value = self.seen(value, iterations, begins)?;
        let directions = self.stencil.directions.iter_mut().zip(iterations).zip(begins);
        let along =
            directions.map(|((direction, iterations), begins)| direction.along(self.graph, iterations, *begins));
        let along = along.collect::<Option<Vec<_>>>()?;
        match self.stencil.contributions.iter_mut().find(|contribution| contribution.along == along) {
            Some(contribution) => contribution.value = self.graph.add(contribution.value, value),
            None => self.stencil.contributions.push(SiteContribution { along, value }),
        }
        Some(())
    }

    /// The value of an iteration as seen from its site: coordinates are named by how far from the site they are.
    fn seen(&mut self, value: NodeId, iterations: &[Iterations], begins: &[i64]) -> Option<NodeId> {
        let mut seen: HashMap<NodeId, NodeId> = HashMap::new();
        for id in computed(self.graph, value, self.leaf) {
            let loops = self.graph.loops_of(id);
            let own = loops.iter().all(|by| iterations.iter().any(|iterations| iterations.by == Some(by)));
            // A table over both directions is one of rows.
            let rows_first = loops
                .iter()
                .eq(iterations.iter().filter_map(|iterations| iterations.by).filter(|by| loops.contains(*by)));
            let node = match self.graph.node(id) {
                _ if !own => return None,
                // The number of an iteration in a table is how far from its site the iteration begins, one for each loop.
                _ if (self.leaf)(self.graph, id) => {
                    (rows_first && (self.begins == Begins::Together || loops.is_empty())).then_some(id)?
                }
                Node::Coordinate(element) => self.neighbour(iterations, begins, element)?,
                Node::Sum(..) | Node::External(..) => return None,
                Node::CompareIndex(..) if !loops.is_empty() => return None,
                node => self.graph.rebuilt(node.map(|child| seen[&child])),
            };
            seen.insert(id, node);
        }
        seen.get(&value).copied()
    }

    /// A coordinate as seen from a site.
    fn neighbour(&mut self, iterations: &[Iterations], begins: &[i64], element: Element) -> Option<NodeId> {
        let directions = self.stencil.directions.iter_mut().zip(iterations.iter().zip(begins)).zip(indices(element));
        let seen = directions
            .map(|((direction, (iterations, begins)), index)| direction.seen(self.graph, iterations, *begins, index));
        match seen.collect::<Option<Vec<_>>>()?[..] {
            [index] => Some(self.graph.coordinate(Element { index, component: None, ..element })),
            [index, component] => Some(self.graph.coordinate(Element { index, component: Some(component), ..element })),
            _ => None,
        }
    }

    /// All contributions, where no loop runs in one direction for one of them and in the other for another.
    fn finished(self) -> Option<Stencil> {
        let Stencil { directions, mut contributions } = self.stencil;
        let of = |number: usize| directions.get(number).map(|direction| &direction.begins);
        if let (Some(rows), Some(sites)) = (of(0), of(1))
            && rows.keys().any(|by| sites.contains_key(by))
        {
            return None;
        }
        // What most sites have comes first, so that a sum begins with it.
        let is_few = |along: &Along| matches!(along.places, Extent::Few(..));
        contributions.sort_by_key(|contribution| (contribution.onward(), contribution.along.iter().any(is_few)));
        Some(Stencil { directions, contributions })
    }
}
