//! Gradients with the same formula for every site of a lattice, in a form in which each site gets all its addends
//! together.
//!
//! In: contributions to a gradient. Out: a stencil: each contribution is computed at a site from its neighbourhood and
//! belongs to that site or to a later one. A lattice is a line of sites, a plane of rows, or a volume of planes. No
//! contribution belongs to a later plane, so bonds between planes are computed on both sides.
//!
//! Always true: the stencil has the same sum as the input, iteration by iteration. The iterations of every loop are
//! renumbered so that none belongs to an earlier site. If one contribution is of another kind, there is no stencil.

mod direction;
mod line;
mod pieces;

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId,
        index::{Index, IndexId, LoopId},
    },
    reason::Reason,
};
use direction::Iterations;
pub(crate) use direction::{Along, Direction, Extent};
pub(crate) use line::{Addend, Ends, Line};
use pieces::{Piece, pieces};
use std::collections::{BTreeSet, HashMap};

/// How far the contributions of a site look and go along a line or a row.
const FARTHEST: i64 = 2;

/// How many rows they look and go over, and how many planes they look over.
const FARTHEST_ROW: i64 = 1;

/// A stencil: what is computed at each site, and where the sites are that differ from the others.
#[derive(Clone, Debug)]
pub(crate) struct Stencil {
    /// From plane to plane and from row to row, where there are any, and from site to site.
    pub(crate) directions: Vec<Direction>,
    pub(crate) contributions: Vec<SiteContribution>,
    /// The numbers of rows and of sites in a row, where coordinates are flat.
    pub(crate) flat: Option<[IndexId; 2]>,
}

/// What sites make up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lattice {
    /// One row.
    Line,
    /// Rows, one below the other.
    Plane,
    /// Planes, one after the other.
    Volume,
}

/// A contribution of a range of sites to themselves or to others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SiteContribution {
    /// How far it goes in every direction.
    pub(crate) along: Vec<Along>,
    pub(crate) value: NodeId,
}

impl SiteContribution {
    /// How many places ahead the contribution goes in every direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        self.along.iter().map(|along| along.onward).collect()
    }
}

impl Stencil {
    /// What the sites make up.
    pub(crate) fn lattice(&self) -> Lattice {
        match self.directions.len() {
            1 => Lattice::Line,
            2 => Lattice::Plane,
            _ => Lattice::Volume,
        }
    }

    /// Whether rows hand something on that takes no longer to compute again than to be kept.
    fn hands_on_to_rows_what_is_cheap(&self, graph: &Graph, leaf: &impl Fn(&Graph, NodeId) -> bool) -> bool {
        let is_to_row =
            |contribution: &&SiteContribution| matches!(contribution.onward()[..], [.., rows, _] if rows > 0);
        let mut handed_on = self.contributions.iter().filter(is_to_row).peekable();
        let is_cheap = |contribution: &SiteContribution| {
            let mut nodes: Vec<_> = computed(graph, contribution.value, leaf).into_iter().collect();
            nodes.retain(|id| !leaf(graph, *id) && !graph.node(*id).is_read());
            let is_operation = |id: &NodeId| matches!(graph.node(*id), Node::Add(..) | Node::Mul(..) | Node::Neg(_));
            nodes.len() <= CHEAP && nodes.iter().all(is_operation)
        };
        handed_on.peek().is_some() && handed_on.all(is_cheap)
    }

    /// How many places ahead the farthest contribution goes in each direction.
    pub(crate) fn onward(&self) -> Vec<usize> {
        let farthest =
            |direction: usize| self.contributions.iter().map(|contribution| contribution.along[direction].onward).max();
        (0..self.directions.len()).map(|direction| farthest(direction).unwrap_or(0)).collect()
    }

    /// The forward offsets of contributions, in order: along a line or a row as far as any goes, then those for the next
    /// row, as far as one of them goes.
    pub(crate) fn places(&self) -> Vec<Vec<usize>> {
        match self.onward()[..] {
            [ref planes @ .., rows, sites] => {
                let in_plane = |onward: Vec<usize>| [onward[planes.len()], onward[planes.len() + 1]];
                let onward = self.contributions.iter().map(|contribution| in_plane(contribution.onward()));
                let below = onward.filter(|[rows, _]| *rows > 0).map(|[_, sites]| sites).max().unwrap_or(0);
                let far = move |row| if row == 0 { sites } else { below };
                let place = |row, site| planes.iter().copied().chain([row, site]).collect();
                (0..=rows)
                    .flat_map(|row| (0..=far(row)).map(move |site| (row, site)))
                    .map(|(row, site)| place(row, site))
                    .collect()
            }
            ref line => (0..=line.iter().sum()).map(|site| vec![site]).collect(),
        }
    }
}

