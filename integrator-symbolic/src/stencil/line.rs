//! Lines of sites with open ends: the neighbour that an end lacks is at rest, or does not exist.
//!
//! In: a stencil. Out: its contributions as one loop over all sites, and the boundary conditions at the ends; or
//! nothing, if an end differs in another way. Always true: the loop has the same sum as the stencil, if a neighbour
//! beyond an end is read as zero and the contribution of a missing bond is left out.

use super::{Along, Extent, SiteContribution, Stencil};
use crate::{
    differentiate::Contribution,
    graph::{
        Element, Graph, Node, NodeId, Part, Scope,
        index::{Index, IndexId, LoopId},
    },
};
use std::collections::HashMap;

/// The lanes of a vector of sites.
const LANES: u64 = 8;

/// A line of sites that are all alike.
#[derive(Debug)]
pub(crate) struct Line {
    /// The running index of the sites.
    pub(crate) site: LoopId,
    /// What each site computes from its own coordinate and that of the next one: addends of its own first, those of the
    /// next site after them.
    pub(crate) addends: Vec<Addend>,
    pub(crate) ends: Ends,
    /// How many vectors the sites fill.
    pub(crate) vectors: u64,
}

/// An addend of the gradient that sites compute.
#[derive(Debug)]
pub(crate) struct Addend {
    pub(crate) contribution: Contribution,
    /// Whether it is one of a bond after which there is nothing at the last site.
    pub(crate) without_last: bool,
}

/// What is beyond the ends of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ends {
    /// The last site is followed by the first.
    Ring,
    /// Before the first site and after the last one is one at rest, or nothing.
    Open { first_at_rest: bool, last_at_rest: bool },
}

/// Where a contribution of a line is added.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    /// To every site.
    Site,
    /// To every site but the last, by the bond to the next one.
    Bond,
    /// To every site but the first, by the bond from the one before.
    Onward,
    /// To the first site alone.
    First,
    /// To the last site alone.
    Last,
}

impl Stencil {
    /// The line that the stencil is, where its sites fill vectors and all are alike.
    pub(crate) fn line(&self, graph: &mut Graph) -> Option<Line> {
        let [direction] = &self.directions[..] else { return None };
        let number = direction.number.and_then(|number| u64::try_from(number).ok());
        let number = number.filter(|number| *number >= LANES && number.is_multiple_of(LANES))?;
        if direction.behind != 0 || direction.ahead != 1 {
            return None;
        }
        let site = direction.place;
        let here = graph.loops.intern(Index::Running(site));
        let one = graph.loops.intern(Index::Literal(1));
        let next = graph.loops.intern(Index::Add(here, one));
        let roles = self.contributions.iter().map(|contribution| role(graph, contribution, number, direction.periodic));
        let roles = roles.collect::<Option<Vec<_>>>()?;
        let of = |role| {
            let mut values = self.contributions.iter().zip(&roles).filter(|(_, known)| **known == role);
            values.next().map(|(contribution, _)| contribution.value)
        };
        let [bond, onward, first, last] = [Role::Bond, Role::Onward, Role::First, Role::Last].map(of);
        let is_tabled = |value: NodeId| {
            let tables = graph.reachable([value]).into_iter();
            tables.filter(|id| graph.is_prepared(*id)).any(|id| !graph.loops_of(id).is_empty())
        };
        if self.contributions.iter().any(|contribution| is_tabled(contribution.value)) {
            return None;
        }
        // Whether an end is the bond to a site at rest, whose index in the bond is `rest`.
        let mut is_at_rest = |end: Option<NodeId>, bond: Option<NodeId>, rest: IndexId| {
            let Some(end) = end else { return Some(false) };
            let mut of = |value, rest| Rest { rest, site: here, seen: HashMap::new() }.of(graph, value, false);
            (of(end, None)? == of(bond?, Some(rest))?).then_some(true)
        };
        let ends = if direction.periodic {
            Ends::Ring
        } else {
            Ends::Open { first_at_rest: is_at_rest(first, onward, here)?, last_at_rest: is_at_rest(last, bond, next)? }
        };
        let all = self.contributions.iter().zip(&roles);
        let of_all = all.filter(|(_, role)| !matches!(role, Role::First | Role::Last));
        let is_open = !matches!(ends, Ends::Ring | Ends::Open { last_at_rest: true, .. });
        let addends = of_all.map(|(contribution, role)| {
            let index = if contribution.onward() == [0] { here } else { next };
            let element = Element { part: Part::Position, index, component: None };
            let contribution = Contribution { context: vec![Scope::Loop(site)], element, value: contribution.value };
            Addend { contribution, without_last: is_open && *role == Role::Bond }
        });
        Some(Line { site, addends: addends.collect(), ends, vectors: number / LANES })
    }
}

