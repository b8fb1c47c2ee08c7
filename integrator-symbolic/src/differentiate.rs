//! Gradients by a reverse sweep over the arena.
//!
//! In: a root and the part to differentiate by. Out: contributions to the components of the gradient, each with its
//! loops and conditions. Always true: the gradient is the sum of all contributions, over all iterations in which their
//! conditions hold; sums are never unrolled; zeros have no contribution; a branch that is not taken contributes
//! nothing.
//!
//! Inside a sum, the adjoint of a node has one value per iteration of the enclosing loops. If such a value reaches a
//! node that is independent of the innermost loop, it is summed over that loop first. The sweep hence leaves a loop as
//! soon as possible.
//!
//! The sweep never leaves a condition: the contribution of a branch is computed in the branch. A loop may have no
//! iteration in its branches. After such a loop, values are computed under the condition that it had one, unless no
//! value can do harm.

mod limits;
mod quotient;

use crate::graph::{
    Element, FoldSlope, Graph, Node, NodeId, Part, Scope,
    function::{Function, LEAST},
    index::LoopId,
    like_terms::with_like_terms_collected,
};
use limits::Limits;
use std::collections::HashMap;

/// An addend of one component of a gradient (of a family of them, where the component depends on loops).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contribution {
    /// The loops and conditions around it, outermost first.
    pub(crate) context: Vec<Scope>,
    /// The coordinate that the component belongs to.
    pub(crate) element: Element,
    pub(crate) value: NodeId,
}

impl Contribution {
    /// The loops around it, outermost first.
    pub(crate) fn loops(&self) -> impl Iterator<Item = LoopId> {
        self.context.iter().filter_map(|around| match around {
            Scope::Loop(by) => Some(*by),
            Scope::Branch(..) => None,
        })
    }

    /// The conditions around it, outermost first.
    pub(crate) fn conditions(&self) -> impl Iterator<Item = NodeId> {
        self.context.iter().filter_map(Scope::condition)
    }

    /// Its value and the conditions around it.
    pub(crate) fn values(&self) -> impl Iterator<Item = NodeId> {
        self.conditions().chain([self.value])
    }

    /// The same with other nodes for its value and for the conditions.
    pub(crate) fn mapped(&self, of: impl Fn(NodeId) -> NodeId) -> Self {
        Self { value: of(self.value), context: self.around(of), ..*self }
    }

    /// The loops and conditions around it, with other nodes for the conditions.
    pub(crate) fn around(&self, of: impl Fn(NodeId) -> NodeId) -> Vec<Scope> {
        let renamed = self.context.iter().map(|around| match around {
            Scope::Branch(condition, holds) => Scope::Branch(of(*condition), *holds),
            Scope::Loop(_) => *around,
        });
        renamed.collect()
    }
}

/// The gradient of `root` by the coordinates of `part`, in the order of their ids.
pub(crate) fn gradient(graph: &mut Graph, root: NodeId, part: Part) -> Vec<Contribution> {
    let mut sweep = Sweep {
        depends: dependence(graph, root, part),
        adjoints: vec![Vec::new(); root.position() + 1],
        limits: vec![None; root.position() + 1],
        present: Limits::default(),
    };
    let one = graph.constant(1.0);
    sweep.push(graph, root, &[], one);
    let mut contributions = Vec::new();
    for id in graph.reachable([root]).into_iter().rev() {
        sweep.enter(graph, id);
        let adjoints = std::mem::take(&mut sweep.adjoints[id.position()]);
        for (context, adjoint) in merge_adjoints(graph, id, adjoints) {
            match graph.node(id) {
                Node::Coordinate(element) => contributions.push(Contribution { context, element, value: adjoint }),
                node => sweep.propagate(graph, id, node, &context, adjoint),
            }
        }
    }
    contributions.reverse();
    in_few_operations(graph, contributions)
}

/// The same contributions, with their like terms collected if that leaves fewer operations.
fn in_few_operations(graph: &mut Graph, as_written: Vec<Contribution>) -> Vec<Contribution> {
    let values: Vec<NodeId> = as_written.iter().map(|contribution| contribution.value).collect();
    let known = with_like_terms_collected(graph, &values);
    let mut collected = as_written.clone();
    for contribution in &mut collected {
        contribution.value = known[&contribution.value];
    }
    let operations =
        |contributions: &[Contribution]| graph.operations(contributions.iter().flat_map(Contribution::values));
    if operations(&collected) < operations(&as_written) { collected } else { as_written }
}

