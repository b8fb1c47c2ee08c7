//! One direction of a lattice: from site to site along a line, or from row to row of a plane.

use crate::graph::{
    Comparison, Graph, Node,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
};
use crate::reason::Reason;
use std::collections::HashMap;

/// Where the places are that differ from the others, and how far is looked.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    /// The running index of the places.
    pub(crate) place: LoopId,
    /// Whether what is added to several places is computed at each of them. Tables are read at a place of its own then.
    pub(super) apart: bool,
    /// The offset from the place to the former index of a loop: a table over that loop is read at this distance.
    pub(crate) begins: HashMap<LoopId, i64>,
    /// How many places at the beginning have contributions of their own, or lack one.
    pub(crate) first: u64,
    /// How many at the end.
    pub(crate) last: u64,
    /// How far before the place coordinates are read.
    pub(crate) behind: u64,
    /// How far ahead.
    pub(crate) ahead: u64,
    /// Whether the last place is followed by the first.
    pub(crate) periodic: bool,
    length: IndexId,
    /// The number of places, if it is known.
    pub(super) number: Option<i64>,
    /// How far before or after a place its contributions may read or go: as far as the runtime carries them.
    farthest: i64,
}

/// How far a contribution goes, and which places have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Along {
    /// How many places ahead.
    pub(crate) onward: usize,
    pub(crate) places: Extent,
}

/// A range of places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    /// All.
    All,
    /// All but a few at the ends.
    Most(IndexId, IndexId),
    /// A few at one end.
    Few(IndexId, IndexId),
}

/// A place, counted from the beginning or back from the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    FromBegin(i64),
    FromEnd(i64),
}

impl Place {
    fn further(self, by: i64) -> Self {
        match self {
            Place::FromBegin(place) => Place::FromBegin(place + by),
            Place::FromEnd(place) => Place::FromEnd(place - by),
        }
    }

    /// Whether it is a place of every lattice that is long enough.
    fn is_inside(self) -> bool {
        match self {
            Place::FromBegin(place) => place >= 0,
            Place::FromEnd(place) => place > 0,
        }
    }

    /// The number of the place on a lattice of this number.
    fn on(self, number: i64) -> i64 {
        match self {
            Place::FromBegin(place) => place,
            Place::FromEnd(place) => number - place,
        }
    }

    /// The end of iterations that also end before another place, where that is known for all lengths or for the one that is known.
    fn before(self, other: Self, number: Option<i64>) -> Option<Self> {
        if let Some(number) = number {
            return Some(if other.on(number) < self.on(number) { other } else { self });
        }
        match (self, other) {
            (Place::FromEnd(end), Place::FromEnd(other)) => Some(Place::FromEnd(end.max(other))),
            (Place::FromBegin(end), Place::FromBegin(other)) if other > 0 => Some(Place::FromBegin(end.min(other))),
            (Place::FromEnd(0), Place::FromBegin(other)) if other > 0 => Some(Place::FromBegin(other)),
            _ => None,
        }
    }

    /// The beginning of iterations that also begin at another place or after it, where that is known likewise.
    fn after(self, other: Self, number: Option<i64>) -> Option<Self> {
        if let Some(number) = number {
            return Some(if other.on(number) > self.on(number) { other } else { self });
        }
        match (self, other) {
            (Place::FromBegin(begin), Place::FromBegin(other)) => Some(Place::FromBegin(begin.max(other))),
            (Place::FromEnd(begin), Place::FromEnd(other)) if other > 0 => Some(Place::FromEnd(begin.min(other))),
            (Place::FromBegin(0), Place::FromEnd(other)) if other > 0 => Some(Place::FromEnd(other)),
            _ => None,
        }
    }
}

/// The number of places of the smallest lattice.
const SMALLEST: i64 = 1;

/// The iterations of a loop, or the one iteration where there is none, in which something is added to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Iterations {
    pub(super) by: Option<LoopId>,
    /// Whether there is one for every place; only then may the last place be followed by the first.
    whole: bool,
    /// Whether the place after the last one is the first one.
    wraps: bool,
    from: Place,
    to: Place,
    /// The place of an iteration minus its index; none if there is no loop.
    pub(super) to_place: i64,
}

impl Iterations {
    /// Whether they belong to a few places at one end.
    pub(super) fn are_few(&self) -> bool {
        self.by.is_some() && !self.run()
    }

    /// The first iteration and the others, where the first one would belong to a place before the first one.
    pub(super) fn cut(&self, begins: i64) -> Option<[Self; 2]> {
        let second = Place::FromBegin(1);
        let is_cut = self.run() && self.from == Place::FromBegin(0) && begins == -1 && self.always_has(self.from);
        is_cut.then_some([Self { to: second, whole: false, ..*self }, Self { from: second, whole: false, ..*self }])
    }

