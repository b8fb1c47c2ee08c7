//! Scheduling: nodes and the destinations of their values become nested blocks.
//!
//! In: lowered nodes, each with its destination. Out: a block of lets, loops, branches and destinations, in order.
//! Always true:
//!
//! - A node is computed outside of every loop on which it does not depend.
//! - A node that only one branch needs is computed inside of it. A sum is computed outside of a branch on the condition
//!   that its loop has iterations.
//! - A value that may not exist is read inside of the condition that it exists.
//! - Loops over the same range that do not depend on each other are merged; so are branches on the same condition.
//! - A node has a name if it is used twice, or in an inner block.

mod hoist;
pub(crate) mod lanes;
pub(crate) mod lists;
pub(crate) mod nest;
mod order;
pub(crate) mod phases;
mod place;
pub(crate) mod results;
mod store;
pub(crate) mod tally;
mod unwritten;

pub(crate) use store::{is_direct, is_protected};

use crate::graph::{
    Element, Graph, Node, NodeId, Scope,
    index::{LoopId, LoopSet},
};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// The destination of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sink {
    /// It is added to a coordinate.
    Update(Element),
    /// It is added to the gradient's component for a coordinate, in a buffer.
    Collect(Element),
    /// It is a contribution to a site, by its number among them.
    Contribution(usize),
    /// It is the gradient's component for a coordinate, to which nothing else is added.
    Assign(Element),
    /// It is added to the derivative of a quadratic form by a coordinate at zero.
    FirstDerivative(Element),
    /// It is added to the derivative of a quadratic form by two coordinates.
    SecondDerivative(Element, Element),
    /// It is the derivative of an energy with respect to a parameter, by its number.
    Slope(usize),
    /// It is what the function returns.
    Return,
    /// It is shown to what watches the edges of the formula.
    Watch(Watched),
}

/// What a value contributes to an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Watched {
    /// It is a comparison, which is shown where it is computed.
    Side,
    /// It is the argument of the function of this name, which returns whole numbers.
    Level(&'static str),
    /// It is the radicand of a root.
    Root,
}

/// A store: a value, its destination, and the scopes around it, outermost first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Store {
    pub(crate) context: Vec<Scope>,
    pub(crate) sink: Sink,
    pub(crate) value: NodeId,
}

/// A statement of a block.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    /// A named value.
    Let(NodeId),
    /// Sine and cosine of one argument, both named.
    SineCosine { argument: NodeId, sine: NodeId, cosine: NodeId },
    /// A sum that is about to be accumulated, or a choice that is about to be made.
    Begin(NodeId),
    /// A loop.
    Loop { by: LoopId, body: Vec<Item> },
    /// What happens where a condition holds, or where it does not.
    Branch { condition: NodeId, holds: bool, body: Vec<Item> },
    /// An iteration adds to a sum.
    Add { sum: NodeId, value: NodeId },
    /// A choice is made.
    Choose { choice: NodeId, value: NodeId },
    /// A destination.
    Sink(Sink, NodeId),
}

impl Item {
    /// The values that it computes and gives names.
    pub(crate) fn named(&self) -> impl Iterator<Item = NodeId> {
        let named = match self {
            Item::Let(id) => [Some(*id), None],
            Item::SineCosine { sine, cosine, .. } => [Some(*sine), Some(*cosine)],
            _ => [None, None],
        };
        named.into_iter().flatten()
    }
}

/// The body of a function.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Program {
    pub(crate) items: Vec<Item>,
    /// The nodes that have a name.
    pub(crate) named: BTreeSet<NodeId>,
    /// Whether a line reads the explicit time.
    pub(crate) reads_time: bool,
    /// Whether a line divides by a root cubed in one operation.
    pub(crate) divides_by_root_cubed: bool,
    /// What conditions compare: each of its operations is rounded by itself, and none is fused with another.
    pub(crate) compared: HashSet<NodeId>,
}