/// The role of a contribution on a line of this number of sites.
fn role(graph: &Graph, contribution: &SiteContribution, number: u64, periodic: bool) -> Option<Role> {
    let [Along { onward, places }] = contribution.along[..] else { return None };
    let range = |from: IndexId, to: IndexId| Some((graph.loops.literal(from)?, graph.loops.literal(to)?));
    match (onward, places) {
        (0, Extent::All) => Some(Role::Site),
        (1, Extent::All) if periodic => Some(Role::Onward),
        _ if periodic => None,
        (0, Extent::Most(from, to)) if range(from, to)? == (0, number - 1) => Some(Role::Bond),
        (1, Extent::Most(from, to)) if range(from, to)? == (0, number - 1) => Some(Role::Onward),
        (0, Extent::Few(from, to)) if range(from, to)? == (0, 1) => Some(Role::First),
        (0, Extent::Few(from, to)) if range(from, to)? == (number - 1, number) => Some(Role::Last),
        _ => None,
    }
}

/// Values beside a neighbour at rest, with signs taken into sums: so that values which differ in nothing else are one node.
struct Rest {
    /// The index of the site that is at rest, if any.
    rest: Option<IndexId>,
    /// The index that the site beside it gets.
    site: IndexId,
    seen: HashMap<(NodeId, bool), NodeId>,
}

impl Rest {
    /// A value or its negative.
    fn of(&mut self, graph: &mut Graph, id: NodeId, negative: bool) -> Option<NodeId> {
        if let Some(seen) = self.seen.get(&(id, negative)) {
            return Some(*seen);
        }
        let value = match graph.node(id) {
            Node::Neg(a) => self.of(graph, a, !negative)?,
            // exact: -(x + y) == -x - y
            Node::Add(a, b) => {
                let (a, b) = (self.of(graph, a, negative)?, self.of(graph, b, negative)?);
                graph.add(a, b)
            }
            node => {
                let value = self.product(graph, id, node)?;
                if negative { graph.neg(value) } else { value }
            }
        };
        self.seen.insert((id, negative), value);
        Some(value)
    }

    /// A value that is no sum.
    fn product(&mut self, graph: &mut Graph, id: NodeId, node: Node) -> Option<NodeId> {
        if graph.is_prepared(id) {
            return Some(id);
        }
        let value = match node {
            Node::Coordinate(element) if Some(element.index) == self.rest => graph.constant(0.0),
            Node::Coordinate(element) if self.rest.is_some() => {
                graph.coordinate(Element { index: self.site, ..element })
            }
            Node::Coordinate(_) | Node::Time | Node::Middle => id,
            Node::Mul(a, b) => {
                let (a, b) = (self.of(graph, a, false)?, self.of(graph, b, false)?);
                graph.mul(a, b)
            }
            Node::Div(a, b) => {
                let (a, b) = (self.of(graph, a, false)?, self.of(graph, b, false)?);
                graph.div(a, b)
            }
            Node::Power(a, halves) => {
                let a = self.of(graph, a, false)?;
                graph.power(a, halves)
            }
            Node::Unary(function, a) => {
                let a = self.of(graph, a, false)?;
                graph.unary(function, a)
            }
            Node::Binary(function, a, b) => {
                let (a, b) = (self.of(graph, a, false)?, self.of(graph, b, false)?);
                graph.binary(function, a, b)
            }
            _ => return None,
        };
        Some(value)
    }
}
