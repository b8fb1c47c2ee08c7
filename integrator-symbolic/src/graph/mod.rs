//! Expressions as a hash-consed arena: one node per distinct expression, children before parents.
//!
//! In: calls of the smart constructors. Out: ids. Always true:
//!
//! - The id of a child is smaller than that of its parent: evaluation is a forward loop and a gradient a backward loop.
//! - Equal expressions have equal ids, so a shared subexpression is one node.
//! - Only the constructors in [`algebra`] build nodes, so their local identities hold everywhere.
//! - The arena knows neither syntax nor spans.

mod access;
mod addend;
mod algebra;
mod antiderivative;
mod by_parameter;
mod compared;
mod condition;
mod cost;
mod decision_tree;
#[cfg(test)]
pub(crate) mod evaluate;
pub(crate) mod exact;
pub(crate) mod explicit;
pub(crate) mod external;
mod fold;
pub(crate) mod function;
mod in_the_way;
pub(crate) mod index;
pub(crate) mod kepler;
pub(crate) mod like_terms;
mod masked_sum;
mod own_loops;
mod piecewise;
mod polynomial;
mod product;
mod quadratic;
pub(crate) mod rename;
mod root_factors;
pub(crate) mod same_product;
mod separate;
pub(crate) mod series;
pub(crate) mod shift;
pub(crate) mod unroll;

pub(crate) use access::Access;
pub use cost::Tally;
use external::Arguments;
pub(crate) use fold::{Fold, FoldSlope};
use function::Function;
use index::{IndexId, LoopId, LoopSet, Loops};
use std::collections::{HashMap, HashSet};

/// A node of the arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct NodeId(u32);

impl NodeId {
    pub(crate) fn position(self) -> usize {
        self.0 as usize
    }
}

/// An expression of the user that depends on parameters (and indices of loops) alone; the model holds its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct ParameterId(pub(crate) u32);

/// An opaque method of the user: it has a value, and methods that give its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct ExternalId(pub(crate) u32);

/// One of the two parts of the Hamiltonian's arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Part {
    /// Positions, the arguments of `V`.
    Position,
    /// Momenta, the arguments of `T`.
    Momentum,
}

impl Part {
    /// The part that the gradient by this one moves.
    pub(crate) fn other(self) -> Self {
        match self {
            Part::Position => Part::Momentum,
            Part::Momentum => Part::Position,
        }
    }
}

/// The most components of a point whose loops are written out or whose coordinates are read together.
pub(crate) const MOST_COMPONENTS: u64 = 8;

/// One coordinate: which point (or number), and which of its components where coordinates are points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Element {
    pub(crate) part: Part,
    pub(crate) index: IndexId,
    pub(crate) component: Option<IndexId>,
}

impl Element {
    /// The coordinate of the other part with the same indices.
    pub(crate) fn partner(self) -> Self {
        Self { part: self.part.other(), ..self }
    }
}

/// What a node is. Children are ids, so a node is small and can be compared and hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// A number, by its bits.
    Constant(u64),
    /// An expression of parameters alone.
    Parameter(ParameterId),
    /// The entry of a table, which is a parameter and no child, in a row and a column, which are prepared numbers.
    Entry(NodeId, NodeId, NodeId),
    /// A coordinate.
    Coordinate(Element),
    /// The explicit time.
    Time,
    /// The middle of the step that a flow belongs to, at which conditions on the time are read.
    Middle,
    /// The duration of the flow that an update belongs to, with its sign.
    Step,
    /// An integer expression as a number.
    FromIndex(IndexId),
    Neg(NodeId),
    Add(NodeId, NodeId),
    Mul(NodeId, NodeId),
    /// Division as such: by a number, or what a negative power was lowered to.
    Div(NodeId, NodeId),
    /// A power with exponent `halves / 2`, neither 0 nor 1.
    Power(NodeId, i32),
    Unary(Function, NodeId),
    Binary(Function, NodeId, NodeId),
    /// A method of the user.
    External(ExternalId, Arguments),
    /// The sum of the body over the loop's index.
    Sum(LoopId, NodeId),
    /// The items of the loop joined otherwise than by adding them.
    Fold(Fold, LoopId, NodeId),
    /// A condition: how two numbers compare.
    Compare(Comparison, NodeId, NodeId),
    /// A condition: how two integers compare.
    CompareIndex(Comparison, IndexId, IndexId),
    /// A condition of parameters alone.
    Flag(ParameterId),
    /// A condition: both hold.
    And(NodeId, NodeId),
    /// A condition: one holds at least.
    Or(NodeId, NodeId),
    /// A condition: the other does not hold.
    Not(NodeId),
    /// The second where the first, a condition, holds, else the third. What is not taken is not computed.
    Select(NodeId, NodeId, NodeId),
}

