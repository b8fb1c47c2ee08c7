//! The block of each node: the innermost one around all of its uses, outside of every loop on which it does not depend.

use super::{End, Scheduler};
use crate::graph::{Graph, Node, NodeId, Scope};

impl<L: Fn(&Graph, NodeId) -> bool> Scheduler<'_, L> {
    /// Finds the block of every node, and then of those that are computed beside others; `None` if that comes to too
    /// many.
    pub(super) fn place(&mut self) -> Option<()> {
        loop {
            // Users come before what they use, since their ids are larger.
            while let Some((id, uses)) = self.uses.pop_last() {
                self.place_uses(id, uses);
                if self.strategy.protects && self.left == 0 {
                    return None;
                }
            }
            let missing = self.missing();
            if missing.is_empty() {
                return Some(());
            }
            for (id, path) in missing {
                self.note_use(id, &path);
            }
        }
    }

    /// What is computed beside others and is not there yet, with the blocks of these.
    fn missing(&self) -> Vec<(NodeId, Vec<usize>)> {
        let is_there = |id: &NodeId, path: &[usize]| {
            (self.leaf)(self.graph, *id)
                || self.homes.get(id).is_some_and(|homes| homes.iter().any(|home| path.starts_with(home)))
        };
        let mut missing = Vec::new();
        for (id, beside) in &self.constraints.beside {
            for path in self.homes.get(id).into_iter().flatten() {
                missing.extend(beside.iter().filter(|id| !is_there(id, path)).map(|id| (*id, path.clone())));
            }
        }
        missing
    }

    fn place_uses(&mut self, id: NodeId, uses: Vec<Vec<usize>>) {
        let known = self.homes.remove(&id).unwrap_or_default();
        let mut homes = known.clone();
        for path in uses {
            let (needed, path) = (self.min_depth(&path, id), &path[..self.max_depth(&path, id)]);
            // Uses inside one iteration of the deepest loop share what they have in common, and what is computed
            // further out.
            let is_shared =
                |home: &&mut Vec<usize>| home.get(..needed) == Some(&path[..needed]) || path.starts_with(home);
            match homes.iter_mut().find(is_shared) {
                Some(home) => {
                    let common = home.iter().zip(path).take_while(|(a, b)| a == b).count();
                    home.truncate(common);
                    let home = home.clone();
                    homes.retain(|other| *other == home || !other.starts_with(&home));
                }
                None => homes.push(path.to_vec()),
            }
        }
        for left in known.iter().filter(|home| !homes.contains(home)) {
            self.leave(id, left);
        }
        for home in homes.iter().filter(|home| !known.contains(home)) {
            self.place_at(id, home);
        }
        self.homes.insert(id, homes);
    }

    /// Takes a node out of a block, since a use has been found outside of it.
    fn leave(&mut self, id: NodeId, home: &[usize]) {
        self.block(home).nodes.remove(&id);
        let mut open = vec![home[home.len() - 1]];
        while let Some(block) = open.pop() {
            let makes = |end: &End| match end {
                End::Add { sum: made, .. } | End::Choose { choice: made, .. } => *made == id,
                End::Sink(..) => false,
            };
            self.blocks[block].ends.retain(|end| !makes(end));
            open.extend(self.blocks[block].inner.iter().map(|(_, inner)| *inner));
        }
    }

    fn place_at(&mut self, id: NodeId, home: &[usize]) {
        self.block(home).nodes.insert(id);
        match self.graph.node(id) {
            Node::Sum(by, body) => {
                let waits = self.waits(home, id, Scope::Loop(by));
                let iteration = self.inside(home, Scope::Loop(by), waits);
                match self.graph.node(body) {
                    // What an iteration adds under a condition alone is added there.
                    Node::Select(condition, value, zero) if self.graph.as_constant(zero) == Some(0.0) => {
                        self.add_where(id, &iteration, condition, true, value);
                    }
                    Node::Select(condition, zero, value) if self.graph.as_constant(zero) == Some(0.0) => {
                        self.add_where(id, &iteration, condition, false, value);
                    }
                    _ => self.end(&iteration, End::Add { sum: id, value: body }),
                }
            }
            Node::Fold(_, by, body) => {
                let waits = self.waits(home, id, Scope::Loop(by));
                let iteration = self.inside(home, Scope::Loop(by), waits);
                self.end(&iteration, End::Add { sum: id, value: body });
            }
            Node::Select(condition, first, second) if !self.is_selection(id) => {
                self.note_use(condition, home);
                // A choice begins as zero, which needs no branch; the negative zero does.
                let zero = |value: &NodeId| self.graph.as_constant(*value).is_some_and(|value| value.to_bits() == 0);
                for (holds, value) in [(true, first), (false, second)].into_iter().filter(|(_, value)| !zero(value)) {
                    let around = Scope::Branch(condition, holds);
                    let waits = self.waits(home, id, around);
                    let branch = self.inside(home, around, waits);
                    self.end(&branch, End::Choose { choice: id, value });
                }
            }
            node => {
                for child in node.children() {
                    self.note_use(child, home);
                }
            }
        }
    }

    fn add_where(&mut self, sum: NodeId, iteration: &[usize], condition: NodeId, holds: bool, value: NodeId) {
        self.note_use(condition, iteration);
        let around = Scope::Branch(condition, holds);
        let waits = self.waits(iteration, condition, around).max(self.waits(iteration, value, around));
        let branch = self.inside(iteration, around, waits + 1);
        self.end(&branch, End::Add { sum, value });
    }

    fn inside(&mut self, path: &[usize], around: Scope, waits: u32) -> Vec<usize> {
        let inner = self.inner(path, around, waits);
        path.iter().copied().chain([inner]).collect()
    }

    fn end(&mut self, path: &[usize], end: End) {
        self.note_use(end.value(), path);
        self.block(path).ends.push(end);
    }
}
