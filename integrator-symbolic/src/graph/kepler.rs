//! Kepler parts, sums of `p²/2m - k/|q|` over bodies: their recognition, and the masses and strengths of the bodies.

use super::{
    Element, Graph, Node, NodeId, Part,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
    same_product::FactorsOf,
};

/// Bodies that move about the origin, alike but for their masses and strengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Orbits {
    pub(crate) bodies: Bodies,
    /// `1/m`
    pub(crate) inverse_mass: NodeId,
    /// `k`
    pub(crate) strength: NodeId,
}

/// The bodies that a term is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bodies {
    /// All coordinates are those of one body.
    Whole,
    /// The point with this index.
    One(IndexId),
    /// The points with the indices of a loop.
    Each(LoopId),
}

/// What keeps a sum with a term `k/|q|` from being one over Kepler parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stray {
    /// A term is neither a square of a momentum nor the inverse of a distance.
    Term,
    /// The squares of a body's momenta or positions lack a component.
    Component,
    /// The squares of a body's momenta have different factors.
    Mass,
    /// A body with `k/|q|` lacks `p²/2m`.
    Kinetic,
    /// A body may be in two sums.
    Twice,
}

/// The most terms that are looked at.
const MANY: usize = 4096;

/// A coefficient that depends on parameters alone times something else, summed over loops.
struct Term {
    /// The value that it was found as, without factors around it.
    whole: NodeId,
    loops: Vec<LoopId>,
    coefficient: NodeId,
    core: NodeId,
}

/// The components of a body that a square is about.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    All,
    Literal(u64),
}

/// What was found of the same bodies.
struct Found {
    bodies: Bodies,
    /// The factors of the squares of momenta.
    kinetic: Vec<(Component, NodeId)>,
    /// The factor of the inverse distance.
    potential: Option<NodeId>,
}

impl Graph {
    /// The orbits that an energy is the sum of. `extents` is the number of numbers or points of the coordinates, and that
    /// of the components of a point; `factors_of` returns the factors of parameters. Nothing but `None` stands in the way
    /// of an energy without a term `k/|q|`; of others, the terms that prevent it are returned, where these are known.
    pub(crate) fn orbits(
        &mut self,
        energy: NodeId,
        extents: &[IndexId],
        factors_of: FactorsOf<'_>,
    ) -> Result<Vec<Orbits>, Option<(Stray, Vec<NodeId>)>> {
        let one = self.constant(1.0);
        let mut terms = Vec::new();
        self.terms(energy, one, &mut Vec::new(), &mut terms);
        if terms.len() > MANY {
            return Err(Some((Stray::Term, Vec::new())));
        }
        // A number in an energy moves nothing.
        terms.retain(|term| !self.is_prepared(term.core));
        let mut found: Vec<Found> = Vec::new();
        let (mut strays, mut attracts) = (Vec::new(), false);
        for term in terms {
            if let Err(stray) = self.place(&term, extents, &mut attracts, &mut found) {
                strays.push((stray, term.whole));
            }
        }
        if !attracts {
            return Err(None);
        }
        if let Some((stray, _)) = strays.first() {
            return Err(Some((*stray, strays.iter().map(|(_, term)| *term).collect())));
        }
        let all: Vec<Bodies> = found.iter().map(|found| found.bodies).collect();
        let twice = (0..all.len()).any(|a| (0..a).any(|b| !self.are_apart(all[a], all[b])));
        if twice {
            return Err(Some((Stray::Twice, Vec::new())));
        }
        let orbits: Result<_, _> = found.into_iter().map(|found| self.orbit(found, extents, factors_of)).collect();
        orbits.map_err(|stray| Some((stray, Vec::new())))
    }