/// The derivative of a gradient by the coordinates of `part` along the coordinates of the other part: the Hessian times
/// these, as the gradient of their product with the gradient.
pub(crate) fn hessian_product(graph: &mut Graph, of: &[Contribution], part: Part) -> Vec<Contribution> {
    let mut along = graph.constant(0.0);
    for Contribution { context, element, value } in of {
        let direction = graph.coordinate(element.partner());
        let product = graph.mul(*value, direction);
        let product = context.iter().rev().fold(product, |product, around| select_in_branch(graph, *around, product));
        along = graph.add(along, product);
    }
    gradient(graph, along, part)
}

/// The same gradient with branches folded into selects: one contribution per element and loops, where nothing else
/// distinguishes them.
pub(crate) fn fold_branches(graph: &mut Graph, gradient: &[Contribution]) -> Vec<Contribution> {
    let mut places: HashMap<(Element, &[Scope]), usize> = HashMap::new();
    let mut families: Vec<(&Contribution, usize, Vec<Inside<'_>>)> = Vec::new();
    for contribution in gradient {
        let Contribution { context, element, value } = contribution;
        let outer = end_of_loops(context);
        let place = *places.entry((*element, &context[..outer])).or_insert(families.len());
        if place == families.len() {
            families.push((contribution, outer, Vec::new()));
        }
        families[place].2.push((&context[outer..], *value));
    }
    let folded = families.into_iter().map(|(Contribution { context, element, .. }, outer, values)| Contribution {
        context: context[..outer].to_vec(),
        element: *element,
        value: sum_of_branches(graph, &values),
    });
    folded.collect()
}

/// The length of a context up to its last loop.
fn end_of_loops(context: &[Scope]) -> usize {
    context.iter().rposition(|around| matches!(around, Scope::Loop(_))).map_or(0, |last| last + 1)
}

/// A side of a distance: a length, or the square of one.
enum Side {
    Length(NodeId),
    Square(NodeId),
}

/// The most sides of a distance, so that what is written of distances within distances is in proportion to them.
const MOST_SIDES: usize = 8;

/// The sides of a distance by `hypot`, those of distances in it included, or of a root. A distance in another one has no slope where
/// it is zero, and the whole has: its slope by a side is the side over the whole.
fn distance(graph: &Graph, id: NodeId) -> Option<Vec<Side>> {
    let (mut sides, mut open) = (Vec::new(), vec![id]);
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Binary(function, a, b) if function.is_distance() => open.extend([b, a]),
            Node::Power(square, 1) => sides.push(Side::Square(square)),
            _ => sides.push(Side::Length(id)),
        }
        if sides.len() + open.len() > MOST_SIDES {
            return None;
        }
    }
    let is_plain = matches!(sides[..], [Side::Length(of)] if of == id);
    (!is_plain).then_some(sides)
}

/// A value inside of branches.
type Inside<'a> = (&'a [Scope], NodeId);

/// A group of values: one without branches, or all values inside of the branches of one condition.
enum Group<'a> {
    Value(NodeId),
    /// A condition, with the values where it holds and where it does not.
    Branch(NodeId, [Vec<Inside<'a>>; 2]),
}

fn group_by_branch<'a>(values: &[Inside<'a>]) -> Vec<Group<'a>> {
    let mut places: HashMap<NodeId, usize> = HashMap::new();
    let mut slots = Vec::new();
    for (context, value) in values {
        let Some((Scope::Branch(condition, holds), inner)) = context.split_first() else {
            slots.push(Group::Value(*value));
            continue;
        };
        let place = *places.entry(*condition).or_insert(slots.len());
        if place == slots.len() {
            slots.push(Group::Branch(*condition, [Vec::new(), Vec::new()]));
        }
        if let Group::Branch(_, sides) = &mut slots[place] {
            sides[usize::from(!holds)].push((inner, *value));
        }
    }
    slots
}