    /// Whether each of them may be seen from the place that it adds to: none that is counted from the end lies before the first
    /// one of a short lattice.
    pub(super) fn may_be_apart(&self) -> bool {
        match self.from {
            Place::FromBegin(_) => true,
            Place::FromEnd(from) => self.to_place <= 0 || from <= SMALLEST,
        }
    }

    /// Whether a few iterations and no others have a place where they are seen from there, on lattices of any length.
    fn are_seen(&self, begins: i64) -> bool {
        match (self.from, self.to) {
            (Place::FromBegin(_), Place::FromBegin(to)) => begins >= 0 || to <= SMALLEST,
            (Place::FromEnd(from), _) if begins < 0 => from - begins <= SMALLEST,
            (Place::FromEnd(from), _) => begins == 0 || from <= SMALLEST,
            _ => true,
        }
    }

    /// Whether one of them has the number of a place on every lattice.
    fn always_has(&self, place: Place) -> bool {
        match (self.from, self.to, place) {
            (Place::FromBegin(from), Place::FromEnd(to), Place::FromBegin(place)) => {
                from <= place && place < SMALLEST - to
            }
            (Place::FromBegin(from), Place::FromEnd(to), Place::FromEnd(place)) => {
                place > to && SMALLEST - place >= from
            }
            _ => false,
        }
    }

    /// Whether none of them has the number of a place on any lattice.
    fn never_has(&self, place: Place) -> bool {
        match (self.from, self.to, place) {
            (Place::FromBegin(_), Place::FromBegin(to), Place::FromEnd(place)) => SMALLEST - place >= to,
            (Place::FromEnd(from), Place::FromEnd(_), Place::FromBegin(place)) => place < SMALLEST - from,
            _ => false,
        }
    }

    /// Whether they run over the lattice.
    pub(super) fn run(&self) -> bool {
        matches!((self.from, self.to), (Place::FromBegin(_), Place::FromEnd(_)))
    }
}

/// An index as a sum.
#[derive(Clone, Copy)]
struct Linear {
    running: Option<LoopId>,
    lengths: i64,
    constant: i64,
    wraps: bool,
}

impl Direction {
    /// The direction of this number of places, inside the loop over another one.
    pub(super) fn new(
        graph: &mut Graph,
        parent: Option<LoopId>,
        length: IndexId,
        farthest: i64,
        apart: bool,
    ) -> Option<Self> {
        if graph.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let number = graph.loops.literal(length);
        let zero = graph.loops.intern(Index::Literal(0));
        Some(Self {
            place: graph.loops.range(Loop { parent, from: zero, to: length }),
            apart,
            begins: HashMap::new(),
            first: 0,
            last: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
            length,
            number: number.map(i64::try_from).transpose().ok()?,
            farthest,
        })
    }

    /// Whether coordinates are read beside the place itself.
    pub(crate) fn has_neighbours(&self) -> bool {
        self.behind > 0 || self.ahead > 0
    }

    /// The iterations of the loop whose index runs in `index`.
    pub(super) fn iterations(&mut self, graph: &Graph, index: IndexId) -> Result<Iterations, Reason> {
        let linear = self.linear(graph, index).ok_or(Reason::SiteIndex)?;
        let Some(by) = linear.running else {
            let place = self.place(linear).ok_or(Reason::Unrecognised)?;
            return Ok(Iterations {
                by: None,
                from: place,
                to: place.further(1),
                to_place: 0,
                whole: false,
                wraps: false,
            });
        };
        let Loop { from, to, .. } = graph.loops.get(by);
        let bound = |bound| self.place(self.linear(graph, bound)?);
        let (from, to) = bound(from).zip(bound(to)).ok_or(Reason::SiteRange)?;
        let whole = (from, to) == (Place::FromBegin(0), Place::FromEnd(0));
        if linear.lengths != 0 || linear.wraps && !whole {
            return Err(Reason::Unrecognised);
        }
        self.periodic |= linear.wraps;
        Ok(Iterations { by: Some(by), from, to, to_place: linear.constant, whole, wraps: linear.wraps })
    }

