//! Gradients in which every site of a lattice takes part alike, in a form in which each gets all its addends at once.
//!
//! Comes in: contributions to a gradient. Goes out: the same as shares: each is computed at a site from its
//! neighbourhood and belongs to that site or to one further on. A lattice is a line of sites, or a plane of rows.
//! Always true: the shares are the contributions, iteration by iteration, with the iterations of every loop renumbered
//! so that none belongs to a site behind; or nothing comes out, where one contribution is of another kind.

mod direction;

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId,
        index::{IndexId, LoopId},
    },
};
use direction::Iterations;
pub(crate) use direction::{Along, Direction, Extent};
use std::collections::{BTreeSet, HashMap};

/// How far the shares of a site look and go along a line or a row.
const FARTHEST: i64 = 2;

/// How many rows they look and go over.
const FARTHEST_ROW: i64 = 1;

/// What is computed at each site, and where the sites are that differ from the others.
#[derive(Debug)]
pub(crate) struct Gathered {
    /// From row to row, where there are rows, and from site to site.
    pub(crate) directions: Vec<Direction>,
    pub(crate) shares: Vec<Share>,
}

/// What a range of sites adds to themselves or to others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Share {
    /// How far it goes in every direction.
    pub(crate) along: Vec<Along>,
    pub(crate) value: NodeId,
}

impl Share {
    /// How many places further on the share goes in every direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        self.along.iter().map(|along| along.onward).collect()
    }
}

impl Gathered {
    /// Whether the sites are those of a plane.
    pub(crate) fn is_plane(&self) -> bool {
        self.directions.len() > 1
    }

