//! Gradients in which every site of a lattice takes part alike, in a form in which each gets all its addends at once.
//!
//! Comes in: contributions to a gradient. Goes out: the same as shares: each is computed at a site from its
//! neighbourhood and belongs to that site or to one further on. Always true: the shares are the contributions, turn by
//! turn, with the turns of every loop renumbered so that none belongs to a site behind; or nothing comes out, where one
//! contribution is of another kind.

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId,
        index::{Index, IndexId, Loop, LoopId},
    },
};
use std::collections::{BTreeSet, HashMap};

/// How far ahead of a site or behind it its shares may look or go: as far as the runtime's sweep carries them.
const FARTHEST: i64 = 2;

/// What is computed at each site, and where the sites are that differ from the others.
#[derive(Debug)]
pub(crate) struct Gathered {
    /// The running index of the sites.
    pub(crate) site: LoopId,
    pub(crate) shares: Vec<Share>,
    /// How far behind its site what was the index of a loop begins: a table over that loop is read so much further on.
    pub(crate) begins: HashMap<LoopId, i64>,
    /// How many sites at the beginning have shares of their own, or lack one.
    pub(crate) first: u64,
    /// How many at the end.
    pub(crate) last: u64,
    /// How far behind coordinates are read.
    pub(crate) behind: u64,
    /// How far ahead.
    pub(crate) ahead: u64,
    /// Whether the last site is followed by the first.
    pub(crate) periodic: bool,
}

impl Gathered {
    /// How many places further on the farthest share goes.
    pub(crate) fn onward(&self) -> usize {
        self.shares.iter().map(|share| share.onward).max().unwrap_or(0)
    }
}

/// What a range of sites adds to themselves or to others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Share {
    /// How many places further on.
    pub(crate) onward: usize,
    pub(crate) sites: Extent,
    pub(crate) value: NodeId,
}

/// A range of sites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    /// All.
    All,
    /// All but a few at the ends.
    Most(IndexId, IndexId),
    /// A few at one end.
    Few(IndexId, IndexId),
}

/// How many sites a lattice has at least, if their number is known: fewer are as fast in a plain loop.
const FEWEST: u64 = 8;

/// The shares of `gradient`, where all of it has that form; `leaf` tells which nodes are read, not computed.
pub(crate) fn gathered(
    graph: &mut Graph,
    gradient: &[Contribution],
    length: IndexId,
    leaf: impl Fn(&Graph, NodeId) -> bool,
) -> Option<Gathered> {
    if graph.loops.literal(length).is_some_and(|number| number < FEWEST) {
        return None;
    }
    let zero = graph.loops.intern(Index::Literal(0));
    let site = graph.loops.range(Loop { parent: None, from: zero, to: length });
    let mut gathering = Gathering {
        lattice: Lattice { length, number: graph.loops.literal(length).map(i64::try_from).transpose().ok()? },
        leaf: &leaf,
        graph,
        gathered: Gathered {
            site,
            shares: Vec::new(),
            begins: HashMap::new(),
            first: 0,
            last: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        },
    };
    let turns = gradient.iter().map(|contribution| gathering.turns(contribution)).collect::<Option<Vec<_>>>()?;
    // Nothing is gained where no loop runs over the lattice.
    turns.iter().find(|turns| matches!((turns.from, turns.to), (Place::FromBegin(_), Place::FromEnd(_))))?;
    for turn in &turns {
        let together = turns.iter().filter(|other| turn.by.is_some() && other.by == turn.by);
        let begins = together.map(|other| other.to_site).min().unwrap_or_default();
        gathering.share(turn, begins)?;
    }
    // What most sites have comes first, so that a sum begins with it.
    gathering.gathered.shares.sort_by_key(|share| (share.onward, matches!(share.sites, Extent::Few(..))));
    Some(gathering.gathered)
}

/// A place in the lattice, counted from its beginning or back from its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    FromBegin(i64),
    FromEnd(i64),
}

/// The turns of a loop, or the one turn where there is none, in which something is added to a site.
#[derive(Debug, PartialEq)]
struct Turns {
    by: Option<LoopId>,
    /// Whether there is one for every site; only then may the last site be followed by the first.
    whole: bool,
    from: Place,
    to: Place,
    /// How much further on than its number the site of a turn is; nothing where there is no loop.
    to_site: i64,
    value: NodeId,
}

/// An index as a sum.
#[derive(Clone, Copy)]
struct Linear {
    running: Option<LoopId>,
    lengths: i64,
    constant: i64,
    wraps: bool,
}

/// How many sites there are.
#[derive(Clone, Copy)]
struct Lattice {
    length: IndexId,
    number: Option<i64>,
}