    /// Leaves of some iterations those in which a comparison of their number holds, or does not, and returns whether
    /// any may remain;
    /// `None` where these are no range, or where a lattice that is short may have another one.
    pub(super) fn narrow(&self, graph: &Graph, own: &mut Iterations, condition: Node, holds: bool) -> Option<bool> {
        let Node::CompareIndex(comparison, a, b) = condition else { return None };
        let (a, b) = (self.linear(graph, a)?, self.linear(graph, b)?);
        let (index, bound, is_first) = if a.running.is_some() { (a, b, true) } else { (b, a, false) };
        if index.running != own.by || index.lengths != 0 || index.wraps {
            return None;
        }
        let place = self.place(Linear { constant: bound.constant - index.constant, ..bound })?;
        let behind = place.further(1);
        let (from, to) = match (comparison, is_first, holds) {
            (Comparison::Less, true, true) | (Comparison::LessOrEqual, false, false) => {
                (own.from, own.to.before(place, self.number)?)
            }
            (Comparison::Less, true, false) | (Comparison::LessOrEqual, false, true) => {
                (own.from.after(place, self.number)?, own.to)
            }
            (Comparison::LessOrEqual, true, true) | (Comparison::Less, false, false) => {
                (own.from, own.to.before(behind, self.number)?)
            }
            (Comparison::LessOrEqual, true, false) | (Comparison::Less, false, true) => {
                (own.from.after(behind, self.number)?, own.to)
            }
            (Comparison::Equal, _, true) if own.whole && place.is_inside() || own.always_has(place) => (place, behind),
            (Comparison::Equal, _, true) if own.never_has(place) => return Some(false),
            (Comparison::Equal, _, false) if own.never_has(place) => (own.from, own.to),
            (Comparison::Equal, _, false) if place == own.from => (behind, own.to),
            (Comparison::Equal, _, false) if behind == own.to => (own.from, place),
            (Comparison::Equal, ..) => return None,
        };
        own.whole &= (from, to) == (own.from, own.to);
        (own.from, own.to) = (from, to);
        Some(self.number.is_none_or(|number| from.on(number) < to.on(number)))
    }

    /// Notes where what the iterations add goes, as seen from the first place that iterations of their loop add to,
    /// which is `begins` plus their index.
    ///
    /// Tables over the loop are read at that distance.
    pub(super) fn along(
        &mut self,
        graph: &mut Graph,
        iterations: &Iterations,
        begins: i64,
        reads_tables: bool,
    ) -> Option<Along> {
        let onward = iterations.to_place - begins;
        let (from, to) = (iterations.from.further(begins), iterations.to.further(begins));
        let places = match (from, to) {
            _ if !(0..=self.farthest).contains(&onward) => return None,
            _ if self.number.is_none() && iterations.are_few() && !iterations.are_seen(begins) => return None,
            _ if iterations.wraps && iterations.are_few() && begins != 0 => return None,
            // The first iteration would belong to a place before the first one, which open ends do not have.
            _ if iterations.whole && begins != 0 && !self.periodic => return None,
            _ if iterations.whole => Extent::All,
            (Place::FromBegin(first), Place::FromEnd(last)) => {
                self.first = self.first.max(u64::try_from(first).ok()?);
                self.last = self.last.max(u64::try_from(last).ok()?);
                Extent::Most(self.index(graph, from)?, self.index(graph, to)?)
            }
            (Place::FromBegin(_), Place::FromBegin(end)) => {
                self.first = self.first.max(u64::try_from(end).ok()?);
                Extent::Few(self.index(graph, from)?, self.index(graph, to)?)
            }
            (Place::FromEnd(begin), Place::FromEnd(_)) => {
                self.last = self.last.max(u64::try_from(begin).ok()?);
                Extent::Few(self.index(graph, from)?, self.index(graph, to)?)
            }
            (Place::FromEnd(_), Place::FromBegin(_)) => return None,
        };
        if let Some(by) = iterations.by {
            let begins_at = if self.apart { 0 } else { begins };
            if reads_tables {
                self.begins.insert(by, begins_at);
            } else {
                self.begins.entry(by).or_insert(begins_at);
            }
            if iterations.whole && !self.apart {
                self.first = self.first.max(begins.unsigned_abs());
                self.last = self.last.max(begins.unsigned_abs());
            }
        }
        Some(Along { onward: usize::try_from(onward).ok()?, places })
    }

    /// The index of a coordinate as seen from a place: how far it is from there.
    pub(super) fn seen(
        &mut self,
        graph: &mut Graph,
        iterations: &Iterations,
        begins: i64,
        index: IndexId,
    ) -> Result<IndexId, Reason> {
        let linear = self.linear(graph, index).ok_or(Reason::SiteIndex)?;
        self.periodic |= linear.wraps;
        let ahead = match iterations.by {
            Some(by) if linear.running == Some(by) && linear.lengths == 0 && (!linear.wraps || iterations.whole) => {
                linear.constant - begins
            }
            None => {
                let place = self.place(linear).ok_or(Reason::Unrecognised)?;
                self.nearest(iterations.from, place).ok_or(Reason::Unrecognised)?
            }
            Some(_) => return Err(Reason::Unrecognised),
        };
        if ahead.abs() > self.farthest {
            return Err(Reason::SiteFar);
        }
        let (far, here) = (ahead.unsigned_abs(), graph.loops.intern(Index::Running(self.place)));
        let distance = graph.loops.intern(Index::Literal(far));
        Ok(if ahead < 0 {
            self.behind = self.behind.max(far);
            graph.loops.intern(Index::Sub(here, distance))
        } else {
            self.ahead = self.ahead.max(far);
            graph.loops.intern(Index::Add(here, distance))
        })
    }