/// The sum of values that are zero where their branches are not taken: one select for each condition.
fn sum_of_branches(graph: &mut Graph, values: &[Inside<'_>]) -> NodeId {
    let zero = graph.constant(0.0);
    group_by_branch(values).into_iter().fold(zero, |sum, slot| {
        let value = match slot {
            Group::Value(value) => value,
            Group::Branch(condition, sides) => {
                let [first, second] = sides.map(|side| sum_of_branches(graph, &side));
                graph.select(condition, first, second)
            }
        };
        add_or_select(graph, sum, value)
    })
}

/// The condition that the branches around one of the values are taken.
fn is_any_taken(graph: &mut Graph, values: &[Inside<'_>]) -> NodeId {
    if values.iter().any(|(context, _)| context.is_empty()) {
        return graph.truth(true);
    }
    let never = graph.truth(false);
    group_by_branch(values).into_iter().fold(never, |any, slot| {
        let Group::Branch(condition, sides) = slot else { return any };
        let [first, second] = sides.map(|side| is_any_taken(graph, &side));
        let one = match [first, second].map(|side| graph.as_truth(side)) {
            [Some(true), None] => graph.or(condition, second),
            [None, Some(true)] => {
                let otherwise = graph.not(condition);
                graph.or(otherwise, first)
            }
            _ => graph.select(condition, first, second),
        };
        graph.or(any, one)
    })
}

/// A value where a branch is taken, zero elsewhere.
pub(crate) fn select_in_branch(graph: &mut Graph, around: Scope, value: NodeId) -> NodeId {
    let zero = graph.constant(0.0);
    match around {
        Scope::Branch(condition, true) => graph.select(condition, value, zero),
        Scope::Branch(condition, false) => graph.select(condition, zero, value),
        Scope::Loop(by) => graph.sum(by, value),
    }
}

/// The sum of two values; of the two branches of one condition, the select between them.
fn add_or_select(graph: &mut Graph, first: NodeId, second: NodeId) -> NodeId {
    if let (Node::Select(c, a, b), Node::Select(d, x, y)) = (graph.node(first), graph.node(second))
        && c == d
    {
        let (a, b) = (graph.add(a, x), graph.add(b, y));
        return graph.select(c, a, b);
    }
    graph.add(first, second)
}

/// For each node, whether it depends on the coordinates of `part`.
fn dependence(graph: &Graph, root: NodeId, part: Part) -> Vec<bool> {
    let mut depends = vec![false; root.position() + 1];
    for id in graph.reachable([root]) {
        depends[id.position()] = graph.reads(id, part);
    }
    depends
}

/// The largest number of contexts of the adjoints of a node; more are merged into one. Where each branch reads the
/// result of the last one, the number would double each time.
const CONTEXTS: usize = 2;

/// Merges the adjoints of a node in the same loops into one context where they are many. Their common context stays
/// around them; the rest is selected, and the node's own slopes are computed where one of them is.
fn merge_adjoints(graph: &mut Graph, id: NodeId, adjoints: Vec<Adjoint>) -> Vec<Adjoint> {
    if adjoints.len() <= CONTEXTS || matches!(graph.node(id), Node::Coordinate(_)) {
        return adjoints;
    }
    let mut groups: Vec<Vec<Adjoint>> = Vec::new();
    for (context, adjoint) in adjoints {
        let own = |group: &&mut Vec<Adjoint>| {
            let known = &group[0].0;
            known[..end_of_loops(known)] == context[..end_of_loops(&context)]
        };
        match groups.iter_mut().find(own) {
            Some(group) => group.push((context, adjoint)),
            None => groups.push(vec![(context, adjoint)]),
        }
    }
    groups.into_iter().map(|group| in_one_context(graph, id, &group)).collect()
}

/// The adjoint in the common context of some adjoints.
fn in_one_context(graph: &mut Graph, id: NodeId, adjoints: &[Adjoint]) -> Adjoint {
    let first = &adjoints[0].0;
    let shared =
        |known: usize, context: &[Scope]| first[..known].iter().zip(context).take_while(|(a, b)| a == b).count();
    let common = adjoints.iter().fold(first.len(), |known, (context, _)| shared(known, context));
    let values: Vec<Inside<'_>> = adjoints.iter().map(|(context, adjoint)| (&context[common..], *adjoint)).collect();
    let (sum, any) = (sum_of_branches(graph, &values), is_any_taken(graph, &values));
    let mut context = first[..common].to_vec();
    let is_harmless = adjoints.iter().all(|(left, _)| graph.is_harmless(id, &left[common..]));
    if !is_harmless {
        context.extend(branches(graph, any));
    }
    (context, sum)
}

/// An adjoint: the context around it, and its value.
type Adjoint = (Vec<Scope>, NodeId);

/// A sweep over the nodes, the root first.
struct Sweep {
    depends: Vec<bool>,
    /// The adjoints of a node so far, one per context that it is used in.
    adjoints: Vec<Vec<Adjoint>>,
    /// The limits of the adjoints of each node.
    limits: Vec<Option<Limits>>,
    /// Those of the node whose adjoint is propagated.
    present: Limits,
}

impl Sweep {
    /// Passes the limits of the adjoint of a node on to its children, which are propagated after it.
    fn enter(&mut self, graph: &Graph, id: NodeId) {
        self.present = self.limits[id.position()].unwrap_or_default();
        let node = graph.node(id);
        if node.is_condition() {
            return;
        }
        let below = self.present.below(graph, id);
        for child in node.children() {
            let limits = &mut self.limits[child.position()];
            *limits = Some(limits.map_or(below, |known| known.with(below)));
        }
    }

    /// Propagates the adjoint of `node` to its children.
    fn propagate(&mut self, graph: &mut Graph, id: NodeId, node: Node, context: &[Scope], adjoint: NodeId) {
        match node {
            Node::Neg(a) => {
                let value = graph.neg(adjoint);
                self.push(graph, a, context, value);
            }
            Node::Add(a, b) => {
                self.push(graph, a, context, adjoint);
                self.push(graph, b, context, adjoint);
            }
            Node::Mul(a, b) => {
                self.push_product(graph, a, context, adjoint, b);
                self.push_product(graph, b, context, adjoint, a);
            }
            Node::Div(a, b) if self.depends[a.position()] => {
                let value = graph.div(adjoint, b);
                self.push(graph, a, context, value);
            }
            Node::Power(a, halves) if self.depends[a.position()] => {
                // d(x^e) = e x^(e-1)
                let lowered = graph.power(a, halves - 2);
                let exponent = graph.constant(f64::from(halves) / 2.0);
                let slope = graph.mul(exponent, lowered);
                self.push_product(graph, a, context, adjoint, slope);
            }
            Node::Unary(function, a) if self.depends[a.position()] => {
                let Some(slope) = graph.slope(function, a, id) else { return };
                if function.row().of_square
                    && let Some(distance) = distance(graph, a)
                {
                    // Both are zero where the distance is, and the quotient is one.
                    let least = graph.constant(LEAST);
                    let (negative, size) = graph.signed(slope);
                    let (size, divisor) = (graph.add(size, least), graph.call_two("max", a, least));
                    let quotient = graph.div(size, divisor);
                    let quotient = if negative { graph.neg(quotient) } else { quotient };
                    self.push_distance(graph, &distance, context, adjoint, quotient);
                } else {
                    self.push_product(graph, a, context, adjoint, slope);
                }
            }
            // The quotient whose divisor is bounded has no slope beyond the bound, by its limits.
            Node::Binary(_, a, bound) | Node::Binary(_, bound, a) if graph.is_huge(bound) => {
                self.push(graph, a, context, adjoint);
            }
            Node::Binary(function, a, b) => {
                if let Some(first) = self.choice(graph, function, [a, b], adjoint) {
                    self.push_chosen(graph, [a, b], first, context, adjoint);
                } else if function.is_distance()
                    && let Some(distance) = distance(graph, id)
                {
                    let reciprocal = graph.power(id, -2);
                    self.push_distance(graph, &distance, context, adjoint, reciprocal);
                } else {
                    let slopes = graph.slopes(function, a, b, id);
                    for (child, slope) in [a, b].into_iter().zip(slopes) {
                        if let Some(slope) = slope {
                            self.push_product(graph, child, context, adjoint, slope);
                        }
                    }
                }
            }
            Node::External(external, arguments) => {
                for (place, child) in arguments.iter().enumerate() {
                    if let Some(slope) = graph.external_slope(external, place) {
                        let slope = graph.external(slope, arguments);
                        self.push_product(graph, child, context, adjoint, slope);
                    }
                }
            }
            Node::Sum(by, body) => {
                let inside: Vec<Scope> = context.iter().copied().chain([Scope::Loop(by)]).collect();
                self.push(graph, body, &inside, adjoint);
            }
            Node::Fold(fold, by, body) if self.depends[body.position()] => {
                let FoldSlope { condition, value } = graph.fold_slope(fold, by, body, id);
                let scopes = [Some(Scope::Loop(by)), condition.map(|condition| Scope::Branch(condition, true))];
                let inside: Vec<Scope> = context.iter().copied().chain(scopes.into_iter().flatten()).collect();
                self.push_product(graph, body, &inside, adjoint, value);
            }
            Node::Select(condition, a, b) => self.push_chosen(graph, [a, b], condition, context, adjoint),
            // Leaves and conditions pass nothing on; neither does what does not depend on the part.
            _ => {}
        }
    }

    /// Passes on the adjoint of a distance, times what its slopes have in common: that by a length `x` is `x` times it.
    fn push_distance(
        &mut self,
        graph: &mut Graph,
        distance: &[Side],
        context: &[Scope],
        adjoint: NodeId,
        common: NodeId,
    ) {
        for side in distance {
            let (child, slope) = match *side {
                Side::Length(x) => (x, graph.mul(common, x)),
                Side::Square(square) => {
                    let half = graph.constant(0.5);
                    (square, graph.mul(half, common))
                }
            };
            if self.depends[child.position()] {
                self.push_product(graph, child, context, adjoint, slope);
            }
        }
    }

    /// The condition that a function's value is its first argument, if it is one of the two and the slope zero of the
    /// other might meet what is not finite.
    fn choice(&self, graph: &mut Graph, function: Function, arguments: [NodeId; 2], adjoint: NodeId) -> Option<NodeId> {
        let [a, b] = arguments;
        let harmless = [a, b, adjoint].into_iter().all(|id| graph.is_total(id));
        let chooses = function.row().chooses.filter(|_| !harmless)?;
        Some(chooses(graph, a, b))
    }

    /// Passes an adjoint on to the first of two nodes where a condition holds, to the second where it does not.
    fn push_chosen(
        &mut self,
        graph: &mut Graph,
        nodes: [NodeId; 2],
        condition: NodeId,
        context: &[Scope],
        adjoint: NodeId,
    ) {
        for (node, holds) in nodes.into_iter().zip([true, false]) {
            let branch = Scope::Branch(condition, holds);
            if context.contains(&Scope::Branch(condition, !holds)) {
                continue;
            }
            if context.contains(&branch) {
                self.push(graph, node, context, adjoint);
                continue;
            }
            let inside: Vec<Scope> = context.iter().copied().chain([branch]).collect();
            self.push(graph, node, &inside, adjoint);
        }
    }

    fn push_product(&mut self, graph: &mut Graph, to: NodeId, context: &[Scope], adjoint: NodeId, slope: NodeId) {
        if self.depends[to.position()] {
            let value = self.present.product(graph, adjoint, slope);
            self.push(graph, to, context, value);
        }
    }

    /// Adds `value`, one per iteration of the loops in `context`, to the adjoint of `to`.
    fn push(&mut self, graph: &mut Graph, to: NodeId, context: &[Scope], value: NodeId) {
        if !self.depends[to.position()] {
            return;
        }
        let (outer, left) = context.split_at(common_depth(graph, to, context));
        let value = left.iter().rev().fold(value, |value, around| select_in_branch(graph, *around, value));
        let more = guards(graph, to, left).into_iter().filter(|around| !outer.contains(around));
        let outer: Vec<Scope> = outer.iter().copied().chain(more).collect();
        let adjoints = &mut self.adjoints[to.position()];
        match adjoints.iter_mut().find(|(known, _)| *known == outer) {
            Some((_, sum)) => {
                *sum = match quotient::complement(graph, *sum, value) {
                    Some(sum) => sum,
                    None => graph.add(*sum, value),
                }
            }
            None => adjoints.push((outer, value)),
        }
    }
}

/// The conditions around the adjoint of a node that replace the loops and branches that were `left`: where nothing
/// entered them, the adjoint is an empty sum, and a slope that is not finite there must not be multiplied by it.
fn guards(graph: &mut Graph, id: NodeId, left: &[Scope]) -> Vec<Scope> {
    if left.is_empty() || graph.is_harmless(id, left) {
        return Vec::new();
    }
    let entered = graph.happens(left, id);
    branches(graph, entered)
}

/// A condition as branches, one inside the other where one of its terms is only evaluated where another one holds.
fn branches(graph: &mut Graph, condition: NodeId) -> Vec<Scope> {
    match graph.node(condition) {
        _ if graph.as_truth(condition).is_some() => Vec::new(),
        Node::And(first, second) if graph.protects(Scope::Branch(first, true), second) => {
            [first, second].into_iter().flat_map(|part| branches(graph, part)).collect()
        }
        _ => vec![Scope::Branch(graph.in_order(condition), true)],
    }
}

/// The length of the `context` that stays around the adjoint of a node: up to the first loop after all those it
/// depends on.
fn common_depth(graph: &Graph, id: NodeId, context: &[Scope]) -> usize {
    let own = graph.loops_of(id);
    let is_own = |around: &Scope| matches!(around, Scope::Loop(by) if own.contains(*by));
    let deepest = context.iter().rposition(is_own).map_or(0, |deepest| deepest + 1);
    let next = context[deepest..].iter().position(|around| matches!(around, Scope::Loop(_)));
    next.map_or(context.len(), |next| deepest + next)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{
        Comparison,
        evaluate::Point,
        index::{Index, Loop},
    };

    fn position(graph: &mut Graph, index: Index) -> NodeId {
        let index = graph.loops.intern(index);
        graph.coordinate(Element { part: Part::Position, index, component: None })
    }

    fn range(graph: &mut Graph, parent: Option<LoopId>, from: Index, to: Index) -> LoopId {
        let (from, to) = (graph.loops.intern(from), graph.loops.intern(to));
        graph.loops.range(Loop { parent, from, to })
    }

    /// The iterations of the loops of `context` in which its conditions hold.
    fn around(graph: &Graph, point: &mut Point<'_>, context: &[Scope], body: &mut dyn FnMut(&mut Point<'_>)) {
        match context.split_first() {
            None => body(point),
            Some((Scope::Loop(by), inner)) => {
                point.iterations(graph, &[*by], &mut |point| around(graph, point, inner, body));
            }
            Some((Scope::Branch(condition, holds), inner)) => {
                if point.holds(graph, *condition) == *holds {
                    around(graph, point, inner, body);
                }
            }
        }
    }

    /// The gradient by its contributions.
    fn by_sweep(graph: &mut Graph, root: NodeId, q: &[f64]) -> Vec<f64> {
        let mut gradient_at = vec![0.0; q.len()];
        for Contribution { context, element, value } in gradient(graph, root, Part::Position) {
            around(graph, &mut Point::new(q, &[]), &context, &mut |point| {
                gradient_at[point.index(graph, element.index) as usize] += point.value(graph, value);
            });
        }
        gradient_at
    }

    /// The gradient by central differences; with h = 1e-5 good to 1e-10 times a third derivative, plus eps/h = 2e-11.
    fn by_differences(graph: &Graph, root: NodeId, q: &[f64]) -> Vec<f64> {
        let at = |i: usize, shift: f64| {
            let mut q = q.to_vec();
            q[i] += shift;
            Point::new(&q, &[]).value(graph, root)
        };
        (0..q.len()).map(|i| (at(i, 1e-5) - at(i, -1e-5)) / 2e-5).collect()
    }

    fn check(graph: &mut Graph, root: NodeId, q: &[f64]) {
        let (sweep, differences) = (by_sweep(graph, root, q), by_differences(graph, root, q));
        for (a, b) in sweep.iter().zip(&differences) {
            assert!((a - b).abs() < 1e-7 * (1.0 + b.abs()), "{sweep:?} for {differences:?}");
        }
        assert!(sweep.iter().any(|component| component.abs() > 1e-3), "a gradient to speak of: {sweep:?}");
    }

    const Q: [f64; 5] = [0.3, -1.1, 0.7, 2.2, -0.4];

    #[test]
    fn a_chain_of_neighbours() {
        let mut graph = Graph::default();
        let by = range(&mut graph, None, Index::Literal(0), Index::Literal(4));
        let i = graph.loops.intern(Index::Running(by));
        let one = graph.loops.intern(Index::Literal(1));
        let (left, right) = (position(&mut graph, Index::Running(by)), position(&mut graph, Index::Add(i, one)));
        let bond = graph.sub(right, left);
        let energy = graph.call("cosh", bond);
        let root = graph.sum(by, energy);
        check(&mut graph, root, &Q);
    }

    #[test]
    fn pairs_in_a_triangular_loop_where_a_factor_depends_on_the_inner_index_alone() {
        let mut graph = Graph::default();
        let outer = range(&mut graph, None, Index::Literal(0), Index::Literal(5));
        let inner = range(&mut graph, Some(outer), Index::Literal(0), Index::Running(outer));
        let (a, b) = (position(&mut graph, Index::Running(outer)), position(&mut graph, Index::Running(inner)));
        let (sine, cosine) = (graph.call("sin", a), graph.call("cos", b));
        let pair = graph.mul(sine, cosine);
        let pairs = graph.sum(inner, pair);
        let root = graph.sum(outer, pairs);
        check(&mut graph, root, &Q);
        let contexts = gradient(&mut graph, root, Part::Position);
        let depth = |element: NodeId| {
            let of = contexts.iter().find(|contribution| graph.node(element) == Node::Coordinate(contribution.element));
            of.map(|contribution| contribution.context.len())
        };
        assert_eq!(depth(a), Some(1), "what the outer index alone decides is summed before it leaves the inner loop");
        assert_eq!(depth(b), Some(2));
    }

    #[test]
    fn a_sum_inside_another_sum_and_a_square_of_a_sum() {
        let mut graph = Graph::default();
        let first = range(&mut graph, None, Index::Literal(0), Index::Literal(5));
        let q = position(&mut graph, Index::Running(first));
        let total = graph.sum(first, q);
        let away = graph.sub(q, total);
        let square = graph.power(away, 4);
        let spread = graph.sum(first, square);
        let whole = graph.mul(spread, total);
        check(&mut graph, whole, &Q);
    }

    #[test]
    fn terms_independent_of_the_part_contribute_nothing() {
        let mut graph = Graph::default();
        let index = graph.loops.intern(Index::Literal(0));
        let p = graph.coordinate(Element { part: Part::Momentum, index, component: None });
        let root = graph.call("sin", p);
        assert!(gradient(&mut graph, root, Part::Position).is_empty());
    }

    #[test]
    fn a_loop_over_a_term_independent_of_it_is_a_factor() {
        let mut graph = Graph::default();
        let by = range(&mut graph, None, Index::Literal(0), Index::Literal(7));
        let q = position(&mut graph, Index::Literal(2));
        let root = graph.sum(by, q);
        assert_eq!(by_sweep(&mut graph, root, &Q), [0.0, 0.0, 7.0, 0.0, 0.0]);
    }

    /// A bond that breaks beyond a length: `if |d| < 1.2 { d^3 } else { d }` with d the distance of neighbours.
    fn breaking_bonds(graph: &mut Graph) -> NodeId {
        let by = range(graph, None, Index::Literal(0), Index::Literal(4));
        let i = graph.loops.intern(Index::Running(by));
        let one = graph.loops.intern(Index::Literal(1));
        let (left, right) = (position(graph, Index::Running(by)), position(graph, Index::Add(i, one)));
        let bond = graph.sub(right, left);
        let (length, limit) = (graph.call("abs", bond), graph.constant(1.2));
        let near = graph.compare(Comparison::Less, length, limit);
        let cube = graph.power(bond, 6);
        let energy = graph.select(near, cube, bond);
        graph.sum(by, energy)
    }

    #[test]
    fn the_branch_that_is_taken_is_differentiated() {
        let mut graph = Graph::default();
        let root = breaking_bonds(&mut graph);
        check(&mut graph, root, &Q);
    }

    #[test]
    fn folded_branches_are_the_same_gradient() {
        let mut graph = Graph::default();
        let root = breaking_bonds(&mut graph);
        let whole = gradient(&mut graph, root, Part::Position);
        let folded = fold_branches(&mut graph, &whole);
        assert!(folded.len() < whole.len());
        let sum = |graph: &Graph, contributions: &[Contribution]| {
            let mut at = vec![0.0; Q.len()];
            for Contribution { context, element, value } in contributions {
                around(graph, &mut Point::new(&Q, &[]), context, &mut |point| {
                    at[point.index(graph, element.index) as usize] += point.value(graph, *value);
                });
            }
            at
        };
        assert_eq!(sum(&graph, &whole), sum(&graph, &folded));
    }
}
