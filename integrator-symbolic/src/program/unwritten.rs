//! The lines of a block that are not scheduled yet, and the dependencies of each.

use super::{Block, Scheduler};
use crate::graph::{Graph, NodeId};
use std::collections::{BTreeSet, HashMap};

/// A line of a block that waits for others.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Line {
    Value(NodeId),
    /// An inner block, by its position.
    Block(usize),
}

/// The named values and the inner blocks of a block that are not written yet.
pub(super) struct Unwritten {
    /// How many lines each line still waits for.
    counts: HashMap<Line, usize>,
    /// The lines that wait for a line.
    waiting_for: HashMap<Line, Vec<Line>>,
    ready_values: BTreeSet<NodeId>,
    ready_blocks: BTreeSet<usize>,
    /// How many are left.
    pub(super) values: usize,
    pub(super) blocks: usize,
}

impl Unwritten {
    pub(super) fn of<L: Fn(&Graph, NodeId) -> bool>(
        scheduler: &Scheduler<'_, L>,
        own: &Block,
        named: &BTreeSet<NodeId>,
        blocks: &[usize],
    ) -> Self {
        let values: Vec<NodeId> = own.nodes.iter().filter(|id| named.contains(id)).copied().collect();
        let mut lines = Self {
            counts: HashMap::new(),
            waiting_for: HashMap::new(),
            ready_values: BTreeSet::new(),
            ready_blocks: BTreeSet::new(),
            values: values.len(),
            blocks: blocks.len(),
        };
        for (at, block) in blocks.iter().enumerate() {
            let (mut needs, makes) = (BTreeSet::new(), scheduler.makes(*block));
            scheduler.block_needs(*block, own, &mut needs);
            // What the block itself makes is not needed from outside.
            let needed = needs.iter().filter(|id| own.nodes.contains(id) && named.contains(id) && !makes.contains(id));
            lines.add(Line::Block(at), needed.map(|id| Line::Value(*id)).collect());
            let made = makes.iter().filter(|id| own.nodes.contains(id));
            for id in made {
                *lines.counts.entry(Line::Value(*id)).or_default() += 1;
                lines.waiting_for.entry(Line::Block(at)).or_default().push(Line::Value(*id));
            }
        }
        for id in values {
            let mut needs = BTreeSet::new();
            if !scheduler.is_made_inside(id) {
                scheduler.needs(id, own, named, &mut needs);
            }
            lines.add(Line::Value(id), needs.into_iter().map(Line::Value).collect());
        }
        lines
    }

    /// Notes what a line waits for beside what was noted.
    fn add(&mut self, line: Line, needs: Vec<Line>) {
        let count = self.counts.entry(line).or_default();
        *count += needs.len();
        if *count == 0 {
            self.is_ready(line);
        }
        for need in needs {
            self.waiting_for.entry(need).or_default().push(line);
        }
    }

    fn is_ready(&mut self, line: Line) {
        match line {
            Line::Value(id) => self.ready_values.insert(id),
            Line::Block(at) => self.ready_blocks.insert(at),
        };
    }

    /// The next value: children have smaller ids.
    pub(super) fn next_value(&mut self) -> Option<NodeId> {
        let id = self.ready_values.pop_first()?;
        self.values -= 1;
        self.written(Line::Value(id));
        Some(id)
    }

    /// The first block that waits for nothing.
    pub(super) fn next_block(&mut self) -> Option<usize> {
        let at = self.ready_blocks.pop_first()?;
        self.blocks -= 1;
        self.written(Line::Block(at));
        Some(at)
    }

    fn written(&mut self, line: Line) {
        for line in self.waiting_for.remove(&line).unwrap_or_default() {
            if let Some(count) = self.counts.get_mut(&line) {
                *count -= 1;
                if *count == 0 {
                    self.is_ready(line);
                }
            }
        }
    }
}