impl Program {
    /// The lines within these loops, which the caller runs.
    pub(crate) fn within(self, loops: &[LoopId]) -> Self {
        fn lines(items: Vec<Item>, around: &LoopId) -> Vec<Item> {
            let lines = items.into_iter().flat_map(|item| match item {
                Item::Loop { by, body } if by == *around => body,
                Item::Branch { condition, holds, body } => {
                    vec![Item::Branch { condition, holds, body: lines(body, around) }]
                }
                other => vec![other],
            });
            lines.collect()
        }
        Self { items: loops.iter().fold(self.items, lines), ..self }
    }
}

/// The base of a divisor `x sqrt(x)`, where neither the product nor the root has a name.
pub(crate) fn root_cubed(graph: &Graph, divisor: NodeId, is_named: impl Fn(NodeId) -> bool) -> Option<NodeId> {
    let Node::Mul(base, root) = graph.node(divisor) else { return None };
    let is_inline = !is_named(divisor) && !is_named(root);
    (is_inline && graph.node(root) == Node::Power(base, 1)).then_some(base)
}

/// The argument of a divisor that is a root without a name.
pub(crate) fn root(graph: &Graph, divisor: NodeId, is_named: impl Fn(NodeId) -> bool) -> Option<NodeId> {
    match graph.node(divisor) {
        Node::Power(base, 1) if !is_named(divisor) => Some(base),
        _ => None,
    }
}

/// Constraints on the schedule beside the dependences between nodes.
#[derive(Debug, Default)]
pub(crate) struct Constraints {
    /// Those that have a name however they are used.
    pub(crate) named: BTreeSet<NodeId>,
    /// Those that are computed wherever another one is, which reads them later than in this pass.
    pub(crate) beside: BTreeMap<NodeId, BTreeSet<NodeId>>,
    /// Whether choices among prepared numbers are selections by any condition: lanes rarely agree on a branch.
    pub(crate) selects: bool,
}

/// Schedules what stores need. `leaf` decides which nodes are read, not computed.
pub(crate) fn schedule(graph: &Graph, stores: &[Store], leaf: impl Fn(&Graph, NodeId) -> bool) -> Program {
    schedule_with(graph, stores, leaf, &Constraints::default())
}

/// The same under constraints.
pub(crate) fn schedule_with(
    graph: &Graph,
    stores: &[Store],
    leaf: impl Fn(&Graph, NodeId) -> bool,
    constraints: &Constraints,
) -> Program {
    let stores = &lists::by_point(graph, stores);
    // With what it protects, an order may have copies of too much in too many branches.
    let strategies =
        [true, false].into_iter().flat_map(|protects| WAITING.map(|waiting| Strategy { waiting, protects }));
    let mut found = strategies.filter_map(|strategy| attempt(graph, stores, &leaf, constraints, strategy));
    found.next().unwrap_or_default()
}

/// The rule by which inner blocks are joined: which of them keep a later one from joining an earlier one.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Waiting {
    /// Those over the same loop or on the same condition. Fewest blocks, but two kinds may end up waiting for each
    /// other.
    ForItsLike,
    /// All. What a condition or a factor of one block needs may still come from a block that waits for it.
    ForAny,
    /// None is joined with another: each block makes one value or leads to one destination, from values that were made
    /// before it, so that an order always exists.
    Apart,
}

const WAITING: [Waiting; 3] = [Waiting::ForItsLike, Waiting::ForAny, Waiting::Apart];

/// A strategy to order blocks.
#[derive(Clone, Copy)]
struct Strategy {
    waiting: Waiting,
    /// Whether what may not be there is read inside of what decides that it is.
    protects: bool,
}

/// How many uses a node of the graph has on average, at most, in an order that protects.
const USES: usize = 8;