impl Lattice {
    fn linear(self, graph: &Graph, index: IndexId) -> Option<Linear> {
        let plain = |running, lengths, constant| Some(Linear { running, lengths, constant, wraps: false });
        if index == self.length && self.number.is_none() {
            return plain(None, 1, 0);
        }
        match graph.loops.index(index) {
            Index::Literal(value) => plain(None, 0, i64::try_from(value).ok()?),
            Index::Running(by) => plain(Some(by), 0, 0),
            Index::Add(a, b) => self.sum(graph, a, b, 1),
            Index::Sub(a, b) => self.sum(graph, a, b, -1),
            Index::Rem(a, b) if b == self.length => {
                let inner = self.linear(graph, a).filter(|inner| !inner.wraps && inner.running.is_some())?;
                // The nearest of all numbers that are the same site.
                let constant = self.number.map_or(inner.constant, |number| {
                    let rest = inner.constant.rem_euclid(number.max(1));
                    if 2 * rest > number { rest - number } else { rest }
                });
                Some(Linear { running: inner.running, lengths: 0, constant, wraps: true })
            }
            _ => None,
        }
    }

    fn sum(self, graph: &Graph, a: IndexId, b: IndexId, sign: i64) -> Option<Linear> {
        let (a, b) = (self.linear(graph, a)?, self.linear(graph, b)?);
        let running = match (a.running, b.running, sign) {
            (running, None, _) => running,
            (None, running, 1) => running,
            _ => return None,
        };
        let lengths = a.lengths + sign * b.lengths;
        let constant = a.constant.checked_add(sign * b.constant)?;
        (!a.wraps && !b.wraps).then_some(Linear { running, lengths, constant, wraps: false })
    }

    /// An index without a loop, as a place; of those in the middle of a lattice of known length, from the nearer end.
    fn place(self, linear: Linear) -> Option<Place> {
        let Linear { running: None, lengths, constant, wraps: false } = linear else { return None };
        match (lengths, self.number) {
            (0, Some(number)) if 2 * constant > number => Some(Place::FromEnd(number - constant)),
            (0, _) => Some(Place::FromBegin(constant)),
            (1, None) => Some(Place::FromEnd(-constant)),
            _ => None,
        }
    }

    /// How much further on than `from` a place is.
    fn distance(self, from: Place, to: Place) -> Option<i64> {
        match (from, to, self.number) {
            (Place::FromBegin(a), Place::FromBegin(b), _) | (Place::FromEnd(b), Place::FromEnd(a), _) => Some(b - a),
            (Place::FromBegin(a), Place::FromEnd(b), Some(number)) => Some(number - b - a),
            (Place::FromEnd(a), Place::FromBegin(b), Some(number)) => Some(b + a - number),
            _ => None,
        }
    }
}

impl Place {
    fn further(self, by: i64) -> Self {
        match self {
            Place::FromBegin(place) => Place::FromBegin(place + by),
            Place::FromEnd(place) => Place::FromEnd(place - by),
        }
    }
}

struct Gathering<'g, L> {
    graph: &'g mut Graph,
    leaf: &'g L,
    lattice: Lattice,
    gathered: Gathered,
}