    /// Whether an index is the number of a place in each of some iterations, on a lattice of any length.
    pub(super) fn is_within(&self, graph: &Graph, own: &Iterations, index: IndexId) -> bool {
        let Some(linear) = self.linear(graph, index) else { return false };
        let (first, behind) = match (linear.running, self.place(linear)) {
            (Some(_), _) => (own.from.further(linear.constant), own.to.further(linear.constant)),
            (None, Some(place)) => (place, place.further(1)),
            (None, None) => return false,
        };
        let smallest = self.number.unwrap_or(SMALLEST);
        let is_after_first = match first {
            Place::FromBegin(place) => place >= 0,
            Place::FromEnd(place) => place <= smallest,
        };
        let is_before_end = match behind {
            Place::FromBegin(place) => place <= smallest,
            Place::FromEnd(place) => place >= 0,
        };
        linear.wraps || is_after_first && is_before_end
    }

    fn linear(&self, graph: &Graph, index: IndexId) -> Option<Linear> {
        let plain = |running, lengths, constant| Some(Linear { running, lengths, constant, wraps: false });
        if index == self.length && self.number.is_none() {
            return plain(None, 1, 0);
        }
        match graph.loops.index(index) {
            Index::Literal(value) => plain(None, 0, i64::try_from(value).ok()?),
            Index::Running(by) => plain(Some(by), 0, 0),
            Index::Typed(_, a) => self.linear(graph, a),
            Index::Add(a, b) => self.sum(graph, a, b, 1),
            // Bounds of a lattice that is long enough: nothing is below zero.
            Index::Sub(a, b) | Index::Minus(a, b) | Index::Monus(a, b) => self.sum(graph, a, b, -1),
            Index::Rem(a, b) if b == self.length => {
                let inner = self.linear(graph, a).filter(|inner| !inner.wraps && inner.running.is_some())?;
                // The nearest of all numbers that are the same place.
                let constant = self.number.map_or(inner.constant, |number| {
                    let rest = inner.constant.rem_euclid(number.max(1));
                    if 2 * rest > number { rest - number } else { rest }
                });
                Some(Linear { running: inner.running, lengths: 0, constant, wraps: true })
            }
            _ => None,
        }
    }

    fn sum(&self, graph: &Graph, a: IndexId, b: IndexId, sign: i64) -> Option<Linear> {
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
    fn place(&self, linear: Linear) -> Option<Place> {
        let Linear { running: None, lengths, constant, wraps: false } = linear else { return None };
        match (lengths, self.number) {
            (0, Some(number)) if 2 * constant > number => Some(Place::FromEnd(number - constant)),
            (0, _) => Some(Place::FromBegin(constant)),
            (1, None) => Some(Place::FromEnd(-constant)),
            _ => None,
        }
    }

    /// The distance from `from` to a place, around the ends of the lattice if that is shorter.
    fn nearest(&mut self, from: Place, to: Place) -> Option<i64> {
        if let Some(ahead) = self.distance(from, to).filter(|ahead| ahead.abs() <= self.farthest) {
            return Some(ahead);
        }
        let ahead = match (from, to) {
            (Place::FromEnd(a), Place::FromBegin(b)) => a + b,
            (Place::FromBegin(a), Place::FromEnd(b)) => -a - b,
            _ => return None,
        };
        self.periodic |= ahead.abs() <= self.farthest;
        Some(ahead)
    }

    /// The distance from `from` to a place.
    fn distance(&self, from: Place, to: Place) -> Option<i64> {
        match (from, to, self.number) {
            (Place::FromBegin(a), Place::FromBegin(b), _) | (Place::FromEnd(b), Place::FromEnd(a), _) => Some(b - a),
            (Place::FromBegin(a), Place::FromEnd(b), Some(number)) => Some(number - b - a),
            (Place::FromEnd(a), Place::FromBegin(b), Some(number)) => Some(b + a - number),
            _ => None,
        }
    }

    /// The number of a place.
    fn index(&self, graph: &mut Graph, place: Place) -> Option<IndexId> {
        if matches!(place, Place::FromEnd(..0)) {
            return None;
        }
        let (back, constant) = match (place, self.number) {
            (Place::FromBegin(constant), _) => (None, constant),
            (Place::FromEnd(constant), Some(number)) => (None, number - constant),
            (Place::FromEnd(constant), None) => (Some(self.length), constant),
        };
        let literal = graph.loops.intern(Index::Literal(u64::try_from(constant).ok()?));
        Some(back.map_or(literal, |length| graph.loops.intern(Index::Monus(length, literal))))
    }
}