/// How two numbers compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Comparison {
    Less,
    LessOrEqual,
    Equal,
}

impl Node {
    /// The children, in order.
    pub(crate) fn children(self) -> impl Iterator<Item = NodeId> {
        let children = match self {
            Node::Constant(_)
            | Node::Parameter(_)
            | Node::Coordinate(_)
            | Node::Time
            | Node::Middle
            | Node::Step
            | Node::FromIndex(_)
            | Node::CompareIndex(..)
            | Node::External(..)
            | Node::Flag(_) => [None; 3],
            Node::Neg(a)
            | Node::Power(a, _)
            | Node::Unary(_, a)
            | Node::Sum(_, a)
            | Node::Fold(_, _, a)
            | Node::Not(a) => [Some(a), None, None],
            Node::Add(a, b)
            | Node::Mul(a, b)
            | Node::Div(a, b)
            | Node::Binary(_, a, b)
            | Node::Entry(_, a, b)
            | Node::Compare(_, a, b)
            | Node::And(a, b)
            | Node::Or(a, b) => [Some(a), Some(b), None],
            Node::Select(condition, a, b) => [Some(condition), Some(a), Some(b)],
        };
        let arguments = match self {
            Node::External(_, arguments) => Some(arguments.iter()),
            _ => None,
        };
        children.into_iter().flatten().chain(arguments.into_iter().flatten())
    }

    /// The same with other children.
    pub(crate) fn map(self, of: impl Fn(NodeId) -> NodeId) -> Self {
        match self {
            Node::Constant(_)
            | Node::Parameter(_)
            | Node::Coordinate(_)
            | Node::Time
            | Node::Middle
            | Node::Step
            | Node::FromIndex(_)
            | Node::CompareIndex(..)
            | Node::Flag(_) => self,
            Node::Neg(a) => Node::Neg(of(a)),
            Node::Power(a, halves) => Node::Power(of(a), halves),
            Node::Unary(function, a) => Node::Unary(function, of(a)),
            Node::External(id, arguments) => Node::External(id, arguments.map(of)),
            Node::Sum(by, a) => Node::Sum(by, of(a)),
            Node::Fold(fold, by, a) => Node::Fold(fold, by, of(a)),
            Node::Not(a) => Node::Not(of(a)),
            Node::Add(a, b) => Node::Add(of(a), of(b)),
            Node::Mul(a, b) => Node::Mul(of(a), of(b)),
            Node::Div(a, b) => Node::Div(of(a), of(b)),
            Node::Binary(function, a, b) => Node::Binary(function, of(a), of(b)),
            Node::Entry(table, a, b) => Node::Entry(table, of(a), of(b)),
            Node::Compare(comparison, a, b) => Node::Compare(comparison, of(a), of(b)),
            Node::And(a, b) => Node::And(of(a), of(b)),
            Node::Or(a, b) => Node::Or(of(a), of(b)),
            Node::Select(condition, a, b) => Node::Select(of(condition), of(a), of(b)),
        }
    }

    /// Whether it is read of a state or of the clock.
    pub(crate) fn is_read(self) -> bool {
        matches!(self, Node::Coordinate(_) | Node::Time | Node::Middle | Node::Step)
    }

    /// Whether it holds or does not, rather than being a number.
    pub(crate) fn is_condition(self) -> bool {
        matches!(
            self,
            Node::Compare(..) | Node::CompareIndex(..) | Node::Flag(_) | Node::And(..) | Node::Or(..) | Node::Not(_)
        )
    }
}

/// A scope around a value: the body of a loop, or one side of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Scope {
    /// It is there in every iteration of a loop.
    Loop(LoopId),
    /// It is there where a condition holds (`true`) or where it does not.
    Branch(NodeId, bool),
}

impl Scope {
    /// The same for both branches of a condition.
    pub(crate) fn either_side(self) -> Self {
        match self {
            Scope::Loop(_) => self,
            Scope::Branch(condition, _) => Scope::Branch(condition, true),
        }
    }

    /// The condition of a branch.
    pub(crate) fn condition(&self) -> Option<NodeId> {
        match self {
            Scope::Loop(_) => None,
            Scope::Branch(condition, _) => Some(*condition),
        }
    }
}