fn attempt<L: Fn(&Graph, NodeId) -> bool>(
    graph: &Graph,
    stores: &[Store],
    leaf: &L,
    constraints: &Constraints,
    strategy: Strategy,
) -> Option<Program> {
    let mut scheduler = Scheduler {
        graph,
        leaf,
        constraints,
        strategy,
        left: USES * (graph.len() + USES),
        known: (0, None, HashMap::new()),
        blocks: vec![Block::default()],
        uses: BTreeMap::new(),
        homes: BTreeMap::new(),
        reads_time: false,
    };
    for Store { context, sink, value } in stores {
        let mut path = vec![0];
        for (position, around) in context.iter().enumerate() {
            // Conditions further in count as well: a sum in one of them has its loop before this block.
            let conditions = context[position..].iter().filter_map(Scope::condition);
            let needed = conditions.chain([*value]);
            let waits = needed.map(|id| scheduler.waits(&path, id, *around)).max().unwrap_or(0);
            if let Some(condition) = around.condition() {
                scheduler.note_use(condition, &path);
            }
            path.push(scheduler.inner(&path, *around, waits + 1));
        }
        scheduler.note_use(*value, &path);
        scheduler.block(&path).ends.push(End::Sink(*sink, *value));
    }
    scheduler.place()?;
    let named = scheduler.names();
    let conditions = stores.iter().flat_map(|store| store.context.iter().filter_map(Scope::condition));
    let compared = graph.compared(conditions.chain(stores.iter().map(|store| store.value)));
    let divides = |id: &NodeId| match graph.node(*id) {
        Node::Div(_, divisor) if !compared.contains(id) => {
            root_cubed(graph, divisor, |id| named.contains(&id)).is_some()
        }
        _ => false,
    };
    let divides_by_root_cubed = scheduler.blocks.iter().flat_map(|block| &block.nodes).any(divides);
    let (items, reads_time) = (scheduler.items(0, &named)?, scheduler.reads_time);
    Some(Program { items, named, reads_time, divides_by_root_cubed, compared })
}

/// How many operations may be nested in one expression before a part of it gets a name.
const DEEP: u32 = 24;

/// What the lines of a block lead to.
#[derive(Clone, Copy)]
enum End {
    Add { sum: NodeId, value: NodeId },
    Choose { choice: NodeId, value: NodeId },
    Sink(Sink, NodeId),
}

impl End {
    fn value(self) -> NodeId {
        match self {
            End::Add { value, .. } | End::Choose { value, .. } | End::Sink(_, value) => value,
        }
    }
}

/// A block under construction.
#[derive(Default)]
struct Block {
    scope: Option<Scope>,
    /// Inner blocks in order of their making, each with how many of its like it waits for.
    inner: Vec<(u32, usize)>,
    nodes: BTreeSet<NodeId>,
    ends: Vec<End>,
}

struct Scheduler<'g, L> {
    graph: &'g Graph,
    leaf: &'g L,
    constraints: &'g Constraints,
    strategy: Strategy,
    /// How many uses may still be noted.
    left: usize,
    /// How many blocks of a kind nodes wait for in a block, as far as that was asked last.
    known: (usize, Option<Scope>, HashMap<NodeId, u32>),
    blocks: Vec<Block>,
    /// The blocks that nodes are used in, as paths from the outermost one; the last node is placed first.
    uses: BTreeMap<NodeId, Vec<Vec<usize>>>,
    /// The blocks that nodes are computed in, as paths.
    homes: BTreeMap<NodeId, Vec<Vec<usize>>>,
    reads_time: bool,
}