    /// How many places further on the farthest share goes in each direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        let farthest = |direction: usize| self.shares.iter().map(|share| share.along[direction].onward).max();
        (0..self.directions.len()).map(|direction| farthest(direction).unwrap_or(0)).collect()
    }

    /// How far onward the shares go that there are to be, in order: along a line or a row as far as any share goes,
    /// then those for the next row, as far as one of them goes.
    pub(crate) fn places(&self) -> Vec<Vec<usize>> {
        match self.onward()[..] {
            [rows, sites] => {
                let onward = self.shares.iter().map(Share::onward).filter(|onward| onward[0] > 0);
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

/// The shares of `gradient`, where all of it has that form, on a line or a plane of such lengths; `leaf` tells which
/// nodes are read, not computed.
pub(crate) fn gathered(
    graph: &mut Graph,
    gradient: &[Contribution],
    lengths: &[IndexId],
    leaf: impl Fn(&Graph, NodeId) -> bool,
) -> Option<Gathered> {
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
    let mut gathering = Gathering { leaf: &leaf, graph, gathered: Gathered { directions, shares: Vec::new() } };
    let iterations =
        gradient.iter().map(|contribution| gathering.iterations(contribution)).collect::<Option<Vec<_>>>()?;
    // Nothing is gained where no loops run over the lattice.
    iterations.iter().find(|iterations| iterations.iter().all(Iterations::run))?;
    for (contribution, own) in gradient.iter().zip(&iterations) {
        let begins = own.iter().enumerate().map(|(direction, own)| {
            let all = iterations.iter().map(|iterations| &iterations[direction]);
            let together = all.filter(|other| own.by.is_some() && other.by == own.by);
            together.map(|other| other.to_place).min().unwrap_or_default()
        });
        gathering.share(contribution.value, own, &begins.collect::<Vec<_>>())?;
    }
    let gathered = gathering.finished()?;
    // Components of points may be counted by a constant too, and are few. Those of a row have neighbours.
    let may_be_points = gathered.is_plane() && number.is_none();
    let is_row = gathered.directions.last().is_some_and(Direction::has_neighbours);
    (!may_be_points || is_row).then_some(gathered)
}

/// The indices of a coordinate, one per direction.
fn indices(element: Element) -> impl Iterator<Item = IndexId> {
    [Some(element.index), element.component].into_iter().flatten()
}

struct Gathering<'g, L> {
    graph: &'g mut Graph,
    leaf: &'g L,
    gathered: Gathered,
}

impl<L: Fn(&Graph, NodeId) -> bool> Gathering<'_, L> {
    /// The iterations in which a contribution is made, direction by direction.
    fn iterations(&mut self, contribution: &Contribution) -> Option<Vec<Iterations>> {
        let indices = indices(contribution.element);
        let iterations = self.gathered.directions.iter_mut().zip(indices);
        let iterations =
            iterations.map(|(direction, index)| direction.iterations(self.graph, index)).collect::<Option<Vec<_>>>()?;
        // Every loop around it runs in one direction, and nothing else is around it.
        let by: BTreeSet<LoopId> = iterations.iter().filter_map(|iterations| iterations.by).collect();
        let around: BTreeSet<LoopId> = contribution.loops().collect();
        let running = iterations.iter().filter(|iterations| iterations.by.is_some()).count();
        (by == around && running == by.len() && running == contribution.context.len()).then_some(iterations)
    }

    /// Notes what some iterations add to a site, as seen from the first site that iterations of their loops add to.
    fn share(&mut self, value: NodeId, iterations: &[Iterations], begins: &[i64]) -> Option<()> {
        let value = self.seen(value, iterations, begins)?;
        let directions = self.gathered.directions.iter_mut().zip(iterations).zip(begins);
        let along =
            directions.map(|((direction, iterations), begins)| direction.along(self.graph, iterations, *begins));
        let along = along.collect::<Option<Vec<_>>>()?;
        match self.gathered.shares.iter_mut().find(|share| share.along == along) {
            Some(share) => share.value = self.graph.add(share.value, value),
            None => self.gathered.shares.push(Share { along, value }),
        }
        Some(())
    }

    /// The value of an iteration as seen from its site: coordinates are named by how far from the site they are.
    fn seen(&mut self, value: NodeId, iterations: &[Iterations], begins: &[i64]) -> Option<NodeId> {
        let mut used = BTreeSet::new();
        let mut open = vec![value];
        while let Some(id) = open.pop() {
            if used.insert(id) && !(self.leaf)(self.graph, id) {
                open.extend(self.graph.node(id).children());
            }
        }
        let mut seen: HashMap<NodeId, NodeId> = HashMap::new();
        for id in used {
            let loops = self.graph.loops_of(id);
            let own = loops.iter().all(|by| iterations.iter().any(|iterations| iterations.by == Some(by)));
            // A table over both directions is one of rows.
            let rows_first = loops
                .iter()
                .eq(iterations.iter().filter_map(|iterations| iterations.by).filter(|by| loops.contains(*by)));
            let node = match self.graph.node(id) {
                _ if !own => return None,
                _ if (self.leaf)(self.graph, id) => rows_first.then_some(id)?,
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
        let directions = self.gathered.directions.iter_mut().zip(iterations.iter().zip(begins)).zip(indices(element));
        let seen = directions
            .map(|((direction, (iterations, begins)), index)| direction.seen(self.graph, iterations, *begins, index));
        match seen.collect::<Option<Vec<_>>>()?[..] {
            [index] => Some(self.graph.coordinate(Element { index, component: None, ..element })),
            [index, component] => Some(self.graph.coordinate(Element { index, component: Some(component), ..element })),
            _ => None,
        }
    }

    /// All shares, where no loop runs in one direction for one of them and in the other for another.
    fn finished(self) -> Option<Gathered> {
        let Gathered { directions, mut shares } = self.gathered;
        let of = |number: usize| directions.get(number).map(|direction| &direction.begins);
        if let (Some(rows), Some(sites)) = (of(0), of(1))
            && rows.keys().any(|by| sites.contains_key(by))
        {
            return None;
        }
        // What most sites have comes first, so that a sum begins with it.
        let is_few = |along: &Along| matches!(along.places, Extent::Few(..));
        shares.sort_by_key(|share| (share.onward(), share.along.iter().any(is_few)));
        Some(Gathered { directions, shares })
    }
}