impl<L: Fn(&Graph, NodeId) -> bool> Gathering<'_, L> {
    fn turns(&mut self, contribution: &Contribution) -> Option<Turns> {
        let Contribution { context, element, value } = contribution;
        let linear = self.lattice.linear(self.graph, element.index)?;
        if element.component.is_some() {
            return None;
        }
        let by = contribution.loops().next();
        if by != linear.running || context.len() > usize::from(by.is_some()) {
            return None;
        }
        let Some(by) = by else {
            let place = self.lattice.place(linear)?;
            return Some(Turns {
                by: None,
                from: place,
                to: place.further(1),
                to_site: 0,
                whole: false,
                value: *value,
            });
        };
        let Loop { parent: None, from, to } = self.graph.loops.get(by) else { return None };
        let bound = |bound| self.lattice.place(self.lattice.linear(self.graph, bound)?);
        let (from, to) = (bound(from)?, bound(to)?);
        let whole = (from, to) == (Place::FromBegin(0), Place::FromEnd(0));
        if linear.lengths != 0 || linear.wraps && !whole {
            return None;
        }
        self.gathered.periodic |= linear.wraps;
        Some(Turns { by: Some(by), from, to, to_site: linear.constant, whole, value: *value })
    }

    /// Notes what one turn of a loop adds to a site, as seen from the first site that the loop's turns add to, which is
    /// `begins` further on than their number.
    fn share(&mut self, turns: &Turns, begins: i64) -> Option<()> {
        let onward = turns.to_site - begins;
        let (from, to) = (turns.from.further(begins), turns.to.further(begins));
        let value = self.seen(turns, begins)?;
        let gathered = &mut self.gathered;
        let sites = match (from, to) {
            _ if !(0..=FARTHEST).contains(&onward) => return None,
            _ if turns.whole => Extent::All,
            (Place::FromBegin(first), Place::FromEnd(last)) => {
                gathered.first = gathered.first.max(u64::try_from(first).ok()?);
                gathered.last = gathered.last.max(u64::try_from(last).ok()?);
                Extent::Most(self.index(from)?, self.index(to)?)
            }
            (Place::FromBegin(_), Place::FromBegin(end)) => {
                gathered.first = gathered.first.max(u64::try_from(end).ok()?);
                Extent::Few(self.index(from)?, self.index(to)?)
            }
            (Place::FromEnd(begin), Place::FromEnd(_)) => {
                gathered.last = gathered.last.max(u64::try_from(begin).ok()?);
                Extent::Few(self.index(from)?, self.index(to)?)
            }
            (Place::FromEnd(_), Place::FromBegin(_)) => return None,
        };
        let onward = usize::try_from(onward).ok()?;
        let gathered = &mut self.gathered;
        if let Some(by) = turns.by {
            gathered.begins.insert(by, begins);
            if turns.whole {
                gathered.first = gathered.first.max(begins.unsigned_abs());
                gathered.last = gathered.last.max(begins.unsigned_abs());
            }
        }
        match gathered.shares.iter_mut().find(|share| share.onward == onward && share.sites == sites) {
            Some(share) => share.value = self.graph.add(share.value, value),
            None => gathered.shares.push(Share { onward, sites, value }),
        }
        Some(())
    }

    /// The number of a site.
    fn index(&mut self, place: Place) -> Option<IndexId> {
        let (back, constant) = match (place, self.lattice.number) {
            (Place::FromBegin(constant), _) => (None, constant),
            (Place::FromEnd(constant), Some(number)) => (None, number - constant),
            (Place::FromEnd(constant), None) => (Some(self.lattice.length), constant),
        };
        let literal = self.graph.loops.intern(Index::Literal(u64::try_from(constant).ok()?));
        Some(back.map_or(literal, |length| self.graph.loops.intern(Index::Sub(length, literal))))
    }

    /// The value of a turn as seen from its site: coordinates are named by how far from the site they are.
    fn seen(&mut self, turns: &Turns, begins: i64) -> Option<NodeId> {
        let mut used = BTreeSet::new();
        let mut open = vec![turns.value];
        while let Some(id) = open.pop() {
            if used.insert(id) && !(self.leaf)(self.graph, id) {
                open.extend(self.graph.node(id).children());
            }
        }
        let mut seen: HashMap<NodeId, NodeId> = HashMap::new();
        for id in used {
            let own = self.graph.loops_of(id).iter().all(|by| Some(by) == turns.by);
            let node = match self.graph.node(id) {
                _ if !own => return None,
                _ if (self.leaf)(self.graph, id) => id,
                Node::Coordinate(element) => self.neighbour(turns, begins, element)?,
                Node::Sum(..) | Node::External(..) | Node::ExternalTwo(..) => return None,
                Node::CompareIndex(..) if !self.graph.loops_of(id).is_empty() => return None,
                node => self.graph.rebuilt(node.map(|child| seen[&child])),
            };
            seen.insert(id, node);
        }
        seen.get(&turns.value).copied()
    }

    /// A coordinate as seen from a site.
    fn neighbour(&mut self, turns: &Turns, begins: i64, element: Element) -> Option<NodeId> {
        let linear = self.lattice.linear(self.graph, element.index)?;
        let ahead = match turns.by {
            Some(by) if linear.running == Some(by) && linear.lengths == 0 && (!linear.wraps || turns.whole) => {
                linear.constant - begins
            }
            None => self.lattice.distance(turns.from, self.lattice.place(linear)?)?,
            Some(_) => return None,
        };
        if element.component.is_some() || ahead.abs() > FARTHEST {
            return None;
        }
        let (far, here) = (ahead.unsigned_abs(), self.graph.loops.intern(Index::Running(self.gathered.site)));
        let distance = self.graph.loops.intern(Index::Literal(far));
        let index = if ahead < 0 {
            self.gathered.behind = self.gathered.behind.max(far);
            self.graph.loops.intern(Index::Sub(here, distance))
        } else {
            self.gathered.ahead = self.gathered.ahead.max(far);
            self.graph.loops.intern(Index::Add(here, distance))
        };
        Some(self.graph.coordinate(Element { index, ..element }))
    }
}