/// The most additions and multiplications that take no longer than storing and loading a number.
const CHEAP: usize = 3;

/// How many directions a volume has.
const VOLUME: usize = 3;

/// How many sites a line or a row has at least, if their number is known: fewer are as fast in a plain loop.
const FEWEST: u64 = 8;

/// What is known of coordinates with two indices where the second has no literal number of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Components {
    /// The sites of rows: another gradient of the system adds to neighbours along them.
    Sites,
    /// They may be the few components of points, too.
    Unknown,
    /// The sites of rows, where coordinates are flat: a number beyond the end of a row is that of a site in the next one.
    Flat,
}

/// The stencil of `gradient`, where all of it has that form, on a line or a plane of such lengths; `leaf` decides which
/// nodes are read, not computed.
pub(crate) fn stencil(
    graph: &mut Graph,
    gradient: &[Contribution],
    lengths: &[IndexId],
    components: Components,
    leaf: impl Fn(&Graph, NodeId) -> bool,
) -> Result<Stencil, Reason> {
    let pieces = pieces(graph, gradient, &leaf).ok_or(Reason::SiteCondition)?;
    let of = |graph: &mut Graph, begins| stencil_of(graph, &pieces, (lengths, components), begins, &leaf);
    let Ok(together) = of(graph, Begins::Together) else { return of(graph, Begins::Apart) };
    if together.hands_on_to_rows_what_is_cheap(graph, &leaf) {
        return of(graph, Begins::RowsApart).or(Ok(together));
    }
    Ok(together)
}

/// Which site sees what an iteration adds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begins {
    /// The first one that iterations of its loop add to: what is added to several sites is computed once.
    Together,
    /// The same along rows; across these the one that it is added to.
    RowsApart,
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
) -> Result<Stencil, Reason> {
    let number = graph.loops.literal(*lengths.last().ok_or(Reason::Unrecognised)?);
    if number.is_some_and(|number| number < FEWEST) {
        return Err(Reason::FewSites);
    }
    let mut directions: Vec<Direction> = Vec::new();
    for (level, length) in lengths.iter().enumerate() {
        let farthest = if level + 1 < lengths.len() { FARTHEST_ROW } else { FARTHEST };
        let parent = directions.last().map(|outer| outer.place);
        let apart = match begins {
            // From plane to plane nothing is handed on.
            Begins::Together => lengths.len() == VOLUME && level == 0,
            Begins::RowsApart => level + 1 < lengths.len(),
            Begins::Apart => true,
        };
        directions.push(Direction::new(graph, parent, *length, farthest, apart).ok_or(Reason::Unrecognised)?);
    }
    let is_flat = components == Components::Flat;
    let stencil = Stencil { directions, contributions: Vec::new(), flat: None };
    let mut gathering = Gathering { leaf, graph, stencil, is_flat };
    let mut made = Vec::new();
    for piece in pieces {
        made.extend(gathering.iterations(piece)?.map(|iterations| (&piece.contribution, iterations)));
    }
    let (gradient, iterations): (Vec<_>, Vec<_>) = made.into_iter().unzip();
    // Nothing is gained where no loops run over the lattice.
    let run = |iterations: &Vec<Iterations>| iterations.iter().all(Iterations::run);
    if !iterations.iter().any(run) {
        return Err(Reason::NoSites);
    }
    for (contribution, own) in gradient.iter().zip(&iterations) {
        let reads_tables = gathering.reads_tables(contribution.value);
        let begins = own.iter().enumerate().map(|(direction, own)| {
            // What a few sites add is handed on to none.
            if gathering.stencil.directions[direction].apart || own.are_few() && own.may_be_apart() && !reads_tables {
                return own.to_place;
            }
            let all = iterations.iter().map(|iterations| &iterations[direction]);
            let together =
                all.filter(|other| own.by.is_some() && other.by == own.by && (reads_tables || !other.are_few()));
            together.map(|other| other.to_place).min().unwrap_or_default()
        });
        let mut begins: Vec<_> = begins.collect();
        let last = own.len() - 1;
        let is_open = !gathering.stencil.directions[last].periodic;
        let (first, others) = match own[last].cut(begins[last]).filter(|_| !reads_tables && is_open) {
            Some([first, others]) => (Some(first), others),
            None => (None, own[last]),
        };
        let mut own = own.clone();
        own[last] = others;
        gathering.contribution(contribution.value, &own, &begins, reads_tables)?;
        if let Some(first) = first {
            (own[last], begins[last]) = (first, first.to_place);
            gathering.contribution(contribution.value, &own, &begins, reads_tables)?;
        }
    }
    let stencil = gathering.finished().ok_or(Reason::Unrecognised)?;
    let may_be_points = stencil.lattice() == Lattice::Plane && number.is_none() && components == Components::Unknown;
    let is_row = stencil.directions.last().is_some_and(Direction::has_neighbours);
    if may_be_points && !is_row { Err(Reason::Unrecognised) } else { Ok(stencil) }
}