impl<L: Fn(&Graph, NodeId) -> bool> Scheduler<'_, L> {
    fn block(&mut self, path: &[usize]) -> &mut Block {
        &mut self.blocks[path[path.len() - 1]]
    }

    fn note_use(&mut self, id: NodeId, path: &[usize]) {
        self.reads_time |= self.graph.node(id) == Node::Time;
        if !(self.leaf)(self.graph, id) {
            self.left = self.left.saturating_sub(1);
            self.uses.entry(id).or_default().push(path.to_vec());
        }
    }

    /// How much of a path a node has to be inside of: up to the deepest loop that it depends on, and up to the last
    /// place that decides whether what it reads is there.
    fn min_depth(&self, path: &[usize], id: NodeId) -> usize {
        let (loops, summed) = (self.graph.loops_of(id), self.graph.summed_in(id));
        let is_over = |block: &usize, set: LoopSet| matches!(self.blocks[*block].scope, Some(Scope::Loop(by)) if set.contains(by));
        // The index of a loop has one value in it, so that the sum over the same loop is not computed there.
        let outside = path.iter().position(|block| is_over(block, summed)).unwrap_or(path.len());
        let protected = if self.strategy.protects { self.last_guard(path, outside, id) } else { None };
        let own = path.iter().rposition(|block| is_over(block, loops));
        own.max(protected).map_or(1, |deepest| deepest + 1)
    }

    /// The last place of a path that decides whether what a node reads is there: in the place of a loop the question
    /// around it whether it has iterations. The sums in the node are computed in the first `outside` blocks.
    fn last_guard(&self, path: &[usize], outside: usize, id: NodeId) -> Option<usize> {
        let around = |place: usize| self.blocks[path[place]].scope;
        let is_protected = |place: &usize| {
            around(*place).is_some_and(|at| match *place < outside {
                true => self.graph.protects(at, id),
                false => self.graph.protects_beside_sums(at, id),
            })
        };
        let places = (0..path.len()).filter(is_protected);
        let decided = places.map(|place| match around(place) {
            Some(Scope::Loop(by)) => {
                let asks = |place: &usize| {
                    let Some(Scope::Branch(condition, true)) = around(*place) else { return false };
                    self.graph.asks_for_iterations(condition, by)
                };
                (0..place).rev().find(asks).unwrap_or(place)
            }
            _ => place,
        });
        decided.max()
    }

    /// How much of a path a node may be inside of: up to the first loop that it does not need, and for a sum up to the
    /// question whether its loop has iterations, which the same loop answers.
    fn max_depth(&self, path: &[usize], id: NodeId) -> usize {
        let needed = self.min_depth(path, id);
        let sum = match self.graph.node(id) {
            Node::Sum(by, body) if !self.graph.is_kept_by_iterations(by, body) => Some(by),
            _ => None,
        };
        let is_end = |block: &usize| match self.blocks[*block].scope {
            Some(Scope::Loop(_)) => true,
            Some(Scope::Branch(condition, _)) => sum.is_some_and(|by| self.graph.asks_for_iterations(condition, by)),
            None => false,
        };
        path[needed..].iter().position(is_end).map_or(path.len(), |next| needed + next)
    }

    /// How many inner blocks of a kind, one after the other, a node waits for in the last block of `path`.
    fn waits(&mut self, path: &[usize], id: NodeId, kind: Scope) -> u32 {
        let (block, kind) = (path[path.len() - 1], kind.either_side());
        let (known_block, known_kind, known) = std::mem::take(&mut self.known);
        let mut known = if (known_block, known_kind) == (block, Some(kind)) { known } else { HashMap::new() };
        let waits = self.waits_of(path, id, kind, &mut known);
        self.known = (block, Some(kind), known);
        waits
    }

    fn waits_of(&self, path: &[usize], id: NodeId, kind: Scope, known: &mut HashMap<NodeId, u32>) -> u32 {
        // A choice has a larger id than its condition.
        let is_before = kind.condition().is_some_and(|condition| id <= condition);
        if is_before && self.strategy.waiting != Waiting::ForAny {
            return 0;
        }
        if let Some(waits) = known.get(&id) {
            return *waits;
        }
        let around = |by| path.iter().any(|block| self.blocks[*block].scope == Some(Scope::Loop(by)));
        let inner = self.graph.loops_of(id).iter().any(|by| !around(by));
        let outer = !inner && self.max_depth(path, id) < path.len();
        let waits = if (self.leaf)(self.graph, id) || outer {
            0
        } else {
            let node = self.graph.node(id);
            let children = node.children().map(|child| self.waits_of(path, child, kind, known)).max().unwrap_or(0);
            let like = match (node, kind) {
                _ if self.is_selection(id) => false,
                (Node::Sum(..) | Node::Fold(..) | Node::Select(..), _) if self.strategy.waiting == Waiting::ForAny => {
                    true
                }
                (Node::Sum(by, _) | Node::Fold(_, by, _), Scope::Loop(kind)) => by == kind,
                (Node::Select(condition, ..), Scope::Branch(kind, _)) => condition == kind,
                _ => false,
            };
            children + u32::from(!inner && like)
        };
        known.insert(id, waits);
        waits
    }

    /// The block inside the last one of `path`, new or known.
    fn inner(&mut self, path: &[usize], around: Scope, waits: u32) -> usize {
        let beside = &self.blocks[path[path.len() - 1]].inner;
        let known = beside.iter().find(|(own, block)| *own == waits && self.blocks[*block].scope == Some(around));
        if let Some((_, known)) = known.filter(|_| self.strategy.waiting != Waiting::Apart) {
            return *known;
        }
        let made = self.blocks.len();
        self.blocks.push(Block { scope: Some(around), ..Block::default() });
        self.block(path).inner.push((waits, made));
        made
    }

    /// Sums and choices, what is used twice, and what is used in a block inside the one that it is computed in.
    fn names(&self) -> BTreeSet<NodeId> {
        let mut uses: HashMap<NodeId, u32> = HashMap::new();
        let mut named = BTreeSet::new();
        for block in &self.blocks {
            // A sum and a choice are used by the ends inside their blocks; a change of sign costs nothing, so it is
            // written where it is used, and what is under it is used there.
            let passes = |id: &&NodeId| !self.is_made_inside(**id) && !matches!(self.graph.node(**id), Node::Neg(_));
            let from_nodes = block.nodes.iter().filter(passes).flat_map(|id| self.graph.node(*id).children());
            let from_ends = block.ends.iter().map(|end| end.value());
            let conditions = block.inner.iter().filter_map(|(_, inner)| match self.blocks[*inner].scope {
                Some(Scope::Branch(condition, _)) => Some(condition),
                _ => None,
            });
            for used in from_nodes.chain(from_ends) {
                let used = match self.graph.node(used) {
                    Node::Neg(inner) if !(self.leaf)(self.graph, used) => inner,
                    _ => used,
                };
                *uses.entry(used).or_default() += 1;
                if !block.nodes.contains(&used) {
                    named.insert(used);
                }
            }
            named.extend(conditions);
            named.extend(block.nodes.iter().filter(|id| self.is_made_inside(**id)));
        }
        named.extend(uses.into_iter().filter(|(_, count)| *count > 1).map(|(id, _)| id));
        named.extend(self.blocks.iter().flat_map(|block| block.nodes.intersection(&self.constraints.named)));
        self.name_deep(&mut named);
        named.retain(|id| !(self.leaf)(self.graph, *id));
        for block in &self.blocks {
            named.extend(self.pairs(block).into_iter().flat_map(|(sine, cosine, _)| [sine, cosine]));
        }
        named
    }

    /// Names parts of expressions that would otherwise nest too deeply to be read, by people or by the compiler.
    fn name_deep(&self, named: &mut BTreeSet<NodeId>) {
        let mut depths: HashMap<NodeId, u32> = HashMap::new();
        let computed: BTreeSet<NodeId> = self.blocks.iter().flat_map(|block| block.nodes.iter().copied()).collect();
        for id in computed {
            let of = |child: NodeId| if named.contains(&child) { 0 } else { depths.get(&child).copied().unwrap_or(0) };
            let depth = 1 + self.graph.node(id).children().map(of).max().unwrap_or(0);
            depths.insert(id, depth);
            if depth > DEEP && !matches!(self.graph.node(id), Node::Neg(_)) {
                named.insert(id);
            }
        }
    }
}