    /// The terms of a sum, with what they are multiplied by, numbers included; of too many, one more than are looked at.
    fn terms(&mut self, id: NodeId, coefficient: NodeId, loops: &mut Vec<LoopId>, terms: &mut Vec<Term>) {
        if terms.len() > MANY {
            return;
        }
        if self.is_prepared(id) {
            terms.push(Term { whole: id, loops: loops.clone(), coefficient, core: id });
            return;
        }
        match self.node(id) {
            Node::Add(a, b) => {
                self.terms(a, coefficient, loops, terms);
                self.terms(b, coefficient, loops, terms);
            }
            Node::Neg(a) => {
                let coefficient = self.neg(coefficient);
                self.terms(a, coefficient, loops, terms);
            }
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => {
                let coefficient = self.mul(coefficient, factor);
                self.terms(a, coefficient, loops, terms);
            }
            Node::Div(a, divisor) if self.is_prepared(divisor) => {
                let coefficient = self.div(coefficient, divisor);
                self.terms(a, coefficient, loops, terms);
            }
            Node::Sum(by, body) => {
                loops.push(by);
                self.terms(body, coefficient, loops, terms);
                loops.pop();
            }
            _ => {
                if let Some(sum) = self.guarded_sum(id) {
                    return self.terms(sum, coefficient, loops, terms);
                }
                let (coefficient, core) = self.gathered(id, coefficient);
                terms.push(Term { whole: id, loops: loops.clone(), coefficient, core });
            }
        }
    }

    /// A coefficient with those in front of each factor of a product, as in `(k p) p`, and the product of the others.
    fn gathered(&mut self, id: NodeId, coefficient: NodeId) -> (NodeId, NodeId) {
        match self.node(id) {
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => {
                let coefficient = self.mul(coefficient, factor);
                self.gathered(a, coefficient)
            }
            Node::Mul(a, b) => {
                let (coefficient, a) = self.gathered(a, coefficient);
                let (coefficient, b) = self.gathered(b, coefficient);
                (coefficient, self.mul(a, b))
            }
            _ => (coefficient, id),
        }
    }

    /// Adds a term to what was found of its bodies.
    fn place(
        &mut self,
        term: &Term,
        extents: &[IndexId],
        attracts: &mut bool,
        found: &mut Vec<Found>,
    ) -> Result<(), Stray> {
        let (bodies, component) = match self.distance_squared(term.core) {
            Some(square) => {
                *attracts = true;
                (self.squared_distance_of(square, &term.loops, extents)?, None)
            }
            None => {
                let (bodies, component) = self.square_of(term, Part::Momentum, extents).ok_or(Stray::Term)?;
                (bodies, Some(component))
            }
        };
        let own = match bodies {
            Bodies::Each(by) => LoopSet::of(by),
            Bodies::Whole | Bodies::One(_) => LoopSet::EMPTY,
        };
        if !self.loops_of(term.coefficient).is_subset(own) {
            return Err(if component.is_some() { Stray::Mass } else { Stray::Term });
        }
        let place = found.iter().position(|found| found.bodies == bodies).unwrap_or_else(|| {
            found.push(Found { bodies, kinetic: Vec::new(), potential: None });
            found.len() - 1
        });
        let found = &mut found[place];
        match component {
            None => {
                found.potential = Some(match found.potential {
                    Some(sum) => self.add(sum, term.coefficient),
                    None => term.coefficient,
                });
            }
            Some(component) => match found.kinetic.iter_mut().find(|(known, _)| *known == component) {
                Some((_, factor)) => *factor = self.add(*factor, term.coefficient),
                None => found.kinetic.push((component, term.coefficient)),
            },
        }
        Ok(())
    }

    /// The mass and the strength of bodies.
    fn orbit(&mut self, found: Found, extents: &[IndexId], factors_of: FactorsOf<'_>) -> Result<Orbits, Stray> {
        let Found { bodies, kinetic, potential } = found;
        let Some((_, factor)) = kinetic.first().copied() else { return Err(Stray::Kinetic) };
        if kinetic.iter().any(|(_, other)| !self.is_same_product(*other, factor, factors_of)) {
            return Err(Stray::Mass);
        }
        let components: Vec<_> = kinetic.into_iter().map(|(component, _)| component).collect();
        if !self.are_all(&components, extents) {
            return Err(Stray::Component);
        }
        let two = self.constant(2.0);
        let inverse_mass = self.mul(two, factor);
        let strength = match potential {
            Some(potential) => self.neg(potential),
            None => self.constant(0.0),
        };
        Ok(Orbits { bodies, inverse_mass, strength })
    }