/// What is computed of a value and what it reads, children first; `leaf` decides what is read.
fn computed(graph: &Graph, value: NodeId, leaf: impl Fn(&Graph, NodeId) -> bool) -> BTreeSet<NodeId> {
    let (mut nodes, mut open) = (BTreeSet::new(), vec![value]);
    while let Some(id) = open.pop() {
        if nodes.insert(id) && !leaf(graph, id) {
            open.extend(graph.node(id).children());
        }
    }
    nodes
}

struct Gathering<'g, L> {
    graph: &'g mut Graph,
    leaf: &'g L,
    stencil: Stencil,
    /// Whether an index has to be checked to stay within its row.
    is_flat: bool,
}

impl<L: Fn(&Graph, NodeId) -> bool> Gathering<'_, L> {
    /// The iterations in which a contribution is made, direction by direction; nothing inside, where there are none.
    fn iterations(&mut self, Piece { contribution, conditions }: &Piece) -> Result<Option<Vec<Iterations>>, Reason> {
        let graph = &*self.graph;
        let iterations = self.stencil.directions.iter_mut().zip(graph.loops.of_coordinate(contribution.element));
        let mut iterations =
            iterations.map(|(direction, index)| direction.iterations(graph, index)).collect::<Result<Vec<_>, _>>()?;
        for (condition, holds) in conditions {
            let loops = self.graph.loops_of(*condition);
            let mut directions = self.stencil.directions.iter().zip(&mut iterations);
            let of_loop = directions.find(|(_, own)| own.by.is_some_and(|by| loops.contains(by)));
            let (direction, own) = of_loop.ok_or(Reason::SiteCondition)?;
            let may_remain = direction.narrow(self.graph, own, self.graph.node(*condition), *holds);
            if !may_remain.ok_or(Reason::SiteCondition)? {
                return Ok(None);
            }
        }
        self.are_within(&iterations, contribution.element)?;
        // Every loop around it runs in one direction, and nothing else is around it.
        let by: BTreeSet<LoopId> = iterations.iter().filter_map(|iterations| iterations.by).collect();
        let around: BTreeSet<LoopId> = contribution.loops().collect();
        let running = iterations.iter().filter(|iterations| iterations.by.is_some()).count();
        let is_alone = by == around && running == by.len() && running == contribution.context.len();
        if is_alone { Ok(Some(iterations)) } else { Err(Reason::SiteScope) }
    }

    /// Nothing if the indices of a flat coordinate may lie beyond its row or the last row.
    fn are_within(&self, iterations: &[Iterations], element: Element) -> Result<(), Reason> {
        let directions = self.stencil.directions.iter().zip(iterations);
        let mut indices = directions.zip(self.graph.loops.of_coordinate(element));
        let are_within = indices.all(|((direction, own), index)| direction.is_within(self.graph, own, index));
        if self.is_flat && !are_within { Err(Reason::SiteFar) } else { Ok(()) }
    }

    /// Whether a value reads prepared constants by the index of an iteration.
    fn reads_tables(&self, value: NodeId) -> bool {
        let nodes = computed(self.graph, value, self.leaf);
        nodes.into_iter().any(|id| (self.leaf)(self.graph, id) && !self.graph.loops_of(id).is_empty())
    }

    /// Notes what some iterations add to a site, as seen from the first site that iterations of their loops add to.
    fn contribution(
        &mut self,
        value: NodeId,
        iterations: &[Iterations],
        begins: &[i64],
        reads_tables: bool,
    ) -> Result<(), Reason> {
        let value = self.seen(value, iterations, begins)?;
        let directions = self.stencil.directions.iter_mut().zip(iterations).zip(begins);
        let along = directions
            .map(|((direction, iterations), begins)| direction.along(self.graph, iterations, *begins, reads_tables));
        let along = along.collect::<Option<Vec<_>>>().ok_or(Reason::Unrecognised)?;
        match self.stencil.contributions.iter_mut().find(|contribution| contribution.along == along) {
            Some(contribution) => contribution.value = self.graph.add(contribution.value, value),
            None => self.stencil.contributions.push(SiteContribution { along, value }),
        }
        Ok(())
    }

    /// The value of an iteration as seen from its site: coordinates are named by how far from the site they are.
    fn seen(&mut self, value: NodeId, iterations: &[Iterations], begins: &[i64]) -> Result<NodeId, Reason> {
        let mut seen: HashMap<NodeId, NodeId> = HashMap::new();
        for id in computed(self.graph, value, self.leaf) {
            let loops = self.graph.loops_of(id);
            let own = loops.iter().all(|by| iterations.iter().any(|iterations| iterations.by == Some(by)));
            // A table over both directions is one of rows.
            let rows_first = loops
                .iter()
                .eq(iterations.iter().filter_map(|iterations| iterations.by).filter(|by| loops.contains(*by)));
            let node = match self.graph.node(id) {
                _ if !own => return Err(Reason::SiteScope),
                // The number of an iteration in a table is how far from its site the iteration begins, one for each loop.
                _ if (self.leaf)(self.graph, id) => {
                    let is_over = |own: &Iterations| own.by.is_some_and(|by| loops.contains(by));
                    let over: Vec<_> = iterations.iter().map(is_over).collect();
                    let directions = self.stencil.directions.iter().zip(begins).zip(&over);
                    let mut directions = directions.filter(|(_, is_over)| **is_over);
                    let is_table = directions.all(|((direction, begins), _)| !direction.apart || *begins == 0);
                    // Of tables over planes the runtime knows those of one number for each, or for each site.
                    let is_known = !matches!(over[..], [true, row, site] if row != site);
                    (rows_first && is_table && is_known).then_some(id).ok_or(Reason::Unrecognised)?
                }
                Node::Coordinate(element) => self.neighbour(iterations, begins, element)?,
                Node::Sum(..) | Node::Fold(..) => return Err(Reason::SiteSum),
                Node::External(..) => return Err(Reason::Method),
                Node::CompareIndex(..) if !loops.is_empty() => return Err(Reason::SiteCondition),
                node => self.graph.rebuilt(node.map(|child| seen[&child])),
            };
            seen.insert(id, node);
        }
        seen.get(&value).copied().ok_or(Reason::Unrecognised)
    }

    /// A coordinate as seen from a site.
    fn neighbour(&mut self, iterations: &[Iterations], begins: &[i64], element: Element) -> Result<NodeId, Reason> {
        self.are_within(iterations, element)?;
        let indices: Vec<_> = self.graph.loops.of_coordinate(element).collect();
        let directions = self.stencil.directions.iter_mut().zip(iterations.iter().zip(begins)).zip(indices);
        let seen = directions
            .map(|((direction, (iterations, begins)), index)| direction.seen(self.graph, iterations, *begins, index));
        let seen = seen.collect::<Result<Vec<_>, _>>()?;
        let loops = &mut self.graph.loops;
        let (index, component) = match seen[..] {
            [index] => (index, None),
            [index, component] => (index, Some(component)),
            // In another plane it is in the same row.
            [plane, row, site] if [plane, row].iter().any(|index| matches!(loops.index(*index), Index::Running(_))) => {
                (plane, Some(loops.intern(Index::InPlane(row, site))))
            }
            _ => return Err(Reason::SiteFar),
        };
        Ok(self.graph.coordinate(Element { index, component, ..element }))
    }

    /// All contributions, where no loop runs in one direction for one of them and in the other for another.
    fn finished(self) -> Option<Stencil> {
        let Stencil { directions, mut contributions, flat } = self.stencil;
        let mut loops = directions.iter().flat_map(|direction| direction.begins.keys());
        let mut seen = BTreeSet::new();
        if !loops.all(|by| seen.insert(*by)) {
            return None;
        }
        // What most sites have comes first, so that a sum begins with it.
        let is_few = |along: &Along| matches!(along.places, Extent::Few(..));
        contributions.sort_by_key(|contribution| (contribution.onward(), contribution.along.iter().any(is_few)));
        Some(Stencil { directions, contributions, flat })
    }
}