/// What is known of a node beside its children, found when it is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Facts {
    /// The loops whose index it depends on.
    loops: LoopSet,
    /// The loops of the sums in it.
    summed: LoopSet,
    /// Whether it depends on parameters, numbers and loop indices alone.
    prepared: bool,
    /// Whether it depends on positions.
    positions: bool,
    /// Whether it depends on momenta.
    momenta: bool,
    /// Whether it and its derivatives are finite wherever its coordinates are, but for overflow.
    total: bool,
    /// Whether it is total even if its parameters are missing, or if an expression of parameters alone such as `1 / self.k` is
    /// not finite.
    total_of_any: bool,
    /// Whether it contains an exponential of a coordinate, so that it may overflow.
    grows: bool,
    /// Where it may be computed.
    access: Access,
    /// Where it may be computed where the sums in it have been.
    beside_sums: Access,
    /// The loops that all it reads depends on, but for what can be read anywhere.
    read_in: LoopSet,
    /// Whether it is a condition with a term that is only evaluated where another one holds, or does not.
    ordered: bool,
}

/// The arena.
#[derive(Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    facts: Vec<Facts>,
    ids: HashMap<Node, NodeId>,
    /// The methods that give the derivatives of a method of the user, by its id.
    externals: Vec<Vec<ExternalId>>,
    /// The parameters whose text says that they are not negative.
    never_negative: HashSet<ParameterId>,
    /// The parameters that are NaN if their list is too short; the function then reads no value computed from them.
    maybe_missing: HashSet<ParameterId>,
    /// Parameters that the runtime computes in every step.
    computed: HashSet<ParameterId>,
    /// Tables that are symmetric.
    symmetric: HashSet<ParameterId>,
    /// Integer expressions and loops.
    pub(crate) loops: Loops,
}

impl Graph {
    /// The node behind an id.
    pub(crate) fn node(&self, id: NodeId) -> Node {
        self.nodes[id.position()]
    }