    /// Whether these are the components of a body, each once.
    fn are_all(&self, components: &[Component], extents: &[IndexId]) -> bool {
        if components == [Component::All] {
            return true;
        }
        let Some(count) = extents.last().and_then(|extent| self.loops.literal(*extent)) else { return false };
        components.len() as u64 == count && components.iter().all(|component| *component != Component::All)
    }

    /// The square of the length that a term is the inverse of.
    fn distance_squared(&mut self, core: NodeId) -> Option<NodeId> {
        match self.node(core) {
            Node::Power(square, -1) => Some(square),
            Node::Power(length, -2) => self.squared(length),
            Node::Power(inverse, 1) => match self.node(inverse) {
                Node::Power(square, -2) => Some(square),
                _ => None,
            },
            _ => None,
        }
    }

    /// The square of a length, which is a root or a hypotenuse.
    fn squared(&mut self, length: NodeId) -> Option<NodeId> {
        match self.node(length) {
            Node::Power(square, 1) => Some(square),
            Node::Coordinate(_) => Some(self.power(length, 4)),
            Node::Binary(function, a, b) if function.name() == "hypot" => {
                let (a, b) = (self.squared(a)?, self.squared(b)?);
                Some(self.add(a, b))
            }
            _ => None,
        }
    }

    /// The bodies whose distance from the origin has this square.
    fn squared_distance_of(&mut self, square: NodeId, loops: &[LoopId], extents: &[IndexId]) -> Result<Bodies, Stray> {
        let one = self.constant(1.0);
        let mut terms = Vec::new();
        self.terms(square, one, &mut loops.to_vec(), &mut terms);
        if terms.len() > MANY {
            return Err(Stray::Term);
        }
        let mut components = Vec::new();
        let mut bodies = None;
        for term in &terms {
            let (of, component) = self.square_of(term, Part::Position, extents).ok_or(Stray::Term)?;
            if term.coefficient != one || *bodies.get_or_insert(of) != of || components.contains(&component) {
                return Err(Stray::Term);
            }
            components.push(component);
        }
        match bodies {
            Some(bodies) if self.are_all(&components, extents) => Ok(bodies),
            Some(_) => Err(Stray::Component),
            None => Err(Stray::Term),
        }
    }

    /// The bodies and the component of a square of a coordinate, whose loops are those over bodies and components alone.
    fn square_of(&self, term: &Term, part: Part, extents: &[IndexId]) -> Option<(Bodies, Component)> {
        let Node::Power(base, 4) = self.node(term.core) else { return None };
        let Node::Coordinate(element) = self.node(base) else { return None };
        let Element { part: own, index, component } = element;
        let (bodies, component) = match component {
            None => (Bodies::Whole, index),
            Some(component) => match self.loops.index(index) {
                Index::Literal(_) => (Bodies::One(index), component),
                Index::Running(by) => (Bodies::Each(by), component),
                _ => return None,
            },
        };
        let (component, over) = match self.loops.index(component) {
            Index::Literal(number) => (Component::Literal(number), None),
            Index::Running(by) => {
                let Loop { from, to, .. } = self.loops.get(by);
                let all = self.loops.literal(from) == Some(0) && extents.last() == Some(&to);
                (all.then_some(Component::All)?, Some(by))
            }
            _ => return None,
        };
        let of_bodies = match bodies {
            Bodies::Each(by) => Some(by),
            Bodies::Whole | Bodies::One(_) => None,
        };
        let mut expected: Vec<LoopId> = of_bodies.into_iter().chain(over).collect();
        let mut loops = term.loops.clone();
        expected.sort();
        loops.sort();
        (own == part && loops == expected).then_some((bodies, component))
    }

    /// Whether bodies of two terms are surely others.
    fn are_apart(&self, a: Bodies, b: Bodies) -> bool {
        let range = |bodies| match bodies {
            Bodies::Whole => None,
            Bodies::One(index) => self.loops.literal(index).map(|index| (index, index + 1)),
            Bodies::Each(by) => {
                let Loop { from, to, .. } = self.loops.get(by);
                self.loops.literal(from).zip(self.loops.literal(to))
            }
        };
        range(a).zip(range(b)).is_some_and(|((from, to), (other_from, other_to))| to <= other_from || other_to <= from)
    }
}
