//! Names for common subexpressions of formulas: distances, and the pieces of a formula that is too long for a line.

use super::{Formulas, formula::Formula};
use crate::{
    graph::{Graph, Node, NodeId, Part},
    model::Model,
};
use std::collections::{HashMap, HashSet};

/// How many operations one line shows.
pub(crate) const LINE: u64 = 40;

/// How many operations a piece has that is named since it is used twice.
const SHARED: u64 = 8;

/// How many operations a sum of two squares has.
const SQUARES: u64 = 5;

/// What distances of positions are called, and what roots of momenta are.
const DISTANCES: [&str; 4] = ["r", "s", "d", "l"];
const ENERGIES: [&str; 2] = ["w", "e"];

/// A name for a node, which is that name to the power of `halves / 2`.
#[derive(Clone, Debug)]
pub(crate) struct Name {
    pub(crate) text: String,
    pub(crate) halves: i32,
}

impl<'m> Formulas<'m> {
    /// Formulas in which distances that occur twice have a name, and so do the pieces of what is too long.
    pub(crate) fn with_names(model: &'m Model, roots: &[NodeId]) -> Self {
        let mut naming = Naming::new(model, roots);
        naming.distances();
        if naming.sizes().into_iter().any(|(id, size)| size > LINE && roots.contains(&id)) {
            naming.pieces(roots);
        }
        Self { model, names: naming.names }
    }

    /// `where r = ...` for every name, each after those that it is made of.
    pub(crate) fn definitions(&self) -> Vec<String> {
        let mut named: Vec<_> = self.names.iter().collect();
        named.sort_by_key(|(id, _)| **id);
        let definition = |(id, Name { text, halves }): (&NodeId, &Name)| {
            let value: Formula = match halves {
                2 => self.computed(*id),
                _ => self.computed(*id).power(1),
            };
            format!("where {text} = {}", value.text())
        };
        named.into_iter().map(definition).collect()
    }
}

struct Naming<'m> {
    model: &'m Model,
    /// What the roots are made of, children first.
    parts: Vec<NodeId>,
    /// How often each is written where nothing has a name.
    written: HashMap<NodeId, u64>,
    /// How many nodes each is a part of.
    uses: HashMap<NodeId, u64>,
    names: HashMap<NodeId, Name>,
    /// The words that stand for something else.
    taken: HashSet<String>,
}

impl<'m> Naming<'m> {
    fn new(model: &'m Model, roots: &[NodeId]) -> Self {
        let graph = &model.graph;
        let parts = graph.reachable(roots.iter().copied());
        let (mut written, mut uses): (HashMap<NodeId, u64>, HashMap<NodeId, u64>) = Default::default();
        for root in roots {
            *written.entry(*root).or_default() += 1;
            *uses.entry(*root).or_default() += 1;
        }
        for id in parts.iter().rev() {
            let own = written[id];
            for child in graph.node(*id).children() {
                let known = written.entry(child).or_default();
                *known = known.saturating_add(own);
                *uses.entry(child).or_default() += 1;
            }
        }
        let texts = model.parameters.iter().map(|parameter| parameter.own.to_string());
        let words = texts.chain(model.running.values().map(ToString::to_string));
        let words = words.chain(model.externals.iter().map(ToString::to_string)).collect::<Vec<_>>().join(" ");
        let words = words.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
        let taken = words.map(ToOwned::to_owned).collect();
        Self { model, parts, written, uses, names: HashMap::new(), taken }
    }

    /// How many operations each part shows.
    fn sizes(&self) -> HashMap<NodeId, u64> {
        let mut sizes = HashMap::new();
        for id in &self.parts {
            let size = self.size(*id, &sizes);
            sizes.insert(*id, size);
        }
        sizes
    }

    fn size(&self, id: NodeId, sizes: &HashMap<NodeId, u64>) -> u64 {
        let of = |child| if self.names.contains_key(&child) { 1 } else { sizes[&child] };
        self.model.graph.node(id).children().map(of).fold(1, u64::saturating_add)
    }

    /// Names sums of squares that roots or quotients are made of.
    fn distances(&mut self) {
        let (graph, sizes) = (&self.model.graph, self.sizes());
        let mut bases: Vec<NodeId> = Vec::new();
        for id in &self.parts {
            if let Node::Power(base, halves) = graph.node(*id)
                && (halves < 0 || halves % 2 != 0)
                && !graph.is_prepared(base)
                && is_sum_of_squares(graph, base)
                && self.written[&base] > 1
                && sizes[&base] >= SQUARES
                && !bases.contains(&base)
            {
                bases.push(base);
            }
        }
        bases.sort_unstable();
        for base in bases {
            let letters: &[&str] = if graph.reads(base, Part::Position) { &DISTANCES } else { &ENERGIES };
            let suffix = self.indices(base);
            let numbered = (2..).map(|number| format!("{}{number}", letters[0]));
            let mut letters = letters.iter().map(ToString::to_string).chain(numbered);
            let is_free =
                |letter: &String| !self.taken.contains(letter) && !self.taken.contains(&format!("{letter}{suffix}"));
            if let Some(letter) = letters.find(is_free) {
                self.name(base, format!("{letter}{suffix}"), 4);
            }
        }
    }

    /// Names what is long and used twice, and what is too long for a line.
    fn pieces(&mut self, roots: &[NodeId]) {
        let mut sizes = HashMap::new();
        let mut count = 0;
        for at in 0..self.parts.len() {
            let id = self.parts[at];
            let size = self.size(id, &sizes);
            sizes.insert(id, size);
            let node = self.model.graph.node(id);
            let shared = size >= SHARED && self.uses[&id] > 1;
            let long = size > LINE && !roots.contains(&id);
            if !(shared || long) || node.is_condition() || matches!(node, Node::Neg(_)) || self.names.contains_key(&id)
            {
                continue;
            }
            let suffix = self.indices(id);
            let name = loop {
                count += 1;
                let name = format!("u{count}{suffix}");
                if !self.taken.contains(&name) {
                    break name;
                }
            };
            self.name(id, name, 2);
        }
    }

    fn name(&mut self, id: NodeId, text: String, halves: i32) {
        self.taken.insert(text.clone());
        self.names.insert(id, Name { text, halves });
    }

    /// `_ij` for what depends on the indices of two loops.
    fn indices(&self, id: NodeId) -> String {
        let loops = self.model.graph.loops_of(id);
        let names: Vec<String> =
            loops.iter().filter_map(|by| self.model.running.get(&by)).map(ToString::to_string).collect();
        match names.iter().all(|name| name.chars().count() == 1) {
            _ if names.is_empty() => String::new(),
            true => format!("_{}", names.concat()),
            false => format!("_{}", names.join("_")),
        }
    }
}

/// Whether a node is a sum of squares, of those of parameters and of numbers too.
fn is_sum_of_squares(graph: &Graph, id: NodeId) -> bool {
    let is_square = |id| match graph.node(id) {
        Node::Power(_, halves) => halves > 0 && halves % 4 == 0,
        Node::Mul(a, b) => graph.is_prepared(a) && matches!(graph.node(b), Node::Power(_, halves) if halves % 4 == 0),
        _ => graph.is_prepared(id),
    };
    match graph.node(id) {
        Node::Add(a, b) => [a, b].into_iter().all(|part| is_sum_of_squares(graph, part) || is_square(part)),
        Node::Sum(_, body) => is_square(body) || is_sum_of_squares(graph, body),
        _ => false,
    }
}