    /// All nodes.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = Node> {
        self.nodes.iter().copied()
    }

    /// How many nodes there are.
    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The loops of the sums in a node.
    pub(crate) fn summed_in(&self, id: NodeId) -> LoopSet {
        self.facts[id.position()].summed
    }

    /// The loops whose index a node depends on.
    pub(crate) fn loops_of(&self, id: NodeId) -> LoopSet {
        self.facts[id.position()].loops
    }

    /// Whether a node depends on parameters, numbers and loop indices alone, so that it is computed once per run.
    pub(crate) fn is_prepared(&self, id: NodeId) -> bool {
        self.facts[id.position()].prepared
    }

    /// Whether a node and its derivatives are finite wherever its coordinates are, but for overflow: it is made of
    /// sums, products, whole powers and functions without poles or edges.
    pub(crate) fn is_total(&self, id: NodeId) -> bool {
        self.facts[id.position()].total
    }

    /// Whether a node contains an exponential of a coordinate, so that it may overflow.
    pub(crate) fn grows(&self, id: NodeId) -> bool {
        self.facts[id.position()].grows
    }

    /// Whether a condition has a term that is only evaluated where another one holds, or does not.
    pub(super) fn is_ordered(&self, condition: NodeId) -> bool {
        self.facts[condition.position()].ordered
    }

    /// Whether a node depends on coordinates of a part.
    pub(crate) fn reads(&self, id: NodeId, part: Part) -> bool {
        let facts = self.facts[id.position()];
        match part {
            Part::Position => facts.positions,
            Part::Momentum => facts.momenta,
        }
    }

    /// Whether a node can be computed outside of what is `left` around its use, and multiplied by zero where nothing
    /// entered that: it is there, it is total, and so is what it is made of that is prepared.
    pub(crate) fn is_harmless(&self, id: NodeId, left: &[Scope]) -> bool {
        self.facts[id.position()].total_of_any && !left.iter().any(|around| self.protects(*around, id))
    }

    /// The number that a node is, if it is one.
    pub(crate) fn as_constant(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// All nodes that `roots` are made of, children first.
    pub(crate) fn reachable(&self, roots: impl IntoIterator<Item = NodeId>) -> Vec<NodeId> {
        let mut seen = vec![false; self.len()];
        let mut open: Vec<NodeId> = roots.into_iter().collect();
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut seen[id.position()], true) {
                open.extend(self.node(id).children());
            }
        }
        (0..self.len() as u32).map(NodeId).filter(|id| seen[id.position()]).collect()
    }

    /// The id of `node`, new or known. Only the constructors call this.
    fn intern(&mut self, node: Node) -> NodeId {
        if let Some(id) = self.ids.get(&node) {
            return *id;
        }
        let id = NodeId(self.nodes.len() as u32);
        self.facts.push(self.facts_of(node));
        self.nodes.push(node);
        self.ids.insert(node, id);
        id
    }

    fn facts_of(&self, node: Node) -> Facts {
        let loops = match node {
            Node::Parameter(id) | Node::Flag(id) => self.loops.of_parameter(id),
            Node::CompareIndex(_, a, b) => self.loops.of_index(a).union(self.loops.of_index(b)),
            Node::FromIndex(index) => self.loops.of_index(index),
            Node::Sum(by, _) | Node::Fold(_, by, _) => self.loops.of_range(by),
            Node::Coordinate(element) => self.loops.of_element(element),
            _ => LoopSet::EMPTY,
        };
        let part = match node {
            Node::Coordinate(element) => Some(element.part),
            _ => None,
        };
        let mut facts = Facts {
            loops,
            summed: match node {
                Node::Sum(by, _) | Node::Fold(_, by, _) => LoopSet::of(by),
                _ => LoopSet::EMPTY,
            },
            prepared: !node.is_read()
                && !matches!(node, Node::Parameter(parameter) if self.computed.contains(&parameter)),
            positions: part == Some(Part::Position),
            momenta: part == Some(Part::Momentum),
            total: self.is_total_by_itself(node),
            total_of_any: self.is_total_by_itself(node) && !self.may_be_missing(node),
            grows: matches!(node, Node::Unary(function, _) if function.row().overflows),
            access: self.own_access(node),
            beside_sums: self.own_access(node),
            read_in: self.read_in(node, loops),
            ordered: match node {
                Node::And(first, second) | Node::Or(first, second) => {
                    self.protects(Scope::Branch(first, true), second)
                        || [first, second].iter().any(|id| self.is_ordered(*id))
                }
                Node::Not(inner) => self.is_ordered(inner),
                _ => false,
            },
        };
        for child in node.children() {
            let child = self.facts[child.position()];
            facts.loops = facts.loops.union(match node {
                Node::Sum(by, _) | Node::Fold(_, by, _) => child.loops.without(by),
                _ => child.loops,
            });
            facts.summed = facts.summed.union(child.summed);
            facts.prepared &= child.prepared;
            facts.positions |= child.positions;
            facts.momenta |= child.momenta;
            facts.total &= child.total;
            facts.total_of_any &= child.total_of_any;
            facts.grows |= child.grows;
            facts.access = facts.access.max(child.access);
            if !matches!(node, Node::Sum(..) | Node::Fold(..)) {
                facts.beside_sums = facts.beside_sums.max(child.beside_sums);
            }
        }
        // Without loops around it, a sum over coordinates reads only coordinates that its own loops reach.
        let is_sum = matches!(node, Node::Sum(..) | Node::Fold(..)) && facts.loops.is_empty();
        if is_sum && facts.access == Access::ByRunning && facts.summed.iter().all(|by| self.loops.ends_within(by)) {
            facts.access = Access::Anywhere;
        }
        // A prepared constant is known to be finite, and a condition is no factor of anything.
        let is_constant = facts.prepared && facts.loops.iter().count() <= 1;
        facts.total |= is_constant || node.is_condition();
        facts.total_of_any |= node.is_condition();
        facts.grows &= !facts.prepared;
        facts
    }

    /// Whether a node is an element that a list may not have.
    fn may_be_missing(&self, node: Node) -> bool {
        match node {
            Node::Parameter(id) => self.maybe_missing.contains(&id),
            Node::Entry(table, ..) => self.may_be_missing(self.node(table)),
            _ => false,
        }
    }

    /// Whether a node is total where its children are.
    fn is_total_by_itself(&self, node: Node) -> bool {
        match node {
            Node::Power(_, halves) => halves > 0 && halves % 2 == 0,
            Node::Div(_, divisor) => self.as_constant(divisor).is_some_and(|divisor| divisor != 0.0),
            Node::Unary(function, _) | Node::Binary(function, ..) => function.row().total,
            // Without items the largest one is infinite, and a derivative divides by items.
            Node::External(..) | Node::Fold(..) => false,
            _ => true,
        }
    }
}
